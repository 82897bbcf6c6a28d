// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/map.hpp"
#include "io/toml_fields.hpp"
#include "rung_controller.hpp"
#include "source/nearest.hpp"
#include "source/text_file.hpp"

namespace rung::io {
namespace {

using Pins = std::vector<std::string_view>;

// Periods and watchdogs are counted in clocks of 32 bits: 100 s are that at 42 MHz.
constexpr std::int64_t kMostUs = 100'000'000;
constexpr std::int64_t kMostFilterUs = 1'000'000;
constexpr int kMostFilter = 15;
constexpr int kMostTimeoutMs = 10'000;  // of a flow task's request

template <typename Value, typename Found>
void take(Value& value, const std::optional<Found>& found) {
  if (found) value = static_cast<Value>(*found);
}

class MapReader {
 public:
  MapReader(const toml::table& root, const std::string& file, Diagnostics& diagnostics)
      : root_(root), file_(file), diagnostics_(diagnostics) {}

  std::optional<Map> read() {
    const Fields root = fields(root_, "the map");
    root.only({"board", "controller", "modbus", "inputs", "outputs", "analog", "pwm", "uart",
               "latched", "flow"});
    map_.file = file_;
    if (!read_board(root)) return std::nullopt;
    if (const auto* table = root.table("controller")) read_controller(*table);
    if (const auto* table = root.table("modbus")) read_modbus(*table);
    each("inputs", [this](const toml::key& key, const toml::node& node) { read_input(key, node); });
    each("outputs",
         [this](const toml::key& key, const toml::node& node) { read_output(key, node); });
    each("analog",
         [this](const toml::key& key, const toml::node& node) { read_analog(key, node); });
    each("pwm", [this](const toml::key& key, const toml::node& node) { read_pwm(key, node); });
    if (const auto* table = root.table("uart")) read_uart(*table);
    if (const auto* table = root.table("latched")) read_latched(*table);
    if (const auto* table = root.table("flow")) read_flow(root, *table);
    return std::move(map_);
  }

 private:
  Fields fields(const toml::table& table, std::string where) {
    return {table, std::move(where), file_, diagnostics_};
  }
  void error(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(file_, position, std::move(what), std::move(mend));
  }

  // Of the table `name` each key, in the order of the file; toml++ has them in that of their names.
  template <typename Read>
  void each(std::string_view name, Read&& read) {
    const auto* table = fields(root_, "the map").table(name);
    if (table == nullptr) return;
    std::map<std::pair<int, int>, std::pair<const toml::key*, const toml::node*>> in_order;
    for (const auto& [key, node] : *table) {
      const SourcePosition at = position_of(key.source());
      in_order[{at.line, at.column}] = {&key, &node};
    }
    for (const auto& [at, entry] : in_order) read(*entry.first, *entry.second);
  }

  bool read_board(const Fields& root) {
    std::vector<std::string_view> names;
    for (const controller::Board& board : controller::boards()) names.push_back(board.name);
    const std::string all = fmt::format("the boards are {}", fmt::join(names, ", "));
    if (!root.has("board")) {
      error({}, "the map does not say which board it is for",
            "write in its first line: board = \"simulated\"; " + all);
      return false;
    }
    const auto name = root.text("board");
    if (!name) return false;
    map_.board = find_board(*name);
    if (map_.board != nullptr) return true;
    const std::string_view near = nearest(*name, names);
    root.error("board", fmt::format("there is no board {}", shown(*name)),
               near.empty() ? all : fmt::format("did you mean {}? {}", near, all));
    return false;
  }

  void read_controller(const toml::table& table) {
    const Fields in = fields(table, "[controller]");
    in.only({"period_ms", "watchdog_ms", "exchange_points", "save_seconds", "stop_on_bad_download",
             "stop_after_power_up", "filter_us"});
    Settings& settings = map_.settings;
    map_.has_period = in.has("period_ms");
    map_.period_position = in.position("period_ms");
    map_.watchdog_position = in.position("watchdog_ms");
    take(settings.period_us, in.milliseconds("period_ms", kMostUs));
    take(settings.watchdog_us, in.milliseconds("watchdog_ms", kMostUs));
    take(settings.exchange_points, in.integer("exchange_points", 16, 2000));
    take(settings.save_seconds, in.integer("save_seconds", 0, 65535));
    take(settings.stop_on_bad_download, in.flag("stop_on_bad_download"));
    take(settings.stop_after_power_up, in.flag("stop_after_power_up"));
    take(settings.filter_us, in.integer("filter_us", 1, kMostFilterUs));
  }

