// SPDX-License-Identifier: Apache-2.0
// Reads the fields of a TOML table and says what is wrong with them where they stand.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "source/diagnostics.hpp"

namespace rung::io {

SourcePosition position_of(const toml::source_region& region);

class Fields {
 public:
  // `where` is what messages call the table: "[modbus]", "X0".
  Fields(const toml::table& table, std::string where, const std::string& file,
         Diagnostics& diagnostics)
      : table_(table), where_(std::move(where)), file_(file), diagnostics_(diagnostics) {}

  // An error for each key that is not among `known`, with the nearest that is.
  void only(std::initializer_list<std::string_view> known) const;

  // The value of `key`; nothing if it is not there, or, with an error, not what was asked for.
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t least,
                                      std::int64_t most) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::string> text(std::string_view key) const;
  // Milliseconds, decimals allowed, as microseconds.
  std::optional<std::int64_t> milliseconds(std::string_view key, std::int64_t most_us) const;
  // A table of its own; an error if `key` is something else.
  const toml::table* table(std::string_view key) const;
  SourcePosition position(std::string_view key) const;
  bool has(std::string_view key) const { return table_.contains(key); }
  const toml::node* node(std::string_view key) const { return table_.get(key); }

  void error(std::string_view key, const std::string& what, std::string mend) const;

 private:
  const toml::table& table_;
  std::string where_;
  const std::string& file_;
  Diagnostics& diagnostics_;
};

}  // namespace rung::io
