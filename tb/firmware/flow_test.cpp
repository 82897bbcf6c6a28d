// SPDX-License-Identifier: Apache-2.0
// What the firmware does for flow tasks: their spaces of a load file, their registers.
#include <string>

#include "bench.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
namespace f = rung::flow;

constexpr int kRegisters = f::holding_flow;
constexpr int kBusy = 6;

int address(int number) { return kRegisters + number - f::reg_flow_pc_resource; }

class Flow : public Bench {
 protected:
  void SetUp() override {
    if (!kFlow) GTEST_SKIP() << "this configuration has no flow tasks";
    install(sample_program(1).words());
  }
  std::uint16_t& at(int number) {
    return machine_->flow_registers.at(number - f::reg_flow_pc_resource);
  }
};

TEST_F(Flow, ALoadFileFillsTheirSpaces) {
  LoadFile file = sample_program(2);
  file.at(f::space_flow_steps, 5, 0x1234)
      .at(f::space_flow_transfers, 4 * 255 + 3, 77)
      .at(f::space_flow_tasks, 99, 0x8003)
      .at(f::space_flow_setup, f::flow_setup_enable, 1)
      .at(f::space_flow_setup, f::flow_first_board + f::flow_boards - 1, 9);
  ASSERT_EQ(download(file.words()), 2);
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_steps][5], 0x1234);
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_transfers][4 * 255 + 3], 77);
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_tasks][99], 0x8003);
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_setup][f::flow_setup_enable], 1);
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_setup][f::flow_first_board + f::flow_boards - 1],
            9);
}

// The next program has only the tasks and boards that it names.
TEST_F(Flow, NothingOfTheProgramBeforeIsLeft) {
  LoadFile file = sample_program(2);
  for (int n = 0; n < f::flow_tasks; ++n) file.at(f::space_flow_tasks, n, 0x8001);
  for (int n = 0; n < f::flow_boards; ++n) file.at(f::space_flow_setup, f::flow_first_board + n, 1);
  file.at(f::space_flow_setup, f::flow_setup_enable, 1);
  ASSERT_EQ(download(file.words()), 2);
  ASSERT_EQ(download(sample_program(3).at(f::space_flow_tasks, 7, 0x8002).words()), 2);
  for (int n = 0; n < f::flow_tasks; ++n) {
    EXPECT_EQ(machine_->flow_spaces[f::space_flow_tasks][n], n == 7 ? 0x8002 : 0) << n;
  }
  for (int n = 0; n < f::flow_boards; ++n) {
    EXPECT_EQ(machine_->flow_spaces[f::space_flow_setup][f::flow_first_board + n], 0) << n;
  }
  EXPECT_EQ(machine_->flow_spaces[f::space_flow_setup][f::flow_setup_enable], 0);
}

TEST_F(Flow, RegistersAreTheHardwares) {
  at(f::reg_flow_pool_full) = 0x1234;
  at(f::reg_panel_timeouts) = 0x5678;
  EXPECT_EQ(read(address(f::reg_flow_pool_full), f::reg_panel_timeouts - f::reg_flow_pool_full + 1)
                .front(),
            0x1234);
  EXPECT_EQ(holding(address(f::reg_panel_timeouts)), 0x5678);
  EXPECT_EQ(write(address(f::reg_flow_pc_resource), {0x0102, 3, 4, 1}), 0);
  EXPECT_EQ(at(f::reg_flow_pc_resource), 0x0102);
  EXPECT_EQ(at(f::reg_flow_pc_control), 1);
  at(f::reg_flow_pc_control) = 0;
  EXPECT_EQ(write(address(f::reg_flow_pc_data), Words(f::reg_flow_pc_data_count, 9)), 0);
  EXPECT_EQ(at(f::reg_flow_pc_data + f::reg_flow_pc_data_count - 1), 9);
  EXPECT_EQ(write(address(f::reg_flow_break_step), {12, 1, 3}), 0);
  EXPECT_EQ(at(f::reg_flow_task), 3);
  EXPECT_EQ(write(address(f::reg_flow_task_continue), {1}), 0);
  EXPECT_EQ(at(f::reg_flow_task_continue), 1);
}

TEST_F(Flow, ReadOnlyOnesAreNotWritten) {
  for (const int number : {f::reg_flow_task_state, f::reg_flow_task_step, f::reg_flow_pool_full,
                           f::reg_panel_timeouts}) {
    at(number) = 5;
    EXPECT_EQ(write(address(number), {1}), 2) << number;
    EXPECT_EQ(at(number), 5) << number;
  }
  // All of a request or nothing.
  EXPECT_EQ(write(address(f::reg_flow_break_step), {12, 1, 3, 4}), 2);
  EXPECT_EQ(at(f::reg_flow_break_step), 0);
  // Nothing is behind the last.
  EXPECT_EQ(write(kRegisters + f::holding_flow_count, {1}), 2);
}

TEST_F(Flow, ACommandUnderWayIsLeftAlone) {
  at(f::reg_flow_pc_control) = 2;
  EXPECT_EQ(write(address(f::reg_flow_pc_resource), {0x0102, 3, 4, 1}), kBusy);
  EXPECT_EQ(write(address(f::reg_flow_pc_data), {1}), kBusy);
  EXPECT_EQ(at(f::reg_flow_pc_resource), 0);
  EXPECT_EQ(write(address(f::reg_flow_break_step), {12, 1}), 0) << "others are not the command's";
}

}  // namespace
}  // namespace rung::tb