  void read_modbus(const toml::table& table) {
    const Fields in = fields(table, "[modbus]");
    in.only({"unit", "baud", "parity"});
    take(map_.settings.unit, in.integer("unit", 1, 247));
    take(map_.settings.baud, in.integer("baud", 9600, 921600));
    read_parity(in, "parity", map_.settings.parity);
  }

  static void read_parity(const Fields& in, std::string_view key, Parity& parity) {
    const auto name = in.text(key);
    if (!name) return;
    static const std::map<std::string_view, Parity> kParities = {
        {"none", Parity::None}, {"odd", Parity::Odd}, {"even", Parity::Even}};
    const auto found = kParities.find(*name);
    if (found != kParities.end()) {
      parity = found->second;
    } else {
      in.error(key, fmt::format("{} is no parity", shown(*name)), "write none, odd or even");
    }
  }

  void read_flow(const Fields& root, const toml::table& table) {
    const Fields in = fields(table, "[flow]");
    in.only({"suspend", "link_timeout_ms", "panel_timeout_ms", "panel_unit", "panel_baud",
             "panel_parity"});
    map_.flow_position = root.position("flow");
    if (in.has("suspend")) map_.suspend_position = in.position("suspend");
    FlowSettings& settings = map_.settings.flow;
    take(settings.suspension, in.flag("suspend"));
    take(settings.link_timeout_ms, in.integer("link_timeout_ms", 1, kMostTimeoutMs));
    take(settings.panel_timeout_ms, in.integer("panel_timeout_ms", 1, kMostTimeoutMs));
    take(settings.panel_unit, in.integer("panel_unit", 1, 247));
    take(settings.panel_baud, in.integer("panel_baud", 9600, 921600));
    read_parity(in, "panel_parity", settings.panel_parity);
  }

  // The number of a pin by its name; `others` are pins that would be the wrong kind.
  std::optional<int> pin_of(const std::string& name, SourcePosition position, const Pins& pins,
                            std::string_view what, const Pins& others,
                            std::string_view other_what) {
    const auto found = std::find(pins.begin(), pins.end(), name);
    if (found == pins.end()) {
      const std::string head =
          fmt::format("{}: board {} has no {} of this name", shown(name), map_.board->name, what);
      if (std::find(others.begin(), others.end(), name) != others.end()) {
        error(position,
              fmt::format("{}: this is no {} of board {} but one of its {}s", name, what,
                          map_.board->name, other_what),
              list_of(pins, what));
        return std::nullopt;
      }
      const std::string_view near = nearest(name, pins);
      error(position, head,
            near.empty() ? list_of(pins, what)
                         : fmt::format("did you mean {}? {}", near, list_of(pins, what)));
      return std::nullopt;
    }
    const auto [first, is_new] = used_.try_emplace(name, position);
    if (!is_new) {
      error(position,
            fmt::format("{}: the pin is used in line {} already", name, first->second.line),
            "give one of the two another pin");
      return std::nullopt;
    }
    return static_cast<int>(found - pins.begin());
  }

  static std::string list_of(const Pins& pins, std::string_view what) {
    if (pins.empty()) return fmt::format("it has no {} at all: take the line out", what);
    return fmt::format("it has: {}", fmt::join(pins, ", "));
  }

  // `NAME = "pin"` or `NAME = { pin = "pin", ... }`: the pin's name, and the table if it is one.
  struct Value {
    std::string name;
    SourcePosition position;  // of `name`
    const toml::table* table = nullptr;
  };
  std::optional<Value> value_of(const toml::key& key, const toml::node& node,
                                std::string_view field) {
    if (const auto* text = node.as_string()) {
      return Value{text->get(), position_of(node.source()), nullptr};
    }
    const auto* table = node.as_table();
    const toml::node* pin = table != nullptr ? table->get(field) : nullptr;
    if (pin == nullptr || !pin->is_string()) {
      error(position_of(key.source()),
            fmt::format("{}: this does not say which {}", shown(key.str()), field),
            fmt::format("write {} = \"NAME\" or {} = {{ {} = \"NAME\", ... }}", key.str(),
                        key.str(), field));
      return std::nullopt;
    }
    return Value{pin->as_string()->get(), position_of(pin->source()), table};
  }

  static Line line_of(const toml::key& key) {
    return {std::string(key.str()), position_of(key.source())};
  }

  void read_input(const toml::key& key, const toml::node& node) {
    const auto value = value_of(key, node, "pin");
    if (!value) return;
    InputLine line{line_of(key)};
    if (value->table != nullptr) {
      const Fields in = fields(*value->table, line.name);
      in.only({"pin", "filter", "invert"});
      take(line.filter, in.integer("filter", 0, kMostFilter));
      take(line.invert, in.flag("invert"));
    }
    const auto pin = pin_of(value->name, value->position, map_.board->inputs, "input pin",
                            map_.board->outputs, "output pin");
    line.pin = pin.value_or(kNoPin);
    map_.inputs.push_back(std::move(line));
  }

