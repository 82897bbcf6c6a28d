// SPDX-License-Identifier: Apache-2.0
// The board of board.h in simavr, scan by scan.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct avr_t;
struct avr_irq_t;

namespace rung::tb {

class SimulatedBoard {
 public:
  // `firmware` is an ELF file. good() tells whether it could be loaded.
  explicit SimulatedBoard(const std::string& firmware);
  ~SimulatedBoard();
  SimulatedBoard(const SimulatedBoard&) = delete;
  SimulatedBoard& operator=(const SimulatedBoard&) = delete;

  bool good() const { return avr_ != nullptr; }
  // For the scans to come.
  void input(int number, bool value);
  void sample(int channel, int value);
  // A byte arrives at the UART: it takes the time that its baud rate says from now on.
  void receive(int byte);
  // Runs until the next scan has ended; false if there was none for a long time.
  bool scan();

  // After a scan.
  bool output(int number) const;
  const std::vector<int>& sent() const { return sent_; }
  // What the PWM timer compares its 8 bits with.
  int pwm_compare() const;

  // The power goes and comes back: of all memory the EEPROM's is kept.
  void power_cycle();

 private:
  static void on_scan(avr_irq_t* irq, std::uint32_t value, void* board);
  static void on_sent(avr_irq_t* irq, std::uint32_t value, void* board);

  avr_t* avr_ = nullptr;
  bool in_scan_ = false;
  bool scanned_ = false;
  std::vector<int> sent_;
};

}  // namespace rung::tb
