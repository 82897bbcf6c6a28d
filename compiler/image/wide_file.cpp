// SPDX-License-Identifier: Apache-2.0
#include "image/wide_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "image/flow_file.hpp"
#include "wide/code.hpp"

namespace rung::image {

using file::inside;
using file::require;
using nlohmann::json;

json wide_to_json(const WideImage& wide) {
  json out;
  out["slots"] = wide.slots;
  out["code"] = wide.code;
  out["origins"] = wide.origins;
  out["first_latch_row"] = wide.first_latch_row;
  out["latched"] = wide.latched;
  out["latch_rows"] = wide.latch_rows;
  out["merged"] = wide.merged;
  json writes = json::array();
  for (const WideWrite& each : wide.writes) {
    writes.push_back({each.step, each.lane, each.device, each.quiet ? 1 : 0});
  }
  out["writes"] = std::move(writes);
  json ports = json::array();
  for (const WidePort& each : wide.ports) {
    ports.push_back({static_cast<int>(each.device.kind), each.device.number, each.address});
  }
  out["ports"] = std::move(ports);
  const WideReport& r = wide.report;
  out["report"] = {r.look_ups,    r.words,    r.divisions,   r.captures,     r.near_values,
                   r.by_look_ups, r.by_words, r.by_dividers, r.by_dependence};
  out["binding"] = r.binding;
  return out;
}

WideImage wide_from_json(const json& in) {
  WideImage out;
  out.slots = in.at("slots").get<int>();
  out.code = in.at("code").get<std::vector<std::vector<std::vector<std::uint16_t>>>>();
  out.origins = in.at("origins").get<std::vector<std::vector<int>>>();
  out.first_latch_row = in.at("first_latch_row").get<int>();
  out.latched = in.at("latched").get<std::vector<int>>();
  out.latch_rows = in.at("latch_rows").get<int>();
  out.merged = in.at("merged").get<bool>();
  for (const json& each : in.at("writes")) {
    out.writes.push_back({each.at(0).get<int>(), each.at(1).get<int>(), each.at(2).get<int>(),
                          each.at(3).get<int>() != 0});
  }
  for (const json& each : in.at("ports")) {
    const int kind = each.at(0).get<int>();
    require(inside(kind, kDeviceKinds), "kind of a port");
    out.ports.push_back(
        {{static_cast<DeviceKind>(kind), each.at(1).get<std::uint32_t>()}, each.at(2).get<int>()});
  }
  const json& r = in.at("report");
  WideReport& report = out.report;
  int* const numbers[] = {&report.look_ups, &report.words,       &report.divisions,
                          &report.captures, &report.near_values, &report.by_look_ups,
                          &report.by_words, &report.by_dividers, &report.by_dependence};
  for (std::size_t i = 0; i < std::size(numbers); ++i) *numbers[i] = r.at(i).get<int>();
  report.binding = in.at("binding").get<std::string>();
  return out;
}

void check_wide(const Image& image) {
  const WideImage& wide = *image.wide;
  const wide::Machine* machine = wide::find_machine(wide.slots);
  require(machine != nullptr, "number of slots");
  const auto steps = static_cast<int>(wide.code.size());
  require(steps >= 1 && steps <= machine->steps && wide.origins.size() == wide.code.size(),
          "number of steps");
  wide::Step decoded;
  decoded.bits.resize(machine->slots);
  decoded.words.resize(machine->units);
  for (std::size_t step = 0; step < wide.code.size(); ++step) {
    require(static_cast<int>(wide.code[step].size()) == machine->slots, "slots of a step");
    require(wide.origins[step].size() == wide.code[step].size(), "origins of a step");
    for (int slot = 0; slot < machine->slots; ++slot) {
      require(wide::decode(wide.code[step][slot], slot, *machine, decoded), "instruction");
      const int origin = wide.origins[step][slot];
      require(origin >= -1 && origin < static_cast<int>(image.source.size()), "origin");
    }
  }
  require(wide.first_latch_row >= 0 && wide.latch_rows >= 0 &&
              wide.first_latch_row + wide.latch_rows <= machine->rows,
          "latch rows");
  require(static_cast<int>(wide.latched.size()) <= wide.latch_rows * machine->slots,
          "latched bits");
  require(image.clocks == steps + wide::constant::scan_fill +
                              std::max(0, wide.latch_rows - wide::constant::scan_latch_free),
          "clocks");
  const auto devices = static_cast<int>(image.devices.size());
  for (const int device : wide.latched) {
    require(inside(device, devices) && !is_word(image.devices[device].device), "latched device");
  }
  for (const WideWrite& each : wide.writes) {
    require(inside(each.device, devices) && inside(each.step, steps), "write");
    const bool word = is_word(image.devices[each.device].device);
    require(inside(each.lane, word ? machine->units : machine->slots), "lane of a write");
  }
  const auto fits = [&](Device device, int address) {
    return inside(address, is_word(device) ? machine->word_rows * machine->units
                                           : machine->rows * machine->slots);
  };
  for (const ImageDevice& each : image.devices) {
    require(fits(each.device, each.address), "device address");
  }
  for (const WidePort& each : wide.ports) require(fits(each.device, each.address), "port address");
  for (const ImageTicks& each : image.ticks) {
    require(inside(each.address, machine->word_rows * machine->units), "address of ticks");
    require(each.base_us > 0, "base of ticks");
  }
}

std::string wide_listing(const Image& image) {
  const WideImage& wide = *image.wide;
  const wide::Machine& machine = *wide::find_machine(wide.slots);
  std::string out = fmt::format("; {}: MPU4 with {} slots, {} steps, {} clocks a scan\n",
                                image.program, wide.slots, wide.code.size(), image.clocks);
  out += "; places: row.lane; near values: own-N, bus-N.lane; word instructions behind |\n";
  for (const ImageDevice& device : image.devices) {
    const int lanes = is_word(device.device) ? machine.units : machine.slots;
    out += fmt::format("; {} = {}.{}{}{}\n", device.name, device.address / lanes,
                       device.address % lanes, device.comment.empty() ? "" : ": ", device.comment);
  }
  wide::Step decoded;
  decoded.bits.resize(machine.slots);
  decoded.words.resize(machine.units);
  for (std::size_t step = 0; step < wide.code.size(); ++step) {
    for (int slot = 0; slot < machine.slots; ++slot) {
      wide::decode(wide.code[step][slot], slot, machine, decoded);
      std::string code;
      const wide::Chunks& chunks = wide.code[step][slot];
      for (auto chunk = chunks.rbegin(); chunk != chunks.rend(); ++chunk) {
        code += fmt::format("{:04x}", *chunk);
      }
      std::string line = slot == 0 ? fmt::format("{:5}", step) : std::string(5, ' ');
      line += fmt::format("  {:<28}  {:<64}", code, wide::disassemble(decoded, slot, machine));
      const int origin = wide.origins[step][slot];
      if (origin >= 0) {
        const SourceLine& source = image.source[static_cast<std::size_t>(origin)];
        line += fmt::format("; {}: {}", source.position.line, source.text);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + "\n";
    }
  }
  return out;
}

}  // namespace rung::image
