// SPDX-License-Identifier: Apache-2.0
#include "flow_units/outside.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <stdexcept>

extern char** environ;

namespace rung::tb {
namespace {

constexpr int kPatienceMs = 30'000;  // a Python program starts within
constexpr int kSliceMs = 20;
constexpr std::uint8_t kException = 0x80;

std::runtime_error failure(const std::string& script, const std::string& what) {
  return std::runtime_error(fmt::format("{}: {}", script, what));
}

}  // namespace

std::size_t frame_length(std::span<const std::uint8_t> bytes, bool reply) {
  if (bytes.size() < 2) return 0;
  constexpr std::size_t kCrc = 2;
  if ((bytes[1] & kException) != 0) return 3 + kCrc;
  // Return query data: the probe of a client that has missed an answer, and its echo.
  if (bytes[1] == 8 || (reply ? bytes[1] == 16 : bytes[1] == 3)) return 6 + kCrc;
  const std::size_t count_at = reply ? 2 : 6;
  if (bytes.size() <= count_at) return 0;
  return count_at + 1 + bytes[count_at] + kCrc;
}

Outside::Outside(const std::string& script, const std::vector<std::string>& arguments)
    : script_(script), terminal_("") {
  std::vector<std::string> words{RUNG_REPOSITORY "/build/clients/bin/python",
                                 RUNG_REPOSITORY "/tb/flow_units/" + script, terminal_.name()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw failure(script_, "no pipe");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  const int error = ::posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  output_ = pipe[0];
  if (error != 0) {
    process_ = -1;
    ::close(output_);
    throw failure(script_,
                  fmt::format("cannot start {}: scripts/setup.sh test installs it", words[0]));
  }
  // A terminal that nobody has open loses what is written to it.
  for (int waited = 0; !terminal_.open(); waited += kSliceMs) {
    if (waited > kPatienceMs) throw failure(script_, "does not open its terminal");
    const auto early = terminal_.read(256);
    heard_.insert(heard_.end(), early.begin(), early.end());
    ::usleep(kSliceMs * 1000);
  }
}

Outside::~Outside() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (output_ >= 0) ::close(output_);
}

std::vector<std::uint8_t> Outside::read_frame(Side side) {
  for (int waited = 0; waited <= kPatienceMs; waited += kSliceMs) {
    const std::size_t length = frame_length(heard_, side == Side::Reply);
    if (length != 0 && heard_.size() >= length) {
      const auto end = heard_.begin() + static_cast<std::ptrdiff_t>(length);
      std::vector<std::uint8_t> frame(heard_.begin(), end);
      heard_.erase(heard_.begin(), end);
      return frame;
    }
    pollfd readable{.fd = terminal_.descriptor(), .events = POLLIN, .revents = 0};
    ::poll(&readable, 1, kSliceMs);
    const auto bytes = terminal_.read(256);
    if (!bytes.empty()) waited = 0;
    heard_.insert(heard_.end(), bytes.begin(), bytes.end());
  }
  int status = 0;
  const bool ended = ::waitpid(process_, &status, WNOHANG) == process_;
  if (ended) process_ = -1;
  throw failure(script_,
                fmt::format("{}{}", side == Side::Reply ? "does not answer" : "asks nothing",
                            ended ? fmt::format(", it has ended ({:#x})", status) : ""));
}

std::vector<std::uint8_t> Outside::ask(std::span<const std::uint8_t> request) {
  terminal_.write(request);
  try {
    return read_frame(Side::Reply);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{} to {:02x}", error.what(), fmt::join(request, " ")));
  }
}

std::vector<std::uint8_t> Outside::next_request() { return read_frame(Side::Request); }

void Outside::answer(std::span<const std::uint8_t> bytes) { terminal_.write(bytes); }

std::vector<std::string> Outside::said() {
  std::array<char, 4096> bytes{};
  for (;;) {
    pollfd readable{.fd = output_, .events = POLLIN, .revents = 0};
    if (::poll(&readable, 1, 0) <= 0 || (readable.revents & POLLIN) == 0) break;
    const ssize_t got = ::read(output_, bytes.data(), bytes.size());
    if (got <= 0) break;
    text_.append(bytes.data(), static_cast<std::size_t>(got));
  }
  std::vector<std::string> lines;
  for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n')) {
    lines.push_back(text_.substr(0, end));
    text_.erase(0, end + 1);
  }
  return lines;
}

}  // namespace rung::tb
