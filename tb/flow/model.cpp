// SPDX-License-Identifier: Apache-2.0
#include "flow/model.hpp"

#include <algorithm>

namespace rung::tb::flow {
namespace {

constexpr int kRefused = rung::flow::flow_status_refused;

}  // namespace

Model::Model(const Program& program)
    : words(kWords), program_(program), rows_(rung::flow::flow_tasks) {
  for (int b = 0; b < rung::flow::flow_task_blocks; ++b) free_blocks_.insert(b);
  for (auto& block : blocks) block.resize(rung::flow::flow_block_words);
  first();
}

void Model::first() {
  for (std::size_t n = 0; n < rows_.size(); ++n) {
    Row& row = rows_[n];
    if (row.block && !row.waits) free(*row.block);
    row = Row{};
    if (n >= program_.tasks.size()) continue;
    row.started = program_.tasks[n].starts;
    row.step = row.shown = program_.tasks[n].first;
  }
}

Model::Way Model::way(const Transfer& t) const {
  if (t.count < 1 || t.count > rung::flow::flow_block_words) return Way::Refused;
  if (!own(t)) return t.unit >= 1 && t.unit <= rung::flow::flow_units ? Way::Link : Way::Refused;
  if (t.board >= rung::flow::flow_boards || (board(t) & kThere) == 0) return Way::Refused;
  if ((board(t) & kPanel) != 0) return Way::Panel;
  return t.first + t.count <= kPoints ? Way::Local : Way::Refused;
}

bool Model::exclusive(const Transfer& t) const {
  return own(t) && t.board < rung::flow::flow_boards && (board(t) & kThere) != 0 &&
         (board(t) & kExclusive) != 0;
}

void Model::free(int block) {
  if (block < rung::flow::flow_task_blocks) free_blocks_.insert(block);
  std::erase_if(locks_, [=](const auto& lock) { return lock.second == block; });
}

bool Model::request(const Transfer& t, int block, bool write) {
  Request r{way(t) == Way::Panel, block, write, t.unit, t.board, t.first, t.count, {}};
  if (write) {
    const auto& from = blocks[static_cast<std::size_t>(block)];
    r.words.assign(from.begin(), from.begin() + t.count);
  }
  now_.requests.push_back(r);
  if (!in_place(t)) return false;
  const Answer came = answer(r);
  statuses_[block] = came.status;
  for (std::size_t i = 0; i < came.words.size(); ++i) {
    blocks[static_cast<std::size_t>(block)][i] = came.words[i];
  }
  return true;
}

void Model::load_block(const Transfer& t, int block) {
  for (int i = 0; i < t.count; ++i) {
    const int point = t.first + i;
    blocks[static_cast<std::size_t>(block)][static_cast<std::size_t>(i)] =
        mapped(point) ? words[static_cast<std::size_t>(kFirstPoint + point)] : 0;
  }
}

void Model::store_block(const Transfer& t, int block) {
  for (int i = 0; i < t.count; ++i) {
    const int point = t.first + i;
    if (!mapped(point)) continue;
    words[static_cast<std::size_t>(kFirstPoint + point)] =
        blocks[static_cast<std::size_t>(block)][static_cast<std::size_t>(i)];
  }
}

void Model::come(int block, const Answer& answer) {
  statuses_[block] = answer.status;
  for (std::size_t i = 0; i < answer.words.size(); ++i) {
    blocks[static_cast<std::size_t>(block)][i] = answer.words[i];
  }
  if (block < rung::flow::flow_task_blocks) {
    Row& row = rows_[static_cast<std::size_t>(owners_.at(block))];
    if (row.waits && row.block == block) {
      row.waits = false;
    } else {
      free(block);
      ++counters.vanished;
    }
    return;
  }
  for (Command& command : ring_) {
    if (command.block == block) command.came = true;
  }
}

void Model::receive(const Event& event, int block) {
  for (std::size_t i = 0; i < event.words.size(); ++i) {
    blocks[static_cast<std::size_t>(block)][i] = event.words[i];
  }
  ring_.push_back({event, block});
}

int Model::lowest_event_block() const {
  int block = rung::flow::flow_task_blocks;
  const auto taken = [&] {
    return std::any_of(ring_.begin(), ring_.end(),
                       [&](const Command& command) { return command.block == block; });
  };
  while (taken()) ++block;
  return block;
}

void Model::go_on(int task) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  row.skip = row.paused;
  row.paused = row.ask = false;
}

void Model::ask(int task) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  row.ask = row.started && !row.paused;
}

