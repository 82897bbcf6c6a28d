// SPDX-License-Identifier: Apache-2.0
#include "load/load_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "io/modbus_map.hpp"
#include "load/flow_words.hpp"
#include "load/format.hpp"
#include "load/io_list.hpp"
#include "load/units.hpp"
#include "rung_controller.hpp"
#include "rungs/ports.hpp"

namespace rung::load {
namespace {

using Words = std::vector<std::uint16_t>;
using Values = std::map<std::uint32_t, std::uint16_t>;

constexpr std::size_t kIoEntries = 256;
constexpr std::size_t kKeepRanges = 16;
constexpr int kKeepWords = 4;
constexpr std::int64_t kMostStep = 1 << 20;
constexpr std::int64_t kMostClocks = UINT32_MAX;
constexpr std::int64_t kMostFilterClocks = 1 << 16;
constexpr double kMostBaudError = 0.02;
constexpr int kMapped = 0x8000;  // of a device map's word: the point is a device

std::uint16_t low(std::int64_t value) { return static_cast<std::uint16_t>(value & 0xFFFF); }
std::uint16_t high(std::int64_t value) { return static_cast<std::uint16_t>(value >> 16 & 0xFFFF); }

// Devices that follow each other in one memory.
struct Keep {
  bool word = false;
  bool saved = false;
  int first = 0;
  int count = 0;
};

class Maker {
 public:
  Maker(const image::Image& image, const io::Bindings& bindings, std::int64_t clock_hz,
        Diagnostics& diagnostics)
      : image_(image), bindings_(bindings), clock_hz_(clock_hz), diagnostics_(diagnostics) {}

  std::optional<Words> run() {
    const int errors = diagnostics_.error_count();
    io();
    device_maps();
    keep();
    setup();
    host();
    code();
    flow();
    if (diagnostics_.error_count() > errors) return std::nullopt;
    return file();
  }

 private:
  void error(std::string what, std::string mend) {
    diagnostics_.error(image_.program, {}, std::move(what), std::move(mend));
  }
  void set(int space, std::uint32_t address, std::uint16_t value) {
    values_[space][address] = value;
  }

  void io() {
    const IoList list = io_list(image_, bindings_);
    const std::size_t entries = list.latch.size() + list.refresh.size();
    if (entries > kIoEntries) {
      error(fmt::format(
                "the program has {} inputs, outputs, relays and times that are refreshed each "
                "scan; the controller has room for {}",
                entries, kIoEntries),
            "name fewer X devices: an index register on X takes all that it may reach");
      return;
    }
    std::uint32_t address = 0;
    for (const auto* part : {&list.latch, &list.refresh}) {
      for (const IoEntry& entry : *part) {
        set(controller::space_io, address++, entry.address);
        set(controller::space_io, address++, entry.second_word());
      }
    }
    set(controller::space_setup, controller::setup_latch_count, low(list.latch.size()));
    set(controller::space_setup, controller::setup_refresh_first, low(list.latch.size()));
    set(controller::space_setup, controller::setup_refresh_count, low(list.refresh.size()));
  }

  void device_maps() {
    const Dialect dialect = *find_dialect(image_.dialect);
    const int last_word = isa::find_config(image_.config)->word_devices - 1;
    for (const image::ImageDevice& each : image_.devices) {
      if (is_port(each.device.kind)) continue;
      const auto point = io::point_of(each.device, dialect, image_.config);
      if (!point) continue;
      // Its number stands for no device there (hdl/controller/device_map.v).
      if (is_word(each.device) && each.address == last_word) {
        diagnostics_.warning(
            image_.program, {},
            fmt::format("{} is in the last word of memory, which Modbus clients do not "
                        "see: they read 0",
                        each.name),
            "use fewer words, or a configuration with more");
        continue;
      }
      set(is_word(each.device) ? controller::space_word_map : controller::space_bit_map,
          static_cast<std::uint32_t>(point->index),
          static_cast<std::uint16_t>(kMapped | each.address));
    }
  }

  static void add(std::vector<Keep>& ranges, bool word, bool saved, int address) {
    if (!ranges.empty()) {
      Keep& last = ranges.back();
      if (last.word == word && last.saved == saved && last.first + last.count == address) {
        ++last.count;
        return;
      }
    }
    ranges.push_back({word, saved, address, 1});
  }

