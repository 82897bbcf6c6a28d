// SPDX-License-Identifier: Apache-2.0
// A controller as its clients see it, without hardware: the registers of hdl/isa/controller.toml
// behind a Modbus server of its own, on TCP (loopback) or RTU (a pseudo-terminal), with faults to
// order.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rung::tb {

using Bytes = std::vector<std::uint8_t>;

class FakeController {
 public:
  enum class Line { Tcp, Rtu };
  explicit FakeController(Line line);
  ~FakeController();
  FakeController(const FakeController&) = delete;
  FakeController& operator=(const FakeController&) = delete;

  // What --port takes.
  std::string port() const { return port_; }

  // Who it says it is; board `simulated` if nothing is set. Before the first request.
  void set_register(int address, std::uint16_t value);
  std::uint16_t register_at(int address);
  // Devices, by their Modbus address.
  void set_bit(int address, bool value);
  void set_word(int address, std::uint16_t value);
  // The points that may be forced; others answer exception 02.
  void allow_force(int address);

  std::vector<std::uint16_t> program();  // the load file that runs
  std::vector<int> commands();           // that were written to `command`
  int requests();

  // Faults, each used up request by request.
  std::atomic<int> drop = 0;       // answers that get lost
  std::atomic<int> garble = 0;     // answers with a wrong CRC (RTU)
  std::atomic<int> busy = 0;       // exception 06 instead of an answer
  std::atomic<int> damage = 0;     // windows of which a word is stored wrong
  std::atomic<int> load_ends = 0;  // load_state that a commit ends with, 0: as it is
  // Unit from the next commit on, as a program with another I/O map would have it; 0: it stays.
  std::atomic<int> unit_after_commit = 0;

 private:
  void serve_tcp();
  void serve_rtu();
  // The answer to a request, function code first; empty: none.
  Bytes answer(const Bytes& request);
  Bytes read_bits(const Bytes& request);
  Bytes read_words(const Bytes& request);
  // Of both functions that write; `function` is the one that was asked.
  Bytes write(int function, int address, const std::vector<std::uint16_t>& words);
  static bool write_all(int file, const Bytes& bytes);
  int written(int address, std::uint16_t value);
  void commit();
  std::uint32_t wide(int address);
  void set_wide(int address, std::uint32_t value);

  std::mutex mutex_;
  std::map<int, std::uint16_t> registers_;
  std::map<int, bool> bits_;
  std::map<int, bool> forces_;
  std::map<int, bool> may_force_;
  std::vector<std::uint16_t> incoming_, program_;
  std::vector<int> commands_;
  int requests_ = 0;
  int unit_ = 1;
  int polls_left_ = 0;  // of load_state, while it says 1

  std::string port_;
  int file_ = -1;  // listening socket, or the pseudo-terminal's master
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace rung::tb
