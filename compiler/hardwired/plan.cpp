// SPDX-License-Identifier: Apache-2.0
#include "hardwired/plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace rung::hardwired {
namespace {

using core::Op;
using logic::Action;
using logic::kNoNode;
using logic::kStart;
using logic::Logic;
using logic::Node;
using logic::NodeId;
using logic::NodeKind;
using logic::Version;

// Estimates in ns on an ECP5 of grade 6, wires included.
constexpr double kGate = 0.45;      // of two inputs, of which a LUT takes three
constexpr double kChoice = 1.0;     // of the old or the new word
constexpr double kUnitInput = 2.2;  // from an operand to the register of a unit that many share

double delay(const Action& action) {
  switch (action.op) {
    case Op::Out:
    case Op::Gather:
    case Op::Mov:
    case Op::Tb:
      return 0;
    case Op::Set:
    case Op::Rst:
      return kGate;
    case Op::Wand:
    case Op::Wor:
    case Op::Wxor:
      return 0.8;
    case Op::Add32:
    case Op::Sub32:
    case Op::Lt32:
    case Op::Minu:
      return 3.4;
    case Op::LoadWord:
    case Op::LoadBit:
      return 1.0 + 0.6 * std::log2(1.0 + static_cast<double>(action.reads.size()));
    case Op::StoreWord:
    case Op::SetBit:
    case Op::RstBit:
      return 2.0;
    default:
      return 2.4;
  }
}

bool is_bit_action(Op op) {
  return core::is_coil(op) || op == Op::LoadBit || op == Op::SetBit || op == Op::RstBit;
}

// Calls `value` with what a leaf reads, `inner` with the nodes right under any other node.
template <typename Values, typename Nodes>
void children(const Node& node, Values&& value, Nodes&& inner) {
  if (node.kind == NodeKind::Leaf) return value(node.device, node.version);
  inner(node.left);
  if (node.kind == NodeKind::And || node.kind == NodeKind::Or) inner(node.right);
}

// Whether the old value of a target is a part of the new one.
bool keeps(const Action& action) {
  switch (action.op) {
    case Op::Out:
      return false;
    case Op::StoreWord:
    case Op::SetBit:
    case Op::RstBit:
    case Op::Div:
    case Op::Div32:
      return true;
    default:
      return action.condition != kNoNode;
  }
}

// Marks what the values at the scan's end are made of.
class Liveness {
 public:
  Liveness(const Logic& logic, const Interface& interface, Plan& plan)
      : logic_(logic), interface_(interface), plan_(plan), nodes_(logic.nodes.size(), false) {}

  void run() {
    for (const Action& action : logic_.actions)
      plan_.live.emplace_back(action.targets.size(), false);
    for (const Device device : interface_.state) end_of(device);
    for (std::size_t i = 0; i < logic_.actions.size(); ++i) {
      // The error flag sees every division.
      const Op op = logic_.actions[i].op;
      if (op == Op::Div || op == Op::Div32) inputs(i);
    }
    while (!work_.empty()) {
      const auto [device, version] = work_.back();
      work_.pop_back();
      if (version == kStart) {
        if (interface_.start(device).kind == Start::Kind::Register) end_of(device);
        continue;
      }
      const Action& action = logic_.actions[version];
      inputs(version);
      if (keeps(action)) value(device, logic_.current(device, version));
    }
    for (std::size_t i = 0; i < logic_.actions.size(); ++i) {
      for (std::size_t t = 0; t < plan_.live[i].size(); ++t) {
        if (plan_.live[i][t]) {
          plan_.versions[logic_.actions[i].targets[t]].push_back(static_cast<Version>(i));
        }
      }
    }
  }

 private:
  void end_of(Device device) { value(device, logic_.current(device, logic::kNever)); }

  void value(Device device, Version version) {
    if (version == kStart) {
      if (!starts_.insert(device).second) return;
    } else {
      const auto& targets = logic_.actions[version].targets;
      const auto place = std::find(targets.begin(), targets.end(), device) - targets.begin();
      if (plan_.live[version][place]) return;
      plan_.live[version][place] = true;
    }
    work_.emplace_back(device, version);
  }

