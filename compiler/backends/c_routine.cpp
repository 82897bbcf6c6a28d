// SPDX-License-Identifier: Apache-2.0
#include "backends/c_routine.hpp"

#include <algorithm>

namespace rung {
namespace {

std::size_t index_of(const CUnit& unit, const Instruction& instruction) {
  return static_cast<std::size_t>(&instruction - unit.program.instructions.data());
}

std::string_view relation(Relation relation) {
  switch (relation) {
    case Relation::Equal:
      return "==";
    case Relation::NotEqual:
      return "!=";
    case Relation::Less:
      return "<";
    case Relation::Greater:
      return ">";
    case Relation::LessEqual:
      return "<=";
    case Relation::GreaterEqual:
      break;
  }
  return ">=";
}

bool inverts(Op op) { return op == Op::Ldi || op == Op::Ani || op == Op::Ori; }
bool rises(Op op) { return op == Op::LdP || op == Op::AndP || op == Op::OrP; }
bool falls(Op op) { return op == Op::LdF || op == Op::AndF || op == Op::OrF; }
bool in_parallel(Op op) {
  return op == Op::Or || op == Op::Ori || op == Op::OrP || op == Op::OrF || op == Op::OrCompare;
}

}  // namespace

CRoutine::CRoutine(CUnit& unit, CRange range) : unit_(unit), range_(range) {
  for (std::size_t i = range_.first; i < range_.end; ++i) {
    const Instruction& instruction = unit_.program.instructions[i];
    if (instruction.op == Op::Cj) labels_.insert(instruction.destination);
  }
}

std::string CRoutine::name(const CUnit& unit, std::size_t label) {
  return fmt::format("@_P{}", unit.program.instructions[label].operand(0).value);
}

// The declarations come first, and are known last.
void CRoutine::write() {
  CSource declarations = unit_.body.empty_copy();
  std::swap(declarations, unit_.body);
  begin_rungs();
  for (std::size_t i = range_.first; i < range_.end; ++i) {
    if (ends_state(i)) close_state();
    source_comment(i);
    instruction(unit_.program.instructions[i]);
  }
  close_state();
  std::swap(declarations, unit_.body);
  const CSource& code = declarations;
  for (const auto& [name, reads] : locals_) unit_.body.line("unsigned {} = 0;", name);
  for (const auto& [name, reads] : locals_) {
    if (!reads) unit_.body.line("(void){};", name);
  }
  unit_.body.append(code);
}

// A state's zone ends at RET and at the next STL; those that follow each other directly are in
// series.
bool CRoutine::ends_state(std::size_t index) const {
  const std::vector<Instruction>& all = unit_.program.instructions;
  const Op op = all[index].op;
  if (op == Op::Stl) return index == range_.first || all[index - 1].op != Op::Stl;
  return op == Op::Ret || op == Op::Fend;
}

void CRoutine::source_comment(std::size_t index) {
  const std::vector<Network>& networks = unit_.program.networks;
  const auto found = std::lower_bound(
      networks.begin(), networks.end(), index,
      [](const Network& network, std::size_t wanted) { return network.first < wanted; });
  if (found == networks.end() || found->first != index || found->count == 0) return;
  unit_.body.blank();
  std::string line =
      fmt::format("/* {} {}, by the lines of its source", unit_.is_ldmicro() ? "Rung" : "Network",
                  found - networks.begin() + 1);
  for (std::size_t i = index; i < index + found->count; ++i) {
    const Instruction& instruction = unit_.program.instructions[i];
    // Where one branch ends and the next begins there is no line that says so.
    if (instruction.text.empty()) continue;
    unit_.body.comment(line);
    line = fmt::format(" * {:5}: {}", instruction.position.line, comment_text(instruction.text));
    for (const Operand& operand : instruction.operands) {
      const auto comment = unit_.program.comments.find(operand.device);
      const bool device = operand.kind == Operand::Kind::Device;
      if (!device || comment == unit_.program.comments.end()) continue;
      line += fmt::format("  [{}]", comment_text(comment->second));
    }
  }
  unit_.body.comment(line + " */");
}

std::string CRoutine::local(const std::string& name, bool reads) {
  bool& read = locals_[name];
  read = read || reads;
  return name;
}

// The variable of a new block. An LD after the outputs of a network begins the next one.
std::string CRoutine::load() {
  if (at_start_ && branches_ == 0) blocks_ = 0;
  at_start_ = false;
  return local(fmt::format("r{}", blocks_++), false);
}

std::string CRoutine::top() {
  // The condition of a rung may lead nowhere, which only its last element would show.
  return local(fmt::format("r{}", std::max(blocks_ - 1, 0)), !unit_.is_ldmicro());
}

std::string CRoutine::power() {
  std::string power;
  for (const int level : levels_) {
    power += (power.empty() ? "" : " & ") + local(fmt::format("n{}", level), true);
  }
  if (!states_.empty()) power += (power.empty() ? "" : " & ") + local("active", true);
  return power;
}

void CRoutine::instruction(const Instruction& instruction) {
  if (instruction.op == Op::Nop) return;
  if (is_contact(instruction.op)) return contact(instruction);
  if (block(instruction) || flow(instruction) || element(instruction)) return;
  output(instruction);
  at_start_ = true;
}

void CRoutine::contact(const Instruction& instruction) {
  const Op op = instruction.op;
  const std::string result = is_load(op) ? load() : top();
  const std::string_view assign = is_load(op) ? "=" : in_parallel(op) ? "|=" : "&=";
  at_start_ = false;
  const COperands operands(unit_, instruction);
  CSource& body = unit_.body;
  if (operands.indexed()) {
    body.open("{{");
    operands.declare_indices();
  }
  if (op == Op::LdCompare || op == Op::AndCompare || op == Op::OrCompare) {
    body.line("{} {} {}({}, {}) {} 0;", result, assign, unit_.helpers.use(CHelper::Compare),
              operands.read_value(0), operands.read_value(1), relation(instruction.relation));
  } else if (rises(op) || falls(op)) {
    const std::string edge = unit_.edge(instruction);
    const std::string bit = operands.read_bit(0);
    if (rises(op)) {
      body.line("{} {} {} & ({} ^ 1u);", result, assign, bit, edge);
    } else {
      body.line("{} {} ({} ^ 1u) & {};", result, assign, bit, edge);
    }
    body.line("{} = (uint8_t){};", edge, bit);
  } else {
    body.line("{} {} {}{};", result, assign, operands.read_bit(0), inverts(op) ? " ^ 1u" : "");
  }
  if (operands.indexed()) {
    body.line("if ({}) {}();", operands.any_outside(), unit_.helpers.use(CHelper::Fault));
    body.close();
  }
}

// ANB ORB MPS MRD MPP INV MEP MEF.
bool CRoutine::block(const Instruction& instruction) {
  CSource& body = unit_.body;
  switch (instruction.op) {
    case Op::Anb:
    case Op::Orb: {
      const std::string last = top();
      --blocks_;
      body.line("{} {} {};", top(), instruction.op == Op::Anb ? "&=" : "|=", last);
      break;
    }
    case Op::Inv:
      body.line("{} ^= 1u;", top());
      break;
    case Op::Mep:
    case Op::Mef: {
      const std::string result = top();
      const std::string zones = power();
      const std::string edge = unit_.edge(instruction);
      body.open("{{");
      body.line("const unsigned x = {}{};", result, zones.empty() ? "" : " & " + zones);
      if (instruction.op == Op::Mep) {
        body.line("{} = x & ({} ^ 1u);", result, edge);
      } else {
        body.line("{} = (x ^ 1u) & {};", result, edge);
      }
      body.line("{} = (uint8_t)x;", edge);
      body.close();
      break;
    }
    case Op::Mps:
      body.line("{} = {};", local(fmt::format("s{}", branches_++), false), top());
      break;
    case Op::Mrd:
      body.line("{} = {};", top(), local(fmt::format("s{}", branches_ - 1), true));
      break;
    case Op::Mpp:
      body.line("{} = {};", top(), local(fmt::format("s{}", --branches_), true));
      break;
    default:
      return false;
  }
  at_start_ = false;
  return true;
}

void CRoutine::output(const Instruction& instruction) {
  CCondition condition;
  condition.result = top();
  condition.power = power();
  condition.states = states_;
  condition.cond = condition.power.empty()
                       ? condition.result
                       : fmt::format("({} & {})", condition.result, condition.power);
  condition.executed = condition.cond;
  CSource& body = unit_.body;
  if (instruction.pulse) {
    const std::string edge = unit_.edge(instruction);
    condition.executed = local("pulse", true);
    body.line("pulse = {} & ({} ^ 1u);", condition.cond, edge);
    body.line("{} = (uint8_t){};", edge, condition.cond);
  }
  if (instruction.op == Op::Cj) return jump(instruction, condition.executed);
  if (instruction.op == Op::Call) {
    return body.line("if ({}) {}();", bare(condition.executed),
                     name(unit_, instruction.destination));
  }
  if (instruction.op == Op::Mc) {
    const int level = instruction.operand(0).value;
    // Its condition still has the power of the zones around it alone.
    body.line("{} = {};", local(fmt::format("n{}", level), false), bare(condition.cond));
    body.code(COperands(unit_, instruction).set_bit(1, fmt::format("n{}", level)));
    local(fmt::format("n{}", level), true);
    if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) {
      levels_.push_back(level);
    }
    return;
  }
  using Writer = bool (*)(CUnit&, const Instruction&, const CCondition&);
  for (const Writer writer : {write_timers_counters, write_words, write_arithmetic, write_rotates,
                              write_shifts, write_blocks, write_bits}) {
    if (writer(unit_, instruction, condition)) return;
  }
}

