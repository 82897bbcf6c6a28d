// SPDX-License-Identifier: Apache-2.0
// Faults put into images: a wrong bit in a LUT row, two steps exchanged, a wrong bit in an
// instruction. The step model says what each does, and of faults of time the RTL; the proof has to
// catch all that change a device, and the start of a scan that it gives for each has to show the
// fault.
//
// RUNG_COUNT=N takes N faults of each kind and processor, RUNG_SEED=S the random numbers of S.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "melsec/list.hpp"
#include "programs/random_source.hpp"
#include "prove/decode.hpp"
#include "prove/image_model.hpp"
#include "prove/programs.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

// Places that the program names, and all that the core program has.
std::vector<prove::Place> visible(const Compiled& compiled) {
  std::vector<prove::Place> out;
  for (const image::ImageDevice& device : compiled.image.devices) {
    out.push_back({is_word(device.device), device.address});
  }
  std::sort(out.begin(), out.end());
  return out;
}
std::vector<prove::Place> all_places(const Compiled& compiled) {
  std::vector<prove::Place> out;
  for (const auto& [device, address] : compiled.meanings.at(0).places) {
    out.push_back({is_word(device), address});
  }
  std::sort(out.begin(), out.end());
  return out;
}

Memory empty(const image::Image& image) {
  const isa::Config& config = *isa::find_config(image.config);
  return {std::vector<bool>(static_cast<std::size_t>(config.bit_devices)),
          std::vector<std::uint16_t>(static_cast<std::size_t>(config.word_devices))};
}

// Words that are often equal, small or at the ends of their range.
Memory random_memory(const image::Image& image, const std::vector<prove::Place>& places,
                     RandomSource& random) {
  Memory out = empty(image);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < out.bits.size(); ++i, bits >>= 1) {
    if (i % 32 == 0) bits = random.bits();
    out.bits[i] = (bits & 1U) != 0;
  }
  for (const prove::Place place : places) {
    if (!place.word) continue;
    std::uint16_t value = static_cast<std::uint16_t>(random.below(5));
    if (random.percent(30)) value = static_cast<std::uint16_t>(random.bits());
    if (random.percent(10)) value = static_cast<std::uint16_t>(0x7fff + random.below(2));
    out.words[static_cast<std::size_t>(place.address)] = value;
  }
  return out;
}

// `others`: what the finding does not name.
Memory memory_of(const prove::Finding& finding, Memory others) {
  Memory out = std::move(others);
  for (const auto& [place, value] : finding.start) {
    const auto address = static_cast<std::size_t>(place.address);
    if (place.word) {
      out.words[address] = value;
    } else {
      out.bits[address] = value != 0;
    }
  }
  return out;
}

enum class Fault { LutBit, Swap, CodeBit };

// False if there is nothing to spoil. `numbers` are those of the steps, which go with them.
bool spoil(Compiled& compiled, Fault fault, RandomSource& random, std::string& what,
           std::vector<std::size_t>& numbers) {
  image::Image& image = compiled.image;
  const isa::Config& config = *isa::find_config(image.config);
  const int steps = static_cast<int>(image.steps.size());
  switch (fault) {
    case Fault::LutBit: {
      if (image.lut.empty()) return false;
      const int row = random.below(static_cast<int>(image.lut.size()));
      const int bit = random.below(8);
      std::uint8_t& function = image.lut[static_cast<std::size_t>(row)];
      function = static_cast<std::uint8_t>(function ^ 1U << bit);
      what = fmt::format("bit {} of LUT row {}", bit, row);
      return true;
    }
    case Fault::Swap: {
      if (steps < 2) return false;
      const int first = random.below(steps - 1);
      const int second = std::min(first + 1 + random.below(4), steps - 1);
      const auto a = static_cast<std::size_t>(first);
      const auto b = static_cast<std::size_t>(second);
      std::swap(image.steps[a], image.steps[b]);
      std::swap(image.origins[a], image.origins[b]);
      std::swap(image.quiet[a], image.quiet[b]);
      std::swap(numbers[a], numbers[b]);
      what = fmt::format("steps {} and {} exchanged", first, second);
      return true;
    }
    case Fault::CodeBit: {
      auto& step = image.steps[static_cast<std::size_t>(random.below(steps))];
      auto& instruction =
          step[static_cast<std::size_t>(random.below(static_cast<int>(step.size())))];
      const int bit = random.below(isa::slot_bits(image.mpu, config));
      const std::uint64_t code = isa::encode(instruction, image.mpu, config) ^ std::uint64_t{1}
                                                                                   << bit;
      const auto changed = isa::decode(code, image.mpu, config);
      if (!changed) return false;
      instruction = *changed;
      what = fmt::format("bit {} of an instruction: {:x}", bit, code);
      return true;
    }
  }
  return false;
}

