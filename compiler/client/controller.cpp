// SPDX-License-Identifier: Apache-2.0
#include "client/controller.hpp"

#include <fmt/format.h>
#include <modbus/modbus.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "load/format.hpp"
#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::client {
namespace {

using namespace controller;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kIdentity = 0x5247;  // "RG"
constexpr int kInterface = 1;
// Flash is erased while a download begins, and checked when it is committed.
constexpr milliseconds kBusyLimit{20'000};
constexpr milliseconds kLoadLimit{60'000};
constexpr milliseconds kPoll{50};
constexpr int kBegin = 1, kCommit = 2, kAbort = 3;
constexpr int kUnderWay = 1, kDone = 2;
constexpr int kRelease = 2;
constexpr int kForceEnd = 0x7FFF;

std::uint32_t pair(std::uint16_t low, std::uint16_t high) {
  return low | static_cast<std::uint32_t>(high) << 16;
}

// Why a download was refused, and what to do.
std::pair<const char*, const char*> refusal(int state) {
  switch (state) {
    case 3:
      return {"the controller found a wrong CRC: what arrived is not what was sent",
              "load it again; if it happens again, check the line"};
    case 4:
      return {"the program is for another board, configuration or processor",
              "compile it for this one: see `rung info`, and `board` in the I/O map"};
    case 5:
      return {"the controller cannot write its flash",
              "is the flash locked, or another than planned?"};
    case 6:
      return {"the controller cannot load a record of it",
              "is the rung program from the same release as the bitstream?"};
    default:
      return {"the controller did not take it up", "load it again"};
  }
}

}  // namespace

std::string_view state_name(int state) {
  static constexpr std::string_view kNames[] = {"stopped", "running", "one scan", "fault",
                                                "no program"};
  return state >= 0 && state < 5 ? kNames[state] : "unknown";
}

std::string_view fault_name(int fault) {
  static constexpr std::string_view kNames[] = {"none", "watchdog", "no program that may run",
                                                "the program in flash could not be loaded"};
  return fault >= 0 && fault < 4 ? kNames[fault] : "unknown";
}

std::string board_name(int board) {
  for (const Board& each : boards()) {
    if (each.id == board) return std::string(each.name);
  }
  return fmt::format("unknown board {}", board);
}

std::string config_name(int config) {
  for (const ConfigId& each : config_ids) {
    if (each.id == config) return std::string(each.config);
  }
  return {};
}

Controller::Controller(LineOptions options) : line_(std::make_unique<Connection>(options)) {
  std::vector<std::uint16_t> words;
  const char* remedy = "is the port, and with several units --unit, the right one?";
  try {
    words = line_->read_words(holding_identity, holding_tables - holding_identity + 1);
  } catch (const ExceptionError& error) {
    throw ClientError(
        fmt::format("{}: this is not a Rung controller: {}", options.port, error.what()), remedy);
  }
  if (words[0] != kIdentity) {
    throw ClientError(fmt::format("{}: this is not a Rung controller: register {:#06x} is {:#06x}",
                                  options.port, holding_identity, words[0]),
                      remedy);
  }
  const auto at = [&](int address) {
    return static_cast<int>(words[static_cast<std::size_t>(address - holding_identity)]);
  };
  identity_ = {at(holding_interface), at(holding_board), at(holding_config), at(holding_mpu),
               at(holding_tables)};
  if (identity_.interface != kInterface) {
    throw ClientError(fmt::format("{}: the controller has version {} of the register map; this "
                                  "program knows version {}",
                                  options.port, identity_.interface, kInterface),
                      "use the rung program of the bitstream's release");
  }
}

Status Controller::status() {
  Status out;
  const auto first = line_->read_words(holding_state, 3);
  out.state = first[0];
  out.fault = first[1];
  out.flags = first[2];
  const int base = holding_scan_count;
  const auto words = line_->read_words(base, holding_program_crc + 2 - base);
  const auto word = [&](int address) { return words[static_cast<std::size_t>(address - base)]; };
  const auto wide = [&](int address) { return pair(word(address), word(address + 1)); };
  out.scan_count = wide(holding_scan_count);
  out.scan_last = wide(holding_scan_last);
  out.scan_min = wide(holding_scan_min);
  out.scan_max = wide(holding_scan_max);
  out.overruns = word(holding_overruns);
  out.exchange_points = word(holding_exchange_points);
  out.frames = word(holding_frames);
  out.bad_frames = word(holding_bad_frames);
  out.bad_bytes = word(holding_bad_bytes);
  out.lost_frames = word(holding_lost_frames);
  out.exceptions = word(holding_exceptions);
  out.saves = word(holding_saves);
  out.generation = wide(holding_program_generation);
  out.length = wide(holding_program_length);
  out.crc = wide(holding_program_crc);
  const auto pins = line_->read_words(holding_inputs, 8);
  out.inputs.assign(pins.begin(), pins.begin() + 4);
  out.outputs.assign(pins.begin() + 4, pins.end());
  out.forces = line_->read_words(holding_force_count, 1)[0];
  return out;
}

template <typename Request>
void Controller::patiently(Request&& request) {
  const auto end = Clock::now() + kBusyLimit;
  while (true) {
    try {
      return request();
    } catch (const ExceptionError& error) {
      const bool busy = error.code == MODBUS_EXCEPTION_SLAVE_OR_SERVER_BUSY ||
                        error.code == MODBUS_EXCEPTION_ACKNOWLEDGE;
      if (!busy || Clock::now() > end) throw;
    }
    std::this_thread::sleep_for(kPoll);
  }
}

void Controller::command(int command) {
  patiently([&] { line_->write_once(holding_command, static_cast<std::uint16_t>(command)); });
}

void Controller::force(int address, bool value) {
  const std::uint16_t words[] = {static_cast<std::uint16_t>(address),
                                 static_cast<std::uint16_t>(value ? 1 : 0)};
  line_->write_words(holding_force_point, words);
}

void Controller::release(int address) {
  const std::uint16_t words[] = {static_cast<std::uint16_t>(address), kRelease};
  line_->write_words(holding_force_point, words);
}

std::vector<Force> Controller::forces() {
  std::vector<Force> out;
  for (const std::uint16_t word : line_->read_words(holding_force_list, holding_force_list_count)) {
    if ((word & 0x7FFF) == kForceEnd) break;
    out.push_back({word & 0x7FFF, word >> 15 != 0});
  }
  return out;
}

void Controller::check_target(const std::vector<std::uint16_t>& words) const {
  const auto head = [&](std::size_t at) { return static_cast<int>(words.at(at)); };
  const std::string& port = line_->options().port;
  if (head(load::kBoardAt) != identity_.board) {
    throw ClientError(fmt::format("{}: the program is for board {}; this is board {}", port,
                                  board_name(head(load::kBoardAt)), board_name(identity_.board)),
                      fmt::format("give an I/O map of this board with --io (board = \"{}\")",
                                  board_name(identity_.board)));
  }
  if (head(load::kConfigAt) != identity_.config) {
    throw ClientError(
        fmt::format("{}: the program is for configuration {}; the controller has {}", port,
                    config_name(head(load::kConfigAt)), config_name(identity_.config)),
        fmt::format("compile it with --config {}", config_name(identity_.config)));
  }
  if (head(load::kMpuAt) != identity_.mpu) {
    throw ClientError(fmt::format("{}: the program is for MPU{}; the controller has MPU{}", port,
                                  head(load::kMpuAt), identity_.mpu),
                      fmt::format("compile it with --mpu {}", identity_.mpu));
  }
  if (head(load::kTablesAt) != identity_.tables) {
    throw ClientError(fmt::format("{}: this program and the controller were made from different "
                                  "tables (fingerprints {:04x} and {:04x})",
                                  port, head(load::kTablesAt), identity_.tables),
                      "use the rung program and the bitstream of one release");
  }
}

void Controller::send(const std::vector<std::uint16_t>& words, const Progress& progress) {
  const std::uint32_t crc = load::crc32(words);
  const auto size = static_cast<std::uint32_t>(words.size());
  const auto half = [](std::uint32_t value, int shift) {
    return static_cast<std::uint16_t>(value >> shift & 0xFFFF);
  };
  const std::uint16_t head[] = {half(size, 0), half(size, 16), half(crc, 0), half(crc, 16)};
  patiently([&] { line_->write_words(holding_load_length, head); });
  const std::uint16_t begin[] = {kBegin};
  patiently([&] { line_->write_words(holding_load_command, begin); });
  for (std::size_t at = 0; at < words.size(); at += holding_window_count) {
    const std::size_t count = std::min<std::size_t>(holding_window_count, words.size() - at);
    std::vector<std::uint16_t> request = {half(static_cast<std::uint32_t>(at), 0),
                                          half(static_cast<std::uint32_t>(at), 16)};
    request.insert(request.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
                   words.begin() + static_cast<std::ptrdiff_t>(at + count));
    patiently([&] { line_->write_words(holding_window_offset, request); });
    if (progress) progress(at + count, words.size());
  }
}

void Controller::reopen(const LineOptions& options) {
  line_.reset();
  line_ = std::make_unique<Connection>(options);
}

// With the program the line's settings change: what does not answer with the old ones may with the
// new.
int Controller::wait_for_load(const LineOptions& after) {
  const LineOptions before = line_->options();
  const bool differs =
      before.baud != after.baud || before.parity != after.parity || before.unit != after.unit;
  bool changed = false;
  const auto end = Clock::now() + kLoadLimit;
  while (true) {
    try {
      const int state = line_->read_words(holding_load_state, 1)[0];
      if (state != kUnderWay) return state;
      if (Clock::now() > end) {
        throw ClientError(before.port + ": the controller is still not done with the program",
                          "see `rung info` for its state");
      }
    } catch (const ExceptionError&) {
      if (Clock::now() > end) throw;
    } catch (const ClientError&) {
      if (Clock::now() > end) throw;
      if (differs) {
        changed = !changed;
        reopen(changed ? after : before);
      }
    }
    std::this_thread::sleep_for(kPoll);
  }
}

Status Controller::download(const std::vector<std::uint16_t>& words, const LineOptions& after,
                            const Progress& progress) {
  check_target(words);
  const int timeout = line_->options().timeout_ms;
  try {
    line_->set_timeout(std::max(timeout, line_->options().flash_timeout_ms));
    send(words, progress);
  } catch (const ExceptionError&) {
    try {
      line_->write_once(holding_load_command, kAbort);
    } catch (const ClientError&) {
      // What the download failed of says more.
    }
    throw;
  }
  try {
    line_->write_once(holding_load_command, kCommit);
  } catch (const TimeoutError&) {
    // The answer may be lost, or come with the new program's settings: its state tells.
  }
  line_->set_timeout(timeout);
  const int state = wait_for_load(after);
  if (state != kDone) {
    const auto [what, mend] = refusal(state);
    throw ClientError(fmt::format("{}: {}", line_->options().port, what), mend);
  }
  Status now = status();
  if (now.length != words.size() || now.crc != load::crc32(words)) {
    throw ClientError(line_->options().port + ": the controller runs another program than was sent",
                      "did somebody else load one at the same time? load it again");
  }
  return now;
}

std::vector<std::uint16_t> Controller::upload(const Progress& progress) {
  const auto size = line_->read_words(holding_program_length, 2);
  const std::size_t length = pair(size[0], size[1]);
  std::vector<std::uint16_t> words;
  while (words.size() < length) {
    const auto at = static_cast<std::uint32_t>(words.size());
    const std::uint16_t offset[] = {static_cast<std::uint16_t>(at & 0xFFFF),
                                    static_cast<std::uint16_t>(at >> 16)};
    line_->write_words(holding_window_offset, offset);
    const std::size_t count = std::min<std::size_t>(holding_window_count, length - words.size());
    const auto part = line_->read_words(holding_window, static_cast<int>(count));
    words.insert(words.end(), part.begin(), part.end());
    if (progress) progress(words.size(), length);
  }
  return words;
}

}  // namespace rung::client
