// SPDX-License-Identifier: Apache-2.0
#include "melsec/comments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "melsec/csv.hpp"
#include "melsec/operands.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

std::string upper_case(const std::string& text) {
  std::string upper = text;
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

class CommentReader {
 public:
  CommentReader(const std::string& file, Dialect dialect, Diagnostics& diagnostics)
      : file_(file), dialect_(dialect), diagnostics_(diagnostics) {}

  void row(const CsvRow& row) {
    const std::string name = upper_case(row.text(0));
    const ParsedDevice parsed = parse_device(name, dialect_);
    if (parsed.error == DeviceError::Form && !looks_like_operand(name)) {
      // The title and the headers stand before the first device.
      if (!begun_) return;
      error(row.cells[0], fmt::format("{}: not a device", shown(row.cells[0].text)),
            "a row is a device and its comment");
      return;
    }
    begun_ = true;
    if (parsed.error == DeviceError::Digit) {
      error(row.cells[0],
            fmt::format("{}: its number has a digit that dialect {} does not use", shown(name),
                        dialect_name(dialect_)),
            "these may be the comments of another controller: use --dialect");
      return;
    }
    if (parsed.error != DeviceError::None || row.text(1).empty()) return;
    name_device(contact_of(parsed.device), row);
    if (const Device value = value_of(contact_of(parsed.device));
        value != contact_of(parsed.device)) {
      name_device(value, row);
    }
  }

  std::map<Device, std::string> take() { return std::move(comments_); }
  bool begun() const { return begun_; }

 private:
  void name_device(Device device, const CsvRow& row) {
    const auto [found, is_new] = comments_.try_emplace(device, row.text(1));
    if (is_new || found->second == row.text(1)) return;
    if (is_word(device) && device != contact_of(device)) return;  // said of its contact
    error(row.cells[0],
          fmt::format("{} has a comment already: {}", device_name(device, dialect_),
                      shown(found->second)),
          "remove one of the two");
  }

  void error(const CsvCell& cell, std::string what, std::string mend) {
    diagnostics_.error(file_, cell.position, std::move(what), std::move(mend));
  }

  const std::string& file_;
  Dialect dialect_;
  Diagnostics& diagnostics_;
  std::map<Device, std::string> comments_;
  bool begun_ = false;
};

}  // namespace

std::optional<std::map<Device, std::string>> parse_comments(const SourceText& source,
                                                            Dialect dialect,
                                                            Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  CommentReader reader(source.file, dialect, diagnostics);
  for (const CsvRow& row : read_csv(source, diagnostics)) reader.row(row);
  if (!reader.begun() && diagnostics.error_count() == errors_before) {
    diagnostics.error(source.file, {}, "there is no device comment in this file",
                      "a row is a device and its comment, separated by a tab or comma");
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return reader.take();
}

}  // namespace rung
