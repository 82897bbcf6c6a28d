// SPDX-License-Identifier: Apache-2.0
#include "machine.hpp"

#include <gtest/gtest.h>

#include "firmware_config.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
constexpr std::uint64_t kAccessesPerMillisecond = 64;

std::uint32_t crc32(std::uint32_t crc, std::uint8_t byte) {
  crc = ~crc ^ byte;
  for (int i = 0; i < 8; ++i) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  return ~crc;
}

}  // namespace

Machine::Machine(Flash& flash)
    : bits(kBitDevices),
      words(kWordDevices),
      bit_map(kBitPoints),
      word_map(kWordPoints),
      io(512),
      flash_(flash) {
  flash_.power_up();
  // What memories hold at power-up is not 0.
  for (auto* memory : {&bits, &words, &bit_map, &word_map, &io, &setup}) {
    for (std::size_t i = 0; i < memory->size(); ++i)
      (*memory)[i] = memory == &bits ? i & 1U : 0xA5A5;
  }
}

// What the frames before have left behind it stays.
void Machine::receive(const Bytes& frame) {
  for (std::size_t i = 0; i < frame.size(); ++i) rx_.at(i) = frame[i];
  length_ = static_cast<int>(frame.size());
  waiting = true;
}

std::uint16_t Machine::status() {
  if (scans_under_way > 0 && --scans_under_way == 0) {
    if (state != 3) state = 0;
    ++stops;
  }
  const bool idle = state == 0;
  return static_cast<std::uint16_t>(state | (idle ? 4 : 0) | (run_switch ? 8 : 0) |
                                    (next_is_first ? 16 : 0) | fault << 8);
}

std::uint16_t Machine::read(std::uint16_t address) {
  if (++accesses > budget) throw Hang{};
  if (address >= c::micro_registers) return read_register(address - c::micro_registers);
  if (address >= c::micro_exchange_buffer) return buffer_.at(address - c::micro_exchange_buffer);
  if (address >= c::micro_tx_frame) {
    ADD_FAILURE() << "tx_frame is not there to be read";
    return 0;
  }
  return rx_.at(address - c::micro_rx_frame);
}

void Machine::write(std::uint16_t address, std::uint16_t value) {
  if (++accesses > budget) throw Hang{};
  if (address >= c::micro_registers) {
    write_register(address - c::micro_registers, value);
  } else if (address >= c::micro_exchange_buffer) {
    buffer_.at(address - c::micro_exchange_buffer) = value;
  } else {
    ASSERT_GE(address, c::micro_tx_frame);
    EXPECT_LE(value, 255) << "bytes only";
    EXPECT_EQ(sending, 0) << "tx_frame changed while it is sent";
    tx_.at(address - c::micro_tx_frame) = value;
  }
}

namespace {

bool of_flow(int number) {
  const int n = number - flow::reg_flow_pc_resource;
  return kFlow && n >= 0 && n < flow::holding_flow_count;
}

}  // namespace

std::uint16_t Machine::read_register(int number) {
  const auto wide = [&](std::uint32_t value) {
    held_ = static_cast<std::uint16_t>(value >> 16U);
    return static_cast<std::uint16_t>(value);
  };
  switch (number) {
    case c::reg_line_status: {
      const bool busy = sending > 0;
      if (busy) --sending;
      return static_cast<std::uint16_t>((waiting ? 1 : 0) | (busy ? 2 : 0));
    }
    case c::reg_line_length:
      return static_cast<std::uint16_t>(length_);
    case c::reg_line_bad_crc:
      return bad_crc;
    case c::reg_line_bad_byte:
      return 12;
    case c::reg_line_lost:
      return 13;
    case c::reg_flash_data:
      return flash_in_;
    case c::reg_flash_busy:
      return flash_busy_ > 0 ? flash_busy_--, 1 : 0;
    case c::reg_crc_low:
      return static_cast<std::uint16_t>(crc_);
    case c::reg_crc_high:
      return static_cast<std::uint16_t>(crc_ >> 16U);
    case c::reg_exchange_status:
      if (state == 3) return 1;
      return exchange_busy_ > 0 ? (exchange_busy_ -= exchange_offered ? 1 : 0, 1) : 0;
    case c::reg_scan_status:
      return status();
    case c::reg_scan_count_low:
      return wide(0x00120034);
    case c::reg_scan_last_low:
      return wide(0x00560078);
    case c::reg_scan_min_low:
      return wide(0x009A00BC);
    case c::reg_scan_max_low:
      return wide(0x00DE00F0);
    case c::reg_scan_count_high:
    case c::reg_scan_last_high:
    case c::reg_scan_min_high:
    case c::reg_scan_max_high:
      return held_;
    case c::reg_scan_overruns:
      return overruns;
    case c::reg_milliseconds:
      return static_cast<std::uint16_t>(accesses / kAccessesPerMillisecond + milliseconds_offset);
    case c::reg_keep_status:
      return keep_wanted ? 1 : 0;
    case c::reg_keep_index:
      return 0;
    case c::reg_keep_value:
      return 0;
    case c::reg_board_id:
      return board;
    case c::reg_config_id:
      return static_cast<std::uint16_t>(config_id());
    case c::reg_mpu:
      return mpu;
    case c::reg_flash_base:
      return 1;
    default:
      break;
  }
  if (of_flow(number)) return flow_registers.at(number - flow::reg_flow_pc_resource);
  if (number >= c::reg_inputs && number < c::reg_outputs + 4)
    return static_cast<std::uint16_t>(0x1100 + number);
  ADD_FAILURE() << "read of register " << number;
  return 0;
}

