// SPDX-License-Identifier: Apache-2.0
#include "reference/flow_run.hpp"
#include "rung_flow.hpp"
#include "view/engine.hpp"

namespace rung::view {
namespace {

class ReferenceEngine final : public Engine {
 public:
  ReferenceEngine(const Program& program, std::int64_t tick_us)
      : tick_us_(program.ldmicro ? program.ldmicro->cycle_us : tick_us),
        reference_(program, tick_us_),
        seen_(program.instructions.size()) {
    reference_.watch(seen_);
  }

  std::string name() const override { return "reference"; }
  void scan(std::span<const StimulusEvent> events) override {
    for (const StimulusEvent& event : events) reference_.set(event.device, event.value);
    reference_.run_scan();
  }
  std::int16_t value(Device device) override { return reference_.get(device); }
  const std::vector<Conduction>& seen() const override { return seen_; }
  std::vector<int> sent() const override { return reference_.sent(); }
  std::int64_t tick_us() const override { return tick_us_; }

 private:
  std::int64_t tick_us_;
  Reference reference_;
  std::vector<Conduction> seen_;
};

class FlowEngine final : public Engine {
 public:
  FlowEngine(const flowchart::Flowchart& chart, std::int64_t tick_us, const std::string& config)
      : tick_us_(tick_us),
        rounds_(chart, tick_us, config),
        seen_(chart.ladder.instructions.size()) {
    rounds_.watch(seen_);
  }

  std::string name() const override { return "reference"; }
  void scan(std::span<const StimulusEvent> events) override {
    while (!rounds_.requests().empty()) {
      rounds_.complete(rounds_.requests().front().id, flow::flow_status_no_reply);
    }
    for (const StimulusEvent& event : events) rounds_.set(event.device, event.value);
    rounds_.run_round();
  }
  std::int16_t value(Device device) override { return rounds_.get(device); }
  const std::vector<Conduction>& seen() const override { return seen_; }
  std::int64_t tick_us() const override { return tick_us_; }
  std::optional<FlowTaskState> task(std::size_t number) const override {
    return rounds_.task(number);
  }

 private:
  std::int64_t tick_us_;
  FlowRounds rounds_;
  std::vector<Conduction> seen_;
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine(const Program& program, std::int64_t tick_us) {
  return std::make_unique<ReferenceEngine>(program, tick_us);
}

std::unique_ptr<Engine> make_flow_engine(const flowchart::Flowchart& chart, std::int64_t tick_us,
                                         const std::string& config) {
  return std::make_unique<FlowEngine>(chart, tick_us, config);
}

}  // namespace rung::view
