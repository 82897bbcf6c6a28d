// SPDX-License-Identifier: Apache-2.0
#include "avr/simulated_board.hpp"

#include <avr_adc.h>
#include <avr_ioport.h>
#include <avr_uart.h>
#include <sim_avr.h>
#include <sim_elf.h>

#include <array>
#include <cstring>

// The leak sanitizer asks for it: the simulator does not free what it has taken.
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr"; }

namespace rung::tb {
namespace {

constexpr int kInputs = 4;
constexpr int kFirstInputPin =
    4;  // of port D, beyond the pins with an interrupt, which simavr polls
constexpr std::array kOutputBits = {0, 1, 2, 4, 5};  // of port B
// Of the ATmega328P, as the program sees them.
constexpr int kPortB = 0x25;
constexpr int kOcr2A = 0xB3;
constexpr int kScanPin = 5;              // of port C
constexpr std::uint32_t kSupply = 5115;  // mV: 5 to each step of the converter
// Steps in which time goes by while the processor sleeps; short beside a scan.
constexpr std::uint64_t kMostCyclesAtOnce = 1000;
constexpr std::uint64_t kMostCycles = 50'000'000;

void no_messages(avr_t*, const int, const char*, va_list) {}
// The simulator would sleep as long as the processor.
void no_sleep(avr_t*, avr_cycle_count_t) {}

}  // namespace

SimulatedBoard::SimulatedBoard(const std::string& firmware) {
  avr_global_logger_set(no_messages);
  elf_firmware_t elf;
  std::memset(&elf, 0, sizeof elf);
  if (elf_read_firmware(firmware.c_str(), &elf) != 0) return;
  avr_ = avr_make_mcu_by_name("atmega328p");
  if (avr_ == nullptr) return;
  avr_init(avr_);
  elf.frequency = 16'000'000;
  elf.vcc = elf.avcc = elf.aref = kSupply;
  avr_load_firmware(avr_, &elf);
  avr_->sleep = no_sleep;
  avr_->run_cycle_limit = kMostCyclesAtOnce;
  std::uint32_t flags = 0;
  avr_ioctl(avr_, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
  avr_irq_register_notify(avr_io_getirq(avr_, AVR_IOCTL_IOPORT_GETIRQ('C'), kScanPin), on_scan,
                          this);
  avr_irq_register_notify(avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_sent,
                          this);
}

SimulatedBoard::~SimulatedBoard() {
  if (avr_ != nullptr) avr_terminate(avr_);
}

void SimulatedBoard::input(int number, bool value) {
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_IOPORT_GETIRQ('D'), kFirstInputPin + number),
                value ? 1 : 0);
}

void SimulatedBoard::sample(int channel, int value) {
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + channel),
                static_cast<std::uint32_t>(value) * kSupply / 1023);
}

void SimulatedBoard::receive(int byte) {
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT),
                static_cast<std::uint32_t>(byte));
}

bool SimulatedBoard::scan() {
  sent_.clear();
  scanned_ = false;
  const std::uint64_t last = avr_->cycle + kMostCycles;
  while (!scanned_ && avr_->cycle < last) {
    const int state = avr_run(avr_);
    if (state == cpu_Done || state == cpu_Crashed) return false;
  }
  return scanned_;
}

bool SimulatedBoard::output(int number) const {
  return (avr_->data[kPortB] >> kOutputBits.at(static_cast<std::size_t>(number)) & 1) != 0;
}

int SimulatedBoard::pwm_compare() const { return avr_->data[kOcr2A]; }

void SimulatedBoard::power_cycle() {
  in_scan_ = false;
  avr_reset(avr_);
  // The pins read 0 now, which the simulator does not tell those that drive them.
  for (int number = 0; number < kInputs; ++number) {
    input(number, true);
    input(number, false);
  }
}

void SimulatedBoard::on_scan(avr_irq_t*, std::uint32_t value, void* board) {
  auto* const self = static_cast<SimulatedBoard*>(board);
  if (self->in_scan_ && value == 0) self->scanned_ = true;
  self->in_scan_ = value != 0;
}

void SimulatedBoard::on_sent(avr_irq_t*, std::uint32_t value, void* board) {
  static_cast<SimulatedBoard*>(board)->sent_.push_back(static_cast<int>(value & 0xFF));
}

}  // namespace rung::tb
