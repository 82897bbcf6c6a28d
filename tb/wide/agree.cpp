// SPDX-License-Identifier: Apache-2.0
#include "wide/agree.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "reference/reference.hpp"
#include "wide/wide_machine.hpp"

namespace rung::tb {
namespace {

class Pair {
 public:
  Pair(const Program& program, const image::Image& image, const WideHow& how)
      : program_(program),
        image_(image),
        how_(how),
        machine_(image, how.tick_us),
        reference_(program, how.tick_us) {
    expected_.assign(image.devices.size(), 0);
    got_ = expected_;
  }

  std::string scan(std::span<const StimulusEvent> events) {
    for (const StimulusEvent& event : events) {
      reference_.set(event.device, event.value);
      const int device = machine_.find(event.device);
      if (device >= 0) expected_[device] = got_[device] = reference_.get(event.device);
    }
    machine_.apply(events);
    reference_.run_scan();
    machine_.run_scan();
    if (!how_.merge) {
      std::string problem = compare_sequences();
      if (!problem.empty()) return problem;
    }
    for (std::size_t i = 0; i < image_.devices.size(); ++i) {
      if (is_port(image_.devices[i].device.kind)) continue;
      const std::int16_t expected = reference_.get(image_.devices[i].device);
      const std::int16_t got = machine_.value(i);
      if (expected == got) continue;
      return fmt::format("{} after the scan: expected {}, got {}", image_.devices[i].name, expected,
                         got);
    }
    if (reference_.error() != machine_.error()) return "the error flag";
    if (machine_.clocks() != image_.clocks) return "the clocks";
    return {};
  }

 private:
  std::string compare_sequences() {
    std::vector<std::vector<std::int16_t>> expected(image_.devices.size());
    std::vector<std::vector<const WideWritten*>> got(image_.devices.size());
    for (const ReferenceWrite& write : reference_.writes()) {
      const int device = machine_.find(write.device);
      if (device < 0 || std::exchange(expected_[device], write.value) == write.value) continue;
      expected[device].push_back(write.value);
    }
    for (const WideWritten& write : machine_.writes()) {
      if (std::exchange(got_[write.device], write.value) == write.value) continue;
      got[write.device].push_back(&write);
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      for (std::size_t k = 0; k < std::max(expected[i].size(), got[i].size()); ++k) {
        const bool both = k < expected[i].size() && k < got[i].size();
        if (both && expected[i][k] == got[i][k]->value) continue;
        return fmt::format("write {} of {}: expected {}, got {}", k, image_.devices[i].name,
                           k < expected[i].size() ? std::to_string(expected[i][k]) : "none",
                           k < got[i].size() ? fmt::format("{} ({})", got[i][k]->value,
                                                           machine_.describe(*got[i][k]))
                                             : "none");
      }
    }
    return {};
  }

  const Program& program_;
  const image::Image& image_;
  const WideHow& how_;
  WideMachine machine_;
  Reference reference_;
  std::vector<std::int16_t> expected_, got_;
};

}  // namespace

std::string wide_difference(const Program& program, const Stimulus& stimulus, const WideHow& how,
                            std::int64_t* clocks) {
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = how.slots;
  options.merge = how.merge;
  options.search.tries = 4;
  Diagnostics diagnostics;
  const auto compiled = compile(program, options, diagnostics);
  if (!compiled) {
    std::ostringstream text;
    diagnostics.print(text);
    return "refused: " + text.str();
  }
  if (clocks != nullptr) *clocks = compiled->image.clocks;
  Pair pair(program, compiled->image, how);
  for (std::uint64_t i = 0; i < stimulus.scans(); ++i) {
    const std::string problem = pair.scan(stimulus.events(i));
    if (!problem.empty()) return fmt::format("scan {}: {}", i, problem);
  }
  return {};
}

}  // namespace rung::tb
