// SPDX-License-Identifier: Apache-2.0
#include "backends/c_interface.hpp"

#include <algorithm>

#include "backends/c_hooks.hpp"
#include "rungs/devices.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

// Kinds that have access functions: those of every program, and those that this one names.
std::vector<DeviceKind> access_kinds(const CUnit& unit) {
  std::vector<DeviceKind> kinds;
  if (unit.is_ldmicro()) return kinds;
  for (int i = 0; i < kDeviceKinds; ++i) {
    const auto kind = static_cast<DeviceKind>(i);
    const bool always = kind == DeviceKind::X || kind == DeviceKind::Y || kind == DeviceKind::M ||
                        kind == DeviceKind::D;
    const auto& devices = unit.layout.devices();
    if (always || std::any_of(devices.begin(), devices.end(),
                              [&](Device device) { return device.kind == kind; })) {
      kinds.push_back(kind);
    }
  }
  return kinds;
}

std::vector<Device> specials(const CUnit& unit, DeviceKind kind) {
  std::vector<Device> found;
  for (const Device device : unit.layout.devices()) {
    if (device.kind == kind && unit.layout.special(device)) found.push_back(device);
  }
  return found;
}

// The period of every clock that the program names.
std::vector<const SpecialRange*> clocks(const CUnit& unit) {
  std::vector<const SpecialRange*> found;
  for (const SpecialRange& range : special_ranges()) {
    if (range.dialect == unit.program.dialect && range.role == SpecialRole::Clock &&
        unit.layout.names({range.kind, range.first})) {
      found.push_back(&range);
    }
  }
  return found;
}

void head_comment(const CUnit& unit, CSource& source) {
  const Program& program = unit.program;
  source.comment(fmt::format("/* {}, dialect {}, as C99: {} {}, {} instructions.",
                             comment_text(program.file), dialect_name(program.dialect),
                             program.networks.size(), unit.is_ldmicro() ? "rungs" : "networks",
                             count(program).instructions));
  if (unit.options.bare) return source.comment(" */");
  if (unit.is_ldmicro()) return write_hooks_manual(unit, source);
  source.code(R"( *
 * Before a scan give the inputs with $WriteX, then call $Cycle, then read the outputs with
 * $ReadY: nothing is to be put out while it runs. Timers and clock relays go by the time between
 * the beginnings of two scans, which $Elapsed sets; where scans are not equally long, call it
 * before each.)");
  source.line(" * A device goes by its number: {}. Bits are 0 or 1.",
              program.dialect == Dialect::Q ? "Y10, which is hexadecimal, is 16"
                                            : "Y10, which is octal, is 8");
  source.code(R"( * T5 is bit 5 of TS, its contact, and word 5 of TN, its value; C5 of CS and CN.
 * Devices that the program does not name read 0, and writing them does nothing. */)");
}

void comments(const CUnit& unit, CSource& source) {
  bool first = true;
  for (const Device device : unit.layout.devices()) {
    const auto comment = unit.program.comments.find(device);
    if (comment == unit.program.comments.end()) continue;
    if (first) source.comment("/* Devices with a name:");
    first = false;
    source.comment(fmt::format(" *   {:7} {}", device_name(device, unit.program.dialect),
                               comment_text(comment->second)));
  }
  if (!first) source.comment(" */");
}

// In front of the access to special relays, which are no elements of an array.
void special_cases(const CUnit& unit, DeviceKind kind, bool reads, CSource& source) {
  const std::vector<Device> devices = specials(unit, kind);
  if (devices.empty()) return;
  source.open("switch (number) {{");
  for (const Device device : devices) {
    const std::string place = unit.layout.place(device);
    source.line("case {}u:", device.number);
    source.line("  {}", reads ? "return " + place + ";" : place + " = value != 0;");
    if (!reads) source.line("  return;");
  }
  source.line("default:");
  source.line("  break;");
  source.close();
}

void access_by_number(const CUnit& unit, DeviceKind kind, CSource& source) {
  const std::string array = CLayout::array(kind);
  const std::string type = CLayout::type(kind);
  const std::uint32_t size = unit.layout.size(kind);
  source.open("{} $Read{}(uint32_t number) {{", type, array);
  special_cases(unit, kind, true, source);
  if (size > 0) {
    source.line("return number < {}u ? @.{}[number] : 0;", size, array);
  } else {
    source.line("(void)number;");
    source.line("return 0;");
  }
  source.close();
  source.blank();
  source.open("void $Write{}(uint32_t number, {} value) {{", array, type);
  special_cases(unit, kind, false, source);
  if (size > 0) {
    source.line("if (number < {}u) @.{}[number] = {};", size, array,
                is_word(kind) ? "value" : "value != 0");
  } else {
    source.line("(void)number;");
    source.line("(void)value;");
  }
  source.close();
  source.blank();
}

