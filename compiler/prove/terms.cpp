// SPDX-License-Identifier: Apache-2.0
#include "prove/terms.hpp"

#include <algorithm>
#include <bit>

namespace rung::prove {
namespace {

std::int64_t number(const Numbers& operands, std::size_t first, bool wide) {
  if (!wide) return static_cast<std::int16_t>(operands[first]);
  return static_cast<std::int32_t>(std::uint32_t{operands[first + 1]} << 16 | operands[first]);
}

}  // namespace

Numbers compute(Function function, const Numbers& operands) {
  const bool wide = function == Function::Multiply32 || function == Function::Divide32;
  const bool divide = function == Function::Divide16 || function == Function::Divide32;
  const std::int64_t a = number(operands, 0, wide);
  const std::int64_t b = number(operands, wide ? 2 : 1, wide);
  if (divide && b == 0) return {};
  const int width = wide ? 32 : 16;
  const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
  const std::uint64_t all = divide ? (static_cast<std::uint64_t>(a / b) & mask) |
                                         static_cast<std::uint64_t>(a % b) << width
                                   : static_cast<std::uint64_t>(a * b);
  Numbers out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint16_t>(all >> 16 * i);
  return out;
}

Terms::Terms() {
  nodes_.push_back({0, 0});
  patterns_.push_back({});
}

Bit Terms::add_node(Node node, const Patterns& patterns) {
  nodes_.push_back(node);
  patterns_.push_back(patterns);
  return static_cast<Bit>(nodes_.size() - 1) << 1;
}

Bit Terms::variable() {
  Patterns patterns;
  for (std::uint64_t& word : patterns) word = random_();
  return add_node({}, patterns);
}

Word Terms::word_variable() {
  Word out;
  for (Bit& bit : out) bit = variable();
  return out;
}

Bit Terms::both(Bit a, Bit b) {
  if (a > b) std::swap(a, b);
  if (a == kFalse || a == inverse(b)) return kFalse;
  if (a == kTrue || a == b) return b;
  // `b` is the later node: it may have been made of `a`.
  if (!is_variable(node_of(b))) {
    const Bit l = left(node_of(b));
    const Bit r = right(node_of(b));
    const bool inverted = (b & 1U) != 0;
    if (a == l || a == r) return inverted ? both(a, inverse(a == l ? r : l)) : b;
    if (a == inverse(l) || a == inverse(r)) return inverted ? a : kFalse;
  }
  const std::uint64_t key = std::uint64_t{a} << 32 | b;
  const auto [place, fresh] = found_.try_emplace(key, static_cast<NodeId>(nodes_.size()));
  if (!fresh) return place->second << 1;
  Patterns patterns;
  for (std::size_t n = 0; n < kRounds; ++n) patterns[n] = round(a, n) & round(b, n);
  return add_node({a, b}, patterns);
}

Bit Terms::differ(Bit a, Bit b) {
  const Bit sign = (a ^ b) & 1U;
  a &= ~1U;
  b &= ~1U;
  if (a == kFalse) return b ^ sign;
  if (b == kFalse) return a ^ sign;
  return either(both(a, inverse(b)), both(inverse(a), b)) ^ sign;
}

Bit Terms::choose(Bit condition, Bit yes, Bit no) {
  if (yes == no) return yes;
  if (yes == inverse(no)) return differ(condition, no);
  return either(both(condition, yes), both(inverse(condition), no));
}

Word Terms::constant(std::uint16_t value) {
  Word out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = when((value >> i & 1) != 0);
  return out;
}

Word Terms::choose(Bit condition, const Word& yes, const Word& no) {
  Word out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = choose(condition, yes[i], no[i]);
  return out;
}

Bit Terms::differ(const Word& a, const Word& b) {
  Bit out = kFalse;
  for (std::size_t i = 0; i < a.size(); ++i) out = either(out, differ(a[i], b[i]));
  return out;
}

Word Terms::add(const Word& a, const Word& b, Bit& carry) {
  Word out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Bit half = differ(a[i], b[i]);
    out[i] = differ(half, carry);
    carry = either(both(a[i], b[i]), both(half, carry));
  }
  return out;
}

