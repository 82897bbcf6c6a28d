// SPDX-License-Identifier: Apache-2.0
// What both assemblers begin with: the address of every device, and the fields of a word operation.
#pragma once

#include <map>

#include "image/image.hpp"

namespace rung::image {

// Devices that the program names first, hidden ones after them, each by kind and number: so the
// devices of a window lie together, in order. Device ports have places of their own at the end of
// the configuration's memories.
class Addresses {
 public:
  Addresses(const Program& source, const core::Program& program, const isa::Config& config);

  std::uint16_t of(Device device) const { return static_cast<std::uint16_t>(devices_.at(device)); }
  // Devices that are no ports.
  int bits() const { return bits_; }
  int words() const { return words_; }
  // Port bits and words from the first up to the highest that the program uses.
  int port_bits() const { return port_bits_; }
  int port_words() const { return port_words_; }
  const std::map<Device, int>& devices() const { return devices_; }

 private:
  std::map<Device, int> devices_;
  int bits_ = 0;
  int words_ = 0;
  int port_bits_ = 0;
  int port_words_ = 0;
};

// An image without instructions.
Image start_image(const Program& source, const core::Program& program, const Addresses& addresses,
                  const isa::Config& config, isa::Mpu mpu);

// Fields of a word operation from its two sources; one of them is a device, but for MV, which has
// only the second.
void set_sources(isa::SlotInstruction& out, const core::WordSource& first,
                 const core::WordSource& second, const Addresses& addresses);

}  // namespace rung::image
