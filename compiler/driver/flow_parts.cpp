// SPDX-License-Identifier: Apache-2.0
#include "driver/flow_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>
#include <tuple>

#include "rung_flow.hpp"

namespace rung::flow_parts {

using flowchart::Board;
using flowchart::Flowchart;
using flowchart::Step;
using flowchart::Transfer;

namespace {

// One more than the highest number of a flow device.
constexpr std::uint32_t kFlowEnd = 2 * flowchart::kFirstFlowWord;
// Ticks for the clocks of waits, where the ladder has none of that base.
constexpr std::uint32_t kClockTicks = kFlowEnd - 2;

void must(bool condition, const std::string& what) {
  if (!condition) throw std::logic_error("internal error in the flowchart: " + what);
}

void check_transfer(const Flowchart& chart, const Step& step, const Transfer& transfer) {
  must(transfer.board < chart.boards.size(), step.name + ": no such board");
  must(transfer.count >= 1 && transfer.count <= flow::flow_block_words,
       step.name + ": words of a transfer");
  must(transfer.first >= 0 && transfer.first + transfer.count <= 1 << 16,
       step.name + ": variables of a transfer");
  must(is_word(transfer.head), step.name + ": a transfer to bits");
}

void check_indices(const Flowchart& chart) {
  must(chart.unit >= 1 && chart.unit <= flow::flow_units, "number of the unit");
  for (const flowchart::Task& task : chart.tasks) {
    must(task.first < chart.steps.size(), task.name + ": no such step");
  }
  std::size_t before = 0;
  for (const Step& step : chart.steps) {
    must(step.task < chart.tasks.size() && step.task >= before, step.name + ": its task");
    before = step.task;
    for (const std::size_t next : step.next) {
      must(next < chart.steps.size(), step.name + ": no such next step");
    }
    if (step.read) check_transfer(chart, step, *step.read);
    if (step.write) check_transfer(chart, step, *step.write);
    must(step.rungs.instructions.empty() || step.rungs.dialect == chart.dialect,
         step.name + ": its dialect");
  }
  const bool ladder = !chart.ladder.instructions.empty();
  must(!ladder || chart.ladder.dialect == chart.dialect, "the ladder's dialect");
  must(chart.dialect != Dialect::Ldmicro, "its dialect");
}

using Key = std::tuple<std::size_t, int, int, Device>;
Key key_of(const Transfer& transfer) {
  return {transfer.board, transfer.first, transfer.count, transfer.head};
}

// Numbers from 1 on, in the order of the steps.
class Numbers {
 public:
  // True if it is a new one.
  bool add(const Transfer& transfer) {
    return numbers_.try_emplace(key_of(transfer), static_cast<int>(numbers_.size()) + 1).second;
  }
  int of(const std::optional<Transfer>& transfer) const {
    return transfer ? numbers_.at(key_of(*transfer)) : 0;
  }
  std::size_t count() const { return numbers_.size(); }

