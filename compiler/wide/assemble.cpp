// SPDX-License-Identifier: Apache-2.0
#include "wide/assemble.hpp"

#include <algorithm>

namespace rung::wide {
namespace {

using values::NodeKind;
using values::Values;
using values::Word;

class Assembler {
 public:
  Assembler(const Schedule& schedule, const Work& work, const Values& values,
            const Machine& machine)
      : schedule_(schedule), work_(work), values_(values), machine_(machine), latch_(work.latch) {}

  Code run(const std::vector<Device>& devices) {
    Step empty;
    empty.bits.resize(machine_.slots);
    for (BitInstruction& each : empty.bits) each.inputs.fill(near_value(constant::near_zero));
    empty.words.resize(machine_.units);
    for (WordInstruction& each : empty.words) {
      each.keep = each.s1 = each.s2 = near_value(constant::near_zero);
    }
    out_.steps.assign(static_cast<std::size_t>(std::max(1, schedule_.steps)), empty);
    out_.origins.assign(out_.steps.size(),
                        std::vector<int>(static_cast<std::size_t>(machine_.slots), -1));
    give_addresses(devices);
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) add(static_cast<std::int32_t>(i));
    for (std::size_t g = 0; g < work_.groups.size(); ++g) add_group(static_cast<std::int32_t>(g));
    list_writes();
    return std::move(out_);
  }

 private:
  void give_addresses(const std::vector<Device>& devices) {
    const auto steps = static_cast<int>(out_.steps.size());
    out_.first_latch_row = steps;
    out_.latch_rows = latch_.rows;
    for (const auto& [device, position] : latch_.position) {
      out_.addresses[device] = steps * machine_.slots + position;
    }
    for (const auto& [device, look_up] : work_.bit_home) {
      const Place& place = schedule_.look_ups[look_up];
      out_.addresses[device] = place.step * machine_.slots + place.lane;
    }
    for (const auto& [device, made] : work_.word_home) {
      const Place place = schedule_.word(work_, made);
      out_.addresses[device] = place.step * machine_.units + place.lane;
    }
    int bit = (steps + latch_.rows) * machine_.slots;
    int word = steps * machine_.units;
    for (const Device device : devices) {
      if (out_.addresses.contains(device)) continue;
      out_.addresses[device] = is_word(device) ? word++ : bit++;
    }
    out_.rows = (bit + machine_.slots - 1) / machine_.slots;
    out_.word_rows = (word + machine_.units - 1) / machine_.units;
  }

  // What was computed in `from` for a reader at `step`; nearer than the bus it is in the same lane.
  static Operand value_at(const Place& from, int step) {
    const int distance = step - from.step;
    if (distance < constant::near_bus_first) return near_value(distance);
    if (distance <= constant::near_bus_last) return near_value(distance, from.lane);
    return {from.step, from.lane};
  }

  Operand start_of(Device device, int step, int lanes) const {
    const int address = out_.addresses.at(device);
    const Operand place{address / lanes, address % lanes};
    const auto latched = latch_.position.find(device);
    if (latched == latch_.position.end()) return place;
    const int distance = step - latch_.step_of_row(latched->second / lanes);
    if (distance <= constant::near_bus_last) return near_value(distance, place.lane);
    return place;
  }

  Operand input(NodeId leaf, std::int32_t reader, const Place& at) const {
    const std::int32_t from = work_.provider[leaf];
    if (from != kNone && from != reader) {
      return value_at(schedule_.look_ups[from], at.step);
    }
    switch (values_.nodes[leaf].kind) {
      case NodeKind::Start:
        return start_of(values_.nodes[leaf].device, at.step, machine_.slots);
      case NodeKind::Test:
        return near_value(constant::near_flag);
      default:
        return near_value(constant::near_zero);
    }
  }

