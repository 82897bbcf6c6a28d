// SPDX-License-Identifier: Apache-2.0
// The golden model of rounds (hdl/flow/README.md): steps of tasks in turn, then the ladder, each
// instruction as Reference executes it. It knows nothing of the compiler's later steps, of clocks
// or of lines: whoever runs it answers the requests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowchart/flowchart.hpp"
#include "reference/reference.hpp"

namespace rung {

enum class FlowState : std::uint8_t { Fetch, Load, Store, Pause };

struct FlowTaskState {
  FlowState state = FlowState::Fetch;
  bool started = false;
  bool waits = false;    // for its data
  std::size_t step = 0;  // that it is at, or will begin with its next turn
};

// A transfer that is under way over a link or the panel's line.
struct FlowRequest {
  int id = 0;
  std::size_t task = 0;
  bool write = false;
  flowchart::Transfer transfer;
  std::vector<std::int16_t> words;  // of a write
};

struct FlowWrite {
  Device device;
  std::int16_t value = 0;
  std::optional<std::size_t> task;  // whose step, or its read, wrote it; else the ladder
  bool operator==(const FlowWrite&) const = default;
};

// Events since the start, as the controller's registers of these names count them.
struct FlowCounters {
  int pool_full = 0, held = 0, failed = 0, late = 0;
};

// A controller that runs `chart`, which must outlive it, `tick_us` from round to round. All devices
// are 0 at the start. `config` says which of its words are variables of its own board.
class FlowRounds {
 public:
  explicit FlowRounds(const flowchart::Flowchart& chart, std::int64_t tick_us = 10000,
                      std::string config = "ecp5");

  // As Reference has them.
  void set(Device device, std::int16_t value) { ladder_.set(device, value); }
  std::int16_t get(Device device) const { return ladder_.get(device); }

  // As Reference::watch, of the ladder.
  void watch(std::vector<Conduction>& seen) { ladder_.watch(seen); }

  // One round: turns, then the ladder.
  void run_round();
  // The same in its parts: begin_round(), then turn() until it gives nothing, then end_round().
  void begin_round();
  // One turn of the next task that is ready and has had none in this round: which one it was.
  std::optional<std::size_t> turn();
  void end_round();

  // Requests without an answer, in the order in which they went out, those of tasks that have been
  // stopped since too.
  const std::vector<FlowRequest>& requests() const { return requests_; }
  // The answer to a request: a status of flow.toml and, of a read that is done, its words.
  void complete(int id, int status, const std::vector<std::int16_t>& words = {});

  FlowTaskState task(std::size_t number) const;
  void set_break(std::size_t step, bool on) { breaks_.at(step) = on; }
  void pause(std::size_t task);  // before its next step
  void go_on(std::size_t task);  // from PAUSE

  // Of the round so far, in their order; what no program names is not among them.
  const std::vector<FlowWrite>& writes() const { return writes_; }
  const FlowCounters& counters() const { return counters_; }

 private:
  struct TaskRow {
    bool started = false;
    bool waits = false;
    bool paused = false;
    bool asked = false;   // to pause
    bool passes = false;  // the breakpoint that it stood at
    FlowState state = FlowState::Fetch;
    std::size_t step = 0;
    std::size_t next = 0;
    bool ends = false;  // when its write is done
    bool has_block = false;
    int request = 0;                  // the one it waits for
    int status = 0;                   // of its last transfer,
    bool status_due = false;          // to be shown to its next step
    std::vector<std::int16_t> words;  // that a read has brought
  };
  enum class Way : std::uint8_t { None, Own, Refused, Line };

  bool is_ready(std::size_t task) const;
  void take_turn(std::size_t task);
  // `answered`: behind the answer to its step before, in the same turn.
  void fetch(std::size_t task, bool answered);
  // Nothing is left of a step that cannot begin.
  bool can_begin(const flowchart::Step& step, bool answered);
  void run_step(std::size_t task);
  // What its routine has written to the words that speak to the tasks; false if it stopped itself.
  bool obey(std::size_t task);
  void store(std::size_t task);
  void finish_step(std::size_t task);
  void start(std::size_t task);
  void stop(std::size_t task);
  void send(std::size_t task, bool write, const flowchart::Transfer& transfer);
  void free_block(std::size_t task);

  Way way(const std::optional<flowchart::Transfer>& transfer) const;
  // The word that is variable `number` of this unit's own board.
  std::optional<Device> variable(int number) const;
  void read_own(std::size_t task, const flowchart::Transfer& transfer);
  void write_own(std::size_t task, const flowchart::Transfer& transfer);
  void write(std::size_t task, Device device, std::int16_t value);
  void count_time();

  const flowchart::Flowchart& chart_;
  std::string config_;
  Reference ladder_;
  std::vector<std::unique_ptr<Reference>> steps_;  // as they are first run
  std::vector<bool> breaks_;                       // by step
  std::vector<TaskRow> tasks_;
  std::vector<FlowRequest> requests_;
  std::map<std::size_t, std::size_t> holders_;       // of exclusive boards: task, by board
  std::map<int, std::vector<std::size_t>> orphans_;  // boards that a request of nobody still holds
  int free_blocks_;
  bool short_ = false;         // a step lacked a block or board in this round,
  bool short_before_ = false;  // in the one before
  int last_request_ = 0;
  std::size_t began_;       // the task that began the last round
  std::size_t first_ = 0;   // where this one begins
  std::size_t passed_ = 0;  // how many tasks it has gone past
  bool any_turn_ = false;
  ScanTime time_;
  std::vector<FlowWrite> writes_;
  FlowCounters counters_;
};

}  // namespace rung
