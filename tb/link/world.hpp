// SPDX-License-Identifier: Apache-2.0
// What the units of a simulated link ask of each other, and what became of it. A request is known
// by its board and first variable, which no other has; its words, and whether it is refused, follow
// from that, so that everybody can check what comes.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "rung_flow.hpp"

namespace rung::tb {

struct Asked {
  int from = 0, to = 0;
  bool write = false;
  int count = 1;
  std::uint64_t asked_at = 0;
  std::uint64_t completed_at = 0;
  int executions = 0;
  int completions = 0;
  int status = -1;
  bool forgotten = false;   // its requester was reset
  bool impossible = false;  // nobody can answer that
};

class World {
 public:
  explicit World(std::uint64_t seed) : random_(seed) {}

  std::uint64_t now = 0;  // clocks
  std::vector<Asked> asked;

  std::size_t ask(int from, int to, bool write, int count) {
    Asked a;
    a.from = from;
    a.to = to;
    a.write = write;
    a.count = count;
    a.asked_at = now;
    asked.push_back(a);
    return asked.size() - 1;
  }
  // One of n numbers from 0 on; true once in n times.
  // SplitMix64: some draws are needed in every clock.
  std::uint64_t pick(std::uint64_t n) {
    std::uint64_t x = random_ += 0x9e3779b97f4a7c15ULL;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ x >> 27) * 0x94d049bb133111ebULL;
    return ((x ^ x >> 31) >> 32) * n >> 32;
  }
  bool once_in(std::uint64_t n) { return n != 0 && pick(n) == 0; }

  static std::uint16_t word(std::size_t id, int index) {
    std::uint64_t x =
        (static_cast<std::uint64_t>(id) * 64 + static_cast<std::uint64_t>(index) + 1) *
        0x9e3779b97f4a7c15ULL;
    x ^= x >> 31;
    return static_cast<std::uint16_t>(x * 0xbf58476d1ce4e5b9ULL >> 40);
  }
  static bool refused(std::size_t id) { return word(id, 40) % 16 == 0; }
  static int board(std::size_t id) { return static_cast<int>(id >> 16 & 0xff); }
  static int first(std::size_t id) { return static_cast<int>(id & 0xffff); }

  // A unit got an event command; its words if it writes.
  void executed(int unit, int from, bool write, std::size_t id, int count,
                const std::uint16_t* words) {
    ASSERT_LT(id, asked.size()) << "a command that nobody gave, at unit " << unit;
    Asked& a = asked[id];
    EXPECT_EQ(a.to, unit) << id;
    EXPECT_EQ(a.from, from) << id;
    EXPECT_EQ(a.write, write) << id;
    EXPECT_EQ(a.count, count) << id;
    EXPECT_EQ(++a.executions, 1) << id << " executed again";
    for (int i = 0; write && i < count; ++i) EXPECT_EQ(words[i], word(id, i)) << id << ' ' << i;
  }
  void completed(std::size_t id, int status, const std::uint16_t* words) {
    Asked& a = asked[id];
    EXPECT_EQ(++a.completions, 1) << id << " complete again";
    a.status = status;
    a.completed_at = now;
    if (status == flow::flow_status_no_reply) return;
    if (a.impossible) {
      EXPECT_EQ(a.executions, 0) << id;
      EXPECT_EQ(status, flow::flow_status_refused) << id;
      return;
    }
    EXPECT_EQ(a.executions, 1) << id << " has an answer, status " << status;
    EXPECT_EQ(status, refused(id) ? flow::flow_status_refused : flow::flow_status_done) << id;
    for (int i = 0; status == flow::flow_status_done && !a.write && i < a.count; ++i) {
      EXPECT_EQ(words[i], word(id, i)) << id << ' ' << i;
    }
  }
  std::size_t open() const {
    std::size_t n = 0;
    for (const Asked& a : asked) n += a.completions == 0 && !a.forgotten ? 1 : 0;
    return n;
  }
  std::size_t with_status(int status) const {
    std::size_t n = 0;
    for (const Asked& a : asked) n += a.status == status ? 1 : 0;
    return n;
  }

 private:
  std::uint64_t random_;
};

// RUNG_LINK_SEED, else `otherwise`.
inline std::uint64_t link_seed(std::uint64_t otherwise) {
  const char* given = std::getenv("RUNG_LINK_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 0) : otherwise;
}
// To be printed with a failure.
inline std::string replay(std::uint64_t seed) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return "seed " + std::to_string(seed) + "; again: RUNG_LINK_SEED=" + std::to_string(seed) +
         " unit_link --gtest_filter=" + info->test_suite_name() + "." + info->name();
}

}  // namespace rung::tb
