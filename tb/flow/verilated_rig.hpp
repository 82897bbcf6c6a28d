// SPDX-License-Identifier: Apache-2.0
// The rig over one Verilated bench top.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "flow/rig.hpp"
#include "harness/clocked.hpp"

namespace rung::tb::flow {

// One side's accesses to the pool, one after the other.
struct PoolAccess {
  bool write = false;
  int address = 0;
  std::uint16_t data = 0;
  std::function<void(std::uint16_t)> then;
};

template <typename Dut, isa::Mpu kMpu>
class VerilatedRig final : public Rig {
 public:
  VerilatedRig() : config_(*isa::find_config("hx8k")) { reset(); }

  isa::Mpu mpu() const override { return kMpu; }

  void reset() override {
    jobs_.clear();
    events_.clear();
    for (Side& side : sides_) side = Side{};
    reply_done_.clear();
    dut_->round_i = dut_->first_i = dut_->give_up_i = 0;
    dut_->load_valid_i = dut_->map_write_i = dut_->flow_write_i = 0;
    dut_->read_i = dut_->write_i = 0;
    dut_->link_done_valid_i = dut_->panel_done_valid_i = dut_->event_valid_i = 0;
    dut_->link_mem_valid_i = dut_->panel_mem_valid_i = dut_->reply_done_valid_i = 0;
    dut_->link_req_ready_i = dut_->panel_req_ready_i = 1;
    dut_->core_rst_ni = 0;
    dut_.reset();
    dut_->core_rst_ni = 1;
    tick();
  }

  void load(const Program& program) override {
    using namespace rung::flow;
    // A routine takes one step a move, in one slot after the other, or two side by side.
    std::vector<std::vector<isa::SlotInstruction>> code;
    const auto put = [&](const std::vector<Move>& moves) {
      const Move* before = nullptr;
      for (const Move& move : moves) {
        isa::SlotInstruction one;
        one.opcode = isa::Opcode::Mv;
        one.kind = move.constant ? isa::WordKind::DeviceConstant : isa::WordKind::Devices;
        one.source = move.constant ? move.value : static_cast<std::uint16_t>(move.from);
        one.rd = static_cast<std::uint16_t>(move.to);
        one.always = true;
        const bool beside = program.packed && kSlots > 1 && before != nullptr &&
                            before->to != move.to && (move.constant || move.from != before->to);
        if (beside) {
          code.back() = {code.back().front(), one};
          before = nullptr;
          continue;
        }
        const bool second = kSlots > 1 && !program.packed && code.size() % 2 != 0;
        code.push_back(second ? std::vector{isa::SlotInstruction{}, one} : std::vector{one});
        before = &move;
      }
    };
    put(program.ladder);
    const std::size_t length = code.size();
    for (std::size_t n = 0; n < program.steps.size(); ++n) {
      const Step& step = program.steps[n];
      const std::size_t entry = code.size();
      put(step.routine);
      const int at = static_cast<int>(4 * n);
      flow(space_flow_steps, at, static_cast<int>(entry));
      flow(space_flow_steps, at + 1, static_cast<int>(code.size()));
      flow(space_flow_steps, at + 2, step.before);
      flow(space_flow_steps, at + 3, step.after);
    }
    if (code.size() > static_cast<std::size_t>(config_.steps(kMpu))) {
      throw std::invalid_argument("the program is longer than the instruction memory");
    }
    for (std::size_t i = 0; i < code.size(); ++i) put_step(i, code[i]);
    space(4, 0, static_cast<std::uint16_t>(length));
    for (std::size_t n = 1; n < program.transfers.size(); ++n) {
      const Transfer& t = program.transfers[n];
      const int at = static_cast<int>(4 * n);
      flow(space_flow_transfers, at, t.unit << 8 | t.board);
      flow(space_flow_transfers, at + 1, t.first);
      flow(space_flow_transfers, at + 2, t.count);
      flow(space_flow_transfers, at + 3, t.head);
    }
    for (int n = 0; n < flow_tasks; ++n) {
      const bool known = static_cast<std::size_t>(n) < program.tasks.size();
      const Task task = known ? program.tasks[static_cast<std::size_t>(n)] : Task{0, false};
      flow(space_flow_tasks, n, task.first | (task.starts ? 0x8000 : 0));
    }
    for (int b = 0; b < flow_boards; ++b) {
      flow(space_flow_setup, 64 + b, program.boards[static_cast<std::size_t>(b)]);
    }
    flow(space_flow_setup, flow_setup_unit, kUnit);
    flow(space_flow_setup, flow_setup_next_word, kNextWord);
    flow(space_flow_setup, flow_setup_task_word, kTaskWord);
    flow(space_flow_setup, flow_setup_status_word, kStatusWord);
    flow(space_flow_setup, flow_setup_enable, 1 + (program.in_place ? 2 : 0));
    for (int point = 0; point < kPoints; ++point) {
      dut_->map_write_i = 1;
      dut_->load_addr_i = static_cast<std::uint32_t>(point);
      dut_->load_data_i =
          static_cast<std::uint16_t>(mapped(point) ? 0x8000 | (kFirstPoint + point) : 0);
      tick();
    }
    dut_->map_write_i = 0;
    for (int word = 0; word < kWords; ++word) write_word(word, 0);
  }

