// SPDX-License-Identifier: Apache-2.0
// A controller without its micro-sequencer (controller_bus.v: MPU2, sizes of the HX8K, a
// millisecond of 40 clocks), which a test drives through its bus as the firmware would, and through
// its pins.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "Vcontroller_bus.h"
#include "harness/clocked.hpp"
#include "image/image.hpp"
#include "isa/isa.hpp"
#include "rung_controller.hpp"
#include "rungs/special.hpp"

namespace rung::tb {

// An entry of the io list.
struct IoEntry {
  int kind = 0;
  int index = 0;
  bool word = false;
  int device = 0;
};

// What an exchange asks for; `data` is written, a bit or a word a point.
struct ExchangeRequest {
  bool words = false;
  bool raw = false;
  int write_first = 0;
  std::vector<std::uint16_t> data;
  int read_first = 0;
  int read_count = 0;
};

class ControllerBus {
 public:
  static constexpr int kClocksPerMs = 40;
  static constexpr int kRun = 1, kStop = 2, kOne = 3, kClear = 4, kLeave = 5;
  static constexpr int kStopped = 0, kRunning = 1, kOneScan = 2, kFault = 3;

  ControllerBus() {
    dut_->in_i = 0;
    for (int i = 0; i < 4; ++i) dut_->adc_i[static_cast<std::size_t>(i)] = 0;
    dut_->rx_i = 1;
    dut_->flash_miso_i = 0;
    dut_->run_switch_i = 1;
    dut_->host_rx_active_i = 0;
    dut_->host_rx_valid_i = 0;
    dut_->host_rx_data_i = 0;
    dut_->host_rx_error_i = 0;
    dut_->host_tx_ready_i = 1;
    dut_->host_tx_busy_i = 0;
    dut_->mem_addr_i = 0;
    dut_->mem_read_i = 0;
    dut_->mem_write_i = 0;
    dut_->mem_wdata_i = 0;
    dut_.reset();
    wait_idle();
    for (int i = 0; i < 256; ++i) force(i, 0);
    clear_map();
    clear_devices();
  }
  ControllerBus(const ControllerBus&) = delete;
  ControllerBus& operator=(const ControllerBus&) = delete;

  Vcontroller_bus* operator->() { return dut_.operator->(); }
  Clocked<Vcontroller_bus>& dut() { return dut_; }

  static const isa::Config& config() { return *isa::find_config("hx8k"); }

  // One clock. before() may change inputs, after() look at the clock that begins.
  void clock() {
    if (before) before();
    dut_.tick();
    ++now;
    if (after) after();
  }
  void clocks(std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) clock();
  }
  std::function<void()> before, after;
  std::int64_t now = 0;

  // ---- bus ----
  void write_at(int address, int data) {
    dut_->mem_addr_i = static_cast<std::uint16_t>(address);
    dut_->mem_wdata_i = static_cast<std::uint16_t>(data);
    dut_->mem_write_i = 1;
    clock();
    dut_->mem_write_i = 0;
  }
  std::uint16_t read_at(int address) {
    dut_->mem_addr_i = static_cast<std::uint16_t>(address);
    dut_->mem_read_i = 1;
    clock();
    dut_->mem_read_i = 0;
    return dut_->mem_rdata_o;
  }
  void write(int reg, int data) { write_at(controller::micro_registers + reg, data); }
  std::uint16_t read(int reg) { return read_at(controller::micro_registers + reg); }
  std::uint32_t read32(int low) {
    const std::uint32_t value = read(low);
    return value | std::uint32_t{read(low + 1)} << 16;
  }

  // ---- state ----
  int status() { return read(controller::reg_scan_status); }
  int state() { return status() & 3; }
  int fault() { return status() >> 8; }
  void command(int code) { write(controller::reg_scan_command, code); }
  void first() { write(controller::reg_scan_first, 1); }
  void run() {
    first();
    command(kRun);
  }
  void wait_idle() {
    for (int i = 0; i < 100000; ++i) {
      if ((status() & 4) != 0) return;
    }
    throw std::runtime_error("never idle");
  }
  void stop() {
    command(kStop);
    wait_idle();
  }
  std::uint32_t scans() { return read32(controller::reg_scan_count_low); }
  // Until `count` more scans have been counted.
  void wait_scans(std::uint32_t count) {
    const std::uint32_t begin = scans();
    for (int i = 0; i < 10000000; ++i) {
      if (scans() - begin >= count) return;
    }
    throw std::runtime_error("no scans");
  }

  // ---- load ----
  void load(int space, int address, const std::vector<std::uint16_t>& data) {
    write(controller::reg_load_space, space | address >> 16 << 8);
    write(controller::reg_load_address, address & 0xffff);
    for (const std::uint16_t word : data) write(controller::reg_load_data, word);
  }
  void load1(int space, int address, int word) {
    load(space, address, {static_cast<std::uint16_t>(word)});
  }
  void setup(int address, int value) { load1(controller::space_setup, address, value); }
  void setup32(int address, std::uint32_t value) {
    setup(address, static_cast<int>(value & 0xffff));
    setup(address + 1, static_cast<int>(value >> 16));
  }
  void force(int entry, int how) { write(controller::reg_force_entry, how << 8 | entry); }
  void clear_map() {
    load(controller::space_bit_map, 0, std::vector<std::uint16_t>(1024, 0));
    load(controller::space_word_map, 0, std::vector<std::uint16_t>(472, 0));
  }
  void clear_devices() {
    load(controller::space_bits, 0,
         std::vector<std::uint16_t>(static_cast<std::size_t>(config().bit_devices), 0));
    load(controller::space_words, 0,
         std::vector<std::uint16_t>(static_cast<std::size_t>(config().word_devices), 0));
  }

