// SPDX-License-Identifier: Apache-2.0
#include "melsec/suggest.hpp"

#include <vector>

#include "melsec/instructions.hpp"
#include "melsec/unsupported.hpp"
#include "source/nearest.hpp"

namespace rung {

namespace {

std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names;
  for (const std::string_view name : instruction_names()) {
    if (name.size() > 1) names.push_back(name);
  }
  names.push_back("END");
  const std::vector<std::string_view> others = unsupported_names();
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

}  // namespace

std::string_view suggest_instruction(std::string_view word) {
  // Some hundred names, which a file that is no list would ask for in every line.
  static const std::vector<std::string_view> names = all_names();
  return nearest(word, names);
}

}  // namespace rung
