// SPDX-License-Identifier: Apache-2.0
#include "view/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>

namespace rung::view {
namespace {

constexpr std::int64_t kScans = 20'000;

// Printable characters count upwards.
std::string vcd_code(std::size_t number) {
  constexpr std::size_t kFirst = 33, kCodes = 94;
  std::string code;
  do {
    code += static_cast<char>(kFirst + number % kCodes);
    number /= kCodes;
  } while (number != 0);
  return code;
}

std::string vcd_value(bool word, std::int16_t value, const std::string& code) {
  if (!word) return fmt::format("{}{}\n", value != 0 ? 1 : 0, code);
  return fmt::format("b{} {}\n", std::bitset<16>(static_cast<std::uint16_t>(value)).to_string(),
                     code);
}

// A name that viewers take: no blanks, nothing that they read as a range.
std::string vcd_name(std::string name) {
  for (char& c : name) {
    if (c == ' ' || c == ':' || c == '[' || c == ']' || c == '.') c = '_';
  }
  return name;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace

void History::add(std::int64_t scan, int device, std::int16_t value) {
  std::deque<Change>& changes = changes_.at(static_cast<std::size_t>(device));
  if (value == (changes.empty() ? 0 : changes.back().value)) return;
  changes.push_back({scan, value});
  while (changes.size() > 1 && changes[1].scan <= first_) changes.pop_front();
}

void History::end_scan(std::int64_t scan) {
  last_ = scan;
  first_ = std::max(first_, last_ - kScans + 1);
}

std::vector<History::Change> History::of(int device, std::int64_t from) const {
  from = std::max(from, first_);
  const std::deque<Change>& all = changes_.at(static_cast<std::size_t>(device));
  const auto next =
      std::upper_bound(all.begin(), all.end(), from,
                       [](std::int64_t scan, const Change& change) { return scan < change.scan; });
  std::vector<Change> changes{
      {from, next == all.begin() ? std::int16_t{0} : std::prev(next)->value}};
  changes.insert(changes.end(), next, all.end());
  return changes;
}

std::string to_vcd(const History& history, const ProgramView& view, const std::vector<int>& devices,
                   std::int64_t tick_us) {
  std::string text = fmt::format(
      "$comment {} , a scan every {} us $end\n$timescale 1us $end\n$scope module rung $end\n",
      vcd_name(view.program().file), tick_us);
  struct Event {
    std::int64_t scan;
    std::size_t which;
    std::int16_t value;
  };
  std::vector<Event> events;
  std::string start;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceView& device = view.devices().at(static_cast<std::size_t>(devices[i]));
    const bool word = is_word(device.device);
    text += fmt::format("$var {} {} {} {} $end\n", word ? "integer" : "wire", word ? 16 : 1,
                        vcd_code(i), vcd_name(device.name));
    const auto changes = history.of(devices[i]);
    start += vcd_value(word, changes.front().value, vcd_code(i));
    for (std::size_t k = 1; k < changes.size(); ++k) {
      events.push_back({changes[k].scan, i, changes[k].value});
    }
  }
  text += "$upscope $end\n$enddefinitions $end\n";
  text += fmt::format("#{}\n$dumpvars\n{}$end\n", history.first() * tick_us, start);
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.scan < b.scan; });
  std::int64_t now = history.first();
  for (const Event& event : events) {
    if (event.scan != now) text += fmt::format("#{}\n", event.scan * tick_us);
    now = event.scan;
    const DeviceView& device = view.devices()[static_cast<std::size_t>(devices[event.which])];
    text += vcd_value(is_word(device.device), event.value, vcd_code(event.which));
  }
  return text + fmt::format("#{}\n", (history.last() + 1) * tick_us);
}

std::string to_csv(const History& history, const ProgramView& view, const std::vector<int>& devices,
                   std::int64_t tick_us) {
  std::string text = "scan,ms";
  std::vector<std::vector<History::Change>> columns;
  for (const int device : devices) {
    text += "," + csv_cell(view.devices().at(static_cast<std::size_t>(device)).name);
    columns.push_back(history.of(device));
  }
  text += '\n';
  std::vector<std::size_t> at(columns.size(), 0);
  for (std::int64_t scan = history.first(); scan <= history.last(); ++scan) {
    text += fmt::format("{},{}", scan, static_cast<double>(scan * tick_us) / 1000);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      while (at[i] + 1 < columns[i].size() && columns[i][at[i] + 1].scan <= scan) ++at[i];
      text += fmt::format(",{}", columns[i][at[i]].value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace rung::view