Word Terms::subtract(const Word& a, const Word& b, Bit& borrow) {
  Word complement;
  for (std::size_t i = 0; i < b.size(); ++i) complement[i] = inverse(b[i]);
  Bit carry = inverse(borrow);
  const Word out = add(a, complement, carry);
  borrow = inverse(carry);
  return out;
}

Bit Terms::less(const Word& a, const Word& b, Bit borrow) {
  subtract(a, b, borrow);
  return borrow;
}

Bit Terms::less_signed(const Word& a, const Word& b, Bit borrow) {
  // As unsigned numbers once both are 32,768 more.
  Word high_a = a;
  Word high_b = b;
  high_a[15] = inverse(a[15]);
  high_b[15] = inverse(b[15]);
  return less(high_a, high_b, borrow);
}

Word Terms::bitwise(Bit (Terms::*function)(Bit, Bit), const Word& a, const Word& b) {
  Word out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = (this->*function)(a[i], b[i]);
  return out;
}

Word Terms::rotate_left(const Word& a, const Word& by) {
  Word out = a;
  for (std::size_t stage = 0; stage < 4; ++stage) {
    Word rotated;
    for (std::size_t i = 0; i < out.size(); ++i) rotated[(i + (1U << stage)) % 16] = out[i];
    out = choose(by[stage], rotated, out);
  }
  return out;
}

Bit Terms::pick(const Word& a, const Word& number) {
  Word out = a;
  for (std::size_t stage = 0; stage < 4; ++stage) {
    for (std::size_t i = 0; i < 8U >> stage; ++i) {
      out[i] = choose(number[stage], out[2 * i + 1], out[2 * i]);
    }
  }
  return out[0];
}

Bit Terms::is_zero(std::span<const Word> words) {
  Bit any = kFalse;
  for (const Word& word : words) {
    for (const Bit bit : word) any = either(any, bit);
  }
  return inverse(any);
}

std::vector<Word> Terms::call(Function function, const std::vector<Word>& operands) {
  std::vector<Bit> bits;
  for (const Word& word : operands) bits.insert(bits.end(), word.begin(), word.end());
  const auto [place, fresh] =
      called_.try_emplace({function, bits}, static_cast<std::uint32_t>(calls_.size()));
  if (!fresh) return calls_[place->second].results;

  Call call{function, bits, {}};
  for (std::size_t i = 0; i < operands.size(); ++i) {
    Word& word = call.results.emplace_back();
    for (std::size_t j = 0; j < word.size(); ++j) {
      const auto number = static_cast<std::uint32_t>(results_.size());
      results_.push_back({static_cast<std::uint32_t>(calls_.size()), static_cast<std::uint8_t>(i),
                          static_cast<std::uint8_t>(j)});
      word[j] = add_node({kNone, number}, {});
    }
  }
  calls_.push_back(std::move(call));
  for (std::size_t n = 0; n < kRounds; ++n) simulate_call(calls_.size() - 1, n);
  return calls_.back().results;
}

void Terms::simulate_call(std::size_t call, std::size_t n) {
  const Call& one = calls_[call];
  for (const Word& word : one.results) {
    for (const Bit bit : word) patterns_[node_of(bit)][n] = 0;
  }
  for (std::size_t start = 0; start < 64; ++start) {
    Numbers numbers{};
    for (std::size_t i = 0; i < one.operands.size(); ++i) {
      const std::uint64_t value = round(one.operands[i], n) >> start & 1;
      numbers[i / 16] = static_cast<std::uint16_t>(numbers[i / 16] | value << i % 16);
    }
    const Numbers results = compute(one.function, numbers);
    for (std::size_t i = 0; i < 16 * one.results.size(); ++i) {
      const std::uint64_t value = results[i / 16] >> i % 16 & 1;
      patterns_[node_of(one.results[i / 16][i % 16])][n] |= value << start;
    }
  }
}

