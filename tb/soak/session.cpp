// SPDX-License-Identifier: Apache-2.0
#include "soak/session.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::uint64_t kClocksPerMs = 250;
constexpr std::uint64_t kGap = 160;  // of the line between two requests, with quicken()
// Longer than a start of the board takes.
constexpr std::uint64_t kBoot = 40'000'000;
// Longer than RUN takes, which clears all devices.
constexpr std::uint64_t kRun = 8'000'000;
constexpr std::uint64_t kSwitched = 40'000;
// Longer than a request and its answer take.
constexpr std::uint64_t kOldAnswer = 50'000;
constexpr int kLoaded = 2;   // load_state
constexpr int kFailure = 4;  // Modbus exception
constexpr int kTripped = 1;  // fault

std::unique_ptr<SimulatedController> make_machine(const SoakOptions& options) {
  ControllerSetup setup;
  setup.board = options.board;
  setup.line = ControllerSetup::Line::Bytes;
  setup.clocks_per_ms = kClocksPerMs;
  setup.seed = options.seed;
  setup.flash_times =
      FlashTimes{.page_program = 200, .sector_erase = 500, .block_erase = 1000, .wake = 1};
  return SimulatedController::make(setup);
}

}  // namespace

std::string swap_name(Swap swap) {
  static constexpr std::array<const char*, kSwaps> kNames{
      "running", "stopped", "again", "wrong_crc", "damaged", "trip", "reset", "power"};
  return kNames.at(static_cast<std::size_t>(swap));
}

Session::Session(const SoakOptions& options)
    : options_(options),
      random_(options.seed),
      machine_(make_machine(options)),
      watch_(*machine_, options.seed + 1),
      client_(*machine_) {
  client_.advance = [this](std::uint64_t clocks) { watch_.advance(clocks); };
  client_.patience = kBoot;
  watch_.scanned = [this] {
    if (!asked_.empty()) seen_.push_back(values_of(asked_));
  };
  download(make_next(), {});
  client_.gap = kGap;
}

Session::Made Session::make_next() {
  return make_soak_program(options_.board, kClocksPerMs, random_.bits());
}

void Session::must_be_running() {
  if (!watch_.running() || watch_.program() != now_) {
    throw Difference(fmt::format("clock {}: program {} does not run", machine_->now(), now_->seed));
  }
}

void Session::run_until_started(std::uint64_t clocks) {
  const std::uint64_t end = machine_->now() + clocks;
  while (!watch_.running()) {
    if (machine_->now() > end) throw Difference("it does not start");
    watch_.advance(1000);
  }
}

void Session::stop() {
  watch_.expect_stop();
  client_.command(2);
  watch_.stopped();
  ++counts_["stops"];
}

void Session::run() {
  watch_.expect_start(now_);
  client_.command(1);
  run_until_started(kRun);
}

void Session::turn_switch() {
  watch_.expect_stop();
  machine_->set_run_switch(false);
  for (std::uint64_t i = 0; watch_.running() && i < kSwitched; i += 100) watch_.advance(100);
  watch_.stopped();
  watch_.advance(random_.bits() % 5000);
  if (client_.write(c::holding_command, {1}) != kFailure) throw Difference("it runs, switched off");
  watch_.expect_start(now_);
  machine_->set_run_switch(true);
  run_until_started(kRun);
  ++counts_["switched"];
}

// `file`: none for its own.
void Session::download(const Made& next, const Words& file) {
  const Words& words = file.empty() ? next->file : file;
  const bool trips = !file.empty();
  const std::uint64_t begun = machine_->now();
  int wrong = client_.begin(words, load::crc32(words));
  if (wrong == 0) wrong = client_.windows(words);
  if (wrong != 0) throw Difference(fmt::format("a download meets exception {}", wrong));
  const std::uint64_t committed = machine_->now();
  watch_.expect_stop();
  watch_.expect_start(next, trips);
  const int state = client_.commit();
  if (state != kLoaded) throw Difference(fmt::format("a download ends with load_state {}", state));
  now_ = next;
  ++counts_["downloads"];
  if (trips) return;
  run_until_started(kRun);
  must_be_running();
  download_clocks_ = machine_->now() - begun;
  commit_clocks_ = machine_->now() - committed;
}

// A download that must be refused, while the program that is there runs on.
void Session::refused_download(const Words& file, std::uint32_t crc) {
  int wrong = client_.begin(file, crc);
  if (wrong == 0) wrong = client_.windows(file);
  if (wrong != 0) throw Difference(fmt::format("a download meets exception {}", wrong));
  const int state = client_.commit();
  if (state <= kLoaded) throw Difference(fmt::format("a wrong download has load_state {}", state));
  must_be_running();
  ++counts_["refused_downloads"];
}

void Session::broken_download(const Made& next) {
  int wrong = client_.begin(next->file, load::crc32(next->file));
  const std::size_t windows = next->file.size() / c::holding_window_count;
  for (std::size_t i = random_.bits() % (windows + 1); i > 0 && wrong == 0; --i) {
    const std::size_t at = random_.bits() % (windows + 1) * c::holding_window_count;
    wrong = client_.window(next->file, at, at);
  }
  if (wrong == 0 && random_.percent(50)) wrong = client_.write(c::holding_load_command, {3});
  if (wrong != 0) throw Difference(fmt::format("a download meets exception {}", wrong));
  must_be_running();
  ++counts_["broken_downloads"];
}

