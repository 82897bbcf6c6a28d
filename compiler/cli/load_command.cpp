// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "cli/client_input.hpp"
#include "load/load_file.hpp"

namespace rung::cli {
namespace {

using Clock = std::chrono::steady_clock;

// "42 % of 12,000 words, 350 words/s", over itself, on a terminal only.
class ProgressLine {
 public:
  void operator()(std::size_t done, std::size_t all) {
    if (isatty(STDERR_FILENO) == 0) return;
    const std::chrono::duration<double> since = Clock::now() - start_;
    if (done < all && Clock::now() - last_ < std::chrono::milliseconds(100)) return;
    last_ = Clock::now();
    fmt::print(stderr, "\r{:3} % of {} bytes, {:.1f} kB/s ", 100 * done / all, 2 * all,
               2 * static_cast<double>(done) / 1000 / std::max(since.count(), 1e-3));
    if (done == all) fmt::print(stderr, "\n");
    shown_ = done < all;
  }
  ~ProgressLine() {
    if (shown_) fmt::print(stderr, "\n");
  }

 private:
  Clock::time_point start_ = Clock::now(), last_ = {};
  bool shown_ = false;
};

// The line is as the program that runs there has set it: most often by this map, at first as after
// reset.
client::Controller connect(const Options& options, const std::optional<io::Map>& map) {
  const client::LineOptions as_mapped = line_of(options, map);
  const client::LineOptions plain = line_of(options, std::nullopt);
  try {
    return client::Controller(as_mapped);
  } catch (const client::TimeoutError&) {
    if (as_mapped.baud == plain.baud && as_mapped.parity == plain.parity &&
        as_mapped.unit == plain.unit) {
      throw;
    }
  }
  return client::Controller(plain);
}

}  // namespace

int load_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  const auto map = read_io(options, diagnostics);
  auto input = read_input(options, true, std::nullopt, diagnostics);
  if (!input || (!options.io.empty() && !map)) return report(diagnostics);
  if (!input->image) {
    auto compiled = compile_input(*input, options, diagnostics);
    if (!compiled) return report(diagnostics);
    input->image = std::move(compiled->image);
  }
  const Bound bound = bind_image(*input->image, map, options, diagnostics);
  if (diagnostics.has_errors()) return report(diagnostics);
  const auto words = load::make(*input->image, bound.bindings, bound.timing.clock_hz, diagnostics);
  if (!words) return report(diagnostics);
  return with_controller(options, diagnostics, [&] {
    client::Controller controller = connect(options, map);
    client::LineOptions after = line_of(options, std::nullopt);
    const client::LineOptions mapped = line_of({}, map);
    after.baud = mapped.baud;
    after.parity = mapped.parity;
    after.unit = mapped.unit;
    ProgressLine progress;
    const client::Status status = controller.download(*words, after, std::ref(progress));
    fmt::print("{}: loaded, {} bytes, generation {}, {}\n", options.program, 2 * words->size(),
               status.generation, client::state_name(status.state));
    return kDone;
  });
}

}  // namespace rung::cli
