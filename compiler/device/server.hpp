// SPDX-License-Identifier: Apache-2.0
// `rung device`: a machine on a pseudo-terminal, with a TCP gateway and a console, in real time or
// as fast as it goes.
#pragma once

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "device/bench_machine.hpp"
#include "device/pace.hpp"
#include "device/pseudo_terminal.hpp"
#include "device/shared_line.hpp"
#include "device/tcp_gateway.hpp"
#include "rung_controller.hpp"

namespace rung::device {

struct ServerSetup {
  std::string link;
  std::optional<std::uint16_t> tcp;
  bool fast = false;
  bool watch = false;  // print every change of an output
  int console = -1;    // descriptor of the commands, -1: none
  std::FILE* out = stdout;
  std::FILE* errors = stderr;
};

class Server {
 public:
  // Throws std::runtime_error if terminal, link or port cannot be had.
  Server(BenchMachine& machine, const controller::Board& board, const ServerSetup& setup);

  const PseudoTerminal& terminal() const { return terminal_; }
  const TcpGateway* gateway() const { return gateway_.get(); }

  // Until `stop` is not 0 (a signal's handler sets it) or the console says so.
  void run(const volatile std::sig_atomic_t& stop);

  // A command, as from the console; an error's text, or nothing.
  std::optional<std::string> command(std::string_view line);

 private:
  void serve();
  void wait(Pace::Clock::time_point until);
  void read_console();
  void print_changes();
  void show() const;
  double milliseconds(std::uint64_t clock) const;

  BenchMachine& machine_;
  const controller::Board& board_;
  ServerSetup setup_;
  PseudoTerminal terminal_;
  SharedLine line_;
  std::unique_ptr<TcpGateway> gateway_;
  std::string typed_;
  bool quit_ = false;
};

}  // namespace rung::device
