// SPDX-License-Identifier: Apache-2.0
// Units in a chain, 1 the upper end, and the lines between them, which can be cut, inverted and
// disturbed. Each unit has a clock a little different from the others': some are left out.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "link/link_unit.hpp"
#include "link/world.hpp"

namespace rung::tb {

// One direction of a line.
class Line {
 public:
  enum class Fault : std::uint8_t { none, invert, low, high, noise };
  void disturb(Fault fault, std::uint64_t until) {
    fault_ = fault;
    until_ = until;
  }
  // These levels instead of what is sent, a clock each.
  void play(const std::deque<bool>& levels) {
    played_.insert(played_.end(), levels.begin(), levels.end());
  }
  bool playing() const { return !played_.empty(); }
  bool through(bool level, World& world) {
    if (!played_.empty()) {
      level = played_.front();
      played_.pop_front();
    }
    if (fault_ != Fault::none && world.now >= until_) fault_ = Fault::none;
    switch (fault_) {
      case Fault::invert:
        return !level;
      case Fault::low:
        return false;
      case Fault::high:
        return true;
      case Fault::noise:
        if (world.once_in(5)) noise_ = !noise_;
        return noise_;
      case Fault::none:
        break;
    }
    return level;
  }

 private:
  Fault fault_ = Fault::none;
  std::uint64_t until_ = 0;
  bool noise_ = true;
  std::deque<bool> played_;
};

template <typename Dut>
class LinkChain {
 public:
  struct Options {
    int units = 2;
    int divisor = 6;
    std::uint64_t clocks_per_ms = 2000;
    int timeout_ms = 100;
  };
  LinkChain(World& world, const Options& options) : world(world), options(options) {
    for (int n = 1; n <= options.units; ++n) {
      units.push_back(std::make_unique<LinkUnit<Dut>>(world, n, options.timeout_ms));
    }
    down.resize(units.size());
    up.resize(units.size());
    down_levels_.assign(units.size() + 1, 1);  // idle at the ends
    up_levels_.assign(units.size() + 1, 1);
  }

  World& world;
  Options options;
  std::vector<std::unique_ptr<LinkUnit<Dut>>> units;
  // Element i: between units i + 1 and i + 2, away from unit 1 and towards it.
  std::vector<Line> down, up;

  LinkUnit<Dut>& unit(int number) { return *units.at(static_cast<std::size_t>(number - 1)); }

  void step() {
    const std::size_t n = units.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
      down_levels_[i + 1] = down[i].through(units[i]->lower_tx(), world) ? 1 : 0;
      up_levels_[i + 1] = up[i].through(units[i + 1]->upper_tx(), world) ? 1 : 0;
    }
    const bool millisecond = world.now % options.clocks_per_ms == 0;
    for (std::size_t i = 0; i < n; ++i) {
      // Some hundred parts in a million slower than the first.
      if (i != 0 && !millisecond && world.now % (4001 - 500 * i) == 7 * i) continue;
      units[i]->clock(down_levels_[i] != 0, up_levels_[i + 1] != 0, millisecond);
    }
    ++world.now;
  }
  void steps(std::uint64_t n) {
    for (std::uint64_t i = 0; i < n; ++i) step();
  }
  bool playing() const {
    const auto plays = [](const Line& line) { return line.playing(); };
    return std::any_of(down.begin(), down.end(), plays) || std::any_of(up.begin(), up.end(), plays);
  }
  // Until everything asked is complete; the limit is an error.
  void finish(std::uint64_t limit) {
    const std::uint64_t end = world.now + limit;
    while (world.open() != 0 && world.now < end) steps(50);
    EXPECT_EQ(world.open(), 0U) << "requests never complete";
  }
  // One request, alone: its clocks.
  std::uint64_t alone(int from, int to, bool write, int count) {
    EXPECT_TRUE(unit(from).ask(to, write, count));
    const std::size_t id = world.asked.size() - 1;
    while (world.asked[id].completions == 0) step();
    EXPECT_NE(world.asked[id].status, flow::flow_status_no_reply);
    return world.asked[id].completed_at - world.asked[id].asked_at;
  }

  // Requests at random, each unit to each other, one in `every` clocks and unit.
  void traffic(std::uint64_t clocks, std::uint64_t every, std::uint64_t faults_every = 0,
               std::uint64_t resets_every = 0) {
    std::vector<std::uint64_t> release(units.size());
    for (const std::uint64_t end = world.now + clocks; world.now < end;) {
      for (std::size_t i = 0; i < units.size(); ++i) {
        if (world.once_in(every)) ask_anybody(*units[i]);
        if (units[i]->held() && world.now >= release[i]) units[i]->hold(false);
        if (world.once_in(resets_every)) {
          units[i]->hold(true);
          release[i] = world.now + 10 + world.pick(world.once_in(3) ? 20000 : 200);
        }
      }
      for (std::size_t i = 0; i + 1 < units.size(); ++i) {
        if (world.once_in(faults_every)) disturb(down[i]);
        if (world.once_in(faults_every)) disturb(up[i]);
      }
      step();
    }
    for (const auto& u : units) u->hold(false);
  }

  // Sum over all units of what `counter` gives.
  template <typename Counter>
  std::uint64_t sum(Counter counter) {
    std::uint64_t all = 0;
    for (const auto& u : units) all += static_cast<std::uint64_t>(counter(*u));
    return all;
  }
  std::uint64_t bad() {
    return sum([](auto& u) { return u->upper_bad_o + u->lower_bad_o; });
  }
  std::uint64_t full() {
    return sum([](auto& u) { return u->upper_full_o + u->lower_full_o; });
  }
  std::uint64_t again() {
    return sum([](auto& u) { return u->upper_again_o + u->lower_again_o; });
  }
  std::uint64_t lost() {
    return sum([](auto& u) { return u->upper_lost_o + u->lower_lost_o; });
  }
  std::uint64_t late() {
    return sum([](auto& u) { return u->late_o; });
  }

 private:
  void ask_anybody(LinkUnit<Dut>& unit) {
    int to = 1 + static_cast<int>(world.pick(units.size() - 1));
    if (to >= unit.number()) ++to;
    const int count = world.once_in(3) ? 1 : 1 + static_cast<int>(world.pick(32));
    unit.ask(to, world.once_in(2), count);
  }
  void disturb(Line& line) {
    const auto bit = static_cast<std::uint64_t>(options.divisor);
    switch (world.pick(8)) {
      case 0:
        line.disturb(Line::Fault::noise, world.now + bit * (1 + world.pick(300)));
        break;
      case 1:
        line.disturb(Line::Fault::low, world.now + bit * (1 + world.pick(300)));
        break;
      case 2:
        line.disturb(Line::Fault::high,
                     world.now + bit * (1 + world.pick(world.once_in(4) ? 6000 : 300)));
        break;
      default:
        line.disturb(Line::Fault::invert, world.now + 1 + world.pick(2 * bit));
    }
  }

  std::vector<std::uint8_t> down_levels_, up_levels_;
};

}  // namespace rung::tb
