// SPDX-License-Identifier: Apache-2.0
// Values of a scan as terms over the devices' values at its start: a graph of two-input ANDs and
// inverters in which equal structure is one node, with words as sixteen of its edges. Products and
// quotients are functions of their operands about which nothing is known but that equal operands
// give equal results. Every node is simulated on 512 starts as it is made, random ones at first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rung::prove {

// An edge: twice the node's number, 1 more if inverted. Node 0 is the constant 0.
using Bit = std::uint32_t;
inline constexpr Bit kFalse = 0;
inline constexpr Bit kTrue = 1;
inline Bit inverse(Bit bit) { return bit ^ 1U; }
inline Bit when(bool value) { return value ? kTrue : kFalse; }
using NodeId = std::uint32_t;
inline NodeId node_of(Bit bit) { return bit >> 1; }

using Word = std::array<Bit, 16>;  // the lowest bit first

// Operands and results in words, low words first: {a, b}, {a low, a high, b low, b high}; a
// product; quotient, then remainder.
enum class Function : std::uint8_t { Multiply16, Divide16, Multiply32, Divide32 };
using Numbers = std::array<std::uint16_t, 4>;
// The function itself; 0 where the divisor is 0.
Numbers compute(Function function, const Numbers& operands);

// Values of variables, by their nodes; those that are not there are 0.
using Model = std::unordered_map<NodeId, bool>;

class Terms {
 public:
  Terms();

  Bit variable();
  Word word_variable();

  Bit both(Bit a, Bit b);
  Bit either(Bit a, Bit b) { return inverse(both(inverse(a), inverse(b))); }
  Bit differ(Bit a, Bit b);
  Bit choose(Bit condition, Bit yes, Bit no);

  static Word constant(std::uint16_t value);
  Word choose(Bit condition, const Word& yes, const Word& no);
  Bit differ(const Word& a, const Word& b);
  Bit equal(const Word& a, const Word& b) { return inverse(differ(a, b)); }
  // The sum; `carry` comes in and goes out.
  Word add(const Word& a, const Word& b, Bit& carry);
  Word subtract(const Word& a, const Word& b, Bit& borrow);
  Bit less(const Word& a, const Word& b, Bit borrow = kFalse);  // unsigned: a - borrow < b
  Bit less_signed(const Word& a, const Word& b, Bit borrow = kFalse);
  Word bitwise(Bit (Terms::*function)(Bit, Bit), const Word& a, const Word& b);
  Word rotate_left(const Word& a, const Word& by);  // by the low four bits
  Bit pick(const Word& a, const Word& number);      // of the low four bits
  Bit is_zero(std::span<const Word> words);

  // Two or four words of result, as many as operands.
  std::vector<Word> call(Function function, const std::vector<Word>& operands);
  // The same, for operands that need not look like those of an earlier call to be equal to them:
  // where they are, the results are that call's.
  std::vector<Word> call_like_others(Function function, const std::vector<Word>& operands);

  // ---- the graph ----
  std::size_t size() const { return nodes_.size(); }
  bool is_variable(NodeId node) const { return nodes_[node].left == kNone; }
  Bit left(NodeId node) const { return nodes_[node].left; }
  Bit right(NodeId node) const { return nodes_[node].right; }
  // What `roots` depend on, operands of functions included, in the order in which it was made.
  std::vector<NodeId> cone(std::span<const Bit> roots) const;
  // True for the result of a function, which is no free variable.
  bool is_result(NodeId node) const { return is_variable(node) && nodes_[node].right != kNone; }
  // The bits' values, functions computed.
  std::vector<bool> evaluate(std::span<const Bit> bits, const Model& model) const;

  // ---- simulation ----
  static constexpr std::size_t kRounds = 8;
  using Patterns = std::array<std::uint64_t, kRounds>;
  Patterns simulated(Bit bit) const {
    Patterns out;
    for (std::size_t n = 0; n < kRounds; ++n) out[n] = round(bit, n);
    return out;
  }
  // Takes this start, and 63 that are much like it, for 64 others.
  void learn(const Model& model);
  // A start in which `bit` is 1, or -1.
  int pattern_with(Bit bit) const;
  // The values of the variables among `nodes` in it.
  Model model_of(int pattern, std::span<const NodeId> nodes) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Node {
    std::uint32_t left = kNone;   // kNone: a variable
    std::uint32_t right = kNone;  // of a variable: its number among the results of functions
  };
  struct Call {
    Function function;
    std::vector<Bit> operands;
    std::vector<Word> results;
  };
  struct Result {
    std::uint32_t call;
    std::uint8_t word, bit;
  };

  std::uint64_t round(Bit bit, std::size_t n) const {
    return patterns_[node_of(bit)][n] ^ ((bit & 1U) != 0 ? ~std::uint64_t{0} : 0);
  }
  Bit add_node(Node node, const Patterns& patterns);
  void simulate_call(std::size_t call, std::size_t n);

  std::vector<Node> nodes_;
  std::vector<Patterns> patterns_;
  std::unordered_map<std::uint64_t, NodeId> found_;
  std::map<std::pair<Function, std::vector<Bit>>, std::uint32_t> called_;
  std::vector<Call> calls_;
  std::vector<Result> results_;
  std::size_t learned_ = 0;
  std::mt19937_64 random_{20261127};
};

}  // namespace rung::prove
