// SPDX-License-Identifier: Apache-2.0
#include "io/bind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "rung_controller.hpp"
#include "source/text_file.hpp"

namespace rung::io {
namespace {

constexpr std::int64_t kDefaultPwmHz = 1000;

class Binder {
 public:
  Binder(const Map& map, const Subject& subject, Diagnostics& diagnostics)
      : map_(map),
        subject_(subject),
        diagnostics_(diagnostics),
        file_(map.file.empty() ? subject.file : map.file) {}

  Bindings run() {
    out_.board = map_.board;
    out_.settings = map_.settings;
    if (!map_.has_period && subject_.cycle_us > 0) out_.settings.period_us = subject_.cycle_us;
    check_target();
    for (const InputLine& line : map_.inputs) input(line);
    for (const OutputLine& line : map_.outputs) output(line);
    for (const AnalogLine& line : map_.analog) analog(line);
    for (const PwmLine& line : map_.pwm) pwm(line);
    check_channels();
    check_ports();
    check_outputs();
    check_flow();
    out_.latched =
        map_.latched ? latched_of(map_, subject_, diagnostics_) : latched_by_default(subject_);
    return std::move(out_);
  }

 private:
  void error(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(file_, position, std::move(what), std::move(mend));
  }
  void warn(SourcePosition position, std::string what, std::string mend = {}) {
    diagnostics_.warning(file_, position, std::move(what), std::move(mend));
  }
  bool ldmicro() const { return subject_.dialect == Dialect::Ldmicro; }

  void check_target() {
    const controller::Board& board = *map_.board;
    if (subject_.config != board.config) {
      error({},
            fmt::format("board {} has configuration {}; the program is compiled for {}", board.name,
                        board.config, subject_.config),
            fmt::format("compile it with --config {}, or name another board", board.config));
    }
    if (subject_.mpu != 0 && subject_.mpu != board.mpu) {
      error({},
            fmt::format("board {} has MPU{}; the program is compiled for MPU{}", board.name,
                        board.mpu, subject_.mpu),
            fmt::format("compile it with --mpu {}, or name another board", board.mpu));
    }
    if (subject_.own_pins && !map_.file.empty()) {
      diagnostics_.note(subject_.file, {},
                        "pin numbers in the program's IO LIST are those of a micro-controller and "
                        "mean nothing here; the I/O map alone counts");
    }
  }

  // The device that a line binds; nothing with a message. `kind` is what it has to be.
  std::optional<Device> device_of(const Line& line, bool word) {
    const auto device = subject_.find(line.name, word);
    if (!device) {
      const std::string near = subject_.near(line.name);
      error(
          line.position,
          fmt::format("{}: this is neither a device of dialect {} nor a name that the program has",
                      shown(line.name), dialect_name(subject_.dialect)),
          near.empty() ? "write a device such as X0, or a name from --comments or the program"
                       : fmt::format("did you mean {}?", near));
      return std::nullopt;
    }
    const auto [first, is_new] = bound_.try_emplace(*device, line);
    if (!is_new) {
      error(line.position,
            fmt::format("{}: this device is bound in line {} already{}", shown(line.name),
                        first->second.position.line,
                        first->second.name == line.name ? "" : " as " + first->second.name),
            "take one of the two lines out");
      return std::nullopt;
    }
    return device;
  }

  // A cabinet is wired once, and not every program uses all of it.
  bool is_used(const Line& line, Device device, std::string_view what) {
    if (subject_.has(device)) return true;
    warn(line.position,
         fmt::format("{}: the program does not name this device; {}", shown(line.name), what));
    return false;
  }

  void input(const InputLine& line) {
    const auto device = device_of(line, false);
    if (!device) return;
    if (device->kind != DeviceKind::X) {
      error(line.position,
            fmt::format("{}: {} cannot be bound to an input pin", shown(line.name),
                        device->kind == DeviceKind::Y ? "an output" : "what is no input (X)"),
            device->kind == DeviceKind::Y ? "put the line under [outputs]" : "bind an X device");
      return;
    }
    if (!is_used(line, *device, "the pin is not read")) return;
    out_.inputs.push_back({*device, line.pin, line.filter, line.invert});
  }

  void output(const OutputLine& line) {
    const auto device = device_of(line, false);
    if (!device) return;
    if (device->kind != DeviceKind::Y) {
      error(line.position,
            fmt::format("{}: {} cannot be bound to an output pin", shown(line.name),
                        device->kind == DeviceKind::X ? "an input" : "what is no output (Y)"),
            device->kind == DeviceKind::X ? "put the line under [inputs]" : "bind a Y device");
      return;
    }
    if (!is_used(line, *device, "the pin stays at its safe level")) return;
    out_.outputs.push_back({*device, line.pin, line.safe, line.invert});
  }

  void analog(const AnalogLine& line) {
    if (ldmicro()) {
      const auto channel = subject_.find_channel(line.name);
      if (!channel) {
        const std::string near = subject_.near(line.name);
        error(line.position,
              fmt::format("{}: the program has no READ ADC into this variable", shown(line.name)),
              near.empty() || near == line.name
                  ? "take the line out, or name a variable that it has"
                  : fmt::format("did you mean {}?", near));
        return;
      }
      out_.analog.push_back({*channel, line.channel});
      return;
    }
    const auto device = device_of(line, true);
    if (!device) return;
    if (!is_plain_word(line, *device)) return;
    if (!is_used(line, *device, "the channel is not read")) return;
    out_.analog.push_back({*device, line.channel});
  }

