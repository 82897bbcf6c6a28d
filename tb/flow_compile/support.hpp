// SPDX-License-Identifier: Apache-2.0
// Flowcharts by hand.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "driver/compile_flow.hpp"
#include "flowchart/flowchart.hpp"
#include "melsec/list.hpp"

namespace rung::tb {

inline std::string printed(const Diagnostics& diagnostics) {
  std::ostringstream out;
  diagnostics.print(out);
  return out.str();
}

// In the lists of these tests, what no program names has names: D7000 the next step, D7001 the task
// command, D7002 the status, D7003 milliseconds, D7004 tenths, D7100 + n the begin of task n's
// wait, D7200 + n scratch, M7600 + n whether task n is not as
// it was at the start.
inline void name_flow_devices(Device& device) {
  const std::uint32_t n = device.number;
  if (device.kind == DeviceKind::M && n >= 7600 && n < 7680) {
    device = flowchart::task_turned(n - 7600);
  } else if (device.kind == DeviceKind::D && n >= 7000 && n < 7100) {
    device = {DeviceKind::HW, flowchart::kFirstFlowWord + (n - 7000)};
  } else if (device.kind == DeviceKind::D && n >= 7100 && n < 7200) {
    device = flowchart::wait_since(n - 7100);
  } else if (device.kind == DeviceKind::D && n >= 7200 && n < 7300) {
    device = flowchart::scratch(n - 7200);
  }
}

// A list that must parse; nothing for no text.
inline Program list(const std::string& text, Dialect dialect = Dialect::Fx) {
  Program program;
  program.file = "test.flow";
  program.dialect = dialect;
  if (text.empty()) return program;
  Diagnostics diagnostics;
  const auto source = decode_text(text + "END\n", "test.flow", diagnostics);
  auto parsed = source ? parse_list(*source, dialect, diagnostics) : std::nullopt;
  if (!parsed) throw std::runtime_error(printed(diagnostics) + text);
  for (Instruction& instruction : parsed->instructions) {
    for (Operand& operand : instruction.operands) name_flow_devices(operand.device);
  }
  return std::move(*parsed);
}

// One task after the other: begin(), then its steps.
class ChartMaker {
 public:
  explicit ChartMaker(const std::string& ladder, Dialect dialect = Dialect::Fx) {
    chart.file = "test.flow";
    chart.dialect = dialect;
    chart.ladder = list(ladder, dialect);
    chart.boards = {{"memory", 1, 0, false, false, false, {2, 1}},
                    {"panel", 1, 3, true, true, true, {3, 1}},
                    {"other", 2, 5, true, false, false, {4, 1}}};
  }

  ChartMaker& task(const std::string& name, bool starts = true) {
    chart.tasks.push_back({name, starts, chart.steps.size(), place()});
    return *this;
  }
  ChartMaker& step(const std::string& rungs) {
    flowchart::Step& step = chart.steps.emplace_back();
    step.name = "s" + std::to_string(chart.steps.size() - 1);
    step.task = chart.tasks.size() - 1;
    step.rungs = list(rungs, chart.dialect);
    step.next = {chart.steps.size() - 1};
    step.position = place();
    step.text = "step " + step.name;
    return *this;
  }
  ChartMaker& read(std::size_t board, int first, int count, Device head) {
    chart.steps.back().read = flowchart::Transfer{board, first, count, head, place()};
    return *this;
  }
  ChartMaker& write(std::size_t board, int first, int count, Device head) {
    chart.steps.back().write = flowchart::Transfer{board, first, count, head, place()};
    return *this;
  }

  flowchart::Flowchart chart;

 private:
  SourcePosition place() { return {++line_, 1}; }
  int line_ = 10;
};

// Boards of ChartMaker.
inline constexpr std::size_t kMemory = 0, kPanel = 1, kOther = 2;

inline std::string ladder_text() {
  return "LD X0\nOR M0\nANI X1\nOUT M0\nLDP X2\nINC D0\nLD M0\nOUT T0 K5\nLD T0\nOUT Y0\n"
         "LD M1\nMUL D0 K3 D2\n";
}

// Two tasks that use everything that a chart has.
inline ChartMaker example() {
  ChartMaker maker(ladder_text());
  maker.task("fill")
      .step("LD M0\nMOV D100 D7200\nLD X3\nMOV K1 D7000\n")
      .read(kPanel, 400, 4, {DeviceKind::D, 100})
      .step(
          "LD= D7002 K0\nOUT Y1\nLD Y1\nMUL D101 D102 D110\nLD M0\nMOV K257 D7001\nSET M7601\n"
          "LD M8000\nMOV D7003 D7100\nMOV K0 D7000\n")
      .write(kOther, 7, 2, {DeviceKind::D, 110})
      .task("heat", false)
      .step(
          "LD X4\nOR X5\nAND M7600\nANI M0\nOR Y3\nANI X6\nOUT Y2\nSUB D7004 D7101 D7201\n"
          "LD> D7201 K10\nMOV K-1 D7000\n")
      .read(kMemory, 20, 3, {DeviceKind::D, 200})
      .write(kMemory, 20, 3, {DeviceKind::D, 200});
  maker.chart.steps[0].next = {1};
  maker.chart.steps[1].next = {0};
  return maker;
}

inline std::optional<Compiled> try_compile(const flowchart::Flowchart& chart, int mpu,
                                           Diagnostics& diagnostics, const char* config = "ecp5") {
  CompileOptions options;
  options.mpu = static_cast<isa::Mpu>(mpu);
  options.config = isa::find_config(config);
  return compile_flow(chart, options, diagnostics);
}

inline image::Image image_of(const flowchart::Flowchart& chart, int mpu = 3) {
  Diagnostics diagnostics;
  auto compiled = try_compile(chart, mpu, diagnostics);
  if (!compiled) throw std::runtime_error(printed(diagnostics));
  return std::move(compiled->image);
}

}  // namespace rung::tb
