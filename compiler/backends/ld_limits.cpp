// SPDX-License-Identifier: Apache-2.0
#include "backends/ld_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "source/text_file.hpp"

namespace rung::ld_limits {
namespace {

class Check {
 public:
  Check(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void run() {
    if (program_.networks.size() > kRungs) {
      const std::size_t first = program_.networks[kRungs].first;
      error(
          program_.instructions[first].position,
          fmt::format("{} rungs, of which LDmicro 2.3 holds {}", program_.networks.size(), kRungs),
          "put rungs side by side into the branches of a PARALLEL, or write two programs");
    }
    check_names();
    for (const Network& rung : program_.networks) check_comments(rung);
    for (const Instruction& instruction : program_.instructions) check_table(instruction);
    check_pins();
  }

 private:
  void error(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(program_.file, position, std::move(what), std::move(mend));
  }

  // Where the program names it first.
  SourcePosition place_of(Device device) const {
    for (const Instruction& instruction : program_.instructions) {
      for (const Operand& operand : instruction.operands) {
        if (operand.kind == Operand::Kind::Device && operand.device == device) {
          return instruction.position;
        }
      }
    }
    return {};
  }

  void check_names() {
    std::size_t names = 0;
    for (const auto& [device, name] : program_.names) {
      if (is_port(device.kind)) continue;
      ++names;
      const std::size_t letters = name.size() - (name.ends_with(":w") ? 2 : 0);
      if (letters <= kName) continue;
      error(place_of(device),
            fmt::format("{}: a name of {} letters, of which LDmicro 2.3 holds {}", shown(name),
                        letters, kName),
            "give it a shorter name");
    }
    if (names <= kNames) return;
    error({}, fmt::format("{} names, of which LDmicro 2.3 holds {}", names, kNames),
          "use one variable for several purposes, or write two programs");
  }

  // LDmicro 2.3 loads such a rung, and stops with an internal error when it compiles it.
  void check_comments(const Network& rung) {
    if (rung.count <= 2) return;
    for (std::size_t i = rung.first; i < rung.first + rung.count; ++i) {
      const Instruction& instruction = program_.instructions[i];
      if (instruction.op != Op::Comment) continue;
      error(instruction.position, "COMMENT beside other elements, which LDmicro 2.3 cannot compile",
            "give it a rung of its own");
    }
  }

  void check_table(const Instruction& instruction) {
    const auto check_count = [&](std::size_t count, std::size_t most, const char* what,
                                 const char* mend) {
      if (count <= most) return;
      error(instruction.position,
            fmt::format("{}: {} {}, of which LDmicro 2.3 holds {}", shown(instruction.text), count,
                        what, most),
            mend);
    };
    if (instruction.op == Op::LookUpTable) {
      check_count(instruction.table.size(), kLookUp, "values", "use two tables");
    } else if (instruction.op == Op::PiecewiseLinear) {
      check_count(instruction.table.size() / 2, kPoints, "points", "use two tables");
    } else if (instruction.op == Op::FormattedString) {
      check_count(instruction.table.size(), kString, "characters",
                  "send it as two strings, one behind the other");
    }
  }

  void check_pins() {
    for (const LdmicroSettings::Pin& pin : program_.ldmicro->pins) {
      if (std::string_view("XYA").find(pin.name.front()) == std::string_view::npos) {
        error({},
              fmt::format("IO LIST: {} has a pin, which in LDmicro 2.3 only names with X, Y "
                          "and A have",
                          shown(pin.name)),
              "remove it from the IO LIST");
      }
    }
  }

  const Program& program_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check(const Program& program, Diagnostics& diagnostics) { Check(program, diagnostics).run(); }

}  // namespace rung::ld_limits
