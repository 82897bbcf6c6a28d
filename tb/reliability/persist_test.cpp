// SPDX-License-Identifier: Apache-2.0
// PERSIST values of an LDmicro program: the program counts edges and asks that the count be kept;
// power goes at random clocks around each.
#include <fmt/format.h>

#include "io/modbus_map.hpp"
#include "programs/random_source.hpp"
#include "reliability/bench.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
using Pin = device::PinChange::Pin;

constexpr const char* kCounter =
    "LDmicro0.1\nCYCLE=2000\nIO LIST\nXin at 0\nYout at 0\nEND\nPROGRAM\n"
    "RUNG\nCONTACTS Xin 0\nOSR\nADD kept kept 1\nEND\n"
    "RUNG\nCONTACTS Xin 0\nCOIL Yout 0 0 0\nEND\n"
    "RUNG\nPERSIST kept\nEND\n";

TEST(Persist, KeptOverPowerCuts) {
  const std::uint64_t seed = base_seed();
  RandomSource random(seed);
  Made made = make_program(kCounter,
                           "board = \"hx8k\"\n[controller]\nexchange_points = 64\n[inputs]\n"
                           "Xin = \"t1\"\n[outputs]\nYout = \"t5\"\n");
  quicken(made.words);
  int address = -1;
  for (const auto& each : made.image.devices) {
    if (each.name != "kept") continue;
    const auto point = io::point_of(each.device, Dialect::Ldmicro, made.image.config);
    ASSERT_TRUE(point);
    address = point->address;
  }
  ASSERT_GE(address, 0);
  const int input = made.bindings.inputs.at(0).pin;
  const auto controller = make_controller("hx8k", seed, false);
  Client client(*controller);
  install(*controller, client, made.words);
  client.gap = 160;
  int kept = client.holding(address);
  const std::uint64_t all = count(2, 100);
  std::uint64_t completed = 0, before = 0, after = 0;
  for (std::uint64_t i = 0; i < all; ++i) {
    const std::string what = fmt::format("seed {}, cut {}", seed, i);
    bool done = false;
    // Every second one surely after the saving.
    client.cut_at = controller->now() + (i % 2 == 0 ? random.bits() % 40'000 : 400'000);
    try {
      const int saves = client.holding(c::holding_saves);
      controller->set_input(input, true);
      while (client.holding(c::holding_saves) == saves) continue;
      done = true;
      while (true) client.holding(address);
    } catch (const Cut&) {
    }
    controller->power_cycle();
    controller->set_input(input, false);
    ASSERT_TRUE(run_until(
        *controller, [&] { return controller->lamp(Pin::Run); }, 20'000'000));
    client.gap = Client::kGap;
    const int now = client.holding(address);
    client.gap = 160;
    ASSERT_TRUE(now == kept + 1 || (now == kept && !done))
        << what << ": " << now << ", before it " << kept << (done ? ", saved" : "");
    completed += done ? 1 : 0;
    ++(now == kept ? before : after);
    kept = now;
  }
  EXPECT_GT(completed, 0U);
  note("cuts", all);
  note("after_a_whole_saving", completed);
  note("value_before_after", fmt::format("{} {}", before, after));
}

}  // namespace
}  // namespace rung::tb
