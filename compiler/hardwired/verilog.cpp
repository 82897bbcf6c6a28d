// SPDX-License-Identifier: Apache-2.0
#include "hardwired/verilog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "hardwired/head.hpp"
#include "hardwired/units.hpp"
#include "hardwired/values.hpp"
#include "lower/lower.hpp"

namespace rung::hardwired {
namespace {

using core::Op;
using logic::Action;
using logic::kStart;
using logic::Version;

// Reads of indexed operations, one multiplexer input each: beyond this no FPGA holds the program.
constexpr std::size_t kMostWindowReads = 200'000;

class Writer {
 public:
  Writer(const Program& source, const core::Program& program, const logic::Logic& logic,
         const Interface& interface, const Plan& plan, const Options& options)
      : source_(source),
        program_(program),
        logic_(logic),
        interface_(interface),
        plan_(plan),
        options_(options),
        values_(source, logic, interface, plan) {}

  std::string write() {
    for (const Device device : interface_.state) values_.need_register(device);
    const std::string actions = write_actions();
    const std::string units = write_units();
    const std::string error = write_error();
    std::string blocks = write_registers();
    blocks += write_holds();
    blocks += write_outputs();
    std::string text = head(source_, interface_, plan_, options_);
    text += write_declarations();
    text += "\n  // --- What each rung makes of the values at its place in the scan.\n";
    text += actions + units;
    text += "\n  // --- Registers: what stays from scan to scan, or from clock to clock.\n";
    text += error + blocks + "endmodule\n";
    for (const Unit& unit : kUnits) {
      if (used_.contains(unit.op)) text += unit_module(unit, options_.name);
    }
    return text + "\n/* verilator lint_on UNUSED */\n`default_nettype wire\n";
  }

  std::size_t holds() const { return values_.holds().size(); }

 private:
  bool several() const { return plan_.clocks > 1; }

  std::string write_actions() {
    std::string text;
    std::size_t said = source_.instructions.size();
    for (std::size_t i = 0; i < logic_.actions.size(); ++i) {
      if (plan_.clock[i] < 0) continue;
      const std::size_t origin = program_.instructions[logic_.actions[i].instruction].origin;
      if (origin != said && origin < source_.instructions.size()) text += remark(origin);
      said = origin;
      text += values_.action(i);
      if (unit_of(logic_.actions[i].op) != nullptr) used_[logic_.actions[i].op].push_back(i);
    }
    return text;
  }

  // The source line that the next wires come from, and in which clock.
  std::string remark(std::size_t origin) const {
    const Instruction& instruction = source_.instructions[origin];
    return fmt::format("  // {}:{}\n", instruction.position.line,
                       instruction.text.empty() ? "" : " " + plain(instruction.text));
  }

  // Operands of all actions of a unit, each in its clock.
  std::string write_units() {
    std::string text;
    for (const Unit& unit : kUnits) {
      if (!used_.contains(unit.op)) continue;
      const bool wide = unit.op == Op::Mul32 || unit.op == Op::Div32;
      const bool divides = unit.op == Op::Div || unit.op == Op::Div32;
      const int width = wide ? 32 : 16;
      text += fmt::format("\n  // --- {}\n", unit.name);
      for (const int which : {0, 1}) {
        std::vector<std::string> terms;
        for (const std::size_t i : used_[unit.op]) {
          terms.push_back(fmt::format("({{{}{{phase[{}]}}}} & {})", width, plan_.issue[i],
                                      values_.unit_operand(i, which)));
        }
        text += fmt::format("  wire [{}:0] {}_{} =\n      {};\n", width - 1, unit.name,
                            which == 0 ? 'a' : 'b', fmt::join(terms, "\n      | "));
      }
      text += fmt::format(
          "  {0}_{1} {1} (\n      .clk_i(clk_i),\n      .a_i({1}_a),\n      .b_i({1}_b),\n"
          "      .result_o({1}_result){2}\n  );\n",
          options_.name, unit.name,
          divides ? fmt::format(",\n      .zero_o({}_zero)", unit.name) : "");
    }
    return text;
  }

  std::string write_error() {
    std::vector<std::string> terms;
    for (const Unit& unit : kUnits) {
      if (unit.op != Op::Div && unit.op != Op::Div32) continue;
      for (const std::size_t i : used_[unit.op]) {
        terms.push_back(fmt::format("(phase[{}] & {})", plan_.clock[i], values_.zero_division(i)));
      }
      if (used_[unit.op].empty()) used_.erase(unit.op);
    }
    if (terms.empty()) return "  assign error_o = 1'b0;\n";
    return fmt::format(
        "  // A division by zero in this scan.\n  wire error =\n      {};\n  reg error_q;\n"
        "  always @(posedge clk_i) error_q <= ~rst_i & (error | (error_q & ~phase[0]));\n"
        "  assign error_o = error_q;\n",
        fmt::join(terms, "\n      | "));
  }

  // Which value a device takes at the end of which clocks: of each clock the last one.
  std::map<std::int32_t, std::string> kept_values(Device device) {
    std::map<std::int32_t, std::string> values;
    if (interface_.start(device).kind == Start::Kind::Given)
      values[0] = values_.wire(device, kStart);
    const auto versions = plan_.versions.find(device);
    if (versions == plan_.versions.end()) return values;
    for (const Version version : versions->second) {
      values[plan_.clock[version]] = values_.wire(device, version);
    }
    return values;
  }

