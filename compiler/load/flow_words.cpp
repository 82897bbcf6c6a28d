// SPDX-License-Identifier: Apache-2.0
#include "load/flow_words.hpp"

#include <array>

#include "rung_flow.hpp"

namespace rung::load {
namespace {

constexpr std::uint32_t kRow = 4;  // words of a step or transfer
constexpr int kStartsWithProgram = 0x8000;

class Words {
 public:
  void set(int space, std::int64_t address, std::int64_t value) {
    out_.push_back(
        {space, static_cast<std::uint32_t>(address), static_cast<std::uint16_t>(value & 0xFFFF)});
  }
  void row(int space, std::size_t number, const std::array<int, kRow>& words) {
    for (std::uint32_t k = 0; k < kRow; ++k) {
      set(space, static_cast<std::int64_t>(kRow * number + k), words.at(k));
    }
  }
  std::vector<SpaceWord> take() { return std::move(out_); }

 private:
  std::vector<SpaceWord> out_;
};

}  // namespace

std::vector<SpaceWord> flow_words(const image::FlowImage& flow, const io::FlowSettings& settings,
                                  std::int64_t panel_step) {
  using namespace rung::flow;
  Words words;
  for (std::size_t i = 0; i < flow.steps.size(); ++i) {
    const image::FlowStep& step = flow.steps[i];
    words.row(space_flow_steps, i, {step.entry, step.end, step.read, step.write});
  }
  for (std::size_t i = 0; i < flow.transfers.size(); ++i) {
    const image::FlowTransfer& each = flow.transfers[i];
    const image::FlowBoard& board = flow.board_of(each);
    words.row(space_flow_transfers, i + 1,
              {board.unit << 8 | board.number, each.first, each.count, each.address});
  }
  for (std::size_t i = 0; i < flow.tasks.size(); ++i) {
    const image::FlowTask& task = flow.tasks[i];
    words.set(space_flow_tasks, static_cast<std::int64_t>(i),
              task.first | (task.starts ? kStartsWithProgram : 0));
  }
  const auto setup = [&](int number, std::int64_t value) {
    words.set(space_flow_setup, number, value);
  };
  setup(flow_setup_enable, settings.suspension ? 1 : 3);
  setup(flow_setup_unit, flow.unit);
  setup(flow_setup_next_word, flow.next_word);
  setup(flow_setup_task_word, flow.task_word);
  setup(flow_setup_status_word, flow.status_word);
  setup(flow_setup_link_timeout, settings.link_timeout_ms);
  setup(flow_setup_panel_timeout, settings.panel_timeout_ms);
  setup(flow_setup_panel_unit, settings.panel_unit);
  setup(flow_setup_panel_baud_low, panel_step);
  setup(flow_setup_panel_baud_high, panel_step >> 16);
  setup(flow_setup_panel_parity, static_cast<int>(settings.panel_parity));
  for (const image::FlowBoard& board : flow.boards) {
    if (board.unit == flow.unit) {
      setup(flow_first_board + board.number, image::FlowImage::bits(board));
    }
  }
  return words.take();
}

}  // namespace rung::load
