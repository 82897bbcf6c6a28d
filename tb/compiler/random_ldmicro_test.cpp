// SPDX-License-Identifier: Apache-2.0
// The random LDmicro programs: valid, the same everywhere, with every element, and made smaller by
// blocks.
#include "programs/random_ldmicro.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "ldmicro/ldmicro.hpp"
#include "programs/ldmicro_stimulus.hpp"
#include "programs/shrink.hpp"
#include "rungs/names.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

std::optional<Program> read(const std::string& text, std::string& messages) {
  Diagnostics diagnostics;
  const auto source = decode_ldmicro(text, "t.ld", diagnostics);
  std::optional<Program> program;
  if (source) program = parse_ldmicro(*source, diagnostics);
  std::ostringstream out;
  diagnostics.print(out);
  messages = out.str();
  return program;
}

Program good(const std::string& text) {
  std::string messages;
  std::optional<Program> program = read(text, messages);
  EXPECT_TRUE(program) << messages << text;
  return program.value_or(Program{});
}

// How often each line's first word stands in the programs of some seeds.
std::map<std::string, int> words_of(const std::string& text) {
  std::map<std::string, int> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line);
    std::string word;
    in >> word;
    ++words[word];
  }
  return words;
}

TEST(RandomLdmicro, IsTheSameEverywhere) {
  std::string all;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    all += random_ldmicro(seed, ldmicro_options(seed));
  }
  EXPECT_EQ(fnv1a(all), 12723506686902277917U);
  EXPECT_NE(random_ldmicro(1, ldmicro_options(1)), random_ldmicro(2, ldmicro_options(1)));
}

TEST(RandomLdmicro, IsValidAndHasEveryElement) {
  std::string all;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string text = random_ldmicro(seed, ldmicro_options(seed));
    std::string messages;
    ASSERT_TRUE(read(text, messages)) << "seed " << seed << '\n' << messages << text;
    all += text;
  }
  const std::map<std::string, int> words = words_of(all);
  for (const char* const word : {"CONTACTS",      "COIL",
                                 "SHORT",         "OPEN",
                                 "OSR",           "OSF",
                                 "EQU",           "NEQ",
                                 "GRT",           "GEQ",
                                 "LES",           "LEQ",
                                 "MASTER_RELAY",  "TON",
                                 "TOF",           "RTO",
                                 "RES",           "CTU",
                                 "CTD",           "CTC",
                                 "MOVE",          "ADD",
                                 "SUB",           "MUL",
                                 "DIV",           "SHIFT_REGISTER",
                                 "LOOK_UP_TABLE", "PIECEWISE_LINEAR",
                                 "READ_ADC",      "SET_PWM",
                                 "PERSIST",       "UART_SEND",
                                 "UART_RECV",     "FORMATTED_STRING",
                                 "COMMENT",       "PARALLEL",
                                 "SERIES"}) {
    ASSERT_TRUE(words.contains(word)) << word;
    EXPECT_GE(words.at(word), 10) << word;
  }
}

TEST(RandomLdmicro, EveryFamilyAloneIsValidAndThere) {
  const std::map<LdmicroFamily, std::vector<std::string>> signs = {
      {LdmicroFamily::Edges, {"OSR", "OSF"}},
      {LdmicroFamily::Timers, {"TON", "TOF", "RTO", "RES"}},
      {LdmicroFamily::Counters, {"CTU", "CTD", "CTC", "RES"}},
      {LdmicroFamily::Compares, {"EQU", "NEQ", "GRT", "GEQ", "LES", "LEQ"}},
      {LdmicroFamily::Moves, {"MOVE"}},
      {LdmicroFamily::Arithmetic, {"ADD", "SUB", "MUL", "DIV"}},
      {LdmicroFamily::Registers, {"SHIFT_REGISTER"}},
      {LdmicroFamily::Tables, {"LOOK_UP_TABLE", "PIECEWISE_LINEAR"}},
      {LdmicroFamily::Serial, {"UART_SEND", "UART_RECV"}},
      {LdmicroFamily::Strings, {"FORMATTED_STRING"}},
      {LdmicroFamily::Analogue, {"READ_ADC", "SET_PWM"}},
      {LdmicroFamily::Lasting, {"PERSIST"}},
      {LdmicroFamily::Wires, {"SHORT", "OPEN"}},
      {LdmicroFamily::Relay, {"MASTER_RELAY"}}};
  for (const auto& [family, words] : signs) {
    RandomLdmicroOptions options;
    options.weight(family) = 20;
    std::string all;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const std::string text = random_ldmicro(seed, options);
      good(text);
      all += text;
    }
    const std::map<std::string, int> there = words_of(all);
    for (const std::string& word : words) EXPECT_TRUE(there.contains(word)) << word;
    for (const auto& [other, other_words] : signs) {
      if (other == family || other_words.front() == "OSR") continue;
      EXPECT_EQ(there.contains(other_words.front()), other == family) << other_words.front();
    }
  }
}

TEST(LdmicroStimulus, SetsWhatTheProgramHas) {
  const Program program = good(
      "LDmicro0.1\nCYCLE=10000\nPROGRAM\nRUNG\n  CONTACTS X0 0\n  READ_ADC A\n  UART_RECV v\n"
      "  COIL Y0 0 0 0\nEND\n");
  std::map<Device, int> events;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto scans = ldmicro_stimulus(seed, program, 10);
    EXPECT_EQ(scans.size(), 10U);
    EXPECT_EQ(scans, ldmicro_stimulus(seed, program, 10));
    for (const auto& scan : scans) {
      for (const StimulusEvent& event : scan) {
        ++events[event.device];
        if (event.device == Device{DeviceKind::X, 0}) {
          EXPECT_TRUE(event.value == 0 || event.value == 1);
        }
        if (event.device == port::uart_rx_data) {
          EXPECT_TRUE(event.value >= 0 && event.value <= 255);
        }
      }
    }
  }
  EXPECT_GT(events[(Device{DeviceKind::X, 0})], 50);
  EXPECT_GT(events[port::adc], 50);
  EXPECT_GT(events[port::uart_rx_data], 50);
  EXPECT_GT(events[*DeviceNames(program).device("v")], 10);
}

TEST(ShrinkLdmicro, TakesOutRungsElementsAndBranches) {
  std::string text = "LDmicro0.1\nPROGRAM\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("RUNG\nCONTACTS X{0} 0\nCOIL Y{0} 0 0 0\nEND\n", i);
  text +=
      "RUNG\nPARALLEL\nSERIES\nOSR\nPARALLEL\nOSF\nSERIES\nSHORT\nCOIL R 0 0 "
      "0\nEND\nEND\nEND\nOPEN\n"
      "END\nEND\n";
  const auto needed = [](const std::string& left) {
    const auto has = [&](const char* line) { return left.find(line) != left.npos; };
    return has("COIL R") && has("COIL Y7");
  };
  EXPECT_EQ(shrink_ldmicro(text, needed),
            "LDmicro0.1\nPROGRAM\nRUNG\nCOIL Y7 0 0 0\nEND\nRUNG\nCOIL R 0 0 0\nEND\n");
  EXPECT_EQ(shrink_ldmicro(text, [](const std::string&) { return false; }), text);
}

}  // namespace
}  // namespace rung
