// SPDX-License-Identifier: Apache-2.0
#include "view/circuit.hpp"

#include <algorithm>
#include <utility>

#include "rungs/structure.hpp"

namespace rung::view {
namespace {

NodePtr element(std::size_t instruction) {
  return std::make_shared<Node>(Node{Node::Kind::Element, instruction, {}});
}

NodePtr group(Node::Kind kind, std::vector<NodePtr> parts) {
  if (kind != Node::Kind::Fork && parts.size() == 1) return parts.front();
  return std::make_shared<Node>(Node{kind, 0, std::move(parts)});
}

// What stands in series, from the left rail or from where a block begins.
using Path = std::vector<NodePtr>;

NodePtr series(const Path& path) { return group(Node::Kind::Series, path); }

// `upper` or `lower`, as one element of a path.
NodePtr either(const Path& upper, const NodePtr& lower) {
  std::vector<NodePtr> branches;
  if (upper.size() == 1 && upper.front()->kind == Node::Kind::Parallel) {
    branches = upper.front()->parts;
  } else {
    branches.push_back(series(upper));
  }
  branches.push_back(lower);
  return group(Node::Kind::Parallel, std::move(branches));
}

// The tree of all paths from the rail to an output: those that follow each other share what they
// begin with.
struct Branch {
  Path path;
  std::vector<Branch> branches;  // behind the path
};

void add_output(Branch& root, const Path& path, std::size_t at) {
  std::vector<Branch>& branches = root.branches;
  if (branches.empty() || branches.back().path.front() != path[at]) {
    branches.push_back({Path(path.begin() + static_cast<std::ptrdiff_t>(at), path.end()), {}});
    return;
  }
  Branch& last = branches.back();
  std::size_t same = 0;
  while (same < last.path.size() && at + same < path.size() && last.path[same] == path[at + same]) {
    ++same;
  }
  if (same < last.path.size()) {
    const auto cut = last.path.begin() + static_cast<std::ptrdiff_t>(same);
    Branch rest{Path(cut, last.path.end()), std::move(last.branches)};
    last.path.erase(cut, last.path.end());
    last.branches.clear();
    last.branches.push_back(std::move(rest));
  }
  add_output(last, path, at + same);
}

NodePtr tree_of(const Branch& branch) {
  Path path = branch.path;
  if (branch.branches.size() == 1) {
    const NodePtr only = tree_of(branch.branches.front());
    if (only->kind == Node::Kind::Series) {
      path.insert(path.end(), only->parts.begin(), only->parts.end());
    } else {
      path.push_back(only);
    }
  } else if (!branch.branches.empty()) {
    std::vector<NodePtr> parts;
    for (const Branch& each : branch.branches) parts.push_back(tree_of(each));
    path.push_back(group(Node::Kind::Fork, std::move(parts)));
  }
  return series(path);
}

// Whether what stands in this block must know where it begins.
bool has_own_result(const Program& program, const Path& block) {
  return std::any_of(block.begin(), block.end(), [&](const NodePtr& part) {
    return part->kind == Node::Kind::Element &&
           changes_result(program.instructions[part->instruction].op);
  });
}

// The boolean machine of a list, on drawings instead of results.
NodePtr list_circuit(const Program& program, const Network& network) {
  std::vector<Path> blocks;
  std::vector<Path> branches;  // of MPS
  Branch outputs;
  for (std::size_t i = network.first; i < network.first + network.count; ++i) {
    const Op op = program.instructions[i].op;
    switch (effect_of(op)) {
      case Effect::Load:
      case Effect::State:
        blocks.push_back({element(i)});
        break;
      case Effect::Combine: {
        Path& path = blocks.back();
        const bool in_parallel =
            op == Op::Or || op == Op::Ori || op == Op::OrP || op == Op::OrF || op == Op::OrCompare;
        if (in_parallel) {
          path = {either(path, element(i))};
        } else {
          path.push_back(element(i));
        }
        break;
      }
      case Effect::Join: {
        const Path second = std::move(blocks.back());
        blocks.pop_back();
        Path& first = blocks.back();
        if (op == Op::Anb && has_own_result(program, second)) {
          first.push_back(series(second));
        } else if (op == Op::Anb) {
          first.insert(first.end(), second.begin(), second.end());
        } else {
          first = {either(first, series(second))};
        }
        break;
      }
      case Effect::Push:
        branches.push_back(blocks.back());
        break;
      case Effect::Read:
        blocks.back() = branches.back();
        break;
      case Effect::Pop:
        blocks.back() = std::move(branches.back());
        branches.pop_back();
        break;
      case Effect::Output:
      case Effect::Between: {
        Path path = blocks.empty() ? Path{} : blocks.back();
        path.push_back(element(i));
        add_output(outputs, path, 0);
        break;
      }
      case Effect::None:
      case Effect::Unknown:
        break;
    }
  }
  // A step of a step ladder may have transitions only, in networks of their own.
  if (outputs.branches.empty() && !blocks.empty()) outputs.branches.push_back({blocks.back(), {}});
  return tree_of(outputs);
}

// An LDmicro rung is drawn as it is written.
class RungReader {
 public:
  RungReader(const Program& program, const Network& network)
      : program_(program), at_(network.first), end_(network.first + network.count) {}

  NodePtr read() {
    Path path;
    for (; at_ < end_; ++at_) {
      const Op op = program_.instructions[at_].op;
      if (op == Op::Branch || op == Op::Join) break;
      if (op == Op::Rung || op == Op::Comment) continue;
      path.push_back(op == Op::Parallel ? read_parallel() : element(at_));
    }
    return series(path);
  }

 private:
  NodePtr read_parallel() {
    std::vector<NodePtr> branches;
    do {
      ++at_;
      branches.push_back(read());
    } while (program_.instructions[at_].op == Op::Branch);
    return group(Node::Kind::Parallel, std::move(branches));
  }

  const Program& program_;
  std::size_t at_, end_;
};

}  // namespace

bool changes_result(Op op) { return op == Op::Inv || op == Op::Mep || op == Op::Mef; }

NodePtr circuit_of(const Program& program, const Network& network) {
  if (program.dialect == Dialect::Ldmicro) return RungReader(program, network).read();
  return list_circuit(program, network);
}

}  // namespace rung::view
