// SPDX-License-Identifier: Apache-2.0
// I/O maps: what a good one binds, and for each way to write a bad one the message, where it
// stands.
#include <algorithm>

#include "host/support.hpp"
#include "io/modbus_map.hpp"
#include "load/latency.hpp"

namespace rung::tb {
namespace {

constexpr const char* kList =
    "LD X0\nOR Y0\nANI X1\nOUT Y0\nLD M600\nOUT T250 K30\nLD T250\nOUT C220 K5\n"
    "LD M8000\nMOV D10 D200\nOUT Y1\nEND\n";

constexpr const char* kLadder = R"(LDmicro0.1
MICRO=Atmel AVR ATmega16 40-PDIP
CYCLE=5000
CRYSTAL=4000000
BAUD=9600

IO LIST
    Xstart at 3
    Yrun at 0
    Ain at 0
END

PROGRAM
RUNG
    CONTACTS Xstart 0
    COIL Yrun 0 0 0
END
RUNG
    READ_ADC Ain
END
RUNG
    MOVE duty Ain
END
RUNG
    SET_PWM duty 1000
END
RUNG
    UART_SEND duty
END
RUNG
    PERSIST duty
END
)";

struct Checked {
  std::optional<io::Map> map;
  io::Bindings bindings;
  io::Subject subject;
  std::string messages;
  bool errors = false;
};

Checked check(const std::string& text, const Program& program, int mpu = 3,
              const char* config = "ecp5") {
  Diagnostics diagnostics;
  Checked out;
  out.map = io::parse_map(text, "m.toml", diagnostics);
  if (out.map) {
    const image::Image image = image_of(program, mpu, config);
    out.subject = load::subject_of(image);
    out.bindings = io::bind(*out.map, out.subject, diagnostics);
    const auto timing = load::timing_of(image, out.bindings, isa::find_config(config)->clock_hz);
    load::check_timing(timing, *out.map, out.bindings, image.program, diagnostics);
  }
  out.messages = printed(diagnostics);
  out.errors = diagnostics.has_errors();
  return out;
}

constexpr const char* kGood = R"(board = "ulx3s"
[controller]
period_ms = 2.5
watchdog_ms = 50
exchange_points = 125
save_seconds = 5
stop_on_bad_download = true
stop_after_power_up = true
filter_us = 200
[modbus]
unit = 17
baud = 115200
parity = "none"
[inputs]
X0 = "btn1"
"X1" = { pin = "gp3", filter = 4, invert = true }
[outputs]
Y0 = { pin = "led0", safe = 1 }
Y1 = { pin = "gn2", safe = "hold", invert = true }
[analog]
D10 = "adc2"
[pwm]
D200 = { pin = "gp18", hz = 500 }
)";

TEST(IoMap, AllThatAMapMaySay) {
  const Checked got = check(kGood, program_of(kList));
  ASSERT_EQ(got.messages, "");
  const io::Settings& settings = got.bindings.settings;
  EXPECT_EQ(settings.period_us, 2500);
  EXPECT_EQ(settings.watchdog_us, 50000);
  EXPECT_EQ(settings.exchange_points, 125);
  EXPECT_EQ(settings.save_seconds, 5);
  EXPECT_TRUE(settings.stop_on_bad_download && settings.stop_after_power_up);
  EXPECT_EQ(settings.filter_us, 200);
  EXPECT_EQ(settings.unit, 17);
  EXPECT_EQ(settings.baud, 115200);
  EXPECT_EQ(settings.parity, io::Parity::None);
  ASSERT_EQ(got.bindings.inputs.size(), 2U);
  EXPECT_EQ(got.bindings.inputs[1].pin, 12);  // btn1..6, sw1..3, gp0..13
  EXPECT_EQ(got.bindings.inputs[1].filter, 4);
  EXPECT_TRUE(got.bindings.inputs[1].invert);
  ASSERT_EQ(got.bindings.outputs.size(), 2U);
  EXPECT_EQ(got.bindings.outputs[0].safe, io::Safe::High);
  EXPECT_EQ(got.bindings.outputs[1].safe, io::Safe::Hold);
  EXPECT_EQ(got.bindings.outputs[1].pin, 6);
  ASSERT_EQ(got.bindings.analog.size(), 1U);
  EXPECT_EQ(got.bindings.analog[0].channel, 2);
  ASSERT_TRUE(got.bindings.pwm);
  EXPECT_EQ(got.bindings.pwm->hz, 500);
  const std::string table = io::table(got.bindings, got.subject);
  for (const char* part : {"X1", "gp3", "4 equal samples, inverted", "led0", "safe at 1", "adc2",
                           "500 Hz", "M600 TS250 CS220 D200 TN250 CN220"}) {
    EXPECT_NE(table.find(part), std::string::npos) << part << " is not in\n" << table;
  }
}