  void read_output(const toml::key& key, const toml::node& node) {
    const auto value = value_of(key, node, "pin");
    if (!value) return;
    OutputLine line{line_of(key)};
    if (value->table != nullptr) {
      const Fields in = fields(*value->table, line.name);
      in.only({"pin", "safe", "invert"});
      read_safe(in, line.safe);
      take(line.invert, in.flag("invert"));
    }
    const auto pin = pin_of(value->name, value->position, map_.board->outputs, "output pin",
                            map_.board->inputs, "input pin");
    line.pin = pin.value_or(kNoPin);
    map_.outputs.push_back(std::move(line));
  }

  static void read_safe(const Fields& in, Safe& safe) {
    const toml::node* node = in.node("safe");
    if (node == nullptr) return;
    if (node->value<std::int64_t>() == 0 && node->is_integer()) {
      safe = Safe::Low;
    } else if (node->value<std::int64_t>() == 1 && node->is_integer()) {
      safe = Safe::High;
    } else if (node->value<std::string_view>() == "hold") {
      safe = Safe::Hold;
    } else {
      in.error("safe", "this is no state of an output", "write 0, 1 or \"hold\"");
    }
  }

  void read_analog(const toml::key& key, const toml::node& node) {
    const auto value = value_of(key, node, "channel");
    if (!value) return;
    if (value->table != nullptr) fields(*value->table, std::string(key.str())).only({"channel"});
    for (int channel = 0; channel < map_.board->adc; ++channel) {
      if (value->name != fmt::format("adc{}", channel)) continue;
      map_.analog.push_back({line_of(key), channel});
      return;
    }
    error(value->position,
          fmt::format("{}: board {} has no such analogue channel", shown(value->name),
                      map_.board->name),
          map_.board->adc == 0 ? "it has none: take the line out"
                               : fmt::format("it has adc0 to adc{}", map_.board->adc - 1));
  }

  void read_pwm(const toml::key& key, const toml::node& node) {
    const auto value = value_of(key, node, "pin");
    if (!value) return;
    PwmLine line{line_of(key)};
    if (value->table != nullptr) {
      const Fields in = fields(*value->table, line.name);
      in.only({"pin", "hz"});
      take(line.hz, in.integer("hz", 1, 1'000'000));
    }
    const auto pin = pin_of(value->name, value->position, map_.board->pwm, "PWM output",
                            map_.board->outputs, "plain output pin");
    line.pin = pin.value_or(kNoPin);
    map_.pwm.push_back(std::move(line));
  }

  void read_uart(const toml::table& table) {
    const Fields in = fields(table, "[uart]");
    in.only({"ladder"});
    const auto name = in.text("ladder");
    if (!name) return;
    const SourcePosition position = position_of(in.node("ladder")->source());
    if (!pin_of(*name, position, map_.board->uart, "UART", map_.board->outputs, "output pin")) {
      return;
    }
    map_.uart = Line{*name, in.position("ladder")};
  }

  void read_latched(const toml::table& table) {
    const Fields in = fields(table, "[latched]");
    in.only({"devices"});
    const toml::node* node = in.node("devices");
    if (node == nullptr) return;
    const auto* array = node->as_array();
    if (array == nullptr) {
      return in.error("devices", "this is no list",
                      "write [\"M100-M199\", \"D5\"], or [] for none");
    }
    map_.latched.emplace();
    for (const toml::node& each : *array) {
      if (const auto* text = each.as_string()) {
        map_.latched->push_back({text->get(), position_of(each.source())});
      } else {
        error(position_of(each.source()), "this is no device or range of devices",
              "write \"M100-M199\" or \"D5\"");
      }
    }
  }

  const toml::table& root_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  Map map_;
  std::map<std::string, SourcePosition> used_;  // pins
};

}  // namespace

const controller::Board* find_board(std::string_view name) {
  for (const controller::Board& board : controller::boards()) {
    if (board.name == name) return &board;
  }
  return nullptr;
}

std::optional<Map> parse_map(std::string_view text, const std::string& file,
                             Diagnostics& diagnostics) {
  try {
    const toml::table root = toml::parse(text, std::string_view(file));
    return MapReader(root, file, diagnostics).read();
  } catch (const toml::parse_error& problem) {
    diagnostics.error(file, position_of(problem.source()),
                      fmt::format("this is no TOML: {}", problem.description()),
                      "the format is on compiler/io/README.md");
    return std::nullopt;
  }
}

}  // namespace rung::io
