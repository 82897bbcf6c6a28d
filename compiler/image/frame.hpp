// SPDX-License-Identifier: Apache-2.0
// What images are put together from: the address of every device, the rows of the LUT, and routines
// that either assembler has made with them.
#pragma once

#include <map>
#include <set>

#include "image/image.hpp"
#include "image/meaning.hpp"

namespace rung::image {

// Devices that the program names first, hidden ones after them, each by kind and number: so the
// devices of a window lie together, in order. Device ports have places of their own at the end of
// the configuration's memories.
class Addresses {
 public:
  Addresses(const Program& source, const core::Program& program, const isa::Config& config);
  Addresses(const std::set<Device>& devices, const isa::Config& config);

  // Of one of several routines: `own` before the addresses that are common to all. `common` stays.
  Addresses(const Addresses& common, std::map<Device, int> own);

  std::uint16_t of(Device device) const;
  // Devices that are no ports.
  int bits() const { return bits_; }
  int words() const { return words_; }
  // Port bits and words from the first up to the highest that the program uses.
  int port_bits() const { return port_bits_; }
  int port_words() const { return port_words_; }
  const std::map<Device, int>& devices() const { return devices_; }

 private:
  const Addresses* common_ = nullptr;
  std::map<Device, int> devices_;
  int bits_ = 0;
  int words_ = 0;
  int port_bits_ = 0;
  int port_words_ = 0;
};

// Rows of the LUT, which all routines of an image share: each function has one.
class Rows {
 public:
  std::uint8_t of(const mapping::MappedOp& op);
  const std::vector<std::uint8_t>& lut() const { return lut_; }
  int used() const { return static_cast<int>(used_.size()); }
  // If not, what of() gave was none.
  bool fit() const { return lut_.size() <= isa::constant::lut_rows; }

 private:
  std::vector<std::uint8_t> lut_;
  std::set<int> used_;
};

// Straight-line code from its first step to its last.
struct Routine {
  std::vector<std::vector<isa::SlotInstruction>> steps;
  std::vector<std::vector<int>> origins;  // indices into its own source's instructions, or -1
  std::vector<std::vector<std::uint8_t>> quiet;
  int lookups = 0;
  std::int64_t clocks = 0;  // from start to done, the pipeline's filling included
};

// MPU1: the core instructions one after the other, each in as many steps as it takes.
Routine assemble_routine(const core::Program& program, const Addresses& addresses,
                         const isa::Config& config);
// MPU2 and MPU3: a schedule with addresses. Temporary bits lie behind the devices.
Routine assemble_routine(const core::Program& program, const mapping::Mapping& mapping,
                         const schedule::Schedule& schedule,
                         const schedule::Temporaries& temporaries, const Addresses& addresses,
                         Rows& rows, const isa::Config& config);

// Behind what is there, its origins counted from `first_origin` on in the image's source.
void append(Image& image, const Routine& routine, int first_origin);

// An image without instructions.
Image start_image(const Program& source, const core::Program& program, const Addresses& addresses,
                  const isa::Config& config, isa::Mpu mpu);

// What a routine is to do, for a check of the image; where it stands is the caller's to say.
Meaning meaning(const Program& source, const core::Program& program, std::map<Device, int> places);

// The source's lines, counts and what it asks of the controller around it.
void describe_source(const Program& source, Image& image);

// Fields of a word operation from its two sources; one of them is a device, but for MV, which has
// only the second.
void set_sources(isa::SlotInstruction& out, const core::WordSource& first,
                 const core::WordSource& second, const Addresses& addresses);

}  // namespace rung::image
