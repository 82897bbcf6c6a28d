// SPDX-License-Identifier: Apache-2.0
#include "link/panel_bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "controller/rtu_bus.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

constexpr int kRead = 3, kWrite = 16, kProbe = 8;
constexpr std::uint8_t kException = 0x80;
constexpr int kIllegalFunction = 1, kIllegalAddress = 2;
constexpr double kApart = 38.5, kRequestEnds = 30;  // bits

std::uint8_t high(unsigned word) { return static_cast<std::uint8_t>(word >> 8); }
std::uint8_t low(unsigned word) { return static_cast<std::uint8_t>(word & 0xff); }
std::uint32_t step_of(double clocks_per_bit) {
  return static_cast<std::uint32_t>(8 * 1048576 / clocks_per_bit + 0.5);
}

}  // namespace

PanelServer::PanelServer(double clocks_per_bit, Parity parity, std::uint8_t unit)
    : bit_(clocks_per_bit), unit_(unit) {
  line_.set_rate(step_of(clocks_per_bit), parity);
}

bool PanelServer::level(std::uint64_t now) {
  if (!to_send_.empty() && now >= to_send_.front().at && line_.sending() == 0) {
    const Sending& sending = to_send_.front();
    for (std::size_t i = 0; i < sending.frame.size(); ++i) {
      if (sending.bad_byte && i == sending.frame.size() / 2) {
        line_.send_bad(sending.frame[i]);
      } else {
        line_.send(sending.frame[i]);
      }
    }
    to_send_.pop_front();
    began_at_ = now;
  }
  const bool level = line_.level(now);
  if (!level || line_.sending() != 0) quiet_since_ = now;
  return level;
}

void PanelServer::sample(std::uint64_t now, bool level) {
  if (!level) {
    // The first edge of a request. Its distance from what was on either line before.
    if (heard_.empty() && heard_at_ == 0) {
      const double quiet = static_cast<double>(now - quiet_since_);
      // Nobody sees an answer that begins in the same bit.
      const bool crossed = static_cast<double>(now - began_at_) < 2 * bit_;
      if (!crossed && (quiet < kApart * bit_ || quiet < 1.75 * kPanelClocksPerMs)) ++too_close_;
      begun_at_ = heard_at_ = now;
    }
    quiet_since_ = now;
  }
  line_.sample(now, level);
  for (const std::uint8_t byte : line_.take()) {
    heard_.push_back(byte);
    heard_at_ = now;
  }
  if (heard_at_ != 0 && static_cast<double>(now - heard_at_) > kRequestEnds * bit_) heard(now);
}

void PanelServer::heard(std::uint64_t now) {
  Frame frame = std::exchange(heard_, {});
  heard_at_ = 0;
  if (frame.size() < 4 || modbus_crc(frame) != 0) {
    ++broken_;
    return;
  }
  frame.resize(frame.size() - 2);
  if (frame[0] != unit_) return;
  if (frame[1] == kProbe) {
    ++probes_;
    if (echo == Echo::Silent) return;
    if (echo == Echo::Exception) frame = {unit_, kProbe | kException, kIllegalFunction};
    queue(now, with_crc(frame), {});
    return;
  }
  Plan plan;
  if (!plans_.empty()) {
    plan = std::move(plans_.front());
    plans_.pop_front();
  }
  const Frame reply = serve(frame, plan);
  queue(now, reply, plan);
}

Frame PanelServer::serve(const Frame& frame, Plan& plan) {
  const Answer answer = plan.answer;
  Request request;
  request.function = frame[1];
  request.first = static_cast<unsigned>(frame[2] << 8 | frame[3]);
  request.count = static_cast<unsigned>(frame[4] << 8 | frame[5]);
  request.answer = answer;
  request.begun_at = begun_at_;
  Frame reply{unit_, frame[1]};
  if (request.function == kRead) {
    EXPECT_EQ(frame.size(), 6U);
    reply.push_back(low(2 * request.count));
    for (unsigned i = 0; i < request.count; ++i) {
      const std::size_t serial = requests_.size() + 1;
      request.words.push_back(static_cast<std::uint16_t>(serial * 257 + request.first + i));
      reply.push_back(high(request.words.back()));
      reply.push_back(low(request.words.back()));
    }
  } else {
    EXPECT_EQ(request.function, kWrite);
    EXPECT_EQ(frame[6], 2 * request.count);
    EXPECT_EQ(frame.size(), 7 + 2 * request.count);
    for (std::size_t i = 7; i + 1 < frame.size(); i += 2) {
      request.words.push_back(static_cast<std::uint16_t>(frame[i] << 8 | frame[i + 1]));
    }
    reply.insert(reply.end(), frame.begin() + 2, frame.begin() + 6);
  }
  if (answer == Answer::Raw) {
    request.answer = meaning(request, with_crc(reply), plan.raw);
    requests_.push_back(request);
    // No byte at all is no answer.
    if (plan.raw.empty()) plan.answer = Answer::Silent;
    return plan.raw;
  }
  requests_.push_back(request);

  if (answer == Answer::Exception) {
    reply = {unit_, static_cast<std::uint8_t>(frame[1] | kException), kIllegalAddress};
  }
  if (answer == Answer::WrongUnit) ++reply[0];
  if (answer == Answer::WrongCount) {
    ++reply[request.function == kRead ? 2 : 5];
  }
  reply = with_crc(reply);
  if (answer == Answer::WrongCrc) reply[reply.size() / 2] ^= 4;
  return reply;
}

