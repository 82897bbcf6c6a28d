// SPDX-License-Identifier: Apache-2.0
#include "soak/watch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rung::tb {
namespace {

// Shorter than any way from a latch to a refresh.
constexpr std::uint64_t kStoppedStep = 16;
// From the last clock of the refresh, counted from the end of the clock with the latch, to the
// pins.
constexpr std::int64_t kToPins = 0;
// From the end of a scan to the safe levels, at a stop.
constexpr std::uint64_t kSettles = 4;

}  // namespace

Watch::Watch(SimulatedController& machine, std::uint64_t seed)
    : machine_(machine), random_(seed), seen_latches_(machine.latches()) {}

void Watch::fail(const std::string& what) const {
  throw Difference(fmt::format("clock {}, program {}, scan {}: {}", machine_.now(),
                               program_ ? program_->seed : 0, program_scans_, what));
}

void Watch::advance(std::uint64_t clocks) {
  const std::uint64_t end = machine_.now() + clocks;
  while (machine_.now() < end) {
    const std::uint64_t until = std::min(end, next_clock());
    machine_.run(until - machine_.now());
    look();
  }
}

std::uint64_t Watch::next_clock() const {
  if (state_ == State::Stopped) return machine_.now() + kStoppedStep;
  if (!refreshed_) return refresh_;
  return latch_ + static_cast<std::uint64_t>(program_->timing.period);
}

void Watch::look() {
  if (state_ == State::Running) {
    look_running();
  } else {
    look_stopped();
  }
}

void Watch::look_running() {
  using Pin = device::PinChange::Pin;
  for (const device::PinChange& change : machine_.changes()) {
    if (change.pin == Pin::Output) {
      const std::uint64_t pin = std::uint64_t{1} << change.index;
      pins_ = change.level ? pins_ | pin : pins_ & ~pin;
      ++changes_;
      if (change.clock == refresh_) continue;
      // The end of the last scan
      if (may_stop_ && refreshed_) {
        stop();
        continue;
      }
      if (state_ == State::Stopped) continue;
      fail(fmt::format("output {} changes at clock {}, the refresh is at {}", change.index,
                       change.clock, refresh_));
    } else if (change.pin == Pin::Run && !change.level) {
      if (!may_stop_ || !refreshed_) fail("it stops");
      stop();
    } else if (change.pin == Pin::Fault) {
      fail("it goes to fault");
    }
  }
  if (state_ == State::Stopped) return;
  if (!refreshed_) {
    if (machine_.now() >= refresh_) refresh();
    return;
  }
  const std::uint64_t next = latch_ + static_cast<std::uint64_t>(program_->timing.period);
  if (machine_.now() < next) return;
  if (machine_.latches() == seen_latches_ + 1 && machine_.latched_at() == next) {
    begin_scan(next);
  } else if (may_stop_ && machine_.latches() == seen_latches_) {
    stop();
  } else {
    fail(fmt::format("the next scan begins at clock {}, not {}", machine_.latched_at(), next));
  }
}

void Watch::begin_scan(std::uint64_t latch) {
  seen_latches_ = machine_.latches();
  latch_ = latch;
  const load::Timing& timing = program_->timing;
  refresh_ =
      latch + static_cast<std::uint64_t>(timing.latch + timing.scan + timing.refresh + kToPins);
  refreshed_ = false;
  // Those of this scan are held.
  for (const io::Bindings::Input& input : program_->bindings.inputs) {
    reference_->set(input.device, ((levels_in_ >> input.pin & 1) != 0) != input.invert ? 1 : 0);
  }
  // What comes and goes before the next latch is nobody's.
  if (random_.percent(5)) {
    ++glitches_;
    for (const io::Bindings::Input& input : program_->bindings.inputs) {
      machine_.set_input(input.pin, random_.percent(50));
    }
  }
}

void Watch::refresh() {
  refreshed_ = true;
  if (write_ && (pins_ >> write_->mark & 1) == (write_->level ? 1U : 0U)) {
    for (const auto& [device, value] : write_->values) reference_->set(device, value);
    write_.reset();
  }
  reference_->run_scan();
  ++scans_;
  ++program_scans_;
  std::uint64_t expected = program_->inverted;
  for (const io::Bindings::Output& output : program_->bindings.outputs) {
    if (reference_->get(output.device) != 0) expected ^= std::uint64_t{1} << output.pin;
  }
  if (pins_ != expected) {
    fail(fmt::format("outputs {:#b}, and the reference has {:#b}", pins_, expected));
  }
  set_inputs();
  if (scanned) scanned();
}

