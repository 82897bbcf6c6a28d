// SPDX-License-Identifier: Apache-2.0
// The load file (hdl/controller/README.md): what an image and its bindings become, what goes
// through the controller's window and lies in its flash.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/image.hpp"
#include "io/bind.hpp"

namespace rung::load {

// What the map is checked against, from an image.
io::Subject subject_of(const image::Image& image);

// Words of a load file. Errors when something does not fit the controller: too many inputs and
// outputs, ranges of latched devices, a rate that `clock_hz` cannot make. `clock_hz` is the clock
// of the controller: the configuration's, or a simulated one's.
std::optional<std::vector<std::uint16_t>> make(const image::Image& image,
                                               const io::Bindings& bindings, std::int64_t clock_hz,
                                               Diagnostics& diagnostics);

// Of the words, the high byte of each first: the CRC that the controller checks.
std::uint32_t crc32(const std::vector<std::uint16_t>& words);
// As a file: the high byte of each word first.
std::string to_bytes(const std::vector<std::uint16_t>& words);

// A load file taken apart.
struct Contents {
  int tables = 0;  // fingerprint
  int config_id = 0;
  int board_id = 0;
  int mpu = 0;
  int retain_id = 0;
  int chunks = 0;
  // What each (space, address) is set to.
  std::map<std::pair<int, std::uint32_t>, std::uint16_t> values;

  std::optional<std::uint16_t> at(int space, std::uint32_t address) const;
};
// Nothing, with what is wrong in `problem`, when it is not whole and well formed: its length, its
// records, addresses that no space has, an address set twice, `length` that is not last.
std::optional<Contents> read(const std::vector<std::uint16_t>& words, std::string& problem);

}  // namespace rung::load
