// SPDX-License-Identifier: Apache-2.0
// The values that a scan starts with, which both sides read: a variable for each bit of each
// device.
#pragma once

#include <compare>
#include <map>
#include <span>
#include <utility>

#include "prove/terms.hpp"

namespace rung::prove {

struct Place {
  bool word = false;
  int address = 0;
  auto operator<=>(const Place&) const = default;
};

class Start {
 public:
  explicit Start(Terms& terms) : terms_(terms) {}

  // What is at `place`; of a bit only bit 0 counts.
  const Word& at(Place place);

  // From now on, and so before it is asked for: it holds this in every scan.
  void fix(Place place, const Word& value) { values_[place] = value; }

  // The place that a variable is a bit of, or null: it is a value that nothing defines.
  const std::pair<Place, std::size_t>* owner(NodeId variable) const;

 private:
  Terms& terms_;
  std::map<Place, Word> values_;
  std::map<NodeId, std::pair<Place, std::size_t>> owners_;
};

// The value at `address` among `values`, which lie side by side from `first` on: `inside` and what
// is there.
struct Selected {
  Bit inside = kFalse;
  Word value;
};
Selected select(Terms& terms, const Word& address, int first, std::span<const Word> values);

}  // namespace rung::prove