 private:
  std::map<Key, int> numbers_;
};

}  // namespace

void check_chart(const Flowchart& chart, const CompileOptions& options, Diagnostics& diagnostics) {
  check_indices(chart);
  if (options.paper) {
    diagnostics.error(chart.file, {}, "flow tasks have more than the paper's instruction forms",
                      "compile without --paper");
  }
  if (!options.config->flow) {
    diagnostics.error(
        chart.file, {},
        fmt::format("configuration {} has no hardware for flow tasks", options.config->name),
        "choose another one with --config, ecp5");
  }
  const auto limit = [&](std::size_t count, int most, SourcePosition position, const char* what,
                         const char* mend) {
    if (count <= static_cast<std::size_t>(most)) return;
    diagnostics.error(
        chart.file, position,
        fmt::format("the program has {} {}; the task hardware has {}", count, what, most), mend);
  };
  const auto beyond = [](const auto& things, int most) {
    const auto index = static_cast<std::size_t>(most);
    return index < things.size() ? things[index].position : SourcePosition{};
  };
  limit(chart.tasks.size(), flow::flow_tasks, beyond(chart.tasks, flow::flow_tasks), "tasks",
        "join tasks that never run together");
  limit(chart.steps.size(), flow::flow_steps, beyond(chart.steps, flow::flow_steps),
        "steps, those of waits included", "join steps that need no data from elsewhere");
  for (const Board& board : chart.boards) {
    if (board.unit != chart.unit || board.number < flow::flow_boards) continue;
    diagnostics.error(chart.file, board.position,
                      fmt::format("board {} of this unit has number {}; the highest is {}",
                                  board.name, board.number, flow::flow_boards - 1),
                      "choose a lower number");
  }
  constexpr int kMostTransfers = flow::flow_transfers - 1;  // 0 means none
  Numbers numbers;
  SourcePosition position;
  for (const Step& step : chart.steps) {
    for (const auto* transfer : {&step.read, &step.write}) {
      const bool fresh = *transfer && numbers.add(**transfer);
      if (fresh && numbers.count() == kMostTransfers + 1) position = (*transfer)->position;
    }
  }
  limit(numbers.count(), kMostTransfers, position, "different transfers",
        "let steps that want the same data use the same devices");
}

bool is_flow_device(Device device) {
  return (device.kind == DeviceKind::HB || device.kind == DeviceKind::HW) &&
         device.number >= flowchart::kFirstFlowWord && device.number < kFlowEnd;
}

std::string remembers(const core::Program& program) {
  if (!program.ticks.empty()) return "it counts time";
  if (!program.constants.empty()) return "it has a table of constants";
  std::set<Device> written;
  const auto unknown = [&](Device device) {
    return is_private(device) && !written.contains(device);
  };
  for (const core::Instruction& instruction : program.instructions) {
    for (const Device device : instruction.reads) {
      if (unknown(device)) return "it reads what it has not written";
    }
    for (const core::WordSource& source : instruction.sources) {
      if (!source.constant && unknown(source.device)) return "it reads what it has not written";
    }
    if (core::is_contact(instruction.op)) {
      if (unknown(instruction.targets.at(0))) return "a contact remembers";
      continue;
    }
    // A word under a condition is used under it too; a bit may be read when it was not written.
    const bool surely = instruction.op == core::Op::Out || instruction.always;
    for (const Device device : instruction.targets) {
      if (surely || is_word(device)) written.insert(device);
    }
  }
  return {};
}

void count_time(core::Program& ladder, const std::set<Device>& used) {
  struct Clock {
    Device word;
    std::int64_t base_us;
  };
  constexpr std::array kClocks = {Clock{flowchart::kMilliseconds, 1'000},
                                  Clock{flowchart::kTenths, 100'000}};
  std::vector<core::Instruction> front;
  for (std::size_t i = 0; i < kClocks.size(); ++i) {
    const auto& [word, base] = kClocks.at(i);
    if (!used.contains(word)) continue;
    Device ticks{DeviceKind::HW, kClockTicks + static_cast<std::uint32_t>(i)};
    bool there = false;
    for (const core::TickWord& each : ladder.ticks) {
      if (each.base_us == base) {
        ticks = each.device;
        there = true;
      }
    }
    if (!there) ladder.ticks.push_back({ticks, base});
    core::Instruction add;
    add.op = core::Op::Add;
    add.targets = {word};
    add.sources = {{false, 0, word}, {false, 0, ticks}};
    add.always = true;
    add.origin = static_cast<std::size_t>(-1);  // no instruction of the source
    front.push_back(std::move(add));
  }
  if (front.empty()) return;
  for (core::Network& network : ladder.networks) network.first += front.size();
  ladder.networks.insert(ladder.networks.begin(), {0, front.size()});
  ladder.instructions.insert(ladder.instructions.begin(), front.begin(), front.end());
}

Program whole_program(const Flowchart& chart) {
  Program whole;
  whole.file = chart.file;
  whole.dialect = chart.dialect;
  const auto add = [&](const Program& program) {
    const std::size_t first = whole.instructions.size();
    whole.instructions.insert(whole.instructions.end(), program.instructions.begin(),
                              program.instructions.end());
    for (const Network& network : program.networks) {
      whole.networks.push_back({first + network.first, network.count});
    }
    whole.comments.insert(program.comments.begin(), program.comments.end());
  };
  add(chart.ladder);
  for (const Step& step : chart.steps) add(step.rungs);
  return whole;
}

std::set<Device> table_devices(const Flowchart& chart) {
  std::set<Device> devices{flowchart::kNextStep, flowchart::kTaskCommand, flowchart::kStatus};
  for (const Step& step : chart.steps) {
    for (const auto* transfer : {&step.read, &step.write}) {
      if (!*transfer) continue;
      const Device head = (*transfer)->head;
      for (int i = 0; i < (*transfer)->count; ++i) {
        devices.insert({head.kind, head.number + static_cast<std::uint32_t>(i)});
      }
    }
  }
  return devices;
}

image::FlowImage tables(const Flowchart& chart, const std::function<int(Device)>& address) {
  image::FlowImage out;
  out.unit = chart.unit;
  out.next_word = address(flowchart::kNextStep);
  out.task_word = address(flowchart::kTaskCommand);
  out.status_word = address(flowchart::kStatus);
  for (const Board& board : chart.boards) {
    out.boards.push_back(
        {board.name, board.unit, board.number, board.over_link, board.exclusive, board.panel});
  }
  for (const flowchart::Task& task : chart.tasks) {
    out.tasks.push_back({task.name, static_cast<int>(task.first), task.starts});
  }
  Numbers numbers;
  const auto add = [&](const std::optional<Transfer>& transfer) {
    if (!transfer || !numbers.add(*transfer)) return;
    const Device head = transfer->head;
    for (int i = 0; i < transfer->count; ++i) {
      must(address({head.kind, head.number + static_cast<std::uint32_t>(i)}) == address(head) + i,
           "the words of a transfer do not lie together");
    }
    out.transfers.push_back(
        {static_cast<int>(transfer->board), transfer->first, transfer->count, address(head)});
  };
  for (const Step& step : chart.steps) {
    add(step.read);
    add(step.write);
    image::FlowStep& to = out.steps.emplace_back();
    to.name = step.name;
    to.task = static_cast<int>(step.task);
    to.read = numbers.of(step.read);
    to.write = numbers.of(step.write);
    to.next.assign(step.next.begin(), step.next.end());
    to.added = step.added;
    to.position = step.position;
    to.text = step.text;
  }
  return out;
}

}  // namespace rung::flow_parts
