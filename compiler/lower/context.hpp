// SPDX-License-Identifier: Apache-2.0
// What the parts of the lowering share: where they are in the source, under which gates, and how
// core instructions, memories and temporaries are made.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/program.hpp"
#include "rungs/footprint.hpp"
#include "rungs/program.hpp"
#include "rungs/special.hpp"

namespace rung::lower {

using core::WordSource;

inline WordSource constant(std::int32_t value) {
  return {true, static_cast<std::int16_t>(static_cast<std::uint16_t>(value)), {}};
}
inline WordSource word(Device device) { return {false, 0, device}; }

// A 32-bit value as its two words.
struct Pair {
  WordSource low, high;
};

class Context {
 public:
  explicit Context(const Program& program);

  const Program& program() const { return program_; }
  Dialect dialect() const { return program_.dialect; }
  core::Program take() { return std::move(out_); }

  // The source instruction that what follows stands for.
  void at(std::size_t index) { index_ = index; }
  std::size_t index() const { return index_; }
  const Instruction& source() const { return program_.instructions[index_]; }

  // --- Networks: between begin and end the stacks are those of one rung. Within another one (a
  // subroutine called in the middle of a rung) the result of the inner is dropped at its end.
  void begin_network();
  void end_network();

  // --- Core instructions. Every sequence leaves the stacks as it found them, but for the result.
  void contact(core::Op op, Device bit);
  void block(core::Op op);
  void coil(core::Op op, Device bit, bool quiet = false);
  // Runs whatever the result is; only for hidden targets.
  void always(core::Op op, std::initializer_list<Device> targets,
              std::initializer_list<WordSource> sources);
  // Runs under the current result.
  void gated(core::Op op, std::initializer_list<Device> targets,
             std::initializer_list<WordSource> sources, bool quiet = false);
  void emit(core::Instruction instruction);
  // bit <- the conjunction of the contacts, on its own: {bit, inverted}.
  void compute(Device bit, const std::vector<std::pair<Device, bool>>& contacts);

  // --- Gates. Power switches what is written, live whether anything is executed at all.
  std::optional<Device> power() const { return power_; }
  std::optional<Device> live() const { return live_; }
  void set_power(std::optional<Device> power) { power_ = power; }
  void set_live(std::optional<Device> live) { live_ = live; }
  // The states whose zone this is; setting another state leaves them.
  const std::vector<Device>& states() const { return states_; }
  void set_states(std::vector<Device> states) { states_ = std::move(states); }
  // result <- result AND power AND live: what every output does first. What follows in the rung
  // may go on from the gated result, since it is gated again before it can show.
  void gate();
  // result <- result AND live
  void gate_live();
  // bit <- result, which has been gated, if live; else it holds.
  void drive(Device bit, bool quiet = false);

  // --- Hidden devices.
  // A bit of the current source instruction that lasts from scan to scan; copies of the
  // instruction share it.
  Device memory(int which = 0);
  // The same for a word.
  Device memory_word(int which = 0);
  // One that belongs to a device.
  enum class Role { Coil, Held, TicksUsed, Left };
  Device memory_of(Device device, Role role);
  // A bit of its own.
  Device fresh_bit();
  // Until the end of the network.
  Device temporary_bit();
  Device temporary_word();
  // Ticks of this base since the last scan.
  Device ticks(std::int64_t base_us);

  // word target <- values[index], under the current result or always. An index outside gives
  // anything.
  void load_constant(Device target, const std::vector<std::int32_t>& values,
                     const WordSource& index, bool always);

  // Whether the program names this device; flags that nobody can see are not computed.
  bool is_named(Device device) const { return named_.count(device) != 0; }
  // The named ones of this role.
  std::vector<Device> named_of_role(SpecialRole role) const;
  // The window of an indexed operand of this kind, with its devices in order.
  const std::vector<Device>& window(DeviceKind kind) const;

 private:
  core::Instruction make(core::Op op) const;

  const Program& program_;
  core::Program out_;
  std::size_t index_ = 0;
  // The result is that of LD on a relay that is always on (M8000): what runs under it needs no
  // condition.
  bool surely_on_ = false;
  std::vector<std::size_t> begins_;  // of the networks that are open, by their first instruction
  std::optional<Device> power_, live_;
  std::vector<Device> states_;
  std::set<Device> named_;
  std::map<DeviceKind, std::vector<Device>> windows_;
  std::map<std::pair<std::size_t, int>, Device> memories_, memory_words_;
  std::map<std::pair<Device, Role>, Device> device_memories_;
  std::map<std::vector<std::int32_t>, std::vector<Device>> tables_;  // by their values
  std::uint32_t next_memory_ = 0;
  std::uint32_t next_bit_ = 0;
  std::uint32_t next_word_ = 0;
};

}  // namespace rung::lower
