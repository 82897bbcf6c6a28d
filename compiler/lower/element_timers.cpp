// SPDX-License-Identifier: Apache-2.0
// Timers and counters of LDmicro: variables that count scans and edges.
#include "lower/elements.hpp"

namespace rung::lower {

// less <- T < P; T <- T + 1 where the condition is on and less, 0 where it is off; the condition
// goes on without less.
void Elements::on_delay() {
  const Device timer = variable();
  if (flow_ == Flow::Off) {
    flow_ = Flow::On;
    gated(Core::Mov, {timer}, {constant(0)});
    return replace(Flow::Off);
  }
  const Device counting = less(word(timer), value(1));
  if (flow_ == Flow::On) {
    contact(counting, false);
    gated(Core::Add, {timer}, {word(timer), constant(1)});
    return context_.block(Core::Inv);
  }
  context_.block(Core::Mps);
  contact(counting, false);
  gated(Core::Add, {timer}, {word(timer), constant(1)});
  context_.block(Core::Mrd);
  context_.block(Core::Inv);
  gated(Core::Mov, {timer}, {constant(0)});
  context_.block(Core::Mpp);
  contact(counting, true);
}

// As a program starts, every timer of this kind has run off: T <- P where the condition is off. A
// write of its own for each case, so that T changes once at most.
void Elements::off_delay() {
  const Device timer = variable();
  if (!started_) started_ = context_.fresh_bit();
  const Device less_than = less(word(timer), value(1));
  const Device counting = context_.temporary_bit();
  context_.compute(counting, {{less_than, false}, {*started_, false}});
  materialise();
  context_.block(Core::Mps);
  gated(Core::Mov, {timer}, {constant(0)});
  context_.block(Core::Inv);
  contact(counting, false);
  gated(Core::Add, {timer}, {word(timer), constant(1)});
  context_.block(Core::Mrd);
  context_.block(Core::Inv);
  contact(*started_, true);
  gated(Core::Mov, {timer}, {value(1)});
  context_.block(Core::Mpp);
  context_.contact(Core::Or, counting);
}

void Elements::retentive(bool used) {
  const Device timer = variable();
  const Device counting = less(word(timer), value(1));
  if (flow_ != Flow::Off) {
    contact(counting, false);
    gated(Core::Add, {timer}, {word(timer), constant(1)});
  }
  if (used) replace(counting, true);
}

void Elements::begin_edge() {
  materialise();
  context_.block(Core::Mps);
  contact(context_.memory(), true);
}

void Elements::end_edge() {
  context_.block(Core::Mpp);
  context_.coil(Core::Out, context_.memory());
}

void Elements::count(bool used) {
  const Device counter = variable();
  begin_edge();
  gated(source().op == Op::Ctu ? Core::Add : Core::Sub, {counter}, {word(counter), constant(1)});
  end_edge();
  if (used) replace(less(word(counter), value(1)), true);
}

// The next value is worked out before, because the counter gets the last one only.
void Elements::circular() {
  const Device counter = variable();
  const Device next = context_.temporary_word();
  context_.always(Core::Add, {next}, {word(counter), constant(1)});
  const Device inside = less(word(next), constant(source().operand(1).value + 1));
  gated_by(inside, true, Core::Mov, {next}, {constant(0)});
  begin_edge();
  gated(Core::Mov, {counter}, {word(next)});
  end_edge();
}

}  // namespace rung::lower
