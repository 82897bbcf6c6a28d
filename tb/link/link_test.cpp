// SPDX-License-Identifier: Apache-2.0
// Chains of units, with and without faults. Every request is complete once, with the right words if
// it is done; every command is executed at most once, and was if its answer came: World and
// LinkUnit check that throughout.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>

#include "Vlink.h"
#include "Vlink_16.h"
#include "link/link_chain.hpp"

namespace rung::tb {
namespace {

TEST(Link, LatencyInBitTimes) {
  World world(1);
  LinkChain<Vlink_16> chain(world, {4, 16, 100000, 100});
  for (const auto& u : chain.units) u->pace = {1, 1, 0, 0, 0, true};
  chain.steps(16 * 400);  // the hops begin
  struct Case {
    int to;
    bool write;
    int count;
  };
  for (const Case& c : {Case{2, false, 1}, Case{2, false, 32}, Case{2, true, 32}, Case{4, false, 1},
                        Case{4, false, 32}, Case{4, true, 32}}) {
    std::uint64_t most = 0;
    for (int i = 0; i < 2; ++i) {
      chain.steps(16 * 100 + world.pick(1000));
      most = std::max(most, chain.alone(1, c.to, c.write, c.count));
    }
    const auto hops = static_cast<std::uint64_t>(c.to - 1);
    const double bits = static_cast<double>(most) / 16;
    std::cout << (c.write ? "write " : "read ") << c.count << " words, " << hops
              << " hop(s): " << bits << " bit times\n";
    // Both frames, 11 bytes without words, and what a unit takes between them.
    const std::uint64_t frames = hops * 10 * static_cast<std::uint64_t>(22 + 2 * c.count);
    EXPECT_LE(bits, static_cast<double>(frames + hops * 2 * 20 + 60));
    RecordProperty("bits_to_" + std::to_string(c.to), std::to_string(bits));
  }
  EXPECT_EQ(chain.bad() + chain.again() + chain.lost() + chain.late(), 0U);
}

class CleanLines : public testing::TestWithParam<int> {};

// Everybody asks as fast as blocks become free, commands take long: all buffers are full in both
// directions.
TEST_P(CleanLines, NothingFailsHoweverFullTheyAre) {
  const std::uint64_t seed = link_seed(11);
  SCOPED_TRACE(replay(seed));
  World world(seed);
  LinkChain<Vlink> chain(world, {GetParam(), 6, 3000, 2000});
  for (const auto& u : chain.units) u->pace = {20000, 60000, 5, 60000, 4, true};
  chain.traffic(200000, 300);
  EXPECT_GT(chain.full(), 0U) << "rings never full";
  chain.finish(1500000);
  EXPECT_EQ(world.with_status(flow::flow_status_no_reply), 0U);
  EXPECT_GT(world.asked.size(), 60U);
  EXPECT_EQ(chain.bad() + chain.lost() + chain.late(), 0U);
  std::cout << world.asked.size() << " requests, " << chain.full() << " times full\n";
}
INSTANTIATE_TEST_SUITE_P(Units, CleanLines, testing::Values(2, 4));

class DisturbedLines : public testing::TestWithParam<int> {};

TEST_P(DisturbedLines, NothingIsDoubledAndLittleFails) {
  const std::uint64_t seed = link_seed(21);
  SCOPED_TRACE(replay(seed));
  World world(seed);
  LinkChain<Vlink> chain(world, {GetParam(), 6, 3000, 100});
  chain.traffic(GetParam() == 2 ? 400000 : 250000, 3000, 8000);
  chain.steps(40000);  // the last fault has passed, sides that were down begin again
  const std::uint64_t gone = world.with_status(flow::flow_status_no_reply);
  chain.traffic(60000, 3000);
  chain.finish(1000000);
  EXPECT_GT(chain.bad(), 30U);
  EXPECT_GT(chain.again(), 20U);
  // Lines as bad as these: some. After them: none but those that were still under way.
  EXPECT_LT(world.with_status(flow::flow_status_no_reply), world.asked.size() / 4);
  EXPECT_LT(world.with_status(flow::flow_status_no_reply) - gone, 40U);
  std::cout << world.asked.size() << " requests, " << world.with_status(flow::flow_status_no_reply)
            << " without answer; frames bad " << chain.bad() << ", again " << chain.again()
            << ", lost " << chain.lost() << ", late " << chain.late() << '\n';
}
INSTANTIATE_TEST_SUITE_P(Units, DisturbedLines, testing::Values(2, 4));

TEST(Link, UnitsThatRestartDoNotStopTheOthersForLong) {
  const std::uint64_t seed = link_seed(31);
  SCOPED_TRACE(replay(seed));
  World world(seed);
  LinkChain<Vlink> chain(world, {4, 6, 3000, 50});
  chain.traffic(250000, 3000, 40000, 30000);
  chain.steps(40000);
  const std::size_t before = world.asked.size();
  chain.steps(120000);  // what was lost is complete
  chain.traffic(60000, 3000);
  chain.finish(1000000);
  for (std::size_t id = before; id < world.asked.size(); ++id) {
    EXPECT_NE(world.asked[id].status, flow::flow_status_no_reply) << id;
  }
  std::cout << world.asked.size() << " requests, " << world.with_status(flow::flow_status_no_reply)
            << " without answer, lost " << chain.lost() << ", late " << chain.late() << '\n';
}

class DeadUnit : public testing::TestWithParam<int> {};

// Unit 4 dies (3 in the other case); the others go on asking it and each other.
TEST_P(DeadUnit, CostsItsPartnersTheirTimeoutsAndNobodyElseAnything) {
  const std::uint64_t seed = link_seed(41);
  SCOPED_TRACE(replay(seed));
  const int dead = GetParam();
  World world(seed);
  LinkChain<Vlink> chain(world, {4, 6, 3000, 30});
  chain.traffic(50000, 4000);
  chain.finish(200000);
  EXPECT_EQ(world.with_status(flow::flow_status_no_reply), 0U);
  chain.unit(dead).hold(true);
  const std::size_t from = world.asked.size();
  const std::uint64_t dead_at = world.now;
  const std::uint64_t end = world.now + 250000;
  while (world.now < end) {
    for (int n = 1; n < dead; ++n) {
      // Four at a time to the dead one, so that its timeouts, not the lines, are what counts.
      LinkUnit<Vlink>& u = chain.unit(n);
      if (u.blocks_free() > 13 && world.once_in(500))
        u.ask(dead, world.once_in(2), 1 + static_cast<int>(world.pick(32)));
      if (world.once_in(6000)) u.ask(n == 1 ? 2 : n - 1, world.once_in(2), 4);
    }
    chain.step();
  }
  chain.finish(200000);
  std::uint64_t at_first = 0, slowest = 0;
  std::size_t to_dead = 0;
  for (std::size_t id = from; id < world.asked.size(); ++id) {
    const Asked& a = world.asked[id];
    const std::uint64_t took = a.completed_at - a.asked_at;
    if (a.to == dead) {
      ++to_dead;
      EXPECT_EQ(a.status, flow::flow_status_no_reply);
      EXPECT_LE(took, 32U * 3000U + 6000U);  // a timeout, a begun millisecond, a frame
    } else {
      EXPECT_NE(a.status, flow::flow_status_no_reply) << id << ": " << a.from << " to " << a.to;
      std::uint64_t& most = a.asked_at < dead_at + 60000 ? at_first : slowest;
      most = std::max(most, took);
    }
  }
  EXPECT_GT(to_dead, 20U);
  std::cout << to_dead << " requests to the dead unit; the others' slowest took " << at_first / 6
            << " bit times until that was found, then " << slowest / 6 << '\n';
  EXPECT_LT(at_first / 6, 12000U);
  EXPECT_LT(slowest / 6, 5000U);
  // And it comes back.
  chain.unit(dead).hold(false);
  chain.steps(40000);
  for (int n = 1; n <= 4; ++n) {
    if (n != dead) chain.alone(n, dead, true, 3);
  }
}
INSTANTIATE_TEST_SUITE_P(Units, DeadUnit, testing::Values(3, 4));

TEST(Link, AFullRingLosesNothing) {
  World world(51);
  LinkChain<Vlink> chain(world, {3, 6, 3000, 200});
  chain.steps(2000);
  chain.unit(2).pace.serves = false;
  for (int i = 0; i < 17; ++i) {
    EXPECT_TRUE(chain.unit(1).ask(2, i % 2 == 0, 1 + i));
    EXPECT_TRUE(chain.unit(3).ask(2, i % 2 == 1, 32 - i));
  }
  chain.steps(200000);
  EXPECT_GT(chain.unit(2)->upper_full_o, 5);
  EXPECT_GT(chain.unit(2)->lower_full_o, 5);
  EXPECT_EQ(chain.world.open(), 34U);
  chain.unit(2).pace.serves = true;
  chain.finish(200000);
  EXPECT_EQ(world.with_status(flow::flow_status_no_reply), 0U);
  EXPECT_EQ(chain.lost(), 0U);
}

TEST(Link, AUnitWhoseSchedulerHangsStillLetsOthersThrough) {
  World world(52);
  LinkChain<Vlink> chain(world, {3, 6, 3000, 20});
  chain.steps(2000);
  chain.unit(2).pace.serves = false;
  std::size_t through = 0;
  std::size_t first_timeout = 0;
  for (int i = 0; i < 48; ++i) {
    while (chain.unit(1).blocks_free() > 4) chain.unit(1).ask(2, true, 4);
    chain.steps(4000);
    if (i == 24) first_timeout = world.asked.size();
    if (i % 4 == 0) {
      chain.unit(1).ask(3, true, 5);
      chain.unit(3).ask(1, false, 5);
    }
  }
  chain.unit(2).pace.serves = true;
  chain.finish(200000);
  for (std::size_t id = first_timeout; id < world.asked.size(); ++id) {
    const Asked& a = world.asked[id];
    if (a.to == 2) continue;
    EXPECT_NE(a.status, flow::flow_status_no_reply) << id;
    ++through;
  }
  EXPECT_GT(through, 8U);
  EXPECT_GT(chain.unit(2)->late_o, 20);  // commands that it dropped
  chain.alone(1, 2, false, 7);
}

TEST(Link, LateAnswersAreCountedAndNobodysAnyMore) {
  const std::uint64_t seed = link_seed(61);
  SCOPED_TRACE(replay(seed));
  World world(seed);
  LinkChain<Vlink> chain(world, {2, 6, 3000, 5});
  // Half of the commands take longer than the timeout, so that answers meet later requests of the
  // same block.
  for (const auto& u : chain.units) u->pace = {10, 300, 2, 11000, 4, true};
  chain.traffic(250000, 800);
  chain.finish(100000);
  chain.steps(40000);
  EXPECT_GT(chain.late(), 40U);
  std::size_t executed = 0;
  for (const Asked& a : world.asked) {
    executed += a.executions != 0 && a.status == flow::flow_status_no_reply ? 1 : 0;
  }
  // Each of them, and commands that were dropped because all blocks were taken.
  EXPECT_GE(chain.late(), executed);
  std::cout << world.asked.size() << " requests, " << chain.late() << " late\n";
}

TEST(Link, WhatNobodyCanBeAskedIsRefusedAtOnce) {
  World world(71);
  LinkChain<Vlink> chain(world, {2, 6, 3000, 50});
  chain.steps(2000);
  struct Case {
    int to, count;
  };
  for (const Case& c :
       {Case{1, 3}, Case{0, 3}, Case{16, 3}, Case{200, 3}, Case{2, 0}, Case{2, 33}}) {
    ASSERT_TRUE(chain.unit(1).ask(c.to, false, c.count));
    world.asked.back().impossible = true;
    chain.steps(500);
    EXPECT_EQ(world.asked.back().status, flow::flow_status_refused) << c.to << ' ' << c.count;
  }
  chain.alone(1, 2, true, 32);
}

// 5 is no unit of the chain: the end drops what goes there.
TEST(Link, AUnitThatIsNotThereCostsItsTimeout) {
  World world(72);
  LinkChain<Vlink> chain(world, {3, 6, 3000, 20});
  chain.steps(40000);
  for (int i = 0; i < 10; ++i) {
    chain.unit(1).ask(5, true, 4);
    chain.unit(3).ask(5, true, 4);
    EXPECT_LT(chain.alone(1, 3, false, 4), 9000U);
  }
  chain.finish(100000);
  EXPECT_EQ(world.with_status(flow::flow_status_no_reply), 20U);
  EXPECT_EQ(chain.unit(3)->lower_lost_o, 10);
}

}  // namespace
}  // namespace rung::tb
