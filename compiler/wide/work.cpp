// SPDX-License-Identifier: Apache-2.0
#include "wide/work.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>

namespace rung::wide {
namespace {

using core::Op;
using values::inverted;
using values::kFalse;
using values::kTrue;
using values::node_of;
using values::NodeKind;
using values::Values;
using values::Word;
using values::WordOp;

// The operation may leave its targets as they are.
bool keeps(const WordOp& op) { return op.gate != kTrue || op.op == Op::Div || op.op == Op::Div32; }

// The operation may set the error flag, which the controller sees even if nobody sees its results.
bool may_divide_by_zero(const WordOp& op) {
  if (op.op != Op::Div && op.op != Op::Div32) return false;
  const std::size_t first = op.op == Op::Div ? 1 : 2;  // of the divisor's words
  return std::all_of(
      op.operands.begin() + static_cast<std::ptrdiff_t>(first), op.operands.end(),
      [](const Word& word) { return word.kind != Word::Kind::Constant || word.value == 0; });
}

bool is_result(const Word& word) { return word.kind == Word::Kind::Result; }

// What is worth computing: what somebody sees between scans, what that needs, and hidden devices
// whose value at the start of the scan is used by it.
class Needs {
 public:
  Needs(const Values& values, bool all)
      : values_(values),
        nodes(values.nodes.size(), false),
        operations(values.operations.size(), false) {
    if (all) {
      for (const auto& write : values.bit_writes) need(write.value);
      for (std::size_t i = 0; i < operations.size(); ++i) need_operation(static_cast<int>(i));
    }
    for (std::size_t i = 0; i < operations.size(); ++i) {
      if (may_divide_by_zero(values.operations[i])) need_operation(static_cast<int>(i));
    }
    for (const auto& [device, literal] : values.bits) {
      if (values::is_visible(device) || all) bits.insert(device), need(literal);
    }
    for (const auto& [device, word] : values.words) {
      if (values::is_visible(device) || all) words.insert(device), need(word);
    }
    follow();
  }

 private:
  const Values& values_;

 public:
  std::vector<bool> nodes, operations;
  std::set<Device> bits, words;  // devices whose last value is kept

 private:
  void need(Literal literal) {
    if (nodes[node_of(literal)]) return;
    nodes[node_of(literal)] = true;
    waiting_nodes_.push_back(node_of(literal));
  }

  void need(const Word& word) {
    if (is_result(word)) need_operation(word.operation);
    if (word.kind != Word::Kind::Start) return;
    const auto found = values_.words.find(word.device);
    if (found == values_.words.end() || !words.insert(word.device).second) return;
    need(found->second);
  }

  void need_operation(std::int32_t id) {
    if (operations[id]) return;
    operations[id] = true;
    waiting_operations_.push_back(id);
  }

  void follow() {
    while (!waiting_nodes_.empty() || !waiting_operations_.empty()) {
      if (!waiting_nodes_.empty()) {
        const values::Node& node = values_.nodes[waiting_nodes_.back()];
        waiting_nodes_.pop_back();
        if (node.kind == NodeKind::And) need(node.left), need(node.right);
        if (node.kind == NodeKind::Test) need_operation(node.operation);
        if (node.kind != NodeKind::Start) continue;
        const auto found = values_.bits.find(node.device);
        if (found != values_.bits.end() && bits.insert(node.device).second) need(found->second);
        continue;
      }
      const WordOp& op = values_.operations[waiting_operations_.back()];
      waiting_operations_.pop_back();
      need(op.gate);
      for (const Word& word : op.operands) need(word);
      for (const Literal bit : op.bits) need(bit);
      if (!keeps(op)) continue;
      for (const Word& word : op.keep) need(word);
    }
  }

  std::vector<NodeId> waiting_nodes_;
  std::vector<std::int32_t> waiting_operations_;
};

Cut one_input(NodeId node) {
  Cut cut;
  cut.leaves[0] = node;
  cut.size = 1;
  cut.table = 0b10;
  return cut;
}

std::uint16_t inverse(const Cut& cut) {
  return static_cast<std::uint16_t>(~cut.table & ((1U << (1U << cut.size)) - 1));
}

class Maker {
 public:
  Maker(const Values& values, const Machine& machine, const WorkOptions& options)
      : values_(values), machine_(machine), merge_(options.merge), needs_(values, !options.merge) {}

  Work make() {
    work_.provider.assign(values_.nodes.size(), kNone);
    work_.made.resize(values_.operations.size());
    for (std::size_t i = 0; i < values_.operations.size(); ++i) {
      work_.made[i].resize(values_.operations[i].outputs);
    }
    cover_bits();
    for (std::size_t i = 0; i < values_.operations.size(); ++i) {
      if (needs_.operations[i]) add_operation(static_cast<std::int32_t>(i));
    }
    place_captures();
    settle_bits();
    settle_words();
    join_homes();
    return std::move(work_);
  }

