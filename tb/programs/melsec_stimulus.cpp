// SPDX-License-Identifier: Apache-2.0
#include "programs/melsec_stimulus.hpp"

#include <iterator>

#include "programs/random_source.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

constexpr std::int16_t kCorners[] = {0,      1,      -1,     2,      9,     10,
                                     255,    256,    9999,   10000,  32767, -32768,
                                     -32767, 0x0999, 0x1234, 0x00A0, 16384};
// The 10 ms tick is the usual one. 40 s is more than 32,767 ticks of 1 ms.
constexpr std::int64_t kTicksUs[] = {100,     1'000,   7'300,   10'000,    10'000,     10'000,
                                     100'000, 100'000, 250'000, 1'000'000, 17'000'000, 40'000'000};

std::int16_t word_value(RandomSource& random, DeviceKind kind) {
  if (kind == DeviceKind::V || kind == DeviceKind::Z) {
    // Mostly within the window, at times at its ends and far outside.
    if (random.percent(70)) return static_cast<std::int16_t>(random.below(12) - 3);
    if (random.percent(60)) return static_cast<std::int16_t>(random.below(300) - 150);
  }
  const int which = random.below(100);
  if (which < 45) return kCorners[random.below(static_cast<int>(std::size(kCorners)))];
  if (which < 70) return static_cast<std::int16_t>(random.below(12));
  return static_cast<std::int16_t>(random.bits() & 0xFFFF);
}

bool can_be_preset(Device device, Dialect dialect) {
  const SpecialRange* const special = find_special(device, dialect);
  return special == nullptr || !is_driven(special->role);
}

}  // namespace

std::vector<std::vector<StimulusEvent>> melsec_stimulus(std::uint64_t seed,
                                                        std::span<const Device> named,
                                                        Dialect dialect, int scans) {
  RandomSource random(seed ^ 0x7374696D);
  std::vector<std::vector<StimulusEvent>> events(static_cast<std::size_t>(scans));
  const int calm = random.below(3);  // how long inputs stay as they are
  for (int scan = 0; scan < scans; ++scan) {
    for (const Device device : named) {
      if (!can_be_preset(device, dialect)) continue;
      const bool word = is_word(device);
      const int chance = is_input(device) ? 50 >> calm : scan > 0 ? 1 : word ? 60 : 15;
      if (!random.percent(chance)) continue;
      const std::int16_t value =
          word ? word_value(random, device.kind) : static_cast<std::int16_t>(random.below(2));
      events[static_cast<std::size_t>(scan)].push_back({device, value});
    }
  }
  return events;
}

std::int64_t melsec_tick_us(std::uint64_t seed) {
  RandomSource random(seed ^ 0x7469636B);
  return kTicksUs[random.below(static_cast<int>(std::size(kTicksUs)))];
}

}  // namespace rung
