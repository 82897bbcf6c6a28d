// SPDX-License-Identifier: Apache-2.0
#include "lower/lower.hpp"

#include <algorithm>

#include "lower/bits.hpp"
#include "lower/condition.hpp"
#include "lower/contacts.hpp"
#include "lower/context.hpp"
#include "lower/ldmicro.hpp"
#include "lower/timers.hpp"
#include "lower/words.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

// Walks through the program as it would be executed, and leaves a copy of each instruction for each
// time it can be. What a jump skips, or a call does not reach, stands under `live`.
class Walk {
 public:
  explicit Walk(const Program& program)
      : program_(program), context_(program), starts_(program.instructions.size() + 1, false) {
    for (const Network& network : program.networks) starts_[network.first] = true;
    starts_.back() = true;
  }

  core::Program run() {
    begin_timers(context_);
    routine(0);
    return context_.take();
  }

 private:
  struct Jump {
    std::size_t destination;
    Device taken;
  };
  struct Zone {
    int level;  // of MC; -1: a state's
    std::optional<Device> outer_power, outer_live;
  };
  // What a subroutine or the body of a loop has of its own.
  struct Scope {
    std::vector<Jump> jumps;     // taken ones that have not arrived
    std::optional<Device> live;  // without any jump
    std::vector<Zone> zones;
  };

  const Instruction& instruction(std::size_t i) const { return program_.instructions[i]; }

  // From `first` to FEND, SRET or the end of the program.
  void routine(std::size_t first) {
    const Scope outer = std::exchange(scope_, {{}, context_.live(), {}});
    for (std::size_t i = first; i < program_.instructions.size(); ++i) {
      if (instruction(i).op == Op::Fend || instruction(i).op == Op::Sret) break;
      i = execute(i);
    }
    close_network();
    scope_ = outer;
  }

  // Executes instruction i, or all of the loop that begins there; gives the last one it took.
  std::size_t execute(std::size_t i) {
    if (starts_[i]) close_network();
    context_.at(i);
    if (instruction(i).op == Op::For) return loop(i);
    if (between_networks(i)) return i;
    open_network();
    if (lower_contact(context_) || lower_bits(context_) || lower_words(context_) ||
        lower_arithmetic(context_) || lower_shifts(context_) || lower_codes(context_)) {
      return i;
    }
    switch (instruction(i).op) {
      case Op::OutT:
        lower_timer(context_);
        break;
      case Op::OutC:
        lower_counter(context_);
        break;
      case Op::Mc:
        open_master_control();
        break;
      case Op::Cj:
        jump();
        break;
      case Op::Call:
        call(i);
        break;
      default:
        context_.block(Core::Nop);
    }
    return i;
  }

  // What has no result of its own; true if instruction i is that.
  bool between_networks(std::size_t i) {
    switch (instruction(i).op) {
      case Op::Label:
        close_network();
        arrive(i);
        return true;
      case Op::Mcr:
        close_zones(instruction(i).operand(0).value);
        return true;
      case Op::Stl:
        close_network();
        state(i);
        return true;
      case Op::Ret:
        close_state();
        return true;
      case Op::Next:
      case Op::Fend:
      case Op::Sret:
        return true;
      default:
        return false;
    }
  }

  void open_network() {
    if (!open_) context_.begin_network();
    open_ = true;
  }
  void close_network() {
    if (open_) context_.end_network();
    open_ = false;
  }

  std::size_t loop(std::size_t start) {
    const std::size_t end = instruction(start).destination;
    const Scope outer = std::exchange(scope_, {{}, context_.live(), {}});
    for (int n = 0; n < instruction(start).operand(0).value; ++n) {
      for (std::size_t i = start + 1; i < end; ++i) i = execute(i);
      close_network();
    }
    scope_ = outer;
    return end;
  }

  // --- Jumps: live is what it is without them, but for those on their way.
  void jump() {
    Execution execution(context_, {});
    const Device taken = context_.fresh_bit();
    const Device live = context_.fresh_bit();
    context_.coil(Core::Out, taken);
    execution.end();
    if (context_.live()) {
      context_.compute(live, {{*context_.live(), false}, {taken, true}});
    } else {
      context_.compute(live, {{taken, true}});
    }
    scope_.jumps.push_back({context_.source().destination, taken});
    context_.set_live(live);
  }