 private:
  // ---- bits ----
  void cover_bits() {
    std::vector<NodeId> roots, gates;
    const auto root = [&](Literal literal) {
      if (node_of(literal) != 0) roots.push_back(node_of(literal));
    };
    for (const Device device : needs_.bits) root(values_.bits.at(device));
    if (!merge_) {
      for (const auto& write : values_.bit_writes) root(write.value);
    }
    for (std::size_t i = 0; i < values_.operations.size(); ++i) {
      if (!needs_.operations[i]) continue;
      const WordOp& op = values_.operations[i];
      for (const Literal bit : op.bits) root(bit);
      if (op.gate != kTrue) gates.push_back(node_of(op.gate));
    }
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    cover_ = cover(values_, roots, gates, machine_.arity);
    for (std::size_t i = 0; i < values_.nodes.size(); ++i) {
      if (!cover_.look_up[i]) continue;
      work_.provider[i] = add(cover_.cuts[i], 2 * static_cast<NodeId>(i));
      work_.look_ups.back().flag = cover_.captures[i];
    }
  }

  std::int32_t add(const Cut& cut, Literal value) {
    LookUp made;
    made.cut = cut;
    made.value = value;
    if (inverted(value)) made.cut.table = inverse(cut);
    work_.look_ups.push_back(made);
    return static_cast<std::int32_t>(work_.look_ups.size()) - 1;
  }

  // One more look-up of a value. What reads a flag does so once: all others read it.
  std::int32_t add_again(Literal value) {
    const NodeId node = node_of(value);
    const bool leaf = values_.nodes[node].kind != NodeKind::And;
    if (node == 0) return add(Cut{}, value);
    if (leaf || cover_.captures[node] != kNone) return add(one_input(node), value);
    return add(cover_.cuts[node], value);
  }

  bool kept_from_start(Device device) const { return values_.starts.contains(device); }

  // Each device gets a place: that of a look-up which computes its last value. Two devices share
  // one if no look-up reads what either holds at the start of the scan, so that a write of the host
  // to one is seen by nobody as a write to the other (MERGING.md).
  void settle_bits() {
    std::set<std::int32_t> taken;
    std::set<std::int32_t> shared;
    std::map<Device, std::size_t> writers;
    for (const auto& write : values_.bit_writes) writers[write.device] = write.instruction;
    for (const Device device : needs_.bits) {
      const Literal value = values_.bits.at(device);
      const bool alone = !merge_ || kept_from_start(device) || !values::is_visible(device);
      std::int32_t place = kNone;
      const std::int32_t provider = node_of(value) == 0 ? kNone : work_.provider[node_of(value)];
      if (provider != kNone && work_.look_ups[provider].value == value &&
          (!taken.contains(provider) || (!alone && shared.contains(provider)))) {
        place = provider;
      } else if (!alone) {
        const auto found = copies_.find(value);
        if (found != copies_.end()) place = found->second;
      }
      if (place == kNone) {
        place = add_again(value);
        if (!alone) copies_[value] = place;
      }
      taken.insert(place);
      if (!alone) shared.insert(place);
      work_.bit_home[device] = place;
      work_.look_ups[place].instruction = writers.at(device);
    }
    if (merge_) return;
    // Each write has a place of its own; the last of a device is where it lives.
    for (const auto& write : values_.bit_writes) {
      work_.bit_writes.push_back(write.last ? work_.bit_home.at(write.device)
                                            : add_again(write.value));
    }
  }

  // ---- words ----
  std::int32_t gate_of(const WordOp& op) {
    if (op.gate == kTrue) return kNone;
    const std::int32_t gate = add_again(op.gate);
    work_.look_ups[gate].instruction = op.instruction;
    return gate;
  }

  WordWork& add_word(Group& group, Opcode opcode, int offset) {
    WordWork word;
    word.opcode = opcode;
    word.offset = offset;
    group.words.push_back(word);
    return group.words.back();
  }

  void add_result(Group& group, std::int32_t id, Opcode opcode, int offset, int output, Word s1,
                  Word s2) {
    const WordOp& op = values_.operations[id];
    WordWork& word = add_word(group, opcode, offset);
    word.s1 = s1;
    word.s2 = s2;
    word.writes = true;
    word.operation = id;
    word.output = output;
    word.gate = gate_of(op);
    word.keeps = keeps(op);
    if (word.keeps) word.keep = op.keep[output];
    work_.made[id][output] = {static_cast<std::int32_t>(work_.groups.size()),
                              static_cast<std::int32_t>(group.words.size()) - 1};
  }

