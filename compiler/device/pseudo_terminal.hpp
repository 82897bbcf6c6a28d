// SPDX-License-Identifier: Apache-2.0
// A pseudo-terminal that clients open as a serial port, one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rung::device {

// Raw: bytes pass as they are, whatever the client sets. While no client has it open, what is
// written is lost, as on a line that nobody listens to; nothing of it waits for the next client.
class PseudoTerminal {
 public:
  // `link`: a symbolic link to it, if not empty; an old link of this name is replaced, anything
  // else is not. Throws std::runtime_error with what failed and what to do.
  explicit PseudoTerminal(const std::string& link);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& name() const { return name_; }
  int descriptor() const { return master_; }
  // Whether a client has it open; found anew by each read().
  bool open() const { return open_; }

  // What clients have sent; at most `limit` bytes, the rest waits.
  std::vector<std::uint8_t> read(std::size_t limit);
  // Bytes that the terminal has no room for are lost, and counted.
  void write(std::span<const std::uint8_t> bytes);
  std::uint64_t lost() const { return lost_; }

 private:
  void find_state();

  int master_ = -1;
  std::string name_;
  std::string link_;
  bool open_ = false;
  std::uint64_t lost_ = 0;
};

}  // namespace rung::device
