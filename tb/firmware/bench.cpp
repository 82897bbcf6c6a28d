// SPDX-License-Identifier: Apache-2.0
#include "bench.hpp"

#include <algorithm>

namespace rung::tb {
namespace {

namespace c = controller;
constexpr std::uint64_t kPollBudget = 8'000'000;

std::uint16_t low(std::size_t value) { return static_cast<std::uint16_t>(value); }
std::uint16_t high(std::size_t value) { return static_cast<std::uint16_t>(value >> 16U); }

}  // namespace

Bytes pdu(int function, const Words& words) {
  Bytes out{static_cast<std::uint8_t>(function)};
  for (const std::uint16_t word : words) {
    out.push_back(static_cast<std::uint8_t>(word >> 8U));
    out.push_back(static_cast<std::uint8_t>(word));
  }
  return out;
}

Bench::Bench() { power_on(); }

void Bench::power_on(bool run_switch) {
  machine_ = std::make_unique<Machine>(flash_);
  machine_->run_switch = run_switch;
  machine_->board = board_;
  firmware_ = std::make_unique<Native>(*machine_);
  machine_->budget = machine_->accesses + kPollBudget;
  firmware_->reset();
}

void Bench::poll(int times) {
  for (int i = 0; i < times; ++i) {
    machine_->budget = machine_->accesses + kPollBudget;
    firmware_->poll();
  }
}

Bytes Bench::send(const Bytes& frame) {
  machine_->sent.clear();
  machine_->receive(frame);
  for (int i = 0; i < 8 && machine_->waiting; ++i) poll();
  EXPECT_FALSE(machine_->waiting) << "frame is not taken";
  EXPECT_LE(machine_->sent.size(), 1U);
  return machine_->sent.empty() ? Bytes{} : machine_->sent[0];
}

Bytes Bench::ask(const Bytes& pdu) {
  Bytes frame{unit_};
  frame.insert(frame.end(), pdu.begin(), pdu.end());
  Bytes out = send(frame);
  if (out.empty()) return out;
  EXPECT_EQ(out[0], unit_);
  out.erase(out.begin());
  return out;
}

Words Bench::read(int address, int count) {
  const Bytes out = ask(pdu(3, {low(address), low(count)}));
  Words words;
  if (out.size() != 2U + 2U * count || out[0] != 3 || out[1] != 2 * count) {
    ADD_FAILURE() << "reading " << address << ": " << (out.size() == 2 ? out[1] : -1);
    return Words(count);
  }
  for (int i = 0; i < count; ++i) words.push_back(low(out[2 + 2 * i] << 8 | out[3 + 2 * i]));
  return words;
}

int Bench::write(int address, const Words& values) {
  Bytes frame = pdu(16, {low(address), low(values.size())});
  frame.push_back(static_cast<std::uint8_t>(2 * values.size()));
  const Bytes data = pdu(0, values);
  frame.insert(frame.end(), data.begin() + 1, data.end());
  const Bytes out = ask(frame);
  if (out.size() == 2 && out[0] == 0x90) return out[1];
  EXPECT_EQ(out, Bytes(frame.begin(), frame.begin() + 5));
  return 0;
}

int Bench::begin(const Words& file) {
  const std::uint32_t crc = crc_of(file);
  EXPECT_EQ(
      write(c::holding_load_length, {low(file.size()), high(file.size()), low(crc), high(crc)}), 0);
  return write(c::holding_load_command, {1});
}

int Bench::windows(const Words& file) {
  for (std::size_t at = 0; at < file.size(); at += c::holding_window_count) {
    Words values{low(at), high(at)};
    const std::size_t end = std::min(file.size(), at + c::holding_window_count);
    values.insert(values.end(), file.begin() + static_cast<long>(at),
                  file.begin() + static_cast<long>(end));
    const int wrong = write(c::holding_window_offset, values);
    if (wrong != 0) return wrong;
  }
  return 0;
}

int Bench::commit() {
  const int wrong = write(c::holding_load_command, {2});
  if (wrong != 0) return -wrong;
  for (int i = 0; i < 60; ++i) poll();
  // The program's unit may be another one.
  for (const std::uint8_t unit : {std::uint8_t{1}, std::uint8_t{17}}) {
    unit_ = unit;
    if (!ask(pdu(3, {c::holding_load_state, 1})).empty()) break;
  }
  return holding(c::holding_load_state);
}

int Bench::download(const Words& file, int crc_error) {
  int wrong = begin(file);
  if (wrong == 0) wrong = windows(file);
  if (wrong != 0) return -wrong;
  if (crc_error != 0) {
    const std::uint16_t crc = low(crc_of(file) ^ static_cast<std::uint32_t>(crc_error));
    EXPECT_EQ(write(c::holding_load_crc, {crc}), 0);
  }
  return commit();
}

void Bench::install(const Words& file) { ASSERT_EQ(download(file), 2); }

}  // namespace rung::tb
