// SPDX-License-Identifier: Apache-2.0
// Random choices that are the same with every standard library: the standard fixes the numbers of
// std::mt19937_64, but not those of its distributions.
#pragma once

#include <cstdint>
#include <numeric>
#include <random>
#include <span>

namespace rung {

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  // All 64 bits.
  std::uint64_t bits() { return engine_(); }
  // 0 to bound - 1; bound is at least 1. Its bias is below bound / 2^64.
  int below(int bound) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(bound)); }
  // 1 of `hundred` times out of 100.
  bool percent(int hundred) { return below(100) < hundred; }
  // An index of `weights`, each as often as its weight says; their sum is at least 1.
  std::size_t weighted(std::span<const int> weights) {
    int left = below(std::accumulate(weights.begin(), weights.end(), 0));
    std::size_t index = 0;
    while (left >= weights[index]) left -= weights[index++];
    return index;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rung
