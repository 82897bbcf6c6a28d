// SPDX-License-Identifier: Apache-2.0
// Executes a program's actions on values in place of bits and words.
#include <algorithm>
#include <bit>
#include <cassert>

#include "values/values.hpp"

namespace rung::values {
namespace {

using core::Op;
using logic::Action;

class Builder {
 public:
  Builder(const logic::Logic& logic, const core::Program& program) : logic_(logic) {
    values_.nodes.emplace_back();
    for (const core::ConstantWord& word : program.constants) tables_[word.device] = word.value;
    literals_.assign(logic.nodes.size(), kFalse);
  }

  Values build() {
    // Nodes and actions of Logic are each in the order of the program; a node's epoch says how many
    // actions stand before it.
    std::size_t next = 0;
    for (std::size_t i = 0; i < logic_.actions.size(); ++i) {
      for (; next < logic_.nodes.size() && logic_.nodes[next].epoch <= static_cast<std::int32_t>(i);
           ++next) {
        add_node(next);
      }
      act(logic_.actions[i]);
    }
    mark_last(values_.bit_writes);
    mark_last(values_.word_writes);
    return std::move(values_);
  }

 private:
  void add_node(std::size_t i) {
    const logic::Node& node = logic_.nodes[i];
    const auto of = [&](logic::NodeId id) { return literals_[id]; };
    switch (node.kind) {
      case logic::NodeKind::Leaf:
        // What is current here is what the leaf means: versions are named by actions in order.
        literals_[i] = bit(node.device);
        break;
      case logic::NodeKind::NotLeaf:
      case logic::NodeKind::Not:
        literals_[i] = inverse(of(node.left));
        break;
      case logic::NodeKind::And:
        literals_[i] = values_.land(of(node.left), of(node.right));
        break;
      case logic::NodeKind::Or:
        literals_[i] = values_.lor(of(node.left), of(node.right));
        break;
    }
  }

  Literal bit(Device device) {
    const auto found = values_.bits.find(device);
    return found != values_.bits.end() ? found->second : values_.start(device);
  }

  Word word(Device device) const {
    const auto found = values_.words.find(device);
    if (found != values_.words.end()) return found->second;
    const auto in_table = tables_.find(device);
    if (in_table != tables_.end()) return constant(in_table->second);
    Word value;
    value.kind = Word::Kind::Start;
    value.device = device;
    return value;
  }

  Word operand(const core::WordSource& source) const {
    if (!source.constant) return word(source.device);
    Word value;
    value.value = source.value;
    return value;
  }

  static Word constant(int value) {
    Word word;
    word.value = static_cast<std::int16_t>(value);
    return word;
  }

  void write(Device device, Literal value) {
    values_.bits[device] = value;
    values_.bit_writes.push_back({device, value, instruction_, false});
  }

  void write(Device device, const Word& value) {
    values_.words[device] = value;
    values_.word_writes.push_back({device, value, instruction_, false});
  }

  std::int32_t append(WordOp op) {
    op.instruction = instruction_;
    values_.operations.push_back(std::move(op));
    return static_cast<std::int32_t>(values_.operations.size()) - 1;
  }

  Literal test(Op op, std::vector<Word> operands) {
    WordOp made;
    made.op = op;
    made.operands = std::move(operands);
    made.outputs = 0;
    return values_.test(append(std::move(made)));
  }

  // device <- value under the gate.
  void move(Device device, const Word& value, Literal gate) {
    if (gate == kFalse) return;
    WordOp made;
    made.operands = {value};
    made.gate = gate;
    made.keep = {word(device)};
    made.targets = {device};
    write_outputs(std::move(made));
  }

  void write_outputs(WordOp made) {
    made.outputs = static_cast<int>(made.targets.size());
    const std::vector<Device> targets = made.targets;
    const std::int32_t id = append(std::move(made));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      Word value;
      value.kind = Word::Kind::Result;
      value.operation = id;
      value.output = static_cast<std::int32_t>(i);
      write(targets[i], value);
    }
  }