  // Ranges over what is latched, in the order of memory, bits first; behind them the constants,
  // which the program has only once.
  void keep() {
    std::map<std::pair<bool, int>, Device> latched;
    const std::set<Device> wanted(bindings_.latched.begin(), bindings_.latched.end());
    for (const image::ImageDevice& each : image_.devices) {
      if (wanted.contains(each.device)) {
        latched.emplace(std::pair(is_word(each.device), each.address), each.device);
      }
    }
    std::vector<Keep> ranges;
    std::string layout;
    for (const auto& [place, device] : latched) {
      add(ranges, place.first, true, place.second);
      layout += fmt::format("{}:{} ", static_cast<int>(device.kind), device.number);
    }
    std::set<int> constants;
    for (const image::ImageConstant& each : image_.constants) {
      constants.insert(each.address);
      set(controller::space_words, static_cast<std::uint32_t>(each.address),
          static_cast<std::uint16_t>(each.value));
    }
    for (const int address : constants) add(ranges, true, false, address);
    if (ranges.size() > kKeepRanges) {
      error(fmt::format("the devices that are kept lie in {} ranges; the controller has {}",
                        ranges.size(), kKeepRanges),
            "keep devices that follow each other: [latched] in the I/O map");
    }
    check_ring(latched.size());
    std::uint32_t address = 0;
    for (const Keep& range : ranges) {
      set(controller::space_keep, address,
          static_cast<std::uint16_t>((range.word ? 1 : 0) | (range.saved ? 2 : 0)));
      set(controller::space_keep, address + 1, static_cast<std::uint16_t>(range.first));
      set(controller::space_keep, address + 2, static_cast<std::uint16_t>(range.count));
      set(controller::space_keep, address + 3, 0);
      address += kKeepWords;
    }
    // Saved values are told apart by what they are values of, in which order; where the devices lie
    // may change. Which names the PERSIST values have counts too.
    for (const std::string& name : image_.persist) layout += "=" + name + " ";
    const auto* bytes = reinterpret_cast<const Bytef*>(layout.data());
    const auto crc =
        static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<uInt>(layout.size())));
    retain_id_ = static_cast<std::uint16_t>(crc ^ crc >> 16);
    set(controller::space_host, controller::host_retain_id, retain_id_);
  }

  // A record of the ring is at most a sector: half of it in words, less a head, PERSIST values and
  // CRC.
  void check_ring(std::size_t devices) {
    constexpr std::size_t kMost = controller::flash_sector_bytes / 2 - 64;
    if (devices <= kMost) return;
    error(fmt::format("{} devices are kept; the flash has room for {}", devices, kMost),
          "keep fewer: [latched] in the I/O map");
  }

  void set_long(int space, int number, std::int64_t value) {
    set(space, static_cast<std::uint32_t>(number), low(value));
    set(space, static_cast<std::uint32_t>(number) + 1, high(value));
  }

  std::int64_t clocks(std::int64_t microseconds, const char* what) {
    const std::int64_t clocks = clocks_of(microseconds, clock_hz_);
    if (clocks > kMostClocks) {
      error(fmt::format("{} of {} ms has more clocks than the controller counts", what,
                        microseconds / 1000),
            "choose a shorter one in the I/O map");
    }
    return clocks;
  }

  void setup() {
    using namespace controller;
    const io::Settings& settings = bindings_.settings;
    set(space_setup, setup_exchange_points, low(settings.exchange_points));
    set_long(space_setup, setup_period_low, clocks(settings.period_us, "a period"));
    set_long(space_setup, setup_watchdog_low, clocks(settings.watchdog_us, "a watchdog"));
    const std::int64_t sample = std::max<std::int64_t>(1, clocks_of(settings.filter_us, clock_hz_));
    if (sample > kMostFilterClocks) {
      error(fmt::format(
                "filter_us = {}: a sample of the input filters may be {} clocks apart, {} us",
                settings.filter_us, kMostFilterClocks, kMostFilterClocks * 1'000'000 / clock_hz_),
            "choose a shorter filter_us, and more equal samples for an input's filter");
    }
    set(space_setup, setup_filter_clocks, low(sample - 1));
    if (bindings_.pwm) set_long(space_setup, setup_pwm_hz_low, bindings_.pwm->hz);
    for (const io::Bindings::Analog& each : bindings_.analog) {
      if (!is_port(each.device.kind)) continue;
      const auto channel = each.device.number - port::adc.number;
      set(space_setup, setup_adc_route + channel, low(each.channel));
    }
    for (const io::Bindings::Input& each : bindings_.inputs) {
      set(space_setup, static_cast<std::uint32_t>(setup_filter + each.pin),
          static_cast<std::uint16_t>(each.filter | (each.invert ? 16 : 0)));
    }
    // All of them: between two programs the firmware leaves outputs as the old one had them, so
    // that an inverted one does not come on meanwhile.
    std::vector<std::uint16_t> outputs(bindings_.board->outputs.size(), 0);
    for (const io::Bindings::Output& each : bindings_.outputs) {
      const int safe = each.safe == io::Safe::High ? 1 : each.safe == io::Safe::Hold ? 2 : 0;
      outputs[static_cast<std::size_t>(each.pin)] =
          static_cast<std::uint16_t>(safe | (each.invert ? 4 : 0));
    }
    for (std::size_t pin = 0; pin < outputs.size(); ++pin) {
      set(space_setup, static_cast<std::uint32_t>(setup_output + pin), outputs[pin]);
    }
  }