int Model::state(int task) const {
  const Row& row = rows_[static_cast<std::size_t>(task)];
  const int phase = row.paused ? 3 : row.started ? row.phase : 0;
  return phase | (row.started ? 4 : 0) | (row.waits ? 8 : 0);
}

int Model::step(int task) const { return rows_[static_cast<std::size_t>(task)].shown; }

Expected Model::round() {
  now_ = Expected{};
  pc_command();
  for (std::size_t left = ring_.size(); left != 0; --left) {
    const Command command = ring_.front();
    ring_.pop_front();
    event_command(command);
  }

  // A task that a step starts has its turn in this round if that has not yet passed.
  short_before_ = short_;
  short_ = false;
  const int first = (began_ + 1) % rung::flow::flow_tasks;
  bool began = false;
  for (int i = 0; i < rung::flow::flow_tasks; ++i) {
    const int task = (first + i) % rung::flow::flow_tasks;
    const Row& row = rows_[static_cast<std::size_t>(task)];
    if (!row.started || row.waits || row.paused) continue;
    if (!began) began_ = task;
    began = true;
    turn(task);
  }
  for (const Move& move : program_.ladder) {
    words[static_cast<std::size_t>(move.to)] =
        move.constant ? move.value : words[static_cast<std::size_t>(move.from)];
  }
  return now_;
}

void Model::turn(int task) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  if (row.phase == 1) return loaded(task);
  const bool answered = row.phase == 2;
  if (answered) {
    stored(task);
    if (!row.started) return;
  }
  std::optional<int> block;
  if (fetch(task, block, answered)) run(task, block);
}

// The data of a LOAD have come.
void Model::loaded(int task) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  const int block = *row.block;
  row.block.reset();
  row.phase = 0;
  row.status = statuses_.at(block);
  const Step& step = program_.steps[static_cast<std::size_t>(row.step)];
  const Transfer& t = program_.transfers[static_cast<std::size_t>(step.before)];
  counters.failed += *row.status != 0;
  for (int i = 0; i < t.count && *row.status == 0; ++i) {
    words[static_cast<std::size_t>(t.head + i)] =
        blocks[static_cast<std::size_t>(block)][static_cast<std::size_t>(i)];
  }
  run(task, block);
}

// The answer to a STORE has.
void Model::stored(int task) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  const int block = *row.block;
  row.block.reset();
  row.phase = 0;
  row.status = statuses_.at(block);
  row.shown = row.step;
  counters.failed += *row.status != 0;
  free(block);
  if (row.ends) row.stop();
}

bool Model::fetch(int task, std::optional<int>& block, bool answered) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  const Step& step = program_.steps[static_cast<std::size_t>(row.step)];
  row.shown = row.step;
  if ((breakpoints.contains(row.step) || row.ask) && !row.skip) {
    row.paused = true;
    row.ask = false;
    return false;
  }
  const Transfer& before = program_.transfers[static_cast<std::size_t>(step.before)];
  const Transfer& after = program_.transfers[static_cast<std::size_t>(step.after)];
  const bool held = (step.before != 0 && blocked(before)) || (step.after != 0 && blocked(after));
  const auto linked = [&](const Transfer& t) {
    return way(t) == Way::Link || way(t) == Way::Panel;
  };
  const bool needs = (step.before != 0 && linked(before)) || (step.after != 0 && linked(after));
  if (held) {
    ++counters.held;
    short_ = true;
    return false;
  }
  // Who has just given back its block gives way.
  if (needs && (free_blocks_.empty() || (answered && (short_ || short_before_)))) {
    ++counters.full;
    if (free_blocks_.empty()) short_ = true;
    return false;
  }
  if (needs) {
    block = *free_blocks_.begin();
    free_blocks_.erase(*block);
    if (step.before != 0) lock(before, *block);
    if (step.after != 0) lock(after, *block);
  }
  if (step.before == 0) return true;
  switch (way(before)) {
    case Way::Refused:
      row.status = kRefused;
      ++counters.failed;
      return true;
    case Way::Local:
      load_block(before, kScratchBlock);
      for (int i = 0; i < before.count; ++i) {
        words[static_cast<std::size_t>(before.head + i)] =
            blocks[kScratchBlock][static_cast<std::size_t>(i)];
      }
      row.status = 0;
      return true;
    default:
      break;
  }
  owners_[*block] = task;
  row.block = block;
  row.skip = false;
  row.phase = 1;
  row.waits = !request(before, *block, false);
  if (!row.waits) loaded(task);
  return false;
}

