// SPDX-License-Identifier: Apache-2.0
// The registers of hdl/isa/controller.toml around the firmware, natively compiled: devices, device
// map, exchange, scan controller, line and flash as far as the firmware can tell.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "flash.hpp"
#include "rung_controller.hpp"
#include "rung_flow.hpp"

namespace rung::tb {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

struct Hang {};  // more accesses than any request, boot or stage of a commit has

class Machine {
 public:
  explicit Machine(Flash& flash);

  std::uint16_t read(std::uint16_t address);
  void write(std::uint16_t address, std::uint16_t value);

  // The processor's and the controller's state
  Words bits, words, bit_map, word_map, io, setup = Words(256), forces = Words(256);
  std::map<int, std::uint16_t> steps;  // by load address
  // Of flow tasks: what is loaded, by space; their registers, all of them plain memory
  std::map<int, std::map<int, std::uint16_t>> flow_spaces;
  std::array<std::uint16_t, flow::holding_flow_count> flow_registers{};
  std::uint16_t steps_count = 0, ports = 0;
  int state = 0, fault = 0;
  bool run_switch = true, next_is_first = false, exchange_offered = true;
  bool keep_wanted = false, keep_ready = false;
  std::uint16_t board = 0, mpu = 3, bad_crc = 0, overruns = 0;
  int scans_under_way = 0;  // status reads until a stop is done

  // The line
  void receive(const Bytes& frame);
  bool waiting = false;  // a frame is in rx_frame
  std::vector<Bytes> sent;
  int sending = 0;  // status reads until done

  // Counted
  int exchanges = 0, stops = 0, first_scans = 0, loads_while_running = 0;
  int points_too_many = 0;
  std::map<std::uint16_t, std::uint16_t> line_settings;
  std::uint64_t accesses = 0, budget = 0;
  std::uint64_t milliseconds_offset = 0;

 private:
  std::uint16_t read_register(int number);
  void write_register(int number, std::uint16_t value);
  void load_data(std::uint16_t value);
  void exchange(std::uint16_t control);
  std::uint16_t* device(bool of_words, bool raw, int point);
  std::uint16_t status();

  Flash& flash_;
  std::array<std::uint16_t, 256> rx_{}, tx_{}, buffer_{};
  std::array<std::uint16_t, 256> written_{};  // registers
  std::uint8_t flash_in_ = 0;
  int flash_busy_ = 0, exchange_busy_ = 0, length_ = 0;
  std::uint32_t crc_ = 0, load_place_ = 0;
  std::uint16_t held_ = 0;
  int load_space_ = 0;
  std::uint16_t nowhere_ = 0;
};

}  // namespace rung::tb
