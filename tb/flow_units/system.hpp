// SPDX-License-Identifier: Apache-2.0
// Up to four controllers with flow tasks in one simulation, clock by clock: a chain on the link,
// inputs and outputs, and on the lines of each, if there are any, the Modbus programs outside
// (outside.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "flow_units/outside.hpp"

namespace rung::tb {

// What may be wrong with a unit's line to the next one below it.
enum class LineFault : std::uint8_t { None, Cut, Noise };

class FlowUnit;

class FlowSystem {
 public:
  // Units numbered from 1 on, unit 1 at the upper end.
  FlowSystem(int units, std::uint64_t seed);
  ~FlowSystem();

  static std::uint64_t clocks_per_ms();

  // A unit's flash gets this load file, before the first clock.
  void load(int unit, std::span<const std::uint16_t> words);
  // A touch panel at a unit, which answers after a random time between these, in milliseconds.
  // `silent` later: it never answers.
  void attach_panel(int unit, int modbus_unit, double least_ms, double most_ms);
  void silence_panel(int unit, bool silent);
  // A PC at a unit that reads `count` variables of a board without end.
  void attach_pc(int unit, int of_unit, int board, int first, int count);
  void detach_pc(int unit);

  void clock();
  void run(std::uint64_t clocks) {
    for (std::uint64_t i = 0; i < clocks; ++i) clock();
  }
  // Until all units run their programs. Throws if one does not within seconds of simulated time.
  void start();

  std::uint64_t now() const { return now_; }
  void set_input(int unit, int pin, bool level);
  bool output(int unit, int pin) const;
  // The input behind its filter.
  bool filtered(int unit, int pin) const;
  // Clocks from the beginning of the last round but one to that of the last, and rounds so far.
  std::uint64_t round_clocks(int unit) const;
  std::uint64_t most_round_clocks(int unit) const;
  void forget_most_round(int unit);
  std::uint64_t rounds(int unit) const;
  bool faulted(int unit) const;

  void set_fault(int upper_unit, LineFault fault);

  // A client's request to a unit without a PC: its answer; throws if there is none. The simulation
  // runs meanwhile.
  std::vector<std::uint8_t> ask(int unit, std::vector<std::uint8_t> pdu);
  // Its registers (numbers of flow.toml), by FC 3.
  std::vector<std::uint16_t> registers(int unit, int first, int count);
  // Writes them, by FC 16; the exception, or 0.
  int write_registers(int unit, int first, const std::vector<std::uint16_t>& values);

  // Commands that the PC of this unit has had done, and its complaints.
  std::int64_t pc_done(int unit);
  const std::vector<std::string>& complaints() const { return complaints_; }
  std::int64_t panel_answers(int unit) const;
  // From a request's first byte to the last of its answer.
  bool panel_under_way(int unit) const;

 private:
  FlowUnit& at(int unit) { return *units_.at(static_cast<std::size_t>(unit - 1)); }
  const FlowUnit& at(int unit) const { return *units_.at(static_cast<std::size_t>(unit - 1)); }

  std::mt19937_64 random_;
  std::vector<std::unique_ptr<FlowUnit>> units_;
  std::vector<LineFault> faults_;
  std::uint64_t now_ = 0;
  std::uint64_t noise_ends_ = 0;
  std::vector<std::string> complaints_;
};

}  // namespace rung::tb
