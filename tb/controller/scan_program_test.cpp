// SPDX-License-Identifier: Apache-2.0
// Whole programs in the controller, with time and pins as on a board: scan by scan the pins show
// what the reference shows, every scan takes the same clocks, and a client that reads as fast as it
// can sees whole scans.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "controller/scan_bus.hpp"
#include "passes/support.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr int kScans = 250;

std::string read_program(const std::string& name) {
  const auto path = std::filesystem::path(RUNG_REPOSITORY) / "tb/golden/programs" / (name + ".il");
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Bound {
  std::vector<Device> inputs, outputs;  // device of pin n
  std::vector<IoEntry> latch, refresh;
};

// Inputs and outputs to pins in their order; relays and ticks as the program has them.
Bound bind(const image::Image& image) {
  Bound bound;
  for (const image::ImageDevice& each : image.devices) {
    if (each.device.kind == DeviceKind::X) {
      bound.latch.push_back(
          {c::latch_pin, static_cast<int>(bound.inputs.size()), false, each.address});
      bound.inputs.push_back(each.device);
    } else if (each.device.kind == DeviceKind::Y) {
      bound.refresh.push_back(
          {c::refresh_pin, static_cast<int>(bound.outputs.size()), false, each.address});
      bound.outputs.push_back(each.device);
    }
    const SpecialRange* special = find_special(each.device, Dialect::Fx);
    if (special == nullptr || !is_driven(special->role)) continue;
    int status = 0;
    switch (special->role) {
      case SpecialRole::Off:
        status = 0;
        break;
      case SpecialRole::On:
        status = 1;
        break;
      case SpecialRole::FirstScan:
        status = 2;
        break;
      case SpecialRole::NotFirstScan:
        status = 3;
        break;
      default: {
        const std::int64_t periods[] = {10000, 100000, 200000, 1000000, 2000000, 60000000};
        status =
            4 + static_cast<int>(std::find(periods, periods + 6, special->period_us) - periods);
      }
    }
    bound.latch.push_back({c::latch_status, status, false, each.address});
  }
  for (const image::ImageTicks& ticks : image.ticks) {
    const int base = ticks.base_us == 1000 ? 0 : ticks.base_us == 10000 ? 1 : 2;
    bound.latch.push_back({c::latch_ticks, base, true, ticks.address});
  }
  return bound;
}

class Programs : public testing::TestWithParam<const char*> {};

TEST_P(Programs, PinsAreTheReferences) {
  const Program program = parse(read_program(GetParam()));
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu2;
  options.config = &ControllerBus::config();
  Diagnostics diagnostics;
  const auto compiled = compile(program, options, diagnostics);
  ASSERT_TRUE(compiled);
  const Bound bound = bind(compiled->image);
  ASSERT_FALSE(bound.outputs.empty());

  ControllerBus bus;
  bus.load_image(compiled->image);
  bus.load_io(bound.latch, bound.refresh);
  bus.setup(c::setup_exchange_points, 125);
  constexpr int kPeriod = 1307;  // 32.675 ms
  bus.setup32(c::setup_period_low, kPeriod);
  Reference reference(program, kPeriod * 1000 / ControllerBus::kClocksPerMs);
  RandomSource random(41);
  const std::uint32_t begin = bus.scans();
  const auto draw = [&] {
    for (std::size_t i = 0; i < bound.inputs.size(); ++i) {
      if (!random.percent(30)) continue;
      const std::uint32_t bit = 1U << i;
      bus->in_i ^= bit;
      reference.set(bound.inputs[i], (bus->in_i & bit) != 0 ? 1 : 0);
    }
  };
  draw();
  bus.clocks(4);
  bus.run();
  int changes = 0;
  std::uint32_t before = 0;
  for (int scan = 0; scan < kScans; ++scan) {
    while (bus.scans() - begin < static_cast<std::uint32_t>(scan + 1)) {
      // A client that does not stop.
      ExchangeRequest request;
      request.raw = request.words = true;
      request.read_count = 125;
      bus.post(request);
    }
    reference.run_scan();
    std::uint32_t want = 0;
    for (std::size_t i = 0; i < bound.outputs.size(); ++i) {
      if (reference.get(bound.outputs[i]) != 0) want |= 1U << i;
    }
    ASSERT_EQ(bus->out_o, want) << "scan " << scan;
    changes += want != before ? 1 : 0;
    before = want;
    draw();
  }
  EXPECT_GT(changes, 5);
  const auto clocks = static_cast<std::uint32_t>(compiled->image.clocks);
  EXPECT_EQ(bus.read32(c::reg_scan_min_low), bus.read32(c::reg_scan_max_low));
  EXPECT_EQ(bus.read32(c::reg_scan_last_low), bound.latch.size() + 4 + clocks + 4 +
                                                  bound.refresh.size() + 15 + 125 +
                                                  c::micro_exchange_clocks);
  EXPECT_EQ(bus.read(c::reg_scan_overruns), 0);
}

INSTANTIATE_TEST_SUITE_P(Fx, Programs,
                         testing::Values("elevator", "traffic_light", "bottle_counter",
                                         "step_ladder"));

}  // namespace
}  // namespace rung::tb
