// SPDX-License-Identifier: Apache-2.0
// What a round of flow tasks does, in the words of hdl/flow/README.md and without clocks. What
// comes from outside (data, events) comes between rounds.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "flow/rig.hpp"

namespace rung::tb::flow {

// One round's result.
struct Expected {
  std::vector<Write> writes;
  std::vector<Request> requests;
  std::vector<Reply> replies;
};

struct Counters {
  int full = 0, held = 0, failed = 0, events = 0, event_waits = 0, vanished = 0;
};

class Model {
 public:
  explicit Model(const Program& program);

  std::vector<std::uint16_t> words;
  Counters counters;
  // What becomes of requests that are waited for in their place.
  std::function<Answer(const Request&)> answer;

  // A program's start.
  void first();
  Expected round();
  // An outstanding request's answer; only between rounds.
  void come(int block, const Answer& answer);
  void receive(const Event& event, int block);
  // Of those for event commands, as the pool offers them.
  int lowest_event_block() const;
  int free_event_blocks() const {
    return rung::flow::flow_event_blocks - static_cast<int>(ring_.size());
  }
  // The PC: its command, and the words of its block.
  struct Pc {
    int state = 0;  // of flow_pc_control
    bool write = false;
    Transfer transfer;
    int status = 0;
  } pc;
  std::array<std::vector<std::uint16_t>, 32> blocks;
  std::set<int> breakpoints;
  void go_on(int task);
  void ask(int task);
  // As flow_task_state and flow_task_step have it.
  int state(int task) const;
  int step(int task) const;

 private:
  enum class Way { Refused, Local, Panel, Link };
  struct Row {
    bool started = false, waits = false, paused = false, ask = false, skip = false;
    int step = 0;
    bool ends = false;
    int phase = 0;  // FETCH, LOAD, STORE
    int shown = 0;  // its step, as the bus sees it
    std::optional<int> status;
    std::optional<int> block;
    // Its step is still shown.
    void stop() {
      const int last = shown;
      *this = Row{};
      shown = last;
    }
  };
  struct Command {
    Event event;
    int block = 0;
    bool waits = false, came = false, replies = false;
    int status = 0;
  };

  Way way(const Transfer& t) const;
  bool own(const Transfer& t) const { return t.unit == kUnit; }
  int board(const Transfer& t) const { return program_.boards[static_cast<std::size_t>(t.board)]; }
  bool exclusive(const Transfer& t) const;
  bool blocked(const Transfer& t) const { return exclusive(t) && locks_.contains(t.board); }
  bool in_place(const Transfer& t) const {
    return program_.in_place || (own(t) && (board(t) & kOverLink) == 0);
  }
  void lock(const Transfer& t, int block) {
    if (exclusive(t)) locks_[t.board] = block;
  }
  void free(int block);
  // True if it has been answered.
  bool request(const Transfer& t, int block, bool write);
  // Between block and devices, by the map.
  void load_block(const Transfer& t, int block);
  void store_block(const Transfer& t, int block);

  void turn(int task);
  // True if the step's routine can run in this turn, false if the turn is over.
  // `answered`: behind the answer to a STORE, in the same turn.
  bool fetch(int task, std::optional<int>& block, bool answered);
  void run(int task, std::optional<int> block);
  void loaded(int task);
  void stored(int task);
  void pc_command();
  void event_command(Command command);
  // 0: it waits; a status if it is done. `waits`: it goes on.
  std::optional<int> command(const Transfer& t, bool write, int block);

  const Program& program_;
  std::vector<Row> rows_;
  std::set<int> free_blocks_;
  std::map<int, int> owners_;  // block -> task that waits for it
  std::map<int, int> locks_;   // board -> block
  std::deque<Command> ring_;
  std::map<int, int> statuses_;  // of blocks whose data have come
  int began_ = rung::flow::flow_tasks - 1;
  // Somebody had no block or board since the turns of this round began, or of the one before.
  bool short_ = false;
  bool short_before_ = false;
  Expected now_;
};

}  // namespace rung::tb::flow
