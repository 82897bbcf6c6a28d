// SPDX-License-Identifier: Apache-2.0
// Where the devices of an image for MPU4 are, and what their places hold when a scan starts.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/meaning.hpp"
#include "prove/start.hpp"
#include "wide/machine.hpp"

namespace rung::prove {

// A start has a value for each device, at a number of its own: two devices that share a place need
// not be equal before a scan, and those of a window lie side by side there, which they do not in
// the rows.
class WidePlaces {
 public:
  WidePlaces(const image::Image& image, const image::Meaning& meaning,
             const wide::Machine& machine);

  // What of the image's tables is not so, or nothing: sizes, where devices, ticks and inputs are.
  std::optional<std::string> check() const;

  // By device the number that stands for it in a Start.
  const std::map<Device, int>& numbers() const { return numbers_; }
  Place in_start(Device device) const { return {is_word(device), numbers_.at(device)}; }
  Device device_at(Place in_start) const;
  std::string name(Device device) const;

  // Where it is in the rows; not of a constant, which the instructions hold.
  const std::map<Device, int>& rows() const { return meaning_.places; }

  // What the rows hold before a scan, those of the latch excepted. Where two devices are, nobody
  // knows whose value it is.
  std::map<Place, Word> memory(Start& start) const;
  // What each position of the latch gets.
  std::vector<Bit> latched(Start& start) const;

 private:
  std::optional<std::string> check_sizes() const;
  std::optional<std::string> check_named() const;
  std::optional<std::string> check_latch() const;
  bool is_latch(Device device, int address) const;

  const image::Image& image_;
  const image::WideImage& wide_;
  const image::Meaning& meaning_;
  const wide::Machine& machine_;
  std::map<Device, int> numbers_;
  std::map<Place, Device> devices_;
};

}  // namespace rung::prove