  std::int64_t checked_step(std::int64_t baud, const char* whose) {
    const std::int64_t step = baud_step(baud, clock_hz_);
    const double made = static_cast<double>(step) * static_cast<double>(clock_hz_) / kFractionsABit;
    const double wanted = static_cast<double>(baud);
    if (step < 1 || step >= kMostStep || std::abs(made - wanted) > kMostBaudError * wanted) {
      error(fmt::format("the controller's clock, {} Hz, cannot make the {} baud of {}", clock_hz_,
                        baud, whose),
            "choose a lower one");
    }
    return step;
  }

  void host() {
    using namespace controller;
    const io::Settings& settings = bindings_.settings;
    set(space_host, host_unit, low(settings.unit));
    set_long(space_host, host_baud_low, checked_step(settings.baud, "the host line"));
    set(space_host, host_parity, static_cast<std::uint16_t>(settings.parity));
    // 3.5 characters of 11 bits, as the standard counts them whatever the parity is.
    constexpr double kSilentBits = 3.5 * 11;
    constexpr int kFixedAbove = 19200;
    const double seconds =
        settings.baud > kFixedAbove ? 0.00175 : kSilentBits / static_cast<double>(settings.baud);
    set_long(space_host, host_silence_low,
             static_cast<std::int64_t>(std::ceil(seconds * static_cast<double>(clock_hz_))));
    set(space_host, host_policy,
        static_cast<std::uint16_t>((settings.stop_on_bad_download ? 1 : 0) |
                                   (settings.stop_after_power_up ? 2 : 0)));
    set(space_host, host_save_seconds, low(settings.save_seconds));
  }

  void code() {
    using namespace controller;
    for (std::size_t row = 0; row < image_.lut.size(); ++row) {
      set(space_lut, static_cast<std::uint32_t>(row), image_.lut[row]);
    }
    set(space_ports, 0, static_cast<std::uint16_t>(image_.port_bits | image_.port_words << 8));
    const bool uart = image_.uart;
    const std::int64_t step = uart ? checked_step(image_.baud, "the ladder's UART") : 0;
    set_long(space_ports, 1, step);
  }

  void flow() {
    if (!image_.flow) return;
    const io::FlowSettings& settings = bindings_.settings.flow;
    // Of a program without a panel the line stays idle at any rate, whatever the clock can make.
    const auto is_panel = [&](const image::FlowBoard& board) {
      return board.panel && board.unit == image_.flow->unit;
    };
    const auto& boards = image_.flow->boards;
    const std::int64_t step =
        std::any_of(boards.begin(), boards.end(), is_panel)
            ? checked_step(settings.panel_baud, "the panel's line")
            : std::min(baud_step(settings.panel_baud, clock_hz_), kMostStep - 1);
    for (const SpaceWord& each : flow_words(*image_.flow, settings, step)) {
      set(each.space, each.address, each.value);
    }
  }

  // The bits of a step, its slots side by side, slot 0 lowest, in chunks of 16.
  Words step_words(const std::vector<isa::SlotInstruction>& step, int chunks) const {
    const isa::Config& config = *isa::find_config(image_.config);
    const int width = isa::slot_bits(image_.mpu, config);
    Words out(static_cast<std::size_t>(chunks), 0);
    int at = 0;
    for (const isa::SlotInstruction& slot : step) {
      const std::uint64_t bits = isa::encode(slot, image_.mpu, config);
      for (int bit = 0; bit < width; ++bit, ++at) {
        if ((bits >> bit & 1) != 0) {
          out[static_cast<std::size_t>(at / 16)] |= static_cast<std::uint16_t>(1U << at % 16);
        }
      }
    }
    return out;
  }

