// SPDX-License-Identifier: Apache-2.0
#include "device/pseudo_terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace rung::device {
namespace {

std::runtime_error failure(const std::string& what) {
  return std::runtime_error(fmt::format("{}: {}", what, std::strerror(errno)));
}

// Opens the clients' side for a moment: its settings and its queues outlive each client.
void with_slave(const std::string& name, void (*action)(int)) {
  const int slave = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (slave < 0) throw failure(name);
  action(slave);
  ::close(slave);
}

void make_raw(int terminal) {
  termios settings{};
  ::tcgetattr(terminal, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(terminal, TCSANOW, &settings);
}

// Answers that the client did not take. Not its requests: they may be those of the next client
// already.
void drop_answers(int slave) { ::tcflush(slave, TCIFLUSH); }

void make_link(const std::string& name, const std::string& link) {
  struct stat found {};
  if (::lstat(link.c_str(), &found) == 0) {
    if (!S_ISLNK(found.st_mode)) {
      throw std::runtime_error(
          fmt::format("--link {}: is there and is no symbolic link; name another place", link));
    }
    ::unlink(link.c_str());
  }
  if (::symlink(name.c_str(), link.c_str()) != 0) throw failure("--link " + link);
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::string& link) {
  master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0) throw failure("no pseudo-terminal (is /dev/pts mounted?)");
  try {
    std::array<char, 128> name{};
    if (::grantpt(master_) != 0 || ::unlockpt(master_) != 0 ||
        ::ptsname_r(master_, name.data(), name.size()) != 0) {
      throw failure("no pseudo-terminal");
    }
    name_ = name.data();
    with_slave(name_, make_raw);
    if (!link.empty()) make_link(name_, link);
  } catch (...) {
    ::close(master_);
    throw;
  }
  link_ = link;
}

PseudoTerminal::~PseudoTerminal() {
  // Another device may have taken the name since.
  std::array<char, 128> target{};
  if (!link_.empty() && ::readlink(link_.c_str(), target.data(), target.size() - 1) > 0 &&
      name_ == target.data()) {
    ::unlink(link_.c_str());
  }
  ::close(master_);
}

void PseudoTerminal::find_state() {
  pollfd state{master_, 0, 0};
  ::poll(&state, 1, 0);
  const bool open = (state.revents & POLLHUP) == 0;
  if (open_ && !open) with_slave(name_, drop_answers);
  open_ = open;
  if (open) return;
  // A client may leave the terminal as it likes it, and may have come and gone unseen; the next one
  // starts from raw. The terminal's settings are those of both its sides.
  termios settings{};
  const tcflag_t cooked = ICANON | ECHO | ISIG | IEXTEN;
  if (::tcgetattr(master_, &settings) == 0 &&
      ((settings.c_lflag & cooked) != 0 || (settings.c_oflag & OPOST) != 0)) {
    make_raw(master_);
  }
}

std::vector<std::uint8_t> PseudoTerminal::read(std::size_t limit) {
  std::vector<std::uint8_t> bytes(limit);
  // What a client sent before it closed is still there to be read.
  const ssize_t got = limit == 0 ? 0 : ::read(master_, bytes.data(), bytes.size());
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  if (bytes.empty()) find_state();
  return bytes;
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
  find_state();
  if (!open_) return;
  while (!bytes.empty()) {
    const ssize_t put = ::write(master_, bytes.data(), bytes.size());
    if (put <= 0) {
      if (put < 0 && errno == EINTR) continue;
      lost_ += bytes.size();
      return;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
}

}  // namespace rung::device
