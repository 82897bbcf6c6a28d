// SPDX-License-Identifier: Apache-2.0
#include "reliability/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "driver/compile.hpp"
#include "load/load_file.hpp"
#include "melsec/melsec.hpp"
#include "rung_controller.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::uint64_t kStep = 64;
// Longer than the controller ever leaves between two bytes of an answer.
constexpr std::uint64_t kAnswerGap = 6 * 16;
constexpr int kCommitPolls = 2000;

[[noreturn]] void fail(const Diagnostics& diagnostics) {
  std::ostringstream out;
  diagnostics.print(out);
  throw std::runtime_error(out.str());
}

std::uint16_t crc_16(const Bytes& bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? crc >> 1 ^ 0xA001 : crc >> 1);
    }
  }
  return crc;
}

}  // namespace

Made make_program(const std::string& list, const std::string& map_text) {
  Diagnostics diagnostics;
  const auto source = decode_text(list, "test.il", diagnostics);
  std::optional<Program> program;
  if (source) program = parse_melsec(*source, std::nullopt, diagnostics);
  const auto map = io::parse_map(map_text, "test.toml", diagnostics);
  if (!program || !map) fail(diagnostics);
  CompileOptions options;
  options.mpu = static_cast<isa::Mpu>(map->board->mpu);
  options.config = isa::find_config(map->board->config);
  auto compiled = compile(*program, options, diagnostics);
  if (!compiled) fail(diagnostics);
  Made made;
  made.image = std::move(compiled->image);
  made.bindings = io::bind(*map, load::subject_of(made.image), diagnostics);
  const auto clock_hz = static_cast<std::int64_t>(1000 * ControllerSetup{}.clocks_per_ms);
  made.timing = load::timing_of(made.image, made.bindings, clock_hz);
  const auto words = load::make(made.image, made.bindings, clock_hz, diagnostics);
  if (!words || diagnostics.has_errors()) fail(diagnostics);
  made.words = *words;
  return made;
}

std::string golden(const std::string& name) {
  std::ifstream in(std::string(RUNG_REPOSITORY) + "/tb/golden/programs/" + name);
  if (!in) throw std::runtime_error(name + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool patch(Words& file, int space, std::uint32_t address, std::uint16_t value) {
  for (std::size_t at = 16; at < file.size() && file[at] != 0;) {
    const std::size_t data = file[at] & 0xFFU;
    const std::uint32_t first = (file[at] >> 8U & 15U) << 16U | file[at + 1];
    if (file[at] >> 12U == space && address >= first && address < first + data) {
      file[at + 2 + address - first] = value;
      return true;
    }
    at += 2 + data;
  }
  return false;
}

void quicken(Words& file) {
  if (!patch(file, c::space_host, c::host_silence_low, 96)) throw std::runtime_error("no silence");
  patch(file, c::space_host, c::host_silence_high, 0);
}

std::uint16_t low(std::size_t value) { return static_cast<std::uint16_t>(value); }
std::uint16_t high(std::size_t value) { return static_cast<std::uint16_t>(value >> 16U); }

Bytes with_crc(Bytes frame) {
  const std::uint16_t crc = crc_16(frame);
  frame.push_back(static_cast<std::uint8_t>(crc));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8U));
  return frame;
}

Bytes pdu(int function, const Words& words) {
  Bytes out{static_cast<std::uint8_t>(function)};
  for (const std::uint16_t word : words) {
    out.push_back(static_cast<std::uint8_t>(word >> 8U));
    out.push_back(static_cast<std::uint8_t>(word));
  }
  return out;
}

void Client::run(std::uint64_t clocks) {
  if (cut_at && controller_.now() + clocks >= *cut_at) {
    if (*cut_at > controller_.now()) controller_.run(*cut_at - controller_.now());
    cut_at.reset();
    throw Cut{};
  }
  controller_.run(clocks);
}

Bytes Client::send(const Bytes& frame, std::uint64_t patience) {
  run(gap);
  Bytes answer = controller_.receive();
  for (const std::uint8_t byte : frame) controller_.send(byte);
  while (controller_.sending() > 0) run(kStep);
  std::uint64_t quiet = 0;
  while (quiet < (answer.empty() ? patience : kAnswerGap)) {
    run(kStep);
    quiet += kStep;
    const Bytes more = controller_.receive();
    if (more.empty()) continue;
    answer.insert(answer.end(), more.begin(), more.end());
    quiet = 0;
  }
  return answer;
}

std::optional<Bytes> Client::ask(const Bytes& pdu) {
  Bytes frame{static_cast<std::uint8_t>(unit)};
  frame.insert(frame.end(), pdu.begin(), pdu.end());
  Bytes answer = send(with_crc(frame), patience);
  if (answer.size() < 4 || crc_16(answer) != 0 || answer[0] != unit) return std::nullopt;
  return Bytes(answer.begin() + 1, answer.end() - 2);
}

