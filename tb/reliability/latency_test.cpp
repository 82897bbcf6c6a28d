// SPDX-License-Identifier: Apache-2.0
// From an edge at an input pin to the edge at an output pin, at all phases of scan and filter:
// never above the bound that `rung compile --io` prints, never below its least, and near to both.
// And the cycle that it prints is the controller's scan_last, of every program.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <numeric>

#include "programs/random_source.hpp"
#include "reliability/bench.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::uint64_t kForever = 1'000'000;
// The bound is for any phases, of which the worst need not be met exactly.
constexpr std::int64_t kNear = 4;
constexpr std::int64_t kNearFiltered = 25;  // a sample: scan and samples rarely meet at their worst

struct Case {
  const char* name;
  const char* board;
  const char* file;  // a sample, to which the rung is added; or none
  int points;
  bool period;
  int filter;
};

std::string list_of(const Case& one) {
  // Devices that no sample uses: X1000 and up are beyond them.
  const std::string rung = "LD X0\nOUT Y0\n";
  if (one.file == nullptr) return rung + "END\n";
  std::string text = golden(one.file);
  // The samples end without END or with it; their own X0 and Y0 are left alone.
  const std::size_t end = text.rfind("END");
  return text.substr(0, end) + "LD X177\nOUT Y177\n" +
         (end == std::string::npos ? "" : text.substr(end));
}

class Edges {
 public:
  Edges(SimulatedController& controller, int input, int output)
      : controller_(controller), input_(input), output_(output) {}

  // An edge at clock `at`, and how long the output takes; 0: for ever.
  std::uint64_t measure(std::uint64_t at) {
    controller_.run(at - controller_.now());
    level_ = !level_;
    controller_.changes();
    controller_.set_input(input_, level_);
    const std::uint64_t begun = controller_.now();
    while (controller_.now() < begun + kForever) {
      controller_.run(32);
      for (const auto& change : controller_.changes()) {
        if (change.pin == device::PinChange::Pin::Output && change.index == output_ &&
            change.level == level_) {
          return change.clock - begun;
        }
      }
    }
    return 0;
  }

 private:
  SimulatedController& controller_;
  int input_, output_;
  bool level_ = false;
};

std::string map_of(const Case& one) {
  const bool own = one.file == nullptr;
  const bool hx8k = std::string(one.board) == "hx8k";
  return fmt::format(
      "board = \"{}\"\n[controller]\nexchange_points = {}\n{}[inputs]\n{} = {{ pin = \"{}\", "
      "filter "
      "= {} }}\n[outputs]\n{} = \"{}\"\n",
      one.board, one.points, one.period ? "period_ms = 16.004\n" : "", own ? "X0" : "X177",
      hx8k ? "t1" : "in0", one.filter, own ? "Y0" : "Y177", hx8k ? "t5" : "out0");
}

class Latency : public testing::TestWithParam<Case> {};

