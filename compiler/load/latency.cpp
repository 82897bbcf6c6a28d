// SPDX-License-Identifier: Apache-2.0
#include "load/latency.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "load/flow_bound.hpp"
#include "load/io_list.hpp"
#include "load/units.hpp"
#include "rung_controller.hpp"

namespace rung::load {

Entries entries_of(const image::Image& image, const io::Bindings& bindings) {
  const IoList list = io_list(image, bindings);
  return {static_cast<int>(list.latch.size()), static_cast<int>(list.refresh.size())};
}

Timing timing_of(const image::Image& image, const io::Bindings& bindings, std::int64_t clock_hz) {
  const Entries entries = entries_of(image, bindings);
  const io::Settings& settings = bindings.settings;
  const bool ports = image.port_bits > 0 || image.port_words > 0;
  Timing timing;
  timing.clock_hz = clock_hz;
  timing.latch = entries.latch + controller::phases_latch_clocks;
  timing.flow = image.flow ? flow_bound(image).flow() : 0;
  timing.scan = timing.flow + image.clocks +
                (ports ? controller::phases_scan_ports_clocks : controller::phases_scan_clocks);
  timing.refresh = entries.refresh + controller::phases_refresh_clocks;
  timing.exchange = settings.exchange_points + controller::micro_exchange_clocks;
  timing.cycle = timing.latch + timing.scan + timing.refresh + timing.exchange;
  timing.period = std::max(timing.cycle, clocks_of(settings.period_us, clock_hz));

  const std::int64_t sample = std::max<std::int64_t>(1, clocks_of(settings.filter_us, clock_hz));
  int slowest = 0;
  int fastest = bindings.inputs.empty() ? 0 : bindings.inputs.front().filter;
  for (const io::Bindings::Input& each : bindings.inputs) {
    slowest = std::max(slowest, each.filter);
    fastest = std::min(fastest, each.filter);
  }
  timing.pins = controller::phases_input_clocks + controller::phases_output_clocks;
  timing.filter = slowest * sample;
  const std::int64_t response = timing.latch + timing.scan + timing.refresh + timing.pins;
  timing.best = response - timing.flow + std::max(0, fastest - 1) * sample;
  timing.worst = response + timing.filter + timing.period;
  return timing;
}

void check_timing(const Timing& timing, const io::Map& map, const io::Bindings& bindings,
                  const std::string& program, Diagnostics& diagnostics) {
  const io::Settings& settings = bindings.settings;
  const std::int64_t watchdog = clocks_of(settings.watchdog_us, timing.clock_hz);
  const auto ms = [&](std::int64_t clocks) {
    return 1e3 * static_cast<double>(clocks) / static_cast<double>(timing.clock_hz);
  };
  const std::string& file = map.file.empty() ? program : map.file;
  if (settings.watchdog_us > 0 && watchdog <= timing.cycle) {
    diagnostics.error(
        file, map.watchdog_position,
        fmt::format("the watchdog, {} ms, is not above a scan, which takes {} clocks, {:.4f} ms",
                    static_cast<double>(settings.watchdog_us) / 1000, timing.cycle,
                    ms(timing.cycle)),
        "choose a longer watchdog_ms, or fewer exchange_points");
  }
  if (settings.period_us > 0 && clocks_of(settings.period_us, timing.clock_hz) < timing.cycle) {
    diagnostics.warning(
        file, map.has_period ? map.period_position : SourcePosition{},
        fmt::format("the period, {} ms, is shorter than a scan, which takes {} clocks, {:.4f} ms: "
                    "every scan will overrun it",
                    static_cast<double>(settings.period_us) / 1000, timing.cycle, ms(timing.cycle)),
        "choose a longer period_ms, or fewer exchange_points");
  }
}

std::string to_string(const Timing& timing) {
  const auto us = [&](std::int64_t clocks) {
    return fmt::format("{} clocks ({:.2f} us)", clocks,
                       1e6 * static_cast<double>(clocks) / static_cast<double>(timing.clock_hz));
  };
  std::string text =
      fmt::format("scan cycle: latch {} + scan {} + refresh {} + exchange {} = {}\n", timing.latch,
                  timing.scan, timing.refresh, timing.exchange, us(timing.cycle));
  if (timing.period > timing.cycle) text += fmt::format("period: {}\n", us(timing.period));
  return text + fmt::format("input edge to output edge: {} at least, {} at most\n", us(timing.best),
                            us(timing.worst));
}

}  // namespace rung::load
