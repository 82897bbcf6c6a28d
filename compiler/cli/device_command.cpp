// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <system_error>

#include "cli/bound.hpp"
#include "controller/simulated_controller.hpp"
#include "device/console.hpp"
#include "device/flash_image.hpp"
#include "device/server.hpp"
#include "load/load_file.hpp"
#include "load/units.hpp"

namespace rung::cli {
namespace {

volatile std::sig_atomic_t stopped = 0;

void stop(int) { stopped = 1; }

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = stop;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = SIG_IGN;
  ::sigaction(SIGPIPE, &action, nullptr);  // of a --watch that nobody reads any more
  ::sigaction(SIGTTIN, &action, nullptr);  // in the background: runs on without its console
}

// The board to simulate: the options', the map's, or `simulated`.
std::string_view choose_board(const Options& options, const std::optional<io::Map>& map) {
  const std::string_view of_map = map ? map->board->name : std::string_view{};
  if (!options.board.empty() && map && options.board != of_map) {
    throw UsageError(fmt::format("--board {}: the I/O map is for {}", options.board, of_map));
  }
  const std::string_view board = !options.board.empty() ? std::string_view(options.board)
                                 : map                  ? of_map
                                                        : "simulated";
  if (board != "simulated" && board != "hx8k") {
    throw UsageError(
        fmt::format("{}: board {} is not simulated; 'simulated' has its processor and sizes",
                    options.io, board));
  }
  return io::find_board(board)->name;
}

// The load file of PROGRAM; nothing, with errors, if there is none.
std::optional<std::vector<std::uint16_t>> load_words(Options options,
                                                     const std::optional<io::Map>& map,
                                                     const controller::Board& board,
                                                     Diagnostics& diagnostics) {
  options.config = board.config;
  options.default_mpu = board.mpu;
  options.clock_hz = static_cast<std::int64_t>(1000 * options.clocks_per_ms);
  auto input = read_input(options, true, std::nullopt, diagnostics);
  if (!input) return std::nullopt;
  if (!input->image) {
    auto compiled = compile_input(*input, options, diagnostics);
    if (!compiled) return std::nullopt;
    input->image = std::move(compiled->image);
  }
  const image::Image& image = *input->image;
  const Bound bound = bind_image(image, map, options, diagnostics);
  if (bound.map.board != &board) {
    diagnostics.error(options.program, {},
                      fmt::format("there is no I/O map for board {}", board.name),
                      "give one with --io");
  }
  if (diagnostics.has_errors()) return std::nullopt;
  return load::make(image, bound.bindings, *options.clock_hz, diagnostics);
}

void read_flash(const Options& options, tb::FlashModel& flash) {
  if (options.flash.empty() || !std::filesystem::exists(options.flash)) return;
  if (!flash.load(options.flash)) {
    throw std::runtime_error(
        fmt::format("--flash {}: cannot be read, or is longer than the board's flash ({} bytes)",
                    options.flash, flash.memory().size()));
  }
}

// Whole or not at all: what was there stays until all of it is written.
void keep_flash(const Options& options, const tb::FlashModel& flash) {
  if (options.flash.empty()) return;
  const std::string part = fmt::format("{}.{}.part", options.flash, ::getpid());
  std::error_code error;
  bool kept = flash.save(part);
  if (kept) {
    std::filesystem::rename(part, options.flash, error);
    kept = !error;
  }
  if (!kept) {
    std::filesystem::remove(part, error);
    throw std::runtime_error(
        fmt::format("--flash {}: cannot be written; what was there is as it was", options.flash));
  }
}

// The firmware's start, reading the program from the flash, takes seconds of scaled time: it is
// simulated at full speed. It ends with a program that runs or a fault; one that waits to be
// started shows neither.
void boot(tb::SimulatedController& machine) {
  constexpr std::uint64_t kSlice = 1000;
  constexpr std::uint64_t kMost = 6'000'000;
  using Pin = device::PinChange::Pin;
  while (stopped == 0 && machine.now() < kMost && !machine.lamp(Pin::Run) &&
         !machine.lamp(Pin::Fault)) {
    machine.run(kSlice);
  }
}

void set_inputs(const Options& options, device::Server& server) {
  for (const std::string& input : options.inputs) {
    if (input.find('=') == std::string::npos) {
      throw UsageError(fmt::format("--inputs {}: write in0=1,adc0=512", input));
    }
    if (const auto error = server.command(input)) throw UsageError("--inputs: " + *error);
  }
}

void print_start(const Options& options, const controller::Board& board,
                 const device::Server& server) {
  const std::string& name = server.terminal().name();
  fmt::print("{} (MPU{}) on {}{}\n", board.title, board.mpu, name,
             options.link.empty() ? "" : fmt::format(", {}", options.link));
  if (const auto* gateway = server.gateway()) {
    fmt::print("Modbus TCP on 127.0.0.1:{}\n", gateway->port());
  }
  fmt::print("a simulated millisecond is {} clocks (rung load --clock {}), {}\n",
             options.clocks_per_ms, 1000 * options.clocks_per_ms,
             options.fast ? "as fast as it goes" : "in real time");
  fmt::print("ready\n");
  std::fflush(stdout);
}

}  // namespace

int device_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  const auto map = read_io(options, diagnostics);
  if (!options.io.empty() && !map) return report(diagnostics);
  const controller::Board& board = *io::find_board(choose_board(options, map));
  if (!given.config.empty() && given.config != board.config) {
    throw UsageError(
        fmt::format("--config {}: board {} has {}", given.config, board.name, board.config));
  }

  tb::ControllerSetup setup;
  setup.board = board.name;
  setup.clocks_per_ms = options.clocks_per_ms;
  const auto machine = tb::SimulatedController::make(setup);
  read_flash(options, machine->flash());
  if (!options.program.empty()) {
    const auto words = load_words(options, map, board, diagnostics);
    if (!words) return report(diagnostics);
    device::put_program(machine->flash().memory(), board, *words);
  }
  if (const int code = report(diagnostics); code != kDone) return code;
  if (options.baud) {
    const auto parity = options.parity == "none"  ? tb::Parity::None
                        : options.parity == "odd" ? tb::Parity::Odd
                                                  : tb::Parity::Even;
    machine->fix_line(
        static_cast<std::uint32_t>(load::baud_step(*options.baud, 1000 * options.clocks_per_ms)),
        parity);
  }

  catch_signals();
  device::ServerSetup serving;
  serving.link = options.link;
  if (options.tcp_port) serving.tcp = static_cast<std::uint16_t>(*options.tcp_port);
  serving.fast = options.fast;
  serving.watch = options.watch;
  serving.console = STDIN_FILENO;
  {
    device::Server server(*machine, board, serving);
    set_inputs(options, server);
    boot(*machine);
    print_start(options, board, server);
    server.run(stopped);
  }
  keep_flash(options, machine->flash());
  return kDone;
}

}  // namespace rung::cli
