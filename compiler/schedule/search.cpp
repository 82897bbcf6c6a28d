// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <queue>
#include <random>
#include <stdexcept>

#include "schedule/schedule.hpp"

namespace rung::schedule {
namespace {

using mapping::kNoOp;
using mapping::MappedOp;
using mapping::Mapping;
using mapping::OpId;
using mapping::Unit;

// What all tries together may place.
constexpr int kOperationsTried = 400'000;

// One slot's time line.
struct Lane {
  std::vector<OpId> cells;
  std::vector<bool> owned;  // steps in which the slot's exc belongs to a unit
  // Steps in which the mul-div unit holds an operation, as first -> last.
  std::map<int, int> busy;
  int first_free = 0;

  bool free(int step) const {
    return step >= static_cast<int>(cells.size()) || cells[step] == kNoOp;
  }
  bool is_owned(int step) const { return step < static_cast<int>(owned.size()) && owned[step]; }
  void put(int step, OpId op) {
    if (step >= static_cast<int>(cells.size())) cells.resize(step + 1, kNoOp);
    cells[step] = op;
    while (!free(first_free)) ++first_free;
  }
  void own(int first, int last) {
    if (last >= static_cast<int>(owned.size())) owned.resize(last + 1, false);
    std::fill(owned.begin() + first, owned.begin() + last + 1, true);
  }
  // The end of an operation that the unit holds in [first, last], or nothing.
  std::optional<int> conflict(int first, int last) const {
    auto next = busy.upper_bound(last);
    if (next == busy.begin()) return std::nullopt;
    --next;
    if (next->second < first) return std::nullopt;
    return next->second;
  }
};

// Where a unit would go: the steps of its operations and collectors in one slot.
struct Place {
  int slot = 0;
  std::vector<int> ops;
  std::vector<int> collectors;
  int end() const {
    int last = ops.back();
    for (const int step : collectors) last = std::max(last, step);
    return last;
  }
};

// What does not change from one try to the next.
class Graph {
 public:
  explicit Graph(const Problem& problem) : problem_(problem) {
    const Mapping& mapping = *problem.mapping;
    unit_of_.assign(mapping.ops.size(), 0);
    for (std::size_t u = 0; u < mapping.units.size(); ++u) {
      for (const OpId op : mapping.units[u].ops) unit_of_[op] = static_cast<int>(u);
      for (const OpId op : mapping.units[u].collectors) unit_of_[op] = static_cast<int>(u);
    }
    in_.resize(mapping.ops.size());
    out_.resize(mapping.ops.size());
    unit_out_.resize(mapping.units.size());
    unit_in_.assign(mapping.units.size(), 0);
    for (const Edge& edge : problem.edges) {
      in_[edge.after].push_back(edge);
      out_[edge.before].push_back(edge);
      const int from = unit_of_[edge.before];
      const int to = unit_of_[edge.after];
      if (from == to) continue;
      unit_out_[from].push_back(to);
      ++unit_in_[to];
    }
    find_tails();
    find_writers();
  }

  const Problem& problem() const { return problem_; }
  const std::vector<Edge>& in(OpId op) const { return in_[op]; }
  int unit_of(OpId op) const { return unit_of_[op]; }
  const std::vector<int>& followers(int unit) const { return unit_out_[unit]; }
  const std::vector<int>& pending() const { return unit_in_; }
  // Units that write a common device, or are linked by such units, have the same number; -1: the
  // unit writes no device.
  int writers(int unit) const { return writers_[unit]; }
  // Steps from the unit's start to the end of the longest chain that hangs on it.
  int tail(int unit) const { return tail_[problem_.mapping->units[unit].ops.front()]; }

 private:
  void find_tails() {
    std::vector<int> left(out_.size(), 0);
    std::vector<OpId> ready;
    for (std::size_t i = 0; i < out_.size(); ++i) {
      left[i] = static_cast<int>(out_[i].size());
      if (left[i] == 0) ready.push_back(static_cast<OpId>(i));
    }
    tail_.assign(out_.size(), 1);
    while (!ready.empty()) {
      const OpId op = ready.back();
      ready.pop_back();
      for (const Edge& edge : in_[op]) {
        tail_[edge.before] = std::max(tail_[edge.before], tail_[op] + edge.latency);
        if (--left[edge.before] == 0) ready.push_back(edge.before);
      }
    }
  }