  void load_steps(const std::vector<isa::SlotInstruction>& steps) {
    for (std::size_t i = 0; i < steps.size(); ++i) load_step(static_cast<int>(i), steps[i]);
    load1(controller::space_length, 0, static_cast<int>(steps.size()));
  }
  void load_image(const image::Image& image) {
    for (std::size_t i = 0; i < image.steps.size(); ++i) {
      load_step(static_cast<int>(i), image.steps[i][0]);
    }
    for (std::size_t row = 0; row < image.lut.size(); ++row) {
      load1(controller::space_lut, static_cast<int>(row), image.lut[row]);
    }
    for (const image::ImageConstant& each : image.constants) {
      load1(controller::space_words, each.address, static_cast<std::uint16_t>(each.value));
    }
    load1(controller::space_ports, 0, image.port_words << 8 | image.port_bits);
    load1(controller::space_length, 0, static_cast<int>(image.steps.size()));
  }
  // Latch entries from 0 on, refresh entries behind them.
  void load_io(const std::vector<IoEntry>& latch, const std::vector<IoEntry>& refresh) {
    int at = 0;
    for (const auto* list : {&latch, &refresh}) {
      for (const IoEntry& entry : *list) {
        load(controller::space_io, 2 * at++,
             {static_cast<std::uint16_t>(entry.device),
              static_cast<std::uint16_t>((entry.word ? 0x8000 : 0) | entry.kind << 8 |
                                         entry.index)});
      }
    }
    setup(controller::setup_latch_count, static_cast<int>(latch.size()));
    setup(controller::setup_refresh_first, static_cast<int>(latch.size()));
    setup(controller::setup_refresh_count, static_cast<int>(refresh.size()));
  }

  // ---- exchange ----
  void post(const ExchangeRequest& request) {
    std::vector<std::uint16_t> words(request.words ? 0 : (request.data.size() + 15) / 16);
    if (request.words) words = request.data;
    for (std::size_t i = 0; !request.words && i < request.data.size(); ++i) {
      words[i / 16] |= static_cast<std::uint16_t>((request.data[i] & 1) << i % 16);
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      write_at(controller::micro_exchange_buffer + static_cast<int>(i), words[i]);
    }
    write(controller::reg_exchange_write_first, request.write_first);
    write(controller::reg_exchange_write_count, static_cast<int>(request.data.size()));
    write(controller::reg_exchange_read_first, request.read_first);
    write(controller::reg_exchange_read_count, request.read_count);
    write(controller::reg_exchange_control, (request.data.empty() ? 0 : 1) |
                                                (request.read_count > 0 ? 2 : 0) |
                                                (request.words ? 4 : 0) | (request.raw ? 8 : 0));
  }
  bool pending() { return (read(controller::reg_exchange_status) & 1) != 0; }
  void wait_exchange() {
    for (int i = 0; i < 1000000; ++i) {
      if (!pending()) return;
    }
    throw std::runtime_error("the exchange does not end");
  }
  std::vector<std::uint16_t> answer(bool words, int count) {
    std::vector<std::uint16_t> result;
    const int stored = words ? count : (count + 15) / 16;
    for (int i = 0; i < stored; ++i) {
      const std::uint16_t word = read_at(controller::micro_exchange_buffer + 128 + i);
      if (words) {
        result.push_back(word);
        continue;
      }
      for (int bit = 0; bit < 16; ++bit) {
        const bool value = (word >> bit & 1) != 0;
        if (16 * i + bit < count) {
          result.push_back(value ? 1 : 0);
        } else {
          EXPECT_FALSE(value) << "an unused bit of the last word";
        }
      }
    }
    return result;
  }
  std::vector<std::uint16_t> exchange(const ExchangeRequest& request) {
    post(request);
    wait_exchange();
    return answer(request.words, request.read_count);
  }
  std::uint16_t device_word(int address) {
    ExchangeRequest request;
    request.words = request.raw = true;
    request.read_first = address;
    request.read_count = 1;
    return exchange(request)[0];
  }
  bool device_bit(int address) {
    ExchangeRequest request;
    request.raw = true;
    request.read_first = address;
    request.read_count = 1;
    return exchange(request)[0] != 0;
  }
  void poke(bool word, int address, std::uint16_t value) {
    ExchangeRequest request;
    request.words = word;
    request.raw = true;
    request.write_first = address;
    request.data = {value};
    exchange(request);
  }

 private:
  void load_step(int step, const isa::SlotInstruction& instruction) {
    const int bits = isa::slot_bits(isa::Mpu::Mpu2, config());
    const std::uint64_t code = isa::encode(instruction, isa::Mpu::Mpu2, config());
    std::vector<std::uint16_t> chunks;
    for (int bit = 0; bit < bits; bit += 16) {
      chunks.push_back(static_cast<std::uint16_t>(code >> bit));
    }
    load(controller::space_steps, step * 8, chunks);
  }

  Clocked<Vcontroller_bus> dut_{7};
};

}  // namespace rung::tb
