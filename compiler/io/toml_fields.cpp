// SPDX-License-Identifier: Apache-2.0
#include "io/toml_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "source/nearest.hpp"
#include "source/text_file.hpp"

namespace rung::io {

SourcePosition position_of(const toml::source_region& region) {
  if (region.begin.line == 0) return {};
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

void Fields::only(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::vector<std::string_view> names(known);
    const std::string_view near = nearest(name, names);
    diagnostics_.error(file_, position_of(key.source()),
                       fmt::format("{}: {} does not have this key", shown(name), where_),
                       near.empty() ? fmt::format("it may have: {}", fmt::join(names, ", "))
                                    : fmt::format("did you mean {}?", near));
  }
}

SourcePosition Fields::position(std::string_view key) const {
  for (const auto& [each, node] : table_) {
    if (each.str() == key) return position_of(each.source());
  }
  return position_of(table_.source());
}

void Fields::error(std::string_view key, const std::string& what, std::string mend) const {
  diagnostics_.error(file_, position(key), fmt::format("{}: {}", key, what), std::move(mend));
}

std::optional<std::int64_t> Fields::integer(std::string_view key, std::int64_t least,
                                            std::int64_t most) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const auto* value = node->as_integer();
  if (value == nullptr || value->get() < least || value->get() > most) {
    error(key, "this is no whole number in its range",
          fmt::format("write a number from {} to {}", least, most));
    return std::nullopt;
  }
  return value->get();
}

std::optional<bool> Fields::flag(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = node->as_boolean()) return value->get();
  error(key, "this is neither true nor false", "write true or false");
  return std::nullopt;
}

std::optional<std::string> Fields::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = node->as_string()) return value->get();
  error(key, "this is no text", "write it in quotes: \"...\"");
  return std::nullopt;
}

std::optional<std::int64_t> Fields::milliseconds(std::string_view key, std::int64_t most_us) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<double> value = node->value<double>();
  const double us = value.value_or(-1) * 1000;
  if (!node->is_number() || !(us >= 0) || us > static_cast<double>(most_us) ||
      std::abs(us - std::round(us)) > 1e-6) {
    error(key, "this is no number of milliseconds in its range",
          fmt::format("write a number from 0 to {} with at most three decimals", most_us / 1000));
    return std::nullopt;
  }
  return std::llround(us);
}

const toml::table* Fields::table(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return nullptr;
  if (const auto* table = node->as_table()) return table;
  error(key, "this is no table", fmt::format("write [{}] and its keys on the lines below", key));
  return nullptr;
}

}  // namespace rung::io
