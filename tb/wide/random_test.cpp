// SPDX-License-Identifier: Apache-2.0
// Random programs on MPU4 beside the reference: basic instructions, all of MELSEC, all of LDmicro.
// Every fourth one on the RTL, the others on the simulator, which the RTL must equal row by row.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs of each kind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/ldmicro_case.hpp"
#include "melsec/list.hpp"
#include "programs/melsec_stimulus.hpp"
#include "programs/random_melsec.hpp"
#include "programs/random_program.hpp"
#include "programs/random_source.hpp"
#include "rungs/footprint.hpp"
#include "wide/agree.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 300;
constexpr int kScans = 6;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

WideHow how_of(std::uint64_t seed) {
  static constexpr int kSlots[] = {4, 8, 16};
  WideHow how;
  how.slots = kSlots[seed % 3];
  how.merge = seed / 3 % 2 == 0;
  how.rtl = seed % 4 == 0;
  return how;
}

Program parse(const std::string& text, Dialect dialect, std::uint64_t seed) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, fmt::format("random-{}.il", seed), diagnostics);
  auto program = parse_list(*source, dialect, diagnostics);
  if (!program) throw std::runtime_error("the generator made a list that is refused\n" + text);
  return std::move(*program);
}

template <typename F>
void for_seeds(const char* filter, F&& run) {
  const std::uint64_t only = from_environment("RUNG_SEED", 0);
  const std::uint64_t count = from_environment("RUNG_COUNT", kDefaultCount);
  const std::uint64_t first = only != 0 ? only : 1;
  for (std::uint64_t seed = first; seed < first + (only != 0 ? 1 : count); ++seed) {
    std::string problem;
    try {
      problem = run(seed);
    } catch (const std::exception& error) {
      problem = error.what();  // a check between two passes
    }
    ASSERT_TRUE(problem.empty()) << problem << "\nreplay: RUNG_SEED=" << seed
                                 << " wide_random --gtest_filter=" << filter;
  }
}

std::string run_basic(std::uint64_t seed) {
  RandomSource random(seed ^ 0x77696465);
  RandomProgramOptions options;
  static constexpr Dialect kDialects[] = {Dialect::Fx, Dialect::Q, Dialect::Paper};
  options.dialect = kDialects[random.below(3)];
  options.networks = 16 + random.below(10);
  const int density = random.below(3);
  options.inputs = 4 << density;
  options.outputs = 2 << 2 * density;
  options.relays = 3 << 2 * density;
  options.words = 3 << density;
  const Program program = parse(random_program(seed, options), options.dialect, seed);
  Stimulus stimulus;
  for (int scan = 0; scan < kScans; ++scan) {
    std::vector<StimulusEvent> events;
    for (const Device device : named_devices(program)) {
      const bool chosen = is_word(device) ? random.percent(scan == 0 ? 50 : 5)
                                          : random.percent(is_input(device) ? 50 : 5);
      if (!chosen) continue;
      const auto value = static_cast<std::int16_t>(random.bits());
      events.push_back({device, is_word(device) ? value : static_cast<std::int16_t>(value & 1)});
    }
    stimulus.append(std::move(events));
  }
  return wide_difference(program, stimulus, how_of(seed));
}

std::string run_melsec(std::uint64_t seed) {
  const RandomMelsecOptions options = melsec_options(seed);
  const Program program = parse(random_melsec(seed, options), options.dialect, seed);
  const std::vector<Device> named = named_devices(program);
  Stimulus stimulus;
  for (auto& events : melsec_stimulus(seed, named, options.dialect, kScans)) {
    stimulus.append(std::move(events));
  }
  WideHow how = how_of(seed);
  how.tick_us = melsec_tick_us(seed);
  std::string problem = wide_difference(program, stimulus, how);
  // What is too large for few slots may be refused, if the diagnostic says so.
  if (problem.find("split the program") != std::string::npos) return {};
  return problem;
}

std::string run_ldmicro(std::uint64_t seed) {
  std::string messages;
  const std::optional<Case> one = make_ldmicro_case(seed, ldmicro_text_of(seed), messages);
  if (!one) return "the generator made a file that is refused: " + messages;
  Stimulus stimulus;
  for (const auto& events : one->events) stimulus.append(events);
  WideHow how = how_of(seed);
  how.tick_us = one->tick_us;
  const std::string problem = wide_difference(one->program, stimulus, how);
  return problem.find("split the program") != std::string::npos ? "" : problem;
}

TEST(WideRandom, BasicProgramsRunAsTheReference) { for_seeds("*Basic*", run_basic); }

TEST(WideRandom, LdmicroProgramsRunAsTheReference) { for_seeds("*Ldmicro*", run_ldmicro); }

TEST(WideRandom, MelsecProgramsRunAsTheReference) { for_seeds("*Melsec*", run_melsec); }

}  // namespace
}  // namespace rung::tb