struct BadMap {
  const char* text;
  const char* message;  // a part of what is printed
};
constexpr BadMap kBadMaps[] = {
    {"", "m.toml:1:1: error: the map does not say which board"},
    {"board = \"ulx4s\"\n",
     "m.toml:1:1: error: board: there is no board ulx4s\n    did you mean ulx3s?"},
    {"board = 3\n", "m.toml:1:1: error: board: this is no text"},
    {"board = \"ulx3s\"\n[inputs\n", "m.toml:2:8: error: this is no TOML"},
    {"board = \"ulx3s\"\ninputs = 3\n", "m.toml:2:1: error: inputs: this is no table"},
    {"board = \"ulx3s\"\n[input]\n",
     "m.toml:2:2: error: input: the map does not have this key\n    did you "
     "mean inputs?"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = \"btn11\"\n",
     "m.toml:3:6: error: btn11: board ulx3s has no input pin of this name\n    did you mean btn1?"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = \"led0\"\n",
     "m.toml:3:6: error: led0: this is no input pin of board ulx3s but one of its output pins"},
    {"board = \"ulx3s\"\n[inputs]\nX1 = \"sw1\"\nX0 = \"sw1\"\n",
     "m.toml:4:6: error: sw1: the pin is used in line 3 already"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = \"sw1\"\nX000 = \"sw2\"\n",
     "m.toml:4:1: error: X000: this device is bound in line 3 already as X0"},
    {"board = \"ulx3s\"\n[inputs]\nY0 = \"sw1\"\n",
     "m.toml:3:1: error: Y0: an output cannot be bound to an input pin\n    put the line under "
     "[outputs]"},
    {"board = \"ulx3s\"\n[outputs]\nX0 = \"led0\"\n",
     "m.toml:3:1: error: X0: an input cannot be bound to an output pin\n    put the line under "
     "[inputs]"},
    {"board = \"ulx3s\"\n[outputs]\nM600 = \"led0\"\n",
     "m.toml:3:1: error: M600: what is no output (Y) cannot be bound"},
    {"board = \"ulx3s\"\n[inputs]\nX8 = \"sw1\"\n",
     "m.toml:3:1: error: X8: this is neither a device of dialect fx nor a name"},
    {"board = \"ulx3s\"\n[inputs]\nX7 = \"sw1\"\n",
     "m.toml:3:1: warning: X7: the program does not name this device; the pin is not read"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = 3\n", "m.toml:3:1: error: X0: this does not say which pin"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = { filter = 3 }\n",
     "m.toml:3:1: error: X0: this does not say which pin"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = { pin = \"sw1\", filter = 16 }\n",
     "m.toml:3:21: error: filter: this is no whole number in its range\n    write a number from 0 "
     "to 15"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = { pin = \"sw1\", invert = 1 }\n",
     "m.toml:3:21: error: invert: this is neither true nor false"},
    {"board = \"ulx3s\"\n[inputs]\nX0 = { pin = \"sw1\", fitler = 1 }\n",
     "m.toml:3:21: error: fitler: X0 does not have this key\n    did you mean filter?"},
    {"board = \"ulx3s\"\n[outputs]\nY0 = { pin = \"led0\", safe = 2 }\n",
     "m.toml:3:22: error: safe: this is no state of an output"},
    {"board = \"ulx3s\"\n[outputs]\nY0 = \"led0\"\n",
     "m.toml:1:1: warning: outputs of the program without a pin: Y1"},
    {"board = \"ulx3s\"\n[analog]\nD10 = \"adc8\"\n",
     "m.toml:3:7: error: adc8: board ulx3s has no such analogue channel\n    it has adc0 to adc7"},
    {"board = \"ulx3s\"\n[analog]\nT250 = \"adc0\"\n",
     "m.toml:3:1: error: T250: this is no word that a channel can have"},
    {"board = \"ulx3s\"\n[pwm]\nD10 = \"gn0\"\n",
     "m.toml:3:7: error: gn0: this is no PWM output of board ulx3s but one of its plain output "
     "pins"},
    {"board = \"ulx3s\"\n[pwm]\nD10 = { pin = \"gp18\", hz = 0 }\n",
     "m.toml:3:23: error: hz: this is no whole number in its range"},
    {"board = \"ulx3s\"\n[uart]\nladder = \"gp19\"\n",
     "m.toml:3:1: warning: ladder: the program has no UART instructions"},
    {"board = \"ulx3s\"\n[uart]\nladder = \"gp17\"\n",
     "m.toml:3:10: error: gp17: board ulx3s has no UART of this name\n    did you mean gp19?"},
    {"board = \"ulx3s\"\n[modbus]\nunit = 248\n",
     "m.toml:3:1: error: unit: this is no whole number"},
    {"board = \"ulx3s\"\n[modbus]\nbaud = 4800\n",
     "m.toml:3:1: error: baud: this is no whole number in its range\n    write a number from 9600 "
     "to 921600"},
    {"board = \"ulx3s\"\n[modbus]\nparity = \"mark\"\n",
     "m.toml:3:1: error: parity: mark is no parity"},
    {"board = \"ulx3s\"\n[flow]\nsuspend = 1\n",
     "m.toml:3:1: error: suspend: this is neither true nor false"},
    {"board = \"ulx3s\"\n[flow]\nlink_timeout_ms = 0\n",
     "m.toml:3:1: error: link_timeout_ms: this is no whole number in its range\n    write a number "
     "from 1 to 10000"},
    {"board = \"ulx3s\"\n[flow]\nlink_timeout_ms = 0.5\n",
     "m.toml:3:1: error: link_timeout_ms: this is no whole number in its range"},
    {"board = \"ulx3s\"\n[flow]\npanel_timeout_ms = 10001\n",
     "m.toml:3:1: error: panel_timeout_ms: this is no whole number in its range\n    write a "
     "number "
     "from 1 to 10000"},
    {"board = \"ulx3s\"\n[flow]\npanel_unit = 248\n",
     "m.toml:3:1: error: panel_unit: this is no whole number in its range\n    write a number from "
     "1 to 247"},
    {"board = \"ulx3s\"\n[flow]\npanel_baud = 4800\n",
     "m.toml:3:1: error: panel_baud: this is no whole number in its range\n    write a number from "
     "9600 to 921600"},
    {"board = \"ulx3s\"\n[flow]\npanel_parity = \"mark\"\n",
     "m.toml:3:1: error: panel_parity: mark is no parity\n    write none, odd or even"},
    {"board = \"ulx3s\"\n[flow]\npanel_baut = 9600\n",
     "m.toml:3:1: error: panel_baut: [flow] does not have this key\n    did you mean panel_baud?"},
    {"board = \"ulx3s\"\nflow = true\n", "m.toml:2:1: error: flow: this is no table"},
    {"board = \"ulx3s\"\n[flow]\n",
     "m.toml:2:2: warning: flow: the program has no flow tasks; these settings have no use"},
    {"board = \"ulx3s\"\n[controller]\nwatchdog_ms = 0.05\n",
     "m.toml:3:1: error: the watchdog, 0.05 ms, is not above a scan"},
    {"board = \"ulx3s\"\n[controller]\nperiod_ms = 0.05\n",
     "m.toml:3:1: warning: the period, 0.05 ms, is shorter than a scan"},
    {"board = \"ulx3s\"\n[controller]\nperiod_ms = 0.0005\n",
     "m.toml:3:1: error: period_ms: this is no number of milliseconds"},
    {"board = \"ulx3s\"\n[controller]\nperiod_ms = -1\n",
     "m.toml:3:1: error: period_ms: this is no number of milliseconds"},
    {"board = \"ulx3s\"\n[controller]\nexchange_points = 2001\n",
     "m.toml:3:1: error: exchange_points: this is no whole number in its range"},
    {"board = \"ulx3s\"\n[latched]\ndevices = \"M0\"\n",
     "m.toml:3:1: error: devices: this is no list"},
    {"board = \"ulx3s\"\n[latched]\ndevices = [\"M0-D5\"]\n",
     "m.toml:3:12: error: M0-D5: this is no range"},
    {"board = \"ulx3s\"\n[latched]\ndevices = [\"X0\"]\n",
     "m.toml:3:12: error: X0: inputs and outputs cannot be kept"},
    {"board = \"ulx3s\"\n[latched]\ndevices = [3]\n",
     "m.toml:3:12: error: this is no device or range of devices"},
    {"board = \"hx8k\"\n",
     "m.toml:1:1: error: board hx8k has configuration hx8k; the program is compiled for "
     "ecp5"},
    {"board = \"hx8k\"\n",
     "m.toml:1:1: error: board hx8k has MPU2; the program is compiled for MPU3"},
};

TEST(IoMap, EveryFaultIsNamedWhereItStands) {
  const Program program = program_of(kList);
  for (const BadMap& bad : kBadMaps) {
    const Checked got = check(bad.text, program);
    EXPECT_NE(got.messages.find(bad.message), std::string::npos) << "of\n"
                                                                 << bad.text << "expected\n"
                                                                 << bad.message << "\ngot\n"
                                                                 << got.messages;
    const bool is_error = std::string_view(bad.message).find("error:") != std::string::npos;
    EXPECT_EQ(got.errors, is_error) << bad.text << got.messages;
  }
}

TEST(IoMap, AllErrorsAtOnce) {
  const Checked got = check(
      "board = \"ulx3s\"\n[modbus]\nunit = 0\n[inputs]\nX0 = \"nowhere\"\nfoo = "
      "\"sw1\"\n[outputs]\nY0 = "
      "\"sw2\"\n",
      program_of(kList));
  for (const char* place :
       {"m.toml:3:1: error", "m.toml:5:6: error", "m.toml:6:1: error", "m.toml:8:6: error"}) {
    EXPECT_NE(got.messages.find(place), std::string::npos) << got.messages;
  }
}

TEST(IoMap, CommentsAreNames) {
  Program program = program_of(kList);
  program.comments[{DeviceKind::X, 0}] = "Start button";
  program.comments[{DeviceKind::Y, 0}] = "Motor";
  const Checked got = check(
      "board = \"ulx3s\"\n[inputs]\n\"Start button\" = \"btn1\"\n[outputs]\nMotor = \"led0\"\nY1 = "
      "\"led1\"\n",
      program);
  EXPECT_EQ(got.messages, "");
  ASSERT_EQ(got.bindings.inputs.size(), 1U);
  EXPECT_EQ(got.bindings.inputs[0].device, (Device{DeviceKind::X, 0}));
  const Checked near = check("board = \"ulx3s\"\n[outputs]\nMotro = \"led0\"\n", program);
  EXPECT_NE(near.messages.find("did you mean Motor?"), std::string::npos) << near.messages;
}

TEST(IoMap, LdmicroProgramsBindTheirNames) {
  const Program program = program_of(kLadder, "t.ld");
  const Checked got = check(
      "board = \"ulx3s\"\n[inputs]\nXstart = \"btn1\"\n[outputs]\nYrun = \"led0\"\n[analog]\nAin = "
      "\"adc3\"\n[pwm]\nSET_PWM = \"gp18\"\n[uart]\nladder = \"gp19\"\n",
      program);
  EXPECT_FALSE(got.errors) << got.messages;
  // Pins of the file's micro-controller mean nothing.
  EXPECT_NE(got.messages.find("t.ld:1:1: note: pin numbers in the program's IO LIST"),
            std::string::npos)
      << got.messages;
  EXPECT_EQ(got.bindings.settings.period_us, 5000);
  ASSERT_EQ(got.bindings.analog.size(), 1U);
  EXPECT_EQ(got.bindings.analog[0].device.kind, DeviceKind::PW);
  EXPECT_TRUE(got.bindings.ladder_pwm && got.bindings.ladder_uart);
  EXPECT_TRUE(got.bindings.latched.empty());

  const Checked unbound = check("board = \"ulx3s\"\n", program);
  EXPECT_NE(unbound.messages.find("the program reads a channel into Ain"), std::string::npos);
  const Checked no_adc = check("board = \"hx8k\"\n", program, 2, "hx8k");
  EXPECT_FALSE(no_adc.errors) << no_adc.messages;
  EXPECT_NE(no_adc.messages.find("READ ADC of Ain: board hx8k has no analogue channel"),
            std::string::npos);
  const Checked wrong =
      check("board = \"ulx3s\"\n[analog]\nAin = \"adc0\"\nAim = \"adc1\"\n[pwm]\nduty = \"gp18\"\n",
            program);
  EXPECT_NE(wrong.messages.find("m.toml:4:1: error: Aim: the program has no READ ADC"),
            std::string::npos);
  EXPECT_NE(wrong.messages.find("m.toml:6:1: error: duty: an LDmicro program drives PWM"),
            std::string::npos);
}

TEST(IoMap, WithoutAMapThePinsAreInOrder) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    text += fmt::format("LD X{:o}\nOUT Y{:o}\n", 2 * i, i);
  }
  Diagnostics diagnostics;
  const image::Image image = image_of(program_of(text + "END\n"));
  const io::Subject subject = load::subject_of(image);
  const io::Map map = io::default_map(subject, diagnostics);
  const io::Bindings bindings = io::bind(map, subject, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.all().size(), 2U) << printed(diagnostics);
  ASSERT_EQ(bindings.inputs.size(), 32U);
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_EQ(bindings.inputs[i].device, (Device{DeviceKind::X, static_cast<unsigned>(2 * i)}));
    EXPECT_EQ(bindings.inputs[i].pin, static_cast<int>(i));
    EXPECT_EQ(bindings.outputs[i].pin, static_cast<int>(i));
  }
}

