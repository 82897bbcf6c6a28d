// SPDX-License-Identifier: Apache-2.0
#include "reliability/client.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::uint64_t kStep = 64;
// Longer than the controller ever leaves between two bytes of an answer.
constexpr std::uint64_t kAnswerGap = 6 * 16;
constexpr int kCommitPolls = 2000;

}  // namespace

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
    const std::uint64_t at = *cut_at;
    cut_at.reset();
    if (at > controller_.now()) run(at - controller_.now());
    throw Cut{};
  }
  if (advance) {
    advance(clocks);
  } else {
    controller_.run(clocks);
  }
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
  if (answer.size() < 4 || modbus_crc(answer) != 0 || answer[0] != unit) return std::nullopt;
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

}  // namespace rung::tb
