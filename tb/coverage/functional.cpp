// SPDX-License-Identifier: Apache-2.0
#include "coverage/functional.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace rung::tb {
namespace {

using isa::Format;
using isa::Gate;
using isa::Opcode;
using isa::SlotInstruction;
using isa::WordKind;

// Word devices count from here on.
constexpr int kWords = 1 << 16;

bool is_look_up(Opcode opcode) {
  return opcode == Opcode::Lut || opcode == Opcode::Luto || opcode == Opcode::Luts ||
         opcode == Opcode::Lutr;
}
bool reads_by_index(Opcode opcode) {
  return opcode == Opcode::Ldx || opcode == Opcode::Mvbx || opcode == Opcode::Mvx;
}
bool writes_by_index(Opcode opcode) {
  return opcode == Opcode::Setx || opcode == Opcode::Rstx || opcode == Opcode::Stx;
}

// What the opcode reads as its bit operand a.
bool reads_a(Opcode opcode) {
  switch (opcode) {
    case Opcode::Ld:
    case Opcode::Ldi:
    case Opcode::And:
    case Opcode::Ani:
    case Opcode::Or:
    case Opcode::Ori:
    case Opcode::Get:
      return true;
    default:
      return is_look_up(opcode);
  }
}

bool reads_b_and_c(Opcode opcode, isa::Mpu mpu) {
  return mpu != isa::Mpu::Mpu1 && (is_look_up(opcode) || opcode == Opcode::Get);
}

bool reads_s2(Opcode opcode) {
  const isa::OpcodeInfo& info = isa::info(opcode);
  return (info.format == Format::Word || info.format == Format::Test) && info.gate != Gate::Unit &&
         opcode != Opcode::Mva && opcode != Opcode::Mvx;
}
bool reads_s1(Opcode opcode) {
  return reads_s2(opcode) && opcode != Opcode::Mv && opcode != Opcode::Stx;
}

// The instruction names a device that it writes.
bool has_target(Opcode opcode) {
  switch (opcode) {
    case Opcode::Luto:
    case Opcode::Luts:
    case Opcode::Lutr:
    case Opcode::Out:
    case Opcode::Set:
    case Opcode::Rst:
    case Opcode::Mvbx:
      return true;
    case Opcode::Muls:
    case Opcode::Divs:
    case Opcode::Mulds:
    case Opcode::Divds:
    case Opcode::Cmp:
    case Opcode::Ldh:
    case Opcode::Ix:
    case Opcode::Stx:
      return false;
    default: {
      const Format format = isa::info(opcode).format;
      return format == Format::Word || format == Format::Test;
    }
  }
}

int target_of(const SlotInstruction& instruction, isa::Mpu mpu) {
  if (isa::info(instruction.opcode).format == Format::Word) return kWords + instruction.rd;
  return mpu == isa::Mpu::Mpu1 ? instruction.a.device : instruction.c.device;
}

bool decided_by_result(Opcode opcode) { return opcode == Opcode::Luts || opcode == Opcode::Lutr; }

GateCase gate_of(const SlotInstruction& instruction, const Retired& retired) {
  const bool wrote = retired.bit_we || retired.word_we;
  if (decided_by_result(instruction.opcode)) return wrote ? GateCase::Open : GateCase::Shut;
  switch (isa::info(instruction.opcode).gate) {
    case Gate::None:
      return GateCase::Free;
    case Gate::Exc:
      // None of them changes exc, which is the gate.
      if (instruction.always) return GateCase::Always;
      return retired.exc ? GateCase::Open : GateCase::Shut;
    case Gate::Unit:
      return wrote ? GateCase::Open : GateCase::Shut;
  }
  return GateCase::Free;
}

// The last writes of a device, done and held: step and slot.
struct Writer {
  int step;
  int slot;
};
struct Writers {
  std::optional<Writer> wrote;
  std::optional<Writer> held;
};

Relation plus(Relation first, int distance) {
  return static_cast<Relation>(static_cast<int>(first) + distance - 1);
}

// All that an instruction of a scan meets.
class Scan {
 public:
  Scan(isa::Mpu mpu, int distances) : mpu_(mpu), distances_(distances) {}

