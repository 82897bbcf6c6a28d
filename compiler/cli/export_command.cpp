// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/bound.hpp"
#include "io/modbus_map.hpp"
#include "load/load_file.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string out = "\"";
  for (const char c : field) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

const char* type_of(Device device, Dialect dialect) {
  if (!is_word(device)) return "bit";
  return device.kind == DeviceKind::CN && is_32_bit_counter(device, dialect) ? "int32" : "int16";
}

// A row a device; a 32-bit counter's words are one, the low word first.
std::string symbols(const io::Subject& subject, int& without) {
  std::string text = "name,comment,device,table,address,type\n";
  for (const io::SubjectDevice& each : subject.devices) {
    if (is_port(each.device.kind) || each.device.kind == DeviceKind::CNH) continue;
    const auto point = io::point_of(each.device, subject.dialect, subject.config);
    if (!point) ++without;
    text += fmt::format(
        "{},{},{},{},{},{}\n", quoted(each.name), quoted(each.comment),
        device_name(each.device, subject.dialect), point ? io::table_name(point->table) : "none",
        point ? std::to_string(point->address) : "", type_of(each.device, subject.dialect));
  }
  return text;
}

}  // namespace

int export_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  const auto map = read_io(options, diagnostics);
  const auto input = read_input(options, true, std::nullopt, diagnostics);
  if (!input) return report(diagnostics);
  check_io(*input, map, options, diagnostics);
  if (diagnostics.has_errors()) return report(diagnostics);
  const io::Subject subject = subject_of(*input, options);
  int without = 0;
  const std::string text = symbols(subject, without);
  if (without > 0) {
    diagnostics.warning(options.program, {},
                        fmt::format("devices of the program without a Modbus address on a "
                                    "controller of configuration {}: {}",
                                    subject.config, without),
                        "let the program copy them to devices that have one: hdl/isa/configs.toml");
  }
  write_file(options.symbols, text, diagnostics);
  return report(diagnostics);
}

}  // namespace rung::cli