  std::string write_register(Device device) {
    const std::string name = values_.register_name(device);
    const auto state = interface_.state_bits.find(device);
    const bool shown = state != interface_.state_bits.end();
    std::string text = "  always @(posedge clk_i) begin\n";
    for (const auto& [clock, value] : kept_values(device)) {
      text += fmt::format("    if (phase[{}]) {} <= {};\n", clock, name, value);
    }
    if (shown) {
      text += fmt::format("    if (state_load_i) {} <= state_i[{}{}];\n", name, state->second,
                          is_word(device) ? " +: 16" : "");
    }
    // What no scan finds from the one before needs none.
    if (shown || interface_.start(device).kind == Start::Kind::Register) {
      text += fmt::format("    if (rst_i) {} <= {};\n", name, literal(device, 0));
    }
    return text + "  end\n";
  }

  std::string write_registers() {
    std::string text;
    for (const Device device : values_.registers()) {
      if (interface_.start(device).kind != Start::Kind::Fixed) text += write_register(device);
    }
    return text;
  }

  std::string write_holds() const {
    std::string text;
    for (const Hold& hold : values_.holds()) {
      text += fmt::format("  always @(posedge clk_i) if (phase[{}]) {} <= {};\n", hold.clock,
                          hold.name, hold.value);
    }
    return text;
  }

  // Outputs change all at once, at the end of the scan.
  std::string write_outputs() {
    std::string text = "\n  // --- Outputs and state, the last device highest.\n";
    std::vector<std::string> now, next, state;
    for (const Device device : interface_.outputs) {
      const Version last = logic_.current(device, logic::kNever);
      now.push_back(values_.register_name(device));
      next.push_back(values_.read(device, last, plan_.clocks - 1));
    }
    for (const Device device : interface_.state) {
      const Start& start = interface_.start(device);
      state.push_back(start.kind == Start::Kind::Fixed ? start.text
                                                       : values_.register_name(device));
    }
    if (now.empty()) {
      text += "  assign out_o = 1'b0;\n";
    } else if (!several()) {
      text += list("out_o", now);
    } else {
      std::vector<std::string> loaded;
      for (const Device device : interface_.outputs) {
        loaded.push_back(fmt::format("state_i[{}]", interface_.state_bits.at(device)));
      }
      text += fmt::format("  reg [{}:0] out_q;\n  assign out_o = out_q;\n", now.size() - 1);
      text += list("wire [" + std::to_string(now.size() - 1) + ":0] out_next", next);
      text += list("wire [" + std::to_string(now.size() - 1) + ":0] out_loaded", loaded);
      text += fmt::format(
          "  always @(posedge clk_i) begin\n    if (phase[{}]) out_q <= out_next;\n"
          "    if (state_load_i) out_q <= out_loaded;\n    if (rst_i) out_q <= {}'b0;\n  end\n",
          plan_.clocks - 1, now.size());
    }
    return text + (state.empty() ? "  assign state_o = 1'b0;\n" : list("state_o", state));
  }

  static std::string list(const std::string& target, std::vector<std::string> bits) {
    std::reverse(bits.begin(), bits.end());
    const bool declared = target.starts_with("wire");
    return fmt::format("  {}{} = {{\n      {}\n  }};\n", declared ? "" : "assign ", target,
                       fmt::join(bits, ",\n      "));
  }

  std::string write_declarations() {
    std::string text;
    for (const Device device : values_.registers()) {
      if (interface_.start(device).kind == Start::Kind::Fixed) continue;
      text += fmt::format("  reg {}{};\n", is_word(device) ? "[15:0] " : "",
                          values_.register_name(device));
    }
    for (const Hold& hold : values_.holds()) {
      text += fmt::format("  reg {}{};\n", hold.word ? "[15:0] " : "", hold.name);
    }
    for (const auto& [op, actions] : used_) {
      const Unit& unit = *unit_of(op);
      const bool wide = op == Op::Mul32 || op == Op::Div32;
      text += fmt::format("  wire [{}:0] {}_result;\n", wide ? 63 : 31, unit.name);
      if (op == Op::Div || op == Op::Div32) text += fmt::format("  wire {}_zero;\n", unit.name);
    }
    return text;
  }

  const Program& source_;
  const core::Program& program_;
  const logic::Logic& logic_;
  const Interface& interface_;
  const Plan& plan_;
  const Options& options_;
  Values values_;
  std::map<Op, std::vector<std::size_t>> used_;  // units, and the actions in them
};

}  // namespace

std::optional<Module> to_verilog(const Program& source, const Options& options,
                                 Diagnostics& diagnostics) {
  const core::Program program = lower::lower(source);
  std::size_t window_reads = 0;
  for (const core::Instruction& instruction : program.instructions) {
    if (!core::is_indexed(instruction.op)) continue;
    window_reads += std::max(instruction.reads.size(), instruction.targets.size());
    if (window_reads <= kMostWindowReads) continue;
    const Instruction& culprit = source.instructions[instruction.origin];
    diagnostics.error(
        source.file, culprit.position,
        fmt::format("indexed operands and tables reach more than {} devices in all, "
                    "each of them an input of a multiplexer in hard-wired logic",
                    kMostWindowReads),
        "name fewer devices of the indexed kind, or compile the program for a processor");
    return std::nullopt;
  }
  const logic::Logic logic = logic::build(program);
  Module module{{}, Interface(source, program, logic), 0, 0};
  const Plan plan = hardwired::plan(logic, module.interface, options.step_ns);
  Writer writer(source, program, logic, module.interface, plan, options);
  module.text = writer.write();
  module.clocks = plan.clocks;
  module.holds = writer.holds();
  return module;
}

}  // namespace rung::hardwired