  void act(const Action& action) {
    instruction_ = action.instruction;
    const Literal gate = action.condition == logic::kNoNode ? kTrue : literals_[action.condition];
    const auto old = [&](std::size_t i) { return bit(action.targets[i]); };
    std::vector<Word> operands;
    for (const logic::Operand& each : action.operands) operands.push_back(operand(each.source));
    switch (action.op) {
      case Op::Out:
        return write(action.targets[0], gate);
      case Op::Set:
        return write(action.targets[0], values_.lor(gate, old(0)));
      case Op::Rst:
        return write(action.targets[0], values_.land(inverse(gate), old(0)));
      case Op::Eq:
      case Op::Lt:
      case Op::Ltu:
      case Op::Lt32:
      case Op::Tb:
        return write(action.targets[0],
                     values_.choose(gate, test(action.op, std::move(operands)), old(0)));
      case Op::LoadBit:
      case Op::LoadWord:
      case Op::StoreWord:
      case Op::SetBit:
      case Op::RstBit:
        return indexed(action, gate, operands);
      default:
        break;
    }
    if (gate == kFalse) return;
    WordOp made;
    made.op = action.op;
    made.operands = std::move(operands);
    for (const logic::Read& each : action.reads) made.bits.push_back(bit(each.device));
    made.gate = gate;
    made.targets = action.targets;
    for (const Device device : action.targets) made.keep.push_back(word(device));
    write_outputs(std::move(made));
  }

  // An index becomes one bit a device of the window: its low bits, decoded. That it is inside is
  // the lowering's matter; outside, nothing that is executed uses what is found.
  void indexed(const Action& action, Literal gate, const std::vector<Word>& operands) {
    const bool load = action.op == Op::LoadWord || action.op == Op::LoadBit;
    std::vector<Device> window;
    if (load) {
      for (const logic::Read& each : action.reads) window.push_back(each.device);
    } else {
      window = action.targets;
    }
    std::sort(window.begin(), window.end());
    // `head` may stand anywhere in the window, and an index before it is negative.
    const auto head = std::lower_bound(window.begin(), window.end(), action.head);
    const int first = static_cast<int>(window.begin() - head);
    const int bits = std::bit_width(window.size());
    std::vector<Literal> index;
    for (int i = 0; i < bits; ++i) index.push_back(test(Op::Tb, {operands[0], constant(i)}));
    const auto chosen = [&](std::size_t place) {
      const int number = first + static_cast<int>(place);
      Literal all = kTrue;
      for (int i = 0; i < bits; ++i) {
        all = values_.land(all, (number >> i & 1) != 0 ? index[i] : inverse(index[i]));
      }
      return all;
    };
    if (action.op == Op::LoadBit) {
      Literal value = kFalse;
      for (std::size_t i = 0; i < window.size(); ++i) {
        value = values_.lor(value, values_.land(chosen(i), bit(window[i])));
      }
      return write(action.targets[0], values_.choose(gate, value, bit(action.targets[0])));
    }
    for (std::size_t i = 0; i < window.size(); ++i) {
      const Literal hit = values_.land(gate, chosen(i));
      if (action.op == Op::LoadWord) {
        move(action.targets[0], word(window[i]), hit);
      } else if (action.op == Op::StoreWord) {
        move(window[i], operands[1], hit);
      } else if (action.op == Op::SetBit) {
        write(window[i], values_.lor(hit, bit(window[i])));
      } else {
        write(window[i], values_.land(inverse(hit), bit(window[i])));
      }
    }
  }

  template <typename T>
  static void mark_last(std::vector<T>& writes) {
    std::map<Device, bool> seen;
    for (auto each = writes.rbegin(); each != writes.rend(); ++each) {
      each->last = seen.emplace(each->device, true).second;
    }
  }

  const logic::Logic& logic_;
  Values values_;
  std::map<Device, std::int16_t> tables_;  // words of the program's tables: nobody writes them
  std::vector<Literal> literals_;
  std::size_t instruction_ = 0;
};

}  // namespace

Values build(const logic::Logic& logic, const core::Program& program) {
  return Builder(logic, program).build();
}

}  // namespace rung::values