  void write_word(int word, std::uint16_t value) override {
    space(3, static_cast<std::uint32_t>(word), value);
  }

  std::uint16_t read_word(int word) override {
    dut_->load_valid_i = 1;
    dut_->load_write_i = 0;
    dut_->load_space_i = 3;
    dut_->load_addr_i = static_cast<std::uint32_t>(word);
    tick();
    dut_->load_valid_i = 0;
    for (int i = 0; i < 20; ++i) {
      if (dut_->load_rvalid_o != 0) return dut_->load_rdata_o;
      tick();
    }
    throw std::runtime_error("the load port does not answer");
  }

  void bus_write(int address, int value) override {
    dut_->addr_i = static_cast<std::uint8_t>(address);
    dut_->wdata_i = static_cast<std::uint16_t>(value);
    dut_->write_i = 1;
    tick();
    dut_->write_i = 0;
  }

  std::uint16_t bus_read(int address) override {
    dut_->addr_i = static_cast<std::uint8_t>(address);
    dut_->read_i = 1;
    tick();
    dut_->read_i = 0;
    return dut_->rdata_o;
  }

  void idle(int clocks) override {
    for (int i = 0; i < clocks; ++i) tick();
  }

  void enable(int bits) override {
    flow(rung::flow::space_flow_setup, rung::flow::flow_setup_enable, bits);
  }

  void first() override {
    dut_->first_i = 1;
    tick();
    dut_->first_i = 0;
  }

  Round round(std::optional<int> abort_after) override {
    seen_ = Round{};
    in_round_ = true;
    int ladder_began = -1;
    dut_->round_i = 1;
    tick();
    dut_->round_i = 0;
    for (seen_.clocks = 1; dut_->round_done_o == 0; ++seen_.clocks) {
      if (dut_->start_o != 0) seen_.starts.push_back(seen_.clocks);
      if (dut_->ladder_o != 0) ladder_began = seen_.clocks;
      if (ladder_began >= 0) in_round_ = false;  // the ladder's writes are not routines'
      if (abort_after && seen_.clocks == *abort_after) {
        give_up();
        return std::move(seen_);
      }
      if (seen_.clocks > 200000) throw std::runtime_error("no end of the round");
      tick();
    }
    seen_.ladder = seen_.clocks - ladder_began;
    in_round_ = false;
    tick();
    drain_replies();
    return std::move(seen_);
  }

  std::vector<Request> held() const override {
    std::vector<Request> held;
    for (const auto& job : jobs_) {
      if (job->state == Job::Held) held.push_back(job->request);
    }
    return held;
  }

