// SPDX-License-Identifier: Apache-2.0
// The proof of programs compiled for MPU4, with 4, 8 and 16 slots, with and without merging.
#include <fmt/format.h>

#include <cstdlib>

#include "melsec/list.hpp"
#include "programs/random_source.hpp"
#include "programs/samples.hpp"
#include "prove/programs.hpp"
#include "prove/wide_decode.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

struct WideTotal {
  int programs = 0;
  int images = 0;
  int writes = 0;
  std::int64_t by_solver = 0;
  double seconds = 0;
  double longest = 0;
  std::string longest_name;
  std::vector<std::string> open;  // with something that is not proven within the limits

  void expect_proven(const Program& program, const std::string& name, int slots, bool merge) {
    const auto compiled = compiled_wide(program, slots, merge);
    if (!compiled) return;
    const prove::Proof proof = prove::prove(compiled->image, compiled->meanings);
    const std::string what =
        fmt::format("{} --slots {}{}", name, slots, merge ? "" : " --no-merge");
    EXPECT_EQ(proof.wrong(), 0) << what << "\n" << errors_of(proof, *compiled);
    if (!proof.holds()) open.push_back(what + "\n" + errors_of(proof, *compiled));
    ++images;
    writes += proof.proven;
    by_solver += proof.effort.solver;
    seconds += proof.seconds;
    if (proof.seconds <= longest) return;
    longest = proof.seconds;
    longest_name = what;
  }
  void print() const {
    fmt::print(
        "{} programs, {} images: {} writes proven in {:.1f} s with {} questions to the solver, the "
        "longest {} {:.2f} s\n",
        programs, images, writes, seconds, by_solver, longest_name, longest);
    // Few, and each says so.
    for (const std::string& each : open) fmt::print("not proven: {}", each);
    EXPECT_LE(20 * open.size(), static_cast<std::size_t>(images));
  }
};

// RUNG_ALL=1: each program in all six ways; else in one, and of many programs every `part`th.
void expect_folder(const std::string& folder, int part, int at_least) {
  const bool all = std::getenv("RUNG_ALL") != nullptr;
  WideTotal total;
  for (const std::string& file : program_files(folder)) {
    const auto program = read_program(file);
    if (!program) continue;
    const int number = total.programs++;
    for (int way = 0; way < 6; ++way) {
      if (all || (number % part == 0 && number / part % 6 == way)) {
        total.expect_proven(*program, file, kSlots[way % 3], way < 3);
      }
    }
  }
  total.print();
  EXPECT_GE(total.images, at_least);
}

TEST(WideProof, OfEveryGoldenProgram) {
  expect_folder(RUNG_REPOSITORY "/tb/golden/programs", 1, 20);
}

TEST(WideProof, OfTheCorpora) {
  const std::string folder = RUNG_REPOSITORY "/../shared/programs";
  if (program_files(folder).empty()) GTEST_SKIP() << "skipped: no corpus";
  expect_folder(folder, 8, 6);
}

TEST(WideProof, OfTheSamples) {
  WideTotal total;
  for (int number = 1; number <= 3; ++number) {
    Diagnostics diagnostics;
    const auto source = decode_text(sample_program(number, 30, 1), "sample.il", diagnostics);
    const auto program = parse_list(*source, Dialect::Paper, diagnostics);
    ASSERT_TRUE(program);
    ++total.programs;
    for (const bool merge : {true, false}) {
      total.expect_proven(*program, fmt::format("sample {}", number), 8, merge);
    }
  }
  total.print();
}

// RUNG_COUNT=N takes the first N programs, RUNG_SEED=S only the program S, in all ways.
TEST(WideProof, OfRandomPrograms) {
  const char* count = std::getenv("RUNG_COUNT");
  const char* only = std::getenv("RUNG_SEED");
  const auto end = static_cast<std::uint64_t>(count == nullptr ? 9 : std::atoi(count));
  WideTotal total;
  for (std::uint64_t seed = 0; seed < end; ++seed) {
    const std::uint64_t number = only == nullptr ? seed : std::strtoull(only, nullptr, 10);
    const Program program = random_case(number);
    SCOPED_TRACE(
        fmt::format("replay: RUNG_SEED={} prove_wide --gtest_filter=*RandomPrograms", number));
    ++total.programs;
    for (const int slots : kSlots) {
      for (const bool merge : {true, false}) {
        if (only == nullptr && (slots != kSlots[number / 4 % 3] || merge != (number / 12 % 2 == 0)))
          continue;
        total.expect_proven(program, fmt::format("random program {}", number), slots, merge);
      }
    }
    if (only != nullptr) break;
  }
  total.print();
}

// Random bits: where the compiler's decoder sees an instruction, this one sees the same.
TEST(WideDecode, AsTheCompilersOwn) {
  RandomSource random(3);
  int seen = 0;
  int refused = 0;
  for (const wide::Machine& machine : wide::machines()) {
    for (int i = 0; i < 2000; ++i) {
      std::vector<wide::Chunks> slots;
      wide::Step expected;
      expected.bits.resize(static_cast<std::size_t>(machine.slots));
      expected.words.resize(static_cast<std::size_t>(machine.units));
      bool all = true;
      for (int slot = 0; slot < machine.slots; ++slot) {
        wide::Chunks& chunks = slots.emplace_back();
        for (int n = 0; n < wide::chunks_of(machine, slot); ++n) {
          chunks.push_back(static_cast<std::uint16_t>(random.bits()));
        }
        // What no field has is 0, and most opcodes and kinds are some.
        wide::Step one = expected;
        for (int again = 0; again < 20 && !wide::decode(chunks, slot, machine, one); ++again) {
          chunks.back() = static_cast<std::uint16_t>(random.bits());
          chunks[chunks.size() - 2] = static_cast<std::uint16_t>(random.bits());
        }
        all &= wide::decode(chunks, slot, machine, expected);
      }
      const auto found = prove::decode(slots, machine);
      ASSERT_EQ(found.has_value(), all);
      ++(all ? seen : refused);
      if (!all) continue;
      EXPECT_EQ(*found, expected);
      slots.back().push_back(0);
      EXPECT_FALSE(prove::decode(slots, machine));
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace rung::tb
