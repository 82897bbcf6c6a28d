// SPDX-License-Identifier: Apache-2.0
// What both assemblers begin with: the address of every device, and the fields of a word operation.
#pragma once

#include <map>

#include "image/image.hpp"

namespace rung::image {

// Devices that the program names first, hidden ones after them, each by kind and number: so the
// devices of a window lie together, in order.
class Addresses {
 public:
  Addresses(const Program& source, const core::Program& program);

  std::uint16_t of(Device device) const { return static_cast<std::uint16_t>(devices_.at(device)); }
  int bits() const { return bits_; }
  int words() const { return words_; }
  const std::map<Device, int>& devices() const { return devices_; }

 private:
  std::map<Device, int> devices_;
  int bits_ = 0;
  int words_ = 0;
};

// An image without instructions.
Image start_image(const Program& source, const core::Program& program, const Addresses& addresses,
                  const isa::Config& config, isa::Mpu mpu);

// Fields of a word operation from its two sources; one of them is a device, but for MV, which has
// only the second.
void set_sources(isa::SlotInstruction& out, const core::WordSource& first,
                 const core::WordSource& second, const Addresses& addresses);

}  // namespace rung::image
