// SPDX-License-Identifier: Apache-2.0
#include "programs/ldmicro_corpus.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "ldmicro/ldmicro.hpp"
#include "source/text_file.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

constexpr LdmicroDeviation kDeviations[] = {
    {"probes/div0",
     "a division by zero: the simulator stops in scan 1; here the target keeps its value, the "
     "error "
     "flag is set, and the scans go on",
     1},
};

LdmicroSample sample(std::string name, const fs::path& program, const fs::path& stimulus,
                     const fs::path& trace) {
  LdmicroSample found{std::move(name), program.string(), {}, {}};
  if (fs::exists(stimulus) && fs::exists(trace)) {
    found.stimulus = stimulus.string();
    found.trace = trace.string();
  }
  return found;
}

template <typename Value>
void take(std::optional<Value> read, Value& target) {
  if (read) target = std::move(*read);
}

}  // namespace

std::vector<LdmicroSample> ldmicro_samples(const std::string& shared) {
  std::vector<LdmicroSample> samples;
  const fs::path folder = fs::path(shared) / "programs/ldmicro";
  if (!fs::is_directory(folder)) return samples;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& program = entry.path();
    if (program.extension() != ".ld") continue;
    // A program has a folder of its own, or its name in common with the other two files.
    const bool own = program.filename() == "prog.ld";
    const fs::path about = own ? program.parent_path() : fs::path(program).replace_extension();
    const std::string name = about.lexically_relative(folder).generic_string();
    samples.push_back(
        own ? sample(name, program, about / "stim.txt", about / "trace.txt")
            : sample(name, program, about.string() + ".stim", about.string() + ".trace"));
  }
  std::sort(samples.begin(), samples.end(),
            [](const auto& left, const auto& right) { return left.name < right.name; });
  return samples;
}

std::span<const LdmicroDeviation> ldmicro_deviations() { return kDeviations; }

LdmicroCase load_ldmicro(const LdmicroSample& sample) {
  LdmicroCase loaded;
  Diagnostics diagnostics;
  if (const auto bytes = read_bytes(sample.program, diagnostics)) {
    if (const auto text = decode_ldmicro(*bytes, sample.program, diagnostics)) {
      loaded.program = parse_ldmicro(*text, diagnostics);
    }
  }
  if (loaded.program && !sample.trace.empty()) {
    if (const auto text = read_text(sample.stimulus, diagnostics)) {
      take(parse_stimulus(*text, *loaded.program, diagnostics), loaded.stimulus);
    }
    if (const auto bytes = read_bytes(sample.trace, diagnostics)) {
      take(read_ldmicro_trace(*bytes, sample.trace, diagnostics), loaded.trace);
    }
    if (diagnostics.has_errors()) loaded.program.reset();
  }
  std::ostringstream messages;
  diagnostics.print(messages);
  loaded.messages = messages.str();
  return loaded;
}

std::optional<TraceDifference> compare_ldmicro(
    const LdmicroCase& ldmicro,
    const std::function<TraceScan(std::span<const StimulusEvent>)>& scan) {
  for (std::size_t k = 0; k < ldmicro.trace.scans.size(); ++k) {
    const auto difference = compare_shown(ldmicro.trace.scans[k], scan(ldmicro.stimulus.events(k)));
    if (difference) return difference;
  }
  return std::nullopt;
}

}  // namespace rung
