// SPDX-License-Identifier: Apache-2.0
// Real Modbus programs beside simulated controllers: each on a pseudo-terminal of its own. Nothing
// passes while they think: whoever asks them waits, and the simulation's clock with him, so that a
// seed gives the same run every time.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "device/pseudo_terminal.hpp"

namespace rung::tb {

// A Python program of this folder that is started with the name of its terminal as first argument,
// and ended with its owner.
class Outside {
 public:
  Outside(const std::string& script, const std::vector<std::string>& arguments);
  ~Outside();
  Outside(const Outside&) = delete;
  Outside& operator=(const Outside&) = delete;

  // A request for a server: its answer. Throws std::runtime_error if there is none within seconds.
  std::vector<std::uint8_t> ask(std::span<const std::uint8_t> request);
  // The next request of a client, which comes as soon as it has its answer.
  std::vector<std::uint8_t> next_request();
  void answer(std::span<const std::uint8_t> bytes);
  // Lines that the program has written since the last call, oldest first.
  std::vector<std::string> said();

 private:
  enum class Side : std::uint8_t { Request, Reply };
  std::vector<std::uint8_t> read_frame(Side side);

  std::string script_;
  device::PseudoTerminal terminal_;
  std::vector<std::uint8_t> heard_;
  std::string text_;
  int output_ = -1;
  pid_t process_ = -1;
};

// Length of the RTU frame that these bytes begin, its CRC included; 0: more bytes are needed to
// tell. Of the functions that a controller and its clients here use: 3, 16, exceptions.
std::size_t frame_length(std::span<const std::uint8_t> bytes, bool reply);

}  // namespace rung::tb