  void find_writers() {
    const Mapping& mapping = *problem_.mapping;
    std::map<Device, std::vector<int>> by_device;
    for (std::size_t op = 0; op < mapping.ops.size(); ++op) {
      const mapping::Destination& to = mapping.ops[op].destination;
      if (to.kind == mapping::Destination::Kind::Device)
        by_device[to.device].push_back(unit_of_[op]);
      for (const Device device : mapping.ops[op].window) by_device[device].push_back(unit_of_[op]);
    }
    writers_.assign(mapping.units.size(), -1);
    for (const auto& [device, units] : by_device) {
      for (const int unit : units) writers_[unit] = unit;
    }
    const auto root = [&](int unit) {
      while (writers_[unit] != unit) unit = writers_[unit];
      return unit;
    };
    for (const auto& [device, units] : by_device) {
      for (const int unit : units) writers_[root(unit)] = root(units.front());
    }
    for (int& group : writers_) {
      if (group >= 0) group = root(group);
    }
  }

  const Problem& problem_;
  std::vector<int> unit_of_;
  std::vector<int> writers_;
  std::vector<std::vector<Edge>> in_, out_;
  std::vector<std::vector<int>> unit_out_;
  std::vector<int> unit_in_;
  std::vector<int> tail_;
};

class Attempt {
 public:
  Attempt(const Graph& graph, const std::vector<std::int64_t>& priority, bool home_banks)
      : graph_(graph),
        mapping_(*graph.problem().mapping),
        priority_(priority),
        home_banks_(home_banks),
        lanes_(graph.problem().slots),
        time_(mapping_.ops.size(), -1) {}

  Schedule run() {
    std::vector<int> pending = graph_.pending();
    using Entry = std::pair<std::int64_t, int>;
    std::priority_queue<Entry> ready;
    for (std::size_t u = 0; u < pending.size(); ++u) {
      if (pending[u] == 0) ready.push({priority_[u], static_cast<int>(u)});
    }
    std::size_t placed = 0;
    while (!ready.empty()) {
      const int unit = ready.top().second;
      ready.pop();
      place(unit);
      ++placed;
      for (const int follower : graph_.followers(unit)) {
        if (--pending[follower] == 0) ready.push({priority_[follower], follower});
      }
    }
    if (placed != mapping_.units.size()) {
      throw std::logic_error("internal error in mapping: units depend on each other in a circle");
    }
    return result();
  }

 private:
  // First step in which `op` finds everything that other units must have done before it.
  int earliest(OpId op) const {
    int step = 0;
    for (const Edge& edge : graph_.in(op)) {
      if (time_[edge.before] >= 0) step = std::max(step, time_[edge.before] + edge.latency);
    }
    return step;
  }

  // The place of `unit` in this slot that starts earliest.
  Place find(const Unit& unit, int slot) const {
    const Lane& lane = lanes_[slot];
    std::vector<int> est;
    for (const OpId op : unit.ops) est.push_back(earliest(op));
    int start = std::max(est.front(), lane.first_free);
    // Starting before its operations can follow would only keep the slot's exc.
    for (std::size_t i = 0; i < est.size(); ++i)
      start = std::max(start, est[i] - static_cast<int>(i));
    for (;; ++start) {
      Place place;
      place.slot = slot;
      int step = start;
      bool fits = true;
      for (std::size_t i = 0; i < unit.ops.size() && fits; ++i, ++step) {
        step = std::max(step, est[i]);
        // Within the unit only an index has to be waited for.
        for (const Edge& edge : graph_.in(unit.ops[i])) {
          if (edge.latency <= 1) continue;
          const auto before = std::find(unit.ops.begin(), unit.ops.end(), edge.before);
          if (before == unit.ops.end()) continue;
          step = std::max(step, place.ops[before - unit.ops.begin()] + edge.latency);
        }
        while (!lane.free(step) && !lane.is_owned(step)) ++step;
        fits = lane.free(step) && !lane.is_owned(step);
        place.ops.push_back(step);
      }
      for (int s = start; fits && s <= place.ops.back(); ++s) fits = !lane.is_owned(s);
      if (!fits) continue;
      if (const auto blocked = find_collectors(unit, lane, place)) {
        start = std::max(start, *blocked - static_cast<int>(unit.ops.size()));
        continue;
      }
      return place;
    }
  }

  // Adds the collectors' steps to `place`; or gives the step at which the mul-div unit's other
  // operation ends.
  std::optional<int> find_collectors(const Unit& unit, const Lane& lane, Place& place) const {
    for (std::size_t i = 0; i < unit.ops.size(); ++i) {
      if (!mapping::starts_unit(mapping_.ops[unit.ops[i]].opcode)) continue;
      int last = place.ops[i];
      for (const OpId collector : unit.collectors) {
        if (mapping_.ops[collector].started_by != unit.ops[i]) continue;
        int step = std::max(last + 1, earliest(collector));
        for (const Edge& edge : graph_.in(collector)) {
          if (edge.before == unit.ops[i]) step = std::max(step, place.ops[i] + edge.latency);
        }
        const auto taken = [&](int s) {
          return !lane.free(s) ||
                 std::find(place.ops.begin(), place.ops.end(), s) != place.ops.end();
        };
        while (taken(step)) ++step;
        place.collectors.push_back(step);
        last = step;
      }
      if (const auto end = lane.conflict(place.ops[i], last)) return end;
    }
    return std::nullopt;
  }

