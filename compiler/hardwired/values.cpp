// SPDX-License-Identifier: Apache-2.0
#include "hardwired/values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <stdexcept>

namespace rung::hardwired {
namespace {

using core::Op;
using logic::Action;
using logic::kNoNode;
using logic::kStart;
using logic::Node;
using logic::NodeId;
using logic::NodeKind;
using logic::Version;

// A longer one gets a wire of its own.
constexpr std::size_t kLongestExpression = 70;

const char* range(bool word) { return word ? "[15:0] " : ""; }

bool is_window(Op op) { return op == Op::StoreWord || op == Op::SetBit || op == Op::RstBit; }

}  // namespace

Values::Values(const Program& source, const logic::Logic& logic, const Interface& interface,
               const Plan& plan)
    : logic_(logic), interface_(interface), plan_(plan), names_(source) {}

std::string Values::wire(Device device, Version version) {
  if (version == kStart) return interface_.start(device).text;
  return fmt::format("{}_a{}", names_.of(device), version);
}

std::string Values::read(Device device, Version version, std::int32_t clock) {
  const Start& start = interface_.start(device);
  if (version == kStart && start.kind == Start::Kind::Fixed) return start.text;
  const std::int32_t made = plan_.made(device, version, interface_);
  const std::int32_t kept = plan_.kept(device, version);
  if (clock < made || (version != kStart && !plan_.is_live(device, version))) {
    throw std::logic_error(fmt::format("hard-wired: value {} of {} is read in clock {}", version,
                                       names_.of(device), clock));
  }
  if (clock == made) return wire(device, version);
  if (clock <= kept) {
    registers_.insert(device);
    return register_name(device);
  }
  const auto [place, fresh] = held_.try_emplace({device, version}, holds_.size());
  if (fresh) {
    const std::string which = version == kStart ? "start" : fmt::format("a{}", version);
    holds_.push_back({fmt::format("{}_{}_h", names_.of(device), which), kept, {}, is_word(device)});
    holds_.back().value = read(device, version, kept);
  }
  return holds_[place->second].name;
}

std::string Values::operand(const logic::Operand& operand, std::int32_t clock) {
  if (operand.source.constant) return literal({DeviceKind::D, 0}, operand.source.value);
  return read(operand.source.device, operand.version, clock);
}

std::string Values::pair(const Action& action, std::size_t low, std::int32_t clock) {
  return fmt::format("{{{}, {}}}", operand(action.operands.at(low + 1), clock),
                     operand(action.operands.at(low), clock));
}

// The low `bits` of a word operand.
std::string Values::low_bits(const logic::Operand& word, std::int32_t clock, int bits,
                             const std::string& name, std::string& wires) {
  std::string value = operand(word, clock);
  // Only of a name can a part be taken.
  if (value.find('\'') != std::string::npos || value.back() == ']') {
    wires += fmt::format("  wire [15:0] {} = {};\n", name, value);
    value = name;
  }
  return fmt::format("{}[{}:0]", value, bits - 1);
}

std::string Values::make_tree(NodeId id, std::int32_t clock, std::string& wires) {
  const Node& node = logic_.nodes[id];
  switch (node.kind) {
    case NodeKind::Leaf:
      return read(node.device, node.version, clock);
    case NodeKind::NotLeaf:
    case NodeKind::Not: {
      const std::string inner = tree(node.left, clock, wires);
      return inner[0] == '~' ? inner.substr(1) : "~" + inner;
    }
    default: {
      std::string text = tree(node.left, clock, wires);
      // Of a chain of the same kind the inner brackets say nothing.
      const char* sign = node.kind == NodeKind::And ? " & " : " | ";
      const std::string right = tree(node.right, clock, wires);
      if (logic_.nodes[node.left].kind == node.kind && text[0] == '(') {
        text = text.substr(1, text.size() - 2);
      }
      return "(" + text + sign + right + ")";
    }
  }
}

std::string Values::tree(NodeId id, std::int32_t clock, std::string& wires) {
  const auto found = trees_.find({id, clock});
  if (found != trees_.end()) return found->second;
  std::string text = make_tree(id, clock, wires);
  const Node& node = logic_.nodes[id];
  const bool gate = node.kind == NodeKind::And || node.kind == NodeKind::Or;
  if (gate && (node.uses > 1 || text.size() > kLongestExpression)) {
    const std::string name = fmt::format("n{}_c{}", id, clock);
    wires += fmt::format("  wire {} = {};\n", name, text);
    text = name;
  }
  return trees_[{id, clock}] = text;
}

std::string Values::condition(std::size_t i, std::string& wires) {
  const Action& action = logic_.actions[i];
  return action.condition == kNoNode ? "" : tree(action.condition, plan_.clock[i], wires);
}

std::string Values::unit_operand(std::size_t i, int which) {
  const Action& action = logic_.actions[i];
  const std::int32_t clock = plan_.issue[i];
  const bool wide = action.op == Op::Mul32 || action.op == Op::Div32;
  return wide ? pair(action, static_cast<std::size_t>(2 * which), clock)
              : operand(action.operands.at(static_cast<std::size_t>(which)), clock);
}

std::string Values::zero_division(std::size_t i) {
  std::string wires;
  const std::string when = condition(i, wires);
  if (!wires.empty())
    throw std::logic_error("hard-wired: a condition was not made with its action");
  const std::string zero = fmt::format("{}_zero", unit_of(logic_.actions[i].op)->name);
  return when.empty() ? zero : fmt::format("{} & {}", zero, when);
}

std::string Values::comparison(const Action& action, std::int32_t clock) {
  if (action.op == Op::Lt32) {
    return fmt::format("$signed({}) < $signed({})", pair(action, 0, clock), pair(action, 2, clock));
  }
  const std::string a = operand(action.operands.at(0), clock);
  const std::string b = operand(action.operands.at(1), clock);
  if (action.op == Op::Eq) return fmt::format("{} == {}", a, b);
  if (action.op == Op::Ltu) return fmt::format("{} < {}", a, b);
  return fmt::format("$signed({}) < $signed({})", a, b);
}

// A wire from which each target takes its part.
std::string Values::shared(std::size_t i, std::string& wires) {
  const Action& action = logic_.actions[i];
  const std::int32_t clock = plan_.clock[i];
  std::string name;
  switch (action.op) {
    case Op::Add32:
    case Op::Sub32:
      name = fmt::format("a{}_sum", i);
      wires += fmt::format("  wire [31:0] {} = {} {} {};\n", name, pair(action, 0, clock),
                           action.op == Op::Add32 ? '+' : '-', pair(action, 2, clock));
      break;
    case Op::LoadWord:
    case Op::LoadBit: {
      // The window as one number, its first device lowest.
      std::vector<std::string> window;
      for (auto read_ = action.reads.rbegin(); read_ != action.reads.rend(); ++read_) {
        window.push_back(read(read_->device, read_->version, clock));
      }
      const int width = action.op == Op::LoadWord ? 16 : 1;
      name = fmt::format("a{}_window", i);
      wires += fmt::format("  wire [{}:0] {} =\n      {{{}}};\n",
                           width * static_cast<int>(window.size()) - 1, name,
                           fmt::join(window, ",\n       "));
      if (window.size() > 1) {
        const int bits = std::bit_width(window.size() - 1);
        const std::string low =
            low_bits(action.operands.at(0), clock, bits, fmt::format("a{}_word", i), wires);
        wires += fmt::format("  wire [{}:0] a{}_index = {};\n", bits - 1, i, low);
      }
      break;
    }
    default:
      break;
  }
  return name;
}

std::string Values::result(std::size_t i, std::size_t t, std::string& wires) {
  const Action& action = logic_.actions[i];
  const std::int32_t clock = plan_.clock[i];
  const auto source = [&](std::size_t n) { return operand(action.operands.at(n), clock); };
  const auto two = [&](const char* sign) { return source(0) + sign + source(1); };
  switch (action.op) {
    case Op::Mov:
      return source(0);
    case Op::Add:
      return two(" + ");
    case Op::Sub:
      return two(" - ");
    case Op::Wand:
      return two(" & ");
    case Op::Wor:
      return two(" | ");
    case Op::Wxor:
      return two(" ^ ");
    case Op::Minu:
      return fmt::format("({0} < {1} ? {0} : {1})", source(0), source(1));
    case Op::Rol:
      return fmt::format("({0} << ({1} & 16'h000F) | {0} >> (16'd16 - ({1} & 16'h000F)))",
                         source(0), source(1));
    case Op::Add32:
    case Op::Sub32:
      return fmt::format("a{}_sum[{} +: 16]", i, 16 * t);
    case Op::Mul:
    case Op::Mul32:
    case Op::Div:
    case Op::Div32:
      return fmt::format("{}_result[{} +: 16]", unit_of(action.op)->name, 16 * t);
    case Op::Eq:
    case Op::Lt:
    case Op::Ltu:
    case Op::Lt32:
      return "(" + comparison(action, clock) + ")";
    case Op::Tb: {
      const int bit = action.operands.at(1).source.value & 15;
      const logic::Operand& word = action.operands.at(0);
      if (word.source.constant) {
        return fmt::format("1'b{}", static_cast<std::uint16_t>(word.source.value) >> bit & 1);
      }
      std::string value = source(0);
      if (value.find('\'') != std::string::npos || value.back() == ']') {
        const std::string name = fmt::format("a{}_word", i);
        wires += fmt::format("  wire [15:0] {} = {};\n", name, value);
        value = name;
      }
      return fmt::format("{}[{}]", value, bit);
    }
    case Op::Gather: {
      std::vector<std::string> bits;
      for (auto each = action.reads.rbegin(); each != action.reads.rend(); ++each) {
        bits.push_back(read(each->device, each->version, clock));
      }
      std::string text = fmt::format("{}", fmt::join(bits, ", "));
      if (bits.size() < 16) text = fmt::format("{}'b0, {}", 16 - bits.size(), text);
      return "{" + text + "}";
    }
    case Op::LoadWord:
    case Op::LoadBit: {
      const bool word = action.op == Op::LoadWord;
      std::string place;
      if (action.reads.size() > 1) {
        place =
            word ? fmt::format("[{{a{}_index, 4'b0}} +: 16]", i) : fmt::format("[a{}_index]", i);
      }
      return fmt::format("({} < 16'd{} ? a{}_window{} : {})", source(0), action.reads.size(), i,
                         place, word ? "16'h0000" : "1'b0");
    }
    case Op::StoreWord:
      return source(1);
    case Op::SetBit:
      return "1'b1";
    case Op::RstBit:
      return "1'b0";
    default:
      throw std::logic_error("hard-wired: no such action");
  }
}

std::string Values::action(std::size_t i) {
  const Action& action = logic_.actions[i];
  const std::int32_t clock = plan_.clock[i];
  std::string wires;
  const std::string when = condition(i, wires);
  shared(i, wires);
  for (std::size_t t = 0; t < action.targets.size(); ++t) {
    if (!plan_.live[i][t]) continue;
    const Device device = action.targets[t];
    const auto old = [&] {
      return read(device, logic_.current(device, static_cast<Version>(i)), clock);
    };
    std::string value;
    if (action.op == Op::Out) {
      value = when;
    } else if (action.op == Op::Set) {
      value = when.empty() ? "1'b1" : fmt::format("{} | {}", old(), when);
    } else if (action.op == Op::Rst) {
      value = when.empty() ? "1'b0" : fmt::format("{} & ~{}", old(), when);
    } else {
      value = result(i, t, wires);
      std::string whether = when;
      const auto also = [&](const std::string& text) {
        whether = whether.empty() ? text : whether + " & " + text;
      };
      if (is_window(action.op)) {
        also(fmt::format("({} == 16'd{})", operand(action.operands.at(0), clock), t));
      }
      if (action.op == Op::Div || action.op == Op::Div32) {
        also(fmt::format("~{}_zero", unit_of(action.op)->name));
      }
      if (!whether.empty()) value = fmt::format("{} ? {} : {}", whether, value, old());
    }
    wires += fmt::format("  wire {}{} = {};\n", range(is_word(device)),
                         wire(device, static_cast<Version>(i)), value);
  }
  return wires;
}

}  // namespace rung::hardwired
