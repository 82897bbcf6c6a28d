// SPDX-License-Identifier: Apache-2.0
#include "mapping/mapping.hpp"

#include <fmt/format.h>

namespace rung::mapping {
namespace {

std::string version_name(logic::Version version) {
  if (version == logic::kStart) return "start";
  return fmt::format("a{}", version);
}

std::string name(const BitValue& value, Dialect dialect) {
  switch (value.kind) {
    case BitValue::Kind::N0:
      return "N0";
    case BitValue::Kind::Device:
      return fmt::format("{}@{}", device_name(value.device, dialect), version_name(value.version));
    case BitValue::Kind::Temporary:
      return fmt::format("t{}", value.temporary);
    case BitValue::Kind::None:
      break;
  }
  return "-";
}

std::string name(const logic::Operand& operand, Dialect dialect) {
  if (operand.source.constant) return fmt::format("K{}", operand.source.value);
  return fmt::format("{}@{}", device_name(operand.source.device, dialect),
                     version_name(operand.version));
}

std::string show(const MappedOp& op, Dialect dialect) {
  std::string text(isa::info(op.opcode).name);
  if (is_lookup(op.opcode)) {
    text += fmt::format(" {:08b}({}, {}, {})", op.function, name(op.inputs[0], dialect),
                        name(op.inputs[1], dialect), name(op.inputs[2], dialect));
  } else if (op.opcode == isa::Opcode::Ld) {
    text += " " + name(op.inputs[0], dialect);
  } else if (isa::info(op.opcode).gate == isa::Gate::Unit) {
    text += fmt::format(" o{}", op.started_by);
  } else if (op.opcode == isa::Opcode::Get) {
    text += fmt::format(" {} {} {}", name(op.inputs[0], dialect), name(op.inputs[1], dialect),
                        name(op.inputs[2], dialect));
  } else if (isa::info(op.opcode).format != isa::Format::Bit) {
    text += fmt::format(" {}, {}", name(op.operands[0], dialect), name(op.operands[1], dialect));
  }
  if (op.destination.kind == Destination::Kind::Device) {
    text += " -> " + device_name(op.destination.device, dialect);
  } else if (op.destination.kind == Destination::Kind::Temporary) {
    text += fmt::format(" -> t{}", op.destination.temporary);
  }
  return text;
}

}  // namespace

bool starts_unit(isa::Opcode opcode) {
  switch (opcode) {
    case isa::Opcode::Mul:
    case isa::Opcode::Div:
    case isa::Opcode::Muls:
    case isa::Opcode::Divs:
    case isa::Opcode::Mulds:
    case isa::Opcode::Divds:
      return true;
    default:
      return false;
  }
}

int collect_latency(isa::Opcode start, const isa::Config& config) {
  switch (start) {
    case isa::Opcode::Muls:
      return config.mul_latency;
    case isa::Opcode::Divs:
      return config.div_latency;
    case isa::Opcode::Mulds:
      return config.mul32_latency;
    case isa::Opcode::Divds:
      return config.div32_latency;
    default:
      return 1;  // MUL and DIV have waited already
  }
}

bool uses_index(isa::Opcode opcode) {
  switch (opcode) {
    case isa::Opcode::Mvx:
    case isa::Opcode::Stx:
    case isa::Opcode::Mvbx:
    case isa::Opcode::Setx:
    case isa::Opcode::Rstx:
      return true;
    default:
      return false;
  }
}

int run_lookups(int n, int inputs) {
  if (n <= 0) return 0;
  return n <= inputs ? 1 : (n - inputs + inputs - 2) / (inputs - 1) + 1;
}

int lookup_bound(const core::Program& program, const core::Network& network) {
  int bound = 0;
  int run = 0;
  bool after_block = false;
  const auto end_run = [&] {
    bound += run_lookups(run);
    run = 0;
  };
  for (std::size_t i = network.first; i < network.first + network.count; ++i) {
    const core::Op op = program.instructions[i].op;
    if (op == core::Op::Ld || op == core::Op::Ldi) {
      end_run();
      run = 1;
    } else if (is_contact(op)) {
      // A run that does not load goes on from the result before it: one more operand. After a block
      // it has its place in the block's look-up.
      if (run == 0) run = after_block ? 0 : 1;
      ++run;
    } else {
      end_run();
      if (op == core::Op::Anb || op == core::Op::Orb) ++bound;
    }
    after_block = op == core::Op::Anb || op == core::Op::Orb;
  }
  end_run();
  return bound;
}

std::string dump(const Mapping& mapping, Dialect dialect) {
  std::string out;
  for (std::size_t u = 0; u < mapping.units.size(); ++u) {
    out += fmt::format("unit {}\n", u);
    for (const OpId id : mapping.units[u].ops) {
      out += fmt::format("  o{} {}\n", id, show(mapping.ops[id], dialect));
    }
    for (const OpId id : mapping.units[u].collectors) {
      out += fmt::format("  later: o{} {}\n", id, show(mapping.ops[id], dialect));
    }
  }
  return out;
}

}  // namespace rung::mapping
