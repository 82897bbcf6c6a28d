// SPDX-License-Identifier: Apache-2.0
// A Modbus client that asks again as soon as it has its answer, and knows what the answer may be:
// the devices as the reference had them after one of the scans between request and reply.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/simulated_controller.hpp"
#include "reference/reference.hpp"

namespace rung::tb {

struct PlantResult;

class Poller {
 public:
  // Both must outlive this. `reference` has run the scan that is under way.
  Poller(SimulatedController& machine, const Reference& reference);

  // The next scan begins, and `reference` has run it.
  void scanned();
  // Takes what has come, and asks the next thing.
  void look();

  std::int64_t replies() const { return replies_; }
  // The first reply that was none of those that it might be.
  const std::string& difference() const { return difference_; }
  // Asks for the controller's own counts of scans and requests.
  void read_statistics(PlantResult& result);

 private:
  struct Question {
    std::uint8_t function;
    std::uint16_t first, count;
    std::vector<Device> devices;  // of its points
  };
  using Values = std::vector<std::int16_t>;

  void send(std::vector<std::uint8_t> bytes);
  Values values() const;
  std::vector<std::uint8_t> expected(const Question& question, const Values& values) const;
  void check(const std::vector<std::uint8_t>& reply);

  SimulatedController& machine_;
  const Reference& reference_;
  std::vector<Question> questions_;
  std::size_t now_ = 0;  // the one that was asked
  bool waiting_ = false;
  std::uint64_t asked_at_ = 0;
  std::vector<std::uint8_t> heard_;
  // What its devices were after each scan from the one in which it was asked to the one under way.
  std::vector<Values> scans_;
  std::int64_t replies_ = 0;
  std::string difference_;
};

}  // namespace rung::tb
