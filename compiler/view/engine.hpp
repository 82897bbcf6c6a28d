// SPDX-License-Identifier: Apache-2.0
// What a view looks at while it runs: the reference, a processor, or a controller at the other end
// of a line.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/flow_rounds.hpp"
#include "reference/reference.hpp"
#include "trace/stimulus.hpp"
#include "view/recording.hpp"

namespace rung::view {

struct Forced {
  Device device;
  std::int16_t value = 0;
};

class Engine {
 public:
  virtual ~Engine() = default;

  // "reference", "mpu3", ...
  virtual std::string name() const = 0;
  // One scan: these devices get their values just before it. Of a controller: they are written,
  // then all devices are read once. Throws what people are to be told.
  virtual void scan(std::span<const StimulusEvent> events) = 0;
  virtual std::int16_t value(Device device) = 0;
  // What each instruction did in the last scan.
  virtual const std::vector<Conduction>& seen() const = 0;
  // Clocks of the last scan; nothing if the engine has none.
  virtual std::optional<std::uint32_t> clocks() const { return std::nullopt; }
  // The bytes that the program's UART was given in the last scan.
  virtual std::vector<int> sent() const { return {}; }
  // From scan to scan.
  virtual std::int64_t tick_us() const = 0;
  virtual std::optional<FlowTaskState> task(std::size_t /*number*/) const { return std::nullopt; }

  // Of an engine that records what is inside of its processors.
  virtual const std::vector<RecordedProcessor>& recordings() const {
    static const std::vector<RecordedProcessor> kNone;
    return kNone;
  }

  // A controller runs by itself, and keeps its forces itself.
  virtual bool is_live() const { return false; }
  virtual void force(Device /*device*/, std::optional<std::int16_t> /*value*/) {}
  virtual std::vector<Forced> forces() { return {}; }
  enum class Order { Run, Stop, Scan };
  virtual void order(Order /*order*/) {}
  // What it says of itself: "running", "stopped", ...
  virtual std::string state() { return {}; }
};

// The reference alone. `program` must outlive it.
std::unique_ptr<Engine> make_reference_engine(const Program& program, std::int64_t tick_us);
// Rounds of flow tasks on the reference; there is nothing behind their links.
std::unique_ptr<Engine> make_flow_engine(const flowchart::Flowchart& chart, std::int64_t tick_us,
                                         const std::string& config);

// What the instructions of a scan would do if the devices had these values throughout; edges, which
// no value shows, conduct nowhere. For what only its devices are known of.
void conduct(const Program& program, const std::function<std::int16_t(Device)>& value,
             std::vector<Conduction>& seen);

}  // namespace rung::view