void Model::run(int task, std::optional<int> block) {
  Row& row = rows_[static_cast<std::size_t>(task)];
  const Step& step = program_.steps[static_cast<std::size_t>(row.step)];
  if (row.status) words[kStatusWord] = static_cast<std::uint16_t>(*row.status);
  row.status.reset();
  row.skip = false;
  int next = row.step;
  bool ends = false;
  bool gone = false;
  std::vector<int> commands;
  for (const Move& move : step.routine) {
    const std::uint16_t value =
        move.constant ? move.value : words[static_cast<std::size_t>(move.from)];
    words[static_cast<std::size_t>(move.to)] = value;
    now_.writes.push_back({move.to, value});
    if (move.to == kNextWord) {
      next = value & 0x7ff;
      ends = value == kEnds;
    }
    if (move.to == kTaskWord && value < 512 && (value & 255) < rung::flow::flow_tasks &&
        commands.size() < static_cast<std::size_t>(rung::flow::flow_task_commands)) {
      commands.push_back(value);
    }
  }
  for (const int command : commands) {
    const int other = command & 127;
    Row& it = rows_[static_cast<std::size_t>(other)];
    if (command >= 256) {
      if (it.started) continue;
      it = Row{};
      it.started = true;
      it.step = it.shown = static_cast<std::size_t>(other) < program_.tasks.size()
                               ? program_.tasks[static_cast<std::size_t>(other)].first
                               : 0;
    } else {
      if (it.block && !it.waits) free(*it.block);
      it.stop();
      gone = gone || other == task;
    }
  }
  if (gone) {
    if (block) free(*block);
    return;
  }
  row.step = next;
  row.ends = ends;
  row.phase = 0;
  if (step.after != 0) {
    const Transfer& t = program_.transfers[static_cast<std::size_t>(step.after)];
    const auto gather = [&](int to) {
      for (int i = 0; i < t.count; ++i) {
        blocks[static_cast<std::size_t>(to)][static_cast<std::size_t>(i)] =
            words[static_cast<std::size_t>(t.head + i)];
      }
    };
    switch (way(t)) {
      case Way::Refused:
        row.status = kRefused;
        ++counters.failed;
        break;
      case Way::Local:
        gather(kScratchBlock);
        store_block(t, kScratchBlock);
        row.status = 0;
        break;
      default:
        gather(*block);
        owners_[*block] = task;
        row.block = block;
        row.phase = 2;
        row.waits = !request(t, *block, true);
        if (!row.waits) stored(task);
        return;  // while it waits, its step is still the one that is shown
    }
  }
  row.shown = next;
  if (block) free(*block);
  if (ends) row.stop();
}

std::optional<int> Model::command(const Transfer& t, bool write, int block) {
  switch (way(t)) {
    case Way::Refused:
      return kRefused;
    case Way::Local:
      if (write)
        store_block(t, block);
      else
        load_block(t, block);
      return 0;
    default:
      break;
  }
  lock(t, block);
  if (request(t, block, write)) return statuses_.at(block);
  return std::nullopt;
}

void Model::pc_command() {
  constexpr int kBlock = rung::flow::flow_pc_block;
  std::optional<int> status;
  if (pc.state == 1) {
    if (blocked(pc.transfer)) {
      ++counters.held;
      short_ = true;
      return;
    }
    status = command(pc.transfer, pc.write, kBlock);
    if (!status) {
      statuses_.erase(kBlock);
      pc.state = 2;
    }
  } else if (pc.state == 2 && statuses_.contains(kBlock)) {
    status = statuses_.at(kBlock);
  }
  if (!status) return;
  statuses_.erase(kBlock);
  pc.state = 0;
  pc.status = *status;
  counters.failed += *status != 0;
  free(kBlock);
}

void Model::event_command(Command command) {
  const Event& event = command.event;
  const Transfer t{kUnit, event.board, event.first, event.count, 0};
  std::optional<int> status;
  if (command.waits) {
    if (command.came) status = statuses_.at(command.block);
  } else if (blocked(t)) {
    ++counters.held;
    short_ = true;
  } else {
    status = this->command(t, event.write, command.block);
    command.waits = !status;
    if (command.waits) {
      ++counters.event_waits;
    }
  }
  if (!status) {
    ring_.push_back(command);
    return;
  }
  ++counters.events;
  counters.failed += *status != 0;
  free(command.block);
  Reply reply{event.write, *status,   event.write || *status != 0 ? 0 : event.count,
              event.from,  event.tag, {}};
  const auto& from = blocks[static_cast<std::size_t>(command.block)];
  reply.words.assign(from.begin(), from.begin() + reply.count);
  now_.replies.push_back(reply);
}

}  // namespace rung::tb::flow
