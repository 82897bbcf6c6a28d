// SPDX-License-Identifier: Apache-2.0
#include "unit/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace rung::tb {
namespace {

// Elaborating a model takes longer than most tests, so each is made once.
std::shared_ptr<Processor> shared_processor(const Target& target) {
  static std::map<std::pair<isa::Mpu, std::string_view>, std::shared_ptr<Processor>> processors;
  auto& processor = processors[{target.mpu, target.config->name}];
  if (!processor) processor = make_processor(target.mpu, *target.config);
  return processor;
}

std::string describe(const Retired& r) {
  std::string text = fmt::format("exc {:d}", r.exc);
  if (r.bit_we) text += fmt::format(", bit {} <- {:d}", r.bit_address, r.bit_value);
  if (r.word_we) text += fmt::format(", word {} <- {}", r.word_address, r.word_value);
  return text;
}

bool same(const Retired& a, const Retired& b) {
  return a.step == b.step && a.slot == b.slot && a.exc == b.exc && a.bit_we == b.bit_we &&
         (!a.bit_we || (a.bit_address == b.bit_address && a.bit_value == b.bit_value)) &&
         a.word_we == b.word_we &&
         (!a.word_we || (a.word_address == b.word_address && a.word_value == b.word_value));
}

}  // namespace

std::vector<Target> targets(const std::vector<isa::Mpu>& mpus) {
  std::vector<Target> targets;
  for (const isa::Config* config : distinct_configs()) {
    for (const isa::Mpu mpu : mpus) targets.push_back({mpu, config});
  }
  return targets;
}

std::string target_name(const testing::TestParamInfo<Target>& info) {
  return fmt::format("mpu{}_{}", static_cast<int>(info.param.mpu), info.param.config->name);
}

Bench::Bench(const Target& target)
    : target_(target), rtl_(shared_processor(target)), model_(target.mpu, *target.config) {
  rtl_->reset();
  rtl_->clear_devices();
  for (int row = 0; row < isa::constant::lut_rows; ++row) rtl_->load_lut(row, 0);
}

void Bench::set_bit(int address, bool value) {
  rtl_->write_bit(address, value);
  model_.bits[static_cast<std::size_t>(address)] = value;
}

void Bench::set_word(int address, std::uint16_t value) {
  rtl_->write_word(address, value);
  model_.words[static_cast<std::size_t>(address)] = value;
}

void Bench::set_lut(int row, std::uint8_t function) {
  rtl_->load_lut(row, function);
  model_.lut[static_cast<std::size_t>(row)] = function;
}

Step Bench::step(const isa::SlotInstruction& instruction, int slot) const {
  Step step(static_cast<std::size_t>(slots()));
  step[static_cast<std::size_t>(slot)] = instruction;
  return step;
}

testing::AssertionResult Bench::scan(const std::vector<Step>& program) {
  std::vector<std::vector<std::uint64_t>> code;
  for (const Step& step : program) {
    auto& words = code.emplace_back();
    for (const isa::SlotInstruction& instruction : step) {
      words.push_back(isa::encode(instruction, mpu(), config()));
    }
  }
  rtl_->load_program(code);
  program_ = program;
  return scan_again();
}

testing::AssertionResult Bench::scan_again() {
  return compare(program_, 0, [this](const RetireObserver& seen) { return rtl_->run_scan(seen); });
}

testing::AssertionResult Bench::scan_range(std::size_t entry, std::size_t end) {
  const auto begin = program_.begin();
  return compare(
      {begin + static_cast<std::ptrdiff_t>(entry), begin + static_cast<std::ptrdiff_t>(end)}, entry,
      [&](const RetireObserver& seen) {
        return rtl_->run_range(static_cast<std::uint16_t>(entry), static_cast<std::uint16_t>(end),
                               seen);
      });
}

testing::AssertionResult Bench::compare(
    const std::vector<Step>& program, std::size_t first,
    const std::function<ScanResult(const RetireObserver&)>& run) {
  retired_.clear();
  const ScanResult result = run([&](const Retired& r) {
    retired_.push_back(r);
    retired_.back().step -= static_cast<std::uint32_t>(first);
  });
  // A waiting instruction completes after what stands beside it in its step.
  std::stable_sort(retired_.begin(), retired_.end(), [](const Retired& a, const Retired& b) {
    return std::tie(a.step, a.slot) < std::tie(b.step, b.slot);
  });
  std::uint32_t clocks = 0;
  const std::vector<Retired> expected = model_.scan(program, clocks);
  for (std::size_t i = 0; i < std::min(expected.size(), retired_.size()); ++i) {
    if (same(expected[i], retired_[i])) continue;
    const Retired& want = expected[i];
    return testing::AssertionFailure() << fmt::format(
               "step {} slot {} ({}): expected {}, got step {} slot {}: {}", want.step, want.slot,
               isa::info(program[want.step][want.slot].opcode).name, describe(want),
               retired_[i].step, retired_[i].slot, describe(retired_[i]));
  }
  if (expected.size() != retired_.size()) {
    return testing::AssertionFailure()
           << fmt::format("{} instructions retired, expected {}", retired_.size(), expected.size());
  }
  if (result.clocks != clocks || result.counted != clocks) {
    return testing::AssertionFailure() << fmt::format("{} clocks, the counter says {}, expected {}",
                                                      result.clocks, result.counted, clocks);
  }
  if (result.error != model_.error) {
    return testing::AssertionFailure()
           << fmt::format("error flag {:d}, expected {:d}", result.error, model_.error);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult Bench::devices_equal() {
  for (int i = 0; i < config().bit_devices; ++i) {
    const bool want = model_.bits[static_cast<std::size_t>(i)];
    if (rtl_->read_bit(i) != want) {
      return testing::AssertionFailure() << fmt::format("bit {} is not {:d}", i, want);
    }
  }
  for (int i = 0; i < config().word_devices; ++i) {
    const std::uint16_t want = model_.words[static_cast<std::size_t>(i)];
    const std::uint16_t got = rtl_->read_word(i);
    if (got != want) {
      return testing::AssertionFailure() << fmt::format("word {}: {}, expected {}", i, got, want);
    }
  }
  return testing::AssertionSuccess();
}

}  // namespace rung::tb
