// SPDX-License-Identifier: Apache-2.0
#include "lower/condition.hpp"

namespace rung::lower {

using core::Op;

Execution::Execution(Context& context, const Requirements& requirements) : context_(context) {
  std::optional<Device> good;
  if (requirements.valid.size() == 1) {
    good = requirements.valid.front();
  } else if (!requirements.valid.empty()) {
    std::vector<std::pair<Device, bool>> all;
    for (const Device bit : requirements.valid) all.emplace_back(bit, false);
    good = context.temporary_bit();
    context.compute(*good, all);
  }
  context.gate();
  if (context.source().pulse) memory_ = context.memory();
  branched_ = memory_ || good;
  if (branched_) context.block(Op::Mps);
  if (memory_) context.contact(Op::Ani, *memory_);
  if (!good) return;
  const std::vector<Device> errors = context.named_of_role(SpecialRole::Error);
  if (!errors.empty()) {
    context.block(Op::Mps);
    context.contact(Op::Ani, *good);
    for (const Device error : errors) context.coil(Op::Set, error, true);
    context.block(Op::Mpp);
  }
  context.contact(Op::And, *good);
}

void Execution::end() {
  if (branched_) context_.block(Op::Mpp);
  if (memory_) remember(context_, *memory_);
}

void remember(Context& context, Device memory) { context.drive(memory); }

void copy_bit(Context& context, Device bit, Device value, bool quiet) {
  context.block(Op::Mps);
  context.contact(Op::And, value);
  context.coil(Op::Set, bit, quiet);
  context.block(Op::Mrd);
  context.contact(Op::Ani, value);
  context.coil(Op::Rst, bit, quiet);
  context.block(Op::Mpp);
}

void set_errors_beside(Context& context, Device inside) {
  const std::vector<Device> errors = context.named_of_role(SpecialRole::Error);
  if (errors.empty()) return;
  context.contact(Op::Ldi, inside);
  context.gate_live();
  for (const Device error : errors) context.coil(Op::Set, error, true);
  context.block(Op::Pop);
}

}  // namespace rung::lower
