// SPDX-License-Identifier: Apache-2.0
#include "prove/image_model.hpp"

#include <algorithm>
#include <initializer_list>

#include "prove/prove.hpp"

namespace rung::tb {

namespace {

using isa::Opcode;

bool is_one_of(Opcode opcode, std::initializer_list<Opcode> opcodes) {
  return std::find(opcodes.begin(), opcodes.end(), opcode) != opcodes.end();
}

void add(const image::Image& image, const std::vector<prove::Place>& places, const Retired& retired,
         Effect& effect) {
  const Opcode opcode = image.steps[retired.step][retired.slot].opcode;
  const bool indexed = is_one_of(opcode, {Opcode::Stx, Opcode::Setx, Opcode::Rstx});
  const auto write = [&](prove::Place place, std::uint16_t value) {
    if (indexed || std::binary_search(places.begin(), places.end(), place)) {
      effect.writes[place].push_back(value);
    }
  };
  if (retired.bit_we) write({false, retired.bit_address}, retired.bit_value ? 1 : 0);
  if (retired.word_we) write({true, retired.word_address}, retired.word_value);
}

}  // namespace

Effect run_model(const image::Image& image, const Memory& start,
                 const std::vector<prove::Place>& places) {
  StepModel model(image.mpu, *isa::find_config(image.config));
  model.bits = start.bits;
  model.words = start.words;
  std::copy(image.lut.begin(), image.lut.end(), model.lut.begin());
  std::uint32_t clocks = 0;
  Effect effect;
  for (const Retired& retired : model.scan(image.steps, clocks)) {
    add(image, places, retired, effect);
  }
  effect.error = model.error;
  return effect;
}

Effect run_rtl(Processor& processor, const image::Image& image, const Memory& start,
               const std::vector<prove::Place>& places) {
  processor.reset();
  processor.load_program(prove::code_of(image));
  for (std::size_t row = 0; row < image.lut.size(); ++row) {
    processor.load_lut(static_cast<int>(row), image.lut[row]);
  }
  for (std::size_t i = 0; i < start.bits.size(); ++i) {
    processor.write_bit(static_cast<int>(i), start.bits[i]);
  }
  for (std::size_t i = 0; i < start.words.size(); ++i) {
    processor.write_word(static_cast<int>(i), start.words[i]);
  }
  Effect effect;
  const ScanResult result =
      processor.run_scan([&](const Retired& retired) { add(image, places, retired, effect); });
  effect.error = result.error;
  return effect;
}

namespace {

// Clocks until the result of what starts the unit can be collected, or 0.
int collect_latency(Opcode opcode, const isa::Config& config) {
  if (is_one_of(opcode, {Opcode::Mul, Opcode::Muls})) return config.mul_latency;
  if (is_one_of(opcode, {Opcode::Div, Opcode::Divs})) return config.div_latency;
  if (is_one_of(opcode, {Opcode::Muld, Opcode::Mulds})) return config.mul32_latency;
  if (is_one_of(opcode, {Opcode::Divd, Opcode::Divds})) return config.div32_latency;
  return 0;
}

}  // namespace

bool keeps_latencies(const image::Image& image) {
  const isa::Config& config = *isa::find_config(image.config);
  struct Times {
    int index = 0;  // from here on
    int result = 0;
  };
  std::vector<Times> slots(static_cast<std::size_t>(isa::slots(image.mpu)));
  int clock = 0;
  for (const auto& step : image.steps) {
    int clocks = 1;
    for (std::size_t s = 0; s < slots.size(); ++s) {
      const Opcode opcode = step[s].opcode;
      const bool uses_index = is_one_of(opcode, {Opcode::Mvx, Opcode::Stx, Opcode::Mvbx,
                                                 Opcode::Ldx, Opcode::Setx, Opcode::Rstx});
      const bool collects = isa::info(opcode).gate == isa::Gate::Unit;
      if (uses_index && clock < slots[s].index) return false;
      if (collects && clock < slots[s].result) return false;
      if (opcode == Opcode::Ix) slots[s].index = clock + isa::constant::index_latency;
      const int latency = collect_latency(opcode, config);
      if (latency != 0) slots[s].result = clock + latency;
      clocks = std::max(clocks, config.clocks(opcode));
    }
    clock += clocks;
  }
  return true;
}

std::map<prove::Place, std::vector<std::size_t>> writers(const image::Image& image,
                                                         const std::vector<std::size_t>& numbers) {
  std::map<prove::Place, std::vector<std::size_t>> out;
  for (std::size_t step = 0; step < image.steps.size(); ++step) {
    for (std::size_t slot = 0; slot < image.steps[step].size(); ++slot) {
      const isa::SlotInstruction& i = image.steps[step][slot];
      const isa::Format format = isa::info(i.opcode).format;
      const bool bit = format == isa::Format::Test ||
                       is_one_of(i.opcode, {Opcode::Luto, Opcode::Luts, Opcode::Lutr, Opcode::Out,
                                            Opcode::Set, Opcode::Rst, Opcode::Mvbx});
      const bool word =
          format == isa::Format::Word &&
          !is_one_of(i.opcode, {Opcode::Cmp, Opcode::Ldh, Opcode::Ix, Opcode::Stx, Opcode::Muls,
                                Opcode::Divs, Opcode::Mulds, Opcode::Divds});
      if (!bit && !word) continue;
      const int target = word ? i.rd : image.mpu == isa::Mpu::Mpu1 ? i.a.device : i.c.device;
      out[{word, target}].push_back(2 * numbers[step] + slot);
    }
  }
  return out;
}

}  // namespace rung::tb
