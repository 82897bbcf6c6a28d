// SPDX-License-Identifier: Apache-2.0
// The proof of every program that the tests and the corpora have, on every processor.
#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "driver/compile_flow.hpp"
#include "flowchart/read.hpp"
#include "melsec/list.hpp"
#include "melsec/paper.hpp"
#include "programs/samples.hpp"
#include "prove/programs.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

// Sums over the programs of one test, for what it prints.
struct Total {
  int programs = 0;
  int images = 0;
  int writes = 0;
  double seconds = 0;
  double longest = 0;
  std::string longest_name;

  void add(const prove::Proof& proof, const std::string& name) {
    ++images;
    writes += proof.proven;
    seconds += proof.seconds;
    if (proof.seconds <= longest) return;
    longest = proof.seconds;
    longest_name = name;
  }
  void print() const {
    fmt::print("{} programs, {} images: {} writes proven in {:.1f} s, the longest {} {:.2f} s\n",
               programs, images, writes, seconds, longest_name, longest);
  }
};

void expect_proven(const Compiled& compiled, const std::string& name, Total& total) {
  const prove::Proof proof = prove::prove(compiled.image, compiled.meanings);
  EXPECT_TRUE(proof.holds()) << name << "\n"
                             << errors_of(proof, compiled) << prove::to_string(proof);
  total.add(proof, name);
}

void expect_all(const Program& program, const std::string& name, Total& total) {
  ++total.programs;
  Diagnostics diagnostics;
  const bool paper = program.dialect == Dialect::Paper && check_paper(program, diagnostics);
  for (const isa::Mpu mpu : kMpus) {
    for (const bool as_paper : {false, true}) {
      if (as_paper && (!paper || mpu == isa::Mpu::Mpu1)) continue;
      const auto compiled = compiled_for(program, mpu, as_paper);
      const std::string what =
          fmt::format("{} --mpu {}{}", name, static_cast<int>(mpu), as_paper ? " --paper" : "");
      if (compiled) expect_proven(*compiled, what, total);
    }
  }
}

// Programs are refused for reasons of their own; those that are taken are proven.
void expect_folder(const std::string& folder, int at_least) {
  Total total;
  for (const std::string& file : program_files(folder)) {
    const auto program = read_program(file);
    if (program) expect_all(*program, file, total);
  }
  total.print();
  EXPECT_GE(total.programs, at_least);
}

TEST(Proof, OfEveryGoldenProgram) { expect_folder(RUNG_REPOSITORY "/tb/golden/programs", 20); }

TEST(Proof, OfThePlantsPrograms) { expect_folder(RUNG_REPOSITORY "/tb/plant/programs", 2); }

TEST(Proof, OfTheCorpora) {
  const std::string folder = RUNG_REPOSITORY "/../shared/programs";
  if (program_files(folder).empty()) GTEST_SKIP() << "skipped: no corpus";
  expect_folder(folder, 60);
}

TEST(Proof, OfTheSamples) {
  Total total;
  for (int number = 1; number <= 3; ++number) {
    Diagnostics diagnostics;
    const auto source = decode_text(sample_program(number, 30, 1), "sample.il", diagnostics);
    const auto program = parse_list(*source, Dialect::Paper, diagnostics);
    ASSERT_TRUE(program);
    expect_all(*program, fmt::format("sample {}", number), total);
  }
  total.print();
}

// RUNG_COUNT=N takes the first N programs, RUNG_SEED=S only the program S.
TEST(Proof, OfRandomPrograms) {
  const char* count = std::getenv("RUNG_COUNT");
  const char* only = std::getenv("RUNG_SEED");
  const auto end = static_cast<std::uint64_t>(count == nullptr ? 100 : std::atoi(count));
  Total total;
  for (std::uint64_t seed = 0; seed < end; ++seed) {
    const std::uint64_t number = only == nullptr ? seed : std::strtoull(only, nullptr, 10);
    const Program program = random_case(number);
    SCOPED_TRACE(
        fmt::format("replay: RUNG_SEED={} prove_corpus --gtest_filter=*RandomPrograms", number));
    expect_all(program, fmt::format("random program {}", number), total);
    if (only != nullptr) break;
  }
  total.print();
}

// On the small configuration there is no multiplier block: other latencies.
TEST(Proof, OfTheSmallConfiguration) {
  Total total;
  for (std::uint64_t seed = 200; seed < 224; ++seed) {
    const Program program = random_case(seed);
    ++total.programs;
    for (const isa::Mpu mpu : kMpus) {
      const auto compiled = compiled_for(program, mpu, false, true);
      if (compiled) expect_proven(*compiled, fmt::format("random program {}", seed), total);
    }
  }
  total.print();
  EXPECT_GT(total.images, 30);
}

TEST(Proof, OfFlowTasks) {
  Diagnostics diagnostics;
  const auto bytes = read_bytes(RUNG_REPOSITORY "/tb/prove/lift.flow", diagnostics);
  ASSERT_TRUE(bytes);
  const auto source = decode_text(*bytes, RUNG_REPOSITORY "/tb/prove/lift.flow", diagnostics);
  const auto chart = flowchart::parse(*source, diagnostics);
  std::ostringstream errors;
  diagnostics.print(errors);
  ASSERT_TRUE(chart) << errors.str();
  Total total;
  total.programs = 1;
  for (const isa::Mpu mpu : kMpus) {
    CompileOptions options;
    options.mpu = mpu;
    const auto compiled = compile_flow(*chart, options, diagnostics);
    ASSERT_TRUE(compiled);
    EXPECT_GT(compiled->meanings.size(), 4U);
    expect_proven(*compiled, "lift.flow", total);
  }
  total.print();
}

}  // namespace
}  // namespace rung::tb
