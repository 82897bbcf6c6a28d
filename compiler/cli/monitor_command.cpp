// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "cli/client_input.hpp"
#include "rungs/devices.hpp"

namespace rung::cli {
namespace {

using SystemClock = std::chrono::system_clock;

volatile std::sig_atomic_t stopped = 0;
void stop(int /*signal*/) { stopped = 1; }

struct Shown {
  std::string name, comment;
};

struct List {
  std::vector<Shown> names;
  std::vector<client::Watched> devices;
};

void add(List& list, const io::Subject& names, Device device, const std::string& config,
         const std::string& argument, Diagnostics& diagnostics) {
  const auto point = io::point_of(device, names.dialect, config);
  const std::string name = names.name(device);
  if (!point) {
    diagnostics.warning(argument, {},
                        fmt::format("{} has no address on a controller of configuration {}: it is "
                                    "left out",
                                    name, config));
    return;
  }
  std::string comment;
  for (const io::SubjectDevice& each : names.devices) {
    if (each.device == device) comment = each.comment;
  }
  const bool wide = device.kind == DeviceKind::CN && is_32_bit_counter(device, names.dialect);
  list.names.push_back({name, comment});
  list.devices.push_back({*point, wide});
}

// Those that were named, else all of the program.
List list_of(const io::Subject& names, const std::vector<std::string>& wanted,
             const std::string& config, const std::string& file, Diagnostics& diagnostics) {
  List list;
  for (const std::string& name : wanted) {
    const auto device = names.find(name, false);
    if (!device) {
      const std::string near = names.near(name);
      diagnostics.error(
          name, {}, "this is neither a device nor a name that the program has",
          near.empty() ? "names need PROGRAM before them" : fmt::format("did you mean {}?", near));
      continue;
    }
    add(list, names, *device, config, name, diagnostics);
    // T5 and C5: contact and value.
    if (value_of(*device) != *device) {
      add(list, names, value_of(*device), config, name, diagnostics);
    }
  }
  if (wanted.empty()) {
    for (const io::SubjectDevice& each : names.devices) {
      if (is_port(each.device.kind) || each.device.kind == DeviceKind::CNH) continue;
      add(list, names, each.device, config, file, diagnostics);
    }
  }
  return list;
}

std::string time_stamp(SystemClock::time_point now) {
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(SystemClock::to_time_t(now)),
                     ms % 1000);
}

// The file that --csv names, written row by row so that nothing is lost when the recording ends.
class Recording {
 public:
  Recording(const std::string& path, const List& list) : path_(path) {
    if (path.empty()) return;
    file_ = path == "-" ? stdout : std::fopen(path.c_str(), "w");
    if (file_ == nullptr) {
      throw client::ClientError(fmt::format("{}: cannot be written", path),
                                "choose another file for --csv");
    }
    std::string head = "time";
    for (const Shown& each : list.names) head += "," + each.name;
    write(head);
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  }

  void row(const std::string& time, const std::vector<std::int32_t>& values) {
    if (file_ != nullptr) write(fmt::format("{},{}", time, fmt::join(values, ",")));
  }
  bool is_output() const { return file_ == stdout; }

 private:
  void write(const std::string& line) {
    if (std::fputs((line + "\n").c_str(), file_) < 0 || std::fflush(file_) != 0) {
      throw client::ClientError(fmt::format("{}: cannot be written", path_), "is the disk full?");
    }
  }

  std::string path_;
  std::FILE* file_ = nullptr;
};

// As a table that is painted over, as many rows as the terminal has.
void paint(const List& list, const std::vector<std::int32_t>& values, const std::string& time) {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 3;
  const std::size_t rows = known ? size.ws_row - 3U : 20U;
  std::size_t width = 4;
  for (const Shown& each : list.names) width = std::max(width, each.name.size());
  std::string text = "\x1b[H\x1b[J" + time + "   Ctrl-C ends\n";
  for (std::size_t i = 0; i < values.size() && i < rows; ++i) {
    text += fmt::format("{:<{}}  {:>11}  {}\n", list.names[i].name, width, values[i],
                        list.names[i].comment);
  }
  if (values.size() > rows) {
    text += fmt::format("and {} more: name those that matter\n", values.size() - rows);
  }
  fmt::print("{}", text);
  std::fflush(stdout);
}

void print_line(const List& list, const std::vector<std::int32_t>& values,
                const std::string& time) {
  std::string text = time;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format(" {}={}", list.names[i].name, values[i]);
  }
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

void watch(client::Controller& controller, const List& list, const Options& options) {
  Recording recording(options.csv, list);
  const int points = controller.status().exchange_points;
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  auto next = std::chrono::steady_clock::now();
  for (std::uint64_t sample = 0; stopped == 0; ++sample) {
    if (options.count != 0 && sample == options.count) break;
    const auto values = client::read_values(controller.line(), list.devices, points);
    const std::string time = time_stamp(SystemClock::now());
    recording.row(time, values);
    if (!recording.is_output()) {
      terminal ? paint(list, values, time) : print_line(list, values, time);
    }
    next += std::chrono::milliseconds(options.interval_ms);
    // In short sleeps: a signal shall not wait for a long interval.
    while (stopped == 0 && std::chrono::steady_clock::now() < next &&
           (options.count == 0 || sample + 1 < options.count)) {
      std::this_thread::sleep_for(std::min<std::chrono::steady_clock::duration>(
          next - std::chrono::steady_clock::now(), std::chrono::milliseconds(50)));
    }
  }
}

}  // namespace

int monitor_command(const Options& options) {
  std::vector<std::string> wanted = options.devices;
  std::string program;
  if (!wanted.empty() && std::filesystem::is_regular_file(wanted.front())) {
    program = wanted.front();
    wanted.erase(wanted.begin());
  }
  if (program.empty() && wanted.empty()) {
    throw UsageError("monitor: name devices, or a program to show all of it");
  }
  Diagnostics diagnostics;
  const auto names = names_for(options, program, diagnostics);
  if (!names) return report(diagnostics);
  return with_controller(options, diagnostics, [&] {
    client::Controller controller(line_of(options, std::nullopt));
    const List list = list_of(*names, wanted, controller.config(), program, diagnostics);
    if (diagnostics.has_errors() || list.devices.empty()) return kRefused;
    watch(controller, list, options);
    return kDone;
  });
}

}  // namespace rung::cli