  void inputs(std::size_t index) {
    const Action& action = logic_.actions[index];
    if (action.condition != kNoNode) node(action.condition);
    for (const logic::Operand& operand : action.operands) {
      if (!operand.source.constant) value(operand.source.device, operand.version);
    }
    for (const logic::Read& read : action.reads) value(read.device, read.version);
  }

  void node(NodeId id) {
    std::vector<NodeId> open{id};
    while (!open.empty()) {
      const NodeId next = open.back();
      open.pop_back();
      if (nodes_[next]) continue;
      nodes_[next] = true;
      children(
          logic_.nodes[next], [&](Device d, Version v) { value(d, v); },
          [&](NodeId inner) { open.push_back(inner); });
    }
  }

  const Logic& logic_;
  const Interface& interface_;
  Plan& plan_;
  std::vector<bool> nodes_;
  std::set<Device> starts_;
  std::vector<std::pair<Device, Version>> work_;
};

// One action after the other, in the order of the program, each as early as it can be.
class Scheduler {
 public:
  Scheduler(const Logic& logic, const Interface& interface, double step_ns, Plan& plan)
      : logic_(logic), interface_(interface), step_ns_(step_ns), plan_(plan) {
    plan_.issue.assign(logic.actions.size(), -1);
    plan_.clock.assign(logic.actions.size(), -1);
    arrival_.assign(logic.actions.size(), 0);
    trees_.resize(logic.nodes.size());
    const bool words = std::any_of(logic.actions.begin(), logic.actions.end(),
                                   [](const Action& action) { return !is_bit_action(action.op); });
    if (!words) step_ns_ = std::numeric_limits<double>::infinity();
  }

  void run() {
    for (std::size_t i = 0; i < logic_.actions.size(); ++i) {
      const Action& action = logic_.actions[i];
      const bool needed =
          std::find(plan_.live[i].begin(), plan_.live[i].end(), true) != plan_.live[i].end();
      const bool divides = action.op == Op::Div || action.op == Op::Div32;
      if (!needed && !divides) continue;
      if (unit_of(action.op) != nullptr) {
        through_unit(i);
      } else {
        at_once(i);
      }
      plan_.clocks = std::max(plan_.clocks, plan_.clock[i] + 1);
    }
  }

 private:
  // The values that meet in one place: the first clock in which all are there, how long the last
  // of them takes in that clock, and how long if all come from registers.
  struct Meeting {
    std::int32_t clock = 0;
    double late = 0;
    double early = 0;

    double at(std::int32_t when) const { return when > clock ? early : late; }
    void add(std::int32_t made, double then, double after) {
      if (made > clock) {
        clock = made;
        late = std::max(early, then);
      } else if (made == clock) {
        late = std::max(late, then);
      } else {
        late = std::max(late, after);
      }
      early = std::max(early, after);
    }
    void add(const Meeting& other) { add(other.clock, other.late, other.early); }
    void through(double ns) {
      late += ns;
      early += ns;
    }
  };

  void add(Meeting& meeting, Device device, Version version) const {
    const std::int32_t made = plan_.made(device, version, interface_);
    meeting.add(made, version == kStart ? 0 : arrival_[version], 0);
  }

  const Meeting& tree(NodeId root) {
    std::vector<NodeId> open{root};
    while (!open.empty()) {
      const NodeId id = open.back();
      if (trees_[id].second) {
        open.pop_back();
        continue;
      }
      const Node& node = logic_.nodes[id];
      Meeting meeting;
      bool ready = true;
      children(
          node, [&](Device d, Version v) { add(meeting, d, v); },
          [&](NodeId inner) {
            if (!trees_[inner].second) {
              open.push_back(inner);
              ready = false;
            } else {
              meeting.add(trees_[inner].first);
            }
          });
      if (!ready) continue;
      if (node.kind == NodeKind::And || node.kind == NodeKind::Or) meeting.through(kGate);
      trees_[id] = {meeting, true};
      open.pop_back();
    }
    return trees_[root].first;
  }