  void add_silent(Group& group, Opcode opcode, int offset, const Word& s1, const Word& s2) {
    WordWork& word = add_word(group, opcode, offset);
    word.s1 = s1;
    word.s2 = s2;
  }

  void add_operation(std::int32_t id) {
    const WordOp& op = values_.operations[id];
    Group group;
    group.instruction = op.instruction;
    std::vector<Word> in = op.operands;
    const Word none;
    switch (op.op) {
      case Op::Mov:
        add_result(group, id, Opcode::Mv, 0, 0, none, in[0]);
        break;
      case Op::Add:
      case Op::Sub:
      case Op::Wand:
      case Op::Wor:
      case Op::Wxor:
      case Op::Rol:
      case Op::Minu:
        one_constant(in[0], in[1]);
        add_result(group, id, simple(op.op), 0, 0, in[0], in[1]);
        break;
      case Op::Eq:
      case Op::Lt:
      case Op::Ltu:
      case Op::Tb:
        one_constant(in[0], in[1]);
        add_silent(group, simple(op.op), 0, in[0], in[1]);
        break;
      case Op::Lt32:
        one_constant(in[0], in[2]);
        one_constant(in[1], in[3]);
        add_silent(group, Opcode::Ltu, 0, in[0], in[2]);
        add_silent(group, Opcode::Ltc, constant::distance_carry, in[1], in[3]);
        break;
      case Op::Add32:
      case Op::Sub32:
        one_constant(in[0], in[2]);
        one_constant(in[1], in[3]);
        add_result(group, id, op.op == Op::Add32 ? Opcode::Add : Opcode::Sub, 0, 0, in[0], in[2]);
        add_result(group, id, op.op == Op::Add32 ? Opcode::Adc : Opcode::Sbc,
                   constant::distance_carry, 1, in[1], in[3]);
        break;
      case Op::Mul:
      case Op::Div:
        one_constant(in[0], in[1]);
        multiply_divide(group, id, in);
        break;
      case Op::Mul32:
      case Op::Div32:
        one_constant(in[0], in[2]);
        one_constant(in[1], in[3]);
        multiply_divide_wide(group, id, in);
        break;
      case Op::Gather:
        gather(group, id);
        break;
      default:
        assert(false && "no word operation");
    }
    if (op.outputs == 0) group.test = id;
    operation_group(id) = static_cast<std::int32_t>(work_.groups.size());
    work_.groups.push_back(std::move(group));
  }

  std::int32_t& operation_group(std::int32_t id) {
    if (groups_.size() < work_.made.size()) groups_.resize(work_.made.size(), kNone);
    return groups_[id];
  }

  static Opcode simple(Op op) {
    switch (op) {
      case Op::Add:
        return Opcode::Add;
      case Op::Sub:
        return Opcode::Sub;
      case Op::Wand:
        return Opcode::Wand;
      case Op::Wor:
        return Opcode::Wor;
      case Op::Wxor:
        return Opcode::Wxor;
      case Op::Rol:
        return Opcode::Rol;
      case Op::Minu:
        return Opcode::Minu;
      case Op::Eq:
        return Opcode::Eq;
      case Op::Lt:
        return Opcode::Lt;
      case Op::Ltu:
        return Opcode::Ltu;
      default:
        return Opcode::Tb;
    }
  }

  // An instruction has one constant at most: of two the first comes from a word that is moved.
  void one_constant(Word& first, const Word& second) {
    if (first.kind != Word::Kind::Constant || second.kind != Word::Kind::Constant) return;
    Group group;
    WordWork& word = add_word(group, Opcode::Mv, 0);
    word.s2 = first;
    word.writes = true;
    word.operation = static_cast<std::int32_t>(work_.made.size());
    work_.made.push_back({{static_cast<std::int32_t>(work_.groups.size()), 0}});
    first = {};
    first.kind = Word::Kind::Result;
    first.operation = word.operation;
    work_.groups.push_back(std::move(group));
  }

  void multiply_divide(Group& group, std::int32_t id, const std::vector<Word>& in) {
    const bool divide = values_.operations[id].op == Op::Div;
    add_silent(group, divide ? Opcode::Div : Opcode::Mul, 0, in[0], in[1]);
    group.divides = divide;
    const int latency = divide ? machine_.div : machine_.mul;
    for (int i = 0; i < values_.operations[id].outputs; ++i) {
      const Opcode low = divide ? Opcode::Quo : Opcode::Mull;
      const Opcode high = divide ? Opcode::Rem : Opcode::Mulh;
      add_result(group, id, i == 0 ? low : high, latency + i, i, {}, {});
    }
  }

