// SPDX-License-Identifier: Apache-2.0
// Random programs on all three processors, in lockstep with the reference.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (10,000 if not given).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "driver/compile.hpp"
#include "lockstep/hazards.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "melsec/list.hpp"
#include "programs/random_program.hpp"
#include "programs/random_source.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 10000;
constexpr int kScans = 5;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

struct Case {
  RandomProgramOptions options;
  bool paper = false;
  const isa::Config* config = nullptr;
};

// From few devices, where nearly everything depends on what stands before it, to many.
Case case_of(std::uint64_t seed) {
  RandomSource random(seed ^ 0x52756e67);
  Case result;
  result.paper = random.percent(20);
  if (result.paper) {
    result.options = paper_options();
  } else {
    const Dialect dialects[] = {Dialect::Fx, Dialect::Q, Dialect::Paper};
    result.options.dialect = dialects[random.below(3)];
  }
  result.options.networks = 20 + random.below(8);
  const int density = random.below(3);
  result.options.inputs = 4 << density;
  result.options.outputs = 2 << 2 * density;
  result.options.relays = 3 << 2 * density;
  result.options.words = 3 << density;
  result.config = isa::find_config(random.percent(50) ? "ecp5" : "hx8k");
  return result;
}

class Fixture {
 public:
  // Runs program number `seed`; a failure of GoogleTest at the first difference.
  void run(std::uint64_t seed) {
    const Case which = case_of(seed);
    const std::string text = random_program(seed, which.options);
    Diagnostics diagnostics;
    const auto source = decode_text(text, fmt::format("random-{}.il", seed), diagnostics);
    const auto program = parse_list(*source, which.options.dialect, diagnostics);
    ASSERT_TRUE(program) << "seed " << seed << ": the generator made a list that is refused\n"
                         << text;
    for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
      for (const bool paper : {false, true}) {
        if (paper && !which.paper) continue;
        run(seed, *program, text, mpu, paper, *which.config);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }

  const Hazards& hazards(isa::Mpu mpu) { return hazards_[mpu]; }
  std::uint64_t runs() const { return runs_; }
  std::uint64_t too_large() const { return too_large_; }

 private:
  Processor& processor(isa::Mpu mpu, const isa::Config& config) {
    auto& place = processors_[{mpu, config.name}];
    if (!place) place = make_processor(mpu, config);
    return *place;
  }

  void run(std::uint64_t seed, const Program& program, const std::string& text, isa::Mpu mpu,
           bool paper, const isa::Config& config) {
    CompileOptions how;
    how.mpu = mpu;
    how.paper = paper;
    how.config = &config;
    how.search.tries = 2;
    Diagnostics diagnostics;
    const auto compiled = compile(program, how, diagnostics);
    if (!compiled) {
      ++too_large_;
      return;
    }
    const image::Image& image = compiled->image;
    Hazards& hazards = hazards_[mpu];
    hazards.count(image);
    Machine machine(image, processor(mpu, config));
    machine.observe([&](const Retired& retired) { hazards.count(image, retired); });
    Lockstep lockstep(program, machine);
    RandomSource random(seed);
    for (int scan = 0; scan < kScans; ++scan) {
      std::vector<StimulusEvent> events;
      for (const Device device : named_devices(program)) {
        if (is_word(device) ? scan == 0 && random.percent(50)
                            : is_input(device) && random.percent(50)) {
          const auto value = static_cast<std::int16_t>(random.bits());
          events.push_back(
              {device, is_word(device) ? value : static_cast<std::int16_t>(value & 1)});
        }
      }
      auto difference = lockstep.scan(events);
      if (!difference && scan + 1 == kScans) difference = lockstep.compare_state();
      ASSERT_FALSE(difference) << fmt::format("seed {}, MPU{}{}, configuration {}\n{}", seed,
                                              static_cast<int>(mpu), paper ? " --paper" : "",
                                              config.name, describe(*difference))
                               << "replay: RUNG_SEED=" << seed
                               << " build/test/tb/lockstep/lockstep_random\n"
                               << text;
    }
    ++runs_;
  }

  std::map<std::pair<isa::Mpu, std::string_view>, std::unique_ptr<Processor>> processors_;
  std::map<isa::Mpu, Hazards> hazards_;
  std::uint64_t runs_ = 0;
  std::uint64_t too_large_ = 0;
};

void expect_all_hit(const Hazards& h, int slots) {
  for (int slot = 0; slot < slots; ++slot) {
    for (int d = 0; d < Hazards::kDistances; ++d) {
      EXPECT_GT(h.bit_read_after_write[slot][d], 0U) << "distance " << d + 1;
      EXPECT_GT(h.word_read_after_write[slot][d], 0U) << "distance " << d + 1;
      EXPECT_GT(h.bit_rewritten[slot][d], 0U) << "distance " << d + 1;
      EXPECT_GT(h.word_rewritten[slot][d], 0U) << "distance " << d + 1;
    }
  }
  EXPECT_GT(h.gated_writes_done, 0U);
  EXPECT_GT(h.gated_writes_held, 0U);
  if (slots == 2) {
    EXPECT_GT(h.both_slots_write, 0U);
    EXPECT_GT(h.read_in_step_of_write, 0U);
  }
}

// Two tests, so that two cores share the programs.
class RandomPrograms : public testing::TestWithParam<int> {};

TEST_P(RandomPrograms, RunAsTheReference) {
  Fixture fixture;
  if (std::getenv("RUNG_SEED") != nullptr) {
    if (GetParam() == 0) fixture.run(from_environment("RUNG_SEED", 0));
    return;
  }
  const std::uint64_t count = from_environment("RUNG_COUNT", kDefaultCount);
  for (std::uint64_t seed = GetParam(); seed < count; seed += 2) {
    fixture.run(seed);
    if (HasFatalFailure()) return;
  }
  fmt::print("{} programs, {} runs of {} scans; {} too large for their configuration\n", count / 2,
             fixture.runs(), kScans, fixture.too_large());
  for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
    fmt::print("MPU{} {}", static_cast<int>(mpu), fixture.hazards(mpu).to_string());
    if (count >= kDefaultCount) expect_all_hit(fixture.hazards(mpu), isa::slots(mpu));
  }
  if (count < kDefaultCount) return;
  for (const isa::Mpu mpu : {isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
    for (const std::uint64_t n : fixture.hazards(mpu).n0_chains) EXPECT_GT(n, 0U);
    EXPECT_GT(fixture.hazards(mpu).collected_at_latency, 0U);
  }
  EXPECT_LT(fixture.too_large(), fixture.runs() / 4);
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomPrograms, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
