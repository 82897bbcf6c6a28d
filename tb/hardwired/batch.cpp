// SPDX-License-Identifier: Apache-2.0
#include "hardwired/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace rung::tb {
namespace {

// At least this: a port of more than 64 bits is the same C++ type whatever its width.
constexpr int kLeastWidth = 65;

struct Port {
  const char* direction;
  const char* name;
  int Offsets::*bit;
};
constexpr Port kPorts[] = {
    {"input ", "in_i", &Offsets::in},       {"input ", "clocks_i", &Offsets::clocks},
    {"input ", "ticks_i", &Offsets::ticks}, {"output", "out_o", &Offsets::out},
    {"input ", "state_i", &Offsets::state}, {"output", "state_o", &Offsets::state}};

// As the module declares them: a port without a use has one bit.
int width_of(const hardwired::Interface& interface, int Offsets::*port) {
  int width = interface.state_width;
  if (port == &Offsets::in) width = static_cast<int>(interface.inputs.size());
  if (port == &Offsets::clocks) width = static_cast<int>(interface.clocks.size());
  if (port == &Offsets::ticks) width = 16 * static_cast<int>(interface.ticks.size());
  if (port == &Offsets::out) width = static_cast<int>(interface.outputs.size());
  return std::max(width, 1);
}

}  // namespace

Batch::Batch(const std::vector<Subject>& subjects, double step_ns) {
  for (const Subject& subject : subjects) {
    Diagnostics diagnostics;
    hardwired::Options options;
    options.name = fmt::format("p{}", modules_.size());
    options.step_ns = step_ns;
    auto module = hardwired::to_verilog(subject.what.program, options, diagnostics);
    if (!module) {
      std::ostringstream text;
      diagnostics.print(text);
      throw std::runtime_error(subject.name + ": " + text.str());
    }
    Placed placed{widths_, std::move(*module)};
    for (const auto bit :
         {&Offsets::in, &Offsets::clocks, &Offsets::ticks, &Offsets::out, &Offsets::state}) {
      widths_.*bit += width_of(placed.module.interface, bit);
    }
    modules_.push_back(std::move(placed));
  }
}

std::string Batch::verilog() const {
  std::string text;
  for (const Placed& placed : modules_) text += placed.module.text;
  const int count = std::max(static_cast<int>(modules_.size()), kLeastWidth);
  text +=
      "\n`default_nettype none\n\n/* verilator lint_off UNUSED */\n/* verilator lint_off UNDRIVEN "
      "*/\n"
      "module hardwired_batch (\n    input  wire clk_i,\n"
      "    input  wire rst_i,\n";
  for (const char* name : {"start_i", "state_load_i"}) {
    text += fmt::format("    input  wire [{}:0] {},\n", count - 1, name);
  }
  for (const char* name : {"busy_o", "done_o", "error_o"}) {
    text += fmt::format("    output wire [{}:0] {},\n", count - 1, name);
  }
  for (const Port& port : kPorts) {
    text += fmt::format("    {} wire [{}:0] {}{}\n", port.direction,
                        std::max(widths_.*port.bit, kLeastWidth) - 1, port.name,
                        &port == std::end(kPorts) - 1 ? "" : ",");
  }
  text += ");\n";
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    text += fmt::format("  p{0} p{0} (.clk_i(clk_i), .rst_i(rst_i)", i);
    for (const char* name : {"start_i", "state_load_i", "busy_o", "done_o", "error_o"}) {
      text += fmt::format(", .{0}({0}[{1}])", name, i);
    }
    for (const Port& port : kPorts) {
      text += fmt::format(",\n      .{0}({0}[{1} +: {2}])", port.name, modules_[i].*port.bit,
                          width_of(modules_[i].module.interface, port.bit));
    }
    text += ");\n";
  }
  return text + "endmodule\n";
}

}  // namespace rung::tb
