// SPDX-License-Identifier: Apache-2.0
// SimulatedController over one Verilated top, at the pins of the host line or at its bytes.
#pragma once

#include <verilated.h>

#include <memory>
#include <utility>

#include "controller/fast_line.hpp"
#include "controller/simulated_controller.hpp"
#include "harness/model_coverage.hpp"

namespace rung::tb {

// The host line at the controller's pins.
template <typename Top>
class PinsOfLine {
 public:
  void idle(Top& top) { top.host_rx_i = 1; }
  // Once for each power-up.
  void start(const Top& top) { follow(top); }
  void before(Top& top, std::uint64_t now) { top.host_rx_i = line_.level(now); }
  void after(const Top& top, std::uint64_t now) {
    if (!fixed_ && (top.baud_step_o != step_ || top.parity_o != parity_)) follow(top);
    line_.sample(now, top.host_tx_o != 0);
  }
  void fix(std::uint32_t baud_step, Parity parity) {
    fixed_ = baud_step != 0;
    if (fixed_) line_.set_rate(baud_step, parity);
    step_ = 0;
  }
  BitLine& line() { return line_; }
  const BitLine& line() const { return line_; }

 private:
  void follow(const Top& top) {
    if (fixed_) return;
    step_ = top.baud_step_o;
    parity_ = top.parity_o;
    line_.set_rate(step_, parity_ == 1 ? Parity::Odd : parity_ == 2 ? Parity::Even : Parity::None);
  }

  BitLine line_;
  std::uint32_t step_ = 0;
  unsigned parity_ = 0;
  bool fixed_ = false;
};

// Its bytes, with bytes/host_uart.v in the place of the UART.
template <typename Top>
class BytesOfLine {
 public:
  class Line : public FastLine {
   public:
    std::uint64_t character_clocks() const { return kByteClocks; }
    double clocks_per_bit() const { return 1; }
    Parity parity() const { return Parity::None; }
  };

  void idle(Top& top) { top.host_rx_i = 1; }
  void start(const Top& /*top*/) {}
  void before(Top& top, std::uint64_t /*now*/) { top.host_rx_i = line_.level(); }
  void after(const Top& top, std::uint64_t /*now*/) { line_.sample(top.host_tx_o != 0); }
  void fix(std::uint32_t /*baud_step*/, Parity /*parity*/) {}
  Line& line() { return line_; }
  const Line& line() const { return line_; }

 private:
  Line line_;
};

template <typename Top, typename Line>
class VerilatedController final : public SimulatedController {
 public:
  VerilatedController(const controller::Board& board, const ControllerSetup& setup,
                      std::size_t flash_bytes, FlashTimes times)
      : SimulatedController(board, setup, flash_bytes, times), seed_(setup.seed) {
    power_up();
  }
  ~VerilatedController() override { end_model(); }

  void run(std::uint64_t clocks) override {
    if (!powered_) {
      now_ += clocks;
      return;
    }
    for (std::uint64_t i = 0; i < clocks; ++i) clock();
  }

  void reset() override {
    top_->rst_ni = 0;
    run(kResetClocks);
    top_->rst_ni = 1;
  }

  void set_input(int pin, bool level) override {
    const std::uint64_t bit = std::uint64_t{1} << pin;
    inputs_ = level ? inputs_ | bit : inputs_ & ~bit;
    top_->in_i = inputs_;
  }
  void set_adc(int channel, int sample) override {
    samples_[static_cast<std::size_t>(channel)] = static_cast<std::uint16_t>(sample);
    give_samples();
  }
  void set_run_switch(bool run) override {
    run_switch_ = run;
    top_->run_switch_i = run;
  }
  void set_power(bool on) override {
    if (on == powered_) return;
    powered_ = on;
    if (on) {
      power_up();
      return;
    }
    flash_.power_cut();
    line_.line().clear();
    ladder_.clear();
    note_outputs(0);
    shown_ = 0;
    for (const auto lamp : kLamps) note_lamp(lamp, false);
  }

