// SPDX-License-Identifier: Apache-2.0
// A Modbus RTU line has one master; here clients on the pseudo-terminal and the TCP gateway take
// turns.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "device/serial_machine.hpp"

namespace rung::device {

// CRC-16 of Modbus RTU; sent low byte first.
std::uint16_t rtu_crc(std::span<const std::uint8_t> bytes);

// Times are those of the simulation. A turn of the terminal ends with the machine's answer and the
// silence behind it, or when nothing passes for kTerminalIdleMs; one of the gateway with the
// answer, its silence, or after kReplyMs.
class SharedLine {
 public:
  static constexpr std::uint64_t kTerminalIdleMs = 100;
  static constexpr std::uint64_t kReplyMs = 1000;
  static constexpr std::uint64_t kTurnMs = 2000;  // that the gateway waits for its turn

  enum class Outcome { Reply, NoReply, NoTurn };
  struct Answer {
    Outcome outcome = Outcome::NoReply;
    std::vector<std::uint8_t> frame;  // of a reply: unit address and PDU, its CRC was right
  };

  explicit SharedLine(SerialMachine& machine) : machine_(machine) {}

  // Bytes that the terminal may bring now.
  std::size_t room() const;
  void from_terminal(std::span<const std::uint8_t> bytes);

  // A request of the gateway, unit address and PDU. One at a time: until answer() has given its
  // end.
  void request(std::span<const std::uint8_t> frame);
  bool requested() const { return gateway_ != Gateway::None; }
  std::optional<Answer> answer();

  // To be called after each run of the machine; gives the bytes for the terminal.
  std::vector<std::uint8_t> step();

 private:
  enum class Owner { Nobody, Terminal, Gateway };
  enum class Gateway { None, Waiting, Running, Done };

  std::uint64_t silence() const;
  void send(std::span<const std::uint8_t> bytes);
  void take_turns();
  void finish(Outcome outcome);

  SerialMachine& machine_;
  Owner owner_ = Owner::Nobody;
  std::uint64_t active_ = 0;  // when the last byte passed, either way
  bool was_sending_ = false;
  bool answered_ = false;          // the machine has sent something in this turn
  std::deque<std::uint8_t> held_;  // of the terminal, until its turn
  Gateway gateway_ = Gateway::None;
  std::uint64_t since_ = 0;  // when the gateway's request came
  std::vector<std::uint8_t> frame_, reply_;
  Outcome outcome_ = Outcome::NoReply;
};

}  // namespace rung::device
