// SPDX-License-Identifier: Apache-2.0
// MPU1 behind its port exchange (port_bench.v): the host's accesses, scans clock by clock, and a
// model of what stands behind the ports.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "Vport_bench.h"
#include "harness/clocked.hpp"
#include "isa/isa.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {

inline const isa::Config& port_config() { return *isa::find_config("hx8k"); }

// A port's place in the processor's memories.
inline int port_address(Device port) {
  const isa::Config& config = port_config();
  const int devices = port.kind == DeviceKind::PB ? config.bit_devices : config.word_devices;
  return devices - 1 - static_cast<int>(port.number);
}

// Counts from the edge that samples scan_i, as the header of port_exchange.v does.
struct ScanTimes {
  int start = -1;  // edge at which the processor samples its start
  int done = -1;   // edge at which its done is sampled first
  int end = -1;    // edge at which done_o is sampled first
};

class PortBench {
 public:
  static constexpr int kSteps = 0, kBits = 2, kWords = 3, kLength = 4;

  PortBench() {
    for (int i = 0; i < 4; ++i) dut_->adc_i[static_cast<std::size_t>(i)] = 0;
    dut_->tx_ready_i = 1;
    dut_->rx_data_i = 0;
    dut_->restore_index_i = 0;
    dut_->restore_value_i = 0;
    ports(3, 64);
    reset();
    for (int i = 0; i < port_config().bit_devices; ++i) write(kBits, i, 0);
    for (int i = 0; i < port_config().word_devices; ++i) write(kWords, i, 0);
  }
  PortBench(const PortBench&) = delete;
  PortBench& operator=(const PortBench&) = delete;

  Vport_bench* operator->() { return dut_.operator->(); }

  // One edge; before() may set inputs for it, after() look at the outputs of the clock it begins.
  void edge() {
    if (before) before();
    dut_.tick();
    if (after) after();
    dut_->rx_valid_i = 0;
  }
  void edges(int count) {
    for (int i = 0; i < count; ++i) edge();
  }
  std::function<void()> before, after;

  void reset() {
    dut_->scan_i = 0;
    dut_->host_valid_i = 0;
    dut_->restore_valid_i = 0;
    dut_->rx_valid_i = 0;
    dut_->persist_ready_i = 0;
    dut_.reset();
  }

  // How many ports the program has.
  void ports(int bits, int words) {
    dut_->port_bits_i = static_cast<std::uint8_t>(bits);
    dut_->port_words_i = static_cast<std::uint8_t>(words);
  }

  void write(int space, int address, std::uint16_t data) {
    host(true, space, address, data);
    edge();
    dut_->host_valid_i = 0;
  }
  std::uint16_t read(int space, int address) {
    host(false, space, address, 0);
    edge();
    dut_->host_valid_i = 0;
    // The eighth clock: the edge that takes the access, and seven more.
    for (int i = 1; i < 8; ++i) {
      if (dut_->host_rvalid_o != 0) throw std::runtime_error("an answer too early");
      edge();
    }
    if (dut_->host_rvalid_o == 0) throw std::runtime_error("no answer in the eighth clock");
    return dut_->host_rdata_o;
  }
  bool bit(Device port) { return read(kBits, port_address(port)) != 0; }
  std::uint16_t word_of(Device port) { return read(kWords, port_address(port)); }

  void load(const std::vector<isa::SlotInstruction>& program) {
    const int bits = isa::slot_bits(isa::Mpu::Mpu1, port_config());
    for (std::size_t step = 0; step < program.size(); ++step) {
      const std::uint64_t code = isa::encode(program[step], isa::Mpu::Mpu1, port_config());
      for (int chunk = 0; chunk * 16 < bits; ++chunk) {
        write(kSteps, static_cast<int>(step) * 8 + chunk,
              static_cast<std::uint16_t>(code >> (16 * chunk)));
      }
    }
    write(kLength, 0, static_cast<std::uint16_t>(program.size()));
  }

  // One whole scan. at(e) sets inputs for edge e.
  ScanTimes scan(const std::function<void(int)>& at = {}) {
    ScanTimes times;
    dut_->scan_i = 1;
    for (int e = 0; e < 2000; ++e) {
      // What this edge samples.
      if (dut_->start_o != 0) times.start = e;
      if (times.start >= 0 && e > times.start && times.done < 0 && dut_->processor_done_o != 0) {
        times.done = e;
      }
      const bool end = e > 0 && dut_->done_o != 0;
      if (end != (e > 0 && dut_->busy_o == 0)) throw std::runtime_error("done and busy disagree");
      if (e > 0 && (dut_->host_ready_o != 0) != end) throw std::runtime_error("host_ready_o");
      if (end) {
        times.end = e;
        return times;
      }
      if (at) at(e);
      edge();
      dut_->scan_i = 0;
    }
    throw std::runtime_error("the scan does not end");
  }

 private:
  void host(bool write, int space, int address, std::uint16_t data) {
    dut_->host_valid_i = 1;
    dut_->host_write_i = write ? 1 : 0;
    dut_->host_space_i = static_cast<std::uint8_t>(space);
    dut_->host_addr_i = static_cast<std::uint32_t>(address);
    dut_->host_data_i = data;
    if (dut_->host_ready_o == 0) throw std::runtime_error("the load port is not the host's");
  }

  Clocked<Vport_bench> dut_{3};
};

}  // namespace rung::tb
