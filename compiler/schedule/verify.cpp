// SPDX-License-Identifier: Apache-2.0
// The check of a schedule: a symbolic run of its steps. Memory holds, instead of values, the name
// of the write that is there; every operation must find the names that the mapping gave it.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <vector>

#include "schedule/schedule.hpp"

namespace rung::schedule {
namespace {

using isa::Opcode;
using logic::Version;
using mapping::BitValue;
using mapping::Destination;
using mapping::kNoOp;
using mapping::MappedOp;
using mapping::Mapping;
using mapping::OpId;

class Checker {
 public:
  Checker(const Schedule& schedule, const Mapping& mapping, const Temporaries& temporaries,
          const isa::Config& config)
      : schedule_(schedule), mapping_(mapping), temporaries_(temporaries), config_(config) {}

  std::string run() {
    find_meant();
    std::vector<int> runs(mapping_.ops.size(), 0);
    const std::size_t slots = schedule_.steps.empty() ? 0 : schedule_.steps.front().size();
    exc_.assign(slots, kNoOp);
    started_.assign(slots, {kNoOp, 0});
    indexed_.assign(slots, {kNoOp, 0});
    state_.assign(slots, kNoOp);
    for (std::size_t step = 0; step < schedule_.steps.size(); ++step) {
      for (std::size_t slot = 0; slot < slots; ++slot) {
        const OpId id = schedule_.steps[step][slot];
        if (id == kNoOp) continue;
        ++runs[id];
        const std::string problem = check(id, slot);
        if (!problem.empty()) return fmt::format("step {}, slot {}: {}", step, slot, problem);
      }
      const std::string problem = write(step);
      if (!problem.empty()) return fmt::format("step {}: {}", step, problem);
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i] != 1) return fmt::format("operation {} runs {} times", i, runs[i]);
    }
    return {};
  }

 private:
  // The operation that the mapping means by N0: the last look-up before it in its unit; and the
  // last one before it that set the slot's own registers.
  void find_meant() {
    meant_n0_.assign(mapping_.ops.size(), kNoOp);
    meant_state_.assign(mapping_.ops.size(), kNoOp);
    for (const mapping::Unit& unit : mapping_.units) {
      OpId last = kNoOp;
      OpId state = kNoOp;
      for (const OpId id : unit.ops) {
        meant_n0_[id] = last;
        meant_state_[id] = state;
        if (sets_state(mapping_.ops[id].opcode)) state = id;
        if (mapping::writes_exc(mapping_.ops[id].opcode)) last = id;
      }
    }
  }

  Version version(Device device) const {
    const auto found = versions_.find(device);
    return found == versions_.end() ? logic::kStart : found->second;
  }

  std::string check(OpId id, std::size_t slot) const {
    const MappedOp& op = mapping_.ops[id];
    for (const BitValue& input : op.inputs) {
      if (input.kind == BitValue::Kind::Device && version(input.device) != input.version) {
        return fmt::format("operation {} reads another version of its contact", id);
      }
      if (input.kind == BitValue::Kind::Temporary) {
        const auto found = contents_.find(temporaries_.address.at(input.temporary));
        if (found == contents_.end() || found->second != input.temporary) {
          return fmt::format("operation {} does not find temporary t{}", id, input.temporary);
        }
      }
      // With nothing before it in its unit, N0 only fills a place.
      if (input.kind == BitValue::Kind::N0 && meant_n0_[id] != kNoOp &&
          exc_[slot] != meant_n0_[id]) {
        return fmt::format("operation {} reads the N0 of operation {}", id, exc_[slot]);
      }
    }
    for (const logic::Operand& operand : op.operands) {
      if (operand.source.constant) continue;
      if (version(operand.source.device) != operand.version) {
        return fmt::format("operation {} reads another version of its word", id);
      }
    }
    for (const logic::Read& read : op.reads) {
      if (version(read.device) != read.version) {
        return fmt::format("operation {} may read another version of a device", id);
      }
    }
    if (mapping::uses_index(op.opcode)) {
      const auto [index, clock] = indexed_[slot];
      if (index == kNoOp || clock_ - clock < isa::constant::index_latency) {
        return fmt::format("operation {} uses its index too early", id);
      }
    }
    if (const OpId before = needs_before(id); before != kNoOp && state_[slot] != before) {
      return fmt::format("operation {} does not find the slot as operation {} left it", id, before);
    }
    if (op.condition != kNoOp && exc_[slot] != op.condition) {
      return fmt::format("operation {} runs under the condition of operation {}", id, exc_[slot]);
    }
    if (op.started_by != kNoOp) {
      const auto [start, clock] = started_[slot];
      if (start != op.started_by) return fmt::format("operation {} collects a foreign result", id);
      if (clock_ - clock < mapping::collect_latency(mapping_.ops[start].opcode, config_)) {
        return fmt::format("operation {} collects its result too early", id);
      }
    }
    return {};
  }

