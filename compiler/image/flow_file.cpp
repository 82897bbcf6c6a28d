// SPDX-License-Identifier: Apache-2.0
#include "image/flow_file.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "rung_flow.hpp"

namespace rung::image {
namespace {

using file::inside;
using file::require;
using nlohmann::json;

int size_of(const auto& things) { return static_cast<int>(things.size()); }

void check_boards(const FlowImage& flow) {
  std::set<std::pair<int, int>> taken;
  for (const FlowBoard& board : flow.boards) {
    require(board.unit >= 1 && board.unit <= rung::flow::flow_units, "unit of a board");
    require(inside(board.number, board.unit == flow.unit ? rung::flow::flow_boards : 256),
            "number of a board");
    require(taken.insert({board.unit, board.number}).second, "two boards of one number");
  }
}

void check_transfers(const FlowImage& flow, const isa::Config& config) {
  require(flow.transfers.size() < rung::flow::flow_transfers, "number of transfers");
  for (const FlowTransfer& transfer : flow.transfers) {
    require(inside(transfer.board, size_of(flow.boards)), "board of a transfer");
    require(transfer.count >= 1 && transfer.count <= rung::flow::flow_block_words,
            "words of a transfer");
    require(inside(transfer.first, (1 << 16) - transfer.count + 1), "variables of a transfer");
    require(inside(transfer.address, config.word_devices - transfer.count + 1),
            "devices of a transfer");
  }
}

void check_steps(const Image& image) {
  const FlowImage& flow = *image.flow;
  require(flow.steps.size() <= rung::flow::flow_steps, "number of flow steps");
  int entry = flow.ladder_steps;
  int task = 0;
  for (const FlowStep& step : flow.steps) {
    require(step.task >= task && step.task < size_of(flow.tasks), "task of a flow step");
    require(step.entry == entry && step.end >= entry && step.end <= size_of(image.steps),
            "routine of a flow step");
    require(inside(step.read, size_of(flow.transfers) + 1), "transfer before a flow step");
    require(inside(step.write, size_of(flow.transfers) + 1), "transfer behind a flow step");
    require(step.clocks >= step.end - step.entry + isa::constant::fill_clocks,
            "clocks of a flow step");
    for (const int next : step.next) require(inside(next, size_of(flow.steps)), "next flow step");
    task = step.task;
    entry = step.end;
  }
  require(entry == size_of(image.steps), "steps behind the last routine");
}

}  // namespace

json flow_to_json(const FlowImage& flow) {
  json out;
  out["unit"] = flow.unit;
  out["words"] = {flow.next_word, flow.task_word, flow.status_word};
  out["ladder_steps"] = flow.ladder_steps;
  json boards = json::array();
  for (const FlowBoard& board : flow.boards) {
    boards.push_back(
        {board.name, board.unit, board.number, board.over_link, board.exclusive, board.panel});
  }
  out["boards"] = std::move(boards);
  json transfers = json::array();
  for (const FlowTransfer& transfer : flow.transfers) {
    transfers.push_back({transfer.board, transfer.first, transfer.count, transfer.address});
  }
  out["transfers"] = std::move(transfers);
  json tasks = json::array();
  for (const FlowTask& task : flow.tasks) tasks.push_back({task.name, task.first, task.starts});
  out["tasks"] = std::move(tasks);
  json steps = json::array();
  for (const FlowStep& step : flow.steps) {
    steps.push_back({step.name, step.task, step.entry, step.end, step.read, step.write, step.clocks,
                     step.next, step.added, step.position.line, step.position.column, step.text});
  }
  out["steps"] = std::move(steps);
  return out;
}

FlowImage flow_from_json(const json& in) {
  FlowImage flow;
  flow.unit = in.at("unit").get<int>();
  const json& words = in.at("words");
  flow.next_word = words.at(0).get<int>();
  flow.task_word = words.at(1).get<int>();
  flow.status_word = words.at(2).get<int>();
  flow.ladder_steps = in.at("ladder_steps").get<int>();
  for (const json& each : in.at("boards")) {
    flow.boards.push_back({each.at(0).get<std::string>(), each.at(1).get<int>(),
                           each.at(2).get<int>(), each.at(3).get<bool>(), each.at(4).get<bool>(),
                           each.at(5).get<bool>()});
  }
  for (const json& each : in.at("transfers")) {
    flow.transfers.push_back({each.at(0).get<int>(), each.at(1).get<int>(), each.at(2).get<int>(),
                              each.at(3).get<int>()});
  }
  for (const json& each : in.at("tasks")) {
    flow.tasks.push_back(
        {each.at(0).get<std::string>(), each.at(1).get<int>(), each.at(2).get<bool>()});
  }
  for (const json& each : in.at("steps")) {
    FlowStep& step = flow.steps.emplace_back();
    step.name = each.at(0).get<std::string>();
    step.task = each.at(1).get<int>();
    step.entry = each.at(2).get<int>();
    step.end = each.at(3).get<int>();
    step.read = each.at(4).get<int>();
    step.write = each.at(5).get<int>();
    step.clocks = each.at(6).get<std::int64_t>();
    step.next = each.at(7).get<std::vector<int>>();
    step.added = each.at(8).get<bool>();
    step.position = {each.at(9).get<int>(), each.at(10).get<int>()};
    step.text = each.at(11).get<std::string>();
  }
  return flow;
}

void check_flow(const Image& image, const isa::Config& config) {
  const FlowImage& flow = *image.flow;
  require(config.flow, "flow tasks in a configuration without them");
  require(flow.unit >= 1 && flow.unit <= rung::flow::flow_units, "number of the unit");
  for (const int word : {flow.next_word, flow.task_word, flow.status_word}) {
    require(inside(word, config.word_devices), "words of the task hardware");
  }
  require(inside(flow.ladder_steps, size_of(image.steps) + 1), "steps of the ladder");
  require(flow.tasks.size() <= rung::flow::flow_tasks, "number of tasks");
  for (const FlowTask& task : flow.tasks) {
    require(inside(task.first, size_of(flow.steps)), "first step of a task");
  }
  check_boards(flow);
  check_transfers(flow, config);
  check_steps(image);
}

}  // namespace rung::image