  bool is_plain_word(const Line& line, Device device) {
    if (device.kind == DeviceKind::D || device.kind == DeviceKind::W ||
        device.kind == DeviceKind::R) {
      return true;
    }
    error(line.position,
          fmt::format("{}: this is no word that a channel can have", shown(line.name)),
          "bind a D, W or R device");
    return false;
  }

  void pwm(const PwmLine& line) {
    if (ldmicro()) {
      if (!subject_.pwm || line.name != "SET_PWM") {
        error(line.position,
              subject_.pwm ? fmt::format("{}: an LDmicro program drives PWM with SET PWM alone",
                                         shown(line.name))
                           : std::string("the program has no SET PWM"),
              subject_.pwm ? "write SET_PWM = \"PIN\"" : "take the line out");
      } else if (line.hz != 0) {
        error(line.position, "SET_PWM: its frequency is in the program", "take out hz");
      }
      return;
    }
    const auto device = device_of(line, true);
    if (!device || !is_plain_word(line, *device)) return;
    if (!is_used(line, *device, "the output is off")) return;
    if (out_.pwm) {
      error(line.position, fmt::format("{}: the board has one PWM output", shown(line.name)),
            "take one of the lines out");
      return;
    }
    out_.pwm = Bindings::Pwm{*device, line.pin, line.hz == 0 ? kDefaultPwmHz : line.hz};
  }

  // Every channel that an LDmicro program reads has to come from somewhere.
  void check_channels() {
    for (const SubjectDevice& each : subject_.devices) {
      if (!is_port(each.device.kind)) continue;
      const bool bound = std::any_of(out_.analog.begin(), out_.analog.end(),
                                     [&](const auto& line) { return line.device == each.device; });
      if (bound) continue;
      if (map_.board->adc == 0) {
        diagnostics_.warning(
            subject_.file, {},
            fmt::format("READ ADC of {}: board {} has no analogue channel; it reads 0", each.name,
                        map_.board->name));
      } else {
        error({},
              fmt::format("the program reads a channel into {}, which the map does not bind",
                          each.name),
              fmt::format("write under [analog]: {} = \"adc0\"", each.name));
      }
    }
  }

  void check_ports() {
    out_.ladder_uart = subject_.uart;
    out_.ladder_pwm = subject_.pwm;
    if (map_.uart && !subject_.uart) {
      warn(map_.uart->position,
           "ladder: the program has no UART instructions; the line stays idle");
    }
    if (subject_.uart && map_.board->uart.empty()) {
      error({}, fmt::format("board {} has no UART for the ladder", map_.board->name),
            "choose another board");
    }
    if (subject_.pwm && map_.board->pwm.empty()) {
      error({}, fmt::format("board {} has no PWM output", map_.board->name),
            "choose another board");
    }
  }

  // An output that nobody sees is more likely forgotten than meant.
  void check_outputs() {
    if (map_.file.empty()) return;
    std::vector<std::string> names;
    for (const SubjectDevice& each : subject_.devices) {
      if (each.device.kind == DeviceKind::Y && !bound_.contains(each.device)) {
        names.push_back(each.name);
      }
    }
    if (names.empty()) return;
    warn({}, fmt::format("outputs of the program without a pin: {}", fmt::join(names, ", ")),
         "bind them under [outputs], if they are to be seen");
  }

  void check_flow() {
    if (map_.flow_position && !subject_.flow) {
      warn(*map_.flow_position, "flow: the program has no flow tasks; these settings have no use",
           "take the table out, if no other program has this map");
    }
    if (subject_.flow && !map_.settings.flow.suspension) {
      warn(map_.suspend_position.value_or(SourcePosition{}),
           "suspend: steps wait for their data in their place, and all others with them; the time "
           "of these waits is in none of the bounds",
           "write suspend = true, unless this is what is to be seen");
    }
  }

  const Map& map_;
  const Subject& subject_;
  Diagnostics& diagnostics_;
  const std::string& file_;  // of messages: the program's for a map that was made up
  Bindings out_;
  std::map<Device, Line> bound_;
};

}  // namespace

Map default_map(const Subject& subject, Diagnostics& diagnostics) {
  Map map;
  map.board = find_board("simulated");
  const auto next = [&](const SubjectDevice& each, std::size_t used, std::size_t pins,
                        const char* what) {
    if (used < pins) return true;
    if (used == pins) {
      diagnostics.warning(
          subject.file, {},
          fmt::format("board simulated has {} {} pins: {} and what follows has none", pins, what,
                      each.name),
          "bind those that matter with --io");
    }
    return false;
  };
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  int channels = 0;
  for (const SubjectDevice& each : subject.devices) {
    const Line line{each.name, {}};
    if (each.device.kind == DeviceKind::X) {
      if (next(each, inputs, map.board->inputs.size(), "input")) {
        map.inputs.push_back({line, static_cast<int>(inputs), 0, false});
      }
      ++inputs;
    } else if (each.device.kind == DeviceKind::Y) {
      if (next(each, outputs, map.board->outputs.size(), "output")) {
        map.outputs.push_back({line, static_cast<int>(outputs), Safe::Low, false});
      }
      ++outputs;
    } else if (is_port(each.device.kind)) {
      map.analog.push_back({line, channels++});
    }
  }
  return map;
}

Bindings bind(const Map& map, const Subject& subject, Diagnostics& diagnostics) {
  return Binder(map, subject, diagnostics).run();
}

}  // namespace rung::io
