// SPDX-License-Identifier: Apache-2.0
// Random programs: every row of every step, the clocks, and all memories afterwards, RTL against
// the step model.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "wide_rtl/random_steps.hpp"
#include "wide_rtl/step_model.hpp"

namespace rung::tb::wide {
namespace {

constexpr int kPrograms = 12;
constexpr int kScans = 4;

// RUNG_SEED=n runs program n alone.
std::vector<unsigned> seeds() {
  if (const char* seed = std::getenv("RUNG_SEED"))
    return {static_cast<unsigned>(std::strtoul(seed, nullptr, 0))};
  std::vector<unsigned> all;
  for (unsigned i = 1; i <= kPrograms; ++i) all.push_back(i);
  return all;
}

std::string describe(const Row& row) {
  std::string bits;
  for (bool bit : row.bits) bits += bit ? '1' : '0';
  return fmt::format("step {}: bits {} (lane 0 first), words {:04x}", row.step, bits,
                     fmt::join(row.words, " "));
}

class Random : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Slots, Random, testing::Values(4, 8, 16));

TEST_P(Random, EveryRowOfEveryStep) {
  for (unsigned seed : seeds()) {
    SCOPED_TRACE(fmt::format(
        "RUNG_SEED={} wide_rtl --gtest_filter='Slots/Random.EveryRowOfEveryStep/*'", seed));
    const int slots = GetParam();
    std::mt19937 random(seed);
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    const int length = seed == 1 ? 512 : 1 + below(160);
    const RandomProgram program = random_program(random, slots, length);
    auto rtl = make_wide_rtl(slots, static_cast<int>(seed));
    StepModel model(slots);
    rtl->load(program.steps, program.latch_row, program.latch_rows);
    const int word_rows = slots == 16 ? 512 : kSpecial;
    for (int row = 0; row < kSpecial; ++row) {
      for (int lane = 0; lane < slots; ++lane) {
        const bool value = below(2) != 0;
        model.write_bit({row, lane}, value);
        rtl->write_bit({row, lane}, value);
      }
      for (int unit = 0; unit < slots / 2 && row < word_rows; ++unit) {
        const auto value = static_cast<std::uint16_t>(below(1 << 16));
        model.write_word({row, unit}, value);
        rtl->write_word({row, unit}, value);
      }
    }
    std::vector<std::vector<bool>> inputs(kScans);
    for (auto& scan : inputs) {
      for (int i = 0; i < program.latch_rows * slots; ++i) scan.push_back(below(2) != 0);
    }
    const std::vector<Scan> scans = rtl->scans(inputs);
    const int clocks =
        length + constant::scan_fill + std::max(0, program.latch_rows - constant::scan_latch_free);
    for (int scan = 0; scan < kScans; ++scan) {
      SCOPED_TRACE(fmt::format("{} slots, scan {}", slots, scan));
      const Scan& got = scans[static_cast<std::size_t>(scan)];
      const std::vector<Row> rows = model.scan(program.steps, program.latch_row, program.latch_rows,
                                               inputs[static_cast<std::size_t>(scan)]);
      ASSERT_EQ(got.edges, clocks);
      ASSERT_EQ(got.clocks, static_cast<std::uint32_t>(clocks));
      ASSERT_EQ(got.rows.size(), rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(got.rows[i], rows[i])
            << "expected " << describe(rows[i]) << "\ngot      " << describe(got.rows[i]);
      }
    }
    ASSERT_EQ(scans.back().error, model.error());
    const auto bits = rtl->read_bit_rows(kSpecial);
    for (int i = 0; i < kSpecial * slots; ++i) {
      const Place place{i / slots, i % slots};
      ASSERT_EQ(bits[static_cast<std::size_t>(i)], model.read_bit(place) ? 1 : 0)
          << place.row << " lane " << place.lane;
    }
    const auto words = rtl->read_word_rows(word_rows);
    for (int i = 0; i < word_rows * slots / 2; ++i) {
      const Place place{i / (slots / 2), i % (slots / 2)};
      ASSERT_EQ(words[static_cast<std::size_t>(i)], model.read_word(place))
          << place.row << " unit " << place.lane;
    }
  }
}

}  // namespace
}  // namespace rung::tb::wide
