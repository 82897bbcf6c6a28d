// SPDX-License-Identifier: Apache-2.0
#include "prove/start.hpp"

namespace rung::prove {

const Word& Start::at(Place place) {
  const auto [found, fresh] = values_.try_emplace(place);
  if (!fresh) return found->second;
  found->second.fill(kFalse);
  for (std::size_t i = 0; i < (place.word ? 16U : 1U); ++i) {
    found->second[i] = terms_.variable();
    owners_[node_of(found->second[i])] = {place, i};
  }
  return found->second;
}

const std::pair<Place, std::size_t>* Start::owner(NodeId variable) const {
  const auto found = owners_.find(variable);
  return found == owners_.end() ? nullptr : &found->second;
}

Selected select(Terms& terms, const Word& address, int first, std::span<const Word> values) {
  // Outside of the window the value is that of its first device, and nobody asks for it.
  Selected out{kFalse, values.front()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto here = static_cast<std::uint16_t>(first + static_cast<int>(i));
    const Bit hit = terms.equal(address, Terms::constant(here));
    out.inside = terms.either(out.inside, hit);
    out.value = terms.choose(hit, values[i], out.value);
  }
  return out;
}

}  // namespace rung::prove
