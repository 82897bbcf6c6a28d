// SPDX-License-Identifier: Apache-2.0
// A machine or a street that a controller controls, as its pins see it: outputs go in, inputs come
// out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rung::tb {

class Plant {
 public:
  virtual ~Plant() = default;

  virtual std::string name() const = 0;
  // The ladder program's file under the repository, and its I/O map: input pin n is the n-th of
  // inputs(), output pin n the n-th of outputs().
  virtual std::string program() const = 0;
  virtual std::vector<std::string> inputs() const = 0;
  virtual std::vector<std::string> outputs() const = 0;

  // `ms` milliseconds pass with the outputs as they are; gives the inputs after them.
  virtual std::uint64_t step(std::uint64_t outputs, int ms) = 0;
  // What has happened that must not; empty if all is well.
  virtual std::string accident() const = 0;
  // How much work has been done, for a report: "214 parts, 107 of them tall".
  virtual std::string work() const = 0;
  // Whether enough of everything has happened for the time that has passed.
  virtual bool busy() const = 0;
};

// Pedestrians at a crossing (programs/crossing.il); now and then it is taken out of service.
std::unique_ptr<Plant> make_crossing(std::uint64_t seed);
// A conveyor that sorts parts by height (programs/sorter.il), with an operator
// who starts, stops and acknowledges, and now and then an emergency stop.
std::unique_ptr<Plant> make_conveyor(std::uint64_t seed);

}  // namespace rung::tb
