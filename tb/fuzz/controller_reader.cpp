// SPDX-License-Identifier: Apache-2.0
// The whole controller of the HX8K board, Verilated, with its firmware; started once, and brought
// back to where it was behind each input.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "Vcontroller_hx8k_bytes.h"
#include "controller/modbus_crc.hpp"
#include "controller/verilated_controller.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "io/map.hpp"
#include "reliability/client.hpp"
#include "reliability/program.hpp"
#include "rung_controller.hpp"

namespace rung::fuzz {
namespace {

namespace c = controller;
using tb::Bytes;
using tb::Words;
using Machine =
    tb::VerilatedController<Vcontroller_hx8k_bytes, tb::BytesOfLine<Vcontroller_hx8k_bytes>>;

constexpr std::uint8_t kUnit = 1;
constexpr std::uint64_t kGap = 160;              // of the line between two frames
constexpr std::uint64_t kPatience = 20'000'000;  // longer than anything takes
constexpr std::uint64_t kNoAnswer = 1'500;       // behind a frame for nobody
constexpr std::uint64_t kBroadcast = 20'000;
constexpr std::uint64_t kAnswerEnds = 150;
constexpr std::size_t kLongest = 256;
constexpr int kGuards = 16;  // D0 to D15
constexpr int kMostFrames = 20;

// Copies, relays and an output, so that there is something of everything to read and write.
std::string list() {
  std::string text = "LD X0\nOUT Y0\nLD X1\nOUT T0 K3\nLD T0\nOUT C0 K5\nLD M98\n";
  for (int n = 0; n < kGuards; n += 2) text += fmt::format("MOV D{} D{}\n", n, n + 1);
  for (int n = 0; n < 16; ++n) text += fmt::format("LD M{}\nAND M98\nOUT M{}\n", n, n + 16);
  return text + "END\n";
}

constexpr const char* kMap =
    "board = \"hx8k\"\n[controller]\nexchange_points = 64\n[latched]\ndevices = []\n[inputs]\n"
    "X0 = \"t1\"\nX1 = \"t2\"\n[outputs]\nY0 = \"t5\"\n";

// Where requests find something, or end.
constexpr int kAddresses[] = {0,
                              8,
                              96,
                              c::holding_identity,
                              c::holding_scan_count,
                              c::holding_command,
                              c::holding_force_point,
                              c::holding_force_list,
                              c::holding_load_command,
                              c::holding_load_length,
                              c::holding_window_offset,
                              c::holding_window,
                              0xFFF8};
constexpr std::uint8_t kFunctions[] = {1, 2, 3, 4, 5, 6, 8, 15, 16, 22, 23, 43};

class Bench {
 public:
  Bench() : machine_(make_machine()), client_(*machine_) {
    tb::Made made = tb::make_program(list(), kMap);
    tb::quicken(made.words);
    cycle_ = made.timing.cycle;
    require(client_.download(made.words) == 2, "no program to begin with");
    client_.gap = kGap;
    client_.patience = kPatience;
    restore();
  }

  void run(Input input) {
    touched_ = false;
    for (int frames = 0; !input.empty() && frames < kMostFrames; ++frames) {
      bool bad_byte = false;
      const Bytes frame = next(input, bad_byte);
      if (frame.empty()) {
        machine_->run(input.word());
      } else {
        exchange(frame, bad_byte);
      }
    }
    if (!touched_) {
      require(client_.read(0, kGuards) == guards(), "a device has changed that no request wrote");
      require(client_.holding(c::holding_state) == 1, "it has stopped");
    }
    restore();
  }

 private:
  static std::unique_ptr<Machine> make_machine() {
    tb::ControllerSetup setup;
    setup.board = "hx8k";
    setup.line = tb::ControllerSetup::Line::Bytes;
    return std::make_unique<Machine>(
        *io::find_board("hx8k"), setup, std::size_t{1} << 21,
        tb::FlashTimes{.page_program = 200, .sector_erase = 500, .block_erase = 1000, .wake = 1});
  }
  static Words guards() {
    Words words;
    for (int n = 0; n < kGuards; ++n) words.push_back(static_cast<std::uint16_t>(0xA500 + 257 * n));
    return words;
  }