  std::vector<Request> outstanding() const override {
    std::vector<Request> all;
    for (const auto& job : jobs_) all.push_back(job->request);
    return all;
  }

  void release(std::size_t which, const Answer& answer) override {
    for (const auto& job : jobs_) {
      if (job->state != Job::Held) continue;
      if (which-- != 0) continue;
      job->answer = answer;
      job->state = Job::Waiting;
      return;
    }
    throw std::out_of_range("no such request is held");
  }

  void drain() override {
    const auto busy = [&] {
      return !events_.empty() || std::any_of(jobs_.begin(), jobs_.end(), [](const auto& job) {
        return job->state != Job::Held;
      });
    };
    for (int i = 0; busy(); ++i) {
      if (i > 100000) throw std::runtime_error("link and panel do not come to an end");
      tick();
    }
    idle(8);
  }

  void send(const Event& event) override { events_.push_back({event, false, 0}); }

 private:
  static constexpr int kSlots = kMpu == isa::Mpu::Mpu3 ? 2 : 1;

  struct Job {
    enum State { Fetching, Waiting, Held, Filling, Done } state = Fetching;
    Request request;
    Answer answer;
  };
  struct Side {
    std::deque<PoolAccess> accesses;
  };
  struct Sending {
    Event event;
    bool written = false;  // its words are in the offered block
    int left = 0;          // words that are not
  };

  void give_up() {
    dut_->give_up_i = 1;
    dut_->core_rst_ni = 0;
    tick();
    dut_->give_up_i = 0;
    in_round_ = false;
    idle(8);
    dut_->core_rst_ni = 1;
    tick();
    space(4, 0, length_);
    idle(2);
  }

  void space(int number, std::uint32_t address, std::uint16_t data) {
    if (number == 4) length_ = data;
    dut_->load_valid_i = 1;
    dut_->load_write_i = 1;
    dut_->load_space_i = static_cast<std::uint8_t>(number);
    dut_->load_addr_i = address;
    dut_->load_data_i = data;
    tick();
    dut_->load_valid_i = 0;
  }

  void flow(int number, int address, int data) {
    dut_->flow_write_i = static_cast<std::uint8_t>(1 << (number - rung::flow::space_flow_steps));
    dut_->load_addr_i = static_cast<std::uint32_t>(address);
    dut_->load_data_i = static_cast<std::uint16_t>(data);
    tick();
    dut_->flow_write_i = 0;
  }

  void put_step(std::size_t at, const std::vector<isa::SlotInstruction>& slots) {
    const int bits = isa::slot_bits(kMpu, config_);
    for (int chunk = 0; chunk < (kSlots * bits + 15) / 16; ++chunk) {
      std::uint64_t data = 0;
      for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const std::uint64_t word = isa::encode(slots[slot], kMpu, config_);
        const int up = static_cast<int>(slot) * bits - 16 * chunk;
        if (up < 16 && up > -64) data |= up >= 0 ? word << up : word >> -up;
      }
      space(0, static_cast<std::uint32_t>(at * 8) + static_cast<std::uint32_t>(chunk),
            static_cast<std::uint16_t>(data));
    }
  }