void CRoutine::jump(const Instruction& instruction, const std::string& executed) {
  if (instruction.destination >= range_.end)
    return unit_.body.line("if ({}) return;", bare(executed));
  unit_.body.line("if ({}) goto P{};", bare(executed),
                  unit_.program.instructions[instruction.destination].operand(0).value);
}

// What stands between networks.
bool CRoutine::flow(const Instruction& instruction) {
  CSource& body = unit_.body;
  const std::size_t index = index_of(unit_, instruction);
  switch (instruction.op) {
    case Op::Label:
      // Labels that only CALL names are the beginnings of functions.
      if (labels_.contains(index)) body.line("P{}: ;", instruction.operand(0).value);
      return true;
    case Op::Mcr: {
      const int level = instruction.operand(0).value;
      std::erase_if(levels_, [&](int each) { return each >= level; });
      break;
    }
    case Op::Stl:
      state(index);
      break;
    case Op::For: {
      const std::string counter = local(fmt::format("k{}", loops_++), true);
      body.open("for ({0} = 0; {0} < {1}u; ++{0}) {{", counter, instruction.operand(0).value);
      break;
    }
    case Op::Next:
      --loops_;
      body.close();
      break;
    case Op::Fend:
      body.line("return;");
      break;
    case Op::Ret:
    case Op::Sret:
      break;
    default:
      return false;
  }
  at_start_ = true;
  blocks_ = 0;
  if (instruction.op == Op::Stl) {
    // An output right after it starts from the state.
    body.line("{} = 1;", load());
    at_start_ = true;
  }
  return true;
}

// An STL that follows another one directly is in series with it.
void CRoutine::state(std::size_t index) {
  CSource& body = unit_.body;
  const std::vector<Instruction>& all = unit_.program.instructions;
  const bool continues = index > range_.first && all[index - 1].op == Op::Stl;
  const bool is_continued = index + 1 < range_.end && all[index + 1].op == Op::Stl;
  const Device device = all[index].operand(0).device;
  states_.push_back(device);
  const std::string place = unit_.layout.place(device);
  const std::string left = fmt::format("@.S_left[{}]", unit_.layout.number(device));
  body.line("if ({}) {} = 0;", left, place);
  body.line("{} = 0;", left);
  body.line("{} {} {};", local("active", true), continues ? "&=" : "=", place);
  if (is_continued) return;
  // When it goes off, its zone is executed once more, without power.
  const std::string edge = unit_.edge(all[index]);
  body.line("{} = active | {};", local("runs", true), edge);
  body.line("{} = (uint8_t)active;", edge);
  body.open("if (runs) {{");
}

void CRoutine::close_state() {
  if (!states_.empty()) unit_.body.close();
  states_.clear();
}

}  // namespace rung
