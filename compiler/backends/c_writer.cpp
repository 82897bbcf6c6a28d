// SPDX-License-Identifier: Apache-2.0
#include "backends/c_writer.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "backends/c_interface.hpp"
#include "backends/c_routine.hpp"
#include "backends/c_unit.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

using Instructions = std::vector<Instruction>;

// From `first` on, where the first instruction of this kind is, or the end.
std::size_t find(const Instructions& instructions, std::size_t first, Op op) {
  while (first < instructions.size() && instructions[first].op != op) ++first;
  return first;
}

// The subroutines that are called, by their labels; the ranges leave SRET out.
std::vector<CRange> subroutines(const Instructions& instructions) {
  std::set<std::size_t> labels;
  for (const Instruction& instruction : instructions) {
    if (instruction.op == Op::Call) labels.insert(instruction.destination);
  }
  std::vector<CRange> ranges;
  for (const std::size_t label : labels) {
    ranges.push_back({label, find(instructions, label, Op::Sret)});
  }
  return ranges;
}

}  // namespace

std::string write_c(const Program& program, const COptions& options) {
  CUnit unit(program, options);
  const std::vector<CRange> called = subroutines(program.instructions);
  for (const CRange& range : called) {
    unit.body.line("static void {}(void);", CRoutine::name(unit, range.first));
  }
  if (!called.empty()) unit.body.blank();
  for (const CRange& range : called) {
    unit.body.open("static void {}(void) {{", CRoutine::name(unit, range.first));
    CRoutine(unit, range).write();
    unit.body.close();
    unit.body.blank();
  }
  // Subroutines, and what nothing calls, are behind FEND.
  const std::size_t scan_end =
      std::min(find(program.instructions, 0, Op::Fend) + 1, program.instructions.size());
  unit.body.open("static void @_scan(void) {{");
  CRoutine(unit, {0, scan_end}).write();
  unit.body.close();
  unit.body.blank();
  unit.body.open("{}void $Cycle(void) {{", options.bare ? "static " : "");
  write_scan_start(unit);
  unit.body.line("@_scan();");
  write_scan_end(unit);
  unit.body.close();

  CSource source(options.prefix);
  write_declarations(unit, source);
  write_accessors(unit, source);
  unit.helpers.write(source);
  write_fault(unit, source);
  source.append(unit.body);
  return source.text();
}

std::string to_c(const Program& program) { return write_c(program, {}); }

std::string c_port_name(Device port) { return "%" + port::name(port); }

}  // namespace rung