  void place(int number) {
    const Unit& unit = mapping_.units[number];
    std::optional<Place> best;
    for (int slot = 0; slot < static_cast<int>(lanes_.size()); ++slot) {
      if (!allowed(number, slot)) continue;
      Place place = find(unit, slot);
      if (!best || place.end() < best->end()) best = std::move(place);
    }
    assert(best);
    commit(unit, *best);
    if (graph_.writers(number) >= 0) home_.try_emplace(graph_.writers(number), best->slot);
  }

  void commit(const Unit& unit, const Place& place) {
    Lane& lane = lanes_[place.slot];
    lane.own(place.ops.front(), place.ops.back());
    for (std::size_t i = 0; i < unit.ops.size(); ++i) {
      const OpId op = unit.ops[i];
      lane.put(place.ops[i], op);
      time_[op] = place.ops[i];
      if (mapping::starts_unit(mapping_.ops[op].opcode)) lane.busy[place.ops[i]] = place.ops[i];
    }
    for (std::size_t i = 0; i < unit.collectors.size(); ++i) {
      const OpId op = unit.collectors[i];
      lane.put(place.collectors[i], op);
      time_[op] = place.collectors[i];
      int& last = lane.busy[time_[mapping_.ops[op].started_by]];
      last = std::max(last, place.collectors[i]);
    }
  }

  // --- Home banks: the slot of the first unit that writes a device has its bank ---

  bool allowed(int unit, int slot) const {
    const auto found = home_.find(graph_.writers(unit));
    return !home_banks_ || found == home_.end() || found->second == slot;
  }

  Schedule result() const {
    std::size_t steps = 0;
    for (const Lane& lane : lanes_) steps = std::max(steps, lane.cells.size());
    Schedule schedule;
    schedule.steps.assign(steps, std::vector<OpId>(lanes_.size(), kNoOp));
    for (std::size_t slot = 0; slot < lanes_.size(); ++slot) {
      const auto& cells = lanes_[slot].cells;
      for (std::size_t step = 0; step < cells.size(); ++step)
        schedule.steps[step][slot] = cells[step];
    }
    return schedule;
  }

  const Graph& graph_;
  const Mapping& mapping_;
  const std::vector<std::int64_t>& priority_;
  bool home_banks_;
  std::vector<Lane> lanes_;
  std::vector<int> time_;
  std::map<int, int> home_;  // writers() of a unit -> slot
};

}  // namespace

Schedule in_order(const Mapping& mapping) {
  Schedule schedule;
  for (const Unit& unit : mapping.units) {
    for (const OpId op : unit.ops) schedule.steps.push_back({op});
    for (const OpId op : unit.collectors) schedule.steps.push_back({op});
  }
  return schedule;
}

Schedule search(const Problem& problem, const SearchOptions& options) {
  const Graph graph(problem);
  const auto units = static_cast<int>(problem.mapping->units.size());
  std::mt19937_64 random(options.seed);
  Schedule best;
  std::optional<std::pair<std::int64_t, std::int64_t>> best_cost;
  // A long program gets fewer tries, so that its compilation stays a matter of a second or two.
  const auto operations = static_cast<int>(problem.mapping->ops.size());
  const int tries = std::min(options.tries, std::max(4, kOperationsTried / (operations + 1)));
  for (int attempt = 0; attempt < tries; ++attempt) {
    // First by the longest chain alone, then with growing noise; ties in the order of the program.
    std::vector<std::int64_t> priority(units);
    const auto noise = static_cast<std::uint64_t>(attempt) * 2;
    for (int u = 0; u < units; ++u) {
      const auto tail = static_cast<std::int64_t>(graph.tail(u) * 4) +
                        static_cast<std::int64_t>(noise == 0 ? 0 : random() % (noise + 1));
      priority[u] = tail * (units + 1) + (units - u);
    }
    Schedule schedule = Attempt(graph, priority, options.home_banks).run();
    std::pair<std::int64_t, std::int64_t> cost(clocks(schedule, *problem.mapping, *problem.config),
                                               schedule.steps.size());
    if (options.by_steps) std::swap(cost.first, cost.second);
    if (!best_cost || cost < *best_cost) {
      best_cost = cost;
      best = std::move(schedule);
    }
    if (static_cast<int>(best.steps.size()) <= problem.lower_bound()) break;
  }
  return best;
}

}  // namespace rung::schedule
