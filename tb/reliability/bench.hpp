// SPDX-License-Identifier: Apache-2.0
// What the reliability tests share, and their counts for the report.
//
// RUNG_RELIABILITY=full runs the full counts, RUNG_SEED=N begins at another seed; every random test
// prints its seed.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "controller/simulated_controller.hpp"
#include "reliability/client.hpp"
#include "reliability/program.hpp"

namespace rung::tb {

// A list of tb/golden/programs
std::string golden(const std::string& name);

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
