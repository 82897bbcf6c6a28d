// SPDX-License-Identifier: Apache-2.0
#include "soak/soak_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "driver/compile.hpp"
#include "io/map.hpp"
#include "load/load_file.hpp"
#include "melsec/list.hpp"
#include "programs/random_melsec.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"
#include "rung_controller.hpp"
#include "rungs/footprint.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr int kMostTries = 200;
// Many random programs do little at their outputs: of so many that fit, the liveliest.
constexpr int kChoice = 4;
constexpr int kTrialScans = 200;
// Of the firmware, for the longest answer to a poll in points; each of them costs every scan a
// clock.
constexpr int kPoints[] = {16, 32, 64};
// Inputs settle in the exchange phase, behind the refresh: its 48 clocks are enough.
constexpr int kMostWait = 200;

// Of one kind, below `end`.
std::vector<Device> of_kind(const std::vector<Device>& devices, DeviceKind kind,
                            std::uint32_t end) {
  std::vector<Device> found;
  for (const Device device : devices) {
    if (device.kind == kind && device.number < end) found.push_back(device);
  }
  return found;
}

std::uint32_t behind(const std::vector<Device>& devices, DeviceKind kind, std::uint32_t end) {
  const auto below = of_kind(devices, kind, end);
  return below.empty() ? 0 : below.back().number + 1;
}

std::optional<Program> parse(const std::string& text, Dialect dialect, std::uint64_t seed) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, fmt::format("soak-{}.il", seed), diagnostics);
  return source ? parse_list(*source, dialect, diagnostics) : std::nullopt;
}

// Special relays and registers are beyond those of the program's own.
constexpr std::uint32_t kSpecial = 8000;

class Maker {
 public:
  Maker(const controller::Board& board, std::uint64_t clocks_per_ms, std::uint64_t seed)
      : board_(board), clock_hz_(static_cast<std::int64_t>(1000 * clocks_per_ms)), random_(seed) {
    made_.seed = seed;
  }

  // Nothing when the program does not fit the board.
  std::shared_ptr<const SoakProgram> make() {
    if (!write_list() || !bind_pins()) return nullptr;
    set_clocks();
    return std::make_shared<SoakProgram>(std::move(made_));
  }

 private:
  bool write_list() {
    RandomMelsecOptions options = melsec_options(random_.bits());
    options.networks = 1 + random_.below(6);
    options.inputs = std::min<int>(options.inputs, static_cast<int>(board_.inputs.size()));
    options.outputs = std::min<int>(options.outputs, static_cast<int>(board_.outputs.size()) - 2);
    std::string list = random_melsec(random_.bits(), options);
    const auto plain = parse(list, options.dialect, made_.seed);
    if (!plain) return false;
    // The marks stand behind all that the program names.
    const std::vector<Device> all = visible_devices(*plain);
    const std::uint32_t y = behind(all, DeviceKind::Y, kSpecial);
    made_.bit.device = {DeviceKind::M, behind(all, DeviceKind::M, kSpecial)};
    made_.word.device = {DeviceKind::D, behind(all, DeviceKind::D, kSpecial)};
    marks_ = {{DeviceKind::Y, y}, {DeviceKind::Y, y + 1}};
    const auto name = [&](Device device) { return device_name(device, options.dialect); };
    // Before all the others: nothing that skips instructions stands there.
    list = fmt::format("LD {}\nOUT {}\nLD= {} K1\nOUT {}\n", name(made_.bit.device),
                       name(marks_[0]), name(made_.word.device), name(marks_[1])) +
           list;
    auto program = parse(list, options.dialect, made_.seed);
    if (!program) return false;
    made_.text = list;
    made_.program = std::move(*program);
    for (const Device device : named_devices(made_.program)) {
      if (io::point_of(device, options.dialect, board_.config)) made_.named.push_back(device);
    }
    std::sort(made_.named.begin(), made_.named.end());
    made_.relays = of_kind(made_.named, DeviceKind::M, made_.bit.device.number + 1);
    made_.words = of_kind(made_.named, DeviceKind::D, made_.word.device.number + 1);
    const auto there = [&](Device device) {
      return std::binary_search(made_.named.begin(), made_.named.end(), device);
    };
    return there(made_.bit.device) && there(made_.word.device);
  }

  bool bind_pins() {
    points_ = kPoints[random_.below(std::size(kPoints))];
    std::string map = fmt::format(
        "board = '{}'\n[controller]\nexchange_points = {}\nsave_seconds = 0\n[modbus]\n"
        "baud = 9600\nparity = 'none'\n[latched]\ndevices = []\n[inputs]\n",
        board_.name, points_);
    const Dialect dialect = made_.program.dialect;
    std::size_t pin = 0;
    const std::vector<Device> devices = named_devices(made_.program);
    for (const Device device : devices) {
      if (device.kind != DeviceKind::X) continue;
      if (pin == board_.inputs.size()) return false;
      map += fmt::format("{} = {{ pin = '{}', filter = 0, invert = {} }}\n",
                         device_name(device, dialect), board_.inputs[pin++], random_.percent(25));
    }
    map += "[outputs]\n";
    pin = 0;
    for (const Device device : devices) {
      if (device.kind != DeviceKind::Y) continue;
      if (pin == board_.outputs.size()) return false;
      // The marks are what they are.
      const bool mark = device == marks_[0] || device == marks_[1];
      static constexpr const char* kSafe[] = {"0", "1", "\"hold\""};
      map += fmt::format("{} = {{ pin = '{}', safe = {}, invert = {} }}\n",
                         device_name(device, dialect), board_.outputs[pin++],
                         mark ? "0" : kSafe[random_.below(3)], !mark && random_.percent(25));
    }
    made_.map = map;
    return compile_all();
  }

