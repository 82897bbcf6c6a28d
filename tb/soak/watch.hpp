// SPDX-License-Identifier: Apache-2.0
// Watches a controller at its pins, clock by clock: while a program runs, the outputs change in one
// clock of each scan only, to what the reference interpreter has; else they are safe. Nothing
// starts, stops or changes that was not to be expected.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "controller/simulated_controller.hpp"
#include "programs/random_source.hpp"
#include "reference/reference.hpp"
#include "soak/soak_program.hpp"

namespace rung::tb {

// What the controller did and the reference did not, or the other way round.
struct Difference : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Watch {
 public:
  using Made = std::shared_ptr<const SoakProgram>;
  // A client's write: it takes effect between two scans, when `mark` goes to `level`.
  struct Write {
    std::vector<std::pair<Device, std::int16_t>> values;
    int mark = 0;
    bool level = false;
  };

  Watch(SimulatedController& machine, std::uint64_t seed);

  // Lets time pass, and looks at every clock in which something is to happen or not to happen.
  void advance(std::uint64_t clocks);

  // The next start is one of this program; `trips`: its watchdog ends it before its first refresh.
  void expect_start(Made program, bool trips = false);
  // Nothing starts any more.
  void expect_no_start() { next_.reset(); }
  // The program that runs may end after the scan under way; it must by stopped(), which ends that.
  void expect_stop() { may_stop_ = true; }
  void stopped();
  // The power has gone, or reset was given: at most what is safe in one of these is shown from now.
  void lost(const std::vector<Made>& possible);
  // What the program that is there shows when it does not run, and no other.
  void settle(const Made& program);
  void write(Write write) { write_ = std::move(write); }
  bool written() const { return !write_; }

  bool running() const { return state_ == State::Running; }
  // The program that runs, or ran last, and its devices after the last scan.
  const Made& program() const { return program_; }
  const Reference& reference() const { return *reference_; }
  // Scans of the program since it started, and of all.
  std::int64_t program_scans() const { return program_scans_; }
  std::int64_t scans() const { return scans_; }
  std::int64_t changes() const { return changes_; }
  std::int64_t trips() const { return trips_; }
  std::int64_t glitches() const { return glitches_; }
  // After each scan of the reference.
  std::function<void()> scanned;

 private:
  enum class State { Stopped, Running };

  std::uint64_t next_clock() const;
  void look();
  void look_running();
  void look_stopped();
  void begin_scan(std::uint64_t latch);
  void refresh();
  void stop();
  void set_inputs();
  void may_show_too(const SoakProgram& program);
  void check_safe(const char* when) const;
  [[noreturn]] void fail(const std::string& what) const;

  SimulatedController& machine_;
  RandomSource random_;
  State state_ = State::Stopped;
  std::uint64_t pins_ = 0, levels_in_ = 0;
  std::uint64_t may_be_1_ = 0, may_be_0_ = ~std::uint64_t{0};  // where nothing runs
  std::uint64_t settles_at_ = 0;                               // of pins after a stop
  Made program_, next_;
  bool next_trips_ = false, may_stop_ = false;
  std::unique_ptr<Reference> reference_;
  std::optional<Write> write_;
  std::uint64_t seen_latches_ = 0, latch_ = 0, refresh_ = 0;
  bool refreshed_ = false;
  std::int64_t program_scans_ = 0, scans_ = 0, changes_ = 0, trips_ = 0, glitches_ = 0;
};

}  // namespace rung::tb
