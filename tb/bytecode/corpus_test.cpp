// SPDX-License-Identifier: Apache-2.0
// Programs that nobody here wrote, if they are there: LDmicro's against the traces of its own
// simulator, value for value; lists beside the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "bytecode/vm_engine.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/melsec.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"
#include "rungs/footprint.hpp"
#include "rungs/special.hpp"
#include "source/text_file.hpp"
#include "trace/ldmicro_trace.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

const fs::path kPrograms = fs::path(RUNG_REPOSITORY) / "../shared/programs";

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// A file of the program: beside it under its name, or in its folder under a name for all.
fs::path beside(const fs::path& program, const char* suffix, const char* name) {
  fs::path own = program;
  own.replace_extension(suffix);
  return fs::exists(own) ? own : program.parent_path() / name;
}

std::string bytes_of(const fs::path& path) {
  Diagnostics diagnostics;
  return read_bytes(path.string(), diagnostics).value_or("");
}

// True if the program was there to be compared.
bool compare_with_trace(const fs::path& path) {
  const fs::path trace_path = beside(path, ".trace", "trace.txt");
  if (!fs::exists(trace_path)) return false;
  Diagnostics diagnostics;
  const auto source = decode_ldmicro(bytes_of(path), path.string(), diagnostics);
  const auto program = source ? parse_ldmicro(*source, diagnostics) : std::nullopt;
  const auto trace = read_ldmicro_trace(bytes_of(trace_path), trace_path.string(), diagnostics);
  const fs::path stimulus_path = beside(path, ".stim", "stim.txt");
  const auto text = read_text(stimulus_path.string(), diagnostics);
  // What LDmicro refuses has a trace without scans.
  if (!program || !trace || trace->scans.empty()) return false;
  const auto stimulus = text ? parse_stimulus(*text, *program, diagnostics) : std::nullopt;
  EXPECT_TRUE(stimulus);
  if (!stimulus) return false;
  VmEngine engine(*program, program->ldmicro->cycle_us);
  for (std::size_t k = 0; k < trace->scans.size(); ++k) {
    engine.apply(stimulus->events(k));
    engine.scan();
    TraceScan got;
    got.scan = static_cast<std::int64_t>(k);
    got.tx = engine.sent();
    got.state.emplace();
    for (const Device device : visible_devices(*program)) {
      if (is_hidden(device.kind)) continue;
      got.state->push_back({device_name(device, *program), engine.value(device)});
    }
    const auto difference = compare_shown(trace->scans[k], got);
    EXPECT_FALSE(difference) << describe(*difference);
    if (difference) break;
  }
  return true;
}

TEST(Corpus, LdmicroProgramsRunAsInItsOwnSimulator) {
  if (!fs::is_directory(kPrograms / "ldmicro")) GTEST_SKIP() << "skipped: no corpus";
  int programs = 0;
  int compared = 0;
  for (const fs::path& path : files_of(kPrograms / "ldmicro")) {
    if (path.extension() != ".ld") continue;
    SCOPED_TRACE(path.string());
    ++programs;
    if (compare_with_trace(path)) ++compared;
  }
  // Three have no scans to compare: two that LDmicro refuses, and one without a trace.
  EXPECT_EQ(compared, programs - 3);
}

void compare_with_reference(const Program& program, std::uint64_t seed) {
  Reference reference(program);
  VmEngine engine(program);
  RandomSource random(seed);
  const std::vector<Device> devices = visible_devices(program);
  for (int scan = 0; scan < 300; ++scan) {
    std::vector<StimulusEvent> events;
    for (const Device device : named_devices(program)) {
      const SpecialRange* special = find_special(device, program.dialect);
      if (special != nullptr && is_driven(special->role)) continue;
      if (!random.percent(is_input(device) ? 40 : 5)) continue;
      const auto value = static_cast<std::int16_t>(random.bits());
      events.push_back({device, is_word(device) ? value : static_cast<std::int16_t>(value & 1)});
    }
    for (const StimulusEvent& event : events) reference.set(event.device, event.value);
    engine.apply(events);
    reference.run_scan();
    engine.scan();
    for (const Device device : devices) {
      ASSERT_EQ(engine.value(device), reference.get(device))
          << "scan " << scan << ": " << device_name(device, program);
    }
    ASSERT_EQ(engine.error(), reference.error()) << "scan " << scan;
  }
}

TEST(Corpus, ListsRunAsTheReference) {
  if (!fs::is_directory(kPrograms / "melsec")) GTEST_SKIP() << "skipped: no corpus";
  int ran = 0;
  for (const fs::path& path : files_of(kPrograms / "melsec")) {
    Diagnostics diagnostics;
    const auto source = read_text(path.string(), diagnostics);
    const auto program = source ? parse_melsec(*source, std::nullopt, diagnostics) : std::nullopt;
    if (!program) continue;
    SCOPED_TRACE(path.string());
    compare_with_reference(*program, 1977);
    if (HasFatalFailure()) return;
    ++ran;
  }
  EXPECT_GT(ran, 0);
}

}  // namespace
}  // namespace rung::tb