  // What goes onto the line; nothing for a pause.
  static Bytes next(Input& input, bool& bad_byte) {
    Bytes frame{kUnit};
    const unsigned kind = input.below(8);
    if (kind == 0) return {};
    if (kind == 1) return input.bytes(1 + input.below(300));
    if (kind == 2) {
      frame = input.bytes(2 + input.below(253));
    } else {
      const std::uint8_t function = kFunctions[input.below(std::size(kFunctions))];
      const int address = kAddresses[input.below(std::size(kAddresses))] + input.byte() % 8;
      frame.push_back(kind == 3 ? input.byte() : function);
      frame.push_back(static_cast<std::uint8_t>(address >> 8));
      frame.push_back(static_cast<std::uint8_t>(address));
      if (function == 16 && kind >= 6) {  // a write whose counts are right
        const std::size_t count = 1 + input.below(16);
        frame.insert(frame.end(),
                     {0, static_cast<std::uint8_t>(count), static_cast<std::uint8_t>(2 * count)});
        const Bytes data = input.bytes(2 * count);
        frame.insert(frame.end(), data.begin(), data.end());
        frame.resize(7 + 2 * count);
      } else {
        const Bytes data = input.bytes(4 + (kind == 4 ? input.below(240) : 0));
        frame.insert(frame.end(), data.begin(), data.end());
      }
    }
    frame = tb::with_crc(frame);
    bad_byte = kind == 5;
    return frame;
  }

  void exchange(const Bytes& frame, bool bad_byte) {
    const bool right =
        !bad_byte && frame.size() >= 4 && frame.size() <= kLongest && tb::modbus_crc(frame) == 0;
    const bool for_us = right && frame[0] == kUnit;
    const bool broadcast = right && frame[0] == 0;
    machine_->run(kGap);
    require(machine_->receive().empty(), "an answer to nothing");
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (bad_byte && i == frame.size() / 2) {
        machine_->send_bad(frame[i]);
      } else {
        machine_->send(frame[i]);
      }
    }
    Bytes answer;
    const std::uint64_t patience = for_us ? kPatience : kNoAnswer;
    for (std::uint64_t quiet = 0; quiet < (answer.empty() ? patience : kAnswerEnds);) {
      machine_->run(50);
      quiet = machine_->sending() > 0 ? 0 : quiet + 50;
      for (const std::uint8_t byte : machine_->receive()) {
        answer.push_back(byte);
        quiet = 0;
      }
    }
    if (!for_us) {
      require(answer.empty(), "an answer to a frame that is none of this unit's");
      if (broadcast) machine_->run(kBroadcast);
      touched_ = touched_ || broadcast;
      return;
    }
    require(answer.size() >= 5 && answer.size() <= kLongest && tb::modbus_crc(answer) == 0,
            "an answer that is no frame");
    require(answer[0] == kUnit && (answer[1] & 0x7F) == (frame[1] & 0x7F),
            "an answer to something else");
    const bool exception = (answer[1] & 0x80) != 0;
    require(!exception || (answer.size() == 5 && answer[2] >= 1 && answer[2] <= 6),
            "an exception that is none");
    if (!exception && frame[1] >= 5 && frame[1] != 8 && frame[1] != 43) touched_ = true;
  }

  // As at the beginning, with everything that takes a good client.
  void restore() {
    for (int i = 0; client_.write(c::holding_load_command, {3}) != 0; ++i) {
      require(i < 1000, "a commit that does not end");
    }
    int state = client_.holding(c::holding_state);
    if (state == 3) client_.command(5);
    client_.command(7);
    state = client_.holding(c::holding_state);
    if (state != 1) client_.command(1);
    require(client_.write(0, guards()) == 0, "a good write is refused");
    client_.command(4);
    machine_->run(3 * static_cast<std::uint64_t>(cycle_));
    const Words clocks = client_.read(c::holding_scan_last, 6);
    for (const int at : {0, 2, 4})
      require(clocks[static_cast<std::size_t>(at)] == cycle_, "a scan of other clocks");
    require(client_.holding(c::holding_identity) == 0x5247, "no identity");
    machine_->changes();
  }

  std::unique_ptr<Machine> machine_;
  tb::Client client_;
  std::int64_t cycle_ = 0;
  bool touched_ = false;
};

}  // namespace

// A right frame for this unit has one answer, which is its own; nothing else has any. No device
// changes that no request writes; scans stay as long as they are; and a good client finds all well.
void read_controller(std::string_view bytes) {
  static Bench bench;
  bench.run(Input(bytes));
}

}  // namespace rung::fuzz
