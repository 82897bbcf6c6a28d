// SPDX-License-Identifier: Apache-2.0
// The firmware (hdl/controller/micro/firmware), compiled for this machine with the sanitizers, over
// the model of its registers: requests, and what lies in the flash when it starts.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "device/flash_image.hpp"
#include "firmware/flash.hpp"
#include "firmware/load_file.hpp"
#include "firmware/machine.hpp"
#include "firmware/native.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "io/map.hpp"
#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::fuzz {
namespace {

namespace c = controller;
using tb::Bytes;
using tb::Words;

constexpr std::size_t kFlashBytes = std::size_t{1} << 20;
constexpr int kFlashBase = 1;                 // of the machine
constexpr std::uint64_t kBudget = 8'000'000;  // accesses, of a poll
constexpr std::uint8_t kUnit = 17;            // of the sample program
constexpr int kMostPolls = 64;
constexpr std::size_t kMostFrame = 254;

tb::Flash& flash() {
  static tb::Flash flash(kFlashBytes);
  return flash;
}

class Firmware {
 public:
  Firmware() : machine_(std::make_unique<tb::Machine>(flash())) {
    native_ = std::make_unique<tb::Native>(*machine_);
    machine_->budget = machine_->accesses + kBudget;
    native_->reset();
  }
  // A copy where `other` is; the flash is for its user to put back.
  Firmware(const Firmware& other)
      : machine_(std::make_unique<tb::Machine>(*other.machine_)),
        native_(std::make_unique<tb::Native>(*other.native_, *machine_)) {}
  Firmware& operator=(const Firmware&) = delete;
  ~Firmware() = default;

  tb::Machine& machine() { return *machine_; }
  void poll() {
    machine_->budget = machine_->accesses + kBudget;
    native_->poll();
  }
  // The answer; none: nothing was sent.
  std::optional<Bytes> send(const Bytes& frame) {
    machine_->sent.clear();
    machine_->sending = 0;
    machine_->receive(frame);
    for (int i = 0; i < kMostPolls && machine_->waiting; ++i) poll();
    require(!machine_->waiting, "a frame is not taken");
    require(machine_->sent.size() <= 1, "two answers");
    if (machine_->sent.empty()) return std::nullopt;
    return machine_->sent.front();
  }
  bool answers(std::uint8_t unit) {
    const auto answer = send({unit, 3, c::holding_identity >> 8, c::holding_identity & 0xFF, 0, 1});
    return answer == Bytes{unit, 3, 2, 0x52, 0x47};
  }
  // `flash_works`: it was never busy for ever, after which commands come to a busy one.
  void keep_rules(bool flash_works) {
    require(machine_->points_too_many == 0, "an exchange of too many points");
    require(machine_->loads_while_running == 0, "the processor is loaded while it runs");
    require(!flash_works || flash().violations == 0, "the flash is misused");
    require(!testing::Test::HasFailure(), "the machine has found a fault");
  }

 private:
  std::unique_ptr<tb::Machine> machine_;
  std::unique_ptr<tb::Native> native_;
};

// With the sample program in it, that runs.
struct Start {
  std::unique_ptr<Firmware> firmware;
  tb::Flash flash_then{kFlashBytes};

  Start() {
    const Words words = tb::sample_program(1).words();
    controller::Board board = *io::find_board("hx8k");
    board.flash_base = kFlashBase;
    device::put_program(flash().data(), board, words);
    firmware = std::make_unique<Firmware>();
    flash_then = flash();
  }
};

void check_answer(const Bytes& frame, const std::optional<Bytes>& answer, std::uint8_t unit) {
  if (frame.size() < 2 || frame[0] != unit) {
    require(!answer || frame.size() < 2, "an answer to another unit's frame");
    return;
  }
  require(answer && answer->size() >= 2 && answer->size() <= kMostFrame, "no answer");
  require(answer->at(0) == unit && (answer->at(1) & 0x7F) == (frame[1] & 0x7F),
          "an answer to something else");
  if (frame[1] >= 128 || (answer->at(1) & 0x80) != 0) {
    require(answer->size() == 3 && answer->at(2) >= 1 && answer->at(2) <= 6,
            "an exception that is none");
  } else if (frame[1] <= 4 || frame[1] == 23) {
    require(answer->size() == 3U + answer->at(2), "an answer of another length than it says");
  }
}

// What the compiler's reader says of files and the firmware does not ask.
bool is_lenient(const std::string& problem) {
  return problem.find("is set twice") != std::string::npos ||
         problem.find("has no address") != std::string::npos ||
         problem.find("of its header is not 0") != std::string::npos;
}

// A bit is 0 or 1 in what the compiler writes; the firmware hands on what there is.
bool has_only_bits(const Words& file) {
  for (std::size_t at = 16; at + 2 < file.size() && file[at] != 0; at += 2 + (file[at] & 0xFFU)) {
    const std::size_t end = std::min(file.size(), at + 2 + (file[at] & 0xFFU));
    if (file[at] >> 12U != c::space_bits) continue;
    for (std::size_t i = at + 2; i < end; ++i) {
      if (file[i] > 1) return false;
    }
  }
  return true;
}

void start_with(const Words& file) {
  Firmware firmware;
  const bool loaded = firmware.machine().state != 3;
  std::string problem;
  const auto contents = load::read(file, problem);
  require(!loaded || contents || is_lenient(problem), "it loads what is no load file: " + problem);
  firmware.poll();
  // Without a program it is unit 1; a file may say anything.
  int unit = 1;
  if (loaded) {
    unit = contents ? contents->at(c::space_host, c::host_unit).value_or(1) : 0;
  }
  require(unit < 1 || unit > 247 || firmware.answers(static_cast<std::uint8_t>(unit)),
          "a good request is not answered");
  firmware.keep_rules(true);
}

}  // namespace

