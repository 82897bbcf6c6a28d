// SPDX-License-Identifier: Apache-2.0
// The Verilated controller with what is around it on a bench: pins, analogue samples, the flash,
// the host line, power.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/bit_line.hpp"
#include "controller/flash_model.hpp"
#include "device/bench_machine.hpp"
#include "rung_controller.hpp"

namespace rung::tb {

struct ControllerSetup {
  std::string_view board = "simulated";  // or "hx8k"
  // Where the host line is met: at its pins, or (much shorter) as bytes behind the UART.
  enum class Line : std::uint8_t { Bits, Bytes };
  Line line = Line::Bits;
  // Clocks of a simulated millisecond: one of built_clocks_per_ms(), or those for plants with
  // `simulated` at its bytes. It is a parameter of the RTL.
  std::uint64_t clocks_per_ms = 250;
  // Of what registers and memories hold at power-up, and of what a power cut leaves in the flash.
  std::uint64_t seed = 1;
  // Times of the flash; none: those of a W25Q in simulated milliseconds.
  std::optional<FlashTimes> flash_times = {};
};

class SimulatedController : public device::BenchMachine {
 public:
  // Powered, in its first clock, with an erased flash. Throws for a board that is not simulated.
  static std::unique_ptr<SimulatedController> make(const ControllerSetup& setup);
  static std::vector<std::uint64_t> built_clocks_per_ms();

  const controller::Board& board() const { return board_; }
  FlashModel& flash() { return flash_; }
  const FlashModel& flash() const { return flash_; }

  // The reset pin for some clocks; the flash knows nothing of it.
  virtual void reset() = 0;
  // Power gone for an instant, at this clock, in the middle of whatever is under way.
  void power_cycle() {
    set_power(false);
    set_power(true);
  }

  // Levels of all output pins, as driven.
  std::uint64_t outputs() const { return outputs_; }
  bool output(int pin) const override { return (outputs_ >> pin & 1) != 0; }
  bool lamp(device::PinChange::Pin lamp) const override {
    return lamps_[static_cast<std::size_t>(lamp)];
  }
  std::vector<device::PinChange> changes() override { return std::exchange(changes_, {}); }
  std::uint64_t now() const override { return now_; }
  std::uint64_t clocks_per_ms() const override { return clocks_per_ms_; }
  bool powered() const override { return powered_; }

  // What the host UART is set to, and frames or bits on its line that were none.
  virtual double clocks_per_bit() const = 0;
  virtual Parity parity() const = 0;
  virtual std::uint64_t bad_bytes() const = 0;
  // A fixed rate of the client's line, for one that is not the controller's; 0: the controller's
  // again.
  virtual void fix_line(std::uint32_t baud_step, Parity parity) = 0;
  // A byte that its receiver must refuse: wrong parity or stop bit.
  virtual void send_bad(std::uint8_t byte) = 0;

  // Scans that have begun, and the clock in which the last one did: inputs are held at its end.
  std::uint64_t latches() const { return latches_; }
  std::uint64_t latched_at() const { return latched_at_; }
  // Clocks of the PWM pin at 1 since the start.
  std::uint64_t pwm_high() const { return pwm_high_; }
  // The ladder's own UART, once its rate is set.
  BitLine& ladder() { return ladder_; }

 protected:
  SimulatedController(const controller::Board& board, const ControllerSetup& setup,
                      std::size_t flash_bytes, FlashTimes times)
      : board_(board),
        flash_(flash_bytes, setup.seed, times),
        clocks_per_ms_(setup.clocks_per_ms) {}

  const controller::Board& board_;
  FlashModel flash_;
  std::uint64_t clocks_per_ms_;
  BitLine ladder_;
  std::uint64_t now_ = 0;
  bool powered_ = true;
  std::uint64_t outputs_ = 0;
  std::array<bool, 4> lamps_{};  // by PinChange::Pin; the first is unused
  std::vector<device::PinChange> changes_;
  std::uint64_t pwm_high_ = 0;
  std::uint64_t latches_ = 0, latched_at_ = 0;
};

}  // namespace rung::tb
