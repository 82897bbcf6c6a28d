// SPDX-License-Identifier: Apache-2.0
#include "host/fake_controller.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

using namespace controller;

constexpr int kIllegalFunction = 1, kIllegalAddress = 2, kIllegalValue = 3, kBusy = 6;
constexpr int kOk = 0;
constexpr int kUnderWay = 1, kDone = 2, kWrongCrc = 3;
constexpr int kPollMs = 20;

int word_at(const Bytes& bytes, std::size_t at) { return bytes.at(at) << 8 | bytes.at(at + 1); }
void push(Bytes& bytes, int word) {
  bytes.push_back(static_cast<std::uint8_t>(word >> 8));
  bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
}
Bytes exception(const Bytes& request, int code) {
  return {static_cast<std::uint8_t>(request[0] | 0x80), static_cast<std::uint8_t>(code)};
}

// CRC-16 of RTU, low byte first on the line.
std::uint16_t crc16(const Bytes& bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint16_t>(crc ^ byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? crc >> 1 ^ 0xA001 : crc >> 1);
    }
  }
  return crc;
}

// Takes counts down to 0; true as long as there was one.
bool use_up(std::atomic<int>& count) {
  if (count == 0) return false;
  --count;
  return true;
}

bool readable(int file) {
  pollfd waits{file, POLLIN, 0};
  return poll(&waits, 1, kPollMs) > 0;
}

}  // namespace

