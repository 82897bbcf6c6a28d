// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "agree/ldmicro_case.hpp"
#include "hardwired/batch.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/list.hpp"
#include "melsec/melsec.hpp"
#include "programs/ldmicro_corpus.hpp"
#include "programs/melsec_stimulus.hpp"
#include "programs/random_program.hpp"
#include "programs/samples.hpp"
#include "rungs/footprint.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLists = 100;      // of all instructions
constexpr std::uint64_t kBasicLists = 10;  // of the paper's
constexpr std::uint64_t kLdmicro = 40;
constexpr int kCorpusScans = 40;
// The largest programs that nobody here wrote take the model's compiler longer than all else
// together.
constexpr std::size_t kMostInstructions = 1500;

// A checked list with the stimulus of `seed`.
Subject with_stimulus(std::string name, Program program, std::uint64_t seed, int scans) {
  Subject subject{std::move(name), fmt::format("stimulus {}", seed), {}};
  subject.what.seed = seed;
  subject.what.program = std::move(program);
  const Program& kept = subject.what.program;
  for (const Device device : visible_devices(kept)) {
    if (!is_hidden(device.kind)) subject.what.devices.push_back(device);
  }
  subject.what.events = melsec_stimulus(seed, named_devices(kept), kept.dialect, scans);
  return subject;
}

Program list(const std::string& text, const std::string& name, Dialect dialect) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, name, diagnostics);
  auto program = source ? parse_list(*source, dialect, diagnostics) : std::nullopt;
  if (!program) throw std::runtime_error(name + ": " + diagnostics.all().at(0).what);
  return std::move(*program);
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void add_random(std::vector<Subject>& subjects) {
  std::string messages;
  for (std::uint64_t seed = 0; seed < kLists; ++seed) {
    auto one = make_case(seed, text_of(seed, {}), messages);
    if (!one) throw std::runtime_error(messages);
    subjects.push_back(
        {fmt::format("random-{}", seed), fmt::format("list {}", seed), std::move(*one)});
  }
  for (std::uint64_t seed = 0; seed < kBasicLists; ++seed) {
    RandomProgramOptions options;
    options.dialect = seed % 2 == 0 ? Dialect::Fx : Dialect::Paper;
    const std::string name = fmt::format("basic-{}", seed);
    subjects.push_back(
        with_stimulus(name, list(random_program(seed, options), name, options.dialect), seed, 20));
  }
  for (std::uint64_t seed = 0; seed < kLdmicro; ++seed) {
    auto one = make_ldmicro_case(seed, ldmicro_text_of(seed), messages);
    if (!one) throw std::runtime_error(messages);
    subjects.push_back(
        {fmt::format("ldmicro-{}", seed), fmt::format("LDmicro {}", seed), std::move(*one)});
  }
}

// What the short ones of the random lists have little of: indexed operands, whose windows make a
// program long, and 32 bits.
constexpr const char* kDirected[] = {
    "LD X0\nOUT M1Z0\nLD M2Z1\nOR X1\nOUT Y0\nLD X2\nSET M3Z0\nLD X3\nRST M0Z1\n"
    "LDI M4Z0\nOUT Y1\nLD X1\nMOV K3 Z0\nLDI X1\nMOV K200 Z0\nLD X4\nADD Z1 K1 Z1\nEND\n",
    "LD X0\nADD D1Z0 D2 D3Z1\nLD X1\nMOV D0 D4Z0\nLD> D2Z1 K5\nOUT Y0\nLD X2\nMOV K-1 Z0\n"
    "LDI X2\nMOV K2 Z0\nLD X3\nMOV D0 Z1\nEND\n",
    "LD X0\nDMUL D0 D2 D4\nDDIV D4 D0 D8\nLD X1\nDADD D0 D8 D2\nDSUB D2 D10 D0\nLD X2\nMUL D0 D1 "
    "D6\n"
    "DIV D6 D2 D10\nLDD> D0 D4\nOUT Y0\nLD X3\nROL D0 K3\nROR D2 K5\nWXOR D0 D2 D1\nEND\n"};

