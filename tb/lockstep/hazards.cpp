// SPDX-License-Identifier: Apache-2.0
#include "lockstep/hazards.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

namespace rung::tb {
namespace {

using isa::Opcode;
using isa::SlotInstruction;
using isa::WordKind;

bool writes_bit(Opcode opcode) {
  switch (opcode) {
    case Opcode::Luto:
    case Opcode::Luts:
    case Opcode::Lutr:
    case Opcode::Out:
    case Opcode::Set:
    case Opcode::Rst:
      return true;
    default:
      return false;
  }
}

bool writes_word(const SlotInstruction& instruction) {
  return isa::info(instruction.opcode).format == isa::Format::Word &&
         instruction.opcode != Opcode::Muls && instruction.opcode != Opcode::Divs;
}

// Addresses that an instruction reads and writes; words count from kWords on.
constexpr int kWords = 1 << 16;

int written(const SlotInstruction& instruction, isa::Mpu mpu) {
  if (writes_word(instruction)) return kWords + instruction.rd;
  if (!writes_bit(instruction.opcode)) return -1;
  return mpu == isa::Mpu::Mpu1 ? instruction.a.device : instruction.c.device;
}

std::vector<int> read(const SlotInstruction& instruction) {
  std::vector<int> addresses;
  const isa::OpcodeInfo& info = isa::info(instruction.opcode);
  if (mapping::is_lookup(instruction.opcode)) {
    for (const auto* operand : {&instruction.a, &instruction.b, &instruction.c}) {
      if (!operand->n0) addresses.push_back(operand->device);
    }
  } else if (info.format == isa::Format::Bit && !writes_bit(instruction.opcode)) {
    addresses.push_back(instruction.a.device);
  } else if (info.format == isa::Format::Word && info.gate != isa::Gate::Unit) {
    if (instruction.opcode != Opcode::Mv || instruction.kind == WordKind::ConstantDevice) {
      addresses.push_back(kWords + instruction.rs);
    }
    if (instruction.kind == WordKind::Devices) addresses.push_back(kWords + instruction.source);
  }
  return addresses;
}

// Operands that the function does not depend on stand as N0 too; those do not count.
bool uses_n0(const SlotInstruction& instruction, std::uint8_t function) {
  const isa::BitOperand* operands[] = {&instruction.a, &instruction.b, &instruction.c};
  for (int place = 0; place < 3; ++place) {
    if (!operands[place]->n0) continue;
    for (int address = 0; address < 8; ++address) {
      const int other = address ^ 1 << (2 - place);
      if ((function >> address & 1) != (function >> other & 1)) return true;
    }
  }
  return false;
}

struct Writer {
  int step;
  int slot;
};

}  // namespace

void Hazards::count(const image::Image& image) {
  const isa::Config& config = *isa::find_config(image.config);
  std::map<int, Writer> last;  // by address
  std::array<int, 2> chain{};
  std::array<int, 2> started{};
  std::array<Opcode, 2> started_as{};
  const int steps = static_cast<int>(image.steps.size());
  for (int step = 0; step < steps; ++step) {
    const auto& slots = image.steps[step];
    int writes = 0;
    for (int slot = 0; slot < static_cast<int>(slots.size()); ++slot) {
      const SlotInstruction& instruction = slots[slot];
      const auto add = [&](int address, ByDistance& bits, ByDistance& words) {
        const auto found = last.find(address);
        if (found == last.end()) return;
        const int distance = step - found->second.step;
        if (distance > kDistances) return;
        auto& table = address >= kWords ? words : bits;
        ++table[found->second.slot == slot ? 0 : 1][distance - 1];
      };
      for (const int address : read(instruction)) {
        add(address, bit_read_after_write, word_read_after_write);
        for (int other = 0; other < static_cast<int>(slots.size()); ++other) {
          if (other != slot && written(slots[other], image.mpu) == address) ++read_in_step_of_write;
        }
      }
      const int target = written(instruction, image.mpu);
      if (target >= 0) {
        ++writes;
        add(target, bit_rewritten, word_rewritten);
      }
      if (mapping::is_lookup(instruction.opcode)) {
        const bool fed = uses_n0(instruction, image.lut[instruction.row]);
        chain[slot] = fed ? chain[slot] + 1 : 0;
        if (fed) ++n0_chains[std::min(chain[slot], 4) - 1];
      }
      if (instruction.opcode == Opcode::Muls || instruction.opcode == Opcode::Divs) {
        started[slot] = step;
        started_as[slot] = instruction.opcode;
      } else if (isa::info(instruction.opcode).gate == isa::Gate::Unit &&
                 (started_as[slot] == Opcode::Muls || started_as[slot] == Opcode::Divs)) {
        const int latency =
            started_as[slot] == Opcode::Muls ? config.mul_latency : config.div_latency;
        if (step - started[slot] == latency) ++collected_at_latency;
      }
    }
    if (writes > 1) ++both_slots_write;
    for (int slot = 0; slot < static_cast<int>(slots.size()); ++slot) {
      const int target = written(slots[slot], image.mpu);
      if (target >= 0) last[target] = {step, slot};
    }
  }
}

void Hazards::count(const image::Image& image, const Retired& retired) {
  const SlotInstruction& instruction = image.steps[retired.step][retired.slot];
  const bool gated = isa::info(instruction.opcode).gate != isa::Gate::None ||
                     instruction.opcode == Opcode::Luts || instruction.opcode == Opcode::Lutr;
  if (!gated || written(instruction, image.mpu) < 0) return;
  ++(retired.bit_we || retired.word_we ? gated_writes_done : gated_writes_held);
}

std::string Hazards::to_string() const {
  const auto table = [](const char* name, const ByDistance& by) {
    return fmt::format("  {}: same slot {}, other slot {}\n", name, fmt::join(by[0], " "),
                       fmt::join(by[1], " "));
  };
  return "hazards, by distance 1 2 3 4 5:\n" +
         table("bit written, then read", bit_read_after_write) +
         table("word written, then read", word_read_after_write) +
         table("bit written, then written", bit_rewritten) +
         table("word written, then written", word_rewritten) +
         fmt::format(
             "  read in the step of a write: {}\n  both slots write in a step: {}\n"
             "  look-ups behind 1, 2, 3, 4 or more N0 in a row: {}\n"
             "  gated writes done: {}, held: {}\n  products collected at once: {}\n",
             read_in_step_of_write, both_slots_write, fmt::join(n0_chains, " "), gated_writes_done,
             gated_writes_held, collected_at_latency);
}

}  // namespace rung::tb
