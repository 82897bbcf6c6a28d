// SPDX-License-Identifier: Apache-2.0
// The instructions of the scan, or of one subroutine, as the lines of a C function.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "backends/c_instructions.hpp"
#include "backends/c_unit.hpp"

namespace rung {

// Instructions first to end - 1.
struct CRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

class CRoutine {
 public:
  CRoutine(CUnit& unit, CRange range);

  // The function's body, between its braces.
  void write();

  // The name of the function of the subroutine that begins at this label.
  static std::string name(const CUnit& unit, std::size_t label);

 private:
  void instruction(const Instruction& instruction);
  void contact(const Instruction& instruction);
  void begin_rungs();
  bool element(const Instruction& instruction);
  bool block(const Instruction& instruction);
  void state(std::size_t index);
  bool ends_state(std::size_t index) const;
  void close_state();
  bool flow(const Instruction& instruction);
  void jump(const Instruction& instruction, const std::string& executed);
  void output(const Instruction& instruction);
  void source_comment(std::size_t index);

  std::string load();
  std::string top();
  std::string power();
  std::string local(const std::string& name, bool reads);

  CUnit& unit_;
  CRange range_;
  std::set<std::size_t> labels_;  // where a CJ leads to
  // Local variables and whether something reads them.
  std::map<std::string, bool> locals_;
  int blocks_ = 0;              // open LDs: r0, r1, ...
  int branches_ = 0;            // open MPSs: s0, s1, ...
  int parallels_ = 0;           // open ones: in0 any0, in1 any1, ...
  int loops_ = 0;               // open FORs: k0, k1, ...
  bool at_start_ = true;        // an LD begins a network
  std::vector<int> levels_;     // of the open MC zones, in their order
  std::vector<Device> states_;  // whose zone is open
};

}  // namespace rung