// Before the next latch, in time for it.
void Watch::set_inputs() {
  for (const io::Bindings::Input& input : program_->bindings.inputs) {
    const std::uint64_t pin = std::uint64_t{1} << input.pin;
    if (random_.percent(15)) levels_in_ ^= pin;
    machine_.set_input(input.pin, (levels_in_ & pin) != 0);
  }
}

void Watch::stop() {
  if (state_ == State::Stopped) return;
  state_ = State::Stopped;
  settles_at_ = machine_.now() + kSettles;
  // A pin that keeps its level keeps that of the last refresh.
  std::uint64_t last = program_->inverted;
  for (const io::Bindings::Output& output : program_->bindings.outputs) {
    if (reference_->get(output.device) != 0) last ^= std::uint64_t{1} << output.pin;
  }
  may_be_1_ = program_->safe | (program_->held & last);
  may_be_0_ = ~may_be_1_;
  if (next_) may_show_too(*next_);
}

// It is loaded, pin by pin.
void Watch::may_show_too(const SoakProgram& program) {
  may_be_1_ |= program.safe | program.held;
  may_be_0_ |= ~program.safe;
}

void Watch::check_safe(const char* when) const {
  if ((pins_ & ~may_be_1_) != 0 || (~pins_ & ~may_be_0_) != 0) {
    fail(
        fmt::format("{}: outputs {:#b} are not safe: 1 at most in {:#b}, 0 at most in {:#b}; safe "
                    "since clock {}",
                    when, pins_, may_be_1_, may_be_0_, settles_at_));
  }
}

void Watch::look_stopped() {
  using Pin = device::PinChange::Pin;
  for (const device::PinChange& change : machine_.changes()) {
    if (change.pin != Pin::Output) continue;
    const std::uint64_t pin = std::uint64_t{1} << change.index;
    pins_ = change.level ? pins_ | pin : pins_ & ~pin;
    if (change.clock >= settles_at_) check_safe("stopped");
  }
  if (machine_.now() >= settles_at_) check_safe("stopped");
  if (machine_.latches() == seen_latches_) return;
  if (!next_ || machine_.latches() != seen_latches_ + 1) fail("it starts by itself");
  if (machine_.now() < settles_at_) fail("it starts before it was stopped");
  seen_latches_ = machine_.latches();
  if (next_trips_) {
    ++trips_;
    next_.reset();
    return;
  }
  program_ = std::exchange(next_, nullptr);
  settle(program_);
  may_stop_ = false;
  write_.reset();
  program_scans_ = 0;
  state_ = State::Running;
  reference_ = std::make_unique<Reference>(program_->program, program_->tick_us);
  begin_scan(machine_.latched_at());
}

void Watch::expect_start(Made program, bool trips) {
  may_show_too(*program);
  next_ = std::move(program);
  next_trips_ = trips;
}

void Watch::settle(const Made& program) {
  may_be_1_ = program->safe | program->held;
  may_be_0_ = ~program->safe;
}

void Watch::stopped() {
  if (state_ == State::Running) fail("it does not stop");
  may_stop_ = false;
}

void Watch::lost(const std::vector<Made>& possible) {
  machine_.changes();
  state_ = State::Stopped;
  pins_ = machine_.outputs();
  settles_at_ = machine_.now();
  seen_latches_ = machine_.latches();
  next_.reset();
  may_stop_ = false;
  write_.reset();
  may_be_0_ = ~std::uint64_t{0};
  may_be_1_ = 0;
  for (const Made& program : possible) may_be_1_ |= program->safe | program->held;
  // In case it was in a scan that glitches.
  const auto inputs = static_cast<int>(machine_.board().inputs.size());
  for (int pin = 0; pin < inputs; ++pin) {
    machine_.set_input(pin, (levels_in_ >> pin & 1) != 0);
  }
}

}  // namespace rung::tb
