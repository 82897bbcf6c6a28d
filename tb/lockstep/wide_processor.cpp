// SPDX-License-Identifier: Apache-2.0
#include "lockstep/wide_processor.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rung::tb {
namespace {

const rung::wide::Machine& find(int slots) {
  const rung::wide::Machine* machine = rung::wide::find_machine(slots);
  if (machine == nullptr) throw std::invalid_argument(fmt::format("no MPU4 with {} slots", slots));
  return *machine;
}

}  // namespace

WideProcessor::WideProcessor(int slots, std::unique_ptr<wide::WideRtl> rtl)
    : machine_(find(slots)), rtl_(std::move(rtl)) {}

void WideProcessor::load(const image::Image& image) {
  const image::WideImage& program = image.wide.value();
  if (program.slots != machine_.slots) {
    throw std::invalid_argument(
        fmt::format("a program for {} slots on {}", program.slots, machine_.slots));
  }
  steps_ = static_cast<int>(program.code.size());
  latch_rows_ = program.latch_rows;
  simulator_.emplace(machine_);
  for (int step = 0; step < steps_; ++step) {
    for (int slot = 0; slot < machine_.slots; ++slot) {
      simulator_->load(step, slot, program.code[step][slot]);
      if (rtl_) rtl_->load_chunks(step, slot, program.code[step][slot]);
    }
  }
  simulator_->set_program(steps_, program.first_latch_row, latch_rows_);
  if (!rtl_) return;
  rtl_->set_program(steps_, program.first_latch_row, latch_rows_);
  // The simulator's places are 0 from the start. The program's are the rows of its steps, those of
  // the latch and, behind them, one a device at most.
  const int bits =
      (program.first_latch_row + latch_rows_) * machine_.slots + image.statistics.bit_devices;
  const int words = steps_ * machine_.units + image.statistics.word_devices;
  for (int i = 0; i < std::min(bits, machine_.rows * machine_.slots); ++i) write_bit(i, false);
  for (int i = 0; i < std::min(words, machine_.word_rows * machine_.units); ++i) write_word(i, 0);
}

void WideProcessor::write_bit(int address, bool value) {
  simulator_->set_bit(address, value);
  if (rtl_) rtl_->write_bit({address / machine_.slots, address % machine_.slots}, value);
}

void WideProcessor::write_word(int address, std::uint16_t value) {
  simulator_->set_word(address, value);
  if (rtl_) rtl_->write_word({address / machine_.units, address % machine_.units}, value);
}

std::vector<std::uint16_t> WideProcessor::read(bool words, std::span<const int> addresses) {
  if (rtl_) return words ? rtl_->read_words(addresses) : rtl_->read_bits(addresses);
  std::vector<std::uint16_t> values;
  values.reserve(addresses.size());
  for (const int address : addresses) {
    values.push_back(words ? simulator_->word(address) : simulator_->bit(address) ? 1 : 0);
  }
  return values;
}

std::vector<std::uint16_t> WideProcessor::read_bits(std::span<const int> addresses) {
  return read(false, addresses);
}
std::vector<std::uint16_t> WideProcessor::read_words(std::span<const int> addresses) {
  return read(true, addresses);
}
bool WideProcessor::read_bit(int address) { return read(false, {&address, 1}).front() != 0; }
std::uint16_t WideProcessor::read_word(int address) { return read(true, {&address, 1}).front(); }

ScanResult WideProcessor::run_scan(std::span<const std::uint8_t> inputs) {
  simulator_->run_scan(inputs);
  if (!rtl_) {
    const auto clocks = static_cast<std::uint32_t>(simulator_->clocks());
    return {clocks, clocks, simulator_->error()};
  }
  std::vector<bool> latched(static_cast<std::size_t>(latch_rows_ * machine_.slots));
  for (std::size_t i = 0; i < inputs.size(); ++i) latched[i] = inputs[i] != 0;
  const wide::Scan scan = rtl_->scans({latched}).front();
  compare(scan);
  return {static_cast<std::uint32_t>(scan.edges), scan.clocks, scan.error};
}

void WideProcessor::compare(const wide::Scan& scan) const {
  const auto differ = [](const std::string& where) {
    throw std::runtime_error("MPU4: RTL and simulator differ: " + where);
  };
  if (static_cast<int>(scan.rows.size()) != steps_) differ("number of steps");
  for (int step = 0; step < steps_; ++step) {
    const wide::Row& row = scan.rows[static_cast<std::size_t>(step)];
    if (row.step != step) differ(fmt::format("order of steps at {}", step));
    for (int slot = 0; slot < machine_.slots; ++slot) {
      if (row.bits[static_cast<std::size_t>(slot)] != simulator_->computed_bit(step, slot)) {
        differ(fmt::format("step {}, slot {}", step, slot));
      }
    }
    for (int unit = 0; unit < machine_.units; ++unit) {
      if (row.words[static_cast<std::size_t>(unit)] != simulator_->computed_word(step, unit)) {
        differ(fmt::format("step {}, unit {}", step, unit));
      }
    }
  }
  if (scan.error != simulator_->error()) differ("the error flag");
}

std::unique_ptr<WideProcessor> make_wide_processor(int slots) {
  return std::make_unique<WideProcessor>(slots, wide::make_wide_rtl(slots, 1));
}
std::unique_ptr<WideProcessor> make_wide_simulator(int slots) {
  return std::make_unique<WideProcessor>(slots, nullptr);
}

}  // namespace rung::tb
