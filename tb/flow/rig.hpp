// SPDX-License-Identifier: Apache-2.0
// The bench top under Verilator, with link and panel played by C++: requests are carried out after
// a delay, or held until the test lets them go.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "flow/program.hpp"

namespace rung::tb::flow {

struct Request {
  bool panel = false;
  int block = 0;
  bool write = false;
  int unit = 0;
  int board = 0;
  int first = 0;
  int count = 0;
  std::vector<std::uint16_t> words;  // of a write
};

// What another side does with a request.
struct Answer {
  int delay = 0;  // clocks; negative: not until release()
  int status = 0;
  std::vector<std::uint16_t> words;  // of a read
};

struct Event {
  bool write = false;
  int board = 0;
  int first = 0;
  int count = 1;
  int from = 2;
  int tag = 0;
  std::vector<std::uint16_t> words;
};

struct Reply {
  bool write = false;
  int status = 0;
  int count = 0;
  int to = 0;
  int tag = 0;
  std::vector<std::uint16_t> words;
};

struct Write {
  int word = 0;
  std::uint16_t value = 0;
};

struct Round {
  int clocks = 0;                 // from the edge that samples round_i to that of round_done_o
  int ladder = 0;                 // the ladder's, likewise
  std::vector<Write> writes;      // of routines, in order
  std::vector<int> starts;        // clocks of the round in which routines began
  std::vector<Request> requests;  // that went out
  std::vector<Reply> replies;     // that came
};

class Rig {
 public:
  virtual ~Rig() = default;

  virtual isa::Mpu mpu() const = 0;
  virtual void reset() = 0;
  virtual void load(const Program& program) = 0;
  virtual void write_word(int word, std::uint16_t value) = 0;
  virtual std::uint16_t read_word(int word) = 0;
  virtual void bus_write(int address, int value) = 0;
  virtual std::uint16_t bus_read(int address) = 0;
  virtual void idle(int clocks) = 0;
  // Setup register `enable`.
  virtual void enable(int bits) = 0;
  // A program's start: the first round behind it finds the tasks as the table says.
  virtual void first() = 0;
  // One round; with `abort_after`, the watchdog strikes after so many clocks.
  virtual Round round(std::optional<int> abort_after = {}) = 0;

  // Decides what becomes of each request when its words have been fetched.
  std::function<Answer(const Request&)> answer;
  // Requests that are held, in their order; release() carries one out.
  virtual std::vector<Request> held() const = 0;
  // All that have not been answered.
  virtual std::vector<Request> outstanding() const = 0;
  virtual void release(std::size_t which, const Answer& answer) = 0;
  // Clocks until all that was let go has come, but what is held.
  virtual void drain() = 0;
  virtual void send(const Event& event) = 0;
  // The link takes replies; it does unless told otherwise.
  bool takes_replies = true;

  // State of a task: bits of flow_task_state, and its step.
  int state(int task);
  int step(int task);
};

inline int Rig::state(int task) {
  bus_write(rung::flow::reg_flow_task, task);
  idle(2);
  return bus_read(rung::flow::reg_flow_task_state);
}
inline int Rig::step(int task) {
  bus_write(rung::flow::reg_flow_task, task);
  idle(2);
  return bus_read(rung::flow::reg_flow_task_step);
}

// A rig after reset. Rigs of one processor share its Verilated model, one at a time.
std::shared_ptr<Rig> make_rig(isa::Mpu mpu);

}  // namespace rung::tb::flow
