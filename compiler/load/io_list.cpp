// SPDX-License-Identifier: Apache-2.0
#include "load/io_list.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "rung_controller.hpp"
#include "rungs/special.hpp"

namespace rung::load {
namespace {

// Bits of the controller's status (hdl/isa/controller.toml, latch "status").
int status_index(const SpecialRange& special) {
  switch (special.role) {
    case SpecialRole::Off:
      return 0;
    case SpecialRole::On:
      return 1;
    case SpecialRole::FirstScan:
      return 2;
    case SpecialRole::NotFirstScan:
      return 3;
    default:
      break;
  }
  static const std::map<std::int64_t, int> kClocks = {
      {10'000, 4}, {100'000, 5}, {200'000, 6}, {1'000'000, 7}, {2'000'000, 8}, {60'000'000, 9}};
  return kClocks.at(special.period_us);
}

int ticks_index(std::int64_t base_us) {
  static const std::map<std::int64_t, int> kBases = {{1'000, 0}, {10'000, 1}, {100'000, 2}};
  return kBases.at(base_us);
}

}  // namespace

IoList io_list(const image::Image& image, const io::Bindings& bindings) {
  const Dialect dialect = *find_dialect(image.dialect);
  IoList list;
  const auto bound = [](const auto& lines, Device device) {
    return std::find_if(lines.begin(), lines.end(),
                        [&](const auto& line) { return line.device == device; });
  };
  for (const image::ImageDevice& each : image.devices) {
    if (is_port(each.device.kind)) continue;
    IoEntry entry{static_cast<std::uint16_t>(each.address), is_word(each.device)};
    const SpecialRange* special = find_special(each.device, dialect);
    const auto analog = bound(bindings.analog, each.device);
    if (each.device.kind == DeviceKind::X) {
      const auto input = bound(bindings.inputs, each.device);
      const bool pin = input != bindings.inputs.end();
      entry.kind = pin ? controller::latch_pin : controller::latch_none;
      entry.index = pin ? input->pin : 0;
    } else if (special != nullptr && is_driven(special->role)) {
      entry.kind = controller::latch_status;
      entry.index = status_index(*special);
    } else if (analog != bindings.analog.end()) {
      entry.kind = controller::latch_adc;
      entry.index = analog->channel;
    } else {
      continue;
    }
    list.latch.push_back(entry);
  }
  for (const image::ImageTicks& each : image.ticks) {
    list.latch.push_back({static_cast<std::uint16_t>(each.address), true, controller::latch_ticks,
                          ticks_index(each.base_us)});
  }
  for (const image::ImageDevice& each : image.devices) {
    const IoEntry entry{static_cast<std::uint16_t>(each.address), is_word(each.device)};
    const auto output = bound(bindings.outputs, each.device);
    if (output != bindings.outputs.end()) {
      list.refresh.push_back({entry.address, false, controller::refresh_pin, output->pin});
    } else if (bindings.pwm && bindings.pwm->device == each.device) {
      list.refresh.push_back({entry.address, true, controller::refresh_pwm, bindings.pwm->pin});
    }
  }
  return list;
}

}  // namespace rung::load