  Meeting operands(const Action& action) const {
    Meeting meeting;
    for (const logic::Operand& operand : action.operands) {
      if (!operand.source.constant) add(meeting, operand.source.device, operand.version);
    }
    for (const logic::Read& read : action.reads) add(meeting, read.device, read.version);
    return meeting;
  }

  // The condition, and the values that the action's targets have before it.
  Meeting before(std::size_t i) {
    const Action& action = logic_.actions[i];
    Meeting meeting;
    if (action.condition != kNoNode) meeting.add(tree(action.condition));
    for (std::size_t t = 0; t < action.targets.size(); ++t) {
      if (!plan_.live[i][t]) continue;
      const Device device = action.targets[t];
      if (keeps(action)) {
        add(meeting, device, logic_.current(device, static_cast<std::int32_t>(i)));
      }
      // Values of one device come in their order, whether they are read or not.
      const auto& versions = plan_.versions[device];
      const auto next = std::lower_bound(versions.begin(), versions.end(), static_cast<Version>(i));
      if (next != versions.begin()) {
        meeting.add(plan_.made(device, *std::prev(next), interface_), 0, 0);
      }
    }
    return meeting;
  }

  void at_once(std::size_t i) {
    const Action& action = logic_.actions[i];
    Meeting meeting = operands(action);
    meeting.through(delay(action));
    meeting.add(before(i));
    if (keeps(action) && !core::is_coil(action.op)) meeting.through(kChoice);
    std::int32_t clock = meeting.clock;
    if (meeting.late > step_ns_ && meeting.late > meeting.early) ++clock;
    plan_.issue[i] = plan_.clock[i] = clock;
    arrival_[i] = meeting.at(clock);
  }

  void through_unit(std::size_t i) {
    const Action& action = logic_.actions[i];
    const Unit& unit = *unit_of(action.op);
    Meeting meeting = operands(action);
    meeting.through(kUnitInput);
    Meeting end = before(i);
    end.through(kChoice);
    std::set<std::int32_t>& taken = taken_[unit.op];
    std::int32_t issue = std::max(meeting.clock, end.clock - unit.latency);
    if (meeting.at(issue) > step_ns_ && meeting.at(issue) > meeting.early) ++issue;
    if (end.at(issue + unit.latency) > step_ns_ && end.clock == issue + unit.latency) ++issue;
    while (!taken.insert(issue).second) ++issue;
    plan_.issue[i] = issue;
    plan_.clock[i] = issue + unit.latency;
    arrival_[i] = std::max(kChoice, end.at(plan_.clock[i]));
  }

  const Logic& logic_;
  const Interface& interface_;
  double step_ns_;
  Plan& plan_;
  std::vector<double> arrival_;  // of each action's value in its clock
  std::vector<std::pair<Meeting, bool>> trees_;
  std::map<Op, std::set<std::int32_t>> taken_;
};

}  // namespace

const Unit* unit_of(Op op) {
  const auto* found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& unit) { return unit.op == op; });
  return found == kUnits.end() ? nullptr : found;
}

std::int32_t Plan::made(Device device, Version version, const Interface& interface) const {
  if (version != kStart) return clock[version];
  return interface.start(device).kind == Start::Kind::Given ? 0 : -1;
}

std::int32_t Plan::kept(Device device, Version version) const {
  const auto found = versions.find(device);
  if (found == versions.end()) return logic::kNever;
  const auto next = std::upper_bound(found->second.begin(), found->second.end(), version);
  return next == found->second.end() ? logic::kNever : clock[*next];
}

bool Plan::is_live(Device device, Version version) const {
  const auto found = versions.find(device);
  return found != versions.end() &&
         std::binary_search(found->second.begin(), found->second.end(), version);
}

Plan plan(const Logic& logic, const Interface& interface, double step_ns) {
  Plan plan;
  Liveness(logic, interface, plan).run();
  Scheduler(logic, interface, step_ns, plan).run();
  return plan;
}

}  // namespace rung::hardwired
