// SPDX-License-Identifier: Apache-2.0
// Programs of ours as C on an ATmega328P, built by avr-gcc, run in simavr: outputs, sent bytes and
// PWM are those of the reference, scan for scan.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <sstream>

#include "avr/simulated_board.hpp"
#include "backends/c_writer.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/melsec.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

// What a board runs: NAME.c, which includes program.c, the translation of NAME.ld or NAME.il.
struct Firmware {
  const char* name;
  const char* extension;
  bool sends = false;
  bool has_pwm = false;
};

constexpr Firmware kPrograms[] = {
    {"conveyor", "ld"}, {"scale", "ld", true}, {"heater", "ld", false, true}, {"stairs", "il"}};
constexpr int kScans = 400;
// The supply fails before this scan.
constexpr int kPowerCycle = 250;

// Pins of the ATmega328P's DIP package, as an `.ld` names them.
constexpr std::array kInputPins = {6, 11, 12, 13};
constexpr std::array kOutputPins = {14, 15, 16, 18, 19};
constexpr int kFirstSamplePin = 23;

std::optional<Program> read_program(const Firmware& firmware) {
  const std::string path =
      fmt::format("{}/{}.{}", RUNG_AVR_FOLDER, firmware.name, firmware.extension);
  Diagnostics diagnostics;
  std::optional<Program> program;
  if (const auto source = read_text(path, diagnostics)) {
    program = std::string_view(firmware.extension) == "ld"
                  ? parse_ldmicro(*source, diagnostics)
                  : parse_melsec(*source, Dialect::Fx, diagnostics);
  }
  std::ostringstream messages;
  diagnostics.print(messages);
  EXPECT_EQ(messages.str(), "");
  return program;
}

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::int64_t cycle_us(const Program& program) {
  return program.ldmicro ? program.ldmicro->cycle_us : 10000;
}

// Compiles as a user would; the path of the ELF file, empty if avr-gcc complains.
std::string build(const Firmware& firmware, const Program& program) {
  const fs::path folder = fs::path(RUNG_SCRATCH) / firmware.name;
  fs::create_directories(folder);
  std::ofstream(folder / "program.c") << to_c(program);
  const std::string base = folder / firmware.name;
  const std::string command = fmt::format(
      "'{}' -std=c99 -Wall -Wextra -pedantic -Werror -Os -ffunction-sections -Wl,--gc-sections "
      "-mmcu=atmega328p -DF_CPU=16000000UL -DCYCLE_US={}UL -DUART_BAUD={}UL -I'{}' -I'{}' "
      "'{}/{}.c' '{}/board.c' -o '{}.elf' >'{}.log' 2>&1",
      RUNG_AVR_GCC, cycle_us(program), program.ldmicro ? program.ldmicro->baud : 9600,
      RUNG_AVR_FOLDER, folder.string(), RUNG_AVR_FOLDER, firmware.name, RUNG_AVR_FOLDER, base,
      base);
  const int failed = std::system(command.c_str());
  EXPECT_EQ(failed, 0) << contents(base + ".log");
  EXPECT_EQ(contents(base + ".log"), "");
  return failed == 0 ? base + ".elf" : "";
}

void print_size(const Firmware& firmware, const std::string& elf) {
  const std::string command = fmt::format("'{0}' '{1}' >'{1}.size'", RUNG_AVR_SIZE, elf);
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(elf + ".size");
  std::string titles;
  std::getline(in, titles);
  int text = 0, data = 0, bss = 0;
  ASSERT_TRUE(in >> text >> data >> bss);
  fmt::print("{}.{}: {} bytes of flash, {} of RAM\n", firmware.name, firmware.extension,
             text + data, data + bss);
}

// A program's devices at the board's inputs and outputs.
class Wiring {
 public:
  explicit Wiring(const Program& program) {
    for (const Device device : named_devices(program)) {
      const int pin = pin_of(program, device);
      if (device.kind == DeviceKind::X)
        inputs_.emplace_back(device, place(device, pin, kInputPins));
      if (device.kind == DeviceKind::Y) {
        outputs_.emplace_back(device, place(device, pin, kOutputPins));
      }
      if (device.kind == DeviceKind::D && pin > 0) samples_.push_back(pin - kFirstSamplePin);
    }
  }

  using Places = std::vector<std::pair<Device, int>>;
  const Places& inputs() const { return inputs_; }
  const Places& outputs() const { return outputs_; }
  // Of the analogue channels, in their order.
  const std::vector<int>& samples() const { return samples_; }

