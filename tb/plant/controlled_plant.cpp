// SPDX-License-Identifier: Apache-2.0
#include "plant/controlled_plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "controller/simulated_controller.hpp"
#include "device/flash_image.hpp"
#include "driver/compile.hpp"
#include "io/map.hpp"
#include "io/modbus_map.hpp"
#include "load/latency.hpp"
#include "load/load_file.hpp"
#include "melsec/melsec.hpp"
#include "plant/poller.hpp"
#include "reference/reference.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

// Small, as somebody who is in a hurry would have it.
constexpr int kExchangePoints = 64;
// What the silence between frames is made for; the line's bytes are behind the UART.
constexpr int kBaud = 9600;
// Of the model that is for hours (tb/controller/simulated.cmake).
constexpr std::uint64_t kClocksPerMs = RUNG_PLANT_CLOCKS_PER_MS;
// The plant moves when this many milliseconds are left before the next latch: its inputs have
// passed the filter (2 samples, a millisecond apart) when it comes.
constexpr int kLeadMs = 4;

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

Program read_program(const Plant& plant) {
  Diagnostics diagnostics;
  const std::string file = std::string(RUNG_REPOSITORY) + "/" + plant.program();
  const auto bytes = read_bytes(file, diagnostics);
  require(bytes.has_value(), file + " cannot be read");
  auto program =
      parse_melsec(decode_text(*bytes, file, diagnostics).value(), Dialect::Fx, diagnostics);
  require(program.has_value(), file + " is refused");
  return std::move(*program);
}

std::string map_text(const Plant& plant, const PlantRun& run, const controller::Board& board) {
  std::string text = fmt::format(
      "board = '{}'\n[controller]\nperiod_ms = {}\nexchange_points = {}\nfilter_us = 1000\n"
      "save_seconds = 60\n[modbus]\nbaud = {}\nparity = 'none'\n[inputs]\n",
      board.name, run.period_ms, kExchangePoints, kBaud);
  int pin = 0;
  for (const std::string& input : plant.inputs()) {
    text += fmt::format("{} = {{ pin = '{}', filter = 2 }}\n", input, board.inputs.at(pin++));
  }
  text += "[outputs]\n";
  pin = 0;
  for (const std::string& output : plant.outputs()) {
    text += fmt::format("{} = '{}'\n", output, board.outputs.at(pin++));
  }
  return text;
}

// The controller with the plant's program in its flash.
struct Bench {
  std::unique_ptr<SimulatedController> machine;
  std::int64_t cycle = 0;  // clocks of a scan, as the compiler says
};

Bench make_bench(const Plant& plant, const Program& program, const PlantRun& run) {
  const controller::Board* board = io::find_board(run.board);
  require(board != nullptr, "no board " + run.board);
  Diagnostics diagnostics;
  CompileOptions options;
  options.mpu = static_cast<isa::Mpu>(board->mpu);
  options.config = isa::find_config(board->config);
  const auto compiled = compile(program, options, diagnostics);
  require(compiled.has_value(), plant.program() + " does not compile");
  const auto map = io::parse_map(map_text(plant, run, *board), "plant.toml", diagnostics);
  require(map.has_value(), "the plant's I/O map is refused");
  const auto bindings = io::bind(*map, load::subject_of(compiled->image), diagnostics);
  ControllerSetup setup;
  setup.board = board->name;
  setup.clocks_per_ms = kClocksPerMs;
  setup.line = ControllerSetup::Line::Bytes;
  const auto clock_hz = static_cast<std::int64_t>(1000 * setup.clocks_per_ms);
  const auto words = load::make(compiled->image, bindings, clock_hz, diagnostics);
  require(words.has_value(), "no load file");
  Bench bench;
  bench.machine = SimulatedController::make(setup);
  device::put_program(bench.machine->flash().memory(), *board, *words);
  bench.cycle = load::timing_of(compiled->image, bindings, clock_hz).cycle;
  return bench;
}

std::vector<Device> devices(const std::vector<std::string>& names) {
  std::vector<Device> found;
  for (const std::string& name : names) {
    found.push_back(parse_device_name(name, Dialect::Fx).value());
  }
  return found;
}

std::uint64_t levels(const Reference& reference, const std::vector<Device>& of) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    bits |= std::uint64_t{reference.get(of[i]) != 0} << i;
  }
  return bits;
}

}  // namespace

PlantResult run_plant(Plant& plant, const PlantRun& run) {
  const Program program = read_program(plant);
  Bench bench = make_bench(plant, program, run);
  SimulatedController& machine = *bench.machine;
  Reference reference(program, std::int64_t{run.period_ms} * 1000);
  const std::vector<Device> inputs = devices(plant.inputs()), outputs = devices(plant.outputs());
  const std::uint64_t mask = (std::uint64_t{1} << outputs.size()) - 1;
  const std::uint64_t period = machine.clocks_per_ms() * static_cast<std::uint64_t>(run.period_ms);
  const std::uint64_t moves = period - kLeadMs * machine.clocks_per_ms();

  PlantResult result;
  result.expected_clocks = bench.cycle;
  require(static_cast<std::uint64_t>(bench.cycle) < moves, "the scan does not fit its period");
  while (machine.latches() == 0) {
    machine.run(1);
    require(machine.now() < 100'000 * machine.clocks_per_ms(), "the controller does not start");
  }
  const std::uint64_t start = machine.latched_at();
  Poller poller(machine, reference);
  std::uint64_t now_in = 0;
  for (std::int64_t ms = 0; ms < run.plant_ms && result.difference.empty(); ms += run.period_ms) {
    const std::uint64_t latch = start + static_cast<std::uint64_t>(result.scans) * period;
    if (machine.latched_at() != latch) {
      result.difference = fmt::format("scan {} began at clock {}, not {}", result.scans,
                                      machine.latched_at() - start, latch - start);
      break;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      reference.set(inputs[i], static_cast<std::int16_t>(now_in >> i & 1));
    }
    reference.run_scan();
    poller.scanned();
    ++result.scans;
    // In pieces, so that the client answers at once.
    const auto run_to = [&](std::uint64_t clock) {
      while (machine.now() < clock) {
        machine.run(std::min<std::uint64_t>(16, clock - machine.now()));
        poller.look();
      }
    };
    run_to(latch + moves);
    const std::uint64_t out = levels(reference, outputs);
    if ((machine.outputs() & mask) != out) {
      result.difference = fmt::format("scan {}: outputs {:b}, and the reference has {:b}",
                                      result.scans - 1, machine.outputs() & mask, out);
      break;
    }
    now_in = plant.step(out, run.period_ms);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      machine.set_input(static_cast<int>(i), (now_in >> i & 1) != 0);
    }
    run_to(latch + period);
    if (!plant.accident().empty()) result.difference = "accident: " + plant.accident();
    if (!poller.difference().empty()) result.difference = poller.difference();
  }
  result.clocks = machine.now() - start;
  result.clocks_per_ms = machine.clocks_per_ms();
  result.polls = poller.replies();
  poller.read_statistics(result);
  return result;
}

}  // namespace rung::tb
