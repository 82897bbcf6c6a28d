// SPDX-License-Identifier: Apache-2.0
// Random conditions and expressions, executed by the reference, against an evaluator of the
// language's own words (compiler/FLOW.md). RUNG_SEED=N runs program N alone; RUNG_COUNT=N that
// many.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>

#include "programs/random_source.hpp"
#include "support.hpp"

namespace rung::flowchart {
namespace {

constexpr int kWords = 6;
constexpr int kBits = 4;

struct State {
  std::array<std::int16_t, kWords> words{};
  std::array<bool, kBits> bits{};
};

// How firmly an operator holds its operands together.
enum Binding { kOr = 1, kXor, kAnd, kNot, kCompare, kSum, kProduct, kSign, kAtom };

struct Node {
  std::string op;  // an operator, or "word", "bit", "constant"
  int value = 0;   // a number, or of which word or bit
  Binding binding = kAtom;
  std::unique_ptr<Node> a, b;
};
using NodePointer = std::unique_ptr<Node>;

NodePointer leaf(std::string op, int value) {
  auto node = std::make_unique<Node>();
  node->op = std::move(op);
  node->value = value;
  return node;
}

NodePointer joined(std::string op, Binding binding, NodePointer a, NodePointer b) {
  auto node = std::make_unique<Node>();
  node->op = std::move(op);
  node->binding = binding;
  node->a = std::move(a);
  node->b = std::move(b);
  return node;
}

int random_constant(RandomSource& random) {
  static constexpr int kEdges[] = {1, 2, -1, 7, -32768, 32767, 255, -7, 16};
  return random.percent(40) ? kEdges[random.below(static_cast<int>(std::size(kEdges)))]
                            : 1 + random.below(300);
}

NodePointer random_words(RandomSource& random, int depth) {
  if (depth == 0 || random.percent(25)) {
    if (random.percent(60)) return leaf("word", random.below(kWords));
    return leaf("constant", random_constant(random));
  }
  struct Choice {
    const char* op;
    Binding binding;
  };
  static constexpr Choice kChoices[] = {{"+", kSum},     {"-", kSum},     {"*", kProduct},
                                        {"/", kProduct}, {"%", kProduct}, {"and", kAnd},
                                        {"or", kOr},     {"xor", kXor},   {"neg", kSign}};
  const Choice& choice = kChoices[random.below(static_cast<int>(std::size(kChoices)))];
  NodePointer a = random_words(random, depth - 1);
  if (choice.binding == kSign) return joined("neg", kSign, std::move(a), nullptr);
  return joined(choice.op, choice.binding, std::move(a), random_words(random, depth - 1));
}

NodePointer random_condition(RandomSource& random, int depth) {
  if (depth == 0 || random.percent(20)) {
    if (random.percent(5)) return leaf("fixed", random.below(2));
    return leaf("bit", random.below(kBits));
  }
  static constexpr const char* kRelations[] = {"=", "<>", "<", ">", "<=", ">="};
  switch (random.below(4)) {
    case 0:
      return joined(kRelations[random.below(6)], kCompare, random_words(random, depth - 1),
                    random_words(random, depth - 1));
    case 1:
      return joined("not", kNot, random_condition(random, depth - 1), nullptr);
    default:
      break;
  }
  const bool both = random.percent(50);
  NodePointer a = random_condition(random, depth - 1);
  return joined(both ? "and" : "or", both ? kAnd : kOr, std::move(a),
                random_condition(random, depth - 1));
}

std::string text_of(const Node& node, RandomSource& random);

// With parentheses where they are needed, and sometimes where they are not.
std::string operand_text(const Node& node, int binding, RandomSource& random) {
  const std::string text = text_of(node, random);
  return node.binding < binding || random.percent(10) ? "(" + text + ")" : text;
}

std::string text_of(const Node& node, RandomSource& random) {
  if (node.op == "word") return "D" + std::to_string(node.value);
  if (node.op == "bit") return "M" + std::to_string(node.value);
  if (node.op == "fixed") return node.value != 0 ? "on" : "off";
  if (node.op == "constant") return std::to_string(node.value);
  if (node.op == "neg") return "-" + operand_text(*node.a, kSign, random);
  if (node.op == "not") return "not " + operand_text(*node.a, kNot, random);
  const int left = node.binding == kCompare ? kSum : node.binding;
  return operand_text(*node.a, left, random) + " " + node.op + " " +
         operand_text(*node.b, node.binding + 1, random);
}

// Nothing where it divides by 0.
std::optional<int> evaluate(const Node& node, const State& state) {
  if (node.op == "word") return state.words.at(static_cast<std::size_t>(node.value));
  if (node.op == "constant") return node.value;
  const std::optional<int> a = evaluate(*node.a, state);
  if (node.op == "neg") return a ? std::optional<int>(static_cast<std::int16_t>(-*a)) : a;
  const std::optional<int> b = evaluate(*node.b, state);
  if (!a || !b) return std::nullopt;
  int result = 0;
  if (node.op == "+") result = *a + *b;
  if (node.op == "-") result = *a - *b;
  if (node.op == "*") result = *a * *b;
  if (node.op == "and") result = *a & *b;
  if (node.op == "or") result = *a | *b;
  if (node.op == "xor") result = *a ^ *b;
  if (node.op == "/" || node.op == "%") {
    if (*b == 0) return std::nullopt;
    result = node.op == "/" ? *a / *b : *a % *b;
  }
  return static_cast<std::int16_t>(result);
}

bool holds(const Node& node, const State& state) {
  if (node.op == "bit") return state.bits.at(static_cast<std::size_t>(node.value));
  if (node.op == "fixed") return node.value != 0;
  if (node.op == "not") return !holds(*node.a, state);
  if (node.binding == kCompare) {
    const std::optional<int> a = evaluate(*node.a, state);
    const std::optional<int> b = evaluate(*node.b, state);
    if (!a || !b) return false;
    if (node.op == "=") return *a == *b;
    if (node.op == "<>") return *a != *b;
    if (node.op == "<") return *a < *b;
    if (node.op == ">") return *a > *b;
    if (node.op == "<=") return *a <= *b;
    return *a >= *b;
  }
  const bool a = holds(*node.a, state);
  const bool b = holds(*node.b, state);
  return node.op == "and" ? a && b : a || b;
}

// Some actions and transitions, the state that they leave, and the step that they lead to.
struct Case {
  std::string text;
  State before, after;
  std::string next = "S";
};

void add_action(Case& one, RandomSource& random) {
  State& state = one.after;
  const bool guarded = random.percent(30);
  const NodePointer guard = random_condition(random, 3);
  const std::string tail = guarded ? " if " + text_of(*guard, random) : "";
  const bool runs = !guarded || holds(*guard, state);
  if (random.percent(60)) {
    const int target = random.below(kWords);
    const NodePointer words = random_words(random, 4);
    one.text += "  D" + std::to_string(target) + " = " + text_of(*words, random) + tail + "\n";
    const std::optional<int> value = evaluate(*words, state);
    if (runs && value) {
      state.words.at(static_cast<std::size_t>(target)) = static_cast<std::int16_t>(*value);
    }
    return;
  }
  const int target = random.below(kBits);
  bool& bit = state.bits.at(static_cast<std::size_t>(target));
  if (guarded) {
    const bool sets = random.percent(50);
    one.text += (sets ? "  set M" : "  reset M") + std::to_string(target) + tail + "\n";
    if (runs) bit = sets;
    return;
  }
  const NodePointer condition = random_condition(random, 4);
  one.text += "  M" + std::to_string(target) + " = " + text_of(*condition, random) + "\n";
  bit = holds(*condition, state);
}

Case random_case(std::uint64_t seed) {
  RandomSource random(seed);
  Case one;
  for (std::int16_t& word : one.before.words) {
    word = static_cast<std::int16_t>(random.percent(30) ? random.below(3) - 1
                                                        : static_cast<int>(random.bits()));
  }
  for (bool& bit : one.before.bits) bit = random.percent(50);
  one.after = one.before;
  static constexpr const char* kDialects[] = {"fx", "q", "paper"};
  one.text = std::string("dialect ") + kDialects[random.below(3)] + "\ntask A start\nstep S\n";
  for (int i = 1 + random.below(6); i > 0; --i) add_action(one, random);
  bool taken = false;
  for (int i = random.below(4); i > 0; --i) {
    const NodePointer condition = random_condition(random, 4);
    const std::string target = "T" + std::to_string(i);
    one.text += "  when " + text_of(*condition, random) + " goto " + target + "\n";
    if (!taken && holds(*condition, one.after)) one.next = target;
    taken = taken || one.next == target;
  }
  if (random.percent(50)) {
    one.text += "  goto T0\n";
    if (!taken) one.next = "T0";
  } else if (one.text.find("when") == std::string::npos) {
    one.next = "T0";  // the next step in the text
  }
  for (int i = 0; i < 4; ++i) one.text += "step T" + std::to_string(i) + "\n  goto S\n";
  return one;
}

void check(std::uint64_t seed) {
  const Case one = random_case(seed);
  const ReadResult result = read_text_of(one.text);
  ASSERT_TRUE(result.chart) << result.messages << one.text;
  FlowRounds rounds(*result.chart);
  for (int i = 0; i < kWords; ++i) {
    rounds.set({DeviceKind::D, static_cast<std::uint32_t>(i)},
               one.before.words.at(static_cast<std::size_t>(i)));
  }
  for (int i = 0; i < kBits; ++i) {
    rounds.set({DeviceKind::M, static_cast<std::uint32_t>(i)},
               one.before.bits.at(static_cast<std::size_t>(i)) ? 1 : 0);
  }
  // What steps before this one may have left there.
  for (std::uint32_t i = 0; i < 12; ++i) rounds.set(scratch(i), static_cast<std::int16_t>(i * 999));
  rounds.run_round();
  for (int i = 0; i < kWords; ++i) {
    EXPECT_EQ(rounds.get({DeviceKind::D, static_cast<std::uint32_t>(i)}),
              one.after.words.at(static_cast<std::size_t>(i)))
        << "D" << i << " of\n"
        << one.text;
  }
  for (int i = 0; i < kBits; ++i) {
    EXPECT_EQ(rounds.get({DeviceKind::M, static_cast<std::uint32_t>(i)}) != 0,
              one.after.bits.at(static_cast<std::size_t>(i)))
        << "M" << i << " of\n"
        << one.text;
  }
  EXPECT_EQ(result.chart->steps.at(rounds.task(0).step).name, one.next) << one.text;
}

TEST(FlowRandom, Expressions) {
  const std::uint64_t first = from_environment("RUNG_SEED", 0);
  const bool alone = std::getenv("RUNG_SEED") != nullptr;
  const std::uint64_t count = alone ? 1 : from_environment("RUNG_COUNT", 1000);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    check(seed);
    if (HasFailure()) {
      FAIL() << "replay: RUNG_SEED=" << seed
             << " build/test/tb/flowchart/unit_flowchart --gtest_filter=FlowRandom.Expressions";
    }
  }
}

}  // namespace
}  // namespace rung::flowchart