  void add(std::int32_t id) {
    const LookUp& look_up = work_.look_ups[id];
    const Place& at = schedule_.look_ups[id];
    BitInstruction& out = out_.steps[at.step].bits[at.lane];
    const int unused = machine_.arity - look_up.cut.size;
    // Inputs stand in the first operands; the table does not depend on the others.
    for (int i = 0; i < look_up.cut.size; ++i) {
      out.inputs[i] = input(look_up.cut.leaves[i], id, at);
    }
    unsigned table = 0;
    for (int address = 0; address < 1 << machine_.arity; ++address) {
      table |= (look_up.cut.table >> (address >> unused) & 1U) << address;
    }
    out.table = look_up.gather ? 0 : static_cast<std::uint16_t>(table);
    out_.origins[at.step][at.lane] = static_cast<int>(look_up.instruction);
  }

  Operand word(const Word& value, int step) const {
    switch (value.kind) {
      case Word::Kind::Start:
        return start_of(value.device, step, machine_.units);
      case Word::Kind::Result:
        return value_at(schedule_.word(work_, work_.made[value.operation][value.output]), step);
      default:
        return near_value(constant::near_zero);
    }
  }

  void add_group(std::int32_t id) {
    const Group& group = work_.groups[id];
    const Place& base = schedule_.groups[id];
    for (const WordWork& work : group.words) {
      const int step = base.step + work.offset;
      WordInstruction& out = out_.steps[step].words[base.lane];
      out.opcode = work.opcode;
      const bool first = work.s1.kind == Word::Kind::Constant;
      const bool second = work.s2.kind == Word::Kind::Constant;
      if (second) {
        out.kind = 1;
        out.constant = static_cast<std::uint16_t>(work.s2.value);
        out.s1 = word(work.s1, step);
      } else if (first && work.opcode != Opcode::Mv) {
        out.kind = 2;
        out.constant = static_cast<std::uint16_t>(work.s1.value);
        out.s1 = word(work.s2, step);
      } else {
        out.s1 = word(work.s1, step);
        out.s2 = word(work.s2, step);
      }
      out.always = work.opcode == Opcode::Get ? work.clear : work.writes && work.gate == kNone;
      if (work.keeps) out.keep = word(work.keep, step);
      int& origin = out_.origins[step][2 * base.lane];
      if (origin < 0) origin = static_cast<int>(group.instruction);
    }
  }

  void list_writes() {
    for (std::size_t i = 0; i < work_.bit_writes.size(); ++i) {
      const Place& place = schedule_.look_ups[work_.bit_writes[i]];
      const values::BitWrite& write = values_.bit_writes[i];
      out_.writes.push_back({place.step, place.lane, write.device, write.instruction});
    }
    if (work_.bit_writes.empty()) {
      for (const auto& [device, look_up] : work_.bit_home) {
        const Place& place = schedule_.look_ups[look_up];
        out_.writes.push_back(
            {place.step, place.lane, device, work_.look_ups[look_up].instruction});
      }
    }
    for (const values::WordWrite& write : values_.word_writes) {
      const Work::Made& made = write.last && work_.word_home.contains(write.device)
                                   ? work_.word_home.at(write.device)
                                   : work_.made[write.value.operation][write.value.output];
      if (made.group == kNone) continue;  // nobody sees it
      const Place place = schedule_.word(work_, made);
      out_.writes.push_back({place.step, place.lane, write.device, write.instruction});
    }
  }

  const Schedule& schedule_;
  const Work& work_;
  const Values& values_;
  const Machine& machine_;
  const Latch& latch_;
  Code out_;
};

}  // namespace

std::int64_t Code::clocks() const {
  return static_cast<std::int64_t>(steps.size()) + constant::scan_fill +
         std::max(0, latch_rows - constant::scan_latch_free);
}

Code assemble(const Schedule& schedule, const Work& work, const Values& values,
              const Machine& machine, const std::vector<Device>& devices) {
  return Assembler(schedule, work, values, machine).run(devices);
}

}  // namespace rung::wide