Answer PanelServer::meaning(Request& request, const Frame& right, const Frame& raw) {
  if (raw.size() < 4 || modbus_crc(raw) != 0 || raw[0] != right[0]) return Answer::Silent;
  if (raw.size() == 5 && raw[1] == (right[1] | kException)) return Answer::Exception;
  if (raw.size() != right.size() || raw[1] != right[1]) return Answer::Silent;
  if (request.function == kWrite) return raw == right ? Answer::Right : Answer::Silent;
  if (raw[2] != right[2]) return Answer::Silent;
  for (std::size_t i = 0; i < request.words.size(); ++i) {
    request.words[i] = static_cast<std::uint16_t>(raw[3 + 2 * i] << 8 | raw[4 + 2 * i]);
  }
  return Answer::Right;
}

void PanelServer::queue(std::uint64_t now, const Frame& frame, const Plan& plan) {
  std::uint64_t at = std::max(now, free_at_) + plan.delay;
  const auto characters = [this](std::size_t n) {
    return static_cast<std::uint64_t>(static_cast<double>(11 * n) * bit_) + n;
  };
  // Frames stand apart.
  const auto apart = static_cast<std::uint64_t>(50 * bit_) + 2 * kPanelClocksPerMs;
  if (plan.answer == Answer::BehindNoise) {
    const Frame noise{unit_, 3, 0x55};
    to_send_.push_back({at, noise, false});
    at += characters(noise.size()) + apart;
  }
  free_at_ = at;
  if (plan.answer == Answer::Silent) return;
  if (plan.answer == Answer::Halves) {
    const auto middle = frame.begin() + static_cast<std::ptrdiff_t>(frame.size() / 2);
    const std::uint64_t pause = static_cast<std::uint64_t>(20 * bit_);
    to_send_.push_back({at, {frame.begin(), middle}, false});
    to_send_.push_back({at + characters(frame.size() / 2) + pause, {middle, frame.end()}, false});
    free_at_ += pause;
  } else {
    to_send_.push_back({at, frame, plan.answer == Answer::WrongParity});
  }
  free_at_ += characters(frame.size()) + apart;
}

PanelBench::PanelBench(int seed, double clocks_per_bit, Parity parity, int timeout)
    : server(clocks_per_bit, parity, kUnit),
      timeout_ms(timeout),
      dut_(seed),
      random_(static_cast<unsigned>(seed)),
      pool_(32 * 32),
      millisecond_at_(random_() % kPanelClocksPerMs) {
  dut_->baud_step_i = step_of(clocks_per_bit);
  dut_->parity_i = static_cast<std::uint8_t>(parity);
  dut_->unit_i = kUnit;
  dut_->timeout_ms_i = static_cast<std::uint16_t>(timeout);
  dut_->millisecond_i = 0;
  dut_->rx_i = 1;
  dut_->panel_req_valid_i = 0;
  dut_->panel_done_ready_i = 0;
  dut_->mem_ready_i = 0;
  dut_->mem_rdata_i = 0;
  dut_.reset();
}

std::size_t PanelBench::ask(bool write, unsigned first, unsigned count) {
  if (!room()) {
    ADD_FAILURE() << "no block";
    return asked_.size() - 1;
  }
  Asked asked;
  std::vector<bool> used(kBlocks);
  for (const std::size_t other : outstanding_) {
    used[static_cast<std::size_t>(asked_[other].block)] = true;
  }
  do {
    asked.block = static_cast<int>(random_() % kBlocks);
  } while (used[static_cast<std::size_t>(asked.block)]);
  asked.write = write;
  asked.first = first;
  asked.count = count;
  for (unsigned i = 0; i < 32; ++i) {
    const auto word = static_cast<std::uint16_t>(random_());
    pool_[static_cast<std::size_t>(asked.block) * 32 + i] = word;
    if (write && i < count) asked.words.push_back(word);
  }
  asked_.push_back(asked);
  to_offer_.push_back(asked_.size() - 1);
  outstanding_.push_back(asked_.size() - 1);
  return asked_.size() - 1;
}

