// SPDX-License-Identifier: Apache-2.0
// A unit: the Verilated link, and around it the pool and what the scheduler does at its borders
// (hdl/flow/README.md), at random speed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "harness/clocked.hpp"
#include "link/world.hpp"

namespace rung::tb {

struct Pace {
  std::uint64_t least = 10, most = 200;  // clocks that an event command takes
  std::uint64_t longer_every = 0;        // one in so many is suspended,
  std::uint64_t longer = 0;              // for so many clocks more
  std::uint64_t pool_busy = 4;           // the pool is not ready in one of so many clocks
  bool serves = true;                    // blocks for event commands are offered
};

template <typename Dut>
class LinkUnit {
 public:
  LinkUnit(World& world, int number, int timeout_ms)
      : world_(world), number_(number), dut_(number * 17 + 1) {
    dut_->unit_i = static_cast<std::uint8_t>(number);
    dut_->timeout_ms_i = static_cast<std::uint16_t>(timeout_ms);
    dut_->upper_rx_i = dut_->lower_rx_i = 1;
    idle();
    dut_.reset();
    forget();
  }

  Pace pace;
  Dut* operator->() { return dut_.operator->(); }
  Dut& operator*() { return *dut_.operator->(); }
  int number() const { return number_; }
  bool upper_tx() { return dut_->upper_tx_o != 0 || held_; }
  bool lower_tx() { return dut_->lower_tx_o != 0 || held_; }

  // Off: in reset, the lines are idle; what it had asked is nobody's any more.
  void hold(bool held) {
    if (held == held_) return;
    held_ = held;
    dut_->rst_ni = held ? 0 : 1;
    if (held) forget();
  }
  bool held() const { return held_; }

  // False if no block is free.
  bool ask(int to, bool write, int count) {
    if (held_ || free_.empty()) return false;
    const std::size_t turn = world_.pick(free_.size());
    const int block = free_[turn];
    free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(turn));
    const std::size_t id = world_.ask(number_, to, write, count);
    asked_[static_cast<std::size_t>(block)] = id;
    for (int i = 0; i < flow::flow_block_words; ++i) {
      word(block, i) = write && i < count ? World::word(id, i) : 0x5555;
    }
    to_ask_.push_back(block);
    return true;
  }
  std::size_t blocks_free() const { return free_.size(); }

  void clock(bool upper_rx, bool lower_rx, bool millisecond) {
    dut_->clk_i = 0;
    dut_->upper_rx_i = upper_rx ? 1 : 0;
    dut_->lower_rx_i = lower_rx ? 1 : 0;
    dut_->millisecond_i = millisecond ? 1 : 0;
    if (!held_) offer();
    dut_->eval();
    if (!held_) exchange();
    dut_->clk_i = 1;
    dut_->eval();
    dut_->mem_rdata_i = read_;
  }

 private:
  struct Event {
    int block = 0;
    bool write = false;
    std::size_t id = 0;
    int count = 0;
    std::uint8_t from = 0, tag = 0;
    std::uint64_t due = 0;
  };

  std::uint16_t& word(int block, int index) {
    return pool_.at(static_cast<std::size_t>(block * flow::flow_block_words + index));
  }

  void idle() {
    dut_->link_req_valid_i = 0;
    dut_->link_done_ready_i = 1;
    dut_->event_block_valid_i = 0;
    dut_->event_ready_i = 0;
    dut_->reply_valid_i = 0;
    dut_->mem_ready_i = 0;
    dut_->millisecond_i = 0;
  }
  void forget() {
    idle();
    free_.clear();
    for (int b = 0; b < flow::flow_task_blocks; ++b) free_.push_back(b);
    free_.push_back(flow::flow_pc_block);
    for (std::optional<std::size_t>& id : asked_) {
      if (id) world_.asked[*id].forgotten = true;
      id.reset();
    }
    to_ask_.clear();
    event_free_.clear();
    for (int b = 0; b < flow::flow_event_blocks; ++b) {
      event_free_.push_back(flow::flow_task_blocks + b);
    }
    running_.clear();
    replies_.clear();
    sending_.clear();
  }

