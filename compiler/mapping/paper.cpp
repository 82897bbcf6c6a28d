// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include "mapping/emit.hpp"
#include "mapping/mapping.hpp"

namespace rung::mapping {
namespace {

// Table 2's code of a contact that is not the first of its look-up.
int later_code(core::Op op) {
  switch (op) {
    case core::Op::And:
      return 1;
    case core::Op::Ani:
      return 2;
    case core::Op::Or:
      return 3;
    default:
      assert(op == core::Op::Ori);
      return 4;
  }
}

class PaperMapper {
 public:
  PaperMapper(const logic::Logic& logic, const core::Program& program, bool keep_nops)
      : logic_(logic), program_(program), keep_nops_(keep_nops) {}

  Mapping map() {
    for (std::size_t i = 0; i < program_.instructions.size(); ++i) {
      const core::Instruction& instruction = program_.instructions[i];
      if (is_contact(instruction.op)) {
        const bool first = instruction.op == core::Op::Ld || instruction.op == core::Op::Ldi;
        if (first) {
          flush();
          close();
        }
        run_.push_back(i);
        continue;
      }
      flush();
      if (instruction.op == core::Op::Nop) {
        if (!keep_nops_) continue;
        MappedOp nop;
        nop.instruction = i;
        append(mapping_, unit_, nop);
        continue;
      }
      append_action(mapping_, unit_, logic_, epoch_++, last_, false);
    }
    flush();
    close();
    return std::move(mapping_);
  }

 private:
  BitValue contact(std::size_t index) const {
    BitValue value;
    value.kind = BitValue::Kind::Device;
    value.device = program_.instructions[index].targets[0];
    value.version = logic_.current(value.device, epoch_);
    return value;
  }

  // Ends a run: its look-ups, from the left.
  void flush() {
    std::size_t at = 0;
    while (at < run_.size()) {
      MappedOp op;
      op.opcode = isa::Opcode::Lut;
      op.inputs.fill({BitValue::Kind::N0, {}, logic::kStart, -1});
      op.instruction = run_[at];
      const core::Op head = program_.instructions[run_[at]].op;
      const bool loads = head == core::Op::Ld || head == core::Op::Ldi;
      std::array<int, 3> codes{loads && head == core::Op::Ldi ? 1 : 0, 0, 0};
      int place = 0;
      if (loads)
        op.inputs[place++] = contact(run_[at++]);
      else
        place = 1;
      for (; place < 3 && at < run_.size(); ++place, ++at) {
        op.inputs[place] = contact(run_[at]);
        codes[place] = later_code(program_.instructions[run_[at]].op);
      }
      op.paper_row = isa::paper_row(codes[0], codes[1], codes[2]);
      op.function = isa::paper_row_function(*op.paper_row);
      last_ = append(mapping_, unit_, op);
    }
    run_.clear();
  }

  void close() {
    if (!unit_.ops.empty()) mapping_.units.push_back(std::move(unit_));
    unit_ = {};
  }

  const logic::Logic& logic_;
  const core::Program& program_;
  bool keep_nops_;
  Mapping mapping_;
  Unit unit_;
  std::vector<std::size_t> run_;
  OpId last_ = kNoOp;
  std::int32_t epoch_ = 0;
};

}  // namespace

Mapping map_paper(const logic::Logic& logic, const core::Program& program, bool keep_nops) {
  return PaperMapper(logic, program, keep_nops).map();
}

}  // namespace rung::mapping
