// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <random>
#include <stdexcept>

#include "wide/schedule.hpp"

namespace rung::wide {
namespace {

using values::NodeKind;
using values::Values;
using values::Word;

// Items of all tries together, about.
constexpr int kItemsTried = 40000;

// How far each item is from the end of the scan.
std::vector<double> heights(const Order& order, const Work& work, double latency) {
  // Items in an order in which users come later.
  std::vector<std::int32_t> missing(order.items, 0);
  auto next = order.users;
  std::vector<std::vector<std::int32_t>> homes(order.items);
  for (const auto& [device, readers] : order.start_readers) {
    const std::int32_t home = order.home_item(work, device);
    for (const std::int32_t reader : readers) homes[reader].push_back(home);
  }
  for (int i = 0; i < order.items; ++i) {
    for (const std::int32_t to : next[i]) ++missing[to];
    for (const std::int32_t to : homes[i]) ++missing[to];
  }
  std::vector<std::int32_t> sorted;
  for (int i = 0; i < order.items; ++i) {
    if (missing[i] == 0) sorted.push_back(i);
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (const auto* to : {&next[sorted[i]], &homes[sorted[i]]}) {
      for (const std::int32_t each : *to) {
        if (--missing[each] == 0) sorted.push_back(each);
      }
    }
  }
  assert(static_cast<int>(sorted.size()) == order.items);
  std::vector<double> own(order.items, 0);
  for (std::size_t g = 0; g < work.groups.size(); ++g) {
    const Group& group = work.groups[g];
    int last = group.words.back().offset;
    for (const Group::Capture& each : group.captures) last = std::max(last, each.offset);
    own[order.item_of_group[g]] = last;
  }
  std::vector<double> height(order.items, 0);
  for (auto at = sorted.rbegin(); at != sorted.rend(); ++at) {
    double most = 0;
    for (const std::int32_t to : next[*at]) most = std::max(most, height[to] + latency);
    for (const std::int32_t to : homes[*at]) {
      most = std::max(most, height[to] - own[*at]);
    }
    height[*at] = most + own[*at];
  }
  return height;
}

// One schedule: step after step, what is most urgent takes a place where all it reads is there.
class List {
 public:
  List(const Work& work, const Values& values, const Machine& machine, const Order& order,
       std::vector<double> priority)
      : work_(work),
        values_(values),
        machine_(machine),
        order_(order),
        priority_(std::move(priority)) {
    out_.look_ups.resize(work.look_ups.size());
    out_.groups.resize(work.groups.size());
    home_unit_.assign(work.homes, kNone);
    home_units_.assign(work.homes, machine.units);
    for (const Group& group : work.groups) {
      int& units = home_units_[group.home];
      if (group.divides) units = std::min(units, machine.dividers);
      if (group.wide) units = 1;
    }
    unit_load_.assign(machine.units, 0);
    divider_.assign(machine.units, {});
    find_items();
  }

  // Nothing if it takes `limit` steps or more.
  bool run(int limit) {
    int left = order_.items;
    for (int step = 0; left > 0; ++step) {
      if (step >= limit) return false;
      ready_.insert(ready_.end(), fresh_.begin(), fresh_.end());
      fresh_.clear();
      std::stable_sort(ready_.begin(), ready_.end(),
                       [&](std::int32_t a, std::int32_t b) { return priority_[a] > priority_[b]; });
      std::size_t kept = 0;
      for (std::size_t i = 0; i < ready_.size(); ++i) {
        const std::int32_t item = ready_[i];
        if (place(item, step)) {
          --left;
          release(item);
        } else {
          ready_[kept++] = item;
        }
      }
      ready_.resize(kept);
    }
    return out_.steps <= limit;
  }

  Schedule take() { return std::move(out_); }

 private:
  struct Item {
    std::int32_t look_up = kNone;
    std::int32_t group = kNone;
    int waiting = 0;
  };

  void find_items() {
    items_.resize(order_.items);
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) {
      if (work_.look_ups[i].group == kNone) {
        items_[order_.item_of_look_up[i]].look_up = static_cast<std::int32_t>(i);
      }
    }
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      items_[order_.item_of_group[g]].group = static_cast<std::int32_t>(g);
    }
    homes_.resize(order_.items);
    homes_of_.resize(order_.items);
    for (const auto& [device, readers] : order_.start_readers) {
      const std::int32_t home = order_.home_item(work_, device);
      homes_of_[home].push_back(device);
      for (const std::int32_t reader : readers) homes_[reader].push_back(home);
    }
    for (int i = 0; i < order_.items; ++i) {
      for (const std::int32_t to : order_.users[i]) ++items_[to].waiting;
      for (const std::int32_t to : homes_[i]) ++items_[to].waiting;
    }
    for (int i = 0; i < order_.items; ++i) {
      if (items_[i].waiting == 0) fresh_.push_back(i);
    }
  }

  void release(std::int32_t item) {
    const std::vector<std::int32_t>* const followers[] = {&order_.users[item], &homes_[item]};
    for (const auto* to : followers) {
      for (const std::int32_t each : *to) {
        if (--items_[each].waiting == 0) fresh_.push_back(each);
      }
    }
  }

