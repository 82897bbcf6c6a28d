// SPDX-License-Identifier: Apache-2.0
#include "agree/case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "melsec/list.hpp"
#include "programs/melsec_stimulus.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"
#include "rungs/footprint.hpp"

namespace rung::tb {
namespace {

constexpr int kLeastScans = 10;
constexpr int kMostScans = 20;

}  // namespace

std::string text_of(std::uint64_t seed, const std::vector<Family>& only) {
  RandomMelsecOptions options = melsec_options(seed);
  if (!only.empty()) {
    for (int i = 0; i < kFamilies; ++i) {
      const auto family = static_cast<Family>(i);
      const bool wanted = std::find(only.begin(), only.end(), family) != only.end();
      // What is asked for is there even where this seed has none of it.
      options.weight(family) = wanted ? std::max(options.weight(family), 10) : 0;
    }
  }
  return random_melsec(seed, options);
}

std::optional<Case> make_case(std::uint64_t seed, const std::string& text, std::string& messages,
                              const Case* original) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, fmt::format("random-{}.il", seed), diagnostics);
  const Dialect dialect = melsec_options(seed).dialect;
  std::optional<Program> program;
  if (source) program = parse_list(*source, dialect, diagnostics);
  if (!program) {
    std::ostringstream out;
    diagnostics.print(out);
    messages = out.str();
    return std::nullopt;
  }
  Case one;
  one.seed = seed;
  one.text = text;
  one.program = std::move(*program);
  one.devices = visible_devices(one.program);
  one.tick_us = melsec_tick_us(seed);
  const int scans = kLeastScans + RandomSource(seed).below(kMostScans - kLeastScans + 1);
  if (original == nullptr) {
    one.events = melsec_stimulus(seed, named_devices(one.program), dialect, scans);
    return one;
  }
  one.events = original->events;
  for (auto& events : one.events) {
    std::erase_if(events, [&](const StimulusEvent& event) {
      return !std::binary_search(one.devices.begin(), one.devices.end(), event.device);
    });
  }
  return one;
}

Behaviour run_reference(const Case& one) {
  Reference reference(one.program, one.tick_us);
  Behaviour behaviour;
  for (const auto& events : one.events) {
    for (const StimulusEvent& event : events) reference.set(event.device, event.value);
    reference.run_scan();
    std::vector<std::int16_t>& state = behaviour.states.emplace_back();
    state.reserve(one.devices.size());
    for (const Device device : one.devices) state.push_back(reference.get(device));
    behaviour.sent.push_back(reference.sent());
  }
  return behaviour;
}

std::string difference(const Case& one, const Behaviour& expected, const Behaviour& got,
                       const std::string& engine) {
  const auto here = [&](std::size_t scan) {
    return fmt::format("seed {}, scan {} (tick {} us): ", one.seed, scan, one.tick_us);
  };
  for (std::size_t scan = 0; scan < expected.states.size(); ++scan) {
    if (scan >= got.states.size()) return fmt::format("{} ended before scan {}\n", engine, scan);
    for (std::size_t i = 0; i < one.devices.size(); ++i) {
      if (expected.states[scan][i] == got.states[scan][i]) continue;
      return here(scan) + fmt::format("{} is {} in the reference and {} in {}\n",
                                      device_name(one.devices[i], one.program),
                                      expected.states[scan][i], got.states[scan][i], engine);
    }
    if (expected.sent[scan] != got.sent[scan]) {
      return here(scan) + fmt::format("the reference sends [{}] and {} [{}]\n",
                                      fmt::join(expected.sent[scan], " "), engine,
                                      fmt::join(got.sent[scan], " "));
    }
    if (!expected.errors.empty() && !got.errors.empty() &&
        expected.errors[scan] != got.errors[scan]) {
      return here(scan) + fmt::format("division by zero: {} in the reference and {} in {}\n",
                                      bool{expected.errors[scan]}, bool{got.errors[scan]}, engine);
    }
  }
  return {};
}

}  // namespace rung::tb
