// SPDX-License-Identifier: Apache-2.0
// The front end of `.flow` programs; the language is on one page, compiler/FLOW.md.
#pragma once

#include <optional>
#include <string>

#include "flowchart/flowchart.hpp"
#include "source/text_file.hpp"

namespace rung::flowchart {

// Reads the program, and the ladder that it names, which is searched for beside source.file.
// Nothing, with all its errors in `diagnostics`, when it is refused.
std::optional<Flowchart> parse(const SourceText& source, Diagnostics& diagnostics);
// The same from a file; "-" is standard input.
std::optional<Flowchart> read(const std::string& path, Diagnostics& diagnostics);

}  // namespace rung::flowchart