  // Calls `found` with each operand and relation of an instruction.
  template <typename Found>
  void operands(const SlotInstruction& instruction, int step, int slot,
                const std::map<int, int>& now, Found found) const {
    const Opcode opcode = instruction.opcode;
    const auto bit = [&](OperandCase which, const isa::BitOperand& operand) {
      found(which, operand.n0 ? Relation::N0 : relation(operand.device, step, slot, now));
    };
    const auto word = [&](OperandCase which, int device) {
      found(which, relation(kWords + device, step, slot, now));
    };
    bool any = false;
    if (reads_a(opcode)) {
      any = true;
      bit(OperandCase::BitA, instruction.a);
      if (reads_b_and_c(opcode, mpu_)) {
        bit(OperandCase::BitB, instruction.b);
        bit(OperandCase::BitC, instruction.c);
      }
    }
    if (reads_s2(opcode)) {
      any = true;
      // Of the two sources one may be the constant; rs is the other.
      if (instruction.kind == WordKind::ConstantDevice) {
        if (reads_s1(opcode)) found(OperandCase::S1, Relation::Constant);
        word(OperandCase::S2, instruction.rs);
      } else {
        if (reads_s1(opcode)) word(OperandCase::S1, instruction.rs);
        if (instruction.kind == WordKind::Devices) {
          word(OperandCase::S2, instruction.source);
        } else {
          found(OperandCase::S2, Relation::Constant);
        }
      }
    }
    if (reads_by_index(opcode) || writes_by_index(opcode)) {
      any = true;
      found(OperandCase::Index,
            step - index_set_[slot] <= distances_ ? Relation::IndexNear : Relation::IndexFar);
    }
    if (has_target(opcode)) {
      any = true;
      found(OperandCase::Target, relation(target_of(instruction, mpu_), step, slot, {}));
    }
    if (!any) found(OperandCase::None, Relation::None);
  }

  void wrote(int device, Writer writer) { writers_[device].wrote = writer; }
  void held(int device, Writer writer) { writers_[device].held = writer; }
  void index_set(int step, int slot) { index_set_[slot] = step; }

 private:
  // `now`: what this step writes, and by which slot.
  Relation relation(int device, int step, int slot, const std::map<int, int>& now) const {
    const auto other = now.find(device);
    if (other != now.end() && other->second != slot) return Relation::SameStep;
    const auto found = writers_.find(device);
    if (found == writers_.end()) return Relation::Far;
    const auto& [wrote, held] = found->second;
    const bool is_held = held && (!wrote || held->step > wrote->step);
    const Writer& last = is_held ? *held : *wrote;
    const int distance = step - last.step;
    if (distance > distances_) return Relation::Far;
    const bool own = last.slot == slot;
    if (is_held) return plus(own ? Relation::OwnHeld1 : Relation::OtherHeld1, distance);
    return plus(own ? Relation::OwnWrote1 : Relation::OtherWrote1, distance);
  }

  isa::Mpu mpu_;
  int distances_;
  std::map<int, Writers> writers_;
  std::array<int, 2> index_set_{-1000, -1000};
};

}  // namespace

std::size_t FunctionalCoverage::index(const Situation& s) {
  std::size_t at = static_cast<std::size_t>(s.opcode) * 2 + static_cast<std::size_t>(s.slot);
  at = at * kGates + static_cast<std::size_t>(s.gate);
  at = at * kOperands + static_cast<std::size_t>(s.operand);
  return at * kRelations + static_cast<std::size_t>(s.relation);
}

void FunctionalCoverage::scan(const Steps& steps, std::span<const Retired> retired) {
  Scan scan(mpu_, kDistances);
  for (std::size_t first = 0; first < retired.size();) {
    std::size_t end = first;
    while (end < retired.size() && retired[end].step == retired[first].step) ++end;
    const auto step = static_cast<int>(retired[first].step);
    const auto& instructions = steps.at(retired[first].step);
    std::map<int, int> now;
    for (const Retired& each : retired.subspan(first, end - first)) {
      if (each.bit_we) now[each.bit_address] = each.slot;
      if (each.word_we) now[kWords + each.word_address] = each.slot;
    }
    for (const Retired& each : retired.subspan(first, end - first)) {
      const SlotInstruction& instruction = instructions.at(each.slot);
      const GateCase gate = gate_of(instruction, each);
      scan.operands(instruction, step, each.slot, now, [&](OperandCase operand, Relation relation) {
        ++counts_[index({instruction.opcode, each.slot, gate, operand, relation})];
      });
    }
    for (const Retired& each : retired.subspan(first, end - first)) {
      const SlotInstruction& instruction = instructions.at(each.slot);
      const Writer writer{step, each.slot};
      if (each.bit_we) scan.wrote(each.bit_address, writer);
      if (each.word_we) scan.wrote(kWords + each.word_address, writer);
      if (!each.bit_we && !each.word_we && has_target(instruction.opcode)) {
        scan.held(target_of(instruction, mpu_), writer);
      }
      if (instruction.opcode == Opcode::Ix) scan.index_set(step, each.slot);
    }
    first = end;
  }
}

