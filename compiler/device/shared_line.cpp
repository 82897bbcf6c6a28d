// SPDX-License-Identifier: Apache-2.0
#include "device/shared_line.hpp"

#include <algorithm>

namespace rung::device {
namespace {

// As much as a frame and some noise; more waits in the terminal.
constexpr std::size_t kHeld = 512;

}  // namespace

std::uint16_t rtu_crc(std::span<const std::uint8_t> bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint16_t>(crc ^ byte);
    for (int i = 0; i < 8; ++i) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? crc >> 1 ^ 0xA001 : crc >> 1);
    }
  }
  return crc;
}

// What ends a frame: 3.5 characters, 1.75 ms above 19,200 baud; with a little more, so that the
// machine has seen it before the next frame begins.
std::uint64_t SharedLine::silence() const {
  return std::max(4 * machine_.character_clocks(), 2 * machine_.clocks_per_ms());
}

std::size_t SharedLine::room() const {
  const std::size_t waiting = held_.size() + machine_.sending();
  return waiting < kHeld ? kHeld - waiting : 0;
}

void SharedLine::from_terminal(std::span<const std::uint8_t> bytes) {
  held_.insert(held_.end(), bytes.begin(), bytes.end());
  take_turns();
}

void SharedLine::request(std::span<const std::uint8_t> frame) {
  frame_.assign(frame.begin(), frame.end());
  const std::uint16_t crc = rtu_crc(frame_);
  frame_.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  frame_.push_back(static_cast<std::uint8_t>(crc >> 8));
  reply_.clear();
  gateway_ = Gateway::Waiting;
  since_ = machine_.now();
  take_turns();
}

std::optional<SharedLine::Answer> SharedLine::answer() {
  if (gateway_ != Gateway::Done) return std::nullopt;
  gateway_ = Gateway::None;
  Answer answer{outcome_, {}};
  if (outcome_ == Outcome::Reply) answer.frame.assign(reply_.begin(), reply_.end() - 2);
  return answer;
}

void SharedLine::send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) machine_.send(byte);
  active_ = machine_.now();
  was_sending_ = true;
}

void SharedLine::finish(Outcome outcome) {
  outcome_ = outcome;
  gateway_ = Gateway::Done;
}

std::vector<std::uint8_t> SharedLine::step() {
  const std::vector<std::uint8_t> bytes = machine_.receive();
  // Of what ended within this run, only the run's end is known to be behind it.
  const bool sending = machine_.sending() != 0;
  if (!bytes.empty() || sending || was_sending_) active_ = machine_.now();
  was_sending_ = sending;
  if (!bytes.empty()) answered_ = true;
  if (owner_ == Owner::Gateway) {
    reply_.insert(reply_.end(), bytes.begin(), bytes.end());
  }
  const bool to_terminal = owner_ != Owner::Gateway;
  take_turns();
  return to_terminal ? bytes : std::vector<std::uint8_t>{};
}

void SharedLine::take_turns() {
  const std::uint64_t quiet = machine_.now() - active_;
  const std::uint64_t ms = machine_.clocks_per_ms();
  if (owner_ == Owner::Terminal &&
      ((answered_ && quiet >= silence()) || quiet >= kTerminalIdleMs * ms)) {
    owner_ = Owner::Nobody;
  }
  if (owner_ == Owner::Gateway) {
    if (!reply_.empty() && quiet >= silence()) {
      finish(reply_.size() >= 4 && rtu_crc(reply_) == 0 ? Outcome::Reply : Outcome::NoReply);
      owner_ = Owner::Nobody;
    } else if (quiet >= (frame_[0] == 0 ? silence() : kReplyMs * ms)) {
      finish(Outcome::NoReply);
      owner_ = Owner::Nobody;
    }
  }
  // The gateway first: a client that polls without a pause would never let it on.
  if (gateway_ == Gateway::Waiting) {
    if (owner_ == Owner::Nobody && quiet >= silence()) {
      owner_ = Owner::Gateway;
      gateway_ = Gateway::Running;
      answered_ = false;
      send(frame_);
    } else if (machine_.now() - since_ >= kTurnMs * ms) {
      finish(Outcome::NoTurn);
    }
  }
  // A client that asks on before the silence behind its answer begins another turn, if none else
  // waits.
  const bool wait = gateway_ == Gateway::Waiting && (owner_ == Owner::Nobody || answered_);
  if (!held_.empty() && owner_ != Owner::Gateway && !wait) {
    answered_ = false;
    owner_ = Owner::Terminal;
    const std::vector<std::uint8_t> bytes(held_.begin(), held_.end());
    held_.clear();
    send(bytes);
  }
}

}  // namespace rung::device
