// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "image/image.hpp"
#include "rungs/fold.hpp"

namespace rung::image {
namespace {

using isa::Opcode;
using isa::SlotInstruction;
using isa::WordKind;
using mapping::BitValue;
using mapping::Destination;
using mapping::MappedOp;

class Addresses {
 public:
  explicit Addresses(const Program& program) {
    for (const Device device : named_devices(program)) {
      int& next = is_word(device) ? words_ : bits_;
      devices_[device] = next++;
    }
  }
  std::uint16_t of(Device device) const { return static_cast<std::uint16_t>(devices_.at(device)); }
  int bits() const { return bits_; }
  int words() const { return words_; }
  std::vector<ImageDevice> table(Dialect dialect) const {
    std::vector<ImageDevice> table;
    for (const auto& [device, address] : devices_) {
      table.push_back({device_name(device, dialect), device.kind, address});
    }
    return table;
  }

 private:
  std::map<Device, int> devices_;
  int bits_ = 0;
  int words_ = 0;
};

// Fields of a word instruction from its two sources, of which at most one is a constant.
void set_sources(SlotInstruction& out, const WordSource& first, const WordSource& second,
                 const Addresses& addresses) {
  assert(!first.constant || !second.constant || out.opcode == Opcode::Mv);
  const auto value = [](const WordSource& source) {
    return static_cast<std::uint16_t>(source.value);
  };
  if (second.constant) {
    out.kind = WordKind::DeviceConstant;
    out.rs = first.constant ? 0 : addresses.of(first.device);
    out.source = value(second);
  } else if (first.constant && out.opcode != Opcode::Mv) {
    out.kind = WordKind::ConstantDevice;
    out.rs = addresses.of(second.device);
    out.source = value(first);
  } else {
    out.kind = WordKind::Devices;
    out.rs = first.constant ? 0 : addresses.of(first.device);
    out.source = addresses.of(second.device);
  }
}

void start_image(Image& image, const Program& program, const Addresses& addresses,
                 const isa::Config& config, isa::Mpu mpu) {
  image.program = program.file;
  image.dialect = dialect_name(program.dialect);
  image.mpu = mpu;
  image.config = config.name;
  image.devices = addresses.table(program.dialect);
  image.first_temporary = addresses.bits();
  for (const Instruction& instruction : program.instructions) {
    image.source.push_back({instruction.position, instruction.text});
  }
  const ProgramCounts counts = count(program);
  image.statistics.rungs = counts.networks;
  image.statistics.instructions = counts.instructions;
  image.statistics.contacts = counts.contacts;
  image.statistics.runs = static_cast<int>(counts.run_lengths.size());
  image.statistics.bit_devices = addresses.bits();
  image.statistics.word_devices = addresses.words();
}

Opcode mpu1_opcode(Op op, Device device) {
  switch (op) {
    case Op::Nop:
      return Opcode::Nop;
    case Op::Ld:
      return Opcode::Ld;
    case Op::Ldi:
      return Opcode::Ldi;
    case Op::And:
      return Opcode::And;
    case Op::Ani:
      return Opcode::Ani;
    case Op::Or:
      return Opcode::Or;
    case Op::Ori:
      return Opcode::Ori;
    case Op::Anb:
      return Opcode::Anb;
    case Op::Orb:
      return Opcode::Orb;
    case Op::Mps:
      return Opcode::Mps;
    case Op::Mrd:
      return Opcode::Mrd;
    case Op::Mpp:
      return Opcode::Mpp;
    case Op::Out:
      return Opcode::Out;
    case Op::Set:
      return Opcode::Set;
    case Op::Rst:
      return is_word(device) ? Opcode::Mv : Opcode::Rst;
    case Op::Mov:
      return Opcode::Mv;
    case Op::Add:
      return Opcode::Add;
    case Op::Sub:
      return Opcode::Sub;
    case Op::Mul:
      return Opcode::Mul;
    case Op::Div:
      return Opcode::Div;
  }
  return Opcode::Nop;
}

class Mpu1Assembler {
 public:
  Mpu1Assembler(const Program& program, const isa::Config& config)
      : program_(program), config_(config), addresses_(program) {}

  Image assemble() {
    start_image(image_, program_, addresses_, config_, isa::Mpu::Mpu1);
    for (std::size_t i = 0; i < program_.instructions.size(); ++i) {
      origin_ = static_cast<int>(i);
      add(program_.instructions[i]);
    }
    image_.clocks = isa::constant::fill_clocks;
    for (const auto& step : image_.steps) image_.clocks += config_.clocks(step[0].opcode);
    return std::move(image_);
  }