bool FunctionalCoverage::can_be(const Situation& s) const {
  const isa::OpcodeInfo& info = isa::info(s.opcode);
  if (!(mpu_ == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot) || s.slot >= isa::slots(mpu_)) {
    return false;
  }
  switch (s.gate) {
    case GateCase::Free:
      if (info.gate != Gate::None || decided_by_result(s.opcode)) return false;
      break;
    case GateCase::Always:
      if (info.gate != Gate::Exc) return false;
      break;
    case GateCase::Open:
    case GateCase::Shut:
      if (info.gate == Gate::None && !decided_by_result(s.opcode)) return false;
      break;
  }
  const bool indexed = reads_by_index(s.opcode) || writes_by_index(s.opcode);
  const bool two_slots = isa::slots(mpu_) == 2;
  const bool none = s.relation == Relation::None;
  const bool by_index = s.relation == Relation::IndexNear || s.relation == Relation::IndexFar;
  const bool other = s.relation == Relation::SameStep ||
                     (s.relation >= Relation::OtherWrote1 && s.relation <= Relation::OtherWrote5) ||
                     s.relation >= Relation::OtherHeld1;
  if (other && !two_slots) return false;
  if (none != (s.operand == OperandCase::None)) return false;
  if (by_index != (s.operand == OperandCase::Index)) return false;
  switch (s.operand) {
    case OperandCase::None:
      return !reads_a(s.opcode) && !reads_s2(s.opcode) && !indexed && !has_target(s.opcode);
    case OperandCase::BitA:
    case OperandCase::BitB:
    case OperandCase::BitC:
      if (s.relation == Relation::Constant) return false;
      // A contact of MPU1 has no N0.
      if (s.relation == Relation::N0 && mpu_ == isa::Mpu::Mpu1) return false;
      return s.operand == OperandCase::BitA ? reads_a(s.opcode) : reads_b_and_c(s.opcode, mpu_);
    case OperandCase::S1:
    case OperandCase::S2:
      if (s.relation == Relation::N0) return false;
      return s.operand == OperandCase::S1 ? reads_s1(s.opcode) : reads_s2(s.opcode);
    case OperandCase::Index:
      return indexed;
    case OperandCase::Target:
      return has_target(s.opcode) && s.relation != Relation::N0 &&
             s.relation != Relation::Constant && s.relation != Relation::SameStep;
  }
  return false;
}

std::vector<Situation> FunctionalCoverage::universe() const {
  std::vector<Situation> all;
  for (const isa::OpcodeInfo& info : isa::opcodes()) {
    for (std::size_t rest = 0; rest < std::size_t{2} * kGates * kOperands * kRelations; ++rest) {
      const Situation situation{info.opcode,
                                static_cast<int>(rest / (kGates * kOperands * kRelations)),
                                static_cast<GateCase>(rest / (kOperands * kRelations) % kGates),
                                static_cast<OperandCase>(rest / kRelations % kOperands),
                                static_cast<Relation>(rest % kRelations)};
      if (can_be(situation)) all.push_back(situation);
    }
  }
  return all;
}

std::vector<Situation> FunctionalCoverage::impossible() const {
  std::vector<Situation> found;
  for (std::size_t at = 0; at < counts_.size(); ++at) {
    if (counts_[at] == 0) continue;
    const std::size_t rest = at % (kGates * kOperands * kRelations);
    const Situation situation{static_cast<Opcode>(at / (2 * kGates * kOperands * kRelations)),
                              static_cast<int>(at / (kGates * kOperands * kRelations) % 2),
                              static_cast<GateCase>(rest / (kOperands * kRelations)),
                              static_cast<OperandCase>(rest / kRelations % kOperands),
                              static_cast<Relation>(rest % kRelations)};
    if (!can_be(situation)) found.push_back(situation);
  }
  return found;
}

std::string describe(isa::Mpu mpu, const Situation& s) {
  static constexpr const char* kGateNames[] = {"", ", always", ", gate open", ", gate shut"};
  static constexpr const char* kOperandNames[] = {"no operand", "a",  "b",  "c",
                                                  "s1",         "s2", "ix", "target"};
  static constexpr const char* kFirst[] = {"none",
                                           "N0",
                                           "a constant",
                                           "the other slot writes it in this step",
                                           "not written in the last 5 steps",
                                           "set in the last 5 steps",
                                           "set more than 5 steps before"};
  const int relation = static_cast<int>(s.relation);
  const int by = relation - static_cast<int>(Relation::OwnWrote1);
  const std::string where = by < 0 ? kFirst[relation]
                                   : fmt::format("{} slot {} it {} steps before",
                                                 by / 5 % 2 == 0 ? "the same" : "the other",
                                                 by < 10 ? "wrote" : "did not write", by % 5 + 1);
  return fmt::format("MPU{} slot {}: {}{}, {}: {}", static_cast<int>(mpu), s.slot,
                     isa::info(s.opcode).name, kGateNames[static_cast<int>(s.gate)],
                     kOperandNames[static_cast<int>(s.operand)], where);
}

}  // namespace rung::tb