void Machine::write_register(int number, std::uint16_t value) {
  written_.at(number) = value;
  switch (number) {
    case c::reg_line_take:
      EXPECT_TRUE(waiting) << "nothing to take";
      waiting = false;
      return;
    case c::reg_line_send:
      EXPECT_EQ(sending, 0);
      EXPECT_GE(value, 1);
      EXPECT_LE(value, 254);
      sent.emplace_back(tx_.begin(), tx_.begin() + value);
      sending = 3;
      return;
    case c::reg_flash_select:
      flash_.select((value & 1U) != 0);
      return;
    case c::reg_flash_data:
      EXPECT_EQ(flash_busy_, 0);
      flash_in_ = flash_.transfer(static_cast<std::uint8_t>(value));
      flash_busy_ = 1;
      return;
    case c::reg_crc_clear:
      crc_ = 0;
      return;
    case c::reg_crc_byte:
      crc_ = crc32(crc_, static_cast<std::uint8_t>(value));
      return;
    case c::reg_load_space:
      load_space_ = value & 15;
      load_place_ = (load_place_ & 0xFFFFU) | static_cast<std::uint32_t>(value >> 8 & 15) << 16U;
      return;
    case c::reg_load_address:
      load_place_ = (load_place_ & 0xF0000U) | value;
      return;
    case c::reg_load_data:
      load_data(value);
      return;
    case c::reg_exchange_control:
      exchange(value);
      return;
    case c::reg_scan_command:
      if (value == 1 && state == 0) state = 1;
      if (value == 2 && state == 1 && scans_under_way == 0) scans_under_way = 3;
      if (value == 3 && state == 0) {
        state = 2;
        scans_under_way = 5;
      }
      if (value == 4) overruns = 0;
      if (value == 5 && state == 3) state = fault = 0;
      if (state == 1 && value == 1) next_is_first = false;
      return;
    case c::reg_scan_first:
      next_is_first = true;
      ++first_scans;
      return;
    case c::reg_fault_set:
      state = 3;
      fault = 2;
      return;
    case c::reg_force_entry:
      forces.at(value & 255) = value >> 8;
      return;
    case c::reg_keep_done:
      keep_ready = (value & 1U) != 0;
      if (keep_ready) keep_wanted = false;
      return;
    default:
      break;
  }
  if (number >= c::reg_line_baud_low && number <= c::reg_line_silence_high) {
    EXPECT_EQ(sending, 0) << "line set anew while an answer goes out";
    line_settings[static_cast<std::uint16_t>(number)] = value;
    return;
  }
  if (of_flow(number)) {
    flow_registers.at(number - flow::reg_flow_pc_resource) = value;
    return;
  }
  EXPECT_TRUE(number >= c::reg_exchange_write_first && number <= c::reg_exchange_or) << number;
}

void Machine::load_data(std::uint16_t value) {
  const std::uint32_t place = load_place_;
  load_place_ = (load_place_ + 1) & 0xFFFFFU;
  if (load_space_ <= c::space_ports && state != 0) ++loads_while_running;
  const auto put = [&](Words& memory) { memory.at(place) = value; };
  switch (load_space_) {
    case c::space_steps:
      steps[static_cast<int>(place)] = value;
      return;
    case c::space_lut:
      return;
    case c::space_bits:
      EXPECT_LE(value, 1);
      return put(bits);
    case c::space_words:
      return put(words);
    case c::space_length:
      steps_count = value;
      return;
    case c::space_ports:
      if (place == 0) ports = value;
      return;
    case c::space_io:
      return put(io);
    case c::space_bit_map:
      return put(bit_map);
    case c::space_word_map:
      return put(word_map);
    case c::space_setup:
      return put(setup);
    default:
      if (kFlow && load_space_ >= flow::space_flow_steps) {
        flow_spaces[load_space_][static_cast<int>(place)] = value;
        return;
      }
      ADD_FAILURE() << "load space " << load_space_;
  }
}

std::uint16_t* Machine::device(bool of_words, bool raw, int point) {
  Words& memory = of_words ? words : bits;
  if (raw) return &memory.at(point);
  const std::uint16_t entry = (of_words ? word_map : bit_map).at(point);
  nowhere_ = 0;
  return (entry & 0x8000U) != 0 ? &memory.at(entry & 0x7FFFU) : &nowhere_;
}

void Machine::exchange(std::uint16_t control) {
  EXPECT_EQ(exchange_busy_, 0);
  ++exchanges;
  exchange_busy_ = 2;
  const bool of_words = (control & 4U) != 0;
  const bool raw = (control & 8U) != 0;
  const int to = written_[c::reg_exchange_write_first];
  const int to_count = (control & 1U) != 0 ? written_[c::reg_exchange_write_count] : 0;
  const int from = written_[c::reg_exchange_read_first];
  const int from_count = (control & 2U) != 0 ? written_[c::reg_exchange_read_count] : 0;
  if (to_count + from_count > setup[c::setup_exchange_points]) ++points_too_many;
  if ((control & 16U) != 0) {
    std::uint16_t& word = *device(true, raw, to);
    const std::uint16_t mask = written_[c::reg_exchange_and];
    word = static_cast<std::uint16_t>((word & mask) | (written_[c::reg_exchange_or] & ~mask));
    return;
  }
  for (int i = 0; i < to_count; ++i) {
    *device(of_words, raw, to + i) = of_words ? buffer_.at(i) : buffer_.at(i / 16) >> (i % 16) & 1U;
  }
  for (int i = 0; i < from_count; ++i) {
    const std::uint16_t value = *device(of_words, raw, from + i);
    std::uint16_t& out = buffer_.at(128 + (of_words ? i : i / 16));
    if (of_words || i % 16 == 0) out = 0;
    out = static_cast<std::uint16_t>(out | (of_words ? value : value << (i % 16)));
  }
}

}  // namespace rung::tb
