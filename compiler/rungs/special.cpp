// SPDX-License-Identifier: Apache-2.0
#include "rungs/special.hpp"

#include <algorithm>

namespace rung {
namespace {

using enum SpecialRole;

constexpr auto kFx = Dialect::Fx;
constexpr auto kQ = Dialect::Q;
constexpr auto kM = DeviceKind::M;
constexpr auto kSm = DeviceKind::SM;

constexpr SpecialRange kSpecials[] = {
    {kFx, kM, 8000, 8000, On, 0},
    {kFx, kM, 8001, 8001, Off, 0},
    {kFx, kM, 8002, 8002, FirstScan, 0},
    {kFx, kM, 8003, 8003, NotFirstScan, 0},
    {kFx, kM, 8011, 8011, Clock, 10'000},
    {kFx, kM, 8012, 8012, Clock, 100'000},
    {kFx, kM, 8013, 8013, Clock, 1'000'000},
    {kFx, kM, 8014, 8014, Clock, 60'000'000},
    {kFx, kM, 8020, 8020, Zero, 0},
    {kFx, kM, 8021, 8021, Borrow, 0},
    {kFx, kM, 8022, 8022, Carry, 0},
    {kFx, kM, 8067, 8068, Error, 0},
    {kFx, kM, 8200, 8234, Direction, 0},
    {kQ, kSm, 0, 0, Error, 0},
    {kQ, kSm, 56, 56, Error, 0},
    {kQ, kSm, 400, 400, On, 0},
    {kQ, kSm, 401, 401, Off, 0},
    {kQ, kSm, 402, 402, FirstScan, 0},
    {kQ, kSm, 403, 403, NotFirstScan, 0},
    {kQ, kSm, 409, 409, Clock, 10'000},
    {kQ, kSm, 410, 410, Clock, 100'000},
    {kQ, kSm, 411, 411, Clock, 200'000},
    {kQ, kSm, 412, 412, Clock, 1'000'000},
    {kQ, kSm, 413, 413, Clock, 2'000'000},
    {kQ, kSm, 700, 700, Carry, 0},
};

}  // namespace

std::span<const SpecialRange> special_ranges() { return kSpecials; }

const SpecialRange* find_special(Device device, Dialect dialect) {
  const auto* found =
      std::find_if(std::begin(kSpecials), std::end(kSpecials), [&](const SpecialRange& range) {
        return range.dialect == dialect && range.kind == device.kind &&
               device.number >= range.first && device.number <= range.last;
      });
  return found == std::end(kSpecials) ? nullptr : found;
}

std::vector<Device> devices_of_role(SpecialRole role, Dialect dialect) {
  std::vector<Device> devices;
  for (const SpecialRange& range : kSpecials) {
    if (range.role != role || range.dialect != dialect) continue;
    for (std::uint32_t n = range.first; n <= range.last; ++n) devices.push_back({range.kind, n});
  }
  return devices;
}

bool driven_value(const SpecialRange& special, ScanTime time) {
  switch (special.role) {
    case On:
      return true;
    case FirstScan:
      return time.scan == 0;
    case NotFirstScan:
      return time.scan != 0;
    case Clock:
      return 2 * time.scan * time.tick_us / special.period_us % 2 != 0;
    default:
      return false;
  }
}

std::int16_t ticks_since_last(std::int64_t base_us, ScanTime time) {
  if (time.scan == 0) return 0;
  const std::int64_t now = time.scan * time.tick_us / base_us;
  const std::int64_t before = (time.scan - 1) * time.tick_us / base_us;
  return static_cast<std::int16_t>(std::min<std::int64_t>(now - before, INT16_MAX));
}

}  // namespace rung