void PanelBench::before_edge() {
  const bool line = server.level(now_);
  dut_->rx_i = line && (!echoes || dut_->tx_o != 0) ? 1 : 0;
  dut_->millisecond_i = now_ % kPanelClocksPerMs == millisecond_at_ ? 1 : 0;
  const std::uint32_t draw = random_();
  dut_->mem_ready_i = draw % 1024 < static_cast<unsigned>(busy * 1024) ? 0 : 1;
  dut_->panel_done_ready_i = draw >> 30 == 0 ? 1 : 0;
  dut_->panel_req_valid_i = to_offer_.empty() ? 0 : 1;
  if (!to_offer_.empty()) {
    const Asked& asked = asked_[to_offer_.front()];
    dut_->panel_req_block_i = static_cast<std::uint8_t>(asked.block);
    dut_->panel_req_write_i = asked.write ? 1 : 0;
    dut_->panel_req_first_i = static_cast<std::uint16_t>(asked.first);
    dut_->panel_req_count_i = static_cast<std::uint8_t>(asked.count);
  }
  dut_->clk_i = 0;
  dut_->eval();
}

void PanelBench::clock() {
  before_edge();
  const bool offered = dut_->panel_req_valid_i != 0;
  if (offered) {
    EXPECT_EQ(dut_->panel_req_ready_o, 1);
    asked_[to_offer_.front()].at = now_;
    to_offer_.pop_front();
  }
  std::optional<std::uint16_t> rdata;
  if (dut_->mem_valid_o != 0 && dut_->mem_ready_i != 0) {
    const auto block = static_cast<int>(dut_->mem_addr_o / 32);
    // Its own are the only words that it touches.
    EXPECT_FALSE(outstanding_.empty());
    if (!outstanding_.empty()) {
      const Asked& asked = asked_[outstanding_.front()];
      EXPECT_EQ(block, asked.block);
      EXPECT_LT(dut_->mem_addr_o % 32U, asked.count);
      EXPECT_EQ(dut_->mem_write_o == 0, asked.write);
    }
    if (dut_->mem_write_o != 0) {
      pool_[dut_->mem_addr_o] = dut_->mem_wdata_o;
    } else {
      rdata = pool_[dut_->mem_addr_o];
    }
  }
  if (dut_->panel_done_valid_o != 0 && dut_->panel_done_ready_i != 0) {
    if (outstanding_.empty()) {
      ADD_FAILURE() << "a completion of nothing";
    } else {
      Asked& asked = asked_[outstanding_.front()];
      EXPECT_EQ(dut_->panel_done_block_o, asked.block);
      asked.status = dut_->panel_done_status_o;
      asked.done_at = now_;
      const auto words = pool_.begin() + std::ptrdiff_t{asked.block} * 32;
      if (!asked.write) asked.read.assign(words, words + std::min<std::ptrdiff_t>(asked.count, 32));
      outstanding_.pop_front();
    }
  }
  dut_->clk_i = 1;
  dut_->eval();
  if (rdata) dut_->mem_rdata_i = *rdata;
  ++now_;
  server.sample(now_, dut_->tx_o != 0);
}

void PanelBench::run(std::uint64_t clocks) {
  for (std::uint64_t i = 0; i < clocks; ++i) clock();
}

void PanelBench::run_to_end() {
  while (!outstanding_.empty() && !testing::Test::HasFailure()) clock();
}

void PanelBench::check(std::size_t number) const {
  const Asked& one = asked(number);
  ASSERT_TRUE(one.status.has_value());
  // Within its timeout and the millisecond that had begun.
  const auto limit = static_cast<std::uint64_t>(timeout_ms + 1) * kPanelClocksPerMs + 100;
  EXPECT_LE(one.done_at - one.at, limit) << "request " << number;
  // What the server got between the end of the one before and its own.
  const std::uint64_t from = number == 0 ? 0 : asked(number - 1).done_at;
  const auto& all = server.requests();
  const auto its_own = [&](const auto& request) {
    return request.begun_at > from && request.begun_at <= one.done_at;
  };
  EXPECT_LE(std::ranges::count_if(all, its_own), 1) << "request " << number;
  const auto found = std::ranges::find_if(all, its_own);
  if (found != all.end()) {
    const PanelServer::Request& served = *found;
    EXPECT_EQ(served.function, one.write ? kWrite : kRead);
    EXPECT_EQ(served.first, one.first);
    EXPECT_EQ(served.count, one.count);
    if (one.write) {
      EXPECT_EQ(served.words, one.words);
    }
    if (one.status == flow::flow_status_done) {
      EXPECT_TRUE(served.answer == Answer::Right || served.answer == Answer::Halves ||
                  served.answer == Answer::BehindNoise);
      if (!one.write) {
        EXPECT_EQ(one.read, served.words) << "request " << number;
      }
    }
    if (one.status == flow::flow_status_refused) {
      EXPECT_EQ(served.answer, Answer::Exception);
    }
  } else if (one.count >= 1 && one.count <= 32) {
    EXPECT_EQ(one.status, flow::flow_status_no_reply) << "request " << number;
  } else {
    EXPECT_EQ(one.status, flow::flow_status_refused) << "request " << number;
  }
}

}  // namespace rung::tb