Words Client::read(int address, int count) {
  const auto answer = ask(pdu(3, {low(address), low(count)}));
  if (!answer || answer->size() != 2U + 2U * count || answer->at(0) != 3) {
    throw std::runtime_error(
        fmt::format("reading {:#x}: {}", address,
                    answer ? fmt::format("exception {}", answer->at(1)) : "no answer"));
  }
  Words words;
  for (int i = 0; i < count; ++i) {
    words.push_back(
        low(static_cast<std::size_t>((*answer)[2 + 2 * i]) << 8U | (*answer)[3 + 2 * i]));
  }
  return words;
}

std::uint32_t Client::holding_long(int address) {
  const Words words = read(address, 2);
  return words[0] | static_cast<std::uint32_t>(words[1]) << 16U;
}

int Client::write(int address, const Words& values) {
  Bytes request = pdu(16, {low(address), low(values.size())});
  request.push_back(static_cast<std::uint8_t>(2 * values.size()));
  const Bytes data = pdu(0, values);
  request.insert(request.end(), data.begin() + 1, data.end());
  const auto answer = ask(request);
  if (answer && answer->size() == 2 && answer->at(0) == 0x90) return answer->at(1);
  if (!answer || *answer != Bytes(request.begin(), request.begin() + 5)) {
    throw std::runtime_error(fmt::format("writing {:#x}: no right answer", address));
  }
  return 0;
}

void Client::command(int value) {
  const int wrong = write(c::holding_command, {low(value)});
  if (wrong != 0) throw std::runtime_error(fmt::format("command {}: exception {}", value, wrong));
}

int Client::begin(const Words& file, std::uint32_t crc) {
  const int wrong =
      write(c::holding_load_length, {low(file.size()), high(file.size()), low(crc), high(crc)});
  return wrong != 0 ? wrong : write(c::holding_load_command, {1});
}

int Client::window(const Words& file, std::size_t at, std::size_t offset) {
  Words values{low(offset), high(offset)};
  const std::size_t end = std::min(file.size(), at + c::holding_window_count);
  values.insert(values.end(), file.begin() + static_cast<std::ptrdiff_t>(at),
                file.begin() + static_cast<std::ptrdiff_t>(end));
  return write(c::holding_window_offset, values);
}

int Client::windows(const Words& file) {
  for (std::size_t at = 0; at < file.size(); at += c::holding_window_count) {
    const int wrong = window(file, at, at);
    if (wrong != 0) return wrong;
  }
  return 0;
}

int Client::commit() {
  const int wrong = write(c::holding_load_command, {2});
  if (wrong != 0) return -wrong;
  for (int i = 0; i < kCommitPolls; ++i) {
    const int state = holding(c::holding_load_state);
    if (state != 1) return state;
  }
  throw std::runtime_error("a commit that does not end");
}

int Client::download(const Words& file) {
  int wrong = begin(file, load::crc32(file));
  if (wrong == 0) wrong = windows(file);
  return wrong != 0 ? -wrong : commit();
}

bool full() {
  const char* const value = std::getenv("RUNG_RELIABILITY");
  return value != nullptr && std::string(value) == "full";
}

std::uint64_t count(std::uint64_t sample, std::uint64_t all) { return full() ? all : sample; }

std::uint64_t base_seed() {
  const char* const value = std::getenv("RUNG_SEED");
  const std::uint64_t seed = value != nullptr ? std::strtoull(value, nullptr, 10) : 1;
  fmt::print("seed {0}; replay: {1}RUNG_SEED={0} reliability --gtest_filter={2}.{3}\n", seed,
             full() ? "RUNG_RELIABILITY=full " : "",
             testing::UnitTest::GetInstance()->current_test_info()->test_suite_name(),
             testing::UnitTest::GetInstance()->current_test_info()->name());
  return seed;
}

void note(const std::string& key, const std::string& value) {
  fmt::print("{}: {}\n", key, value);
  testing::Test::RecordProperty(key, value);
}
void note(const std::string& key, std::uint64_t value) { note(key, std::to_string(value)); }

std::unique_ptr<SimulatedController> make_controller(const std::string& board, std::uint64_t seed,
                                                     bool quick_flash) {
  ControllerSetup setup;
  setup.board = board;
  setup.line = ControllerSetup::Line::Bytes;
  setup.seed = seed;
  if (quick_flash) {
    setup.flash_times =
        FlashTimes{.page_program = 200, .sector_erase = 500, .block_erase = 1000, .wake = 1};
  }
  return SimulatedController::make(setup);
}

void install(SimulatedController& controller, Client& client, const Words& file) {
  static_cast<void>(controller);
  const int state = client.download(file);
  if (state != 2) throw std::runtime_error(fmt::format("installing: load_state {}", state));
}

bool run_until(SimulatedController& controller, const std::function<bool()>& condition,
               std::uint64_t clocks, std::uint64_t step) {
  for (std::uint64_t i = 0; i < clocks; i += step) {
    if (condition()) return true;
    controller.run(step);
  }
  return condition();
}

}  // namespace rung::tb
