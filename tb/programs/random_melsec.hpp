// SPDX-License-Identifier: Apache-2.0
// Valid MELSEC lists by rule with every instruction of compiler/SEMANTICS.md, in dialect fx or q:
// what the agreement tests run by the thousand. Text only: nothing here knows the parser.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rungs/device.hpp"

namespace rung {

// What a program may be made of. The first ones are kinds of outputs, then come kinds of operands
// and forms, then kinds of program parts.
enum class Family : std::uint8_t {
  Bits,   // OUT SET RST; always there
  Edges,  // PLS PLF ALT FF, edge contacts, INV MEP MEF
  Timers,
  Counters,
  Moves,  // MOV CML XCH SWAP BMOV FMOV
  Arithmetic,
  Logic,  // WAND WOR WXOR WXNR
  Shifts,
  Rotates,
  Ranges,    // ZRST
  Codes,     // BCD BIN
  Compares,  // CMP ZCP, compare contacts
  Digits,    // KnXm
  WordBits,  // D0.F
  Index,     // D0Z0
  Wide,      // 32 bits
  Pulse,     // P forms
  Special,   // special relays
  Branches,  // MPS MRD MPP
  Zones,     // MC MCR
  States,    // STL RET
  Flow,      // CJ, CALL, FOR
};
inline constexpr int kFamilies = static_cast<int>(Family::Flow) + 1;
std::string_view family_name(Family family);
// The family of this name, in lower case; nothing if there is none.
std::optional<Family> find_family(std::string_view name);

// The fewer devices there are, the more often one instruction meets what another has written.
struct RandomMelsecOptions {
  Dialect dialect = Dialect::Fx;
  int networks = 8;  // of the main routine, about
  // Of each family: the weight of its outputs among the others, or the chance in 100 of its
  // operands, forms and parts where they are possible. 0: none at all.
  std::array<int, kFamilies> weights{};
  // Devices of each kind, numbered from 0.
  int inputs = 8;
  int outputs = 4;
  int relays = 8;
  int words = 6;  // at least 4

  int weight(Family family) const { return weights[static_cast<std::size_t>(family)]; }
  int& weight(Family family) { return weights[static_cast<std::size_t>(family)]; }
};

// The options of program number `seed`: each program has some families in plenty, some a little and
// some not at all, so that together they mix everything and each still does something.
RandomMelsecOptions melsec_options(std::uint64_t seed);

// A list of 10 to 100 instructions or so, END included. The same seed and options give the same
// text everywhere.
std::string random_melsec(std::uint64_t seed, const RandomMelsecOptions& options);

// What programs are made of, counted from their text: `OUT`, `OUT T`, `DMOVP`, and `digits`,
// `word bit`, `index`.
class MelsecCoverage {
 public:
  void count(std::string_view text);
  std::uint64_t of(const std::string& key) const;
  const std::map<std::string, std::uint64_t>& all() const { return counts_; }

 private:
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace rung
