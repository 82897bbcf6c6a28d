// SPDX-License-Identifier: Apache-2.0
#include "flow_units/unit.hpp"

#include <bit>

#include "rung_controller.hpp"

namespace rung::tb {
namespace {

// Milliseconds between the end of an answer and the PC's next request: the silence of RTU and a
// little of its own.
constexpr double kPcPauseMs = 1;
constexpr std::uint64_t kSilence = 4;  // characters, inside no frame

std::size_t flash_bytes() {
  const controller::Board& board = controller::boards().front();
  return std::bit_ceil(static_cast<std::size_t>(board.flash_base +
                                                2 * controller::flash_copy_sectors +
                                                controller::flash_ring_sectors) *
                       controller::flash_sector_bytes);
}

// The line's client side at the rate that the controller has now.
void follow(BitLine& line, std::pair<std::uint32_t, unsigned>& rate, std::uint32_t step,
            unsigned parity) {
  if (rate == std::pair{step, parity}) return;
  rate = {step, parity};
  line.set_rate(step, parity == 1 ? Parity::Odd : parity == 2 ? Parity::Even : Parity::None);
}

}  // namespace

FlowUnit::FlowUnit(std::uint64_t clocks_per_ms, std::uint64_t seed)
    : clocks_per_ms_(clocks_per_ms),
      random_(seed),
      context_(std::make_unique<VerilatedContext>()),
      flash_(flash_bytes(), seed,
             FlashTimes{clocks_per_ms, clocks_per_ms * 45, clocks_per_ms * 150, 1}) {
  context_->randReset(2);
  context_->randSeed(static_cast<int>(seed % 0x7FFFFFFF) + 1);
  top_ = std::make_unique<Vflow_unit>(context_.get());
  top_->in_i = 0;
  top_->host_rx_i = top_->panel_rx_i = top_->upper_rx_i = top_->lower_rx_i = top_->flash_miso_i = 1;
  top_->rst_ni = 0;
  for (int i = 0; i < kResetClocks; ++i) tick();
  top_->rst_ni = 1;
}

void FlowUnit::tick() {
  top_->clk_i = 0;
  top_->eval();
  top_->clk_i = 1;
  top_->eval();
}

void FlowUnit::attach_panel(int modbus_unit, double least_ms, double most_ms) {
  panel_ = std::make_unique<Outside>("panel.py", std::vector{std::to_string(modbus_unit)});
  least_ms_ = least_ms;
  most_ms_ = most_ms;
}

void FlowUnit::attach_pc(const std::vector<std::string>& what) {
  pc_ = std::make_unique<Outside>("pc.py", what);
}

void FlowUnit::detach_pc() {
  pc_.reset();
  pc_waits_ = false;
  answered_.clear();
}

void FlowUnit::before(std::uint64_t now) {
  top_->host_rx_i = host_.level(now);
  top_->panel_rx_i = panel_line_.level(now);
  tick();
}

void FlowUnit::after(std::uint64_t now) {
  follow(host_, host_rate_, top_->host_baud_o, top_->host_parity_o);
  follow(panel_line_, panel_rate_, top_->panel_baud_o, top_->panel_parity_o);
  host_.sample(now, top_->host_tx_o != 0);
  panel_line_.sample(now, top_->panel_tx_o != 0);
  top_->flash_miso_i =
      flash_.clock(top_->flash_csn_o != 0, top_->flash_sck_o != 0, top_->flash_mosi_o != 0);
  if (top_->latch_o != 0) {
    if (++rounds_ > 1) {
      round_clocks_ = now - round_at_;
      most_round_clocks_ = std::max(most_round_clocks_, round_clocks_);
    }
    round_at_ = now;
  }
  if (panel_ && now % 16 == 0) serve_panel(now);
  if (pc_ && now % 16 == 0 && top_->run_o != 0) serve_pc(now);
}

void FlowUnit::serve_panel(std::uint64_t now) {
  for (const std::uint8_t byte : panel_line_.take()) {
    asked_.push_back(byte);
    asked_at_ = now;
  }
  // A request that was cut short ends with silence.
  if (now - asked_at_ > kSilence * panel_line_.character_clocks()) asked_.clear();
  const std::size_t length = frame_length(asked_, false);
  if (length != 0 && asked_.size() >= length) {
    if (!panel_silent_) {
      answer_ = panel_->ask(asked_);
      std::uniform_real_distribution<double> delay(least_ms_, most_ms_);
      answer_at_ =
          now + static_cast<std::uint64_t>(delay(random_) * static_cast<double>(clocks_per_ms_));
    }
    asked_.clear();
  }
  if (!answer_.empty() && now >= answer_at_) {
    for (const std::uint8_t byte : answer_) panel_line_.send(byte);
    answer_.clear();
    ++panel_answers_;
  }
}

void FlowUnit::serve_pc(std::uint64_t now) {
  for (const std::uint8_t byte : host_.take()) answered_.push_back(byte);
  if (!pc_waits_ && now >= pc_asks_at_) {
    for (const std::uint8_t byte : pc_->next_request()) host_.send(byte);
    pc_waits_ = true;
  }
  const std::size_t length = frame_length(answered_, true);
  if (pc_waits_ && length != 0 && answered_.size() >= length) {
    pc_->answer(answered_);
    answered_.clear();
    pc_waits_ = false;
    pc_asks_at_ =
        now + static_cast<std::uint64_t>(kPcPauseMs * static_cast<double>(clocks_per_ms_));
  }
}

}  // namespace rung::tb
