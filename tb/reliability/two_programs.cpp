// SPDX-License-Identifier: Apache-2.0
#include "reliability/two_programs.hpp"

#include <fmt/format.h>

namespace rung::tb {
namespace {

// From an edge to the pins, with the scans of these programs.
constexpr std::uint64_t kScans = 1500;

Made make_one(const std::string& board, bool fresh, const std::string& more,
              const std::string& settings) {
  const bool hx8k = board == "hx8k";
  return make_program(
      fmt::format(
          "{}LD{} X0\nOUT Y0\nLD{} X0\nOUT Y1\nLDI M99\nOUT Y2\nLD M98\nMOV D0 D100\nMOV D0 D101\n"
          "END\n",
          more, fresh ? "I" : "", fresh ? "" : "I"),
      fmt::format("board = \"{}\"\n[controller]\nexchange_points = 64\n{}\n[inputs]\nX0 = \"{}\"\n"
                  "[outputs]\nY0 = \"{}\"\nY1 = {{ pin = \"{}\", safe = 1 }}\nY2 = \"{}\"\n"
                  "[latched]\ndevices = [\"D100-D101\"]\n",
                  board, settings, hx8k ? "t1" : "in0", hx8k ? "t5" : "out0", hx8k ? "t6" : "out1",
                  hx8k ? "t7" : "out2"));
}

int pin_of(const Made& made, DeviceKind kind, std::uint32_t number) {
  for (const auto& each : made.bindings.outputs) {
    if (each.device.kind == kind && each.device.number == number) return each.pin;
  }
  throw std::runtime_error("an output that is not bound");
}

}  // namespace

TwoPrograms::TwoPrograms(const std::string& board, const std::string& more,
                         const std::string& settings)
    : old(make_one(board, false, more, settings)), fresh(make_one(board, true, more, settings)) {
  quicken(old.words);
  quicken(fresh.words);
  y0 = pin_of(old, DeviceKind::Y, 0);
  y1 = pin_of(old, DeviceKind::Y, 1);
  y2 = pin_of(old, DeviceKind::Y, 2);
  x0 = old.bindings.inputs.at(0).pin;
}

testing::AssertionResult TwoPrograms::runs(SimulatedController& controller, bool of_fresh) const {
  for (const bool level : {true, false}) {
    controller.set_input(x0, level);
    controller.run(kScans);
    const std::uint64_t pins = controller.outputs() & mask();
    if (pins != shows(of_fresh, level)) {
      return testing::AssertionFailure() << fmt::format("with X0 {} the pins are {:#b}, not {:#b}",
                                                        level, pins, shows(of_fresh, level));
    }
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult TwoPrograms::is_safe(const SimulatedController& controller) const {
  if ((controller.outputs() & mask()) == safe()) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << fmt::format("pins {:#b}, safe are {:#b}", controller.outputs() & mask(), safe());
}

}  // namespace rung::tb
