// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "image/frame.hpp"

namespace rung::image {
namespace {

using isa::Opcode;
using isa::SlotInstruction;
using mapping::BitValue;
using mapping::Destination;
using mapping::MappedOp;

class SlotAssembler {
 public:
  SlotAssembler(const Addresses& addresses, const schedule::Temporaries& temporaries)
      : addresses_(addresses), temporaries_(temporaries) {}

  const std::vector<std::uint8_t>& lut() const { return lut_; }
  int rows_used() const { return static_cast<int>(rows_used_.size()); }
  bool rows_fit() const { return lut_.size() <= isa::constant::lut_rows; }

  SlotInstruction assemble(const MappedOp& op) {
    SlotInstruction out;
    out.opcode = op.opcode;
    out.always = op.always;
    if (mapping::is_lookup(op.opcode)) {
      out.row = row(op);
      set_inputs(out, op);
    } else if (op.opcode == Opcode::Get) {
      set_inputs(out, op);
    } else if (op.opcode == Opcode::Ld) {
      out.a = operand(op.inputs[0]);
    }
    const isa::OpcodeInfo& info = isa::info(op.opcode);
    const bool words = info.format == isa::Format::Word || info.format == isa::Format::Test;
    if (words && takes_sources(op.opcode)) set_sources(out, op);
    set_destination(out, op.destination, info.format);
    return out;
  }

 private:
  static bool takes_sources(Opcode opcode) {
    return isa::info(opcode).gate != isa::Gate::Unit && opcode != Opcode::Mva &&
           opcode != Opcode::Mvx;
  }

  void set_sources(SlotInstruction& out, const MappedOp& op) const {
    core::WordSource second = op.operands[1].source;
    // An index counts from the first device of its window.
    if (op.opcode == Opcode::Ix) {
      second = {true, static_cast<std::int16_t>(addresses_.of(op.head)), {}};
    }
    image::set_sources(out, op.operands[0].source, second, addresses_);
  }

  void set_destination(SlotInstruction& out, const Destination& to, isa::Format format) const {
    if (to.kind == Destination::Kind::Temporary) {
      out.c.device = temporary(to.temporary);
    } else if (to.kind == Destination::Kind::Device) {
      std::uint16_t& field = format == isa::Format::Word ? out.rd : out.c.device;
      field = addresses_.of(to.device);
    }
  }

  std::uint16_t temporary(int number) const {
    return static_cast<std::uint16_t>(addresses_.bits() + temporaries_.address[number]);
  }

  isa::BitOperand operand(const BitValue& value) const {
    switch (value.kind) {
      case BitValue::Kind::Device:
        return {addresses_.of(value.device), false};
      case BitValue::Kind::Temporary:
        return {temporary(value.temporary), false};
      default:
        return {0, true};  // nothing to read: N0 takes no port
    }
  }

  void set_inputs(SlotInstruction& out, const MappedOp& op) const {
    out.a = operand(op.inputs[0]);
    out.b = operand(op.inputs[1]);
    out.c = operand(op.inputs[2]);
  }

  std::uint8_t row(const MappedOp& op) {
    if (op.paper_row) {
      if (lut_.size() <= *op.paper_row) lut_.resize(*op.paper_row + 1, 0);
      lut_[*op.paper_row] = op.function;
      rows_used_.insert(*op.paper_row);
      return *op.paper_row;
    }
    const auto found = std::find(lut_.begin(), lut_.end(), op.function);
    const auto index = static_cast<std::size_t>(found - lut_.begin());
    if (found == lut_.end()) lut_.push_back(op.function);
    rows_used_.insert(static_cast<int>(index));
    return static_cast<std::uint8_t>(index & 0x7f);
  }

  const Addresses& addresses_;
  const schedule::Temporaries& temporaries_;
  std::vector<std::uint8_t> lut_;
  std::set<int> rows_used_;
};

}  // namespace

bool assemble_slots(const Program& source, const core::Program& program,
                    const mapping::Mapping& mapping, const schedule::Schedule& schedule,
                    const schedule::Temporaries& temporaries, const isa::Config& config,
                    isa::Mpu mpu, Image& image) {
  const Addresses addresses(source, program, config);
  SlotAssembler assembler(addresses, temporaries);
  Image out = start_image(source, program, addresses, config, mpu);
  for (const auto& step : schedule.steps) {
    auto& instructions = out.steps.emplace_back();
    auto& origins = out.origins.emplace_back();
    auto& quiet = out.quiet.emplace_back();
    for (const mapping::OpId id : step) {
      if (id == mapping::kNoOp) {
        instructions.emplace_back();
        origins.push_back(-1);
        quiet.push_back(0);
        continue;
      }
      const MappedOp& op = mapping.ops[id];
      instructions.push_back(assembler.assemble(op));
      origins.push_back(static_cast<int>(program.instructions[op.instruction].origin));
      quiet.push_back(op.quiet ? 1 : 0);
      if (mapping::is_lookup(op.opcode)) ++out.statistics.lookups;
    }
  }
  if (!assembler.rows_fit()) return false;
  out.lut = assembler.lut();
  out.statistics.lut_rows = assembler.rows_used();
  out.statistics.bit_devices += temporaries.count;
  out.clocks = schedule::clocks(schedule, mapping, config) + isa::constant::fill_clocks;
  image = std::move(out);
  return true;
}

}  // namespace rung::image
