// SPDX-License-Identifier: Apache-2.0
// A program that is being looked at while it runs. One thread owns the engine and everything that
// changes; all others send it jobs. Any number of clients look at the same session.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "view/engine.hpp"
#include "view/history.hpp"
#include "view/program_view.hpp"

namespace rung::view {

enum class Mode : std::uint8_t { Paused, RealTime, Fast };

// Stops the run after a scan in which the device changed, or, with a value, changed to it.
struct Breakpoint {
  std::optional<std::int16_t> value;
};

// Makes an engine by its name; throws what people are to be told.
using EngineMaker = std::function<std::unique_ptr<Engine>(const std::string& name)>;

// All of it belongs to the session's thread.
class Run {
 public:
  // `engines`: the names that `maker` takes; the first one is made.
  Run(const ProgramView& view, std::vector<std::string> engines, EngineMaker maker);

  const ProgramView& view() const { return view_; }
  Engine& engine() const { return *engine_; }
  const std::vector<std::string>& engines() const { return engines_; }
  const History& history() const { return history_; }
  const std::vector<std::int16_t>& values() const { return values_; }
  const std::vector<bool>& power() const { return power_; }
  const std::map<int, std::int16_t>& forced() const { return forced_; }
  const std::map<int, Breakpoint>& breakpoints() const { return breakpoints_; }
  Mode mode() const { return mode_; }
  std::int64_t scans() const { return scans_; }
  // Grows whenever something that clients show has changed; with each run from the start `runs`.
  std::uint64_t version() const { return version_; }
  std::uint64_t runs() const { return runs_; }
  // When each device changed last.
  const std::vector<std::uint64_t>& versions() const { return versions_; }
  // What the program's UART has sent lately.
  const std::string& sent() const { return sent_; }
  // Why it paused, or what went wrong; empty if nothing did.
  const std::string& message() const { return message_; }
  bool failed() const { return failed_; }

  void set_mode(Mode mode);
  // So many scans, then paused.
  void step(int scans);
  // From the next scan on; an input holds.
  void set(int device, std::int16_t value);
  void force(int device, std::optional<std::int16_t> value);
  void release_all();
  void set_breakpoint(int device, std::optional<Breakpoint> breakpoint);
  // From the start, with the inputs as they are.
  void restart(const std::string& engine);

  bool has_work() const { return mode_ != Mode::Paused || steps_ > 0; }
  void one_scan();

 private:
  void sample(bool live);
  void check_breakpoints(const std::vector<std::int16_t>& before);
  void pause(std::string why, bool failed);
  void touch() { ++version_; }

  const ProgramView& view_;
  std::vector<std::string> engines_;
  EngineMaker maker_;
  std::unique_ptr<Engine> engine_;
  History history_;
  std::vector<std::int16_t> values_;
  std::vector<std::uint64_t> versions_;
  std::vector<bool> power_;
  std::map<int, std::int16_t> inputs_;   // as they were set
  std::map<int, std::int16_t> pending_;  // for the next scan
  std::map<int, std::int16_t> forced_;
  std::map<int, Breakpoint> breakpoints_;
  Mode mode_ = Mode::Paused;
  int steps_ = 0;
  std::int64_t scans_ = 0;
  std::uint64_t version_ = 1, runs_ = 1;
  std::string message_;
  std::string sent_;
  bool failed_ = false;
};

class Session {
 public:
  explicit Session(std::unique_ptr<Run> run);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Runs `job` between two scans and gives what it gives, or throws what it throws.
  template <typename Job>
  auto call(Job job) {
    using Result = decltype(job(*run_));
    // The session's thread may still be in its end when the result is here.
    auto task = std::make_shared<std::packaged_task<Result()>>([&] { return job(*run_); });
    auto result = task->get_future();
    post([task] { (*task)(); });
    return result.get();
  }

 private:
  void post(std::function<void()> job);
  void loop();
  void run_jobs();

  std::unique_ptr<Run> run_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rung::view
