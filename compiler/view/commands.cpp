// SPDX-License-Identifier: Apache-2.0
#include "view/commands.hpp"

#include <fmt/format.h>

#include <limits>

namespace rung::view {
namespace {

using nlohmann::json;

std::runtime_error bad(const std::string& what) { return std::runtime_error(what); }

int device_of(const Run& run, const json& command) {
  const auto device = command.at("device").get<std::int64_t>();
  if (device < 0 || device >= static_cast<std::int64_t>(run.values().size())) {
    throw bad("there is no such device");
  }
  return static_cast<int>(device);
}

std::int16_t value_of(const json& value) {
  const auto number = value.get<std::int64_t>();
  // 0x8000 and up mean the same bits.
  if (number < std::numeric_limits<std::int16_t>::min() || number > 0xFFFF) {
    throw bad(fmt::format("{} does not fit a word: -32768 to 32767, or 0 to 65535", number));
  }
  return static_cast<std::int16_t>(number);
}

// All numbers are whole, and not beyond what an integer holds.
void need_whole_numbers(const json& command) {
  for (const auto& [key, value] : command.items()) {
    const bool beyond =
        value.is_number_unsigned() &&
        value.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()};
    if (value.is_number_float() || beyond) throw bad(fmt::format("{} is no whole number", key));
  }
}

void set_mode(Run& run, const std::string& mode) {
  if (mode == "paused") return run.set_mode(Mode::Paused);
  if (mode == "real") return run.set_mode(Mode::RealTime);
  if (mode == "fast" && !run.engine().is_live()) return run.set_mode(Mode::Fast);
  throw bad(fmt::format("there is no mode {} here", mode));
}

void order(Run& run, const std::string& what) {
  if (!run.engine().is_live()) throw bad("only a controller takes orders");
  if (what == "run") return run.engine().order(Engine::Order::Run);
  if (what == "stop") return run.engine().order(Engine::Order::Stop);
  if (what == "scan") return run.engine().order(Engine::Order::Scan);
  throw bad(fmt::format("there is no order {}", what));
}

void set_breakpoint(Run& run, const json& command) {
  std::optional<Breakpoint> breakpoint;
  if (command.at("on").get<bool>()) {
    breakpoint.emplace();
    if (command.contains("value") && !command["value"].is_null()) {
      breakpoint->value = value_of(command["value"]);
    }
  }
  run.set_breakpoint(device_of(run, command), breakpoint);
}

}  // namespace

void obey(Run& run, const json& command) {
  constexpr int kMostSteps = 100'000;
  try {
    need_whole_numbers(command);
    const auto what = command.at("do").get<std::string>();
    if (what == "mode") {
      set_mode(run, command.at("mode").get<std::string>());
    } else if (what == "step") {
      const auto scans = command.value("scans", std::int64_t{1});
      if (scans < 1 || scans > kMostSteps) throw bad("1 to 100000 scans");
      run.step(static_cast<int>(scans));
    } else if (what == "set") {
      run.set(device_of(run, command), value_of(command.at("value")));
    } else if (what == "toggle") {
      const int device = device_of(run, command);
      run.set(device, run.values()[static_cast<std::size_t>(device)] == 0 ? 1 : 0);
    } else if (what == "force") {
      const json& value = command.at("value");
      run.force(device_of(run, command),
                value.is_null() ? std::nullopt : std::optional(value_of(value)));
    } else if (what == "release") {
      run.release_all();
    } else if (what == "break") {
      set_breakpoint(run, command);
    } else if (what == "restart") {
      run.restart(command.at("engine").get<std::string>());
    } else if (what == "order") {
      order(run, command.at("order").get<std::string>());
    } else {
      throw bad(fmt::format("there is no command {}", what));
    }
  } catch (const json::exception& error) {
    throw bad(fmt::format("this is no command: {}", error.what()));
  }
}

}  // namespace rung::view
