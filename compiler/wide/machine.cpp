// SPDX-License-Identifier: Apache-2.0
#include "wide/machine.hpp"

#include <algorithm>
#include <cassert>

namespace rung::wide {
namespace {

struct Name {
  Opcode opcode;
  std::string_view name;
};

constexpr Name kNames[] = {
#define RUNG_WIDE_OP(id, name, code) {Opcode::id, name},
#define RUNG_WIDE_CONFIG(...)
#define RUNG_WIDE_NUMBER(...)
#include "wide_table.inc"
};

constexpr Machine make(std::string_view name, int slots, int units, int arity, int rows,
                       int word_rows, int steps, int dividers) {
  Machine machine;
  machine.name = name;
  machine.slots = slots;
  machine.units = units;
  machine.arity = arity;
  machine.rows = rows;
  machine.word_rows = word_rows;
  machine.steps = steps;
  machine.dividers = dividers;
  return machine;
}

constexpr Machine kMachines[] = {
#define RUNG_WIDE_OP(...)
#define RUNG_WIDE_NUMBER(...)
#define RUNG_WIDE_CONFIG(name, slots, units, arity, rows, word_rows, steps, dividers) \
  make(name, slots, units, arity, rows, word_rows, steps, dividers),
#include "wide_table.inc"
};

}  // namespace

std::string_view name_of(Opcode opcode) {
  for (const Name& each : kNames) {
    if (each.opcode == opcode) return each.name;
  }
  assert(false && "no opcode");
  return "";
}

bool is_opcode(unsigned code) {
  return std::any_of(std::begin(kNames), std::end(kNames),
                     [&](const Name& each) { return static_cast<unsigned>(each.opcode) == code; });
}

const Machine* find_machine(int slots) {
  for (const Machine& machine : kMachines) {
    if (machine.slots == slots) return &machine;
  }
  return nullptr;
}

std::span<const Machine> machines() { return kMachines; }

}  // namespace rung::wide
