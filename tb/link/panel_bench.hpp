// SPDX-License-Identifier: Apache-2.0
// hdl/flow/panel_client.v between a model of the scheduler and its pool, and a Modbus RTU server on
// its line. The server answers in order, as servers do. What it reads from a register says in which
// of its answers, so that an answer to another request shows.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "Vpanel_client.h"
#include "controller/bit_line.hpp"
#include "harness/clocked.hpp"

namespace rung::tb {

using Frame = std::vector<std::uint8_t>;

constexpr int kPanelClocksPerMs = 1000;  // CLOCK_HZ 1,000,000

enum class Answer : std::uint8_t {
  Right,
  WrongCrc,
  WrongParity,
  WrongUnit,
  WrongCount,
  Halves,  // right, with a pause of less than 3.5 characters
  BehindNoise,
  Exception,
  Silent,
  Raw  // what the plan says, whatever it is
};
enum class Echo : std::uint8_t { Right, Exception, Silent };  // what it makes of FC 8

class PanelServer {
 public:
  PanelServer(double clocks_per_bit, Parity parity, std::uint8_t unit);

  // For each request in turn; then Right without delay.
  struct Plan {
    Answer answer = Answer::Right;
    std::uint64_t delay = 0;
    Frame raw = {};
  };
  void plan(Plan plan) { plans_.push_back(std::move(plan)); }
  void forget_plans() { plans_.clear(); }
  Echo echo = Echo::Right;

  bool level(std::uint64_t now);
  void sample(std::uint64_t now, bool level);

  struct Request {
    int function = 0;
    unsigned first = 0;
    std::vector<std::uint16_t> words;  // of a write, or of the answer to a read
    unsigned count = 0;
    Answer answer = Answer::Right;
    std::uint64_t begun_at = 0;  // its start bit
  };
  // All that came whole, but for FC 8.
  const std::vector<Request>& requests() const { return requests_; }
  int probes() const { return probes_; }
  int broken() const { return broken_; }  // requests that did not come whole
  int too_close() const { return too_close_; }

 private:
  void heard(std::uint64_t now);
  Frame serve(const Frame& frame, Plan& plan);
  // What a request and an answer of any bytes come to: Right (with the words that it brings),
  // Exception, or Silent for one that is none.
  static Answer meaning(Request& request, const Frame& right, const Frame& raw);
  void queue(std::uint64_t now, const Frame& frame, const Plan& plan);

  BitLine line_;
  double bit_;
  std::uint8_t unit_;
  std::deque<Plan> plans_;
  struct Sending {
    std::uint64_t at;
    Frame frame;
    bool bad_byte;
  };
  std::deque<Sending> to_send_;
  Frame heard_;
  std::uint64_t quiet_since_ = 0;  // on both lines
  std::uint64_t began_at_ = 0;     // the last answer
  std::uint64_t begun_at_ = 0, heard_at_ = 0;
  std::uint64_t free_at_ = 0;
  std::vector<Request> requests_;
  int probes_ = 0, broken_ = 0, too_close_ = 0;
};

class PanelBench {
 public:
  PanelBench(int seed, double clocks_per_bit, Parity parity, int timeout_ms);

  struct Asked {
    int block = 0;
    bool write = false;
    unsigned first = 0;
    unsigned count = 0;
    std::vector<std::uint16_t> words;  // of a write
    std::uint64_t at = 0;
    std::optional<int> status;
    std::uint64_t done_at = 0;
    std::vector<std::uint16_t> read;
  };

  // The number of the request. There has to be a free block.
  std::size_t ask(bool write, unsigned first, unsigned count);
  bool room() const { return outstanding_.size() < kBlocks; }
  void clock();
  void run(std::uint64_t clocks);
  void run_to_end();  // of all requests
  const Asked& asked(std::size_t number) const { return asked_.at(number); }
  std::size_t number() const { return asked_.size(); }
  // The rules for each request that has ended.
  void check(std::size_t number) const;

  PanelServer server;
  bool echoes = false;  // the line is RS-485 with two wires: what is sent is received
  double busy = 0.25;   // part of the clocks in which the pool has no time
  int timeout_ms;
  std::uint64_t now() const { return now_; }
  int bad() { return dut_->bad_o; }
  int timeouts() { return dut_->timeouts_o; }
  Vpanel_client* operator->() { return dut_.operator->(); }

  static constexpr std::size_t kBlocks = 25;
  static constexpr std::uint8_t kUnit = 17;

 private:
  void before_edge();

  Clocked<Vpanel_client> dut_;
  std::mt19937 random_;
  std::vector<std::uint16_t> pool_;
  std::vector<Asked> asked_;
  std::deque<std::size_t> to_offer_, outstanding_;
  std::uint64_t now_ = 0;
  std::uint64_t millisecond_at_;
};

}  // namespace rung::tb
