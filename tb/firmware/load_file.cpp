// SPDX-License-Identifier: Apache-2.0
#include "load_file.hpp"

#include <zlib.h>

#include <stdexcept>

#include "firmware_config.hpp"

namespace rung::tb {

namespace c = controller;

LoadFile::LoadFile() : config(static_cast<std::uint16_t>(config_id())) {}

LoadFile& LoadFile::record(int space, int address, const Words& data) {
  records_.push_back(static_cast<std::uint16_t>(space << 12 | (address >> 16) << 8 |
                                                static_cast<int>(data.size())));
  records_.push_back(static_cast<std::uint16_t>(address));
  records_.insert(records_.end(), data.begin(), data.end());
  return *this;
}

LoadFile& LoadFile::steps(const Words& data) { return record(c::space_steps, 0, data); }

LoadFile& LoadFile::keep(int n, std::uint16_t flags, std::uint16_t first, std::uint16_t count) {
  return at(c::space_keep, 4 * n, flags)
      .at(c::space_keep, 4 * n + 1, first)
      .at(c::space_keep, 4 * n + 2, count);
}

Words LoadFile::words() const {
  Words out(16);
  const auto put = [&](const std::pair<int, int>& place, std::uint16_t value) {
    out.insert(out.end(),
               {static_cast<std::uint16_t>(place.first << 12 | (place.second >> 16) << 8 | 1),
                static_cast<std::uint16_t>(place.second), value});
  };
  out.insert(out.end(), records_.begin(), records_.end());
  for (const auto& [place, value] : values_) {
    if (place.first != c::space_length) put(place, value);
  }
  for (const auto& [place, value] : values_) {
    if (place.first == c::space_length) put(place, value);
  }
  out.push_back(0);
  const std::uint16_t header[] = {magic,
                                  format,
                                  tables,
                                  config,
                                  board,
                                  mpu,
                                  static_cast<std::uint16_t>(out.size()),
                                  static_cast<std::uint16_t>(out.size() >> 16U),
                                  retain_id,
                                  0,
                                  chunks};
  for (std::size_t i = 0; i < std::size(header); ++i) out[i] = header[i];
  return out;
}

std::uint32_t crc_of(const Words& words) {
  Bytes bytes;
  for (const std::uint16_t word : words) {
    bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(word));
  }
  return static_cast<std::uint32_t>(crc32(0, bytes.data(), static_cast<unsigned>(bytes.size())));
}

Place area(std::string_view name) {
  for (const auto& row : c::areas) {
    if (row.config == kConfig && row.name == name) return {row.first, row.count, row.index};
  }
  throw std::runtime_error("no such area");
}

LoadFile sample_program(std::uint16_t mark) {
  LoadFile file;
  file.steps({mark, 1, 2, 3, 4, 5, 6, 7, mark});
  for (int n = 0; n < 8; ++n) {
    const auto device = [n](int first) { return static_cast<std::uint16_t>(0x8000 | (first + n)); };
    file.at(c::space_bit_map, area("M").index + n, device(0));
    file.at(c::space_bit_map, area("Y").index + n, device(100));
    file.at(c::space_bit_map, area("X").index + n, device(200));
    file.at(c::space_word_map, area("D").index + n, device(0));
    file.at(c::space_io, 2 * n, static_cast<std::uint16_t>(200 + n));
    file.at(c::space_io, 2 * n + 1, static_cast<std::uint16_t>(c::latch_pin << 8 | n));
    file.at(c::space_io, 16 + 2 * n, static_cast<std::uint16_t>(100 + n));
    file.at(c::space_io, 16 + 2 * n + 1, static_cast<std::uint16_t>(c::refresh_pin << 8 | n));
  }
  file.at(c::space_setup, c::setup_latch_count, 8);
  file.at(c::space_setup, c::setup_refresh_first, 8);
  file.at(c::space_setup, c::setup_refresh_count, 8);
  file.at(c::space_setup, c::setup_exchange_points, 2000);
  file.at(c::space_words, 7, mark);
  file.at(c::space_ports, 0, 3 | 19 << 8);
  file.keep(0, 3, 2, 4).keep(1, 2, 2, 5).keep(2, 0, 7, 1);
  file.at(c::space_host, c::host_unit, 17);
  file.at(c::space_host, c::host_retain_id, file.retain_id);
  file.at(c::space_length, 0, 3);
  return file;
}

}  // namespace rung::tb
