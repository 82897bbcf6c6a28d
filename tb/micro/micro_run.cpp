// SPDX-License-Identifier: Apache-2.0
// Runs programs on the Verilated micro-sequencer beside a model of its bus: micro_run < JOBS.
//
// A job is: its name, the seed of what the bus answers, the number of events (reads and writes of
// the bus) to show, the most clocks, the number of words, the words in hexadecimal. Shown is a line
// `name`, then one line an event, `r` or `w` with address and value: native.h prints the same. Exit
// 1: something on the bus that must not be.
#include <fmt/core.h>

#include <cstdint>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Vmicro.h"
#include "native.h"

namespace {

constexpr unsigned ROM_WORDS = 4096;

struct Job {
  std::string name;
  std::uint32_t seed = 0;
  unsigned events = 0;
  std::uint64_t clocks = 0;
  std::vector<std::uint16_t> words;
};

bool read_job(Job& job) {
  std::size_t count = 0;
  if (!(std::cin >> job.name >> job.seed >> job.events >> job.clocks >> count)) return false;
  job.words.assign(count, 0);
  for (auto& word : job.words) {
    unsigned value = 0;
    std::cin >> std::hex >> value >> std::dec;
    word = static_cast<std::uint16_t>(value);
  }
  return static_cast<bool>(std::cin);
}

class Machine {
 public:
  Machine() {
    model_.clk_i = 0;
    model_.eval();
  }

  // The ROM's other words are a jump to themselves each: what runs out of its program stands still.
  void program(const std::vector<std::uint16_t>& words) {
    model_.rst_ni = 0;
    model_.test_write_i = 1;
    for (unsigned i = 0; i < ROM_WORDS; ++i) {
      model_.test_addr_i = i;
      model_.test_data_i = i < words.size() ? words[i] : 0xC000U | i;
      clock();
    }
    model_.test_write_i = 0;
    model_.rst_ni = 1;
  }

  // False: the bus was read and written at once, or the clocks were too few.
  bool run(const Job& job) {
    std::uint32_t noise = job.seed;
    unsigned event = 0;
    for (std::uint64_t clocks = 0; clocks < job.clocks && event < job.events; ++clocks) {
      model_.eval();
      if (model_.mem_read_o && model_.mem_write_o) {
        fmt::print(stderr, "{}: read and write in one clock\n", job.name);
        return false;
      }
      const unsigned address = model_.mem_addr_o;
      // What is not asked for is noise.
      std::uint16_t answer = static_cast<std::uint16_t>(noise = rung_mix(noise + 1));
      if (model_.mem_read_o) {
        answer = rung_bus_value(job.seed, event++, static_cast<std::uint16_t>(address));
        fmt::print("r {:x} {:x}\n", address, answer);
      } else if (model_.mem_write_o) {
        ++event;
        fmt::print("w {:x} {:x}\n", address, unsigned{model_.mem_wdata_o});
      }
      clock();
      model_.mem_rdata_i = answer;
    }
    if (event < job.events) {
      fmt::print(stderr, "{}: {} events in {} clocks, {} are wanted\n", job.name, event, job.clocks,
                 job.events);
    }
    return event == job.events;
  }

 private:
  void clock() {
    model_.clk_i = 1;
    model_.eval();
    model_.clk_i = 0;
    model_.eval();
  }

  Vmicro model_;
};

}  // namespace

int main() {
  const auto machine = std::make_unique<Machine>();
  bool good = true;
  for (Job job; read_job(job);) {
    fmt::print("{}\n", job.name);
    machine->program(job.words);
    good = machine->run(job) && good;
  }
  return good ? 0 : 1;
}