std::string latched(const std::string& map, const std::string& list, Dialect dialect) {
  const Program program = program_of(list, "t.il", dialect);
  const io::Subject subject = io::subject_of(program, "ecp5");
  Diagnostics diagnostics;
  const auto read = io::parse_map(map, "m.toml", diagnostics);
  const io::Bindings bindings = io::bind(*read, subject, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << printed(diagnostics);
  std::string text;
  for (const Device device : bindings.latched) text += subject.name(device) + " ";
  return text;
}

TEST(IoMap, LatchedDevicesAreTheMakersOrTheMaps) {
  const std::string board = "board = \"simulated\"\n";
  const std::string fx =
      "LD M499\nOR M500\nOR M7679\nOR S499\nOR S500\nOR S999\nOR S1000\nOUT T245 K1\nOUT T246 "
      "K1\nOUT T255 "
      "K1\nOUT T256 K1\nOUT C99 K1\nOUT C100 K1\nOUT C199 K1\nOUT C200 K1\nOUT C220 K1\nMOV D199 "
      "D200\nMOV "
      "D199 D7999\nEND\n";
  EXPECT_EQ(
      latched(board, fx, Dialect::Fx),
      "M500 M7679 S500 S999 TS246 TS255 CS100 CS199 CS220 D200 D7999 TN246 TN255 CN100 CN199 CN220 "
      "CN220:h ");
  EXPECT_EQ(latched(board + "[latched]\ndevices = []\n", fx, Dialect::Fx), "");
  EXPECT_EQ(latched(board + "[latched]\ndevices = [\"M499-M500\", \"C200\", \"D0-D199\"]\n", fx,
                    Dialect::Fx),
            "M499 M500 CS200 D199 CN200 CN200:h ");
  EXPECT_EQ(latched(board, "LD L5\nOUT M600\nOUT ST3 K5\nOUT T3 K5\nOUT C1 K5\nEND\n", Dialect::Q),
            "L5 STS3 STN3 ");
}

TEST(ModbusMap, AddressesAreThoseOfAnFx3u) {
  using enum DeviceKind;
  const auto at = [](Device device, const char* config) {
    const auto point = io::point_of(device, Dialect::Fx, config);
    return point ? point->address : -1;
  };
  EXPECT_EQ(at({X, 0}, "ecp5"), 0x3400);
  EXPECT_EQ(at({Y, 0377}, "ecp5"), 0x33FF);
  EXPECT_EQ(at({M, 7679}, "ecp5"), 0x1DFF);
  EXPECT_EQ(at({M, 8000}, "ecp5"), 0x1E00);
  EXPECT_EQ(at({S, 0}, "ecp5"), 0x2000);
  EXPECT_EQ(at({TS, 5}, "ecp5"), 0x3005);
  EXPECT_EQ(at({CS, 5}, "ecp5"), 0x3205);
  EXPECT_EQ(at({D, 7999}, "ecp5"), 7999);
  EXPECT_EQ(at({TN, 0}, "ecp5"), 0xA140);
  EXPECT_EQ(at({CN, 199}, "ecp5"), 0xA407);
  EXPECT_EQ(at({CN, 200}, "ecp5"), 0xA408);
  EXPECT_EQ(at({CNH, 200}, "ecp5"), 0xA409);
  EXPECT_EQ(at({CNH, 234}, "ecp5"), 0xA408 + 69);
  EXPECT_EQ(at({M, 512}, "hx8k"), -1);
  EXPECT_EQ(at({M, 511}, "hx8k"), 511);
  EXPECT_EQ(io::point_of({X, 0}, Dialect::Fx, "ecp5")->table, io::Table::Discrete);
}

// There and back for every point of every configuration.
TEST(ModbusMap, EveryAddressIsOneDevice) {
  for (const controller::Area& area : controller::areas) {
    const bool word = is_word(area.kind);
    const io::Table table = word         ? io::Table::Holding
                            : area.coils ? io::Table::Coil
                                         : io::Table::Discrete;
    int found = 0;
    for (int i = 0; i < area.count; ++i) {
      const auto device = io::device_at(table, area.first + i, Dialect::Fx, area.config);
      if (!device) continue;
      ++found;
      const auto point = io::point_of(*device, Dialect::Fx, area.config);
      ASSERT_TRUE(point);
      EXPECT_EQ(point->address, area.first + i);
      EXPECT_EQ(point->index, area.index + i);
    }
    EXPECT_EQ(found, area.count) << area.config << " " << area.name;
  }
}

}  // namespace
}  // namespace rung::tb