 private:
  void emit(const SlotInstruction& instruction) {
    image_.steps.push_back({instruction});
    image_.origins.push_back({origin_});
  }

  void add(const Instruction& source) {
    SlotInstruction out;
    out.opcode = mpu1_opcode(source.op, source.device);
    if (isa::info(out.opcode).format == isa::Format::Bit)
      out.a.device = addresses_.of(source.device);
    if (isa::info(out.opcode).format != isa::Format::Word) return emit(out);
    add_word(source, out);
  }

  void add_word(const Instruction& source, SlotInstruction& out) {
    const Device second{source.device.kind, source.device.number + 1};
    out.rd = addresses_.of(source.device);
    WordSource a = source.op == Op::Mov || source.op == Op::Rst ? WordSource{} : source.sources[0];
    WordSource b = source.op == Op::Mov ? source.sources[0] : source.sources[1];
    if (source.op == Op::Rst) b = WordSource{};
    if (a.constant && b.constant && out.opcode != Opcode::Mv) {
      if (const auto result = fold(source.op, a.value, b.value)) {
        out.opcode = Opcode::Mv;
        set_sources(out, WordSource{}, {true, result->low, {}}, addresses_);
        emit(out);
        if (source.double_width) {
          out.rd = addresses_.of(second);
          set_sources(out, WordSource{}, {true, result->high, {}}, addresses_);
          emit(out);
        }
        return;
      }
      a = {false, 0, source.device};  // by 0: the dividend does not matter
    }
    set_sources(out, a, b, addresses_);
    emit(out);
    if (!source.double_width) return;
    SlotInstruction high;
    high.opcode = Opcode::Mvh;
    high.rd = addresses_.of(second);
    emit(high);
  }

  const Program& program_;
  const isa::Config& config_;
  Addresses addresses_;
  Image image_;
  int origin_ = 0;
};

class SlotAssembler {
 public:
  SlotAssembler(const Program& program, const schedule::Temporaries& temporaries)
      : temporaries_(temporaries), addresses_(program) {}

  const Addresses& addresses() const { return addresses_; }
  const std::vector<std::uint8_t>& lut() const { return lut_; }
  int rows_used() const { return static_cast<int>(rows_used_.size()); }
  bool rows_fit() const { return lut_.size() <= isa::constant::lut_rows; }

  SlotInstruction assemble(const MappedOp& op) {
    SlotInstruction out;
    out.opcode = op.opcode;
    if (mapping::is_lookup(op.opcode)) {
      out.row = row(op);
      set_inputs(out, op);
    } else if (op.opcode == Opcode::Ld) {
      out.a = operand(op.inputs[0]);
    }
    const Destination& to = op.destination;
    if (isa::info(op.opcode).format == isa::Format::Word) {
      if (to.kind == Destination::Kind::Device) out.rd = addresses_.of(to.device);
      if (isa::info(op.opcode).gate != isa::Gate::Unit) {
        set_sources(out, op.operands[0].source, op.operands[1].source, addresses_);
      }
    } else if (to.kind == Destination::Kind::Device) {
      out.c.device = addresses_.of(to.device);
    } else if (to.kind == Destination::Kind::Temporary) {
      out.c.device = temporary(to.temporary);
    }
    return out;
  }

 private:
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

  const schedule::Temporaries& temporaries_;
  Addresses addresses_;
  std::vector<std::uint8_t> lut_;
  std::set<int> rows_used_;
};

}  // namespace

Image assemble_mpu1(const Program& program, const isa::Config& config) {
  return Mpu1Assembler(program, config).assemble();
}

bool assemble_slots(const Program& program, const mapping::Mapping& mapping,
                    const schedule::Schedule& schedule, const schedule::Temporaries& temporaries,
                    const isa::Config& config, isa::Mpu mpu, Image& image) {
  SlotAssembler assembler(program, temporaries);
  Image out;
  start_image(out, program, assembler.addresses(), config, mpu);
  for (const auto& step : schedule.steps) {
    std::vector<SlotInstruction> instructions;
    std::vector<int> origins;
    for (const mapping::OpId id : step) {
      instructions.push_back(id == mapping::kNoOp ? SlotInstruction{}
                                                  : assembler.assemble(mapping.ops[id]));
      origins.push_back(id == mapping::kNoOp ? -1 : static_cast<int>(mapping.ops[id].instruction));
      if (id != mapping::kNoOp && mapping::is_lookup(mapping.ops[id].opcode))
        ++out.statistics.lookups;
    }
    out.steps.push_back(std::move(instructions));
    out.origins.push_back(std::move(origins));
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
