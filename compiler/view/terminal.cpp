// SPDX-License-Identifier: Apache-2.0
#include "view/terminal.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <utility>

namespace rung::view {
namespace {

volatile std::sig_atomic_t stopped = 0;
void stop(int /*signal*/) { stopped = 1; }

// The terminal takes single keys, on a screen of its own, until this ends.
class Screen {
 public:
  Screen() {
    tcgetattr(STDIN_FILENO, &before_);
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    write("\x1b[?1049h\x1b[?25l");
  }
  ~Screen() {
    write("\x1b[?7h\x1b[?25h\x1b[?1049l");
    tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  static void write(const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
      const ssize_t done = ::write(STDOUT_FILENO, text.data() + at, text.size() - at);
      if (done <= 0) return;
      at += static_cast<std::size_t>(done);
    }
  }
  static winsize size() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row < 4 || size.ws_col < 20) {
      size.ws_row = 24;
      size.ws_col = 80;
    }
    return size;
  }
  // The next key, 0 if none came in time.
  static int key(int milliseconds) {
    pollfd ready{STDIN_FILENO, POLLIN, 0};
    if (::poll(&ready, 1, milliseconds) <= 0) return 0;
    unsigned char c = 0;
    return ::read(STDIN_FILENO, &c, 1) == 1 ? c : -1;
  }

 private:
  termios before_{};
};

constexpr int kUp = 0x100, kDown = 0x101, kPageUp = 0x102, kPageDown = 0x103;
constexpr const char* kHelp =
    " space scan, r run, f fast, p pause, x toggle, = set, ! force, b break, / find, 0, q";

// Escape sequences of the keys that move.
int read_key(int milliseconds) {
  const int key = Screen::key(milliseconds);
  if (key != 27) return key;
  if (Screen::key(5) != '[') return 27;
  switch (const int code = Screen::key(5)) {
    case 'A':
      return kUp;
    case 'B':
      return kDown;
    case '5':
    case '6':
      Screen::key(5);
      return code == '5' ? kPageUp : kPageDown;
    default:
      return 0;
  }
}

class Terminal {
 public:
  explicit Terminal(std::unique_ptr<Run> run) : session_(std::move(run)) {}

  void show() {
    constexpr int kPaint = 50;  // milliseconds
    Screen screen;
    while (stopped == 0) {
      paint();
      const int key = read_key(kPaint);
      if (key < 0 || key == 'q') return;
      if (asked_ != 0) {
        edit(key);
      } else if (key != 0) {
        command(key);
      }
    }
  }

 private:
  void paint() {
    const winsize size = Screen::size();
    std::vector<int> rung_of;
    std::string head;
    std::vector<std::string> lines;
    session_.call([&](Run& run) {
      lines = ladder_text(run, {true}, &rung_of);
      head = fmt::format(" {}  {}  scan {}{}{}{}",
                         std::filesystem::path(run.view().program().file).filename().string(),
                         run.engine().name(), run.scans(),
                         run.mode() == Mode::Paused     ? "  paused"
                         : run.mode() == Mode::RealTime ? "  real time"
                                                        : "  fast",
                         run.engine().is_live() ? "  " + run.engine().state() : "",
                         run.message().empty() ? "" : "  " + run.message());
      for (const auto& [device, value] : run.forced()) {
        head += fmt::format("  !{}={}", run.view().devices()[static_cast<std::size_t>(device)].name,
                            value);
      }
      return 0;
    });
    rung_of_ = std::move(rung_of);
    const int room = size.ws_row - 2;
    top_ = std::clamp(top_, 0, std::max(0, static_cast<int>(lines.size()) - room));
    // A line that is too long is cut by the terminal; bars have no sequences in them and are cut
    // here.
    const auto bar = [&](const std::string& line) {
      return "\x1b[7m" + line.substr(0, size.ws_col) + "\x1b[K\x1b[0m";
    };
    std::string text = "\x1b[?7l\x1b[H" + bar(head) + "\r\n";
    for (int i = 0; i < room; ++i) {
      if (top_ + i < static_cast<int>(lines.size())) {
        text += lines[static_cast<std::size_t>(top_ + i)];
      }
      text += "\x1b[K\r\n";
    }
    Screen::write(text + bar(asked_ != 0     ? question()
                             : note_.empty() ? std::string(kHelp)
                                             : " " + note_));
  }

  std::string question() const {
    const char* what = asked_ == '/'   ? "find device"
                       : asked_ == 'x' ? "toggle device"
                       : asked_ == '=' ? "set DEVICE=VALUE"
                       : asked_ == '!' ? "force DEVICE=VALUE, release DEVICE="
                                       : "break on a change of DEVICE, or on DEVICE=VALUE";
    return fmt::format(" {}: {}_", what, answer_);
  }