  bool place(std::int32_t item, int step) {
    const Item& what = items_[item];
    return what.look_up != kNone ? place_look_up(item, what.look_up, step)
                                 : place_group(item, what.group, step);
  }

  std::int32_t& slot(int step, int lane) { return at(slots_, step, machine_.slots, lane); }
  std::int32_t& unit(int step, int lane) { return at(units_, step, machine_.units, lane); }
  static std::int32_t& at(std::vector<std::vector<std::int32_t>>& table, int step, int width,
                          int lane) {
    while (static_cast<int>(table.size()) <= step) {
      table.emplace_back(static_cast<std::size_t>(width), kNone);
    }
    return table[step][lane];
  }

  // The first step at which a look-up in `lane` finds all its inputs.
  int inputs_ready(std::int32_t look_up, int lane) const {
    int ready = 0;
    const Cut& cut = work_.look_ups[look_up].cut;
    for (int k = 0; k < cut.size; ++k) {
      const std::int32_t from = work_.provider[cut.leaves[k]];
      if (from == look_up) continue;
      if (from == kNone) {
        const values::Node& node = values_.nodes[cut.leaves[k]];
        if (node.kind == NodeKind::Start) {
          ready = std::max(ready, work_.latch.ready(node.device, machine_));
        }
        continue;
      }
      const Place& place = out_.look_ups[from];
      if (place.step == kNone) continue;  // in the same group: its flag
      ready = std::max(ready, place.step + (place.lane == lane ? machine_.own : machine_.other));
    }
    return ready;
  }

  // Nobody reads an old value later than it is there.
  bool old_values_read(std::int32_t item, int step) const {
    for (const Device device : homes_of_[item]) {
      const auto found = last_read_.find(device);
      if (found != last_read_.end() && found->second > step + machine_.old) return false;
    }
    return true;
  }

  void note_reads(std::int32_t look_up, int step) {
    const Cut& cut = work_.look_ups[look_up].cut;
    for (int k = 0; k < cut.size; ++k) {
      const NodeId leaf = cut.leaves[k];
      if (work_.provider[leaf] != kNone || values_.nodes[leaf].kind != NodeKind::Start) continue;
      note_read(values_.nodes[leaf].device, step);
    }
  }
  void note_read(Device device, int step) {
    int& last = last_read_.try_emplace(device, step).first->second;
    last = std::max(last, step);
  }

  void put(std::int32_t look_up, int step, int lane) {
    slot(step, lane) = look_up;
    out_.look_ups[look_up] = {step, lane};
    out_.steps = std::max(out_.steps, step + 1);
    note_reads(look_up, step);
  }

  bool place_look_up(std::int32_t item, std::int32_t id, int step) {
    if (!old_values_read(item, step)) return false;
    // Slots beside no unit's gate first: a gate has one slot only.
    for (const int first : {1, 0}) {
      for (int lane = first; lane < machine_.slots; lane += 2) {
        if (slot(step, lane) != kNone || inputs_ready(id, lane) > step) continue;
        put(id, step, lane);
        return true;
      }
    }
    return false;
  }

  int word_ready(const Word& word, int lane) const {
    if (word.kind != Word::Kind::Result) return 0;
    const Work::Made& made = work_.made[word.operation][word.output];
    const Place place = out_.word(work_, made);
    return place.step + (place.lane == lane ? machine_.own : machine_.other);
  }

  bool look_up_fits(std::int32_t id, int step, int lane) {
    return step >= 0 && slot(step, lane) == kNone && inputs_ready(id, lane) <= step;
  }

  // The slot for a look-up that takes a flag, or kNone.
  int capture_lane(const Group::Capture& capture, int base, int unit) {
    const int step = base + capture.offset;
    for (const int lane : {2 * unit + 1, 2 * unit}) {
      if (look_up_fits(capture.look_up, step, lane)) return lane;
    }
    return kNone;
  }

  bool fits(const Group& group, int base, int lane) {
    if (group.divides) {
      for (const int start : divider_[lane]) {
        if (std::abs(start - base) < machine_.div_interval) return false;
      }
    }
    if (group.wide) {
      for (const int start : wide_) {
        if (std::abs(start - base) < constant::distance_wide_interval) return false;
      }
    }
    for (const WordWork& word : group.words) {
      const int step = base + word.offset;
      if (unit(step, lane) != kNone) return false;
      if (word_ready(word.s1, lane) > step || word_ready(word.s2, lane) > step) return false;
      if (word.keeps && word_ready(word.keep, lane) > step) return false;
      if (word.gate != kNone && !look_up_fits(word.gate, step - 1, 2 * lane)) return false;
      if (word.gather != kNone && !look_up_fits(word.gather, step, 2 * lane)) return false;
    }
    return std::all_of(group.captures.begin(), group.captures.end(),
                       [&](const auto& each) { return capture_lane(each, base, lane) != kNone; });
  }