// A row for each device that a name leads to.
void table_rows(const CUnit& unit, CSource& source) {
  const auto row = [&](const std::string& name, Device device) {
    const std::string place = "&" + unit.layout.place(device);
    source.line("{{\"{}\", {}, {}}},", name, is_word(device) ? "0" : place,
                is_word(device) ? place : "0");
  };
  for (const Device device : unit.layout.reachable()) {
    row(device_name(device, unit.program), device);
  }
  if (!unit.hooks()) {
    for (const Device port : unit.layout.ports()) {
      row(c_port_name(port), port);
    }
  }
  source.line("{{0, 0, 0}}");
}

void bare_table(const CUnit& unit, CSource& source) {
  source.code(R"(#ifndef PLC_HAS_device
#define PLC_HAS_device
struct plc_device {
  const char *name;
  uint8_t *bit;
  int16_t *word;
};
#endif)");
  source.open("static const struct plc_device $Devices[] = {{");
  table_rows(unit, source);
  source.close("};");
  source.blank();
}

void access_by_name(const CUnit& unit, CSource& source) {
  source.line("static const struct {{");
  source.line("  const char *name;");
  source.line("  uint8_t *bit;");
  source.line("  int16_t *word;");
  source.open("}} @_table[] = {{");
  table_rows(unit, source);
  source.close("};");
  source.code(R"(
/* The index of a name, or of the row after the last. */
static unsigned @_find(const char *device) {
  unsigned row = 0;
  for (; @_table[row].name; ++row) {
    const char *a = @_table[row].name, *b = device;
    while (*a && *a == *b) {
      ++a;
      ++b;
    }
    if (*a == *b) break;
  }
  return row;
}

long $Get(const char *device) {
  const unsigned row = @_find(device);
  if (@_table[row].bit) return *@_table[row].bit;
  return @_table[row].word ? *@_table[row].word : 0;
}

int $Set(const char *device, long value) {
  const unsigned row = @_find(device);
  if (@_table[row].bit) *@_table[row].bit = value != 0;
  if (@_table[row].word) {
    const uint32_t bits = (uint32_t)value & 0xFFFFu;
    *@_table[row].word = (int16_t)(bits < 0x8000u ? (int32_t)bits : (int32_t)bits - 0x10000);
  }
  return @_table[row].name != 0;
}
)");
}

void prototypes(const CUnit& unit, CSource& source) {
  source.line(
      "void $Reset(void);  /* as at the start: all devices 0, the next scan is the first */");
  source.line("void $Cycle(void);  /* one scan */");
  if (!unit.is_ldmicro())
    source.line(
        "void $Elapsed(uint32_t microseconds);  /* from scan to scan; 10000 unless told */");
  source.line("uint8_t $Error(void);  /* 1: the last cycle divided by zero; that wrote nothing */");
  if (unit.is_ldmicro()) write_hooks_prototypes(unit, source);
  for (const DeviceKind kind : access_kinds(unit)) {
    source.line("{} $Read{}(uint32_t number);", CLayout::type(kind), CLayout::array(kind));
    source.line("void $Write{}(uint32_t number, {} value);", CLayout::array(kind),
                CLayout::type(kind));
  }
  if (unit.options.table) {
    source.line("/* By its name: \"X10\", \"TN5\", \"CN200:h\". No device of the program: 0. */");
    source.line("long $Get(const char *device);");
    source.line("int $Set(const char *device, long value);");
  }
  source.blank();
}

void variables(const CUnit& unit, CSource& source) {
  comments(unit, source);
  source.open("static struct {{");
  if (!unit.is_ldmicro()) source.line("uint32_t elapsed;");
  if (unit.knows_first_scan()) {
    source.line("uint8_t running; /* a scan was executed since the reset */");
  }
  source.line("uint8_t divided; /* by zero, in this scan */");
  for (const DeviceKind kind : access_kinds(unit)) {
    const std::uint32_t size = unit.layout.size(kind);
    if (size > 0) source.line("{} {}[{}];", CLayout::type(kind), CLayout::array(kind), size);
    for (const Device device : specials(unit, kind)) {
      source.line("uint8_t {}{};", CLayout::array(kind), device.number);
    }
  }
  for (const DeviceKind kind : unit.stateful) {
    source.line("uint8_t {}_state[{}];", CLayout::array(kind), unit.layout.size(kind));
  }
  const auto& instructions = unit.program.instructions;
  if (std::any_of(instructions.begin(), instructions.end(),
                  [](const Instruction& each) { return each.op == Op::Stl; })) {
    source.line("uint8_t S_left[{}]; /* states that go off at their next STL */",
                unit.layout.size(DeviceKind::S));
  }
  if (!unit.edges.empty()) {
    source.line("uint8_t edge[{}]; /* what instructions found when they were executed last */",
                unit.edges.size());
  }
  for (const std::int64_t base : unit.tick_bases) {
    source.line("uint16_t {}; /* in this scan */", time_name("ticks", base));
    source.line("uint32_t {};", time_name("rest", base));
  }
  for (const SpecialRange* const clock : clocks(unit)) {
    source.line("uint32_t {};", time_name("clock", clock->period_us));
  }
  if (unit.is_ldmicro()) write_named_variables(unit, source);
  source.close(unit.is_ldmicro() ? "} @;" : "} @ = {.elapsed = 10000u};");
  source.blank();
}

}  // namespace

