// SPDX-License-Identifier: Apache-2.0
// The controller's Modbus line (rtu_line.v) and the panel's client (panel_client.v), Verilated.
#include <gtest/gtest.h>

#include <algorithm>

#include "controller/rtu_rules.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "link/panel_bench.hpp"
#include "rung_flow.hpp"

namespace rung::fuzz {
namespace {

using tb::Frame;

// Longer than a frame may be.
constexpr std::size_t kMostBytes = 300;

class RtuRun {
 public:
  void run(Input input) {
    while (!input.empty()) step(input);
    // Whatever came, the next good frame is received, whole.
    silence();
    take();
    const Frame good{1, 3, 0, 0, 0, 1};
    frame(tb::with_crc(good), 0, 0);
    silence();
    require(rules_.waiting == good && line_.frame_waits(), "a good frame behind it is lost");
  }

 private:
  void step(Input& input) {
    switch (input.below(8)) {
      case 0:
        frame(tb::with_crc(input.bytes(input.below(256))), input.below(8), 0);
        silence();
        break;
      case 1:
        frame(tb::with_crc(input.bytes(input.below(16))), input.below(8), 0);
        break;
      case 2:
        frame(input.bytes(input.below(kMostBytes)), input.below(8), 0);
        silence();
        break;
      case 3: {
        const std::uint8_t errors = input.byte();
        frame(tb::with_crc(input.bytes(input.below(16))), 0, errors);
        silence();
        break;
      }
      case 4:
        pause(static_cast<int>(input.below(tb::kSilence)));
        break;
      case 5:
        line_.hog = !line_.hog;
        break;
      case 6:
        take();
        break;
      default:
        silence();
    }
  }

  // `errors`: bit i of it set, byte i is one of the line.
  void frame(const Frame& bytes, unsigned more, unsigned errors) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const bool error = i < 8 && (errors >> i & 1) != 0;
      line_.byte(bytes[i], error);
      rules_.byte(bytes[i], error);
      quiet_ = 0;
      // With the RAM's port busy but for a clock in 64, a byte may take as long.
      pause((line_.hog ? 128 : tb::kShortest - 1) + static_cast<int>(more));
    }
  }
  // Never as long as ends a frame.
  void pause(int clocks) {
    clocks = std::min(clocks, tb::kSilence - 1 - quiet_);
    if (clocks <= 0) return;
    line_.pause(clocks);
    quiet_ += clocks;
  }
  void silence() {
    line_.silence();
    quiet_ = 0;
    rules_.silence();
    require(line_.frame_waits() == rules_.waiting.has_value(), "a frame too many, or one too few");
    require(line_.counts() == rules_.counts, "the line counts other frames");
    require(!rules_.waiting || line_.frame() == *rules_.waiting, "another frame than was sent");
  }
  void take() {
    // It takes a clock.
    if (!rules_.waiting || quiet_ >= tb::kSilence - 1) return;
    line_.take();
    ++quiet_;
    rules_.waiting.reset();
  }

  tb::RtuLine line_{1};
  tb::RtuRules rules_;
  int quiet_ = 0;  // clocks since the last byte
};

constexpr double kBit = 8.7;  // clocks
constexpr int kTimeoutMs = 20;

}  // namespace

void read_rtu_line(std::string_view bytes) { RtuRun().run(Input(bytes)); }

// Requests of the panel's boards, and answers of any bytes. What the rules of the bench say holds
// for each; and one more, which is answered rightly, is done.
void read_panel(std::string_view bytes) {
  Input input(bytes);
  tb::PanelBench bench(1, kBit, tb::Parity::Even, kTimeoutMs);
  while (!input.empty() && bench.number() < 5) {
    tb::PanelServer::Plan plan;
    const unsigned kind = input.below(12);
    if (kind < 9) {
      plan.answer = static_cast<tb::Answer>(kind);
    } else {
      plan.answer = tb::Answer::Raw;
      plan.raw = input.bytes(input.below(90));
    }
    plan.delay = input.below(12) * tb::kPanelClocksPerMs;
    bench.server.plan(plan);
    bench.server.echo = static_cast<tb::Echo>(input.below(3));
    bench.echoes = input.below(2) != 0;
    const bool write = input.below(2) != 0;
    const unsigned first = input.word();
    bench.ask(write, first, 1 + input.below(32));
    if (input.below(2) != 0) bench.run_to_end();
  }
  bench.run_to_end();
  // Nothing that is still on the line is an answer to this one.
  bench.server.forget_plans();
  bench.server.echo = tb::Echo::Right;
  bench.run(std::uint64_t{100} * tb::kPanelClocksPerMs);
  const std::size_t last = bench.ask(false, 7, 3);
  bench.run_to_end();
  for (std::size_t i = 0; i < bench.number(); ++i) bench.check(i);
  require(bench.asked(last).status == flow::flow_status_done,
          "a request that is answered rightly is not done");
  require(!testing::Test::HasFailure(), "the bench has found a fault");
}

}  // namespace rung::fuzz
