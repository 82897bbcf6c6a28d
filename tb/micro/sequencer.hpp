// SPDX-License-Identifier: Apache-2.0
// The Verilated micro-sequencer with a program of the test's, and the accesses to its bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class Vmicro;

namespace rung::tb {

struct Access {
  bool write;
  std::uint16_t address;
  std::uint16_t value;
  bool operator==(const Access&) const = default;
};

// What the k-th access reads at an address.
inline std::uint16_t input(std::size_t k, std::uint16_t address) {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(k) * 2654435761U) ^ (address * 40503U);
  return (mixed >> 28U) < 4 ? static_cast<std::uint16_t>(mixed >> 8U & 7U)
                            : static_cast<std::uint16_t>(mixed >> 8U);
}

class Sequencer {
 public:
  Sequencer();
  ~Sequencer();
  Sequencer(const Sequencer&) = delete;
  Sequencer& operator=(const Sequencer&) = delete;

  // The accesses of a program from reset on, until there are `count` or the clocks are over.
  std::vector<Access> run(const std::vector<std::uint16_t>& words, std::size_t count,
                          std::uint64_t clocks = 200000);

 private:
  void clock();
  std::unique_ptr<Vmicro> model_;
};

}  // namespace rung::tb
