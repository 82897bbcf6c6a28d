// SPDX-License-Identifier: Apache-2.0
#include "controller/simulated_controller.hpp"

#include <fmt/format.h>

#include <bit>
#include <stdexcept>

#include "Vcontroller_hx8k.h"
#include "Vcontroller_hx8k_bytes.h"
#include "Vcontroller_plant_bytes.h"
#include "Vcontroller_simulated.h"
#include "Vcontroller_simulated_bytes.h"
#include "controller/verilated_controller.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kClocksPerMs = RUNG_CLOCKS_PER_MS;
constexpr std::uint64_t kPlantClocksPerMs = RUNG_PLANT_CLOCKS_PER_MS;

// A W25Q32's typical times.
FlashTimes scaled_times(std::uint64_t clocks_per_ms) {
  return {.page_program = clocks_per_ms * 7 / 10,
          .sector_erase = clocks_per_ms * 45,
          .block_erase = clocks_per_ms * 150,
          .wake = 1};
}

// The controller's part ends there; a power of two that holds it.
std::size_t flash_bytes(const controller::Board& board) {
  const int sectors =
      board.flash_base + 2 * controller::flash_copy_sectors + controller::flash_ring_sectors;
  return std::bit_ceil(static_cast<std::size_t>(sectors) * controller::flash_sector_bytes);
}

const controller::Board& board_of(std::string_view name) {
  for (const controller::Board& board : controller::boards()) {
    if (board.name == name) return board;
  }
  throw std::runtime_error(fmt::format("board '{}': there is none; simulated or hx8k", name));
}

}  // namespace

std::vector<std::uint64_t> SimulatedController::built_clocks_per_ms() { return {kClocksPerMs}; }

std::unique_ptr<SimulatedController> SimulatedController::make(const ControllerSetup& setup) {
  const controller::Board& board = board_of(setup.board);
  const bool bytes = setup.line == ControllerSetup::Line::Bytes;
  const bool plant =
      setup.clocks_per_ms == kPlantClocksPerMs && setup.board == "simulated" && bytes;
  if (setup.clocks_per_ms != kClocksPerMs && !plant) {
    throw std::runtime_error(fmt::format("{} clocks a millisecond: the models are built with {}",
                                         setup.clocks_per_ms, kClocksPerMs));
  }
  const FlashTimes times = setup.flash_times.value_or(scaled_times(setup.clocks_per_ms));
  const auto make = [&]<typename Top, template <typename> typename Line>() {
    return std::make_unique<VerilatedController<Top, Line<Top>>>(board, setup, flash_bytes(board),
                                                                 times);
  };
  if (plant) return make.operator()<Vcontroller_plant_bytes, BytesOfLine>();
  if (setup.board == "simulated" && bytes) {
    return make.operator()<Vcontroller_simulated_bytes, BytesOfLine>();
  }
  if (setup.board == "hx8k" && bytes) return make.operator()<Vcontroller_hx8k_bytes, BytesOfLine>();
  if (setup.board == "simulated") return make.operator()<Vcontroller_simulated, PinsOfLine>();
  if (setup.board == "hx8k") return make.operator()<Vcontroller_hx8k, PinsOfLine>();
  throw std::runtime_error(
      fmt::format("board '{}': it is not simulated; simulated or hx8k", setup.board));
}

}  // namespace rung::tb
