// SPDX-License-Identifier: Apache-2.0
#include "flowchart/statements.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "flowchart/operand.hpp"
#include "rung_flow.hpp"
#include "rungs/devices.hpp"

namespace rung::flowchart {
namespace {

constexpr std::string_view kReadForm = "read D100 count 4 from BOARD at 20";
constexpr std::string_view kWriteForm = "write D100 count 4 to BOARD at 20";
constexpr std::string_view kWhenForm = "when CONDITION goto STEP, or when CONDITION end";
constexpr std::string_view kWaitForm = "wait 500 ms, wait 2 s, wait 3 min or wait CONDITION";
constexpr std::string_view kActionForm = "D0 = D1 + 1, set M0, start TASK, or one of them if M0";
constexpr std::string_view kBitForm = "Y0 = X0 and not X1";
constexpr int kLastVariable = 0xFFFF;

constexpr int kMostMilliseconds = 30'000;  // longer waits are counted in tenths of a second
constexpr int kMostTenths = 30'000;

}  // namespace

StepReader::StepReader(const World& world, SourcePosition position, std::string text)
    : world_(world), text_(std::move(text)) {
  parts_.emplace_back();
  part().position = position;
  part().text = text_;
}

std::vector<Part> StepReader::finish() {
  for (Part& each : parts_) {
    if (!each.whens.empty() && !each.waits() && each.otherwise.kind == Exit::Kind::Next) {
      each.otherwise.kind = Exit::Kind::Stay;
    }
  }
  return std::move(parts_);
}

void StepReader::line(const Line& line) {
  const Token& first = line.front();
  if (closed_) {
    throw Refusal{first.position,
                  fmt::format("the step has ended in line {}: this is never done", closed_line_),
                  "put it before, or begin another step"};
  }
  if (waited_) open_part(first);
  Cursor cursor(line);
  const bool assigns = line.size() > 2 && line[1].is("=");
  if (first.kind != Token::Kind::Word || (assigns && !is_keyword(first.text))) {
    return assignment(cursor);
  }
  if (first.text == "read") {
    advance(Phase::Read, first);
    return read_transfer(cursor, false);
  }
  if (first.text == "write") {
    advance(Phase::Write, first);
    return read_transfer(cursor, true);
  }
  if (first.text == "set" || first.text == "reset") return bit_command(cursor);
  if (first.text == "start" || first.text == "stop") return command(cursor);
  if (first.text == "when") return when(cursor);
  if (first.text == "wait") return wait(cursor);
  if (first.text == "goto" || first.text == "end") {
    part().otherwise = read_exit(cursor);
    cursor.expect_end(first.text == "end" ? "end" : "goto STEP");
    closed_ = true;
    closed_line_ = first.position.line;
    return;
  }
  assignment(cursor);
}

void StepReader::open_part(const Token& token) {
  parts_.emplace_back();
  part().position = token.position;
  part().text = text_;
  phase_ = Phase::Read;
  commands_ = 0;
  waited_ = false;
  transfers_ = false;
}

void StepReader::advance(Phase phase, const Token& token) {
  const bool twice =
      (phase == Phase::Read && part().read) || (phase == Phase::Write && part().write);
  if (twice) {
    throw Refusal{token.position, fmt::format("a second {}: a step has one at most", token.text),
                  "begin another step for it"};
  }
  const bool actions = phase_ == Phase::Actions && phase == Phase::Read;
  if (phase < phase_ || actions) {
    std::string_view before = phase_ == Phase::Actions ? "the first action"
                              : phase_ == Phase::Write ? "the write"
                                                       : "the transitions";
    throw Refusal{token.position, fmt::format("this has to stand before {}", before),
                  "a step is read, actions, write, transitions, in this order; else begin another"};
  }
  phase_ = phase;
}

void StepReader::read_transfer(Cursor& cursor, bool write) {
  const std::string_view form = write ? kWriteForm : kReadForm;
  transfers_ = true;
  Transfer transfer;
  transfer.position = cursor.take().position;
  const Token& head = cursor.peek();
  if (head.kind != Token::Kind::Word || is_keyword(head.text)) {
    throw Refusal{head.position, fmt::format("{} where a word device has to stand", shown(head)),
                  fmt::format("write {}", form)};
  }
  cursor.take();
  if (cursor.accept("count")) {
    transfer.count = cursor.number(1, flow::flow_block_words, "words", form);
  }
  transfer.head = transfer_head(head, transfer.count);
  cursor.expect(write ? "to" : "from", form);
  const Token& board = cursor.name("a board", form);
  transfer.board = world_.board_names.find(board);
  cursor.expect("at", form);
  const Token& first = cursor.peek();
  transfer.first = cursor.number(0, kLastVariable, "a variable", form);
  if (transfer.first + transfer.count - 1 > kLastVariable) {
    throw Refusal{first.position,
                  fmt::format("{} words from variable {} on go beyond the last variable, {}",
                              transfer.count, transfer.first, kLastVariable),
                  "begin at a lower variable"};
  }
  cursor.expect_end(form);
  check_exclusive(transfer.board, board.position);
  (write ? part().write : part().read) = transfer;
}

void StepReader::check_exclusive(std::size_t board, SourcePosition position) const {
  const std::optional<Transfer>& other = parts_.back().read;
  if (!other || other->board == board || !world_.boards[board].exclusive ||
      !world_.boards[other->board].exclusive) {
    return;
  }
  throw Refusal{position,
                fmt::format("a second exclusive board: the step holds {} until it ends",
                            world_.boards[other->board].name),
                "write in a step of its own, so that no two tasks wait for each other"};
}

Device StepReader::transfer_head(const Token& token, int count) const {
  const Operand operand = read_operand(token, world_.dialect);
  const DeviceKind kind = operand.device.kind;
  if (operand.kind != Operand::Kind::Device ||
      (kind != DeviceKind::D && kind != DeviceKind::R && kind != DeviceKind::W)) {
    throw Refusal{token.position,
                  fmt::format("{}: transfers move the words of D, R and W", shown(token)),
                  "move other values there in an action: D0 = K4X0"};
  }
  const std::uint32_t last = device_range(kind, world_.dialect).last;
  if (operand.device.number + static_cast<std::uint32_t>(count) - 1 > last) {
    throw Refusal{token.position,
                  fmt::format("{} words from {} on go beyond the last device", count, shown(token)),
                  fmt::format("the last one is {}", device_name({kind, last}, world_.dialect))};
  }
  return operand.device;
}

Scope StepReader::scope(std::string no_failed, std::string mend) const {
  return {world_.dialect, world_.tasks, std::move(no_failed), std::move(mend), false, {}};
}

Scope StepReader::action_scope() const {
  if (transfers_) return scope({}, {});
  return scope("failed: no read stands before the actions",
               "a write comes after them: ask for it in a `when` behind it");
}

void StepReader::note(const Scope& scope) {
  for (const std::size_t task : scope.asked) world_.asked[task] = true;
}

void StepReader::guard(Cursor& cursor, Action& action) {
  if (cursor.accept("if")) {
    Scope scope = action_scope();
    action.guard = read_condition(cursor, scope);
    note(scope);
  }
  cursor.expect_end(kActionForm);
}

void StepReader::bit_command(Cursor& cursor) {
  const Token& verb = cursor.take();
  advance(Phase::Actions, verb);
  Action action;
  action.kind = verb.text == "set" ? Action::Kind::Set : Action::Kind::Reset;
  action.position = verb.position;
  const Token& bit = cursor.peek();
  if (bit.kind != Token::Kind::Word || is_keyword(bit.text)) {
    throw Refusal{bit.position, fmt::format("{} where a bit has to stand", shown(bit)),
                  fmt::format("write {} M0", verb.text)};
  }
  cursor.take();
  action.target = read_operand(bit, world_.dialect);
  if (!is_bit(action.target)) {
    throw Refusal{bit.position,
                  fmt::format("{}: {} takes a bit, this is a word", shown(bit), verb.text),
                  "write D0 = 0 for a word, D0.3 for one of its bits"};
  }
  check_writable(bit, action.target, world_.dialect);
  guard(cursor, action);
  part().actions.push_back(std::move(action));
}

void StepReader::command(Cursor& cursor) {
  const Token& verb = cursor.take();
  advance(Phase::Actions, verb);
  Action action;
  action.kind = verb.text == "start" ? Action::Kind::Start : Action::Kind::Stop;
  action.position = verb.position;
  action.task = world_.tasks.find(cursor.name("a task", fmt::format("{} TASK", verb.text)));
  guard(cursor, action);
  if (++commands_ > flow::flow_task_commands) {
    throw Refusal{
        verb.position,
        fmt::format("more than {} starts and stops in one step", flow::flow_task_commands),
        "begin another step for the others"};
  }
  if (action.kind == Action::Kind::Start) world_.started[action.task] = true;
  part().actions.push_back(std::move(action));
}

void StepReader::assignment(Cursor& cursor) {
  const Token& target = cursor.peek();
  if (target.kind != Token::Kind::Word || is_keyword(target.text)) {
    throw Refusal{
        target.position, fmt::format("{}: no line of a step begins with this", shown(target)),
        "it begins with read, a device, set, reset, start, stop, write, when, goto, end or "
        "wait"};
  }
  cursor.take();
  Action action;
  action.position = target.position;
  action.target = read_operand(target, world_.dialect);
  advance(Phase::Actions, target);
  check_writable(target, action.target, world_.dialect);
  cursor.expect("=", is_bit(action.target) ? kBitForm : kActionForm);
  Scope scope = action_scope();
  if (is_bit(action.target)) {
    action.kind = Action::Kind::Bit;
    action.source = read_condition(cursor, scope);
    if (cursor.peek().is("if")) {
      throw Refusal{cursor.peek().position, "if behind the value of a bit: it has one in any case",
                    "write it into the condition, or use set M0 if ..., reset M0 if ..."};
    }
    cursor.expect_end(kBitForm);
  } else {
    action.kind = Action::Kind::Word;
    action.source = read_words(cursor, scope);
    guard(cursor, action);
  }
  note(scope);
  part().actions.push_back(std::move(action));
}

Exit StepReader::read_exit(Cursor& cursor) {
  Exit exit;
  exit.position = cursor.peek().position;
  if (cursor.accept("end")) {
    exit.kind = Exit::Kind::End;
    return exit;
  }
  cursor.expect("goto", kWhenForm);
  exit.kind = Exit::Kind::Step;
  const Token& step = cursor.name("a step", "goto STEP");
  const auto owner = world_.owners.find(step.text);
  if (!world_.steps.index(step.text) && owner != world_.owners.end()) {
    throw Refusal{
        step.position,
        fmt::format("{}: a step of another task, {}", shown(step), rung::shown(owner->second)),
        "goto leads to steps of the same task; other tasks are started and stopped"};
  }
  exit.step = world_.steps.find(step);
  return exit;
}

void StepReader::when(Cursor& cursor) {
  const Token& first = cursor.take();
  advance(Phase::Whens, first);
  Scope scope = transfers_ ? this->scope({}, {})
                           : this->scope("failed: this step has neither read nor write",
                                         "ask in the step that has the transfer");
  Transition transition;
  transition.condition = read_condition(cursor, scope);
  transition.exit = read_exit(cursor);
  cursor.expect_end(kWhenForm);
  note(scope);
  part().asks_failed = part().asks_failed || scope.failed;
  part().whens.push_back(std::move(transition));
}

void StepReader::wait(Cursor& cursor) {
  part().wait_position = cursor.take().position;
  waited_ = true;
  const Token& amount = cursor.peek();
  if (amount.kind != Token::Kind::Number) {
    Scope scope = this->scope("failed: a wait only looks at what is there",
                              "ask for it in a `when`, before the wait");
    part().wait_until = read_condition(cursor, scope);
    cursor.expect_end(kWaitForm);
    return note(scope);
  }
  const int number =
      cursor.number(1, kMostTenths * 100, "milliseconds, seconds or minutes", kWaitForm);
  const Token& unit = cursor.take();
  const std::int64_t factor = unit.is("ms") ? 1 : unit.is("s") ? 1000 : unit.is("min") ? 60'000 : 0;
  if (factor == 0) {
    throw Refusal{unit.position, fmt::format("{} where ms, s or min has to stand", shown(unit)),
                  fmt::format("write {}", kWaitForm)};
  }
  cursor.expect_end(kWaitForm);
  const std::int64_t milliseconds = number * factor;
  if (milliseconds > std::int64_t{kMostTenths} * 100) {
    throw Refusal{amount.position, "a wait of more than 50 minutes",
                  "wait several times, or count with a counter of the ladder"};
  }
  part().wait_tenths = milliseconds > kMostMilliseconds;
  part().wait_ticks =
      static_cast<int>(part().wait_tenths ? (milliseconds + 99) / 100 : milliseconds);
}

}  // namespace rung::flowchart