  // One clock, with what link and panel do in it.
  void tick() {
    drive_side(0, dut_->link_mem_valid_i, dut_->link_mem_write_i, dut_->link_mem_addr_i,
               dut_->link_mem_wdata_i);
    drive_side(1, dut_->panel_mem_valid_i, dut_->panel_mem_write_i, dut_->panel_mem_addr_i,
               dut_->panel_mem_wdata_i);
    Job* link = next_done(false);
    Job* panel = next_done(true);
    drive_done(link, dut_->link_done_valid_i, dut_->link_done_block_i, dut_->link_done_status_i);
    drive_done(panel, dut_->panel_done_valid_i, dut_->panel_done_block_i,
               dut_->panel_done_status_i);
    drive_event();
    dut_->reply_ready_i = takes_replies ? 1 : 0;
    dut_->reply_done_valid_i = reply_done_.empty() ? 0 : 1;
    if (!reply_done_.empty()) {
      dut_->reply_done_block_i = static_cast<std::uint8_t>(reply_done_.front());
      reply_done_.pop_front();
    }
    dut_->clk_i = 0;
    dut_->eval();

    const bool link_mem = dut_->link_mem_valid_i != 0 && dut_->link_mem_ready_o != 0;
    const bool panel_mem = dut_->panel_mem_valid_i != 0 && dut_->panel_mem_ready_o != 0;
    const bool link_done = link != nullptr && dut_->link_done_ready_o != 0;
    const bool panel_done = panel != nullptr && dut_->panel_done_ready_o != 0;
    const bool event = dut_->event_valid_i != 0 && dut_->event_ready_o != 0;
    if (dut_->link_req_valid_o != 0) take_request(false);
    if (dut_->panel_req_valid_o != 0) take_request(true);
    if (dut_->reply_valid_o != 0 && dut_->reply_ready_i != 0) take_reply();
    if (in_round_) {
      for (int slot = 0; slot < 2; ++slot) {
        if ((dut_->write_valid_o >> slot & 1) == 0) continue;
        seen_.writes.push_back({static_cast<int>(dut_->write_addr_o >> 16 * slot & 0xffff),
                                static_cast<std::uint16_t>(dut_->write_data_o >> 16 * slot)});
      }
    }
    if (dut_->start_o != 0 && dut_->ladder_o != 0) throw std::runtime_error("two runs at once");
    dut_.tick();

    end_access(0, link_mem, dut_->link_mem_rdata_o);
    end_access(1, panel_mem, dut_->panel_mem_rdata_o);
    if (link_done) link->state = Job::Done;
    if (panel_done) panel->state = Job::Done;
    if (event) {
      in_block_ = false;
      events_.pop_front();
    }
    std::erase_if(jobs_, [](const auto& job) { return job->state == Job::Done; });
    for (const auto& job : jobs_) {
      if (job->state == Job::Waiting && job->answer.delay-- <= 0) fill(*job);
    }
  }

  template <typename Bit, typename Address, typename Data>
  void drive_side(std::size_t n, Bit& valid, Bit& write, Address& address, Data& data) {
    const Side& side = sides_[n];
    valid = side.accesses.empty() ? 0 : 1;
    if (side.accesses.empty()) return;
    write = side.accesses.front().write ? 1 : 0;
    address = static_cast<Address>(side.accesses.front().address);
    data = side.accesses.front().data;
  }

  void end_access(std::size_t n, bool taken, std::uint16_t data) {
    Side& side = sides_[n];
    if (!taken) return;
    const PoolAccess access = std::move(side.accesses.front());
    side.accesses.pop_front();
    if (access.then) access.then(data);
  }

  // The first one whose data are in the block.
  Job* next_done(bool panel) {
    for (const auto& job : jobs_) {
      if (job->request.panel == panel && job->state == Job::Filling && job->answer.words.empty()) {
        return job.get();
      }
    }
    return nullptr;
  }

  template <typename Bit, typename Block, typename Status>
  static void drive_done(const Job* job, Bit& valid, Block& block, Status& status) {
    valid = job != nullptr ? 1 : 0;
    if (job == nullptr) return;
    block = static_cast<Block>(job->request.block);
    status = static_cast<Status>(job->answer.status);
  }

  void take_request(bool panel) {
    auto job = std::make_shared<Job>();
    Request& r = job->request;
    r.panel = panel;
    r.block = dut_->req_block_o;
    r.write = dut_->req_write_o != 0;
    r.unit = dut_->req_unit_o;
    r.board = dut_->req_board_o;
    r.first = dut_->req_first_o;
    r.count = dut_->req_count_o;
    for (const auto& other : jobs_) {
      if (other->request.block == r.block) throw std::runtime_error("a block is used twice");
    }
    jobs_.push_back(job);
    const std::size_t place = seen_.requests.size();
    seen_.requests.push_back(r);
    if (!r.write) return decide(*job);
    for (int i = 0; i < r.count; ++i) {
      sides_[panel ? 1 : 0].accesses.push_back({false, r.block * 32 + i, 0, [=, this](auto word) {
                                                  job->request.words.push_back(word);
                                                  if (i + 1 != job->request.count) return;
                                                  if (place < seen_.requests.size()) {
                                                    seen_.requests[place] = job->request;
                                                  }
                                                  decide(*job);
                                                }});
    }
  }