void add_directed(std::vector<Subject>& subjects) {
  for (std::size_t i = 0; i < std::size(kDirected); ++i) {
    const std::string name = fmt::format("directed-{}", i);
    subjects.push_back(with_stimulus(name, list(kDirected[i], name, Dialect::Fx), i, 60));
    subjects.back().what.text = kDirected[i];
  }
}

// Lists of a folder that the front end takes.
void add_lists(std::vector<Subject>& subjects, const fs::path& folder, const std::string& prefix) {
  for (const fs::path& path : files_of(folder)) {
    const std::string suffix = path.extension().string();
    if (suffix == ".golden" || suffix == ".ld" || suffix == ".stim") continue;
    Diagnostics diagnostics;
    const auto source = read_text(path.string(), diagnostics);
    auto program = source ? parse_melsec(*source, std::nullopt, diagnostics) : std::nullopt;
    if (!program || program->instructions.size() > kMostInstructions) continue;
    subjects.push_back(
        with_stimulus(prefix + path.filename().string(), std::move(*program), 7, kCorpusScans));
  }
}

void add_ldmicro_corpus(std::vector<Subject>& subjects) {
  for (const LdmicroSample& sample : ldmicro_samples(std::string(RUNG_REPOSITORY) + "/../shared")) {
    LdmicroCase loaded = load_ldmicro(sample);
    if (!loaded.program || loaded.trace.scans.empty()) continue;
    Subject subject{"corpus " + sample.name, sample.program, {}};
    Case& one = subject.what;
    one.program = std::move(*loaded.program);
    one.tick_us = one.program.ldmicro->cycle_us;
    for (const auto& [device, name] : one.program.names) {
      if (!is_hidden(device.kind)) one.devices.push_back(device);
    }
    const auto scans = std::min<std::size_t>(loaded.trace.scans.size(), 2 * kCorpusScans);
    for (std::size_t k = 0; k < scans; ++k) {
      const auto events = loaded.stimulus.events(k);
      one.events.emplace_back(events.begin(), events.end());
    }
    subjects.push_back(std::move(subject));
  }
}

// Those that are short in Verilog, as long as all of them are short enough for every `make test`.
std::vector<Subject> short_ones(std::vector<Subject> subjects) {
  constexpr std::size_t kMost = 16'000, kMostInAll = 700'000;
  std::vector<Subject> kept;
  std::size_t sum = 0;
  for (Subject& subject : subjects) {
    Diagnostics diagnostics;
    const auto module = hardwired::to_verilog(subject.what.program, {}, diagnostics);
    if (!module || module->text.size() > kMost || sum + module->text.size() > kMostInAll) continue;
    sum += module->text.size();
    kept.push_back(std::move(subject));
  }
  return kept;
}

}  // namespace

std::vector<Subject> all_subjects() {
  std::vector<Subject> subjects;
  add_random(subjects);
  for (const int sample : {2, 3}) {  // Sample 1 is one of tb/golden
    const std::string name = fmt::format("sample-{}", sample);
    subjects.push_back(with_stimulus(
        name, list(sample_program(sample, kDensities[1], 1), name, Dialect::Paper), 1, 20));
  }
  const fs::path repository = RUNG_REPOSITORY;
  add_lists(subjects, repository / "tb/golden/programs", "golden ");
  add_lists(subjects, repository / "../shared/programs/melsec", "corpus ");
  add_ldmicro_corpus(subjects);
  return subjects;
}

std::vector<Subject> agree_subjects() {
  std::vector<Subject> subjects = short_ones(all_subjects());
  add_directed(subjects);
  return subjects;
}

std::vector<Subject> exhaustive_subjects() {
  constexpr std::uint64_t kPrograms = 60;
  std::vector<Subject> subjects;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    RandomProgramOptions options;
    options.networks = 8;
    options.inputs = 4;
    options.outputs = 3;
    options.relays = 4;
    options.word_percent = 0;
    const std::string name = fmt::format("bits-{}", seed);
    subjects.push_back(
        with_stimulus(name, list(random_program(seed, options), name, options.dialect), seed, 0));
  }
  return subjects;
}

std::vector<Subject> subjects_of(const std::string& set) {
  if (set == "agree") return agree_subjects();
  if (set == "all") return all_subjects();
  if (set == "exhaustive") return exhaustive_subjects();
  throw std::runtime_error("no set of programs '" + set + "'");
}

}  // namespace rung::tb
