// SPDX-License-Identifier: Apache-2.0
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
  SlotAssembler(const Addresses& addresses, const schedule::Temporaries& temporaries, Rows& rows)
      : addresses_(addresses), temporaries_(temporaries), rows_(rows) {}

  SlotInstruction assemble(const MappedOp& op) {
    SlotInstruction out;
    out.opcode = op.opcode;
    out.always = op.always;
    if (mapping::is_lookup(op.opcode)) {
      out.row = rows_.of(op);
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

  const Addresses& addresses_;
  const schedule::Temporaries& temporaries_;
  Rows& rows_;
};

}  // namespace

Routine assemble_routine(const core::Program& program, const mapping::Mapping& mapping,
                         const schedule::Schedule& schedule,
                         const schedule::Temporaries& temporaries, const Addresses& addresses,
                         Rows& rows, const isa::Config& config) {
  SlotAssembler assembler(addresses, temporaries, rows);
  Routine out;
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
      if (mapping::is_lookup(op.opcode)) ++out.lookups;
    }
  }
  out.clocks = schedule::clocks(schedule, mapping, config) + isa::constant::fill_clocks;
  return out;
}

bool assemble_slots(const Program& source, const core::Program& program,
                    const mapping::Mapping& mapping, const schedule::Schedule& schedule,
                    const schedule::Temporaries& temporaries, const isa::Config& config,
                    isa::Mpu mpu, Image& image) {
  const Addresses addresses(source, program, config);
  Rows rows;
  const Routine routine =
      assemble_routine(program, mapping, schedule, temporaries, addresses, rows, config);
  if (!rows.fit()) return false;
  image = start_image(source, program, addresses, config, mpu);
  append(image, routine, 0);
  image.clocks = routine.clocks;
  image.lut = rows.lut();
  image.statistics.lut_rows = rows.used();
  image.statistics.bit_devices += temporaries.count;
  return true;
}

}  // namespace rung::image
