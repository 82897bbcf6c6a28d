// SPDX-License-Identifier: Apache-2.0
// A machine that answers Modbus RTU requests: a line with the time that bytes take, and nothing
// else.
#pragma once

#include <deque>
#include <map>
#include <utility>

#include "device/bench_machine.hpp"

namespace rung::tb {

// Unit 1 with ten holding registers from address 0 (FC 3 and 6); everything else is exception 1
// or 2. Requests to other units and frames with a wrong CRC are not answered.
class Responder : public device::BenchMachine {
 public:
  static constexpr std::uint64_t kCharacter = 110;  // clocks
  static constexpr std::uint64_t kClocksPerMs = 250;

  void run(std::uint64_t clocks) override;
  std::uint64_t now() const override { return now_; }
  std::uint64_t clocks_per_ms() const override { return kClocksPerMs; }
  void send(std::uint8_t byte) override { to_machine_.push_back(byte); }
  std::size_t sending() const override { return to_machine_.size(); }
  std::vector<std::uint8_t> receive() override;
  std::uint64_t character_clocks() const override { return kCharacter; }

  void set_input(int pin, bool level) override { inputs[pin] = level; }
  void set_adc(int channel, int sample) override { adc[channel] = sample; }
  void set_run_switch(bool run) override { run_switch = run; }
  void set_power(bool on) override { power = on; }
  bool powered() const override { return power; }
  bool output(int pin) const override { return pin == 3; }
  bool lamp(device::PinChange::Pin lamp) const override {
    return lamp == device::PinChange::Pin::Run;
  }
  std::vector<device::PinChange> changes() override { return std::exchange(pending_changes, {}); }

  std::map<int, bool> inputs;
  std::map<int, int> adc;
  bool run_switch = true;
  bool power = true;
  std::vector<device::PinChange> pending_changes;
  std::vector<std::uint16_t> registers = std::vector<std::uint16_t>(10);
  std::uint64_t delay = 300;      // clocks from the end of a request to its answer
  std::uint64_t longest_gap = 0;  // within what was taken as one frame
  int frames = 0;
  int bad_frames = 0;
  bool wrong_crc = false;  // of its answers
  bool mute = false;

 private:
  void clock();
  void answer();

  std::uint64_t now_ = 0;
  std::deque<std::uint8_t> to_machine_;
  std::uint64_t arriving_ = 0;  // clocks that the first of them has been on the line
  std::vector<std::uint8_t> frame_;
  std::uint64_t quiet_ = 0;
  std::deque<std::uint8_t> reply_;
  std::uint64_t reply_in_ = 0;
  std::vector<std::uint8_t> sent_;
};

}  // namespace rung::tb
