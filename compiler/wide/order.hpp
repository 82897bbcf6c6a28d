// SPDX-License-Identifier: Apache-2.0
// What must come before what: items are look-ups that stand alone, and groups with all of theirs.
#pragma once

#include <map>
#include <vector>

#include "wide/work.hpp"

namespace rung::wide {

struct Order {
  int items = 0;
  std::vector<std::int32_t> item_of_look_up, item_of_group;
  // By item: those that use a result of it, each once.
  std::vector<std::vector<std::int32_t>> users;
  // By device that has a home: the items that read what it holds at the start of the scan. They
  // must do so before its home is written; the home's own item is not among them.
  std::map<Device, std::vector<std::int32_t>> start_readers;

  std::int32_t home_item(const Work& work, Device device) const;
};

Order make_order(const Work& work, const values::Values& values);

// Where a device's home is computed before somebody can read the old value, because that somebody
// needs what is computed, the home becomes a copy of it, made later. After this the order of
// make_order, with all readers of a start before its home, has no circle.
void untangle(Work& work, const values::Values& values);

}  // namespace rung::wide
