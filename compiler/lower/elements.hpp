// SPDX-License-Identifier: Apache-2.0
// The elements of an LDmicro rung (compiler/LDMICRO.md), and the condition on its way through them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lower/compare.hpp"
#include "lower/context.hpp"
#include "rungs/format_string.hpp"
#include "rungs/ports.hpp"

namespace rung::lower {

// What is known of the condition. `Result`: it is the current result, a block on MPU1's stack; the
// constants stand nowhere.
enum class Flow : std::uint8_t { Off, On, Result };

class Elements {
 public:
  explicit Elements(Context& context) : context_(context) {}

  Flow flow() const { return flow_; }
  void set_flow(Flow flow) { flow_ = flow; }
  // Executes the current source instruction, an element of a series. `used`: something behind it
  // looks at the condition that it leaves.
  void execute(bool used);

  // condition <- condition AND bit
  void contact(Device bit, bool inverted);
  // A constant condition becomes a result.
  void materialise();
  // condition <- bit, whatever it was
  void replace(Device bit, bool inverted);
  // condition <- a constant
  void replace(Flow constant);

  // What MASTER RELAY lets through to the rungs behind it; nothing until there is one.
  std::optional<Device> master() const { return master_; }
  // What stands behind the last rung.
  void finish();

 private:
  using Core = core::Op;

  const Instruction& source() const { return context_.source(); }
  WordSource value(std::size_t operand) const;
  Device variable(std::size_t operand = 0) const;
  // Under the condition; `quiet` for all that traces list only where it changes.
  void gated(Core op, std::initializer_list<Device> targets,
             std::initializer_list<WordSource> sources, bool quiet = true);
  void coil(Core op, Device bit);
  // On its own: under a bit, or its opposite, instead of the condition.
  void gated_by(Device bit, bool inverted, Core op, std::initializer_list<Device> targets,
                std::initializer_list<WordSource> sources);
  // hidden bit <- a < b
  Device less(const WordSource& a, const WordSource& b);
  // hidden bit <- a = constant
  Device equal(const WordSource& a, std::int32_t constant);
  // A bit that is never written.
  Device zero();

  // Conditions and coils: elements.cpp.
  void out(bool inverted);
  void master_relay();
  void one_shot(bool rising);

  // Timers and counters: element_timers.cpp.
  void on_delay();
  void off_delay();
  void retentive(bool used);
  // From begin_edge() to end_edge() core instructions run when the condition goes on; it is the
  // same afterwards.
  void begin_edge();
  void end_edge();
  void count(bool used);
  void circular();

  // Words: element_words.cpp.
  void arithmetic();
  void shift_register();
  void look_up();
  void piecewise();
  // target <- the line through two points of the table, at `index`; under the current result.
  void segment(Device target, const WordSource& index, std::size_t i);

  // Peripherals: element_ports.cpp, element_string.cpp.
  void pwm();
  void persist();
  void send(bool used);
  void receive();
  void formatted_string(bool used);
  void string_variable(Device going, Device step, Device byte,
                       const std::vector<StringStep>& steps);
  void string_sign(Device going, Device here, Device byte);
  void string_digits(Device going, Device step, Device byte, std::int32_t place,
                     const std::vector<std::int32_t>& powers, bool sign);

  Context& context_;
  Flow flow_ = Flow::On;
  std::optional<Device> master_, zero_, started_, pwm_started_;
};

}  // namespace rung::lower
