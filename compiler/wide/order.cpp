// SPDX-License-Identifier: Apache-2.0
#include "wide/order.hpp"

#include <algorithm>
#include <cassert>

namespace rung::wide {
namespace {

using values::Values;
using values::Word;

template <typename T>
void make_unique(std::vector<T>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

// Strongly connected components, after Tarjan, without recursion.
class Components {
 public:
  explicit Components(const std::vector<std::vector<std::int32_t>>& next)
      : next_(next), of(next.size(), -1), index_(next.size(), -1), low_(next.size(), 0) {
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (index_[i] < 0) visit(static_cast<std::int32_t>(i));
    }
  }

 private:
  const std::vector<std::vector<std::int32_t>>& next_;

 public:
  std::vector<int> of;  // component of each

 private:
  struct Frame {
    std::int32_t at;
    std::size_t child;
  };

  void enter(std::int32_t at) {
    index_[at] = low_[at] = counter_++;
    open_.push_back(at);
    frames_.push_back({at, 0});
  }

  void visit(std::int32_t root) {
    enter(root);
    while (!frames_.empty()) {
      auto& [at, child] = frames_.back();
      if (child < next_[at].size()) {
        const std::int32_t to = next_[at][child++];
        if (index_[to] < 0) {
          enter(to);
        } else if (of[to] < 0) {
          low_[at] = std::min(low_[at], index_[to]);
        }
        continue;
      }
      const std::int32_t done = at;
      frames_.pop_back();
      if (!frames_.empty()) {
        low_[frames_.back().at] = std::min(low_[frames_.back().at], low_[done]);
      }
      if (low_[done] != index_[done]) continue;
      for (std::int32_t member = kNone; member != done;) {
        member = open_.back();
        open_.pop_back();
        of[member] = components_;
      }
      ++components_;
    }
  }

  std::vector<int> index_, low_;
  std::vector<std::int32_t> open_;
  std::vector<Frame> frames_;
  int counter_ = 0;
  int components_ = 0;
};

}  // namespace

std::int32_t Order::home_item(const Work& work, Device device) const {
  if (is_word(device)) return item_of_group[work.word_home.at(device).group];
  return item_of_look_up[work.bit_home.at(device)];
}

Order make_order(const Work& work, const Values& values) {
  Order order;
  order.item_of_look_up.assign(work.look_ups.size(), kNone);
  for (std::size_t i = 0; i < work.look_ups.size(); ++i) {
    if (work.look_ups[i].group == kNone) order.item_of_look_up[i] = order.items++;
  }
  for (std::size_t g = 0; g < work.groups.size(); ++g) {
    order.item_of_group.push_back(order.items++);
  }
  for (std::size_t i = 0; i < work.look_ups.size(); ++i) {
    const std::int32_t group = work.look_ups[i].group;
    if (group != kNone) order.item_of_look_up[i] = order.item_of_group[group];
  }
  order.users.resize(order.items);
  const auto use = [&](std::int32_t from, std::int32_t by) {
    if (from != by) order.users[from].push_back(by);
  };
  const auto read_start = [&](Device device, std::int32_t by) {
    const bool written =
        is_word(device) ? work.word_home.contains(device) : work.bit_home.contains(device);
    if (written && order.home_item(work, device) != by) order.start_readers[device].push_back(by);
  };
  for (std::size_t i = 0; i < work.look_ups.size(); ++i) {
    const std::int32_t by = order.item_of_look_up[i];
    const Cut& cut = work.look_ups[i].cut;
    for (int k = 0; k < cut.size; ++k) {
      const NodeId leaf = cut.leaves[k];
      const std::int32_t from = work.provider[leaf];
      if (from == static_cast<std::int32_t>(i)) continue;  // a flag's own look-up
      if (from != kNone) {
        use(order.item_of_look_up[from], by);
      } else if (values.nodes[leaf].kind == values::NodeKind::Start) {
        read_start(values.nodes[leaf].device, by);
      }
    }
  }
  for (std::size_t g = 0; g < work.groups.size(); ++g) {
    const std::int32_t by = order.item_of_group[g];
    const auto read = [&](const Word& word) {
      if (word.kind == Word::Kind::Result) {
        use(order.item_of_group[work.made[word.operation][word.output].group], by);
      } else if (word.kind == Word::Kind::Start) {
        read_start(word.device, by);
      }
    };
    for (const WordWork& word : work.groups[g].words) {
      read(word.s1);
      read(word.s2);
      if (word.keeps) read(word.keep);
    }
  }
  for (auto& users : order.users) make_unique(users);
  for (auto& [device, readers] : order.start_readers) make_unique(readers);
  return order;
}

void untangle(Work& work, const Values& values) {
  const Order order = make_order(work, values);
  auto next = order.users;
  for (const auto& [device, readers] : order.start_readers) {
    const std::int32_t home = order.home_item(work, device);
    for (const std::int32_t reader : readers) next[reader].push_back(home);
  }
  const Components components(next);
  for (const auto& [device, readers] : order.start_readers) {
    const std::int32_t home = order.home_item(work, device);
    const bool circle = std::any_of(readers.begin(), readers.end(), [&](std::int32_t reader) {
      return components.of[reader] == components.of[home];
    });
    if (!circle) continue;
    if (!is_word(device)) {
      std::int32_t& place = work.bit_home.at(device);
      LookUp copy;
      copy.cut.size = 1;
      copy.cut.leaves[0] = static_cast<NodeId>(work.provider.size());
      copy.cut.table = 0b10;
      copy.value = work.look_ups[place].value;
      copy.instruction = work.look_ups[place].instruction;
      work.provider.push_back(place);
      place = static_cast<std::int32_t>(work.look_ups.size());
      work.look_ups.push_back(copy);
      continue;
    }
    Work::Made& place = work.word_home.at(device);
    const WordWork& old = work.groups[place.group].words[place.word];
    WordWork copy;
    copy.opcode = Opcode::Mv;
    copy.s2.kind = Word::Kind::Result;
    copy.s2.operation = old.operation;
    copy.s2.output = old.output;
    copy.writes = true;
    copy.operation = static_cast<std::int32_t>(work.made.size());
    Group group;
    group.words = {copy};
    group.home = work.groups[place.group].home;
    group.instruction = work.groups[place.group].instruction;
    place = {static_cast<std::int32_t>(work.groups.size()), 0};
    work.made.push_back({place});
    work.groups.push_back(std::move(group));
  }
}

}  // namespace rung::wide
