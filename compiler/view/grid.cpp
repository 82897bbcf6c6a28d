// SPDX-License-Identifier: Apache-2.0
#include "view/grid.hpp"

#include <algorithm>

#include "rungs/structure.hpp"

namespace rung::view {
namespace {

struct Size {
  int rows = 1, columns = 0;
};

// Whether nothing stands to the right of it: it is drawn at the right rail.
bool ends_line(const Program& program, const Node& node) {
  switch (node.kind) {
    case Node::Kind::Element: {
      const Op op = program.instructions[node.instruction].op;
      return program.dialect != Dialect::Ldmicro && effect_of(op) == Effect::Output;
    }
    case Node::Kind::Series:
      return !node.parts.empty() && ends_line(program, *node.parts.back());
    case Node::Kind::Fork:
      return true;
    case Node::Kind::Parallel:
      return false;
  }
  return false;
}

PowerStep::Kind kind_of(const Program& program, Op op) {
  if (is_contact(op) || op == Op::Stl) return PowerStep::Kind::Contact;
  if (changes_result(op)) return PowerStep::Kind::Result;
  if (program.dialect == Dialect::Ldmicro) return PowerStep::Kind::Given;
  return PowerStep::Kind::Same;
}

class Layout {
 public:
  Layout(const Program& program, Net first, int columns) : program_(program), right_(columns) {
    grid_.rail = first;
    grid_.end = first + 1;
  }

  Grid run(const NodePtr& circuit) {
    const Size size = size_of(*circuit);
    // What cannot be turned makes its rung wider.
    if (circuit->kind == Node::Kind::Series) {
      for (const NodePtr& part : circuit->parts) right_ = std::max(right_, size_of(*part).columns);
    } else {
      right_ = std::max(right_, size.columns);
    }
    grid_.columns = right_;
    if (circuit->kind == Node::Kind::Series) {
      turn_lines(*circuit);
    } else {
      finish(place(*circuit, 0, 0, grid_.rail, grid_.rail), size);
    }
    return std::move(grid_);
  }

 private:
  Net new_net() { return grid_.end++; }

  Size size_of(const Node& node) const {
    Size size;
    switch (node.kind) {
      case Node::Kind::Element:
        size.columns = width_of(program_.instructions[node.instruction]);
        return size;
      case Node::Kind::Series:
        for (const NodePtr& part : node.parts) {
          const Size each = size_of(*part);
          size.rows = std::max(size.rows, each.rows);
          size.columns += each.columns;
        }
        return size;
      default:
        size.rows = 0;
        for (const NodePtr& part : node.parts) {
          const Size each = size_of(*part);
          size.rows += each.rows;
          size.columns = std::max(size.columns, each.columns);
        }
        return size;
    }
  }

  void wire(int row, int from, int to, Net net) {
    if (from < to) grid_.wires.push_back({row, from, to, net});
  }

  // A series from the left rail, in as many lines as it takes.
  void turn_lines(const Node& circuit) {
    Net net = grid_.rail;
    int row = 0, column = 0, below = 1;
    Size size;
    for (const NodePtr& part : circuit.parts) {
      size = size_of(*part);
      if (column > 0 && column + size.columns > right_) {
        wire(row, column, right_, net);
        grid_.turns.push_back({static_cast<int>(grid_.turns.size()) + 1, row, right_, below, net});
        row = below;
        column = 0;
      }
      below = std::max(below, row + size.rows);
      // A coil stands at the right rail; in LDmicro what comes last in a rung does.
      const bool last = program_.dialect == Dialect::Ldmicro && part == circuit.parts.back();
      if ((last || ends_line(program_, *part)) && part->kind == Node::Kind::Element) {
        wire(row, column, right_ - size.columns, net);
        column = right_ - size.columns;
      }
      net = place(*part, row, column, net, grid_.rail);
      column += size.columns;
    }
    row_ = row;
    finish(net, {below, column});
  }

  // A drawing whose end is no output goes on to the right rail.
  void finish(Net net, Size size) {
    grid_.rows = std::max(1, size.rows);
    if (program_.dialect == Dialect::Ldmicro) wire(row_, size.columns, right_, net);
  }