FakeController::FakeController(Line line) {
  registers_[holding_identity] = 0x5247;
  registers_[holding_interface] = 1;
  registers_[holding_board] = 0;
  registers_[holding_config] = 1;
  registers_[holding_mpu] = 3;
  registers_[holding_tables] = tables;
  registers_[holding_state] = 4;
  registers_[holding_exchange_points] = 2000;
  if (line == Line::Tcp) {
    file_ = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(file_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(file_, 1) != 0 ||
        getsockname(file_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no loopback");
    }
    port_ = "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
    thread_ = std::thread([this] { serve_tcp(); });
  } else {
    int slave = -1;
    char name[64];
    if (openpty(&file_, &slave, name, nullptr, nullptr) != 0) throw std::runtime_error("no pty");
    termios raw{};
    tcgetattr(slave, &raw);
    cfmakeraw(&raw);
    tcsetattr(slave, TCSANOW, &raw);
    // The slave stays open here: else the master hangs up when a client closes it.
    port_ = name;
    thread_ = std::thread([this, slave] {
      serve_rtu();
      close(slave);
    });
  }
}

FakeController::~FakeController() {
  stop_ = true;
  thread_.join();
  close(file_);
}

void FakeController::set_register(int address, std::uint16_t value) {
  const std::lock_guard lock(mutex_);
  registers_[address] = value;
}
std::uint16_t FakeController::register_at(int address) {
  const std::lock_guard lock(mutex_);
  return registers_[address];
}
void FakeController::set_bit(int address, bool value) {
  const std::lock_guard lock(mutex_);
  bits_[address] = value;
}
void FakeController::set_word(int address, std::uint16_t value) { set_register(address, value); }
void FakeController::allow_force(int address) {
  const std::lock_guard lock(mutex_);
  may_force_[address] = true;
}
std::vector<std::uint16_t> FakeController::program() {
  const std::lock_guard lock(mutex_);
  return program_;
}
std::vector<int> FakeController::commands() {
  const std::lock_guard lock(mutex_);
  return commands_;
}
int FakeController::requests() {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void FakeController::serve_tcp() {
  constexpr std::size_t kHead = 7;
  while (!stop_) {
    if (!readable(file_)) continue;
    const int client = accept(file_, nullptr, nullptr);
    Bytes got;
    while (!stop_) {
      if (!readable(client)) continue;
      std::uint8_t part[512];
      const ssize_t count = read(client, part, sizeof part);
      if (count <= 0) break;
      got.insert(got.end(), part, part + count);
      while (got.size() >= kHead &&
             got.size() >= static_cast<std::size_t>(word_at(got, 4)) + kHead - 1) {
        const std::size_t end = static_cast<std::size_t>(word_at(got, 4)) + kHead - 1;
        const Bytes request(got.begin() + kHead, got.begin() + static_cast<std::ptrdiff_t>(end));
        const int unit = got[6];
        Bytes reply(got.begin(), got.begin() + 4);
        got.erase(got.begin(), got.begin() + static_cast<std::ptrdiff_t>(end));
        if (unit != unit_) continue;
        const Bytes pdu = answer(request);
        if (use_up(drop)) continue;
        push(reply, static_cast<int>(pdu.size() + 1));
        reply.push_back(static_cast<std::uint8_t>(unit));
        reply.insert(reply.end(), pdu.begin(), pdu.end());
        static_cast<void>(write_all(client, reply));
      }
    }
    close(client);
  }
}

void FakeController::serve_rtu() {
  Bytes frame;
  while (!stop_) {
    if (!readable(file_)) {
      frame.clear();  // silence
      continue;
    }
    std::uint8_t part[512];
    const ssize_t count = read(file_, part, sizeof part);
    if (count <= 0) continue;
    frame.insert(frame.end(), part, part + count);
    const bool sized = frame.size() >= 2 && frame[1] == 16;
    if (frame.size() < 8 || (sized && frame.size() < 9U + frame[6])) continue;
    const std::size_t length = sized ? 9U + frame[6] : 8U;
    const Bytes body(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(length - 2));
    const auto crc = static_cast<std::uint16_t>(frame[length - 2] | frame[length - 1] << 8);
    frame.clear();
    if (crc != crc16(body) || body[0] != unit_) continue;
    Bytes reply{body[0]};
    const Bytes pdu = answer(Bytes(body.begin() + 1, body.end()));
    if (use_up(drop)) continue;
    reply.insert(reply.end(), pdu.begin(), pdu.end());
    const auto sum = static_cast<std::uint16_t>(crc16(reply) ^ (use_up(garble) ? 1 : 0));
    reply.push_back(static_cast<std::uint8_t>(sum & 0xFF));
    reply.push_back(static_cast<std::uint8_t>(sum >> 8));
    static_cast<void>(write_all(file_, reply));
  }
}

bool FakeController::write_all(int file, const Bytes& bytes) {
  return ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

Bytes FakeController::answer(const Bytes& request) {
  const std::lock_guard lock(mutex_);
  ++requests_;
  if (use_up(busy)) return exception(request, kBusy);
  switch (request.at(0)) {
    case 1:
    case 2:
      return read_bits(request);
    case 3:
      return read_words(request);
    case 6:
      return write(6, word_at(request, 1), {static_cast<std::uint16_t>(word_at(request, 3))});
    case 16: {
      std::vector<std::uint16_t> words;
      for (std::size_t at = 6; at + 1 < request.size(); at += 2) {
        words.push_back(static_cast<std::uint16_t>(word_at(request, at)));
      }
      return write(16, word_at(request, 1), words);
    }
    default:
      return exception(request, kIllegalFunction);
  }
}

Bytes FakeController::read_bits(const Bytes& request) {
  const int first = word_at(request, 1);
  const int count = word_at(request, 3);
  if (count > registers_[holding_exchange_points]) return exception(request, kIllegalValue);
  Bytes out{request[0], static_cast<std::uint8_t>((count + 7) / 8)};
  out.resize(2 + static_cast<std::size_t>((count + 7) / 8), 0);
  for (int i = 0; i < count; ++i) {
    const auto bit = bits_.find(first + i);
    if (bit == bits_.end()) return exception(request, kIllegalAddress);
    if (bit->second)
      out[2 + static_cast<std::size_t>(i / 8)] |= static_cast<std::uint8_t>(1 << i % 8);
  }
  return out;
}

Bytes FakeController::read_words(const Bytes& request) {
  const int first = word_at(request, 1);
  const int count = word_at(request, 3);
  if (first == holding_load_state && registers_[holding_load_state] == kUnderWay &&
      polls_left_ > 0 && --polls_left_ == 0) {
    commit();
  }
  Bytes out{request[0], static_cast<std::uint8_t>(2 * count)};
  const std::uint32_t offset = wide(holding_window_offset);
  std::vector<std::uint16_t> list;
  for (const auto& [address, value] : forces_) {
    list.push_back(static_cast<std::uint16_t>(address | (value ? 0x8000 : 0)));
  }
  list.resize(holding_force_list_count, 0x7FFF);
  for (int address = first; address < first + count; ++address) {
    const bool own = address >= holding_identity;
    if (address >= holding_window && address < holding_window + holding_window_count) {
      const auto at = offset + static_cast<std::uint32_t>(address - holding_window);
      push(out, at < program_.size() ? program_[at] : 0);
    } else if (address >= holding_force_list &&
               address < holding_force_list + holding_force_list_count) {
      push(out, list[static_cast<std::size_t>(address - holding_force_list)]);
    } else if (address == holding_force_count) {
      push(out, static_cast<int>(forces_.size()));
    } else if (own || registers_.contains(address)) {
      push(out, registers_[address]);
    } else {
      return exception(request, kIllegalAddress);
    }
  }
  return out;
}

Bytes FakeController::write(int function, int address, const std::vector<std::uint16_t>& words) {
  const Bytes asked{static_cast<std::uint8_t>(function)};
  Bytes out = asked;
  push(out, address);
  push(out, function == 6 ? words.at(0) : static_cast<int>(words.size()));
  if (address == holding_window_offset && words.size() > 2) {
    const std::size_t at = words[0] | static_cast<std::size_t>(words[1]) << 16;
    const bool whole =
        at % 64 == 0 && (words.size() == 66 || at + words.size() - 2 == incoming_.size());
    if (registers_[holding_load_state] != kUnderWay || !whole)
      return exception(asked, kIllegalValue);
    for (std::size_t i = 2; i < words.size(); ++i) incoming_.at(at + i - 2) = words[i];
    if (use_up(damage)) incoming_.at(at) = static_cast<std::uint16_t>(incoming_[at] ^ 4);
    return out;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int code = written(address + static_cast<int>(i), words[i]);
    if (code != kOk) return exception(asked, code);
  }
  return out;
}

int FakeController::written(int address, std::uint16_t value) {
  registers_[address] = value;
  switch (address) {
    case holding_command:
      commands_.push_back(value);
      if (value == 3 && registers_[holding_state] != 0) return kIllegalValue;
      if (value == 1) registers_[holding_state] = 1;
      if (value == 2) registers_[holding_state] = 0;
      if (value == 7) forces_.clear();
      return kOk;
    case holding_force_value: {
      const int point = registers_[holding_force_point];
      if (!may_force_.contains(point)) return kIllegalAddress;
      if (value == 2) {
        forces_.erase(point);
      } else {
        forces_[point] = value == 1;
      }
      return kOk;
    }
    case holding_load_command:
      if (value == 1) {
        incoming_.assign(wide(holding_load_length), 0);
        registers_[holding_load_state] = kUnderWay;
        polls_left_ = 0;
      } else if (value == 2) {
        polls_left_ = 3;
        if (unit_after_commit != 0) unit_ = unit_after_commit;
      } else {
        registers_[holding_load_state] = 0;
      }
      return kOk;
    default:
      return kOk;
  }
}

void FakeController::commit() {
  const bool whole = load::crc32(incoming_) == wide(holding_load_crc);
  registers_[holding_load_state] = static_cast<std::uint16_t>(load_ends != 0 ? load_ends.load()
                                                              : whole        ? kDone
                                                                             : kWrongCrc);
  if (registers_[holding_load_state] != kDone) return;
  program_ = incoming_;
  registers_[holding_state] = 1;
  set_wide(holding_program_length, static_cast<std::uint32_t>(program_.size()));
  set_wide(holding_program_crc, load::crc32(program_));
  set_wide(holding_program_generation, wide(holding_program_generation) + 1);
}

std::uint32_t FakeController::wide(int address) {
  return registers_[address] | static_cast<std::uint32_t>(registers_[address + 1]) << 16;
}
void FakeController::set_wide(int address, std::uint32_t value) {
  registers_[address] = static_cast<std::uint16_t>(value & 0xFFFF);
  registers_[address + 1] = static_cast<std::uint16_t>(value >> 16);
}

}  // namespace rung::tb
