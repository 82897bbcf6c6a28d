// SPDX-License-Identifier: Apache-2.0
#include "flow_units/programs.hpp"

#include <stdlib.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "driver/compile_flow.hpp"
#include "flow_units/system.hpp"
#include "flowchart/read.hpp"
#include "io/map.hpp"
#include "load/latency.hpp"
#include "load/load_file.hpp"

namespace rung::tb {
namespace {

std::string text_of(const Diagnostics& diagnostics) {
  std::ostringstream text;
  diagnostics.print(text);
  return text.str();
}

template <typename T>
T require(std::optional<T> made, const std::string& what, const Diagnostics& diagnostics) {
  if (!made) throw std::runtime_error(what + " is refused:\n" + text_of(diagnostics));
  return std::move(*made);
}

}  // namespace

FlowBuilt build_flow(const std::string& file, const std::string& map_of) {
  Diagnostics diagnostics;
  const auto chart = require(flowchart::read(file, diagnostics), file, diagnostics);
  CompileOptions options;
  auto compiled = require(compile_flow(chart, options, diagnostics), file, diagnostics);
  const auto map =
      require(io::parse_map(map_of, "flow.toml", diagnostics), "the I/O map", diagnostics);
  const auto bindings = io::bind(map, load::subject_of(compiled.image), diagnostics);
  const auto clock_hz = static_cast<std::int64_t>(1000 * FlowSystem::clocks_per_ms());
  auto words =
      require(load::make(compiled.image, bindings, clock_hz, diagnostics), file, diagnostics);
  if (diagnostics.has_errors()) throw std::runtime_error(text_of(diagnostics));
  const load::Timing timing = load::timing_of(compiled.image, bindings, clock_hz);
  auto bound = load::flow_bound(compiled.image, load::phases_of(timing, compiled.image));
  return {std::move(compiled.image), std::move(words), std::move(bound)};
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "rung-flow-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Folder::put(const std::string& name, const std::string& text) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream(file) << text;
  return file.string();
}

}  // namespace rung::tb