std::string time_name(std::string_view what, std::int64_t us) {
  return us % 1000 == 0 ? fmt::format("{}_{}ms", what, us / 1000)
                        : fmt::format("{}_{}us", what, us);
}

void write_declarations(const CUnit& unit, CSource& source) {
  head_comment(unit, source);
  source.line("#include <stdint.h>");
  source.blank();
  if (!unit.options.bare) prototypes(unit, source);
  variables(unit, source);
}

void write_accessors(const CUnit& unit, CSource& source) {
  const std::string_view linkage = unit.options.bare ? "static " : "";
  if (unit.options.bare) {
    bare_table(unit, source);
  } else {
    for (const DeviceKind kind : access_kinds(unit)) access_by_number(unit, kind, source);
    if (unit.is_ldmicro()) write_named_access(unit, source);
    if (unit.options.table) access_by_name(unit, source);
    source.line("uint8_t $Error(void) {{ return @.divided; }}\n");
  }
  const bool keeps_time = !unit.is_ldmicro();
  if (keeps_time) {
    source.line("{}void $Elapsed(uint32_t microseconds) {{ @.elapsed = microseconds; }}\n",
                linkage);
  }
  source.open("{}void $Reset(void) {{", linkage);
  source.code(R"(/* volatile: a compiler must not make this loop a call of a library's memset. */
volatile unsigned char *const byte = (volatile unsigned char *)&@;)");
  if (keeps_time) source.line("const uint32_t elapsed = @.elapsed;");
  source.line("uint32_t i;");
  source.line("for (i = 0; i < sizeof @; ++i) byte[i] = 0;");
  if (keeps_time) source.line("@.elapsed = elapsed;");
  source.close();
  source.blank();
}

void write_scan_start(CUnit& unit) {
  CSource& source = unit.body;
  const Dialect dialect = unit.program.dialect;
  if (unit.hooks()) {
    if (unit.layout.has_port(port::uart_tx_ready)) source.line("unsigned tx_ready;");
    if (unit.layout.has_port(port::persist_ready)) source.line("unsigned persist_ready;");
  }
  source.line("@.divided = 0;");
  if (unit.hooks()) write_hooks_before(unit, source);
  for (const Device timer : unit.timers) {
    source.line("@.{}_state[{}] &= 1u;", CLayout::array(timer.kind), unit.layout.number(timer));
  }
  for (const Device device : unit.layout.devices()) {
    const SpecialRange* const special = find_special(device, dialect);
    if (special == nullptr || !is_driven(special->role)) continue;
    const std::string place = unit.layout.place(device);
    if (special->role == SpecialRole::On) source.line("{} = 1;", place);
    if (special->role == SpecialRole::Off) source.line("{} = 0;", place);
    if (special->role == SpecialRole::FirstScan) source.line("{} = !@.running;", place);
    if (special->role == SpecialRole::NotFirstScan) source.line("{} = @.running;", place);
  }
  const std::vector<const SpecialRange*> named_clocks = clocks(unit);
  if (!named_clocks.empty() || !unit.tick_bases.empty()) {
    const std::string ticks = unit.helpers.use(CHelper::Ticks);
    source.open("if (@.running) {{");
    for (const std::int64_t base : unit.tick_bases) {
      source.line("@.{} = {}(@.elapsed, &@.{}, {}u);", time_name("ticks", base), ticks,
                  time_name("rest", base), base);
    }
    for (const SpecialRange* const clock : named_clocks) {
      source.line("{}(@.elapsed, &@.{}, {}u);", ticks, time_name("clock", clock->period_us),
                  clock->period_us);
    }
    source.close();
    // A clock is on in the second half of its period.
    for (const SpecialRange* const clock : named_clocks) {
      source.line("{} = @.{} >= {}u;", unit.layout.place({clock->kind, clock->first}),
                  time_name("clock", clock->period_us), clock->period_us / 2);
    }
  }
  if (!unit.is_ldmicro()) source.line("@.running = 1;");
}

void write_scan_end(CUnit& unit) {
  if (unit.is_ldmicro() && unit.knows_first_scan()) unit.body.line("@.running = 1;");
  if (unit.hooks()) write_hooks_after(unit, unit.body);
}

void write_fault(const CUnit& unit, CSource& source) {
  if (!unit.helpers.used(CHelper::Fault)) return;
  source.line("/* An instruction that could not be executed. */");
  source.open("static void @_fault(void) {{");
  for (const Device relay : unit.layout.of_role(SpecialRole::Error)) {
    source.line("{} = 1;", unit.layout.place(relay));
  }
  source.close();
  source.blank();
}

}  // namespace rung