  static void record(Words& words, int space, std::uint32_t address,
                     std::span<const std::uint16_t> data) {
    words.push_back(
        static_cast<std::uint16_t>(space << 12 | (address >> 16 & 0xF) << 8 | data.size()));
    words.push_back(static_cast<std::uint16_t>(address & 0xFFFF));
    words.insert(words.end(), data.begin(), data.end());
  }

  static void records(Words& words, int space, const Values& values) {
    for (auto at = values.begin(); at != values.end();) {
      const std::uint32_t first = at->first;
      Words data;
      for (; at != values.end() && at->first == first + data.size() && data.size() < kRecordWords;
           ++at) {
        data.push_back(at->second);
      }
      record(words, space, first, data);
    }
  }

  std::optional<Words> file() {
    const int chunks = chunks_of(image_.mpu, *isa::find_config(image_.config));
    Words words(kHeaderWords, 0);
    for (const auto& [space, values] : values_) records(words, space, values);
    // Records of whole steps.
    const std::size_t steps_a_record = kRecordWords / static_cast<std::size_t>(chunks);
    for (std::size_t first = 0; first < image_.steps.size(); first += steps_a_record) {
      const std::size_t end = std::min(first + steps_a_record, image_.steps.size());
      Words data;
      for (std::size_t step = first; step < end; ++step) {
        const Words bits = step_words(image_.steps[step], chunks);
        data.insert(data.end(), bits.begin(), bits.end());
      }
      record(words, controller::space_steps, static_cast<std::uint32_t>(first * kStepAddresses),
             data);
    }
    const Words length{low(static_cast<std::int64_t>(image_.length()))};
    record(words, controller::space_length, 0, length);
    words.push_back(0);
    words[kMagicAt] = kMagic;
    words[kFormatAt] = kFormat;
    words[kTablesAt] = controller::tables;
    words[kConfigAt] = static_cast<std::uint16_t>(config_id(image_.config));
    words[kBoardAt] = static_cast<std::uint16_t>(bindings_.board->id);
    words[kMpuAt] = static_cast<std::uint16_t>(image_.mpu);
    words[kLengthAt] = low(static_cast<std::int64_t>(words.size()));
    words[kLengthAt + 1] = high(static_cast<std::int64_t>(words.size()));
    words[kRetainAt] = retain_id_;
    words[kChunksAt] = static_cast<std::uint16_t>(chunks);
    if (words.size() > kMostWords) {
      error(fmt::format("the load file has {} words; the flash has room for {}", words.size(),
                        kMostWords),
            "split the program");
      return std::nullopt;
    }
    return words;
  }

  const image::Image& image_;
  const io::Bindings& bindings_;
  const std::int64_t clock_hz_;
  Diagnostics& diagnostics_;
  std::map<int, Values> values_;  // by space
  std::uint16_t retain_id_ = 0;
};

}  // namespace

io::Subject subject_of(const image::Image& image) {
  io::Subject subject;
  subject.file = image.program;
  subject.dialect = *find_dialect(image.dialect);
  subject.config = image.config;
  subject.mpu = static_cast<int>(image.mpu);
  for (const image::ImageDevice& each : image.devices) {
    subject.devices.push_back({each.device, each.name, each.comment});
  }
  subject.cycle_us = image.cycle_us;
  subject.uart = image.uart;
  subject.pwm = image.pwm;
  subject.own_pins = image.own_pins;
  subject.flow = image.flow.has_value();
  return subject;
}

std::optional<Words> make(const image::Image& image, const io::Bindings& bindings,
                          std::int64_t clock_hz, Diagnostics& diagnostics) {
  return Maker(image, bindings, clock_hz, diagnostics).run();
}

std::string to_bytes(const Words& words) {
  std::string bytes;
  bytes.reserve(2 * words.size());
  for (const std::uint16_t word : words) {
    bytes += static_cast<char>(word >> 8);
    bytes += static_cast<char>(word & 0xFF);
  }
  return bytes;
}

std::uint32_t crc32(const Words& words) {
  const std::string bytes = to_bytes(words);
  return static_cast<std::uint32_t>(
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

}  // namespace rung::load
