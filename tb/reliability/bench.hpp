// SPDX-License-Identifier: Apache-2.0
// What the reliability tests share: programs made as `rung compile` makes them, a client at the
// byte line of a simulated controller, counts for the report.
//
// RUNG_RELIABILITY=full runs the full counts, RUNG_SEED=N begins at another seed; every random test
// prints its seed.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/simulated_controller.hpp"
#include "image/image.hpp"
#include "io/bind.hpp"
#include "load/latency.hpp"

namespace rung::tb {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

struct Made {
  Words words;
  image::Image image;
  io::Bindings bindings;
  load::Timing timing;
};
// A list and an I/O map that must be good, for the clock of the simulated controller.
Made make_program(const std::string& list, const std::string& map);
// A list of tb/golden/programs
std::string golden(const std::string& name);
// Sets a word of a load file's space; false: the file does not set it.
bool patch(Words& file, int space, std::uint32_t address, std::uint16_t value);
// The silence that ends a frame, far shorter than a client of a real line may have it.
void quicken(Words& file);

std::uint16_t low(std::size_t value);
std::uint16_t high(std::size_t value);
Bytes with_crc(Bytes frame);
Bytes pdu(int function, const Words& words);

// Thrown by a client when its time has come.
struct Cut {};

class Client {
 public:
  explicit Client(SimulatedController& controller) : controller_(controller) {}

  // Sends bytes as they are, and waits for what comes until the line has been silent again for
  // long, or `patience` clocks for the first byte.
  Bytes send(const Bytes& frame, std::uint64_t patience);
  // A request's PDU and its answer's; nothing when there is none that is right.
  std::optional<Bytes> ask(const Bytes& pdu);

  // Throw std::runtime_error without an answer.
  Words read(int address, int count = 1);
  int holding(int address) { return read(address).at(0); }
  std::uint32_t holding_long(int address);
  int write(int address, const Words& values);  // 0 or the exception
  void command(int value);                      // must be accepted

  // A download, step by step.
  int begin(const Words& file, std::uint32_t crc);
  int window(const Words& file, std::size_t at,
             std::size_t offset);  // words from `at`, to `offset`
  int windows(const Words& file);
  int commit();  // the load_state it ends with, or the exception negative
  int download(const Words& file);

  // The clock at which it throws Cut.
  std::optional<std::uint64_t> cut_at;
  std::uint64_t patience = 4'000'000;
  int unit = 1;
  std::uint64_t gap = kGap;

  static constexpr std::uint64_t kGap = 600;  // of the line after a reset: 3.5 characters, and some

 private:
  void run(std::uint64_t clocks);
  SimulatedController& controller_;
};

bool full();  // full counts
std::uint64_t count(std::uint64_t sample, std::uint64_t all);
std::uint64_t base_seed();
// For the report: a number or text under the running test's name.
void note(const std::string& key, const std::string& value);
void note(const std::string& key, std::uint64_t value);

// A controller with a flash that is quick where its times do not matter.
std::unique_ptr<SimulatedController> make_controller(const std::string& board, std::uint64_t seed,
                                                     bool quick_flash = true);
// Downloads the first program into an empty controller.
void install(SimulatedController& controller, Client& client, const Words& file);
// Runs until a condition holds; false: it did not within so many clocks.
bool run_until(SimulatedController& controller, const std::function<bool()>& condition,
               std::uint64_t clocks, std::uint64_t step = 1000);

}  // namespace rung::tb
