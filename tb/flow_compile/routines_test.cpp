// SPDX-License-Identifier: Apache-2.0
// Each routine of an image against what compile() gives for its rungs alone: the same instructions,
// with other addresses and LUT rows. Addresses may differ only from program to program, and a name
// has one in all routines.
#include <chrono>
#include <cstdio>
#include <map>
#include <random>

#include "driver/flow_parts.hpp"
#include "flow_compile/support.hpp"
#include "lower/lower.hpp"
#include "programs/random_melsec.hpp"

namespace rung::tb {
namespace {

using isa::SlotInstruction;
using isa::WordKind;

// Which address of the one image is which of the other.
class Pairs {
 public:
  ::testing::AssertionResult same(int alone, int among) {
    const auto [there, fresh] = to_.try_emplace(alone, among);
    const auto [back, fresh_back] = from_.try_emplace(among, alone);
    if (there->second == among && back->second == alone) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "device " << alone << " is " << among << " and was " << there->second;
  }
  bool has(int alone, int among) const {
    const auto found = to_.find(alone);
    return found != to_.end() && found->second == among;
  }

 private:
  std::map<int, int> to_, from_;
};

struct Places {
  Pairs bits, words;
};

void expect_same(const SlotInstruction& alone, const SlotInstruction& among,
                 const image::Image& alone_image, const image::Image& image, Places& places) {
  ASSERT_EQ(alone.opcode, among.opcode);
  SCOPED_TRACE(std::string(isa::info(alone.opcode).name));
  ASSERT_EQ(alone.always, among.always);
  ASSERT_EQ(alone.kind, among.kind);
  const bool mpu1 = image.mpu == isa::Mpu::Mpu1;
  const isa::Format format = isa::info(alone.opcode).format;
  const bool bit = format == isa::Format::Bit && alone.opcode != isa::Opcode::Ldx &&
                   alone.opcode != isa::Opcode::Setx && alone.opcode != isa::Opcode::Rstx;
  if (mapping::is_lookup(alone.opcode)) {
    ASSERT_EQ(alone_image.lut.at(alone.row), image.lut.at(among.row));
  }
  const auto operand = [&](const isa::BitOperand& a, const isa::BitOperand& b) {
    ASSERT_EQ(a.n0, b.n0);
    // Beside N0 there is a device only where the look-up writes one.
    if (a.n0 && a.device == 0 && b.device == 0) return;
    ASSERT_TRUE(places.bits.same(a.device, b.device));
  };
  const bool loads = alone.opcode == isa::Opcode::Ld;
  if (bit && mpu1) operand(alone.a, among.a);
  if (bit && !mpu1) {
    const bool inputs = mapping::is_lookup(alone.opcode) || alone.opcode == isa::Opcode::Get;
    if (inputs || loads) operand(alone.a, among.a);
    if (inputs) operand(alone.b, among.b);
    if (!loads) operand(alone.c, among.c);
  }
  if (format == isa::Format::Test) {
    operand(mpu1 ? alone.a : alone.c, mpu1 ? among.a : among.c);
  }
  if (format != isa::Format::Word && format != isa::Format::Test) return;
  const bool indexes = alone.opcode == isa::Opcode::Ix;  // its constant is an address
  if (alone.kind == WordKind::Devices) {
    ASSERT_TRUE(alone.source == 0 || places.words.same(alone.source, among.source));
  } else if (!indexes) {
    ASSERT_EQ(alone.source, among.source);
  } else {
    ASSERT_TRUE(places.words.has(alone.source, among.source) ||
                places.bits.has(alone.source, among.source));
  }
  ASSERT_TRUE(alone.rs == 0 || places.words.same(alone.rs, among.rs));
  ASSERT_TRUE(alone.rd == 0 || places.words.same(alone.rd, among.rd));
}

std::map<Device, int> named(const image::Image& image) {
  std::map<Device, int> out;
  for (const image::ImageDevice& each : image.devices) out[each.device] = each.address;
  return out;
}

// The routine from `entry` to before `end`, of `rungs`.
void expect_routine(const Program& rungs, const image::Image& image, int entry, int end,
                    std::int64_t clocks) {
  CompileOptions options;
  options.mpu = image.mpu;
  Diagnostics diagnostics;
  const auto alone = compile(rungs, options, diagnostics);
  ASSERT_TRUE(alone) << printed(diagnostics);
  ASSERT_EQ(end - entry, static_cast<int>(alone->image.steps.size()));
  EXPECT_EQ(clocks, alone->image.clocks);
  Places places;
  const auto of = named(image);
  for (const auto& [device, address] : named(alone->image)) {
    ASSERT_TRUE(of.contains(device));
    ASSERT_TRUE((is_word(device) ? places.words : places.bits).same(address, of.at(device)));
  }
  for (int step = entry; step < end; ++step) {
    const auto& ones = alone->image.steps[static_cast<std::size_t>(step - entry)];
    const auto& others = image.steps[static_cast<std::size_t>(step)];
    ASSERT_EQ(ones.size(), others.size());
    for (std::size_t slot = 0; slot < ones.size(); ++slot) {
      SCOPED_TRACE("step " + std::to_string(step) + ", slot " + std::to_string(slot));
      expect_same(ones[slot], others[slot], alone->image, image, places);
      if (::testing::Test::HasFatalFailure()) return;
      const auto at = static_cast<std::size_t>(step - entry);
      const int origin = alone->image.origins[at][slot];
      const int among = image.origins[static_cast<std::size_t>(step)][slot];
      ASSERT_EQ(origin < 0, among < 0);
      if (origin >= 0) {
        ASSERT_EQ(alone->image.source[origin].text, image.source[among].text);
      }
    }
  }
}

void expect_routines(const flowchart::Flowchart& chart, int mpu, bool ladder_as_alone) {
  SCOPED_TRACE("MPU" + std::to_string(mpu));
  const image::Image image = image_of(chart, mpu);
  const image::FlowImage& flow = *image.flow;
  ASSERT_EQ(flow.steps.size(), chart.steps.size());
  if (ladder_as_alone) {
    expect_routine(chart.ladder, image, 0, flow.ladder_steps, image.clocks);
  }
  int entry = flow.ladder_steps;
  for (std::size_t i = 0; i < chart.steps.size(); ++i) {
    SCOPED_TRACE(chart.steps[i].name);
    ASSERT_EQ(flow.steps[i].entry, entry);
    entry = flow.steps[i].end;
    expect_routine(chart.steps[i].rungs, image, flow.steps[i].entry, entry, flow.steps[i].clocks);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_EQ(entry, static_cast<int>(image.steps.size()));
}

TEST(FlowRoutines, AreThoseOfTheirRungsAlone) {
  // The example's ladder counts the time of waits, which it would not do alone.
  for (const int mpu : {1, 2, 3}) expect_routines(example().chart, mpu, false);
}

TEST(FlowRoutines, OfRandomRungsAreThoseOfTheRungsAlone) {
  constexpr std::uint64_t kSeeds = 6;
  constexpr std::size_t kSteps = 12;
  std::size_t steps = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed) +
                 ": flow_compile_test --gtest_filter=FlowRoutines.OfRandom*");
    const Dialect dialect = seed % 2 == 0 ? Dialect::Fx : Dialect::Q;
    const auto text = [&](std::uint64_t number, bool step) {
      RandomMelsecOptions options = melsec_options(number);
      options.dialect = dialect;
      options.networks = step ? 2 : 6;
      for (const Family family : {Family::Edges, Family::Timers, Family::Counters, Family::Pulse,
                                  Family::States, Family::Flow}) {
        if (step) options.weight(family) = 0;
      }
      std::string list = random_melsec(number, options);
      return list.substr(0, list.rfind("END"));
    };
    ChartMaker maker(text(1000 * seed, false), dialect);
    maker.task("random");
    for (std::uint64_t i = 1; maker.chart.steps.size() < kSteps && i < 50; ++i) {
      const std::string rungs = text(1000 * seed + i, true);
      // Not all that remembers is in a family of its own.
      if (flow_parts::remembers(lower::lower(list(rungs, dialect))).empty()) maker.step(rungs);
    }
    steps += maker.chart.steps.size();
    expect_routines(maker.chart, 1 + static_cast<int>(seed % 3), true);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(steps, kSeeds * kSteps / 2);
}

// More functions of look-ups that write than there are rows: none of them fits, all of them do
// without.
TEST(FlowRoutines, ShareTheRowsOfTheLut) {
  ChartMaker maker("");
  maker.task("functions");
  for (int function = 0; function < 256; ++function) {
    std::string text;
    const std::string coil = "M" + std::to_string(function);
    for (int address = 0; address < 8; ++address) {
      if ((function >> address & 1) == 0) continue;
      const bool first = text.empty();
      text += std::string((address & 4) != 0 ? "LD" : "LDI") + " X0\n";
      text += std::string((address & 2) != 0 ? "AND" : "ANI") + " X1\n";
      text += std::string((address & 1) != 0 ? "AND " : "ANI ") + coil + "\n";
      if (!first) text += "ORB\n";
    }
    if (text.empty()) text = "LD X0\nANI X0\n";
    maker.step(text + "OUT " + coil + "\n");
  }
  const image::Image image = image_of(maker.chart);
  EXPECT_LE(image.statistics.lut_rows, isa::constant::lut_rows);
  EXPECT_GE(image.statistics.lut_rows, 80);
  EXPECT_EQ(image.lut.size(), static_cast<std::size_t>(image.statistics.lut_rows));
}

// 100 tasks of 20 steps each, as large a program as is promised.
TEST(FlowRoutines, OfTwoThousandStepsCompileInSeconds) {
  ChartMaker maker(ladder_text());
  for (int task = 0; task < 100; ++task) {
    maker.task("t" + std::to_string(task));
    for (int step = 0; step < 20; ++step) {
      const std::string n = std::to_string(step);
      const std::string in = "X" + std::to_string(step % 8);
      const std::string next = std::to_string(20 * task + (step + 1) % 20);
      switch (step % 4) {
        case 0:
          maker.step("LD " + in + "\nAND M0\nOR Y1\nANI X7\nOUT M1" + n + "\nLD M1" + n +
                     "\nMOV K" + next + " D7000\n");
          maker.read(kOther, step, 8, {DeviceKind::D, 100});
          break;
        case 1:
          maker.step("LD M8000\nADD D100 D101 D7200\nMUL D7200 D103 D7201\nADD D7201 K" + n +
                     " D10\nLD> D10 K100\nMOV K" + next + " D7000\n");
          break;
        case 2:
          maker.step("LD M8000\nDIV D10 D11 D12\nLD<= D12 D13\nAND " + in + "\nMOV K" + next +
                     " D7000\nLD> D12 D13\nMOV K3 D20\nMOV K" + next + " D7000\n");
          break;
        default:
          maker.step("LD M8000\nSUB D7003 D" + std::to_string(7100 + task) +
                     " D7200\nLD>= D7200 K500\nMOV K" + next + " D7000\nSET Y1\n");
          maker.write(kPanel, step, 4, {DeviceKind::D, 110});
      }
    }
  }
  for (const int mpu : {1, 2, 3}) {
    const auto start = std::chrono::steady_clock::now();
    const image::Image image = image_of(maker.chart, mpu);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::printf("MPU%d: 2,000 flow steps, %zu instruction steps, compiled in %.2f s\n", mpu,
                image.steps.size(), took.count());
    EXPECT_LT(image.steps.size(), 16384U);
    EXPECT_EQ(image.flow->transfers.size(), 10U);
    // The sanitizers and a busy machine take ten times as long.
    EXPECT_LT(took.count(), 40.0);
  }
}

}  // namespace
}  // namespace rung::tb
