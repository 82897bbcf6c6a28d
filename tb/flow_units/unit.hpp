// SPDX-License-Identifier: Apache-2.0
// One Verilated controller with flow tasks, and what stands at its pins.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "Vflow_unit.h"
#include "controller/bit_line.hpp"
#include "controller/flash_model.hpp"
#include "flow_units/outside.hpp"
#include "harness/model_coverage.hpp"

namespace rung::tb {

class FlowUnit {
 public:
  FlowUnit(std::uint64_t clocks_per_ms, std::uint64_t seed);
  ~FlowUnit() {
    top_->final();
    count_coverage(*context_);
  }

  FlashModel& flash() { return flash_; }
  Vflow_unit& pins() { return *top_; }
  const Vflow_unit& pins() const { return *top_; }

  void attach_panel(int modbus_unit, double least_ms, double most_ms);
  void silence_panel(bool silent) { panel_silent_ = silent; }
  void attach_pc(const std::vector<std::string>& what);
  void detach_pc();

  // A clock: the lines' levels before it, what they show after it.
  void before(std::uint64_t now);
  void after(std::uint64_t now);

  // Bytes for the host line, and from it: where no PC is attached.
  BitLine& host() { return host_; }

  std::uint64_t rounds() const { return rounds_; }
  std::uint64_t round_clocks() const { return round_clocks_; }
  std::uint64_t most_round_clocks() const { return most_round_clocks_; }
  void forget_most_round() { most_round_clocks_ = 0; }
  std::int64_t panel_answers() const { return panel_answers_; }
  bool panel_under_way() const {
    return !asked_.empty() || !answer_.empty() || panel_line_.sending();
  }
  // What the PC has said since the last call.
  std::vector<std::string> pc_said() { return pc_ ? pc_->said() : std::vector<std::string>{}; }
  bool has_pc() const { return pc_ != nullptr; }

 private:
  static constexpr int kResetClocks = 16;
  void tick();
  void serve_panel(std::uint64_t now);
  void serve_pc(std::uint64_t now);

  std::uint64_t clocks_per_ms_;
  std::mt19937_64 random_;
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vflow_unit> top_;
  FlashModel flash_;
  BitLine host_, panel_line_;
  std::pair<std::uint32_t, unsigned> host_rate_, panel_rate_;  // baud step and parity

  std::unique_ptr<Outside> panel_;
  double least_ms_ = 0, most_ms_ = 0;
  bool panel_silent_ = false;
  std::vector<std::uint8_t> asked_;
  std::uint64_t asked_at_ = 0;
  std::vector<std::uint8_t> answer_;  // for the panel's line, at answer_at_
  std::uint64_t answer_at_ = 0;
  std::int64_t panel_answers_ = 0;

  std::unique_ptr<Outside> pc_;
  bool pc_waits_ = false;  // for an answer
  std::uint64_t pc_asks_at_ = 0;
  std::vector<std::uint8_t> answered_;

  std::uint64_t rounds_ = 0, round_at_ = 0, round_clocks_ = 0, most_round_clocks_ = 0;
};

}  // namespace rung::tb
