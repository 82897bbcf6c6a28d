// SPDX-License-Identifier: Apache-2.0
// A circuit on a grid of columns and rows: where each element stands, where wires run, and how
// power flows through them. What draws, the page or the terminal, has nothing more to decide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "view/circuit.hpp"

namespace rung::view {

// Where power is or is not; numbered through a program.
using Net = int;

struct Placed {
  std::size_t instruction = 0;
  int row = 0, column = 0, width = 1;
  Net in = 0, out = 0;
};
struct Wire {  // horizontal, from the left edge of a column to that of another one
  int row = 0, from = 0, to = 0;
  Net net = 0;
};
struct Upright {  // at the left edge of a column, between the middles of two rows
  int column = 0, from = 0, to = 0;
  Net net = 0;
};
// A line that was too long goes on in a row below: both ends have the same number.
struct Turn {
  int number = 0;
  int from_row = 0, from_column = 0, to_row = 0;
  Net net = 0;
};

// How a net gets its power from another one.
struct PowerStep {
  enum class Kind : std::uint8_t {
    Contact,  // what `from` has, if the instruction conducts
    Given,    // what the instruction gives, whatever comes in
    Result,   // what `base` has, if the instruction gives 1: of the result since there, not of
              // `from`
    Same,     // what `from` has
    Also,     // what `from` has, or what it has already
  };
  Kind kind = Kind::Same;
  std::size_t instruction = 0;
  Net from = 0, to = 0;
  Net base = 0;
};

struct Grid {
  int rows = 1, columns = 1;
  Net rail = 0;  // the left rail
  Net end = 0;   // the net behind the rung's last one
  std::vector<Placed> elements;
  std::vector<Wire> wires;
  std::vector<Upright> uprights;
  std::vector<Turn> turns;
  std::vector<PowerStep> steps;  // in an order in which each finds what it needs
};

// `first` is the number of the first net; a line that is longer than `columns` is turned.
Grid grid_of(const Program& program, const NodePtr& circuit, Net first, int columns);

// Columns that an instruction takes.
int width_of(const Instruction& instruction);

}  // namespace rung::view
