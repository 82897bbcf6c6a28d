// SPDX-License-Identifier: Apache-2.0
// rung-bytecode-bench PROGRAM...: how long the interpreter takes on this machine. A line for each
// program, its fields parted by tabs: name, rungs, instructions, bytes of the file, nanoseconds a
// scan, a rung and an instruction of the source.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <vector>

#include "bytecode/vm_engine.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/melsec.hpp"
#include "programs/random_source.hpp"
#include "source/text_file.hpp"

namespace {

using namespace rung;
using Clock = std::chrono::steady_clock;

// Scans under the same inputs; how many inputs; how often all of it. The fastest round counts: what
// else the machine does only makes a round slower.
constexpr int kScans = 200;
constexpr int kInputs = 20;
constexpr int kRounds = 25;

std::optional<Program> read(const std::string& path, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(path, diagnostics);
  if (!bytes) return std::nullopt;
  if (std::filesystem::path(path).extension() == ".ld") {
    const auto source = decode_ldmicro(*bytes, path, diagnostics);
    return source ? parse_ldmicro(*source, diagnostics) : std::nullopt;
  }
  const auto source = decode_text(*bytes, path, diagnostics);
  return source ? parse_melsec(*source, std::nullopt, diagnostics) : std::nullopt;
}

// Nanoseconds of kInputs * kScans scans.
double round(tb::VmEngine& engine, const std::vector<Device>& inputs, RandomSource& random) {
  double total = 0;
  for (int i = 0; i < kInputs; ++i) {
    std::vector<StimulusEvent> events;
    for (const Device device : inputs) {
      events.push_back({device, static_cast<std::int16_t>(random.percent(50) ? 1 : 0)});
    }
    engine.apply(events);
    const auto begin = Clock::now();
    for (int k = 0; k < kScans; ++k) engine.scan();
    total += std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
  }
  return total;
}

void measure(const Program& program) {
  tb::VmEngine engine(program, program.ldmicro ? program.ldmicro->cycle_us : 10000);
  std::vector<Device> inputs = named_devices(program);
  std::erase_if(inputs, [](Device device) { return !is_input(device); });
  double best = 0;
  for (int i = 0; i < kRounds; ++i) {
    RandomSource random(1);
    const double took = round(engine, inputs, random);
    best = i == 0 ? took : std::min(best, took);
  }
  const double scan = best / (kInputs * kScans);
  const ProgramCounts counts = count(program);
  fmt::print("{}\t{}\t{}\t{}\t{:.1f}\t{:.2f}\t{:.2f}\n", program.file, counts.networks,
             counts.instructions, engine.file().size(), scan, scan / std::max(counts.networks, 1),
             scan / std::max(counts.instructions, 1));
}

}  // namespace

int main(int argc, char** argv) {
  int refused = argc < 2 ? 2 : 0;
  for (int i = 1; i < argc; ++i) {
    Diagnostics diagnostics;
    const auto program = read(argv[i], diagnostics);
    diagnostics.print(std::cerr);
    if (program) {
      measure(*program);
    } else {
      refused = 1;
    }
  }
  return refused;
}