  // Inputs of this clock.
  void offer() {
    dut_->mem_ready_i = world_.once_in(pace.pool_busy) ? 0 : 1;
    dut_->link_done_ready_i = world_.once_in(3) ? 0 : 1;
    dut_->link_req_valid_i = to_ask_.empty() ? 0 : 1;
    if (!to_ask_.empty()) {
      const int block = to_ask_.front();
      const std::size_t id = *asked_[static_cast<std::size_t>(block)];
      const Asked& a = world_.asked[id];
      dut_->link_req_block_i = static_cast<std::uint8_t>(block);
      dut_->link_req_write_i = a.write ? 1 : 0;
      dut_->link_req_unit_i = static_cast<std::uint8_t>(a.to);
      dut_->link_req_board_i = static_cast<std::uint8_t>(World::board(id));
      dut_->link_req_first_i = static_cast<std::uint16_t>(World::first(id));
      dut_->link_req_count_i = static_cast<std::uint8_t>(a.count);
    }
    dut_->event_block_valid_i = pace.serves && !event_free_.empty() ? 1 : 0;
    if (!event_free_.empty()) dut_->event_block_i = static_cast<std::uint8_t>(event_free_.front());
    dut_->event_ready_i = pace.serves && world_.once_in(2) ? 1 : 0;
    execute();
    dut_->reply_valid_i = replies_.empty() ? 0 : 1;
    if (!replies_.empty()) {
      const Event& e = replies_.front();
      const bool refused = World::refused(e.id);
      dut_->reply_block_i = static_cast<std::uint8_t>(e.block);
      dut_->reply_write_i = e.write ? 1 : 0;
      dut_->reply_status_i =
          static_cast<std::uint8_t>(refused ? flow::flow_status_refused : flow::flow_status_done);
      dut_->reply_count_i = static_cast<std::uint8_t>(e.count);
      dut_->reply_to_i = e.from;
      dut_->reply_tag_i = e.tag;
    }
  }

  void execute() {
    for (auto e = running_.begin(); e != running_.end();) {
      if (e->due > world_.now) {
        ++e;
        continue;
      }
      world_.executed(number_, e->from, e->write, e->id, e->count, &word(e->block, 0));
      for (int i = 0; !e->write && i < e->count; ++i) word(e->block, i) = World::word(e->id, i);
      replies_.push_back(*e);
      e = running_.erase(e);
    }
  }

  // What happens in this clock.
  void exchange() {
    if (dut_->link_req_valid_i != 0 && dut_->link_req_ready_o != 0) to_ask_.pop_front();
    if (dut_->mem_valid_o != 0 && dut_->mem_ready_i != 0) {
      ASSERT_LT(dut_->mem_addr_o, pool_.size());
      if (dut_->mem_write_o != 0) {
        const int block = dut_->mem_addr_o / flow::flow_block_words;
        const bool event = !event_free_.empty() && block == event_free_.front();
        EXPECT_TRUE(event || asked_.at(static_cast<std::size_t>(block)))
            << "a free block " << block;
        pool_.at(dut_->mem_addr_o) = dut_->mem_wdata_o;
      } else {
        read_ = pool_.at(dut_->mem_addr_o);
      }
    }
    if (dut_->event_valid_o != 0 && dut_->event_ready_i != 0) take_event();
    if (dut_->reply_valid_i != 0 && dut_->reply_ready_o != 0) {
      sending_.push_back(replies_.front().block);
      replies_.pop_front();
    }
    if (dut_->reply_done_valid_o != 0) {
      const auto at = std::find(sending_.begin(), sending_.end(), dut_->reply_done_block_o);
      ASSERT_NE(at, sending_.end()) << "a reply that was not given is done";
      event_free_.push_back(*at);
      sending_.erase(at);
    }
    if (dut_->link_done_valid_o != 0 && dut_->link_done_ready_i != 0) {
      const int block = dut_->link_done_block_o;
      std::optional<std::size_t>& id = asked_.at(static_cast<std::size_t>(block));
      ASSERT_TRUE(id) << "block " << block << " is complete, and asked nothing";
      world_.completed(*id, dut_->link_done_status_o, &word(block, 0));
      id.reset();
      free_.push_back(block);
    }
  }

  void take_event() {
    ASSERT_FALSE(event_free_.empty());
    Event e;
    e.block = event_free_.front();
    event_free_.pop_front();
    e.write = dut_->event_write_o != 0;
    e.id = static_cast<std::size_t>(dut_->event_board_o << 16 | dut_->event_first_o);
    e.count = dut_->event_count_o;
    e.from = dut_->event_from_o;
    e.tag = dut_->event_tag_o;
    e.due = world_.now + pace.least + world_.pick(pace.most - pace.least + 1);
    if (world_.once_in(pace.longer_every)) e.due += pace.longer;
    running_.push_back(e);
  }

  World& world_;
  int number_;
  Clocked<Dut> dut_;
  bool held_ = false;
  std::array<std::uint16_t, (flow::flow_pc_block + 1) * flow::flow_block_words> pool_{};
  std::uint16_t read_ = 0;
  std::vector<int> free_;
  std::array<std::optional<std::size_t>, flow::flow_pc_block + 1> asked_;
  std::deque<int> to_ask_;
  std::deque<int> event_free_;
  std::vector<Event> running_;
  std::deque<Event> replies_;
  std::vector<int> sending_;
};

}  // namespace rung::tb
