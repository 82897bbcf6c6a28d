// SPDX-License-Identifier: Apache-2.0
// A user at a controller that is never left alone: polls and writes at full speed, random programs
// swapped in by downloads, RUN and STOP by command and by switch, and faults: broken frames, cut
// and damaged downloads, resets, power cuts, watchdogs that trip.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "controller/simulated_controller.hpp"
#include "programs/random_source.hpp"
#include "reliability/client.hpp"
#include "soak/soak_program.hpp"
#include "soak/watch.hpp"

namespace rung::tb {

// How the next program comes in, and what goes wrong before it does.
enum class Swap : std::uint8_t {
  Running,   // while the one before runs
  Stopped,   // after a STOP
  Again,     // the download breaks off, and begins anew
  WrongCrc,  // a whole download with a CRC that is not its
  Damaged,   // a bit of it is wrong
  Trip,      // with a watchdog that trips
  Reset,     // reset somewhere in the download
  Power,     // power cut somewhere in the download
};
inline constexpr int kSwaps = static_cast<int>(Swap::Power) + 1;
std::string swap_name(Swap swap);

struct SoakOptions {
  std::string board = "hx8k";
  std::uint64_t seed = 1;
  std::int64_t scans = 100'000;  // at least
  std::size_t programs = 1;      // at least
  // Of each program, at random.
  std::int64_t least_scans = 2000, most_scans = 14'000;
  // One after the other, again and again; a reset and a power cut cost millions of clocks.
  std::vector<Swap> swaps;
};

struct SoakResult {
  std::string difference;  // the first one; empty: none
  std::map<std::string, std::int64_t> counts;
};

SoakResult run_soak(const SoakOptions& options);

class Session {
 public:
  explicit Session(const SoakOptions& options);

  // Both throw Difference, or std::runtime_error where the controller does not answer.
  void swap(Swap how);
  void use(std::int64_t scans);
  std::map<std::string, std::int64_t> counts() const;
  std::int64_t scans() const { return watch_.scans(); }

 private:
  using Made = Watch::Made;
  using Values = std::vector<std::int16_t>;

  Made make_next();
  // Requests: requests.cpp.
  void poll();
  void write();
  void break_frame();
  Values values_of(const std::vector<Device>& devices) const;
  void must_be_running();
  void check_statistics();

  void stop();
  void run();
  void turn_switch();
  void run_until_started(std::uint64_t clocks);
  void download(const Made& next, const Words& file);
  void refused_download(const Words& file, std::uint32_t crc);
  void broken_download(const Made& next);
  void tripping_download(const Made& next);
  void cut_download(const Made& next, bool reset);

  SoakOptions options_;
  RandomSource random_;
  std::unique_ptr<SimulatedController> machine_;
  Watch watch_;
  Client client_;
  Made now_;
  std::uint64_t download_clocks_ = 0;  // that the last whole one took
  std::uint64_t commit_clocks_ = 0;    // of them, its commit
  std::vector<Device> asked_;          // by the poll that waits for its answer
  std::vector<Values> seen_;           // their values since it was sent
  std::map<std::string, std::int64_t> counts_;
};

}  // namespace rung::tb
