// SPDX-License-Identifier: Apache-2.0
// The random programs of all instructions: valid, the same everywhere, and of the families asked
// for.
#include "programs/random_melsec.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "melsec/list.hpp"
#include "programs/melsec_stimulus.hpp"
#include "programs/shrink.hpp"

namespace rung {
namespace {

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

RandomMelsecOptions only(Dialect dialect, Family family) {
  RandomMelsecOptions options;
  options.dialect = dialect;
  options.weight(Family::Bits) = 20;
  options.weight(family) = 20;
  return options;
}

TEST(RandomMelsec, IsTheSameEverywhere) {
  std::string all;
  for (std::uint64_t seed = 0; seed < 50; ++seed) all += random_melsec(seed, melsec_options(seed));
  EXPECT_EQ(fnv1a(all), 77236758742594643U);
  EXPECT_NE(random_melsec(1, melsec_options(1)), random_melsec(2, melsec_options(1)));
}

TEST(RandomMelsec, EveryFamilyAloneIsValidAndThere) {
  // What shows that a family is there, where it does not only change other instructions.
  const std::map<Family, std::string> signs = {
      {Family::Edges, "PLS"},   {Family::Timers, "OUT T"},   {Family::Counters, "OUT C"},
      {Family::Moves, "MOV"},   {Family::Arithmetic, "INC"}, {Family::Logic, "WAND"},
      {Family::Shifts, "SFL"},  {Family::Rotates, "RCL"},    {Family::Ranges, "ZRST"},
      {Family::Codes, "BCD"},   {Family::Compares, "CMP"},   {Family::WordBits, "word bit"},
      {Family::Index, "index"}, {Family::Branches, "MPS"},   {Family::Zones, "MC"},
      {Family::States, "STL"},  {Family::Flow, "CJ"}};
  for (const Dialect dialect : {Dialect::Fx, Dialect::Q}) {
    for (int i = 0; i < kFamilies; ++i) {
      const auto family = static_cast<Family>(i);
      MelsecCoverage coverage;
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const std::string text = random_melsec(seed, only(dialect, family));
        Diagnostics diagnostics;
        const auto source = decode_text(text, "t.il", diagnostics);
        ASSERT_TRUE(parse_list(*source, dialect, diagnostics)) << family_name(family) << '\n'
                                                               << text;
        coverage.count(text);
      }
      EXPECT_GT(coverage.of("OUT"), 20U);
      for (const auto& [other, sign] : signs) {
        const bool there = other == family && (family != Family::States || dialect == Dialect::Fx);
        EXPECT_EQ(coverage.of(sign) > 0, there) << sign << " in " << family_name(family);
      }
    }
  }
}

TEST(RandomMelsec, FamiliesHaveNames) {
  for (int i = 0; i < kFamilies; ++i) {
    const auto family = static_cast<Family>(i);
    EXPECT_EQ(find_family(family_name(family)), family);
  }
  EXPECT_FALSE(find_family("motors"));
}

TEST(RandomMelsec, CoverageKnowsFormsAndOperands) {
  MelsecCoverage coverage;
  coverage.count("; dialect fx\nLD D0.F\nMOVP K4X0 D3Z1\nOUT T0 K5\nOUT M0\nMPS\nEND\n");
  const std::map<std::string, std::uint64_t> expected = {
      {"LD", 1},    {"LD D", 1}, {"word bit", 1}, {"MOVP", 1},  {"MOVP K", 1}, {"digits", 1},
      {"index", 1}, {"OUT", 2},  {"OUT T", 1},    {"OUT M", 1}, {"MPS", 1},    {"END", 1}};
  EXPECT_EQ(coverage.all(), expected);
}

TEST(MelsecStimulus, SetsWhatMayBeSet) {
  const Device input{DeviceKind::X, 0};
  const Device word{DeviceKind::D, 0};
  const Device on{DeviceKind::M, 8000};
  const std::vector<Device> devices{input, on, word};
  std::map<Device, int> events;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto scans = melsec_stimulus(seed, devices, Dialect::Fx, 10);
    EXPECT_EQ(scans.size(), 10U);
    EXPECT_EQ(scans, melsec_stimulus(seed, devices, Dialect::Fx, 10));
    for (const auto& scan : scans) {
      for (const StimulusEvent& event : scan) {
        ++events[event.device];
        if (event.device == input) {
          EXPECT_TRUE(event.value == 0 || event.value == 1);
        }
      }
    }
  }
  EXPECT_GT(events[input], 50);
  EXPECT_GT(events[word], 20);
  EXPECT_EQ(events[on], 0);
}

TEST(Shrink, LeavesWhatIsNeeded) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += fmt::format("line {}\n", i);
  const auto needed = [](const std::string& left) {
    // Lines 7 and 30, and 3 and 12 only together.
    const auto has = [&](int i) { return left.find(fmt::format("line {}\n", i)) != left.npos; };
    return has(7) && has(30) && has(3) == has(12);
  };
  EXPECT_EQ(shrink(text, needed), "line 7\nline 30\n");
  EXPECT_EQ(shrink(text, [](const std::string&) { return false; }), text);
}

}  // namespace
}  // namespace rung
