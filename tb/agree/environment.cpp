// SPDX-License-Identifier: Apache-2.0
#include "agree/environment.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace rung::tb {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::vector<Family> families_of_environment() {
  std::vector<Family> families;
  const char* text = std::getenv("RUNG_FAMILIES");
  if (text == nullptr) return families;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    const std::optional<Family> family = find_family(name);
    EXPECT_TRUE(family) << "RUNG_FAMILIES: no family " << name;
    if (family) families.push_back(*family);
  }
  return families;
}

std::string replay_families() {
  const char* const families = std::getenv("RUNG_FAMILIES");
  return families == nullptr ? "" : fmt::format("RUNG_FAMILIES={} ", families);
}

}  // namespace rung::tb
