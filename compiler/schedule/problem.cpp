// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "schedule/schedule.hpp"

namespace rung::schedule {
namespace {

using isa::Opcode;
using logic::Version;
using mapping::BitValue;
using mapping::Destination;
using mapping::MappedOp;
using mapping::Mapping;
using mapping::OpId;
using mapping::Unit;

class Builder {
 public:
  Builder(const Mapping& mapping, const isa::Config& config, int slots) {
    problem_.mapping = &mapping;
    problem_.config = &config;
    problem_.slots = slots;
  }

  Problem build() {
    find_writers();
    for (std::size_t i = 0; i < ops().size(); ++i) add_reads(static_cast<OpId>(i));
    add_write_order();
    for (const Unit& unit : problem_.mapping->units) add_unit(unit);
    const auto count = static_cast<int>(ops().size());
    problem_.by_operations = (count + problem_.slots - 1) / problem_.slots;
    problem_.by_dependence = longest_chain();
    return std::move(problem_);
  }

 private:
  using Writers = std::map<Version, OpId>;

  const std::vector<MappedOp>& ops() const { return problem_.mapping->ops; }

  void edge(OpId before, OpId after, int latency) {
    problem_.edges.push_back({before, after, latency});
  }

  void find_writers() {
    temporaries_.assign(problem_.mapping->temporaries, mapping::kNoOp);
    for (std::size_t i = 0; i < ops().size(); ++i) {
      const Destination& to = ops()[i].destination;
      if (to.kind == Destination::Kind::Device)
        devices_[to.device][to.version] = static_cast<OpId>(i);
      for (const Device device : ops()[i].window)
        devices_[device][to.version] = static_cast<OpId>(i);
      if (to.kind == Destination::Kind::Temporary)
        temporaries_[to.temporary] = static_cast<OpId>(i);
    }
  }

  // The read comes after the write of its version and not after the next one.
  void add_read(OpId op, Device device, Version version) {
    const auto found = devices_.find(device);
    if (found == devices_.end()) return;
    const Writers& writers = found->second;
    const auto own = writers.find(version);
    if (own != writers.end()) edge(own->second, op, 1);
    const auto next = writers.upper_bound(version);
    if (next != writers.end() && next->second != op) edge(op, next->second, 0);
  }

  void add_reads(OpId id) {
    const MappedOp& op = ops()[id];
    for (const BitValue& input : op.inputs) {
      if (input.kind == BitValue::Kind::Device) add_read(id, input.device, input.version);
      if (input.kind == BitValue::Kind::Temporary) edge(temporaries_[input.temporary], id, 1);
    }
    for (const logic::Operand& operand : op.operands) {
      if (!operand.source.constant) add_read(id, operand.source.device, operand.version);
    }
    for (const logic::Read& read : op.reads) add_read(id, read.device, read.version);
  }

  void add_write_order() {
    for (const auto& [device, writers] : devices_) {
      for (auto later = writers.begin(), earlier = later++; later != writers.end();
           ++earlier, ++later) {
        edge(earlier->second, later->second, 1);
      }
    }
  }

  void add_unit(const Unit& unit) {
    OpId index = mapping::kNoOp;
    for (std::size_t i = 0; i < unit.ops.size(); ++i) {
      if (i > 0) edge(unit.ops[i - 1], unit.ops[i], 1);
      const Opcode opcode = ops()[unit.ops[i]].opcode;
      if (opcode == Opcode::Ix) index = unit.ops[i];
      if (mapping::uses_index(opcode)) edge(index, unit.ops[i], isa::constant::index_latency);
    }
    for (const OpId collector : unit.collectors) {
      const OpId start = ops()[collector].started_by;
      edge(start, collector, mapping::collect_latency(ops()[start].opcode, *problem_.config));
    }
    for (std::size_t i = 1; i < unit.collectors.size(); ++i) {
      edge(unit.collectors[i - 1], unit.collectors[i], 1);
    }
  }

  // Steps of the longest chain: levels of the graph, which has no cycle.
  int longest_chain() const {
    std::vector<int> pending(ops().size(), 0);
    std::vector<std::vector<const Edge*>> out(ops().size());
    for (const Edge& e : problem_.edges) {
      ++pending[e.after];
      out[e.before].push_back(&e);
    }
    std::vector<OpId> ready;
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (pending[i] == 0) ready.push_back(static_cast<OpId>(i));
    }
    std::vector<int> level(ops().size(), 0);
    int longest = 0;
    while (!ready.empty()) {
      const OpId op = ready.back();
      ready.pop_back();
      longest = std::max(longest, level[op] + 1);
      for (const Edge* e : out[op]) {
        level[e->after] = std::max(level[e->after], level[op] + e->latency);
        if (--pending[e->after] == 0) ready.push_back(e->after);
      }
    }
    return longest;
  }

  Problem problem_;
  std::map<Device, Writers> devices_;
  std::vector<OpId> temporaries_;
};

}  // namespace

Problem make_problem(const Mapping& mapping, const isa::Config& config, int slots) {
  return Builder(mapping, config, slots).build();
}

}  // namespace rung::schedule
