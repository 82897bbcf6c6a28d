// SPDX-License-Identifier: Apache-2.0
#include "view/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "rungs/ports.hpp"

namespace rung::view {
namespace {

using Clock = std::chrono::steady_clock;
// A run that is further behind does not try to make up for it.
constexpr auto kLate = std::chrono::milliseconds(200);

// Characters that are kept of what a program sends.
constexpr std::size_t kSent = 2000;

// As a terminal shows it; what it could not show as \xAB.
std::string printable(int byte) {
  if (byte == '\r') return {};
  if (byte == '\n' || (byte >= ' ' && byte < 0x7F)) return {static_cast<char>(byte)};
  return fmt::format("\\x{:02X}", byte & 0xFF);
}

}  // namespace

Run::Run(const ProgramView& view, std::vector<std::string> engines, EngineMaker maker)
    : view_(view),
      engines_(std::move(engines)),
      maker_(std::move(maker)),
      engine_(maker_(engines_.front())),
      history_(view.devices().size()),
      values_(view.devices().size()),
      versions_(view.devices().size(), 1),
      power_(static_cast<std::size_t>(view.nets())) {
  if (engine_->is_live()) mode_ = Mode::RealTime;
}

void Run::set_mode(Mode mode) {
  mode_ = mode;
  steps_ = 0;
  message_.clear();
  failed_ = false;
  touch();
}

void Run::step(int scans) {
  set_mode(Mode::Paused);
  steps_ = scans;
}

void Run::set(int device, std::int16_t value) {
  const DeviceView& target = view_.devices().at(static_cast<std::size_t>(device));
  if (!is_word(target.device)) value = value != 0 ? 1 : 0;
  if (target.input) inputs_[device] = value;
  pending_[device] = value;
  // A paused program too shows what it will find.
  if (!engine_->is_live()) {
    values_[static_cast<std::size_t>(device)] = value;
    versions_[static_cast<std::size_t>(device)] = version_ + 1;
  }
  touch();
}

void Run::force(int device, std::optional<std::int16_t> value) {
  const DeviceView& target = view_.devices().at(static_cast<std::size_t>(device));
  if (engine_->is_live()) {
    engine_->force(target.device, value);
    return touch();
  }
  if (value) {
    if (!is_word(target.device)) value = *value != 0 ? 1 : 0;
    forced_[device] = *value;
    values_[static_cast<std::size_t>(device)] = *value;
    versions_[static_cast<std::size_t>(device)] = version_ + 1;
  } else {
    forced_.erase(device);
    // An input goes back to what it was set to.
    if (target.input) set(device, inputs_.contains(device) ? inputs_[device] : std::int16_t{0});
  }
  touch();
}

void Run::release_all() {
  const auto all = forced_;
  for (const auto& [device, value] : all) force(device, std::nullopt);
}

void Run::set_breakpoint(int device, std::optional<Breakpoint> breakpoint) {
  if (breakpoint) {
    breakpoints_[device] = *breakpoint;
  } else {
    breakpoints_.erase(device);
  }
  touch();
}

void Run::restart(const std::string& engine) {
  if (std::find(engines_.begin(), engines_.end(), engine) == engines_.end()) {
    throw std::runtime_error(fmt::format("there is no engine {} here", engine));
  }
  auto made = maker_(engine);
  engine_ = std::move(made);
  history_ = History(values_.size());
  std::fill(values_.begin(), values_.end(), std::int16_t{0});
  ++version_;
  std::fill(versions_.begin(), versions_.end(), version_);
  std::fill(power_.begin(), power_.end(), false);
  pending_ = inputs_;
  for (const auto& [device, value] : inputs_) values_[static_cast<std::size_t>(device)] = value;
  for (const auto& [device, value] : forced_) values_[static_cast<std::size_t>(device)] = value;
  sent_.clear();
  scans_ = 0;
  steps_ = 0;
  mode_ = engine_->is_live() ? Mode::RealTime : Mode::Paused;
  message_.clear();
  failed_ = false;
  ++runs_;
}

void Run::one_scan() {
  if (steps_ > 0) --steps_;
  std::vector<StimulusEvent> events;
  for (const auto& [device, value] : pending_) {
    if (!forced_.contains(device)) {
      events.push_back({view_.devices()[static_cast<std::size_t>(device)].device, value});
    }
  }
  pending_.clear();
  if (!engine_->is_live()) {
    for (const auto& [device, value] : forced_) {
      events.push_back({view_.devices()[static_cast<std::size_t>(device)].device, value});
    }
  }
  const std::vector<std::int16_t> before = values_;
  try {
    engine_->scan(events);
    sample(engine_->is_live());
  } catch (const std::exception& error) {
    return pause(error.what(), true);
  }
  if (failed_) message_.clear();
  failed_ = false;
  history_.end_scan(scans_);
  check_breakpoints(before);
  ++scans_;
}

void Run::sample(bool live) {
  ++version_;
  if (live) {
    forced_.clear();
    for (const Forced& each : engine_->forces()) {
      const int device = view_.find(each.device);
      if (device >= 0) forced_[device] = each.value;
    }
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    std::int16_t value = engine_->value(view_.devices()[i].device);
    if (!live) {
      const auto forced = forced_.find(static_cast<int>(i));
      if (forced != forced_.end()) value = forced->second;
    }
    if (values_[i] != value) {
      values_[i] = value;
      versions_[i] = version_;
    }
    history_.add(scans_, static_cast<int>(i), value);
  }
  for (const int byte : engine_->sent()) sent_ += printable(byte);
  if (sent_.size() > kSent) sent_.erase(0, sent_.size() - kSent);
  power_ = view_.power(engine_->seen());
}

void Run::check_breakpoints(const std::vector<std::int16_t>& before) {
  for (const auto& [device, breakpoint] : breakpoints_) {
    const auto at = static_cast<std::size_t>(device);
    if (before[at] == values_[at]) continue;
    if (breakpoint.value && *breakpoint.value != values_[at]) continue;
    return pause(fmt::format("{} went from {} to {} in scan {}", view_.devices()[at].name,
                             before[at], values_[at], scans_),
                 false);
  }
}

void Run::pause(std::string why, bool failed) {
  // A controller goes on; only the looking stops, to be tried again when it failed.
  if (!(failed && engine_->is_live())) mode_ = Mode::Paused;
  steps_ = 0;
  message_ = std::move(why);
  failed_ = failed;
  touch();
}

Session::Session(std::unique_ptr<Run> run) : run_(std::move(run)), thread_([this] { loop(); }) {}

Session::~Session() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Session::post(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_all();
}

void Session::run_jobs() {
  std::unique_lock lock(mutex_);
  while (!jobs_.empty()) {
    const auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
}

void Session::loop() {
  auto next = Clock::now();
  while (true) {
    run_jobs();
    std::unique_lock lock(mutex_);
    if (stop_ && jobs_.empty()) return;
    if (!run_->has_work()) {
      wake_.wait(lock, [&] { return stop_ || !jobs_.empty(); });
      next = Clock::now();
      continue;
    }
    // Steps are done at once.
    if (run_->mode() == Mode::RealTime) {
      if (wake_.wait_until(lock, next, [&] { return stop_ || !jobs_.empty(); })) continue;
      lock.unlock();
      run_->one_scan();
      next += std::chrono::microseconds(run_->failed() ? 1'000'000 : run_->engine().tick_us());
      if (Clock::now() - next > kLate) next = Clock::now();
      continue;
    }
    lock.unlock();
    run_->one_scan();
  }
}

}  // namespace rung::view