void Session::tripping_download(const Made& next) {
  download(next, next->tripping_file);
  const std::int64_t trips = counts_["trips"];
  watch_.advance(2 * static_cast<std::uint64_t>(next->timing.period) + 1000);
  counts_["trips"] = trips + 1;
  if (watch_.trips() != trips + 1)
    throw Difference("a watchdog has not tripped, or more than once");
  if (client_.holding(c::holding_state) != 3 || client_.holding(c::holding_fault) != kTripped) {
    throw Difference("a watchdog has tripped, and the registers do not say so");
  }
  if (client_.write(c::holding_command, {1}) != kFailure) throw Difference("it runs from a fault");
  client_.command(5);
  if (client_.holding(c::holding_state) != 0) throw Difference("the fault cannot be left");
}

// Somewhere in a download, or after it; the program that is there then runs.
void Session::cut_download(const Made& next, bool reset) {
  const Made before = now_;
  const std::uint64_t begun = machine_->now();
  client_.cut_at = begun + random_.bits() % (download_clocks_ + download_clocks_ / 8);
  const bool in_commit = *client_.cut_at + 1000 > begun + download_clocks_ - commit_clocks_;
  bool committing = false;
  try {
    int wrong = client_.begin(next->file, load::crc32(next->file));
    if (wrong == 0) wrong = client_.windows(next->file);
    if (wrong != 0) throw Difference(fmt::format("a download meets exception {}", wrong));
    committing = true;
    watch_.expect_stop();
    watch_.expect_start(next);
    const int state = client_.commit();
    if (state != kLoaded) throw Difference(fmt::format("a download has load_state {}", state));
    now_ = next;
    watch_.advance(*client_.cut_at > machine_->now() ? *client_.cut_at - machine_->now() : 0);
    client_.cut_at.reset();
  } catch (const Cut&) {
  }
  // In a commit nobody knows which of them is there: the switch keeps it until the client does.
  const bool unknown = committing && now_ == before;
  const bool held = unknown || in_commit;
  if (held) machine_->set_run_switch(false);
  if (reset) {
    machine_->reset();
  } else {
    machine_->set_power(false);
    machine_->run(1000);
    machine_->set_power(true);
  }
  machine_->receive();
  watch_.lost({before, next});
  client_.gap = Client::kGap;
  if (!held) {
    watch_.expect_start(now_);
    run_until_started(kBoot);
  }
  // A request that was on its way is answered first.
  watch_.advance(kOldAnswer);
  machine_->receive();
  const std::uint32_t crc = client_.holding_long(c::holding_program_crc);
  if (unknown && crc == load::crc32(next->file)) now_ = next;
  if (crc != load::crc32(now_->file)) {
    throw Difference(fmt::format("after a cut the program's CRC is {:#x}", crc));
  }
  ++counts_[unknown ? now_ == next ? "cut_commits_new" : "cut_commits_old" : "cut_downloads"];
  ++counts_[reset ? "resets" : "power_cuts"];
  if (held) {
    watch_.settle(now_);
    watch_.expect_start(now_);
    machine_->set_run_switch(true);
    run_until_started(kBoot);
  }
  client_.gap = kGap;
  must_be_running();
}

void Session::swap(Swap how) {
  const Made next = make_next();
  ++counts_["swaps_" + swap_name(how)];
  switch (how) {
    case Swap::Running:
      break;
    case Swap::Stopped:
      stop();
      for (int i = 0; i < 5; ++i) poll();
      if (random_.percent(50)) {
        run();
        stop();
      }
      break;
    case Swap::Again:
      broken_download(next);
      break;
    case Swap::WrongCrc:
      refused_download(next->file, load::crc32(next->file) ^ 1U << random_.below(32));
      break;
    case Swap::Damaged: {
      Words file = next->file;
      file[random_.bits() % file.size()] ^= static_cast<std::uint16_t>(1U << random_.below(16));
      refused_download(file, load::crc32(next->file));
      break;
    }
    case Swap::Trip:
      tripping_download(next);
      break;
    case Swap::Reset:
    case Swap::Power:
      cut_download(next, how == Swap::Reset);
      if (now_ == next) return;
      break;
  }
  download(next, {});
}

void Session::use(std::int64_t scans) {
  watch_.advance(static_cast<std::uint64_t>(now_->timing.period) * 3);
  client_.command(4);  // statistics anew
  watch_.advance(static_cast<std::uint64_t>(now_->timing.period) * 3);
  const std::int64_t end = watch_.scans() + scans;
  const int turn = random_.below(100);
  if (turn < 10) turn_switch();
  if (turn >= 90) {
    stop();
    run();
  }
  while (watch_.scans() < end) {
    switch (random_.weighted(std::array{80, 14, 6})) {
      case 0:
        poll();
        break;
      case 1:
        write();
        break;
      default:
        break_frame();
    }
  }
  must_be_running();
  check_statistics();
}

std::map<std::string, std::int64_t> Session::counts() const {
  auto counts = counts_;
  counts["scans"] = watch_.scans();
  counts["output_changes"] = watch_.changes();
  counts["scans_with_glitches"] = watch_.glitches();
  counts["clocks"] = static_cast<std::int64_t>(machine_->now());
  return counts;
}

SoakResult run_soak(const SoakOptions& options) {
  SoakResult result;
  std::unique_ptr<Session> session;
  RandomSource random(options.seed ^ 0x736F616B);
  try {
    session = std::make_unique<Session>(options);
    for (std::size_t n = 0; n < options.programs || session->scans() < options.scans; ++n) {
      if (n > 0 && !options.swaps.empty())
        session->swap(options.swaps[(n - 1) % options.swaps.size()]);
      const auto range = static_cast<int>(options.most_scans - options.least_scans + 1);
      session->use(options.least_scans + random.below(range));
    }
  } catch (const std::runtime_error& error) {
    result.difference = error.what();
    if (result.difference.empty()) result.difference = "?";
  }
  if (session) result.counts = session->counts();
  return result;
}

}  // namespace rung::tb