 private:
  // 0: a list's, whose devices have the numbers of inputs and outputs.
  static int pin_of(const Program& program, Device device) {
    if (!program.ldmicro) return 0;
    for (const LdmicroSettings::Pin& pin : program.ldmicro->pins) {
      if (pin.name == device_name(device, program)) return pin.pin;
    }
    return 0;
  }
  static int place(Device device, int pin, std::span<const int> pins) {
    if (pin == 0) return static_cast<int>(device.number);
    return static_cast<int>(std::find(pins.begin(), pins.end(), pin) - pins.begin());
  }

  Places inputs_;
  Places outputs_;
  std::vector<int> samples_;
};

class Comparison {
 public:
  Comparison(const Program& program, const std::string& elf)
      : program_(program), wiring_(program), board_(elf) {}

  bool good() const { return board_.good(); }

  // Power comes; `kept` is what the EEPROM has, that of an erased one is -1.
  void start(std::int16_t kept) {
    reference_.emplace(program_, cycle_us(program_));
    reference_->set(port::persist_value, kept);
    next_byte_ = 0;
  }
  std::int16_t kept() const { return reference_->get(port::persist_value); }

  void scan() {
    for (const auto& [device, number] : wiring_.inputs()) {
      if (random_.percent(12)) inputs_[device] = !inputs_[device];
      board_.input(number, inputs_[device]);
      reference_->set(device, inputs_[device] ? 1 : 0);
    }
    for (std::size_t i = 0; i < wiring_.samples().size(); ++i) {
      const int value = random_.percent(60) ? random_.below(1024) : 90;
      board_.sample(wiring_.samples()[i], value);
      reference_->set(port::at(port::adc, static_cast<int>(i)), static_cast<std::int16_t>(value));
    }
    receive();
    reference_->set(port::persist_ready, 1);
    reference_->run_scan();
    ASSERT_TRUE(board_.scan());
    for (const auto& [device, number] : wiring_.outputs()) {
      ASSERT_EQ(board_.output(number), reference_->get(device) != 0)
          << device_name(device, program_);
      outputs_on_ += reference_->get(device);
    }
    ASSERT_EQ(board_.sent(), reference_->sent());
    sent_ += reference_->sent().size();
    if (reference_->get(port::pwm_hz_low) != 0) {
      const int duty = std::clamp<int>(reference_->get(port::pwm_duty), 0, 100);
      ASSERT_EQ(board_.pwm_compare(), duty * 255 / 100);
      duties_.insert(duty);
    }
  }

  void power_cycle() {
    board_.power_cycle();
    start(kept());
  }

  int outputs_on() const { return outputs_on_; }
  std::size_t sent() const { return sent_; }
  std::size_t duties() const { return duties_.size(); }

 private:
  // At 600 baud a byte takes more than one scan and less than two: what begins to arrive before a
  // scan is there in the next one.
  void receive() {
    static constexpr std::array kKeys = {'0', '1', '2', '3', '4', '5', 'p', 'e', 'x'};
    if (next_byte_ != 0) reference_->set(port::uart_rx_data, static_cast<std::int16_t>(next_byte_));
    const bool begins = next_byte_ == 0 && random_.percent(15);
    next_byte_ = begins ? kKeys[static_cast<std::size_t>(random_.below(kKeys.size()))] : 0;
    if (begins) board_.receive(next_byte_);
  }

  const Program& program_;
  Wiring wiring_;
  SimulatedBoard board_;
  std::optional<Reference> reference_;
  RandomSource random_{1};
  std::map<Device, bool> inputs_;
  int next_byte_ = 0;
  int outputs_on_ = 0;
  std::size_t sent_ = 0;
  std::set<int> duties_;
};

class Avr : public testing::TestWithParam<Firmware> {};

TEST_P(Avr, EqualsTheReference) {
  const auto program = read_program(GetParam());
  ASSERT_TRUE(program);
  const std::string elf = build(GetParam(), *program);
  ASSERT_NE(elf, "");
  print_size(GetParam(), elf);
  Comparison comparison(*program, elf);
  ASSERT_TRUE(comparison.good());
  comparison.start(-1);
  for (int scan = 0; scan < kScans; ++scan) {
    SCOPED_TRACE(fmt::format("scan {}", scan));
    if (scan == kPowerCycle) comparison.power_cycle();
    comparison.scan();
    if (HasFatalFailure()) return;
  }
  // What a program has was used.
  EXPECT_GT(comparison.outputs_on(), kScans / 2);
  EXPECT_EQ(comparison.sent() > 100, GetParam().sends);
  EXPECT_EQ(comparison.duties() > 5, GetParam().has_pwm);
}

INSTANTIATE_TEST_SUITE_P(Programs, Avr, testing::ValuesIn(kPrograms),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rung::tb