struct Tally {
  int caught = 0;    // the model shows it too, or the proof's own start does
  int without = 0;   // caught by what no start alone shows
  int open = 0;      // an error too: the proof has found neither a start nor its absence
  int harmless = 0;  // proven to change nothing, and the model sees nothing
};

// Whether the two have another effect on `places` with one of the starts: by the step model, or by
// the RTL where the fault is one of time, of which the model knows nothing.
bool differ(const Compiled& good, const Compiled& bad, const std::vector<prove::Place>& places,
            const std::vector<Memory>& starts) {
  if (keeps_latencies(bad.image)) {
    return std::any_of(starts.begin(), starts.end(), [&](const Memory& start) {
      return run_model(good.image, start, places) != run_model(bad.image, start, places);
    });
  }
  const auto processor = make_processor(bad.image.mpu, *isa::find_config(bad.image.config));
  return std::any_of(starts.begin(), starts.end(), [&](const Memory& start) {
    return run_rtl(*processor, good.image, start, places) !=
           run_rtl(*processor, bad.image, start, places);
  });
}

// `moved`: a write has gone, come, or changed its place among the others of its device.
void judge(bool moved, const Compiled& good, const Compiled& bad, RandomSource& random,
           Tally& tally) {
  prove::ProofOptions options;
  options.findings = 1;
  const prove::Proof proof = prove::prove(bad.image, bad.meanings, options);
  if (proof.holds()) {
    const std::vector<prove::Place> places = visible(good);
    std::vector<Memory> starts;
    for (int i = 0; i < 100; ++i) starts.push_back(random_memory(good.image, places, random));
    EXPECT_FALSE(differ(good, bad, places, starts)) << "the proof has missed a fault";
    ++tally.harmless;
    return;
  }
  ASSERT_FALSE(proof.findings.empty());
  const prove::Finding& finding = proof.findings[0];
  if (!finding.wrong) {
    ++tally.open;
    return;
  }
  if (!finding.shown) {
    ++tally.without;
    return;
  }
  // Whatever the devices are that it does not name; but with some values a write too many and one
  // too few look alike, so there are a few.
  const std::vector<prove::Place> places = all_places(good);
  std::vector<Memory> starts = {memory_of(finding, empty(good.image))};
  for (int i = 0; i < 5; ++i) {
    starts.push_back(memory_of(finding, random_memory(good.image, places, random)));
  }
  const bool seen = differ(good, bad, places, starts);
  // The proof compares the k-th writes. Where one is missing before them, a start that tells them
  // apart need not have another outcome: conditions may exclude each other.
  if (!seen && moved) {
    ++tally.without;
    return;
  }
  EXPECT_TRUE(seen) << "the start does not show it: " << errors_of(proof, bad);
  ++tally.caught;
}

