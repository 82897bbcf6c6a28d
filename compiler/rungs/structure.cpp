// SPDX-License-Identifier: Apache-2.0
#include "rungs/structure.hpp"

#include <fmt/format.h>

#include <utility>

namespace rung {
namespace {

// Walks over the instructions with both stacks. After a fault it keeps quiet until the next
// network begins: what follows a fault is mostly its consequence.
class StructureCheck {
 public:
  StructureCheck(const std::string& file, Dialect dialect, Diagnostics& diagnostics)
      : file_(file), dialect_(dialect), limits_(stack_limits(dialect)), diagnostics_(diagnostics) {}

  void step(const StructureItem& item) {
    if (item.effect == Effect::None) return;
    const bool between = item.effect == Effect::Between || item.effect == Effect::State;
    if (between && !lost_) finish();
    const bool can_begin = last_effect_ == Effect::Output || last_effect_ == Effect::State;
    if (between || (item.effect == Effect::Load && can_begin &&
                    (lost_ || (blocks_.size() == 1 && branches_.empty())))) {
      blocks_.clear();
      branches_.clear();
      lost_ = false;
    }
    if (item.effect == Effect::Unknown) lost_ = true;
    if (!lost_) apply(item);
    last_effect_ = item.effect;
    last_ = &item;
  }

  void finish() {
    if (lost_ || last_ == nullptr) return;
    if (!branches_.empty()) {
      fault(branches_.back().item->position,
            "MPS without MPP: the branch is still open at the end of the network",
            "read the last branch with MPP instead of MRD");
    } else if (last_effect_ != Effect::Output && last_effect_ != Effect::State &&
               last_effect_ != Effect::Between) {
      fault(last_->position,
            fmt::format("the network ends here, but no output uses the result of this {}",
                        last_->name),
            "add the output (OUT, SET, RST, MOV, ...) or remove these contacts");
    }
  }

 private:
  struct Branch {
    const StructureItem* item;
    std::size_t blocks;  // open when MPS kept the result
  };

  void apply(const StructureItem& item) {
    const bool after_state = last_effect_ == Effect::State;
    switch (item.effect) {
      case Effect::State:
        return blocks_.push_back(&item);
      case Effect::Combine:
      case Effect::Join:
      case Effect::Push:
      case Effect::Read:
      case Effect::Pop:
        if (!after_state) break;
        return fault(
            item.position,
            fmt::format("{} right after STL: only LD or an output may stand there", item.name),
            "begin with LD or LDI");
      default:
        break;
    }
    switch (item.effect) {
      case Effect::Load:
        return load(item);
      case Effect::Combine:
        return static_cast<void>(has_result(item));
      case Effect::Join:
        return join(item);
      case Effect::Push:
        return push(item);
      case Effect::Read:
      case Effect::Pop:
        return read(item);
      case Effect::Output:
        return output(item);
      case Effect::State:
      case Effect::Between:
      case Effect::None:
      case Effect::Unknown:
        return;
    }
  }

  void load(const StructureItem& item) {
    blocks_.push_back(&item);
    if (static_cast<int>(blocks_.size()) > limits_.blocks) {
      fault(item.position,
            fmt::format("{} opens block {}, but {} nests at most {}", item.name, blocks_.size(),
                        dialect_name(dialect_), limits_.blocks),
            "join blocks earlier with ANB or ORB, or use a relay (M) for a part of the logic");
    }
  }

  void join(const StructureItem& item) {
    if (!has_result(item)) return;
    if (blocks_.size() < 2) {
      fault(item.position,
            fmt::format("{} joins two blocks, but only the one of {} at line {} is open", item.name,
                        blocks_.back()->name, blocks_.back()->position.line),
            "each block begins with its own LD or LDI; after an output begin a branch with MPS");
      return;
    }
    blocks_.pop_back();
  }

  void push(const StructureItem& item) {
    if (!has_result(item)) return;
    branches_.push_back({&item, blocks_.size()});
    if (static_cast<int>(branches_.size()) > limits_.branches) {
      fault(item.position,
            fmt::format("{} opens branch {}, but {} nests at most {}", item.name, branches_.size(),
                        dialect_name(dialect_), limits_.branches),
            "use a relay (M) for a part of the logic");
    }
  }

