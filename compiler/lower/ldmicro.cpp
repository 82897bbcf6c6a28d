// SPDX-License-Identifier: Apache-2.0
#include "lower/ldmicro.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lower/elements.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

// An element of a rung, or branches in parallel.
struct Node {
  using Series = std::vector<Node>;
  std::size_t index = 0;         // of the instruction
  std::vector<Series> branches;  // empty for an element
  // Nothing in it writes or remembers anything, so that branches can be taken for themselves, in
  // any order, and combined with the condition afterwards.
  bool pure = false;
};
using Series = Node::Series;

bool is_condition(Op op) {
  return op == Op::And || op == Op::Ani || op == Op::AndCompare || op == Op::Short ||
         op == Op::Open;
}

bool all_pure(const Series& series) {
  return std::all_of(series.begin(), series.end(), [](const Node& node) { return node.pure; });
}

class Walk {
 public:
  explicit Walk(const Program& program)
      : program_(program), context_(program), elements_(context_) {}

  core::Program run() {
    for (const Network& network : program_.networks) rung(network);
    elements_.finish();
    return context_.take();
  }

 private:
  Op op(std::size_t i) const { return program_.instructions[i].op; }

  // --- The shape of a rung, from instruction i on; leaves i at what ends the series.
  Series read_series(std::size_t& i, std::size_t end) {
    Series series;
    for (; i < end && op(i) != Op::Branch && op(i) != Op::Join; ++i) {
      if (op(i) == Op::Comment || op(i) == Op::Short) continue;
      Node node{i, {}, is_condition(op(i))};
      if (op(i) == Op::Parallel) {
        do {
          node.branches.push_back(read_series(++i, end));
        } while (op(i) == Op::Branch);
        node.pure = std::all_of(node.branches.begin(), node.branches.end(), all_pure);
      }
      series.push_back(std::move(node));
    }
    return series;
  }

  void rung(const Network& network) {
    context_.at(network.first);
    context_.begin_network();
    elements_.set_flow(Flow::On);
    if (elements_.master()) elements_.contact(*elements_.master(), false);
    std::size_t i = network.first + 1;
    const Series elements = read_series(i, network.first + network.count);
    series(elements, false);
    context_.end_network();
  }

  // --- Code. `used`: something looks at the condition that is left.
  void series(const Series& nodes, bool used) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const bool looked_at = used || k + 1 < nodes.size();
      context_.at(nodes[k].index);
      if (nodes[k].branches.empty()) {
        elements_.execute(looked_at);
      } else if (nodes[k].pure) {
        choice(nodes[k]);
      } else if (looked_at) {
        parallel(nodes[k]);
      } else {
        fork(nodes[k]);
      }
    }
  }

  // Pure branches: their OR as a block of its own, ANDed to the condition.
  void choice(const Node& node) {
    if (elements_.flow() == Flow::Off) return;
    const Flow before = elements_.flow();
    const Flow either = any_of(node.branches);
    if (either == Flow::Result) {
      if (before == Flow::Result) context_.block(Core::Anb);
    } else {
      elements_.set_flow(before);
      if (either == Flow::Off) elements_.replace(Flow::Off);
      return;
    }
    elements_.set_flow(Flow::Result);
  }

  static bool is_contact_alone(const Series& branch) {
    return branch.size() == 1 && branch.front().branches.empty();
  }

  // A block with the OR of the branches, or a constant without one. Longer branches come first:
  // what is a contact alone then needs no block.
  Flow any_of(const std::vector<Series>& branches) {
    std::vector<const Series*> order;
    for (const Series& branch : branches) order.push_back(&branch);
    std::stable_partition(order.begin(), order.end(),
                          [](const Series* branch) { return !is_contact_alone(*branch); });
    Flow total = Flow::Off;
    for (const Series* branch : order) {
      if (total == Flow::Result && is_contact_alone(*branch) && either(branch->front().index)) {
        continue;
      }
      elements_.set_flow(Flow::On);
      series(*branch, true);
      total = join(total, elements_.flow());
      if (total == Flow::On) break;
    }
    return total;
  }

  // result <- result OR contact; false if the instruction is no contact.
  bool either(std::size_t index) {
    context_.at(index);
    const Instruction& contact = program_.instructions[index];
    if (contact.op == Op::AndCompare) {
      const Test test = compare_contact(context_);
      context_.contact(test.inverted ? Core::Ori : Core::Or, test.bit);
    } else if (contact.op == Op::And || contact.op == Op::Ani) {
      context_.contact(contact.op == Op::And ? Core::Or : Core::Ori, contact.operand(0).device);
    } else {
      return false;
    }
    return true;
  }

  // The OR of a condition and of one behind it: of two results the blocks become one.
  Flow join(Flow total, Flow branch) {
    if (total == Flow::Off || branch == Flow::Off) return total == Flow::Off ? branch : total;
    if (total == Flow::Result && branch == Flow::Result) {
      context_.block(Core::Orb);
    } else if (total == Flow::Result || branch == Flow::Result) {
      context_.block(Core::Pop);
      return Flow::On;
    }
    return total;
  }

  // Branches with effects, whose result somebody looks at: each begins with what the condition was.
  void parallel(const Node& node) {
    const Flow before = elements_.flow();
    Device kept;
    if (before == Flow::Result && node.branches.size() > 1) {
      kept = context_.temporary_bit();
      context_.coil(Core::Out, kept);
    }
    Flow total = Flow::Off;
    for (std::size_t k = 0; k < node.branches.size(); ++k) {
      elements_.set_flow(before == Flow::Result && k > 0 ? Flow::On : before);
      if (before == Flow::Result && k > 0) elements_.contact(kept, false);
      series(node.branches[k], true);
      total = join(total, elements_.flow());
    }
    elements_.set_flow(total);
  }

  // Branches with effects, behind which there is nothing: the condition waits on the branch stack.
  void fork(const Node& node) {
    const Flow before = elements_.flow();
    const std::size_t count = node.branches.size();
    for (std::size_t k = 0; k < count; ++k) {
      elements_.set_flow(before);
      if (before == Flow::Result && count > 1) {
        context_.block(k == 0 ? Core::Mps : k + 1 < count ? Core::Mrd : Core::Mpp);
      }
      series(node.branches[k], false);
      if (before != Flow::Result) {
        elements_.replace(before);
      } else if (k + 1 < count) {
        elements_.materialise();  // MRD and MPP take the place of a result
      }
    }
  }

  const Program& program_;
  Context context_;
  Elements elements_;
};

}  // namespace

core::Program lower_ldmicro(const Program& program) { return Walk(program).run(); }

}  // namespace rung::lower