void inject(Fault fault, isa::Mpu mpu) {
  const std::uint64_t count = number_of("RUNG_COUNT", 100);
  const std::uint64_t first = number_of("RUNG_SEED", 1);
  Tally tally;
  for (std::uint64_t n = 0; n < count; ++n) {
    const std::uint64_t seed = first * 1000 + n;
    const auto good = compiled_for(random_case(seed / 3), mpu);
    if (!good) continue;
    RandomSource random(seed);
    Compiled bad = *good;
    std::string what;
    std::vector<std::size_t> numbers(good->image.steps.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    const auto before = writers(good->image, numbers);
    if (!spoil(bad, fault, random, what, numbers)) continue;
    const bool moved = writers(bad.image, numbers) != before;
    SCOPED_TRACE(
        fmt::format("{}; replay: RUNG_SEED={} RUNG_COUNT={} prove_faults", what, first, n + 1));
    judge(moved, *good, bad, random, tally);
    if (testing::Test::HasFailure()) return;
  }
  fmt::print(
      "MPU{}: {} caught, their starts show them; {} caught that no start alone shows; {} "
      "not proven; {} "
      "proven harmless\n",
      static_cast<int>(mpu), tally.caught, tally.without, tally.open, tally.harmless);
  EXPECT_GT(tally.caught, static_cast<int>(count / 10));
}

class Faults : public testing::TestWithParam<isa::Mpu> {};

TEST_P(Faults, WrongLutBitIsCaught) {
  if (GetParam() == isa::Mpu::Mpu1) GTEST_SKIP() << "skipped: MPU1 has no LUT";
  inject(Fault::LutBit, GetParam());
}
TEST_P(Faults, SwappedStepsAreCaught) { inject(Fault::Swap, GetParam()); }
TEST_P(Faults, WrongCodeBitIsCaught) { inject(Fault::CodeBit, GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, Faults, testing::ValuesIn(kMpus), [](const auto& mpu) {
  return fmt::format("Mpu{}", static_cast<int>(mpu.param));
});

constexpr const char* kSmall =
    "LD X0\nANI X1\nOR M0\nOUT M0\nLD M0\nMPS\nAND X2\nOUT Y0\nMPP\nANI X3\nSET M1\n"
    "LD X4\nRST M1\nLDI M1\nOR X1\nLD Y0\nORI M0\nANB\nOUT Y1\nEND\n";

// Of a program that is small enough, every wrong LUT bit and every exchange of two neighbours,
// judged by all of its starts: the proof is right in both directions.
TEST(Faults, ProofAndAllStartsAgree) {
  Diagnostics diagnostics;
  const auto source = decode_text(kSmall, "small.il", diagnostics);
  const auto program = parse_list(*source, Dialect::Fx, diagnostics);
  ASSERT_TRUE(program);
  int caught = 0;
  int harmless = 0;
  for (const isa::Mpu mpu : kMpus) {
    const auto good = compiled_for(*program, mpu);
    ASSERT_TRUE(good);
    const std::vector<prove::Place> places = all_places(*good);
    std::vector<Memory> starts;
    ASSERT_LE(places.size(), 10U);
    for (unsigned all = 0; all < 1U << places.size(); ++all) {
      Memory& start = starts.emplace_back(empty(good->image));
      for (std::size_t i = 0; i < places.size(); ++i) {
        start.bits[static_cast<std::size_t>(places[i].address)] = (all >> i & 1U) != 0;
      }
    }
    const auto check = [&](const Compiled& bad, const std::string& what) {
      const bool holds = prove::prove(bad.image, bad.meanings).holds();
      const bool differs = differ(*good, bad, places, starts);
      EXPECT_EQ(holds, !differs) << what << ", MPU" << static_cast<int>(mpu);
      ++(differs ? caught : harmless);
    };
    for (std::size_t row = 0; row < good->image.lut.size(); ++row) {
      for (int bit = 0; bit < 8; ++bit) {
        Compiled bad = *good;
        bad.image.lut[row] = static_cast<std::uint8_t>(bad.image.lut[row] ^ 1U << bit);
        check(bad, fmt::format("bit {} of LUT row {}", bit, row));
      }
    }
    for (std::size_t step = 0; step + 1 < good->image.steps.size(); ++step) {
      Compiled bad = *good;
      std::swap(bad.image.steps[step], bad.image.steps[step + 1]);
      check(bad, fmt::format("steps {} and {} exchanged", step, step + 1));
    }
  }
  fmt::print("{} faults caught, {} change nothing\n", caught, harmless);
  EXPECT_GT(caught, 80);
  EXPECT_GT(harmless, 0);
}

}  // namespace
}  // namespace rung::tb
