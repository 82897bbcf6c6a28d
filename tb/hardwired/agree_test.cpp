// SPDX-License-Identifier: Apache-2.0
// Hard-wired programs beside the reference: all devices after every scan, bytes sent, divisions by
// zero, the outputs, and the clocks that a scan takes.
//
// RUNG_SUBJECT=NAME compares that program alone ("random-17", "golden conveyor.il").
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/ldmicro_case.hpp"
#include "hardwired/bench.hpp"
#include "hardwired/model.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

// The ladder's transmitter: busy in the scan of a byte and in the next one.
struct Transmitter {
  int busy = 0;

  void begin(Bench& bench, std::size_t program) {
    if (busy > 0) --busy;
    if (bench.get(program, port::uart_tx_ready) != (busy == 0 ? 1 : 0)) {
      bench.set(program, port::uart_tx_ready, busy == 0 ? 1 : 0);
    }
  }
  std::vector<int> end(const Bench& bench, std::size_t program, bool has) {
    if (!has || busy > 0 || bench.get(program, port::uart_tx_ready) != 0) return {};
    busy = 2;
    return {bench.get(program, port::uart_tx_data) & 0xFF};
  }
};

class Agreement {
 public:
  explicit Agreement(const std::vector<Subject>& subjects)
      : subjects_(subjects), batch_(subjects), bench_(batch_, std::make_unique<VerilatedBatch>()) {
    for (const Subject& subject : subjects) {
      expected_.push_back(run_ldmicro_reference(subject.what));
      got_.emplace_back();
    }
    transmitters_.resize(subjects.size());
  }

  void run() {
    int scans = 0;
    for (const Subject& subject : subjects_) scans = std::max(scans, subject.what.scans());
    for (int k = 0; k < scans; ++k) scan(k);
  }

  // The first difference of a program, or nothing.
  std::string difference_of(std::size_t i) const {
    return difference(subjects_[i].what, expected_[i], got_[i], "hard-wired logic") + faults_[i];
  }
  const hardwired::Module& module(std::size_t i) const { return batch_.modules()[i].module; }

 private:
  void scan(int k) {
    std::vector<bool> running;
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
      const Case& one = subjects_[i].what;
      running.push_back(k < one.scans());
      if (!running[i]) continue;
      for (const StimulusEvent& event : one.events[static_cast<std::size_t>(k)]) {
        bench_.set(i, event.device, event.value);
        if (event.device == port::uart_rx_data) bench_.set(i, port::uart_rx_full, 1);
      }
      transmitters_[i].begin(bench_, i);
      bench_.drive(i, one.program.dialect, {k, one.tick_us});
    }
    const std::vector<int> clocks = bench_.scan(running);
    faults_.resize(subjects_.size());
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
      if (running[i]) record(i, k, clocks[i]);
    }
  }

  void record(std::size_t i, int k, int clocks) {
    const Case& one = subjects_[i].what;
    const hardwired::Interface& interface = module(i).interface;
    std::vector<std::int16_t> state;
    for (std::size_t d = 0; d < one.devices.size(); ++d) {
      // A port that no live element uses has no bit: it stays as it was given.
      const bool has = interface.state_bits.contains(one.devices[d]);
      state.push_back(has ? bench_.get(i, one.devices[d])
                          : expected_[i].states[static_cast<std::size_t>(k)][d]);
      if (!has && !is_port(one.devices[d].kind)) fault(i, k, "no bit for a device");
    }
    got_[i].states.push_back(std::move(state));
    got_[i].sent.push_back(
        transmitters_[i].end(bench_, i, interface.state_bits.contains(port::uart_tx_ready)));
    got_[i].errors.push_back(bench_.error(i));
    if (clocks != module(i).clocks) fault(i, k, fmt::format("a scan of {} clocks", clocks));
    for (std::size_t o = 0; o < interface.outputs.size(); ++o) {
      if (bench_.output(i, o) != (bench_.get(i, interface.outputs[o]) != 0)) {
        fault(i, k, "an output is not what its device is");
      }
    }
  }

  void fault(std::size_t i, int k, const std::string& what) {
    if (faults_[i].empty()) faults_[i] = fmt::format("scan {}: {}\n", k, what);
  }

  const std::vector<Subject>& subjects_;
  Batch batch_;
  Bench bench_;
  std::vector<Behaviour> expected_, got_;
  std::vector<Transmitter> transmitters_;
  std::vector<std::string> faults_;
};

TEST(Hardwired, AgreesWithTheReference) {
  const std::vector<Subject> subjects = subjects_of(RUNG_SET);
  Agreement agreement(subjects);
  agreement.run();
  const char* only = std::getenv("RUNG_SUBJECT");
  int compared = 0, several = 0;
  std::size_t holds = 0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (only != nullptr && subjects[i].name != only) continue;
    ++compared;
    if (agreement.module(i).clocks > 1) ++several;
    holds += agreement.module(i).holds;
    const std::string found = agreement.difference_of(i);
    EXPECT_TRUE(found.empty()) << subjects[i].name << " (" << subjects[i].replay << "): " << found
                               << subjects[i].what.text << "replay: RUNG_SUBJECT='"
                               << subjects[i].name
                               << "' build/test/tb/hardwired/hardwired_" RUNG_SET;
  }
  EXPECT_GT(compared, 0) << "no program " << (only == nullptr ? "" : only);
  if (only != nullptr) return;
  // Otherwise most of what is here would not have been tried.
  EXPECT_GT(several, 30);
  EXPECT_GT(holds, 20U);
}

}  // namespace
}  // namespace rung::tb
