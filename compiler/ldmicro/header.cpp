// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ldmicro/numbers.hpp"
#include "ldmicro/symbols.hpp"

namespace rung {
namespace {

constexpr std::string_view kVersion = "LDmicro";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\f");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\f") - first + 1));
}

class HeaderReader {
 public:
  HeaderReader(LdLines& lines, const std::string& file, Diagnostics& diagnostics)
      : lines_(lines), file_(file), diagnostics_(diagnostics) {}

  LdHeader read() {
    read_version();
    while (!lines_.at_end()) {
      const LdLine& line = lines_.line();
      const std::string text = line.text();
      if (text == "PROGRAM") {
        lines_.advance();
        return std::move(header_);
      }
      if (text == "IO LIST") {
        read_list([this](const LdLine& entry) { read_pin(entry); });
      } else if (text == "VAR LIST") {
        read_list([this](const LdLine& entry) { read_size(entry); });
      } else if (text == "PULL-UP LIST") {
        // The board's, not the program's.
        read_list([](const LdLine&) {});
      } else {
        read_setting(line);
        lines_.advance();
      }
    }
    diagnostics_.error(file_, {}, "this is no LDmicro program: the line PROGRAM is not there",
                       "its rungs follow that line; if it was cut off, save it again");
    return std::move(header_);
  }

 private:
  void warn(SourcePosition position, std::string what, std::string mend = {}) {
    diagnostics_.warning(file_, position, std::move(what), std::move(mend));
  }
  void error(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(file_, position, std::move(what), std::move(mend));
  }

  void read_version() {
    if (lines_.at_end() || !lines_.line().keyword().starts_with(kVersion)) return;
    const std::string version = lines_.line().text().substr(kVersion.size());
    header_.extended = version != "0.1";
    if (!version.empty() && version != "0.1" && version != "0.2") {
      warn(lines_.line().position(),
           fmt::format("the format {} is not known; it is read as 0.2", shown(version)));
    }
    lines_.advance();
  }

  // Leaves the line behind its END, or the one that cannot stand in it.
  template <typename Read>
  void read_list(Read read_entry) {
    const SourcePosition position = lines_.line().position();
    const std::string head = lines_.line().text();
    for (lines_.advance(); !lines_.at_end(); lines_.advance()) {
      const std::string text = lines_.line().text();
      if (text == "END") return lines_.advance();
      if (text == "PROGRAM") break;
      read_entry(lines_.line());
    }
    error(position, head + ": its END is not there", "write END after its last line");
  }

  // `name at pin`, behind which 0.2 may have a Modbus address.
  void read_pin(const LdLine& line) {
    if (line.words.size() < 3 || line.words[1].text != "at" || !is_ld_name(line.keyword())) {
      return error(line.position(), fmt::format("{}: no line of an IO LIST", shown(line.raw)),
                   "write: name at pin; 0 is a pin that is not assigned yet");
    }
    const LdWord& pin = line.words[2];
    const LdNumber number = leading_number(pin.text);
    if (number.length == 0) {
      warn(pin.position, fmt::format("pin {}: a pin with a name, taken as one that is not assigned",
                                     shown(pin.text)));
    } else if (number.length != pin.text.size() || !number.fits || number.value < 0) {
      return error(pin.position, fmt::format("{} is no pin's number", shown(pin.text)),
                   "write the number of the pin, or 0");
    }
    for (std::size_t i = 3; i < line.words.size(); ++i) {
      if (line.words[i].text == "0") continue;
      warn(line.words[i].position,
           fmt::format("{}: an address on a bus is not followed", shown(line.words[i].text)));
      break;
    }
    const int assigned = static_cast<int>(number.value);
    if (assigned != 0) {
      const auto [first, is_new] = pins_.try_emplace(assigned, line.keyword());
      if (!is_new && first->second != line.keyword()) {
        warn(pin.position,
             fmt::format("pin {} is assigned to {} already", assigned, shown(first->second)),
             "give one of the two another pin, or 0");
      }
    }
    header_.settings.pins.push_back({line.keyword(), assigned});
  }

  // `2 bytes name` or `name signed 16 bit variable`.
  void read_size(const LdLine& line) {
    const auto& words = line.words;
    const auto size_of = [](const LdWord& word) {
      return static_cast<int>(std::clamp<std::int64_t>(leading_number(word.text).value, 0, 64));
    };
    if (words.size() >= 3 && words[1].text.starts_with("byte")) {
      add_size(words[2].text, 8 * size_of(words[0]), words[2].position);
    } else if (words.size() >= 4 && words[3].text.starts_with("bit")) {
      add_size(words[0].text, size_of(words[2]), words[0].position);
    } else {
      warn(line.position(), fmt::format("{}: no line of a VAR LIST; ignored", shown(line.raw)));
    }
  }
  void add_size(const std::string& name, int bits, SourcePosition position) {
    if (bits != 16) header_.odd_sizes.push_back({name, bits, position});
  }

  void read_setting(const LdLine& line) {
    const std::size_t sign = line.raw.find('=');
    const std::string key = sign == std::string::npos ? "" : line.raw.substr(0, sign);
    const std::string value = sign == std::string::npos ? "" : trimmed(line.raw.substr(sign + 1));
    LdmicroSettings& settings = header_.settings;
    if (key == "MICRO") {
      settings.micro = value;
    } else if (key == "COMPILED") {
      settings.compiled = value;
    } else if (key == "CYCLE") {
      settings.cycle_position = line.position();
      read_cycle(line, value);
    } else if (key == "CRYSTAL") {
      read_frequency(line, key, value, settings.crystal_hz);
    } else if (key == "BAUD") {
      settings.baud_position = line.position();
      read_frequency(line, key, value, settings.baud);
    } else if (key != "COMPILER" && key != "PROGRAMMER") {
      warn(line.position(),
           fmt::format("{}: not known before PROGRAM; ignored", shown(trimmed(line.raw))));
    }
  }

  void read_cycle(const LdLine& line, const std::string& value) {
    const LdNumber number = leading_number(value);
    if (number.length == 0 || number.value <= 0 || !number.fits) {
      return error(line.position(),
                   fmt::format("CYCLE={}: the time from scan to scan in "
                               "microseconds is 1 to 2147483647",
                               shown(value)),
                   "write CYCLE=10000 for 10 ms");
    }
    header_.settings.cycle_us = number.value;
    const std::size_t duty = value.find("YPlcCycleDuty:");
    if (duty != std::string::npos && value.substr(duty).find(":1") != std::string::npos) {
      warn(line.position(), "YPlcCycleDuty:1 is not followed: no output shows the scan's duration");
    }
  }

  // Some programs have 0 for what they do not use.
  void read_frequency(const LdLine& line, const std::string& key, const std::string& value,
                      std::int64_t& hz) {
    const LdNumber number = leading_number(value);
    if (number.length == 0 || number.value < 0 || !number.fits) {
      return error(line.position(),
                   fmt::format("{}={}: this is 1 to 2147483647", key, shown(value)),
                   fmt::format("write {}={}, or leave the line out", key, hz));
    }
    if (number.value == 0) {
      return warn(line.position(), fmt::format("{}=0: taken as {}", key, hz));
    }
    hz = number.value;
  }

  LdLines& lines_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  LdHeader header_;
  std::map<int, std::string> pins_;
};

}  // namespace

LdHeader read_ld_header(LdLines& lines, const std::string& file, Diagnostics& diagnostics) {
  return HeaderReader(lines, file, diagnostics).read();
}

}  // namespace rung
