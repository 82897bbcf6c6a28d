// SPDX-License-Identifier: Apache-2.0
#include "hardwired/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "rungs/special.hpp"

namespace rung::tb {
namespace {

void put(std::uint32_t* port, int at, int width, std::uint32_t value) {
  for (int i = 0; i < width; ++i) {
    const std::uint32_t mask = 1U << ((at + i) % 32);
    std::uint32_t& word = port[(at + i) / 32];
    word = (value >> i & 1) != 0 ? word | mask : word & ~mask;
  }
}

std::uint32_t take(const std::uint32_t* port, int at, int width) {
  std::uint32_t value = 0;
  for (int i = 0; i < width; ++i) value |= (port[(at + i) / 32] >> ((at + i) % 32) & 1) << i;
  return value;
}

int width_of(Device device) { return is_word(device) ? 16 : 1; }

}  // namespace

Bench::Bench(const Batch& batch, std::unique_ptr<BatchModel> model)
    : batch_(batch), model_(std::move(model)) {
  model_->clock(true);
  model_->clock(true);
}

void Bench::set(std::size_t program, Device device, std::int16_t value) {
  const Placed& placed = batch_.modules()[program];
  const hardwired::Interface& interface = placed.module.interface;
  const auto bits = static_cast<std::uint32_t>(is_word(device) ? value : value != 0);
  const auto input = std::find(interface.inputs.begin(), interface.inputs.end(), device);
  if (input != interface.inputs.end()) {
    put(model_->in, placed.in + static_cast<int>(input - interface.inputs.begin()), 1, bits);
    return;
  }
  const auto state = interface.state_bits.find(device);
  if (state == interface.state_bits.end()) return;
  const auto index = static_cast<int>(program);
  if (take(model_->state_load, index, 1) == 0) {
    for (int i = 0; i < interface.state_width; ++i) {
      put(model_->state_in, placed.state + i, 1, take(model_->state, placed.state + i, 1));
    }
    put(model_->state_load, index, 1, 1);
    to_load_ = true;
  }
  put(model_->state_in, placed.state + state->second, width_of(device), bits);
}

void Bench::drive(std::size_t program, Dialect dialect, ScanTime time) {
  const Placed& placed = batch_.modules()[program];
  const hardwired::Interface& interface = placed.module.interface;
  for (std::size_t i = 0; i < interface.clocks.size(); ++i) {
    put(model_->clocks, placed.clocks + static_cast<int>(i), 1,
        driven_value(*find_special(interface.clocks[i], dialect), time) ? 1 : 0);
  }
  for (std::size_t i = 0; i < interface.ticks.size(); ++i) {
    put(model_->ticks, placed.ticks + 16 * static_cast<int>(i), 16,
        static_cast<std::uint16_t>(ticks_since_last(interface.ticks[i], time)));
  }
}

void Bench::load() {
  if (!to_load_) return;
  model_->clock(false);
  const std::size_t words = (std::max<std::size_t>(batch_.modules().size(), 65) + 31) / 32;
  std::fill_n(model_->state_load, words, 0U);
  to_load_ = false;
}

std::vector<int> Bench::scan(const std::vector<bool>& programs) {
  load();
  const std::size_t count = batch_.modules().size();
  std::vector<int> clocks(count, 0);
  std::vector<std::vector<bool>> outputs(count);
  int most = 0;
  std::size_t left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    put(model_->start, static_cast<int>(i), 1, programs[i] ? 1 : 0);
    if (!programs[i]) continue;
    ++left;
    most = std::max(most, batch_.modules()[i].module.clocks);
    const std::size_t wide = batch_.modules()[i].module.interface.outputs.size();
    for (std::size_t o = 0; o < wide; ++o) outputs[i].push_back(output(i, o));
  }
  for (int clock = 1; left > 0; ++clock) {
    if (clock > most) throw std::runtime_error("a scan does not end");
    model_->clock(false);
    for (std::size_t i = 0; i < count; ++i) {
      put(model_->start, static_cast<int>(i), 1, 0);
      if (!programs[i] || clocks[i] != 0) continue;
      if (take(model_->done, static_cast<int>(i), 1) != 0) {
        clocks[i] = clock;
        --left;
        continue;
      }
      for (std::size_t o = 0; o < outputs[i].size(); ++o) {
        if (output(i, o) != outputs[i][o]) {
          throw std::runtime_error(fmt::format("program {}: output {} changes in a scan", i, o));
        }
      }
    }
  }
  return clocks;
}

std::int16_t Bench::get(std::size_t program, Device device) const {
  const Placed& placed = batch_.modules()[program];
  const auto state = placed.module.interface.state_bits.find(device);
  if (state == placed.module.interface.state_bits.end()) return 0;
  return static_cast<std::int16_t>(
      take(model_->state, placed.state + state->second, width_of(device)));
}

bool Bench::output(std::size_t program, std::size_t which) const {
  return take(model_->out, batch_.modules()[program].out + static_cast<int>(which), 1) != 0;
}

bool Bench::error(std::size_t program) const {
  return take(model_->error, static_cast<int>(program), 1) != 0;
}

}  // namespace rung::tb