  void multiply_divide_wide(Group& group, std::int32_t id, const std::vector<Word>& in) {
    static constexpr Opcode kResults[] = {Opcode::Mw0, Opcode::Mw1, Opcode::Mw2, Opcode::Mw3};
    const bool divide = values_.operations[id].op == Op::Div32;
    add_silent(group, Opcode::Ldh, 0, in[1], in[3]);
    add_silent(group, divide ? Opcode::Divd : Opcode::Muld, 1, in[0], in[2]);
    const int latency = divide ? constant::distance_div32 : constant::distance_mul32;
    for (int i = 0; i < values_.operations[id].outputs; ++i) {
      add_result(group, id, kResults[i], 1 + latency + i, i, {}, {});
    }
    group.wide = true;
  }

  // The bits enter from the highest on, as many a step as a look-up has operands.
  void gather(Group& group, std::int32_t id) {
    std::vector<Literal> bits = values_.operations[id].bits;
    std::reverse(bits.begin(), bits.end());
    const auto arity = static_cast<std::size_t>(machine_.arity);
    while (bits.size() % arity != 0) bits.insert(bits.begin(), kFalse);
    const int steps = static_cast<int>(bits.size() / arity);
    for (int i = 0; i < steps; ++i) {
      WordWork& word = add_word(group, Opcode::Get, i);
      word.clear = i == 0;
      Cut cut;
      cut.size = machine_.arity;
      for (std::size_t k = 0; k < arity; ++k) cut.leaves[k] = enter(bits[i * arity + k]);
      word.gather = add(cut, kFalse);
      work_.look_ups.back().gather = true;
    }
    // No other GET may come between the last one and MVA.
    for (int i = 0; i + 1 < constant::distance_accumulator; ++i) {
      add_silent(group, Opcode::Nop, steps + i, {}, {});
    }
    add_result(group, id, Opcode::Mva, steps - 1 + constant::distance_accumulator, 0, {}, {});
  }

  // What GET takes is not inverted.
  NodeId enter(Literal bit) {
    if (!inverted(bit)) return node_of(bit);
    const auto [place, fresh] = entered_.try_emplace(bit, kNone);
    if (fresh) {
      // A node of its own behind the graph's, which only its look-up computes.
      place->second = static_cast<std::int32_t>(work_.provider.size());
      const std::int32_t made = add_again(bit);
      work_.provider.push_back(made);
    }
    return place->second;
  }

  void place_captures() {
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) {
      const std::int32_t test = work_.look_ups[i].flag;
      if (test == kNone) continue;
      Group& group = work_.groups[groups_[test]];
      group.captures.push_back(
          {group.words.back().offset + constant::distance_flag, static_cast<std::int32_t>(i)});
    }
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      const auto own = static_cast<std::int32_t>(g);
      for (const Group::Capture& each : work_.groups[g].captures) {
        work_.look_ups[each.look_up].group = own;
      }
      for (const WordWork& word : work_.groups[g].words) {
        if (word.gate != kNone) work_.look_ups[word.gate].group = own;
        if (word.gather != kNone) work_.look_ups[word.gather].group = own;
      }
    }
  }

  void settle_words() {
    for (const Device device : needs_.words) {
      const Word& word = values_.words.at(device);
      assert(is_result(word));
      work_.word_home[device] = work_.made[word.operation][word.output];
    }
  }

  // ---- units ----
  std::int32_t root(std::int32_t group) {
    while (parent_[group] != group) group = parent_[group] = parent_[parent_[group]];
    return group;
  }

  // What keeps a value finds it in its own lane.
  void join_homes() {
    parent_.resize(work_.groups.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      for (const WordWork& word : work_.groups[g].words) {
        if (!word.keeps) continue;
        std::int32_t from = kNone;
        if (is_result(word.keep)) {
          from = work_.made[word.keep.operation][word.keep.output].group;
        } else if (word.keep.kind == Word::Kind::Start) {
          from = work_.word_home.at(word.keep.device).group;
        }
        if (from != kNone) parent_[root(from)] = root(static_cast<std::int32_t>(g));
      }
    }
    std::map<std::int32_t, std::int32_t> homes;
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      const auto made = homes.try_emplace(root(static_cast<std::int32_t>(g)),
                                          static_cast<std::int32_t>(homes.size()));
      work_.groups[g].home = made.first->second;
    }
    work_.homes = static_cast<int>(homes.size());
  }

  const Values& values_;
  const Machine& machine_;
  bool merge_;
  Needs needs_;
  Work work_;
  Cover cover_;
  std::map<Literal, std::int32_t> copies_;
  std::map<Literal, NodeId> entered_;
  std::vector<std::int32_t> groups_;  // by operation
  std::vector<std::int32_t> parent_;
};

}  // namespace

Work make_work(const Values& values, const Machine& machine, const Latch& latch,
               const WorkOptions& options) {
  Work work = Maker(values, machine, options).make();
  work.latch = latch;
  return work;
}

}  // namespace rung::wide
