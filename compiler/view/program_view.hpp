// SPDX-License-Identifier: Apache-2.0
// A program as it is looked at: its rungs as drawings, its devices with where they stand, and the
// flowcharts of its tasks. Made once; what changes while it runs is elsewhere (session.hpp).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flowchart/flowchart.hpp"
#include "reference/reference.hpp"
#include "view/grid.hpp"
#include "view/symbol.hpp"

namespace rung::view {

struct RungView {
  Network network;
  Grid grid;
  std::vector<Symbol> symbols;  // of grid.elements
  std::string note;             // the comment before it
  int line = 0;                 // in the source
};

struct DeviceView {
  Device device;
  std::string name;
  std::string comment;
  bool input = false;     // it is given from outside: X, an analogue channel
  std::vector<int> read;  // rungs
  std::vector<int> written;
};

// A task of a flow program.
struct StepView {
  std::string name;
  std::vector<std::string> lines;  // of the source
  std::vector<std::size_t> next;   // in Flowchart::steps
  std::size_t number = 0;
  bool added = false;
};
struct TaskView {
  std::string name;
  std::vector<StepView> steps;
};

class ProgramView {
 public:
  // `lines` is the source, for comments and steps; rungs longer than `columns` are turned. The
  // program must outlive this.
  ProgramView(const Program& program, const std::vector<std::string>& lines, int columns);
  ProgramView(const flowchart::Flowchart& chart, const std::vector<std::string>& lines,
              int columns);

  const Program& program() const { return program_; }
  const flowchart::Flowchart* chart() const { return chart_; }
  const std::vector<RungView>& rungs() const { return rungs_; }
  const std::vector<DeviceView>& devices() const { return devices_; }
  const std::vector<TaskView>& tasks() const { return tasks_; }
  Net nets() const { return nets_; }
  // Index of a device, or -1.
  int find(Device device) const;
  // By its name in either case, or its comment; the value of a timer by its own name, TN5.
  int find(std::string_view name) const;

  // Which nets have power after a scan in which the instructions did this.
  std::vector<bool> power(const std::vector<Conduction>& seen) const;

 private:
  void draw(const std::vector<std::string>& lines);
  void add_devices(const std::vector<Device>& devices);
  void add_tasks(const std::vector<std::string>& lines);

  const Program& program_;
  int columns_;
  const flowchart::Flowchart* chart_ = nullptr;
  std::vector<RungView> rungs_;
  std::vector<DeviceView> devices_;
  std::map<Device, int> by_device_;
  std::vector<TaskView> tasks_;
  Net nets_ = 0;
};

}  // namespace rung::view