  // Carry, acc, the unit's high words and ix are the slot's own: what uses them must come right
  // after the operation of its unit that set them, but for what touches none of them.
  OpId needs_before(OpId id) const {
    switch (mapping_.ops[id].opcode) {
      case Opcode::Adc:
      case Opcode::Sbc:
      case Opcode::Ltc:
      case Opcode::Mva:
      case Opcode::Mulds:
      case Opcode::Divds:
      case Opcode::Mvx:
      case Opcode::Stx:
      case Opcode::Mvbx:
      case Opcode::Setx:
      case Opcode::Rstx:
        return meant_state_[id];
      case Opcode::Get:
        return mapping_.ops[id].always ? kNoOp : meant_state_[id];
      default:
        return kNoOp;
    }
  }

  static bool sets_state(Opcode opcode) {
    switch (opcode) {
      case Opcode::Add:
      case Opcode::Adc:
      case Opcode::Sub:
      case Opcode::Sbc:
      case Opcode::Cmp:
      case Opcode::Ltu:
      case Opcode::Get:
      case Opcode::Ldh:
      case Opcode::Ix:
        return true;
      default:
        return false;
    }
  }

  std::string write(std::size_t step) {
    std::map<Device, OpId> devices;
    std::map<int, OpId> addresses;
    int longest = 1;
    for (std::size_t slot = 0; slot < schedule_.steps[step].size(); ++slot) {
      const OpId id = schedule_.steps[step][slot];
      if (id == kNoOp) continue;
      const MappedOp& op = mapping_.ops[id];
      longest = std::max(longest, config_.clocks(op.opcode));
      if (mapping::writes_exc(op.opcode)) exc_[slot] = id;
      if (mapping::starts_unit(op.opcode)) started_[slot] = {id, clock_};
      if (op.opcode == Opcode::Ix) indexed_[slot] = {id, clock_};
      if (sets_state(op.opcode)) state_[slot] = id;
      const Destination& to = op.destination;
      if (to.kind == Destination::Kind::Device) {
        if (!devices.emplace(to.device, id).second) return "two writes of one device";
        if (version(to.device) >= to.version) {
          return fmt::format("operation {} writes after a later write", id);
        }
      } else if (to.kind == Destination::Kind::Window) {
        for (const Device device : op.window) {
          if (!devices.emplace(device, id).second) return "two writes of one device";
          if (version(device) >= to.version) {
            return fmt::format("operation {} may write after a later write", id);
          }
        }
      } else if (to.kind == Destination::Kind::Temporary) {
        const int address = temporaries_.address.at(to.temporary);
        if (!addresses.emplace(address, id).second) return "two writes of one temporary";
      }
    }
    for (const auto& [device, id] : devices)
      versions_[device] = mapping_.ops[id].destination.version;
    for (const auto& [address, id] : addresses) {
      contents_[address] = mapping_.ops[id].destination.temporary;
    }
    clock_ += longest;
    return {};
  }

  const Schedule& schedule_;
  const Mapping& mapping_;
  const Temporaries& temporaries_;
  const isa::Config& config_;
  std::vector<OpId> meant_n0_;
  std::vector<OpId> meant_state_;
  std::map<Device, Version> versions_;
  std::map<int, std::int32_t> contents_;
  std::vector<OpId> exc_;
  std::vector<std::pair<OpId, std::int64_t>> started_, indexed_;
  std::vector<OpId> state_;  // the last operation that set a slot's own registers
  std::int64_t clock_ = 0;
};

}  // namespace

std::string verify(const Schedule& schedule, const Mapping& mapping, const Temporaries& temporaries,
                   const isa::Config& config) {
  return Checker(schedule, mapping, temporaries, config).run();
}

}  // namespace rung::schedule
