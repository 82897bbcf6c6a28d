// SPDX-License-Identifier: Apache-2.0
// The ladder in a terminal: characters instead of lines, the same run behind it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trace/stimulus.hpp"
#include "view/session.hpp"

namespace rung::view {

struct TextStyle {
  bool color = false;  // escape sequences for what has power
};
// The whole ladder as lines of text, with the values as they are. `rung_of` gives for each line its
// rung, -1 for none.
std::vector<std::string> ladder_text(const Run& run, TextStyle style,
                                     std::vector<int>* rung_of = nullptr);

// Where standard output is a terminal: until its user leaves. Else it runs `scans` scans, by
// `stimulus` if there is one, and prints the ladder. The exit code.
int show_in_terminal(std::unique_ptr<Run> run, std::optional<std::uint64_t> scans,
                     const std::optional<Stimulus>& stimulus);

}  // namespace rung::view