  void decide(Job& job) {
    job.answer = answer ? answer(job.request) : Answer{-1, 0, {}};
    job.state = job.answer.delay < 0 ? Job::Held : Job::Waiting;
  }

  void fill(Job& job) {
    job.state = Job::Filling;
    if (job.request.write || job.answer.status != 0) job.answer.words.clear();
    const std::vector<std::uint16_t> words = job.answer.words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      Job* filled = &job;
      const bool last = i + 1 == words.size();
      sides_[job.request.panel ? 1 : 0].accesses.push_back(
          {true, job.request.block * 32 + static_cast<int>(i), words[i], [=](auto) {
             if (last) filled->answer.words.clear();
           }});
    }
  }

  void drive_event() {
    dut_->event_valid_i = 0;
    if (events_.empty() || dut_->event_block_valid_o == 0) return;
    Sending& sending = events_.front();
    const Event& event = sending.event;
    if (!in_block_) {
      in_block_ = true;
      sending.left = static_cast<int>(event.words.size());
      for (std::size_t i = 0; i < event.words.size(); ++i) {
        sides_[0].accesses.push_back({true, dut_->event_block_o * 32 + static_cast<int>(i),
                                      event.words[i], [this](auto) { --events_.front().left; }});
      }
    }
    if (sending.left != 0) return;
    dut_->event_valid_i = 1;
    dut_->event_write_i = event.write ? 1 : 0;
    dut_->event_board_i = static_cast<std::uint8_t>(event.board);
    dut_->event_first_i = static_cast<std::uint16_t>(event.first);
    dut_->event_count_i = static_cast<std::uint8_t>(event.count);
    dut_->event_from_i = static_cast<std::uint8_t>(event.from);
    dut_->event_tag_i = static_cast<std::uint8_t>(event.tag);
  }

  void take_reply() {
    Reply reply{dut_->reply_write_o != 0, dut_->reply_status_o, dut_->reply_count_o,
                dut_->reply_to_o,         dut_->reply_tag_o,    {}};
    const int block = dut_->reply_block_o;
    const std::size_t place = seen_.replies.size();
    seen_.replies.push_back(reply);
    if (reply.count == 0) return reply_done_.push_back(block);
    for (int i = 0; i < reply.count; ++i) {
      ++replying_;
      sides_[0].accesses.push_back({false, block * 32 + i, 0, [=, this](auto word) {
                                      --replying_;
                                      seen_.replies.at(place).words.push_back(word);
                                      if (i + 1 == reply.count) reply_done_.push_back(block);
                                    }});
    }
  }

  void drain_replies() {
    while (replying_ != 0 || !reply_done_.empty()) tick();
    const auto fetching = [&] {
      return std::any_of(jobs_.begin(), jobs_.end(),
                         [](const auto& job) { return job->state == Job::Fetching; });
    };
    while (fetching()) tick();
    tick();
  }

  const isa::Config& config_;
  std::uint16_t length_ = 0;
  bool in_round_ = false;
  bool in_block_ = false;  // the words of the first event
  int replying_ = 0;       // words of replies that are not fetched
  Round seen_;
  std::vector<std::shared_ptr<Job>> jobs_;  // in the order of their requests
  std::array<Side, 2> sides_;               // link, panel
  std::deque<Sending> events_;
  std::deque<int> reply_done_;
  Clocked<Dut> dut_;
};

}  // namespace rung::tb::flow