  void send(std::uint8_t byte) override {
    if (powered_) line_.line().send(byte);
  }
  void send_bad(std::uint8_t byte) override {
    if (powered_) line_.line().send_bad(byte);
  }
  std::size_t sending() const override { return line_.line().sending(); }
  std::vector<std::uint8_t> receive() override { return line_.line().take(); }
  std::uint64_t character_clocks() const override { return line_.line().character_clocks(); }
  double clocks_per_bit() const override { return line_.line().clocks_per_bit(); }
  Parity parity() const override { return line_.line().parity(); }
  std::uint64_t bad_bytes() const override { return line_.line().bad_bytes(); }
  void fix_line(std::uint32_t baud_step, Parity parity) override { line_.fix(baud_step, parity); }

 private:
  using Pin = device::PinChange::Pin;
  static constexpr std::uint64_t kResetClocks = 16;
  static constexpr std::array kLamps{Pin::Run, Pin::Fault, Pin::Forced};

  void end_model() {
    top_->final();
    count_coverage(*context_);
  }

  // As after configuration of the FPGA: every register anything, then the reset of the board top.
  void power_up() {
    if (top_) end_model();
    top_.reset();  // it looks into its context to the end
    context_ = std::make_unique<VerilatedContext>();
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed_++ % 0x7FFFFFFF) + 1);
    top_ = std::make_unique<Top>(context_.get());
    top_->clk_i = 0;
    top_->in_i = inputs_;
    give_samples();
    top_->run_switch_i = run_switch_;
    top_->rx_i = 1;
    top_->flash_miso_i = 1;
    line_.idle(*top_);
    top_->rst_ni = 0;
    // Nothing outside looks before the reset is over.
    for (std::uint64_t i = 0; i < kResetClocks; ++i) tick();
    top_->rst_ni = 1;
    line_.start(*top_);
  }

  void give_samples() {
    for (std::size_t i = 0; i < samples_.size(); i += 2) {
      top_->adc_i[i / 2] = samples_[i] | static_cast<std::uint32_t>(samples_[i + 1]) << 16;
    }
  }

  void tick() {
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }

  void clock() {
    Top& top = *top_;
    line_.before(top, now_);
    top.rx_i = ladder_.level(now_);
    tick();
    ++now_;
    line_.after(top, now_);
    ladder_.sample(now_, top.tx_o != 0);
    top.flash_miso_i =
        flash_.clock(top.flash_csn_o != 0, top.flash_sck_o != 0, top.flash_mosi_o != 0);
    pwm_high_ += top.pwm_o;
    if (top.latch_o != 0) {
      ++latches_;
      latched_at_ = now_;
    }
    if (top.out_o != outputs_) note_outputs(top.out_o);
    const unsigned lamps = top.run_o | top.fault_o << 1 | top.forced_o << 2;
    if (lamps != shown_) {
      shown_ = lamps;
      for (const auto lamp : kLamps) {
        note_lamp(lamp, (lamps >> (static_cast<unsigned>(lamp) - 1) & 1) != 0);
      }
    }
  }

  void note_outputs(std::uint64_t outputs) {
    const std::uint64_t changed = outputs ^ outputs_;
    outputs_ = outputs;
    for (int pin = 0; pin < 64; ++pin) {
      if ((changed >> pin & 1) != 0) {
        changes_.push_back({now_, Pin::Output, pin, (outputs >> pin & 1) != 0});
      }
    }
  }

  void note_lamp(Pin lamp, bool level) {
    bool& shown = lamps_[static_cast<std::size_t>(lamp)];
    if (shown == level) return;
    shown = level;
    changes_.push_back({now_, lamp, 0, level});
  }

  std::uint64_t seed_;
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Top> top_;
  Line line_;
  std::uint64_t inputs_ = 0;
  std::array<std::uint16_t, 8> samples_{};
  bool run_switch_ = true;
  unsigned shown_ = 0;
};

}  // namespace rung::tb
