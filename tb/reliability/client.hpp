// SPDX-License-Identifier: Apache-2.0
// A Modbus client at the byte line of a simulated controller: requests as a user's tools send them,
// a download step by step, and damage to load files.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "controller/modbus_crc.hpp"
#include "controller/simulated_controller.hpp"

namespace rung::tb {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

// Sets a word of a load file's space; false: the file does not set it.
bool patch(Words& file, int space, std::uint32_t address, std::uint16_t value);
// The silence that ends a frame, far shorter than a client of a real line may have it.
void quicken(Words& file);

std::uint16_t low(std::size_t value);
std::uint16_t high(std::size_t value);
Bytes pdu(int function, const Words& words);

// Thrown by a client when its time has come.
struct Cut {};

class Client {
 public:
  explicit Client(SimulatedController& controller) : controller_(controller) {}

  // Sends bytes as they are, and waits for what comes until the line has been silent again for
  // long, or `patience` clocks for the first byte.
  Bytes send(const Bytes& frame, std::uint64_t patience);
  // A request's PDU and its answer's; nothing when there is none that is right.
  std::optional<Bytes> ask(const Bytes& pdu);

  // Throw std::runtime_error without an answer.
  Words read(int address, int count = 1);
  int holding(int address) { return read(address).at(0); }
  std::uint32_t holding_long(int address);
  int write(int address, const Words& values);  // 0 or the exception
  void command(int value);                      // must be accepted

  // A download, step by step.
  int begin(const Words& file, std::uint32_t crc);
  int window(const Words& file, std::size_t at,
             std::size_t offset);  // words from `at`, to `offset`
  int windows(const Words& file);
  int commit();  // the load_state it ends with, or the exception negative
  int download(const Words& file);

  // How it lets time pass; none: the controller runs.
  std::function<void(std::uint64_t clocks)> advance;
  // The clock at which it throws Cut.
  std::optional<std::uint64_t> cut_at;
  std::uint64_t patience = 4'000'000;
  int unit = 1;
  std::uint64_t gap = kGap;

  static constexpr std::uint64_t kGap = 600;  // of the line after a reset: 3.5 characters, and some

 private:
  void run(std::uint64_t clocks);
  SimulatedController& controller_;
};

}  // namespace rung::tb