TEST_P(Latency, EdgeToEdge) {
  const Case& one = GetParam();
  // Of the samples one case is enough for every day.
  if (!full() && one.file != nullptr && (one.points == 2000 || one.period || one.filter == 0))
    GTEST_SKIP();
  RandomSource random(base_seed());
  Made made = make_program(list_of(one), map_of(one));
  quicken(made.words);
  const auto controller = make_controller(one.board, 1);
  Client client(*controller);
  install(*controller, client, made.words);
  const load::Timing& timing = made.timing;
  client.gap = 160;
  // Past the first scans: of none there is nothing to read.
  controller->run(2 * static_cast<std::uint64_t>(timing.period));
  EXPECT_EQ(client.holding_long(c::holding_scan_last), timing.cycle);

  const auto period = static_cast<std::uint64_t>(timing.period);
  const std::uint64_t sample = one.filter != 0 ? 25 : 1;
  const std::uint64_t together = std::lcm(period, sample);
  Edges edges(*controller, made.bindings.inputs.at(0).pin, made.bindings.outputs.at(0).pin);
  std::uint64_t least = kForever, most = 0, least_at = 0, most_at = 0, measured = 0;
  const auto measure = [&](std::uint64_t at) {
    const std::uint64_t clocks = edges.measure(at);
    ASSERT_NE(clocks, 0U) << "no edge came out";
    ++measured;
    if (clocks > most) {
      most = clocks;
      most_at = at;
    }
    if (clocks < least) {
      least = clocks;
      least_at = at;
    }
  };
  for (std::uint64_t i = count(12, one.period ? 1000 : 2000); i > 0; --i) {
    measure(controller->now() + 200 + random.bits() % (2 * period));
    if (HasFatalFailure()) return;
  }
  // Around the best so far: with other phases of the filter, then earlier and later.
  const auto again = [&](std::uint64_t at) {
    std::uint64_t next = controller->now() + 200;
    next += (at % together + together - next % together) % together;
    measure(next);
  };
  for (int round = 0; round < 3 && !HasFatalFailure(); ++round) {
    for (std::uint64_t k = 1; sample > 1 && k < sample && !HasFatalFailure(); ++k) {
      again(most_at + k * period);
      again(least_at + k * period);
    }
    // By bisection in effect: large steps first.
    for (std::uint64_t step = std::bit_ceil(period / 16); step > 0 && !HasFatalFailure();
         step /= 2) {
      for (int times = 0; times < 16; ++times) {
        const std::uint64_t before = most;
        again(most_at + together - step);
        if (most <= before) break;
      }
      for (int times = 0; times < 16; ++times) {
        const std::uint64_t before = least;
        again(least_at + step);
        if (least >= before) break;
      }
    }
  }
  if (HasFatalFailure()) return;
  note("scan_clocks", static_cast<std::uint64_t>(timing.cycle));
  note("period_clocks", period);
  note("edges", measured);
  note("least", least);
  note("most", most);
  note("bound_least", static_cast<std::uint64_t>(timing.best));
  note("bound_most", static_cast<std::uint64_t>(timing.worst));
  const std::int64_t near = one.filter != 0 ? kNearFiltered : kNear;
  EXPECT_LE(static_cast<std::int64_t>(most), timing.worst);
  EXPECT_GE(static_cast<std::int64_t>(least), timing.best);
  EXPECT_GE(static_cast<std::int64_t>(most), timing.worst - near);
  EXPECT_LE(static_cast<std::int64_t>(least), timing.best + near);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  static const std::pair<const char*, const char*> programs[] = {
      {"rung", nullptr}, {"sample_3", "sample_3.il"}, {"sample_1", "sample_1.il"}};
  for (const auto& [name, file] : programs) {
    for (const int points : {2000, 64}) {
      for (const bool period : {false, true}) {
        for (const int filter : {0, 3}) {
          all.push_back({name, "simulated", file, points, period, filter});
        }
      }
    }
  }
  for (const int filter : {0, 3}) all.push_back({"rung_hx8k", "hx8k", nullptr, 64, false, filter});
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Latency, testing::ValuesIn(cases()), [](const auto& info) {
  const Case& one = info.param;
  return fmt::format("{}_{}_{}_filter{}", one.name, one.points, one.period ? "period" : "free",
                     one.filter);
});

// Every golden list that fits the board: the printed cycle is scan_last.
TEST(Cycle, IsScanLast) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const auto& entry :
       fs::directory_iterator(std::string(RUNG_REPOSITORY) + "/tb/golden/programs")) {
    if (entry.path().extension() == ".il") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  std::uint64_t programs = 0;
  for (const char* board : {"simulated", "hx8k"}) {
    const auto controller = make_controller(board, base_seed());
    Client client(*controller);
    bool first = true;
    for (std::size_t i = 0; i < names.size(); i += full() ? 1 : 12) {
      Made made;
      try {
        made = make_program(golden(names[i]), fmt::format("board = \"{}\"\n[controller]\n"
                                                          "exchange_points = {}\n",
                                                          board, 100 + 10 * i));
      } catch (const std::runtime_error&) {
        continue;  // too large for the board
      }
      quicken(made.words);
      install(*controller, client, made.words);
      if (first) client.gap = 160;
      first = false;
      controller->run(3 * static_cast<std::uint64_t>(made.timing.period));
      client.command(4);
      for (int times = 0; times < 4; ++times) {
        const Words scans = client.read(c::holding_scan_last, 6);
        const auto cycle = static_cast<std::uint16_t>(made.timing.cycle);
        EXPECT_EQ(scans[0], cycle) << names[i] << " on " << board;
        EXPECT_EQ(scans[2], cycle) << names[i] << " on " << board;
        EXPECT_EQ(scans[4], cycle) << names[i] << " on " << board;
      }
      ++programs;
    }
  }
  note("programs", programs);
  EXPECT_GT(programs, 1U);
}

}  // namespace
}  // namespace rung::tb
