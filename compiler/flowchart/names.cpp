// SPDX-License-Identifier: Apache-2.0
#include "flowchart/names.hpp"

#include <fmt/format.h>

#include <vector>

#include "source/nearest.hpp"

namespace rung::flowchart {
namespace {

// The search for a near name takes time, and a wrong file may have many of both.
constexpr std::size_t kMostToSearch = 2500;

}  // namespace

void Names::declare(const Token& name) {
  const auto [found, is_new] = names_.try_emplace(name.text, Declared{size_++, name.position.line});
  if (is_new) return;
  throw Refusal{name.position,
                fmt::format("{}: a {} of this name is declared in line {} already", shown(name),
                            what_, found->second.line),
                "give it another name"};
}

std::optional<std::size_t> Names::index(std::string_view name) const {
  const auto found = names_.find(name);
  if (found == names_.end()) return std::nullopt;
  return found->second.index;
}

std::size_t Names::find(const Token& name) const {
  if (const auto found = index(name.text)) return *found;
  std::vector<std::string_view> all;
  // Names of one or two letters are all near to each other.
  if (names_.size() <= kMostToSearch && name.text.size() > 2) {
    for (const auto& [each, declared] : names_) all.push_back(each);
  }
  const std::string_view near = nearest(std::string_view(name.text).substr(0, 60), all);
  throw Refusal{name.position, fmt::format("{}: no {} has this name", shown(name), what_),
                near.empty() ? fmt::format("declare it with a line `{} {}`", what_,
                                           shown(name) + (what_ == "board" ? " = ..." : ""))
                             : fmt::format("did you mean {}?", near)};
}

}  // namespace rung::flowchart