  // Draws `node` with its upper left corner there; the net at its right end. The block that it
  // belongs to begins at net `base`.
  Net place(const Node& node, int row, int column, Net in, Net base) {
    switch (node.kind) {
      case Node::Kind::Element:
        return place_element(node, row, column, in, base);
      case Node::Kind::Series:
        return place_series(node, row, column, in, in);
      case Node::Kind::Parallel:
        return place_parallel(node, row, column, in);
      case Node::Kind::Fork:
        return place_fork(node, row, column, in, base);
    }
    return in;
  }

  Net place_series(const Node& node, int row, int column, Net in, Net base) {
    Net net = in;
    for (const NodePtr& part : node.parts) {
      const int width = size_of(*part).columns;
      if (part->kind == Node::Kind::Element && ends_line(program_, *part)) {
        wire(row, column, right_ - width, net);
        column = right_ - width;
      }
      net = place(*part, row, column, net, base);
      column += width;
    }
    return net;
  }

  Net place_element(const Node& node, int row, int column, Net in, Net base) {
    const Instruction& instruction = program_.instructions[node.instruction];
    const PowerStep::Kind kind = kind_of(program_, instruction.op);
    const Net out = kind == PowerStep::Kind::Same ? in : new_net();
    const int width = width_of(instruction);
    if (ends_line(program_, node) && column < right_ - width) {
      wire(row, column, right_ - width, in);
      column = right_ - width;
    }
    grid_.elements.push_back({node.instruction, row, column, width, in, out});
    if (out != in) grid_.steps.push_back({kind, node.instruction, in, out, base});
    return out;
  }

  Net place_parallel(const Node& node, int row, int column, Net in) {
    const int right = column + size_of(node).columns;
    const Net out = new_net();
    const int top = row;
    int last = row;
    for (const NodePtr& part : node.parts) {
      const Size size = size_of(*part);
      const Net end = place(*part, row, column, in, in);
      wire(row, column + size.columns, right, end);
      grid_.steps.push_back({PowerStep::Kind::Also, 0, end, out, in});
      last = row;
      row += size.rows;
    }
    if (column > 0) grid_.uprights.push_back({column, top, last, in});
    grid_.uprights.push_back({right, top, last, out});
    return out;
  }

  Net place_fork(const Node& node, int row, int column, Net in, Net base) {
    const int top = row;
    int last = row;
    for (const NodePtr& part : node.parts) {
      // A branch goes on with the result before it.
      if (part->kind == Node::Kind::Series) {
        place_series(*part, row, column, in, base);
      } else {
        place(*part, row, column, in, base);
      }
      last = row;
      row += size_of(*part).rows;
    }
    if (column > 0) grid_.uprights.push_back({column, top, last, in});
    return in;
  }

  const Program& program_;
  Grid grid_;
  int right_;    // the column of the right rail
  int row_ = 0;  // of the last line
};

}  // namespace

int width_of(const Instruction& instruction) {
  const Op op = instruction.op;
  switch (op) {
    case Op::Out:
    case Op::Outi:
    case Op::Inv:
    case Op::Mep:
    case Op::Mef:
    case Op::Stl:
    case Op::Short:
    case Op::Open:
    case Op::Osr:
    case Op::Osf:
    case Op::MasterRelay:
      return 1;
    case Op::Set:
    case Op::Rst:
    case Op::Pls:
    case Op::Plf:
    case Op::Alt:
      return instruction.operands.size() == 1 &&
                     instruction.operand(0).kind == Operand::Kind::Device &&
                     !instruction.operand(0).index
                 ? 1
                 : 2;
    case Op::AndCompare:
    case Op::LdCompare:
    case Op::OrCompare:
      return 2;
    default:
      break;
  }
  if (is_contact(op)) return 1;
  return instruction.text.size() > 24 ? 3 : 2;
}

Grid grid_of(const Program& program, const NodePtr& circuit, Net first, int columns) {
  return Layout(program, first, columns).run(circuit);
}

}  // namespace rung::view