  void command(int key) {
    note_.clear();
    const int page = Screen::size().ws_row - 4;
    switch (key) {
      case ' ':
        return send([](Run& run) { run.step(1); });
      case 'r':
        return send([](Run& run) { run.set_mode(Mode::RealTime); });
      case 'f':
        return send([](Run& run) {
          if (!run.engine().is_live()) run.set_mode(Mode::Fast);
        });
      case 'p':
        return send([](Run& run) { run.set_mode(Mode::Paused); });
      case '0':
        return send([](Run& run) { run.restart(run.engine().name()); });
      case kUp:
      case 'k':
        --top_;
        return;
      case kDown:
      case 'j':
        ++top_;
        return;
      case kPageUp:
        top_ -= page;
        return;
      case kPageDown:
        top_ += page;
        return;
      case '/':
      case 'x':
      case '=':
      case '!':
      case 'b':
        asked_ = key;
        answer_.clear();
        return;
      default:
        return;
    }
  }

  void edit(int key) {
    constexpr std::size_t kLongest = 60;
    if (key == '\n' || key == '\r') {
      const int asked = std::exchange(asked_, 0);
      if (!answer_.empty()) answer(asked);
    } else if (key == 27) {
      asked_ = 0;
    } else if (key == 127 || key == 8) {
      if (!answer_.empty()) answer_.pop_back();
    } else if (key >= ' ' && key < 0x100 && answer_.size() < kLongest) {
      answer_ += static_cast<char>(key);
    }
  }

  // DEVICE or DEVICE=VALUE
  void answer(int asked) {
    const std::size_t equals = answer_.find('=');
    const std::string name = answer_.substr(0, equals);
    std::optional<std::int16_t> value;
    if (equals != std::string::npos && equals + 1 < answer_.size()) {
      std::int16_t number = 0;
      const char* end = answer_.data() + answer_.size();
      const auto [at, error] = std::from_chars(answer_.data() + equals + 1, end, number);
      if (error != std::errc{} || at != end) {
        note_ = fmt::format("{}: a number from -32768 to 32767", answer_);
        return;
      }
      value = number;
    }
    send([&](Run& run) {
      const int device = run.view().find(std::string_view(name));
      if (device < 0) throw std::runtime_error(name + ": the program has no such device");
      if (asked == '/') return find(run, device);
      if (asked == '!') return run.force(device, value);
      if (asked == 'b') {
        return run.set_breakpoint(device, run.breakpoints().contains(device)
                                              ? std::nullopt
                                              : std::optional(Breakpoint{value}));
      }
      const bool set = run.values()[static_cast<std::size_t>(device)] != 0;
      run.set(device, value.value_or(static_cast<std::int16_t>(set ? 0 : 1)));
    });
  }

  // Where it is written, else read; from the next time on the next place.
  void find(const Run& run, int device) {
    const DeviceView& view = run.view().devices()[static_cast<std::size_t>(device)];
    std::vector<int> places = view.written;
    places.insert(places.end(), view.read.begin(), view.read.end());
    if (places.empty()) throw std::runtime_error(view.name + ": no rung has it");
    found_ = last_found_ == device ? (found_ + 1) % places.size() : 0;
    last_found_ = device;
    const auto line = std::find(rung_of_.begin(), rung_of_.end(), places[found_]);
    top_ = static_cast<int>(line - rung_of_.begin());
    note_ = fmt::format("{}: rung {}, {} of {}", view.name, places[found_] + 1, found_ + 1,
                        places.size());
  }

  template <typename Job>
  void send(Job job) {
    try {
      session_.call([&](Run& run) {
        job(run);
        return 0;
      });
    } catch (const std::exception& error) {
      note_ = error.what();
    }
  }

  Session session_;
  std::vector<int> rung_of_;
  int top_ = 0;
  int asked_ = 0;  // the key that asked for `answer_`
  std::string answer_, note_;
  int last_found_ = -1;
  std::size_t found_ = 0;
};

void give(Run& run, std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    const int device = run.view().find(event.device);
    if (device >= 0) run.set(device, event.value);
  }
}

}  // namespace

int show_in_terminal(std::unique_ptr<Run> run, std::optional<std::uint64_t> scans,
                     const std::optional<Stimulus>& stimulus) {
  constexpr int kDone = 0, kDifferent = 3;
  const bool terminal = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  if (terminal && !scans && !stimulus) {
    std::signal(SIGINT, stop);
    std::signal(SIGTERM, stop);
    Terminal(std::move(run)).show();
    return kDone;
  }
  const std::uint64_t count = scans.value_or(stimulus ? stimulus->scans() : 1);
  for (std::uint64_t k = 0; k < count && !run->failed(); ++k) {
    if (stimulus) give(*run, stimulus->events(k));
    run->one_scan();
  }
  for (const std::string& line : ladder_text(*run, {})) fmt::print("{}\n", line);
  if (!run->failed()) return kDone;
  fmt::print(stderr, "{}\n", run->message());
  return kDifferent;
}

}  // namespace rung::view
