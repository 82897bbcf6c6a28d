// SPDX-License-Identifier: Apache-2.0
#include "source/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace rung {
namespace {

// Optimal string alignment distance.
int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1] ? 1 : 0)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> names) {
  int nearest = word.size() > 4 ? 3 : 2;
  std::string_view found;
  for (const std::string_view name : names) {
    const auto difference =
        static_cast<std::ptrdiff_t>(name.size()) - static_cast<std::ptrdiff_t>(word.size());
    if (std::abs(difference) >= nearest) continue;
    const int distance = edit_distance(word, name);
    if (distance < nearest) {
      nearest = distance;
      found = name;
    }
  }
  return found;
}

}  // namespace rung