  bool compile_all() {
    Diagnostics diagnostics;
    CompileOptions options;
    options.mpu = static_cast<isa::Mpu>(board_.mpu);
    options.config = isa::find_config(board_.config);
    const auto compiled = compile(made_.program, options, diagnostics);
    if (!compiled) return false;
    auto map = io::parse_map(made_.map, "soak.toml", diagnostics);
    if (!map) throw std::runtime_error("the soak's I/O map is refused:\n" + made_.map);
    made_.bindings = io::bind(*map, load::subject_of(compiled->image), diagnostics);
    made_.timing = load::timing_of(compiled->image, made_.bindings, clock_hz_);
    // Half of them run freely, the others wait for a period, to the clock.
    const std::int64_t clock_us = 1'000'000 / clock_hz_;
    std::int64_t period = made_.timing.cycle;
    if (random_.percent(50)) {
      period += random_.below(kMostWait);
      map->settings.period_us = period * clock_us;
      map->has_period = true;
      made_.bindings = io::bind(*map, load::subject_of(compiled->image), diagnostics);
      made_.timing = load::timing_of(compiled->image, made_.bindings, clock_hz_);
    }
    made_.tick_us = made_.timing.period * clock_us;
    const auto words = load::make(compiled->image, made_.bindings, clock_hz_, diagnostics);
    if (!words || diagnostics.has_errors()) return false;
    made_.file = *words;
    return true;
  }

  void set_clocks() {
    quicken(made_.file);
    const load::Timing& timing = made_.timing;
    const auto set_watchdog = [](Words& file, std::int64_t clocks) {
      if (!patch(file, c::space_setup, c::setup_watchdog_low,
                 low(static_cast<std::size_t>(clocks))) ||
          !patch(file, c::space_setup, c::setup_watchdog_high,
                 high(static_cast<std::size_t>(clocks)))) {
        throw std::runtime_error("a load file without a watchdog");
      }
    };
    made_.tripping_file = made_.file;
    set_watchdog(made_.file, timing.cycle);
    const std::int64_t before_refresh = timing.latch + timing.scan + timing.refresh - 4;
    set_watchdog(made_.tripping_file, 1 + random_.below(static_cast<int>(before_refresh)));
    for (const io::Bindings::Output& each : made_.bindings.outputs) {
      const std::uint64_t pin = std::uint64_t{1} << each.pin;
      if (each.invert) made_.inverted |= pin;
      if (each.safe == io::Safe::Hold) {
        made_.held |= pin;
      } else if ((each.safe == io::Safe::High) != each.invert) {
        made_.safe |= pin;
      }
      if (each.device == marks_[0]) made_.bit.pin = each.pin;
      if (each.device == marks_[1]) made_.word.pin = each.pin;
    }
  }

  const controller::Board& board_;
  std::int64_t clock_hz_;
  RandomSource random_;
  SoakProgram made_;
  std::vector<Device> marks_;
  int points_ = 0;
};

// Scans, of some, in which its outputs change.
int lively(const SoakProgram& made) {
  Reference reference(made.program, made.tick_us);
  RandomSource random(made.seed);
  std::vector<std::int16_t> before;
  int changes = 0;
  for (int scan = 0; scan < kTrialScans; ++scan) {
    for (const io::Bindings::Input& input : made.bindings.inputs) {
      if (random.percent(15)) reference.set(input.device, reference.get(input.device) == 0);
    }
    reference.run_scan();
    std::vector<std::int16_t> now;
    for (const io::Bindings::Output& output : made.bindings.outputs) {
      now.push_back(reference.get(output.device));
    }
    changes += now != before ? 1 : 0;
    before = std::move(now);
  }
  return changes;
}

}  // namespace

std::shared_ptr<const SoakProgram> make_soak_program(const std::string& board,
                                                     std::uint64_t clocks_per_ms,
                                                     std::uint64_t seed) {
  const controller::Board* const found = io::find_board(board);
  if (found == nullptr) throw std::runtime_error("no board " + board);
  RandomSource seeds(seed);
  std::shared_ptr<const SoakProgram> best;
  int most = -1, fitting = 0;
  for (int i = 0; i < kMostTries && fitting < kChoice; ++i) {
    const auto made = Maker(*found, clocks_per_ms, seeds.bits()).make();
    if (!made) continue;
    ++fitting;
    const int changes = lively(*made);
    if (changes > most) {
      most = changes;
      best = made;
    }
  }
  if (best) return best;
  throw std::runtime_error(fmt::format("program {}: none of {} fits the board", seed, kMostTries));
}

}  // namespace rung::tb
