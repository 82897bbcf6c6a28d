// SPDX-License-Identifier: Apache-2.0
#include "trace/stimulus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

#include "rungs/devices.hpp"
#include "rungs/ports.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

// So many scans take weeks; a larger number is a typing error.
constexpr std::uint64_t kMostScans = 1'000'000'000'000;

template <typename Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

// T0 for TS0, which lists say of contact and value alike.
bool is_short_name(std::string_view name, Device device) {
  if (!is_timer(device.kind) && !is_counter(device.kind)) return false;
  const std::string_view letters = kind_letters(device.kind);
  const char last = letters.back();
  return name.size() < letters.size() ||
         std::toupper(static_cast<unsigned char>(name[letters.size() - 1])) != last;
}

// A device, or what is wrong with its name.
struct CheckedDevice {
  std::optional<Device> device;
  std::string what = {};
  std::string mend = {};
};

CheckedDevice check_list_device(std::string_view name, Dialect dialect) {
  const ParsedDevice parsed = parse_device(name, dialect);
  if (parsed.error == DeviceError::Special) {
    return {std::nullopt,
            fmt::format("{} is a special device that this controller does not have", name)};
  }
  if (parsed.error != DeviceError::None) {
    return {std::nullopt, fmt::format("{} is no device of dialect {}", name, dialect_name(dialect)),
            "a stimulus names devices as traces do, X0 M5 S20 D7 TN0 CN200:h, in the number base "
            "of the dialect"};
  }
  const Device device = parsed.device;
  if (is_short_name(name, device)) {
    return {std::nullopt, fmt::format("{} is both a contact and a value", name),
            fmt::format("write {} for the contact or {} for the value",
                        device_name(device, dialect), device_name(value_of(device), dialect))};
  }
  const SpecialRange* special = find_special(device, dialect);
  if (special != nullptr && is_driven(special->role)) {
    return {std::nullopt, fmt::format("{} cannot be set: the controller drives it", name),
            "it follows from the scans and from --tick"};
  }
  return {device};
}

bool same_letters(std::string_view left, std::string_view right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(), [](char a, char b) {
    return std::toupper(static_cast<unsigned char>(a)) ==
           std::toupper(static_cast<unsigned char>(b));
  });
}

CheckedDevice unknown_name(std::string_view name, const DeviceNames& names) {
  const auto& all = names.all();
  const auto near = std::find_if(all.begin(), all.end(),
                                 [&](const auto& each) { return same_letters(each.second, name); });
  return {std::nullopt, fmt::format("the program has no {}", name),
          near == all.end()
              ? "a stimulus names the program's own inputs, relays, variables and channels"
              : fmt::format("write {}: case matters", near->second)};
}

// What a stimulus means by a name that a program gives: of one that is both a bit and a variable
// the input, else the variable.
CheckedDevice check_own_device(std::string_view name, const DeviceNames& names) {
  if (name == "RX") return {port::uart_rx_data};
  const auto plain = names.device(name);
  if (plain && is_input(*plain)) return {plain};
  if (const auto channel = names.channel(name)) return {channel};
  if (const auto variable = names.device(std::string(name) + ":w")) return {variable};
  return plain ? CheckedDevice{plain} : unknown_name(name, names);
}

// The same of the `in` of a trace, where a name is what the trace calls the device.
CheckedDevice check_trace_device(std::string_view name, const DeviceNames& names) {
  if (const auto channel = names.channel(name)) return {channel};
  const auto device = names.device(name);
  return device ? CheckedDevice{device} : unknown_name(name, names);
}

// The event of a device and the text of its value, or what is wrong with them.
struct CheckedEvent {
  std::optional<StimulusEvent> event;
  std::string what;
  std::string mend;
};

CheckedEvent check_event(CheckedDevice checked, std::string_view name, std::string_view value) {
  if (!checked.device) return {std::nullopt, std::move(checked.what), std::move(checked.mend)};
  const Device device = *checked.device;
  const bool byte = device == port::uart_rx_data;
  const std::optional<int> number = whole_number<int>(value);
  const int least = is_word(device) && !byte ? INT16_MIN : 0;
  const int most = byte ? UINT8_MAX : is_word(device) ? INT16_MAX : 1;
  if (!number || *number < least || *number > most) {
    return {
        std::nullopt,
        fmt::format("the value of {} is {}, not a number from {} to {}", name, value, least, most),
        {}};
  }
  return {StimulusEvent{device, static_cast<std::int16_t>(*number)}, {}, {}};
}

