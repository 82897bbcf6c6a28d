// SPDX-License-Identifier: Apache-2.0
#include "device/server.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "device/console.hpp"

namespace rung::device {
namespace {

// Longest line of the console; what is longer is no command.
constexpr std::size_t kLine = 256;
// Runs between two looks at terminal, sockets and console. As fast as it goes, a client waits for
// them, so they are as short as their cost allows.
constexpr std::uint64_t kFastClocks = 500;

}  // namespace

Server::Server(BenchMachine& machine, const controller::Board& board, const ServerSetup& setup)
    : machine_(machine), board_(board), setup_(setup), terminal_(setup.link), line_(machine) {
  if (setup.tcp) gateway_ = std::make_unique<TcpGateway>(*setup.tcp, line_);
}

double Server::milliseconds(std::uint64_t clock) const {
  return static_cast<double>(clock) / static_cast<double>(machine_.clocks_per_ms());
}

void Server::run(const volatile std::sig_atomic_t& stop) {
  const std::uint64_t slice = machine_.clocks_per_ms();
  const std::uint64_t start = machine_.now();
  Pace pace(slice * 1000, Pace::Clock::now());
  while (stop == 0 && !quit_) {
    serve();
    std::uint64_t clocks = kFastClocks;
    if (!setup_.fast) {
      const auto now = Pace::Clock::now();
      clocks = std::min(pace.due(now, machine_.now() - start), slice);
      if (const auto lag = pace.report(now)) {
        fmt::print(setup_.errors,
                   "rung device: {:.0f} ms of the last {:.0f} ms behind real time, {:.0f} ms since "
                   "the start; fewer --clocks-per-ms, or --fast\n",
                   lag->lost_ms, lag->over_ms, lag->total_ms);
      }
    }
    if (clocks > 0) machine_.run(clocks);
    terminal_.write(line_.step());
    print_changes();
    if (!setup_.fast && clocks < slice) wait(pace.when(machine_.now() - start + slice));
  }
  std::fflush(setup_.out);
}

void Server::serve() {
  const std::vector<std::uint8_t> bytes = terminal_.read(line_.room());
  if (!bytes.empty()) line_.from_terminal(bytes);
  if (gateway_) gateway_->step();
  read_console();
}

void Server::wait(Pace::Clock::time_point until) {
  const auto left = until - Pace::Clock::now();
  if (left <= Pace::Clock::duration::zero()) return;
  std::vector<pollfd> polls;
  // A terminal that nobody has open would always be ready, with its hang-up.
  if (terminal_.open() && line_.room() > 0) polls.push_back({terminal_.descriptor(), POLLIN, 0});
  if (gateway_) gateway_->add_to(polls);
  if (setup_.console >= 0) polls.push_back({setup_.console, POLLIN, 0});
  const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(left).count();
  const timespec time{0, static_cast<long>(std::min<std::int64_t>(nanoseconds, 999'999'999))};
  ::ppoll(polls.data(), polls.size(), &time, nullptr);
}

void Server::read_console() {
  if (setup_.console < 0) return;
  pollfd state{setup_.console, POLLIN, 0};
  if (::poll(&state, 1, 0) <= 0) return;
  std::array<char, kLine> text{};
  const ssize_t got = ::read(setup_.console, text.data(), text.size());
  if (got <= 0) {
    // Its end, or a terminal that we are in the background of: the device runs on without it.
    if (got == 0 || errno != EINTR) setup_.console = -1;
    return;
  }
  typed_.append(text.data(), static_cast<std::size_t>(got));
  for (std::size_t end = 0; (end = typed_.find('\n')) != std::string::npos;) {
    const std::string line = typed_.substr(0, end);
    typed_.erase(0, end + 1);
    if (const auto error = command(line)) fmt::print(setup_.errors, "rung device: {}\n", *error);
  }
  if (typed_.size() > kLine) {
    fmt::print(setup_.errors, "rung device: a line of more than {} characters: left out\n", kLine);
    typed_.clear();
  }
  std::fflush(setup_.out);
}

std::optional<std::string> Server::command(std::string_view line) {
  auto parsed = parse_bench_command(line, board_);
  if (auto* error = std::get_if<std::string>(&parsed)) return std::move(*error);
  const BenchCommand& command = std::get<BenchCommand>(parsed);
  using Kind = BenchCommand::Kind;
  switch (command.kind) {
    case Kind::Nothing:
      break;
    case Kind::Input:
      machine_.set_input(command.index, command.value != 0);
      break;
    case Kind::Adc:
      machine_.set_adc(command.index, command.value);
      break;
    case Kind::Power:
      machine_.set_power(command.value != 0);
      break;
    case Kind::Switch:
      machine_.set_run_switch(command.value != 0);
      break;
    case Kind::Show:
      show();
      break;
    case Kind::Help:
      fmt::print(setup_.out, "{}", bench_help(board_));
      break;
    case Kind::Quit:
      quit_ = true;
      break;
  }
  return std::nullopt;
}

void Server::print_changes() {
  const std::vector<PinChange> changes = machine_.changes();
  if (!setup_.watch || changes.empty()) return;
  for (const PinChange& change : changes) {
    const std::string_view name = change.pin == PinChange::Pin::Output
                                      ? board_.outputs[static_cast<std::size_t>(change.index)]
                                  : change.pin == PinChange::Pin::Run   ? "RUN"
                                  : change.pin == PinChange::Pin::Fault ? "FAULT"
                                                                        : "FORCED";
    fmt::print(setup_.out, "{:.3f} ms {}={}\n", milliseconds(change.clock), name,
               change.level ? 1 : 0);
  }
  std::fflush(setup_.out);
}

void Server::show() const {
  std::string on;
  for (std::size_t i = 0; i < board_.outputs.size(); ++i) {
    if (machine_.output(static_cast<int>(i))) on += fmt::format(" {}", board_.outputs[i]);
  }
  using Pin = PinChange::Pin;
  fmt::print(setup_.out, "{:.3f} ms, {}{}{}{}; outputs that are 1:{}\n",
             milliseconds(machine_.now()), machine_.powered() ? "power on" : "power off",
             machine_.lamp(Pin::Run) ? ", RUN" : "", machine_.lamp(Pin::Fault) ? ", FAULT" : "",
             machine_.lamp(Pin::Forced) ? ", FORCED" : "", on.empty() ? " none" : on);
}

}  // namespace rung::device
