// SPDX-License-Identifier: Apache-2.0
// Every program of tb/golden/programs against its golden trace, on every netlist beside its RTL.
#include "golden/golden.hpp"

#include <gtest/gtest.h>

#include "gate/netlists.hpp"

namespace rung::tb {
namespace {

using Parameter = std::tuple<NetlistInfo, std::string>;

class GateGolden : public testing::TestWithParam<Parameter> {
 protected:
  void run(const image::Image& image) {
    const NetlistInfo& netlist = std::get<0>(GetParam());
    const LoadedMachine loaded = load_netlist(netlist, image, program_.golden().header.tick_us);
    const QuietEnd quiet_end;
    const auto difference = program_.difference(image, *loaded.machine);
    ASSERT_FALSE(difference) << *difference;
    read_all(netlist, image, *loaded.processor);
    ++runs_;
  }

  GoldenProgram program_{std::get<1>(GetParam())};
  int runs_ = 0;
};

// An exception, which is how RTL and netlist differ, fails a test too.
TEST_P(GateGolden, Trace) {
  const NetlistInfo& netlist = std::get<0>(GetParam());
  const GateState before = gate_state;
  if (netlist.slots != 0) {
    for (const bool merge : {true, false}) {
      ASSERT_NO_FATAL_FAILURE(run(program_.compile_wide(netlist.slots, merge)));
    }
  } else {
    for (const bool paper : {false, true}) {
      if (paper && !program_.in_table_4()) continue;
      const auto image = program_.compile(netlist.mpu, paper, *netlist.config);
      if (!image) continue;
      ASSERT_NO_FATAL_FAILURE(run(*image));
    }
  }
  RecordProperty("netlist", netlist.name);
  RecordProperty("runs", runs_);
  RecordProperty("scans", static_cast<int>(runs_ * program_.golden().scans.size()));
  RecordProperty("clocks", std::to_string(gate_state.clocks - before.clocks));
  RecordProperty("answers", std::to_string(gate_state.answers - before.answers));
  RecordProperty("words", std::to_string(gate_state.words - before.words));
}

INSTANTIATE_TEST_SUITE_P(Netlists, GateGolden,
                         testing::Combine(testing::ValuesIn(netlists()),
                                          testing::ValuesIn(golden_names())),
                         [](const auto& info) {
                           std::string name =
                               std::get<0>(info.param).name + "_" + std::get<1>(info.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace rung::tb