class LineReader {
 public:
  LineReader(const std::string& file, const DeviceNames& names, Diagnostics& diagnostics)
      : file_(file), names_(names), diagnostics_(diagnostics) {}

  void token(std::string_view text, SourcePosition position) {
    if (text.front() == '_') return;
    if (text.front() == '*') return repeat(text, position);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      diagnostics_.error(file_, position, fmt::format("{} is no stimulus", text),
                         names_.own()
                             ? "write Xname=1 for an input, name=7 for a variable or an analogue "
                               "channel, RX=65 for a byte, *10 for ten scans"
                             : "write X0=1 for an input, D5=7 for a preset, *10 for ten scans");
      return;
    }
    const std::string_view name = text.substr(0, equals);
    CheckedDevice device =
        names_.own() ? check_own_device(name, names_) : check_list_device(name, names_.dialect());
    CheckedEvent checked = check_event(std::move(device), name, text.substr(equals + 1));
    if (checked.event) {
      events_.push_back(*checked.event);
    } else {
      diagnostics_.error(file_, position, std::move(checked.what), std::move(checked.mend));
    }
  }

  void finish(Stimulus& stimulus) {
    stimulus.append(std::exchange(events_, {}), std::max<std::uint64_t>(count_, 1));
    count_ = 0;
  }

 private:
  void repeat(std::string_view text, SourcePosition position) {
    const std::optional<std::uint64_t> count = whole_number<std::uint64_t>(text.substr(1));
    if (!count || *count == 0 || *count > kMostScans) {
      diagnostics_.error(file_, position, fmt::format("{} is no number of scans", text),
                         fmt::format("write *1 to *{}", kMostScans));
    } else if (count_ != 0) {
      diagnostics_.error(file_, position, "this line has a number of scans already");
    } else {
      count_ = *count;
    }
  }

  const std::string& file_;
  const DeviceNames& names_;
  Diagnostics& diagnostics_;
  std::vector<StimulusEvent> events_;
  std::uint64_t count_ = 0;  // of *N; 0 if the line has none
};

}  // namespace

std::span<const StimulusEvent> Stimulus::events(std::uint64_t scan) const {
  const auto found =
      std::lower_bound(lines_.begin(), lines_.end(), scan,
                       [](const Line& line, std::uint64_t wanted) { return line.first < wanted; });
  if (found == lines_.end() || found->first != scan) return {};
  return found->events;
}

void Stimulus::append(std::vector<StimulusEvent> events, std::uint64_t count) {
  if (!events.empty()) lines_.push_back({scans_, std::move(events)});
  scans_ += count;
}

std::optional<Stimulus> parse_stimulus(const SourceText& source, const DeviceNames& names,
                                       Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  Stimulus stimulus;
  LineReader reader(source.file, names, diagnostics);
  for (std::size_t n = 0; n < source.lines.size(); ++n) {
    const std::u32string_view line = source.lines[n];
    std::size_t i = 0;
    while ((i = line.find_first_not_of(U" \t", i)) != std::u32string_view::npos) {
      const std::size_t end = std::min(line.find_first_of(U" \t", i), line.size());
      reader.token(to_utf8(line.substr(i, end - i)),
                   {static_cast<int>(n) + 1, static_cast<int>(i) + 1});
      i = end;
    }
    reader.finish(stimulus);
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return stimulus;
}

std::optional<Stimulus> stimulus_of(const Trace& trace, const DeviceNames& names,
                                    const std::string& file, Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  Stimulus stimulus;
  for (const TraceScan& scan : trace.scans) {
    const SourcePosition position{scan.line, 1};
    if (!scan.rx.empty() && !names.own()) {
      diagnostics.error(file, position, "it gives received bytes (RX), which a list does not read");
    }
    std::vector<StimulusEvent> events;
    for (const int byte : scan.rx) {
      events.push_back({port::uart_rx_data, static_cast<std::int16_t>(byte)});
    }
    for (const TraceValue& each : scan.in) {
      CheckedDevice device = names.own() ? check_trace_device(each.device, names)
                                         : check_list_device(each.device, names.dialect());
      CheckedEvent checked =
          check_event(std::move(device), each.device, fmt::to_string(each.value));
      if (checked.event) {
        events.push_back(*checked.event);
      } else {
        diagnostics.error(file, position, std::move(checked.what), std::move(checked.mend));
      }
    }
    stimulus.append(std::move(events));
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return stimulus;
}

}  // namespace rung
