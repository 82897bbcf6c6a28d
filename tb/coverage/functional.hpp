// SPDX-License-Identifier: Apache-2.0
// Which situations of the pipeline have come up: opcode x slot x gate x operand x relation of the
// operand to the writes before it, counted over the retired instructions of MPU1, MPU2 or MPU3.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "harness/processor.hpp"

namespace rung::tb {

// Whether the instruction had its effect, and what decided on it.
enum class GateCase : std::uint8_t { Free, Always, Open, Shut };
// What it read, or which device it would write: with two slots that one is read too, in the other
// bank.
enum class OperandCase : std::uint8_t { None, BitA, BitB, BitC, S1, S2, Index, Target };
// Where the operand came from. A distance counts steps; of the writes of that device the last one
// counts, and a write that was held is one that the gate of its instruction has stopped.
enum class Relation : std::uint8_t {
  None,  // the opcode has no operand
  N0,    // the slot's last look-up
  Constant,
  SameStep,   // the other slot wrote it in this step: the read gives the old value
  Far,        // not written in the last five steps
  IndexNear,  // ix was set in the last five steps of its slot
  IndexFar,
  OwnWrote1,  // and distances 2 to 5, then the other slot's, then both held
  OwnWrote5 = OwnWrote1 + 4,
  OtherWrote1,
  OtherWrote5 = OtherWrote1 + 4,
  OwnHeld1,
  OwnHeld5 = OwnHeld1 + 4,
  OtherHeld1,
  OtherHeld5 = OtherHeld1 + 4,
};

struct Situation {
  isa::Opcode opcode;
  int slot;
  GateCase gate;
  OperandCase operand;
  Relation relation;
};
// "MPU3 slot 1: ADD, gate open, s1: other slot wrote it 3 steps before"
std::string describe(isa::Mpu mpu, const Situation& situation);

class FunctionalCoverage {
 public:
  explicit FunctionalCoverage(isa::Mpu mpu) : mpu_(mpu), counts_(kSituations, 0) {}

  using Steps = std::vector<std::vector<isa::SlotInstruction>>;
  // All that retired in one scan of `steps`, in order of steps and in a step by slot.
  void scan(const Steps& steps, std::span<const Retired> retired);

  // All that can come up, by the rules of can_be().
  std::vector<Situation> universe() const;
  std::uint64_t count(const Situation& situation) const { return counts_[index(situation)]; }
  // What has come up although the rules say that it cannot.
  std::vector<Situation> impossible() const;

  // The rules. An opcode has the operands and gates of its format (hdl/isa/isa.toml). Other slots,
  // and a write in the step of a read, are of processors with two slots; two slots never write one
  // device in a step. What LDX, MVBX, MVX read and SETX, RSTX, STX write is named by ix.
  bool can_be(const Situation& situation) const;

 private:
  static constexpr int kDistances = 5;
  static constexpr int kGates = 4;
  static constexpr int kOperands = 8;
  static constexpr int kRelations = static_cast<int>(Relation::OtherHeld5) + 1;
  static constexpr std::size_t kSituations =
      (std::size_t{1} << isa::constant::op_bits) * 2 * kGates * kOperands * kRelations;

  static std::size_t index(const Situation& situation);

  isa::Mpu mpu_;
  std::vector<std::uint64_t> counts_;
};

}  // namespace rung::tb
