// SPDX-License-Identifier: Apache-2.0
#include "prove/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rung::prove {

std::string place_name(Place place, const std::map<Place, Device>& owners,
                       const image::Image& image) {
  for (const image::ImageDevice& device : image.devices) {
    if (is_word(device.device) == place.word && device.address == place.address) return device.name;
  }
  const auto owner = owners.find(place);
  const char* kind = place.word ? "word" : "bit";
  if (owner == owners.end()) return fmt::format("the temporary at {} {}", kind, place.address);
  if (is_port(owner->second.kind)) return fmt::format("port {} {}", kind, owner->second.number);
  return fmt::format("the compiler's {} {}", kind, place.address);
}

std::string start_text(const Finding& finding, const std::function<std::string(Place)>& name) {
  constexpr std::size_t kShown = 12;
  std::string out;
  const std::size_t shown = std::min(finding.start.size(), kShown);
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [place, value] = finding.start[i];
    out += fmt::format("{} {}={}", out.empty() ? ", with" : ",", name(place),
                       place.word ? static_cast<std::int16_t>(value) : value);
  }
  if (shown < finding.start.size()) {
    out += fmt::format(" and {} more", finding.start.size() - shown);
  }
  if (finding.takes_undefined) out += ", and with a value that is not defined there";
  return out;
}

}  // namespace rung::prove
