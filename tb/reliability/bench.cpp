// SPDX-License-Identifier: Apache-2.0
#include "reliability/bench.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace rung::tb {
std::string golden(const std::string& name) {
  std::ifstream in(std::string(RUNG_REPOSITORY) + "/tb/golden/programs/" + name);
  if (!in) throw std::runtime_error(name + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool full() {
  const char* const value = std::getenv("RUNG_RELIABILITY");
  return value != nullptr && std::string(value) == "full";
}

std::uint64_t count(std::uint64_t sample, std::uint64_t all) { return full() ? all : sample; }

std::uint64_t base_seed() {
  const char* const value = std::getenv("RUNG_SEED");
  const std::uint64_t seed = value != nullptr ? std::strtoull(value, nullptr, 10) : 1;
  fmt::print("seed {0}; replay: {1}RUNG_SEED={0} reliability --gtest_filter={2}.{3}\n", seed,
             full() ? "RUNG_RELIABILITY=full " : "",
             testing::UnitTest::GetInstance()->current_test_info()->test_suite_name(),
             testing::UnitTest::GetInstance()->current_test_info()->name());
  return seed;
}

void note(const std::string& key, const std::string& value) {
  fmt::print("{}: {}\n", key, value);
  testing::Test::RecordProperty(key, value);
}
void note(const std::string& key, std::uint64_t value) { note(key, std::to_string(value)); }

std::unique_ptr<SimulatedController> make_controller(const std::string& board, std::uint64_t seed,
                                                     bool quick_flash) {
  ControllerSetup setup;
  setup.board = board;
  setup.line = ControllerSetup::Line::Bytes;
  setup.seed = seed;
  if (quick_flash) {
    setup.flash_times =
        FlashTimes{.page_program = 200, .sector_erase = 500, .block_erase = 1000, .wake = 1};
  }
  return SimulatedController::make(setup);
}

void install(SimulatedController& controller, Client& client, const Words& file) {
  static_cast<void>(controller);
  const int state = client.download(file);
  if (state != 2) throw std::runtime_error(fmt::format("installing: load_state {}", state));
}

bool run_until(SimulatedController& controller, const std::function<bool()>& condition,
               std::uint64_t clocks, std::uint64_t step) {
  for (std::uint64_t i = 0; i < clocks; i += step) {
    if (condition()) return true;
    controller.run(step);
  }
  return condition();
}

}  // namespace rung::tb