  bool old_values_read(std::int32_t item, const Group& group, int base) const {
    for (const Device device : homes_of_[item]) {
      const auto found = last_read_.find(device);
      if (found == last_read_.end()) continue;
      int written = base;
      if (is_word(device)) {
        const Work::Made& made = work_.word_home.at(device);
        written += work_.groups[made.group].words[made.word].offset;
      } else {
        for (const Group::Capture& each : group.captures) {
          if (each.look_up == work_.bit_home.at(device)) written += each.offset;
        }
      }
      if (found->second > written + machine_.old) return false;
    }
    return true;
  }

  bool place_group(std::int32_t item, std::int32_t id, int step) {
    const Group& group = work_.groups[id];
    // The gate of its first instruction may be in this step.
    const int base = group.words.front().gate != kNone ? step + 1 : step;
    if (!old_values_read(item, group, base)) return false;
    int best = kNone;
    const int home = home_unit_[group.home];
    for (int lane = 0; lane < home_units_[group.home]; ++lane) {
      if (home != kNone && home != lane) continue;
      if (!fits(group, base, lane)) continue;
      if (best == kNone || unit_load_[lane] < unit_load_[best]) best = lane;
    }
    if (best == kNone) return false;
    home_unit_[group.home] = best;
    put(id, group, base, best);
    return true;
  }

  void put(std::int32_t id, const Group& group, int base, int lane) {
    out_.groups[id] = {base, lane};
    if (group.divides) divider_[lane].push_back(base);
    if (group.wide) wide_.push_back(base);
    unit_load_[lane] += static_cast<int>(group.words.size());
    for (const WordWork& word : group.words) {
      const int step = base + word.offset;
      unit(step, lane) = id;
      out_.steps = std::max(out_.steps, step + 1);
      if (word.gate != kNone) put(word.gate, step - 1, 2 * lane);
      if (word.gather != kNone) put(word.gather, step, 2 * lane);
      for (const Word* each : {&word.s1, &word.s2, &word.keep}) {
        if (each->kind == Word::Kind::Start) note_read(each->device, step);
      }
    }
    for (const Group::Capture& each : group.captures) {
      put(each.look_up, base + each.offset, capture_lane(each, base, lane));
    }
  }

  const Work& work_;
  const Values& values_;
  const Machine& machine_;
  const Order& order_;
  std::vector<double> priority_;
  Schedule out_;
  std::vector<Item> items_;
  std::vector<std::vector<std::int32_t>> homes_;  // by item: homes that it must come before
  std::vector<std::vector<Device>> homes_of_;     // by item: devices whose home it is
  std::vector<std::int32_t> ready_, fresh_;
  std::vector<std::vector<std::int32_t>> slots_, units_;
  std::vector<int> home_unit_, unit_load_;
  std::vector<int> home_units_;  // the first so many units can be a home's
  std::vector<std::vector<int>> divider_;
  std::vector<int> wide_;
  std::map<Device, int> last_read_;
};

}  // namespace

int Bounds::steps() const { return std::max({look_ups, words, dividers, dependence}); }

std::string_view Bounds::binding() const {
  if (steps() == dependence) return "dependence";
  if (steps() == words) return "word units";
  if (steps() == dividers) return "dividers";
  return "look-ups";
}

Bounds bounds(const Work& work, const Values& values, const Machine& machine) {
  Bounds out;
  const auto steps = [](std::size_t work, int places) {
    return static_cast<int>((work + static_cast<std::size_t>(places) - 1) /
                            static_cast<std::size_t>(places));
  };
  out.look_ups = steps(work.look_ups.size(), machine.slots);
  std::size_t words = 0;
  std::size_t divisions = 0;
  for (const Group& group : work.groups) {
    words += group.words.size();
    divisions += group.divides ? 1 : 0;
  }
  out.words = steps(words, machine.units);
  if (divisions > 0 && machine.dividers > 0) {
    out.dividers = (steps(divisions, machine.dividers) - 1) * machine.div_interval + machine.div;
  }
  const Order order = make_order(work, values);
  for (const double height : heights(order, work, machine.own)) {
    out.dependence = std::max(out.dependence, static_cast<int>(height) + 1);
  }
  return out;
}

Schedule search(const Work& work, const Values& values, const Machine& machine,
                const SearchOptions& options) {
  const Order order = make_order(work, values);
  const int least = bounds(work, values, machine).steps();
  Schedule best;
  int limit = 1 << 30;
  // Of a long program fewer: each takes longer, and there is less to gain.
  const int tries =
      std::clamp(kItemsTried / std::max(1, order.items), 1, std::max(1, options.tries));
  for (int i = 0; i < tries && limit > least; ++i) {
    static constexpr double kLatencies[] = {2, 3, 1, 2.5};
    std::vector<double> priority = heights(order, work, kLatencies[i % 4]);
    std::mt19937_64 random(options.seed + static_cast<std::uint64_t>(i));
    for (double& each : priority) {
      each += i < 4 ? 0 : static_cast<double>(random() % 1024) / 1024 * (1 + i % 8);
    }
    List list(work, values, machine, order, std::move(priority));
    if (!list.run(limit)) continue;
    best = list.take();
    limit = best.steps;
  }
  return best;
}

}  // namespace rung::wide
