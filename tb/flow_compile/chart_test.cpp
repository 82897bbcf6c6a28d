// SPDX-License-Identifier: Apache-2.0
// What a flowchart becomes beside its routines: addresses, tables, the clock of waits, and errors.
#include <algorithm>
#include <map>
#include <set>

#include "driver/flow_parts.hpp"
#include "flow_compile/support.hpp"
#include "lower/lower.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

std::map<std::string, int> addresses(const image::Image& image) {
  std::map<std::string, int> out;
  for (const image::ImageDevice& each : image.devices) out[each.name] = each.address;
  return out;
}

const Diagnostic& only_error(const Diagnostics& diagnostics) {
  EXPECT_EQ(diagnostics.error_count(), 1) << printed(diagnostics);
  return diagnostics.all().at(0);
}

TEST(FlowChart, TransfersLieTogetherAndTheirDevicesHaveNames) {
  const image::Image image = image_of(example().chart);
  const auto of = addresses(image);
  const image::FlowImage& flow = *image.flow;
  ASSERT_EQ(flow.transfers.size(), 3U);  // one of the memory serves a read and a write
  const std::pair<const char*, int> heads[] = {{"D100", 4}, {"D110", 2}, {"D200", 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    const image::FlowTransfer& transfer = flow.transfers[i];
    EXPECT_EQ(transfer.count, heads[i].second);
    const int head = std::stoi(std::string(heads[i].first).substr(1));
    for (int word = 0; word < transfer.count; ++word) {
      EXPECT_EQ(of.at("D" + std::to_string(head + word)), transfer.address + word);
    }
  }
  EXPECT_EQ(flow.steps[0].read, 1);
  EXPECT_EQ(flow.steps[0].write, 0);
  EXPECT_EQ(flow.steps[1].write, 2);
  EXPECT_EQ(flow.steps[2].read, 3);
  EXPECT_EQ(flow.steps[2].write, 3);
  EXPECT_EQ(flow.tasks[1].first, 2);
  EXPECT_TRUE(flow.tasks[0].starts);
  EXPECT_FALSE(flow.tasks[1].starts);
}

TEST(FlowChart, WordsOfTheTaskHardwareAreThereWithoutAnyUse) {
  ChartMaker maker("");
  maker.task("idle").step("");
  const image::Image image = image_of(maker.chart);
  const image::FlowImage& flow = *image.flow;
  EXPECT_EQ((std::set{flow.next_word, flow.task_word, flow.status_word}), (std::set{0, 1, 2}));
  EXPECT_EQ(image.statistics.word_devices, 3);
  EXPECT_TRUE(image.devices.empty());
  EXPECT_EQ(flow.ladder_steps, 0);
  EXPECT_EQ(image.length(), 0U);
  EXPECT_EQ(image.clocks, isa::constant::fill_clocks);
  EXPECT_EQ(flow.steps[0].entry, flow.steps[0].end);
  EXPECT_EQ(flow.steps[0].clocks, isa::constant::fill_clocks);
}

// Bit devices that the instructions from `first` to before `end` may write or read on MPU1.
std::set<int> bits_of(const image::Image& image, int first, int end) {
  std::set<int> out;
  for (int step = first; step < end; ++step) {
    const isa::SlotInstruction& each = image.steps[static_cast<std::size_t>(step)][0];
    const isa::Format format = isa::info(each.opcode).format;
    if (format == isa::Format::Bit || format == isa::Format::Test) out.insert(each.a.device);
  }
  return out;
}

TEST(FlowChart, StepsShareTheirHiddenDevicesBehindTheLadders) {
  ChartMaker maker("LDP X0\nPLS M0\nLD= D0 D1\nOUT M1\nLD M5\nOR M7600\nOUT M6\n");
  maker.task("a")
      .step("LD= D0 D1\nOUT M2\nLD= D2 D3\nAND< D4 D5\nOUT M3\n")
      .step("LD> D0 D1\nOUT M4\nLD M7600\nOUT M5\n");
  const image::Image image = image_of(maker.chart, 1);
  const image::FlowImage& flow = *image.flow;
  const auto hidden = [&](int first, int end) {
    std::set<int> out;
    for (const int bit : bits_of(image, first, end)) {
      if (bit >= image.first_hidden_bit) out.insert(bit);
    }
    return out;
  };
  const auto ladder = hidden(0, flow.ladder_steps);
  const auto first = hidden(flow.steps[0].entry, flow.steps[0].end);
  auto second = hidden(flow.steps[1].entry, flow.steps[1].end);
  // The bit that tells of task 0 is one for all of them.
  std::set<int> common;
  std::set_intersection(ladder.begin(), ladder.end(), second.begin(), second.end(),
                        std::inserter(common, common.end()));
  ASSERT_EQ(common.size(), 1U);
  second.erase(*common.begin());
  ASSERT_GE(first.size(), 3U);
  ASSERT_GE(second.size(), 1U);
  EXPECT_GT(*first.begin(), *ladder.rbegin());
  EXPECT_TRUE(std::includes(first.begin(), first.end(), second.begin(), second.end()));
}

TEST(FlowChart, IndexesReachWhatOtherRoutinesName) {
  ChartMaker maker("LD M0\nMOV K1 D5\n");
  maker.task("a").step("LD M0\nMOV D20Z0 D40\n");
  const image::Image image = image_of(maker.chart);
  const auto of = addresses(image);
  for (int n = 5; n <= 147; ++n) {
    EXPECT_EQ(of.at("D" + std::to_string(n)), of.at("D5") + n - 5);
  }
}

// The ladder's first step adds the ticks, whatever else it is.
TEST(FlowChart, TheLadderCountsTheTimeOfWaits) {
  const image::Image image = image_of(example().chart, 1);
  // T0 counts in 100 ms too.
  std::multiset<std::int64_t> bases;
  for (const image::ImageTicks& each : image.ticks) bases.insert(each.base_us);
  EXPECT_EQ(bases, (std::multiset<std::int64_t>{1'000, 100'000}));
  for (std::size_t step = 0; step < 2; ++step) {
    const isa::SlotInstruction& add = image.steps[step][0];
    EXPECT_EQ(add.opcode, isa::Opcode::Add);
    EXPECT_TRUE(add.always);
    EXPECT_EQ(add.rd, add.rs);
    const auto base = step == 0 ? 1'000 : 100'000;
    EXPECT_TRUE(std::any_of(image.ticks.begin(), image.ticks.end(), [&](const auto& each) {
      return each.base_us == base && each.address == add.source;
    }));
    EXPECT_EQ(image.origins[step][0], -1);
  }
  ChartMaker untimed(ladder_text());
  untimed.task("a").step("LD X0\nOUT Y5\n");
  EXPECT_EQ(image_of(untimed.chart, 1).ticks.size(), 1U);

  ChartMaker alone("");
  alone.task("a").step("LD M8000\nMOV D7003 D7100\n");
  for (const int mpu : {1, 2, 3}) {
    const image::Image timed = image_of(alone.chart, mpu);
    EXPECT_EQ(timed.flow->ladder_steps, 1);
    EXPECT_EQ(timed.clocks, 1 + isa::constant::fill_clocks);
  }
}

TEST(FlowChart, AStepThatRemembersIsNone) {
  for (const char* rungs :
       {"LDP X0\nOUT Y0\n", "LD X0\nPLS M0\n", "LD X0\nINCP D0\n", "LD X0\nOUT T0 K5\n",
        "LD X0\nOUT C0 K5\n", "LD X0\nMEP\nOUT Y0\n", "STL S0\nLD X0\nSET S1\nRET\n"}) {
    EXPECT_FALSE(flow_parts::remembers(lower::lower(list(rungs))).empty()) << rungs;
    ChartMaker maker("");
    maker.task("a").step(rungs);
    Diagnostics diagnostics;
    EXPECT_THROW(try_compile(maker.chart, 3, diagnostics), std::logic_error) << rungs;
  }
  for (const char* rungs :
       {"LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nOUT Y1\n", "LD X0\nBCD D0 K4Y0\n",
        "LD X0\nDIV D0 D1 D2\n", "LD X0\nMC N0 M0\nLD X1\nOUT Y0\nMCR N0\n", "LD X0\nINC D0\n",
        "LD X0\nALT M0\n", "LDD> D0 D2\nAND= D4 K7\nOUT Y0\n", "LD X0\nSFTL X1 M0 K16 K3\n",
        "LD X0\nCJ P0\nLD X1\nOUT Y0\nP0\n", "LD M0\nMOV D0Z0 D10V0\n"}) {
    EXPECT_EQ(flow_parts::remembers(lower::lower(list(rungs))), "") << rungs;
  }
}

TEST(FlowChart, ThatNoFrontEndMayMakeIsAnInternalError) {
  const auto throws = [](auto change) {
    ChartMaker maker = example();
    change(maker.chart);
    Diagnostics diagnostics;
    EXPECT_THROW(try_compile(maker.chart, 3, diagnostics), std::logic_error);
  };
  throws([](auto& chart) { chart.tasks[0].first = 99; });
  throws([](auto& chart) { chart.steps[0].task = 2; });
  throws([](auto& chart) { std::swap(chart.steps[0], chart.steps[2]); });
  throws([](auto& chart) { chart.steps[0].next = {3}; });
  throws([](auto& chart) { chart.steps[0].read->board = 3; });
  throws([](auto& chart) { chart.steps[0].read->count = 33; });
  throws([](auto& chart) { chart.steps[0].read->first = 65535; });
  throws([](auto& chart) { chart.steps[0].read->head = {DeviceKind::M, 0}; });
  throws([](auto& chart) { chart.unit = 16; });
  throws([](auto& chart) { chart.ladder.dialect = Dialect::Q; });
}

TEST(FlowChart, OfAConfigurationWithoutTheHardwareIsRefused) {
  for (const char* config : {"hx8k", "gw2a"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(try_compile(example().chart, 3, diagnostics, config));
    EXPECT_EQ(only_error(diagnostics).what,
              std::string("configuration ") + config + " has no hardware for flow tasks");
  }
}

TEST(FlowChart, WithMoreThanTheHardwareHasIsRefused) {
  ChartMaker maker("");
  for (int task = 0; task < 101; ++task) maker.task("t" + std::to_string(task)).step("");
  Diagnostics tasks;
  EXPECT_FALSE(try_compile(maker.chart, 3, tasks));
  EXPECT_EQ(only_error(tasks).what, "the program has 101 tasks; the task hardware has 100");
  EXPECT_EQ(only_error(tasks).position, maker.chart.tasks[100].position);

  ChartMaker steps("");
  steps.task("t");
  for (int step = 0; step < 2049; ++step) steps.step("");
  Diagnostics of_steps;
  EXPECT_FALSE(try_compile(steps.chart, 3, of_steps));
  EXPECT_EQ(only_error(of_steps).what,
            "the program has 2049 steps, those of waits included; the task hardware has 2048");

  ChartMaker transfers("");
  transfers.task("t");
  for (int i = 0; i < 255; ++i) transfers.step("").read(kOther, i, 1, {DeviceKind::D, 0});
  transfers.step("").write(kOther, 254, 1, {DeviceKind::D, 0});  // one that is there
  EXPECT_EQ(image_of(transfers.chart).flow->transfers.size(), 255U);
  transfers.step("").write(kOther, 255, 1, {DeviceKind::D, 0});
  Diagnostics of_transfers;
  EXPECT_FALSE(try_compile(transfers.chart, 3, of_transfers));
  EXPECT_EQ(only_error(of_transfers).what,
            "the program has 256 different transfers; the task hardware has 255");
  EXPECT_EQ(only_error(of_transfers).position, transfers.chart.steps.back().write->position);

  ChartMaker board = example();
  board.chart.boards[0].number = 16;
  Diagnostics of_board;
  EXPECT_FALSE(try_compile(board.chart, 3, of_board));
  EXPECT_EQ(only_error(of_board).what,
            "board memory of this unit has number 16; the highest is 15");

  CompileOptions paper;
  paper.paper = true;
  Diagnostics of_paper;
  EXPECT_FALSE(compile_flow(example().chart, paper, of_paper));
  EXPECT_EQ(of_paper.error_count(), 1);
}

TEST(FlowChart, ThatDoesNotFitTheMemoryIsRefusedWithNumbers) {
  std::string rungs;
  for (int n = 0; n < 20; ++n) rungs += "LD X0\nOUT M" + std::to_string(n) + "\n";
  ChartMaker maker("LD X0\nOUT Y0\n");
  maker.task("t");
  for (int step = 0; step < 500; ++step) maker.step(rungs);
  Diagnostics diagnostics;
  EXPECT_FALSE(try_compile(maker.chart, 1, diagnostics));
  EXPECT_EQ(only_error(diagnostics).what,
            "the program needs 20002 instruction steps, 2 of its ladder and 20000 of its 500 flow "
            "steps; configuration ecp5 has 16384");

  ChartMaker words("");
  words.task("t");
  for (int i = 0; i < 40; ++i) {
    words.step("").read(kOther, i, 32, {DeviceKind::D, static_cast<std::uint32_t>(32 * i)});
  }
  Diagnostics of_words;
  EXPECT_FALSE(try_compile(words.chart, 3, of_words));
  EXPECT_EQ(only_error(of_words).what,
            "the program needs 1283 word devices; configuration ecp5 has 1024");

  std::string deep;
  for (int n = 0; n < 16; ++n) deep += "LD X" + std::to_string(n % 8) + "\n";
  deep += "ANDD= D0 D2\n";
  for (int n = 0; n < 15; ++n) deep += "ANB\n";
  ChartMaker nested("", Dialect::Q);
  nested.task("t").step(deep + "OUT Y0\n");
  Diagnostics of_stack;
  EXPECT_FALSE(try_compile(nested.chart, 1, of_stack));
  EXPECT_EQ(of_stack.error_count(), 1);
  EXPECT_TRUE(try_compile(nested.chart, 3, of_stack));
}

}  // namespace
}  // namespace rung::tb
