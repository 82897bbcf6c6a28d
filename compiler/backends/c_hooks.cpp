// SPDX-License-Identifier: Apache-2.0
#include "backends/c_hooks.hpp"

#include <algorithm>

#include "rungs/ports.hpp"

namespace rung {
namespace {

// Prefixed by what the device is, so that a bit and a variable of the same name differ.
std::string access_name(const CUnit& unit, Device device) {
  return fmt::format("{}_{}", is_word(device) ? "Word" : "Bit", unit.layout.name(device));
}

// Neither an input nor an output.
std::vector<Device> internal_devices(const CUnit& unit) {
  std::vector<Device> found;
  for (const Device device : unit.layout.devices()) {
    if (device.kind != DeviceKind::X && device.kind != DeviceKind::Y) found.push_back(device);
  }
  return found;
}

std::string pin_comment(const CUnit& unit, Device device) {
  if (!unit.program.ldmicro) return {};
  for (const LdmicroSettings::Pin& pin : unit.program.ldmicro->pins) {
    if (pin.name == unit.layout.name(device) && pin.pin != 0) {
      return fmt::format("  /* pin {} */", pin.pin);
    }
  }
  return {};
}

// Every channel is named after the variable that it is read into.
std::vector<Device> channels(const CUnit& unit) {
  std::vector<Device> found;
  for (const Device port : unit.layout.ports()) {
    if (port.kind == port::adc.kind && port.number >= port::adc.number &&
        port.number < port::adc.number + port::adc_count) {
      found.push_back(port);
    }
  }
  return found;
}

std::string channel_name(const CUnit& unit, Device channel) {
  return device_name(channel, unit.program);
}

int kept_values(const CUnit& unit) {
  return unit.layout.ports_from(port::persist_value, port::persist_value_count);
}

void peripheral_prototypes(const CUnit& unit, CSource& source) {
  const CLayout& layout = unit.layout;
  for (const Device channel : channels(unit)) {
    source.line("int16_t $Adc_{}(void);  /* a sample of analogue channel {} */",
                channel_name(unit, channel), channel.number - port::adc.number);
  }
  if (layout.has_port(port::uart_rx_full)) {
    source.line("int16_t $UartReceive(void);  /* the next byte received, 0 to 255; -1: none */");
  }
  if (layout.has_port(port::uart_tx_ready)) {
    source.line("uint8_t $UartReady(void);  /* 1: the transmitter takes a byte */");
    source.line("void $UartSend(uint8_t byte);  /* only when it is ready */");
  }
  if (layout.has_port(port::pwm_duty)) {
    source.line("/* The share of time that the PWM output is on: called when it changes. */");
    source.line("void $SetPwm(uint8_t percent, uint32_t hertz);");
  }
  if (layout.has_port(port::persist_ready)) {
    source.line("/* Memory that lasts without power: values 0 to {}, of which those never written",
                kept_values(unit) - 1);
    source.line(" * are what the memory has. */");
    source.line("uint8_t $PersistReady(void);  /* 1: it can be read and written */");
    source.line("int16_t $PersistRead(uint8_t number);");
    source.line("void $PersistWrite(uint8_t number, int16_t value);  /* may take its time */");
  }
}

}  // namespace

void write_hooks_manual(const CUnit& unit, CSource& source) {
  const std::int64_t cycle = unit.program.ldmicro ? unit.program.ldmicro->cycle_us : 10000;
  source.line(" *");
  source.line(" * Call $Cycle every {} microseconds, the program's CYCLE: its timers count cycles.",
              cycle);
  if (!unit.hooks()) {
    return source.code(
        R"( * Before it set inputs and device ports, after it see what became of outputs and ports. */)");
  }
  source.code(
      R"( * Write the functions under "Hooks", and no others: a cycle begins with those that read inputs
 * and peripherals, then executes the rungs, and ends with those that write outputs and
 * peripherals. Bits are 0 or 1. A file that includes this one can have them as static functions in
 * front of it.
 * $ReadBit_NAME, $WriteWord_NAME, ... give access to what is inside of the program, between
 * cycles; those that nothing calls are left out by gcc -ffunction-sections -Wl,--gc-sections. */)");
}

void write_hooks_prototypes(const CUnit& unit, CSource& source) {
  if (unit.hooks()) {
    source.line("/* Hooks */");
    for (const Device device : unit.layout.devices()) {
      if (device.kind == DeviceKind::X) {
        source.line("uint8_t $Input_{}(void);{}", unit.layout.name(device),
                    pin_comment(unit, device));
      } else if (device.kind == DeviceKind::Y) {
        source.line("void $Output_{}(uint8_t value);{}", unit.layout.name(device),
                    pin_comment(unit, device));
      }
    }
    peripheral_prototypes(unit, source);
    source.blank();
  }
  for (const Device device : internal_devices(unit)) {
    const std::string type = CLayout::type(device.kind);
    source.line("{} $Read{}(void);", type, access_name(unit, device));
    source.line("void $Write{}({} value);", access_name(unit, device), type);
  }
}

void write_named_variables(const CUnit& unit, CSource& source) {
  const CLayout& layout = unit.layout;
  for (const Device device : layout.devices()) {
    source.line("{} {};", CLayout::type(device.kind), layout.place(device).substr(2));
  }
  if (unit.strings > 0) {
    source.line("uint16_t string_step[{}]; /* of each FORMATTED_STRING: the next byte */",
                unit.strings);
    source.line("int16_t string_kept[{}]; /* digits to come */", unit.strings);
    source.line("uint8_t string_seen[{}]; /* a digit that is not 0 was sent */", unit.strings);
  }
  // Device ports: what peripherals and program tell each other.
  for (const Device port : layout.ports()) {
    const std::string place = layout.place(port).substr(2);
    if (place.find('[') == std::string::npos) {
      source.line("{} {};", CLayout::type(port.kind), place);
    }
  }
  const int adc = layout.ports_from(port::adc, port::adc_count);
  if (adc > 0) source.line("int16_t adc[{}];", adc);
  if (kept_values(unit) > 0) source.line("int16_t persist_value[{}];", kept_values(unit));
  if (layout.has_port(port::pwm_duty) && unit.hooks()) {
    source.line("uint8_t pwm_shown; /* per cent that the hook was given, and 1 */");
  }
}

void write_named_access(const CUnit& unit, CSource& source) {
  for (const Device device : internal_devices(unit)) {
    const std::string type = CLayout::type(device.kind);
    const std::string place = unit.layout.place(device);
    source.line("{} $Read{}(void) {{ return {}; }}", type, access_name(unit, device), place);
    source.line("void $Write{}({} value) {{ {} = {}; }}", access_name(unit, device), type, place,
                is_word(device) ? "value" : "value != 0");
  }
  source.blank();
}

void write_hooks_before(const CUnit& unit, CSource& source) {
  const CLayout& layout = unit.layout;
  for (const Device device : layout.devices()) {
    if (device.kind != DeviceKind::X) continue;
    source.line("{} = $Input_{}() != 0;", layout.place(device), layout.name(device));
  }
  for (const Device channel : channels(unit)) {
    source.line("{} = $Adc_{}();", layout.place(channel), channel_name(unit, channel));
  }
  if (layout.has_port(port::uart_rx_full)) {
    source.open("if (!@.uart_rx_full) {{");
    source.line("const int16_t byte = $UartReceive();");
    source.line("@.uart_rx_full = byte >= 0;");
    source.line("if (byte >= 0) @.uart_rx_data = (int16_t)(byte & 0xFF);");
    source.close();
  }
  if (layout.has_port(port::uart_tx_ready)) {
    source.line("tx_ready = $UartReady() != 0;");
    source.line("@.uart_tx_ready = (uint8_t)tx_ready;");
  }
  if (layout.has_port(port::persist_ready)) {
    source.line("persist_ready = $PersistReady() != 0;");
    source.line("@.persist_ready = (uint8_t)persist_ready;");
    source.open("if (persist_ready) {{");
    source.line("uint8_t i;");
    source.line("for (i = 0; i < {}; ++i) @.persist_value[i] = $PersistRead(i);",
                kept_values(unit));
    source.close();
  }
}

void write_hooks_after(const CUnit& unit, CSource& source) {
  const CLayout& layout = unit.layout;
  for (const Device device : layout.devices()) {
    if (device.kind != DeviceKind::Y) continue;
    source.line("$Output_{}({});", layout.name(device), layout.place(device));
  }
  if (layout.has_port(port::uart_tx_ready)) {
    source.line("if (tx_ready && !@.uart_tx_ready) $UartSend((uint8_t)@.uart_tx_data);");
  }
  if (layout.has_port(port::pwm_duty)) {
    source.open("if (@.pwm_hz_low != 0 || @.pwm_hz_high != 0) {{");
    source.line("const int16_t duty = @.pwm_duty;");
    source.line("const uint8_t percent = (uint8_t)(duty < 0 ? 0 : duty > 100 ? 100 : duty);");
    source.open("if (@.pwm_shown != percent + 1) {{");
    source.line("@.pwm_shown = (uint8_t)(percent + 1);");
    source.line("$SetPwm(percent, (uint32_t)(uint16_t)@.pwm_hz_high << 16 |");
    source.line("                 (uint16_t)@.pwm_hz_low);");
    source.close();
    source.close();
  }
  if (layout.has_port(port::persist_ready)) {
    source.open("if (persist_ready && !@.persist_ready) {{");
    source.line("const uint8_t number = (uint8_t)@.persist_index;");
    source.line("$PersistWrite(number, @.persist_value[number]);");
    source.close();
  }
}

}  // namespace rung