// Requests, polls, power cuts, the switch, a flash that does not write, time: each frame for the
// unit has an answer by the protocol, and at the end a good one has its.
void read_modbus(std::string_view bytes) {
  static const Start start;
  flash() = start.flash_then;
  auto firmware = std::make_unique<Firmware>(*start.firmware);
  Input input(bytes);
  bool flash_works = true;
  for (int n = 0; !input.empty() && n < 100; ++n) {
    switch (input.below(16)) {
      case 0:
        firmware->machine().run_switch = !firmware->machine().run_switch;
        break;
      case 1:
        firmware->machine().keep_wanted = true;
        break;
      case 2:
        flash().ignores_writes = !flash().ignores_writes;
        break;
      case 3:
        flash().stuck_busy = !flash().stuck_busy;
        flash_works = false;
        break;
      case 4:
        firmware->machine().milliseconds_offset += input.word();
        break;
      case 5:
        if (input.below(4) == 0) {
          flash().power_up();
          flash().stuck_busy = false;
          firmware = std::make_unique<Firmware>();
        }
        break;
      case 6: {
        Bytes frame = input.bytes(2 + input.below(kMostFrame - 2));
        if (frame.size() < 2) break;
        check_answer(frame, firmware->send(frame), kUnit);
        break;
      }
      default: {
        Bytes frame{kUnit};
        const Bytes pdu = input.bytes(1 + input.below(kMostFrame - 1));
        frame.insert(frame.end(), pdu.begin(), pdu.end());
        if (frame.size() < 2) break;
        check_answer(frame, firmware->send(frame), kUnit);
      }
    }
    firmware->poll();
    firmware->keep_rules(flash_works);
  }
  flash().ignores_writes = flash().stuck_busy = false;
  for (int i = 0; i < 4; ++i) firmware->poll();
  require(firmware->answers(kUnit), "a good request is not answered");
  firmware->keep_rules(flash_works);
}

// The input as a load file with a right header and CRC in the first copy; what is behind it, the
// ring of saved values. A file that the firmware takes is one to the compiler's reader too.
void read_flash(std::string_view bytes) {
  Input input(bytes);
  tb::Flash& there = flash();
  there = tb::Flash(kFlashBytes);
  Words words;
  const std::size_t count = input.word() % 2048;
  for (std::size_t i = 0; i < count && !input.empty(); ++i) words.push_back(input.word());
  Words file(16);
  file[0] = 0x5250;
  file[1] = 1;
  file[2] = c::tables;
  file[3] = tb::LoadFile().config;
  file[5] = 3;
  file[10] = static_cast<std::uint16_t>(1 + input.below(8));
  file.insert(file.end(), words.begin(), words.end());
  file[6] = static_cast<std::uint16_t>(file.size());
  if (input.below(16) == 0) file[input.below(16)] ^= input.word();
  controller::Board board = *io::find_board("hx8k");
  board.flash_base = kFlashBase;
  device::put_program(there.data(), board, file);
  const std::size_t ring =
      (kFlashBase + 2 * c::flash_copy_sectors) * std::size_t{c::flash_sector_bytes};
  const Bytes behind = input.bytes(8192);
  std::copy(behind.begin(), behind.end(), there.data().begin() + static_cast<std::ptrdiff_t>(ring));

  if (!has_only_bits(file)) return;
  try {
    start_with(file);
  } catch (const std::out_of_range&) {
    // An address that this configuration does not have: the compiler makes no such file, and the
    // hardware leaves it out.
  }
}

}  // namespace rung::fuzz