  void read(const StructureItem& item) {
    if (branches_.empty()) {
      fault(item.position,
            fmt::format("{} without MPS: no branch is open in this network", item.name),
            "put MPS where the branches part, before the first of them");
      return;
    }
    const Branch& branch = branches_.back();
    if (blocks_.size() != branch.blocks) {
      const bool opened = blocks_.size() > branch.blocks;
      fault(item.position,
            fmt::format("{} with {} block{} open, but its MPS at line {} had {}", item.name,
                        blocks_.size(), blocks_.size() == 1 ? "" : "s", branch.item->position.line,
                        branch.blocks),
            opened ? "join the blocks of the branch with ANB or ORB and use them in an output first"
                   : "join blocks either before MPS or after MPP");
      return;
    }
    if (item.effect == Effect::Pop) branches_.pop_back();
  }

  void output(const StructureItem& item) {
    if (!has_result(item) || blocks_.size() < 2) return;
    fault(
        item.position,
        fmt::format("{} uses the block of {} at line {}, which nothing joins with the one of {} "
                    "at line {}",
                    item.name, blocks_.back()->name, blocks_.back()->position.line,
                    blocks_[blocks_.size() - 2]->name, blocks_[blocks_.size() - 2]->position.line),
        "join them with ANB (in series) or ORB (in parallel) before this output");
    if (branches_.empty()) return;
    diagnostics_.note(file_, branches_.back().item->position,
                      "the branch of this MPS is still open: if the network ends before that LD, "
                      "its last branch needs MPP");
  }

  bool has_result(const StructureItem& item) {
    if (!blocks_.empty()) return true;
    fault(item.position,
          fmt::format("{} has no result to work on: no LD or LDI before it", item.name),
          item.effect == Effect::Combine ? "begin the network with LD or LDI instead"
                                         : "begin the network with LD or LDI");
    return false;
  }

  void fault(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(file_, position, std::move(what), std::move(mend));
    lost_ = true;
  }

  const std::string& file_;
  Dialect dialect_;
  StackLimits limits_;
  Diagnostics& diagnostics_;
  std::vector<const StructureItem*> blocks_;  // by the instruction that opened each
  std::vector<Branch> branches_;
  Effect last_effect_ = Effect::Output;
  const StructureItem* last_ = nullptr;
  bool lost_ = false;
};

}  // namespace

Effect effect_of(Op op) {
  switch (op) {
    case Op::Nop:
      return Effect::None;
    case Op::Inv:
    case Op::Mep:
    case Op::Mef:
      return Effect::Combine;
    case Op::Anb:
    case Op::Orb:
      return Effect::Join;
    case Op::Mps:
      return Effect::Push;
    case Op::Mrd:
      return Effect::Read;
    case Op::Mpp:
      return Effect::Pop;
    case Op::Stl:
      return Effect::State;
    case Op::Label:
    case Op::Mcr:
    case Op::Ret:
    case Op::Sret:
    case Op::Fend:
    case Op::For:
    case Op::Next:
      return Effect::Between;
    default:
      break;
  }
  if (is_load(op)) return Effect::Load;
  return is_contact(op) ? Effect::Combine : Effect::Output;
}

StackLimits stack_limits(Dialect dialect) {
  return dialect == Dialect::Q ? StackLimits{16, 16} : StackLimits{8, 11};
}

void check_structure(const std::string& file, Dialect dialect, std::span<const StructureItem> items,
                     Diagnostics& diagnostics) {
  StructureCheck check(file, dialect, diagnostics);
  for (const StructureItem& item : items) check.step(item);
  check.finish();
}

std::vector<Network> split_networks(std::span<const Instruction> instructions) {
  std::vector<Network> networks;
  std::size_t blocks = 0;
  std::size_t branches = 0;
  std::size_t first = 0;
  std::size_t after_output = 0;  // index after the last output; only NOPs have followed it
  bool can_end = false;
  const auto end_network = [&](std::size_t end) {
    if (end > first) networks.push_back({first, end - first});
    first = end;
    blocks = 0;
    can_end = false;
  };
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const Effect effect = effect_of(instructions[i].op);
    switch (effect) {
      case Effect::None:
        continue;
      case Effect::Load:
        if (can_end && blocks == 1 && branches == 0) end_network(after_output);
        ++blocks;
        break;
      case Effect::Join:
        --blocks;
        break;
      case Effect::Push:
        ++branches;
        break;
      case Effect::Pop:
        --branches;
        break;
      case Effect::Between:
        end_network(i);
        end_network(i + 1);
        continue;
      case Effect::State:
        end_network(i);
        ++blocks;
        break;
      default:
        break;
    }
    can_end = effect == Effect::Output || effect == Effect::State;
    if (can_end) after_output = i + 1;
  }
  end_network(instructions.size());
  return networks;
}

}  // namespace rung
