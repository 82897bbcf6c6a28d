// SPDX-License-Identifier: Apache-2.0
#include "hardwired/head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace rung::hardwired {
namespace {

constexpr std::string_view kPurpose = R"(//
// The program {name} as logic, written by `rung translate --to verilog`: a scan is {clocks}.
//
//   start_i       at a rising edge while busy_o is 0: a scan begins; held at 1, scan follows scan.
//                 Inputs, clock relays and ticks are sampled at that edge and not later.
//   busy_o        a scan is going on.  done_o: one clock long, the scan has ended and out_o is new.
//   out_o         the outputs, which change together at the end of a scan.
//   error_o       with done_o: the scan divided by zero, and that division has written nothing.
//   state_o       what each device holds, while busy_o is 0.
//   state_load_i  takes all devices from state_i; not while a scan begins or is going on.
//   rst_i         synchronous: all devices 0, the next scan is the first.
)";

// One line a device: "//   3  X2". `width`: bits of each.
std::string table(const Program& source, const std::string& title,
                  const std::vector<Device>& devices) {
  if (devices.empty()) return "";
  std::string text = "//\n// " + title + "\n";
  int bit = 0;
  for (const Device device : devices) {
    const int width = is_word(device) ? 16 : 1;
    const std::string bits = width == 1 ? std::to_string(bit) : fmt::format("{}:{}", bit + 15, bit);
    const auto comment = source.comments.find(device);
    text += fmt::format("//   {:>11}  {}{}\n", bits, plain(device_name(device, source)),
                        comment == source.comments.end() ? "" : "  " + plain(comment->second));
    bit += width;
  }
  return text;
}

std::string port(const char* direction, std::size_t width, const char* name) {
  const std::string range = fmt::format("[{}:0]", std::max<std::size_t>(width, 1) - 1);
  return fmt::format("    {} wire {} {}", direction, range, name);
}

std::string control(const Interface& interface, int clocks) {
  std::string text;
  if (interface.first_scan()) {
    text +=
        "  reg first_q;  // the next scan is the first one\n"
        "  always @(posedge clk_i) first_q <= rst_i | (first_q & ~phase[0]);\n";
  }
  text += "  reg done_q;\n  assign done_o = done_q;\n";
  if (clocks == 1) {
    return "  wire [0:0] phase = start_i;  // the one clock of a scan\n" + text +
           "  assign busy_o = 1'b0;\n  always @(posedge clk_i) done_q <= ~rst_i & start_i;\n";
  }
  return fmt::format(
             "  localparam CLOCKS = {};\n"
             "  // One of these is 1 in each clock of a scan.\n"
             "  wire [CLOCKS-1:0] phase;\n"
             "  reg [CLOCKS-1:1] phase_q;\n"
             "  reg busy_q;\n"
             "  assign phase = {{phase_q, start_i & ~busy_q}};\n"
             "  assign busy_o = busy_q;\n"
             "  always @(posedge clk_i) begin\n"
             "    phase_q <= phase[CLOCKS-2:0] & {{CLOCKS - 1{{~rst_i}}}};\n"
             "    busy_q <= ~rst_i & (phase[0] | (busy_q & ~phase[CLOCKS-1]));\n"
             "    done_q <= ~rst_i & phase[CLOCKS-1];\n"
             "  end\n",
             clocks) +
         text;
}

}  // namespace

std::string plain(const std::string& text) {
  std::string line;
  for (const char c : text) {
    // A backslash at the end of a line would take the next one into the comment.
    line += static_cast<unsigned char>(c) < 0x20 || c == '\\' ? ' ' : c;
  }
  return line;
}

std::string head(const Program& source, const Interface& interface, const Plan& plan,
                 const Options& options) {
  const std::string file = plain(std::filesystem::path(source.file).filename().string());
  std::string text = fmt::format(
      fmt::runtime(kPurpose), fmt::arg("name", file),
      fmt::arg("clocks",
               plan.clocks == 1 ? "one clock" : fmt::format("{} clocks, always", plan.clocks)));
  text.erase(0, 3);
  text += table(source, "in_i", interface.inputs);
  text += table(source, "clocks_i: clock relays, as they are in the scan", interface.clocks);
  if (!interface.ticks.empty()) {
    text += "//\n// ticks_i: ticks since the scan before, 0 in the first, at most 32767\n";
    for (std::size_t i = 0; i < interface.ticks.size(); ++i) {
      text += fmt::format("//   {:>11}  of {} us\n", fmt::format("{}:{}", 16 * i + 15, 16 * i),
                          interface.ticks[i]);
    }
  }
  text += table(source, "out_o", interface.outputs);
  text += table(source, "state_i, state_o", interface.state);
  text +=
      "\n`default_nettype none\n\n"
      "// Of which ports and words all bits are used depends on the program.\n"
      "/* verilator lint_off UNUSED */\n\n";
  const auto state = static_cast<std::size_t>(interface.state_width);
  const std::vector<std::string> ports{"    input  wire clk_i",
                                       "    input  wire rst_i",
                                       "    input  wire start_i",
                                       "    output wire busy_o",
                                       "    output wire done_o",
                                       "    output wire error_o",
                                       port("input ", interface.inputs.size(), "in_i"),
                                       port("input ", interface.clocks.size(), "clocks_i"),
                                       port("input ", 16 * interface.ticks.size(), "ticks_i"),
                                       port("output", interface.outputs.size(), "out_o"),
                                       "    input  wire state_load_i",
                                       port("input ", state, "state_i"),
                                       port("output", state, "state_o")};
  text += fmt::format("module {} (\n{}\n);\n", options.name, fmt::join(ports, ",\n"));
  text += control(interface, plan.clocks);
  return text;
}

}  // namespace rung::hardwired
