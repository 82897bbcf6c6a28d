// SPDX-License-Identifier: Apache-2.0
// The micro-sequencer's side of the RTU line, and frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "controller/modbus_crc.hpp"
#include "harness/clocked.hpp"
#include "rung_controller.hpp"

namespace rung::tb {

template <typename Random>
Frame random_bytes(Random& random, std::size_t length) {
  Frame bytes(length);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

struct LineCounts {
  int bad_crc = 0;
  int bad_byte = 0;
  int lost = 0;
  bool operator==(const LineCounts&) const = default;
};

// One access a clock; clock() is what a test does in every clock.
template <typename Dut>
class RtuBus {
 public:
  explicit RtuBus(int seed) : dut(seed) { release(); }
  virtual ~RtuBus() = default;
  virtual void clock() = 0;

  int read_register(int number) {
    dut->sel_register_i = 1;
    return read(number);
  }
  int read_rx_frame(std::size_t at) {
    dut->sel_rx_frame_i = 1;
    return read(static_cast<int>(at));
  }
  void write_register(int number, int value) {
    dut->sel_register_i = 1;
    write(number, value);
  }
  void write_tx_frame(std::size_t at, int value) {
    dut->sel_tx_frame_i = 1;
    write(static_cast<int>(at), value);
  }

  bool frame_waits() { return (read_register(controller::reg_line_status) & 1) != 0; }
  bool sending() { return (read_register(controller::reg_line_status) & 2) != 0; }
  LineCounts counts() {
    return {read_register(controller::reg_line_bad_crc),
            read_register(controller::reg_line_bad_byte), read_register(controller::reg_line_lost)};
  }
  Frame frame() {
    Frame bytes(static_cast<std::size_t>(read_register(controller::reg_line_length)));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<std::uint8_t>(read_rx_frame(i));
    }
    return bytes;
  }
  void take() { write_register(controller::reg_line_take, 0); }
  void send(const Frame& bytes) {
    for (std::size_t i = 0; i < bytes.size(); ++i) write_tx_frame(i, bytes[i]);
    write_register(controller::reg_line_send, static_cast<int>(bytes.size()));
  }
  void set_silence(std::uint32_t clocks) {
    write_register(controller::reg_line_silence_low, static_cast<int>(clocks & 0xffff));
    write_register(controller::reg_line_silence_high, static_cast<int>(clocks >> 16));
  }

  Clocked<Dut> dut;

 protected:
  void release() {
    dut->sel_rx_frame_i = 0;
    dut->sel_tx_frame_i = 0;
    dut->sel_register_i = 0;
    dut->addr_i = 0;
    dut->read_i = 0;
    dut->write_i = 0;
    dut->wdata_i = 0;
  }

 private:
  int read(int address) {
    dut->addr_i = static_cast<std::uint8_t>(address);
    dut->read_i = 1;
    clock();
    release();
    return dut->rdata_o;
  }
  void write(int address, int value) {
    dut->addr_i = static_cast<std::uint8_t>(address);
    dut->wdata_i = static_cast<std::uint16_t>(value);
    dut->write_i = 1;
    clock();
    release();
  }
};

}  // namespace rung::tb