  void arrive(std::size_t label) {
    const auto here = [&](const Jump& jump) { return jump.destination == label; };
    std::vector<Jump> arrived;
    std::copy_if(scope_.jumps.begin(), scope_.jumps.end(), std::back_inserter(arrived), here);
    if (arrived.empty()) return;
    std::erase_if(scope_.jumps, here);
    if (scope_.jumps.empty()) return context_.set_live(scope_.live);
    const Device live = context_.fresh_bit();
    context_.begin_network();
    context_.contact(Core::Ld, *context_.live());
    for (const Jump& jump : arrived) context_.contact(Core::Or, jump.taken);
    context_.coil(Core::Out, live);
    context_.end_network();
    context_.set_live(live);
  }

  // The subroutine stands where it is called, its rungs within this one if more of this one
  // follows.
  void call(std::size_t i) {
    Execution execution(context_, {});
    const Device called = context_.fresh_bit();
    context_.coil(Core::Out, called);
    execution.end();
    const bool goes_on = !starts_[i + 1];
    if (!goes_on) close_network();
    const auto power = context_.power();
    const auto live = context_.live();
    const std::vector<Device> states = context_.states();
    const bool open = std::exchange(open_, false);
    context_.set_power(std::nullopt);
    context_.set_live(called);
    context_.set_states({});
    routine(context_.source().destination);
    open_ = open;
    context_.at(i);
    context_.set_power(power);
    context_.set_live(live);
    context_.set_states(states);
  }

  // --- Zones
  void open_master_control() {
    const Instruction& source = context_.source();
    const Device power = context_.fresh_bit();
    context_.gate();
    context_.coil(Core::Out, power);
    context_.drive(source.operand(1).device);
    scope_.zones.push_back({source.operand(0).value, context_.power(), context_.live()});
    context_.set_power(power);
  }

  void close_zones(int level) {
    while (!scope_.zones.empty() && scope_.zones.back().level >= level) {
      context_.set_power(scope_.zones.back().outer_power);
      scope_.zones.pop_back();
    }
  }

  void close_state() {
    if (scope_.zones.empty() || scope_.zones.back().level >= 0) return;
    context_.set_power(scope_.zones.back().outer_power);
    context_.set_live(scope_.zones.back().outer_live);
    context_.set_states({});
    scope_.zones.pop_back();
  }

  // s <- s AND NOT left; active <- s (and, in series, the active of the STL before);
  // live <- active OR was; was <- active.
  void state(std::size_t i) {
    const Device state = instruction(i).operand(0).device;
    const bool in_series = i > 0 && instruction(i - 1).op == Op::Stl && !context_.states().empty();
    std::vector<Device> states;
    std::optional<Device> before;
    if (in_series) {
      states = context_.states();
      before = active_;
    }
    close_state();
    states.push_back(state);

    const Device left = context_.memory_of(state, Context::Role::Left);
    const Device was = context_.memory();
    const Device live = context_.fresh_bit();
    active_ = context_.fresh_bit();
    context_.begin_network();
    context_.contact(Core::Ld, left);
    context_.gate_live();
    context_.coil(Core::Rst, state, true);
    context_.coil(Core::Rst, left);
    context_.end_network();
    context_.begin_network();
    context_.contact(Core::Ld, state);
    if (before) context_.contact(Core::And, *before);
    context_.coil(Core::Out, active_);
    context_.end_network();
    context_.begin_network();
    context_.contact(Core::Ld, active_);
    context_.contact(Core::Or, was);
    context_.gate_live();
    context_.coil(Core::Out, live);
    context_.end_network();
    context_.begin_network();
    context_.contact(Core::Ld, active_);
    remember(context_, was);
    context_.end_network();

    scope_.zones.push_back({-1, context_.power(), context_.live()});
    Device power = active_;
    if (context_.power()) {
      power = context_.fresh_bit();
      context_.begin_network();
      context_.contact(Core::Ld, active_);
      context_.contact(Core::And, *context_.power());
      context_.coil(Core::Out, power);
      context_.end_network();
    }
    context_.set_power(power);
    context_.set_live(live);
    context_.set_states(states);
    // An output may follow at once: the state is then its contact.
    const bool follows = i + 1 < program_.instructions.size() && !starts_[i + 1];
    if (follows && !is_load(instruction(i + 1).op)) {
      open_network();
      context_.contact(Core::Ld, active_);
    }
  }

  const Program& program_;
  Context context_;
  std::vector<bool> starts_;  // networks, by instruction
  bool open_ = false;
  Scope scope_;
  Device active_;  // of the last STL
};

}  // namespace

core::Program lower(const Program& program) {
  return program.dialect == Dialect::Ldmicro ? lower_ldmicro(program) : Walk(program).run();
}

}  // namespace rung::lower
