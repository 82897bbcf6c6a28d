// SPDX-License-Identifier: Apache-2.0
// Faults put into images for MPU4: a wrong bit in a look-up's table, two steps exchanged, an
// operand from another place, an operand that does not arrive. The simulator says what each does:
// the start of a scan that the proof gives has to show the fault, and none that it lets pass may
// show any.
//
// RUNG_COUNT=N takes N faults of each kind, RUNG_SEED=S the random numbers of S.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "programs/random_source.hpp"
#include "prove/programs.hpp"
#include "wide/simulate.hpp"

namespace rung::tb {
namespace {

enum class WideFault { TableBit, Swap, Source, Lost };

std::uint64_t setting(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

wide::Step decoded(const image::WideImage& image, std::size_t step, const wide::Machine& machine) {
  wide::Step out;
  out.bits.resize(static_cast<std::size_t>(machine.slots));
  out.words.resize(static_cast<std::size_t>(machine.units));
  for (int slot = 0; slot < machine.slots; ++slot) {
    EXPECT_TRUE(wide::decode(image.code[step][static_cast<std::size_t>(slot)], slot, machine, out));
  }
  return out;
}

// An operand of an instruction that computes something: null if chance has met none.
wide::Operand* operand_of(wide::Step& step, RandomSource& random) {
  if (random.percent(60)) {
    auto& code =
        step.bits[static_cast<std::size_t>(random.below(static_cast<int>(step.bits.size())))];
    return code.table == 0 ? nullptr : &code.inputs[static_cast<std::size_t>(random.below(3))];
  }
  auto& code =
      step.words[static_cast<std::size_t>(random.below(static_cast<int>(step.words.size())))];
  if (code.opcode == wide::Opcode::Nop) return nullptr;
  if (random.percent(30)) return &code.keep;
  return code.kind == 0 && random.percent(50) ? &code.s2 : &code.s1;
}

// False if there is nothing to spoil.
bool spoil(image::WideImage& image, WideFault fault, RandomSource& random, std::string& what) {
  const wide::Machine& machine = *wide::find_machine(image.slots);
  const auto steps = static_cast<int>(image.code.size());
  const int number = random.below(steps);
  if (fault == WideFault::Swap) {
    const int other = std::min(number + 1 + random.below(4), steps - 1);
    std::swap(image.code[static_cast<std::size_t>(number)],
              image.code[static_cast<std::size_t>(other)]);
    what = fmt::format("steps {} and {} exchanged", number, other);
    return other != number;
  }
  wide::Step step = decoded(image, static_cast<std::size_t>(number), machine);
  if (fault == WideFault::TableBit) {
    auto& code = step.bits[static_cast<std::size_t>(random.below(machine.slots))];
    if (code.table == 0) return false;
    code.table = static_cast<std::uint16_t>(code.table ^ 1U << random.below(8));
    what = fmt::format("a bit of a table of step {}", number);
  } else {
    wide::Operand* operand = operand_of(step, random);
    if (operand == nullptr) return false;
    const wide::Operand before = *operand;
    if (fault == WideFault::Lost) {
      *operand = wide::near_value(wide::constant::near_zero);
    } else if (wide::is_near(*operand) || random.percent(30)) {
      *operand = wide::near_value(random.below(8), random.below(machine.units));
    } else if (random.percent(50)) {
      operand->lane = random.below(machine.units);
    } else {
      operand->row = random.below(image.first_latch_row + image.latch_rows + 1);
    }
    if (*operand == before) return false;
    what = fmt::format("an operand of step {}: {}.{} for {}.{}", number, operand->row,
                       operand->lane, before.row, before.lane);
  }
  auto& slots = image.code[static_cast<std::size_t>(number)];
  for (int slot = 0; slot < machine.slots; ++slot) {
    slots[static_cast<std::size_t>(slot)] = wide::encode(step, slot, machine);
  }
  return true;
}

using Values = std::map<prove::Place, std::uint16_t>;

struct WideEffect {
  bool defined = true;  // no row is read as it is written
  bool error = false;
  Values ends;
  std::vector<int> writes;  // what the listed ones give; of words -1 if it is kept
  bool operator==(const WideEffect&) const = default;
};

WideEffect run(const Compiled& compiled, const Values& start,
               const std::vector<prove::Place>& places) {
  const image::WideImage& image = *compiled.image.wide;
  wide::Simulator simulator(*wide::find_machine(image.slots));
  for (std::size_t step = 0; step < image.code.size(); ++step) {
    for (std::size_t slot = 0; slot < image.code[step].size(); ++slot) {
      simulator.load(static_cast<int>(step), static_cast<int>(slot), image.code[step][slot]);
    }
  }
  simulator.set_program(static_cast<int>(image.code.size()), image.first_latch_row,
                        image.latch_rows);
  for (const auto& [place, value] : start) {
    if (place.word) {
      simulator.set_word(place.address, value);
    } else {
      simulator.set_bit(place.address, value != 0);
    }
  }
  std::vector<std::uint8_t> inputs;
  for (const int number : image.latched) {
    const auto& device = compiled.image.devices[static_cast<std::size_t>(number)];
    const auto found = start.find({false, device.address});
    inputs.push_back(found != start.end() && found->second != 0 ? 1 : 0);
  }
  WideEffect effect;
  try {
    simulator.run_scan(inputs);
  } catch (const std::logic_error&) {
    effect.defined = false;
    return effect;
  }
  effect.error = simulator.error();
  for (const prove::Place place : places) {
    effect.ends[place] = place.word ? simulator.word(place.address)
                                    : static_cast<std::uint16_t>(simulator.bit(place.address));
  }
  if (image.merged) return effect;
  for (const image::WideWrite& write : image.writes) {
    const bool word =
        is_word(compiled.image.devices[static_cast<std::size_t>(write.device)].device);
    if (!word) {
      effect.writes.push_back(simulator.computed_bit(write.step, write.lane) ? 1 : 0);
    } else {
      effect.writes.push_back(!write.quiet && simulator.kept(write.step, write.lane)
                                  ? -1
                                  : simulator.computed_word(write.step, write.lane));
    }
  }
  return effect;
}

std::vector<prove::Place> places_of(const Compiled& compiled, bool all) {
  std::vector<prove::Place> out;
  for (const auto& [device, address] : compiled.meanings.at(0).places) {
    if (all || !is_hidden(device.kind) || is_port(device.kind)) {
      out.push_back({is_word(device), address});
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Values random_start(const std::vector<prove::Place>& places, RandomSource& random) {
  Values out;
  for (const prove::Place place : places) {
    std::uint16_t value = static_cast<std::uint16_t>(random.below(place.word ? 5 : 2));
    if (place.word && random.percent(30)) value = static_cast<std::uint16_t>(random.bits());
    out[place] = value;
  }
  return out;
}

struct WideTally {
  int caught = 0;    // the proof's own start shows it
  int without = 0;   // caught by what no start alone shows: it takes an undefined value
  int open = 0;      // an error too: neither a start nor its absence was found
  int harmless = 0;  // proven to change nothing, and the simulator sees nothing
};

void judge(const Compiled& good, const Compiled& bad, RandomSource& random, WideTally& tally) {
  prove::ProofOptions options;
  options.findings = 1;
  options.seconds = 1;
  const prove::Proof proof = prove::prove(bad.image, bad.meanings, options);
  const std::vector<prove::Place> all = places_of(good, true);
  if (proof.holds()) {
    const std::vector<prove::Place> seen = places_of(good, false);
    for (int i = 0; i < 40; ++i) {
      const Values start = random_start(all, random);
      EXPECT_EQ(run(good, start, seen), run(bad, start, seen)) << "the proof has missed a fault";
      if (testing::Test::HasFailure()) return;
    }
    ++tally.harmless;
    return;
  }
  ASSERT_FALSE(proof.findings.empty());
  const prove::Finding& finding = proof.findings[0];
  if (!finding.wrong) {
    ++tally.open;
  } else if (!finding.shown) {
    ++tally.without;
  } else {
    Values start = random_start(all, random);
    for (const auto& [place, value] : finding.start) start[place] = value;
    EXPECT_NE(run(good, start, all), run(bad, start, all))
        << "its start does not show it: " << errors_of(proof, bad);
    ++tally.caught;
  }
}

class WideFaults : public testing::TestWithParam<WideFault> {};

TEST_P(WideFaults, AreCaughtOrHarmless) {
  const std::uint64_t count = setting("RUNG_COUNT", 12);
  const std::uint64_t first = setting("RUNG_SEED", 1);
  WideTally tally;
  for (std::uint64_t n = 0; n < count; ++n) {
    const std::uint64_t seed = first * 1000 + n;
    // Lists: of LDmicro programs one in four is large.
    const std::uint64_t number = seed / 4;
    const auto good = compiled_wide(random_case(number % 4 == 2 ? number + 1 : number),
                                    kSlots[number % 3], number / 3 % 2 == 0);
    if (!good) continue;
    RandomSource random(seed);
    Compiled bad = *good;
    std::string what;
    bool spoilt = false;
    for (int again = 0; again < 20 && !spoilt; ++again) {
      bad = *good;
      spoilt = spoil(*bad.image.wide, GetParam(), random, what);
    }
    if (!spoilt) continue;
    SCOPED_TRACE(
        fmt::format("{}; replay: RUNG_SEED={} RUNG_COUNT={} prove_wide", what, first, n + 1));
    judge(*good, bad, random, tally);
    if (testing::Test::HasFailure()) return;
  }
  fmt::print(
      "{} caught, their starts show them; {} caught that no start alone shows; {} not proven; {} "
      "proven harmless\n",
      tally.caught, tally.without, tally.open, tally.harmless);
  EXPECT_GT(tally.caught, static_cast<int>(count / 10));
}

std::string fault_name(const testing::TestParamInfo<WideFault>& fault) {
  static constexpr const char* kNames[] = {"TableBit", "Swap", "Source", "Lost"};
  return kNames[static_cast<std::size_t>(fault.param)];
}
INSTANTIATE_TEST_SUITE_P(All, WideFaults,
                         testing::Values(WideFault::TableBit, WideFault::Swap, WideFault::Source,
                                         WideFault::Lost),
                         fault_name);

}  // namespace
}  // namespace rung::tb