void Terms::learn(const Model& model) {
  // The first round stays as it is.
  const std::size_t n = 1 + learned_++ % (kRounds - 1);
  std::size_t next_call = 0;
  for (NodeId node = 1; node < nodes_.size(); ++node) {
    if (is_result(node)) {
      // The results of a call stand together, behind its operands.
      const Result& result = results_[nodes_[node].right];
      if (result.call >= next_call) simulate_call(next_call++, n);
    } else if (is_variable(node)) {
      const auto found = model.find(node);
      const bool value = found != model.end() && found->second;
      const std::uint64_t others = random_() & random_() & random_() & ~std::uint64_t{1};
      patterns_[node][n] = (value ? ~std::uint64_t{0} : 0) ^ others;
    } else {
      patterns_[node][n] = round(left(node), n) & round(right(node), n);
    }
  }
}

std::vector<Word> Terms::call_like_others(Function function, const std::vector<Word>& operands) {
  const std::size_t before = calls_.size();
  std::vector<Word> results = call(function, operands);
  if (calls_.size() == before) return results;
  for (std::size_t i = 0; i < before; ++i) {
    const Call other = calls_[i];  // a copy of it: what follows makes nodes, but no calls
    if (other.function != function) continue;
    Bit equal = kTrue;
    for (std::size_t n = 0; n < other.operands.size(); ++n) {
      equal = both(equal, inverse(differ(other.operands[n], operands[n / 16][n % 16])));
    }
    for (std::size_t n = 0; n < results.size(); ++n) {
      results[n] = choose(equal, other.results[n], results[n]);
    }
  }
  return results;
}

std::vector<NodeId> Terms::cone(std::span<const Bit> roots) const {
  std::vector<NodeId> out;
  std::vector<NodeId> open;
  std::vector<bool> seen(nodes_.size(), false);
  const auto visit = [&](Bit bit) {
    const NodeId node = node_of(bit);
    if (node == 0 || seen[node]) return;
    seen[node] = true;
    open.push_back(node);
  };
  for (const Bit root : roots) visit(root);
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    out.push_back(node);
    if (is_result(node)) {
      for (const Bit bit : calls_[results_[nodes_[node].right].call].operands) visit(bit);
    } else if (!is_variable(node)) {
      visit(left(node));
      visit(right(node));
    }
  }
  // A node's number is above those of what it was made of.
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<bool> Terms::evaluate(std::span<const Bit> bits, const Model& model) const {
  std::unordered_map<NodeId, bool> values{{0, false}};
  const auto value = [&](Bit bit) { return values.at(node_of(bit)) != ((bit & 1U) != 0); };
  std::map<std::uint32_t, Numbers> results;
  for (const NodeId node : cone(bits)) {
    if (is_result(node)) {
      const Result& result = results_[nodes_[node].right];
      const auto [place, fresh] = results.try_emplace(result.call);
      if (fresh) {
        const Call& call = calls_[result.call];
        Numbers numbers{};
        for (std::size_t i = 0; i < call.operands.size(); ++i) {
          const int bit = value(call.operands[i]) ? 1 << i % 16 : 0;
          numbers[i / 16] = static_cast<std::uint16_t>(numbers[i / 16] | bit);
        }
        place->second = compute(call.function, numbers);
      }
      values[node] = (place->second[result.word] >> result.bit & 1) != 0;
    } else if (is_variable(node)) {
      const auto found = model.find(node);
      values[node] = found != model.end() && found->second;
    } else {
      values[node] = value(left(node)) && value(right(node));
    }
  }
  std::vector<bool> out;
  for (const Bit bit : bits) out.push_back(value(bit));
  return out;
}

int Terms::pattern_with(Bit bit) const {
  for (std::size_t n = 0; n < kRounds; ++n) {
    const std::uint64_t starts = round(bit, n);
    if (starts != 0) return static_cast<int>(64 * n) + std::countr_zero(starts);
  }
  return -1;
}

Model Terms::model_of(int pattern, std::span<const NodeId> nodes) const {
  Model model;
  const auto n = static_cast<std::size_t>(pattern);
  for (const NodeId node : nodes) {
    if (is_variable(node)) model[node] = (patterns_[node][n / 64] >> n % 64 & 1) != 0;
  }
  return model;
}

}  // namespace rung::prove
