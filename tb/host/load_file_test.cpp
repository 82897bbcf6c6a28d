// SPDX-License-Identifier: Apache-2.0
// Load files taken apart and compared with the image and the bindings that they were made of.
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "host/support.hpp"
#include "image/image_file.hpp"
#include "io/modbus_map.hpp"
#include "load/format.hpp"
#include "load/io_list.hpp"
#include "load/latency.hpp"
#include "load/units.hpp"
#include "rungs/ports.hpp"
#include "rungs/special.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;
using namespace controller;

struct Made {
  image::Image image;
  io::Bindings bindings;
  std::vector<std::uint16_t> words;
  load::Contents contents;
  std::string messages;
};

Made make(const Program& program, const std::string& map_text, int mpu = 3,
          const char* config = "ecp5", std::int64_t clock_hz = 25'000'000) {
  Made made;
  Diagnostics diagnostics;
  made.image = image_of(program, mpu, config);
  const io::Subject subject = load::subject_of(made.image);
  const auto map = map_text.empty() ? io::default_map(subject, diagnostics)
                                    : *io::parse_map(map_text, "m.toml", diagnostics);
  made.bindings = io::bind(map, subject, diagnostics);
  const auto words = load::make(made.image, made.bindings, clock_hz, diagnostics);
  made.messages = printed(diagnostics);
  if (!words) return made;
  made.words = *words;
  std::string problem;
  const auto contents = load::read(*words, problem);
  EXPECT_TRUE(contents) << problem;
  if (contents) made.contents = *contents;
  return made;
}

int at(const Made& made, int space, std::uint32_t address) {
  const auto value = made.contents.at(space, address);
  return value ? *value : -1;
}

// What the firmware would put into memories, against the image: steps bit by bit, LUT, constants,
// and the device map of every device.
void expect_as_image(const Made& made) {
  const image::Image& image = made.image;
  const isa::Config& config = *isa::find_config(image.config);
  const int width = isa::slot_bits(image.mpu, config);
  ASSERT_EQ(made.contents.chunks, (width * isa::slots(image.mpu) + 15) / 16);
  std::size_t steps = 0;
  for (const auto& [place, value] : made.contents.values) steps += place.first == space_steps;
  EXPECT_EQ(steps, image.steps.size() * static_cast<std::size_t>(made.contents.chunks));
  for (std::size_t step = 0; step < image.steps.size(); ++step) {
    for (std::size_t slot = 0; slot < image.steps[step].size(); ++slot) {
      std::uint64_t bits = 0;
      for (int bit = 0; bit < width; ++bit) {
        const int place = static_cast<int>(slot) * width + bit;
        const int chunk =
            at(made, space_steps,
               static_cast<std::uint32_t>(step * 8) + static_cast<std::uint32_t>(place / 16));
        ASSERT_GE(chunk, 0);
        bits |= static_cast<std::uint64_t>(chunk >> place % 16 & 1) << bit;
      }
      const auto decoded = isa::decode(bits, image.mpu, config);
      ASSERT_TRUE(decoded) << "step " << step;
      ASSERT_EQ(*decoded, image.steps[step][slot]) << "step " << step;
    }
  }
  EXPECT_EQ(at(made, space_length, 0), static_cast<int>(image.steps.size()));
  for (std::size_t row = 0; row < image.lut.size(); ++row) {
    EXPECT_EQ(at(made, space_lut, static_cast<std::uint32_t>(row)), image.lut[row]);
  }
  for (const image::ImageConstant& each : image.constants) {
    EXPECT_EQ(at(made, space_words, static_cast<std::uint32_t>(each.address)),
              static_cast<std::uint16_t>(each.value));
  }
  const Dialect dialect = *find_dialect(image.dialect);
  std::size_t mapped = 0;
  for (const image::ImageDevice& each : image.devices) {
    if (is_port(each.device.kind)) continue;
    const auto point = io::point_of(each.device, dialect, image.config);
    if (!point) continue;
    ++mapped;
    const int space = is_word(each.device) ? space_word_map : space_bit_map;
    EXPECT_EQ(at(made, space, static_cast<std::uint32_t>(point->index)), 0x8000 | each.address)
        << each.name;
  }
  std::size_t in_file = 0;
  for (const auto& [place, value] : made.contents.values) {
    in_file += place.first == space_word_map || place.first == space_bit_map;
  }
  EXPECT_EQ(in_file, mapped);
}

// Every input of the program is latched, every driven relay and tick word too, all outputs with a
// pin are refreshed, and nothing else is in the list.
void expect_io_list(const Made& made) {
  const image::Image& image = made.image;
  const Dialect dialect = *find_dialect(image.dialect);
  const int latch = at(made, space_setup, setup_latch_count);
  const int refresh = at(made, space_setup, setup_refresh_count);
  ASSERT_EQ(at(made, space_setup, setup_refresh_first), latch);
  std::multiset<std::pair<bool, int>> latched;
  std::multiset<int> refreshed;
  for (int entry = 0; entry < latch + refresh; ++entry) {
    const int address = at(made, space_io, static_cast<std::uint32_t>(2 * entry));
    const int second = at(made, space_io, static_cast<std::uint32_t>(2 * entry + 1));
    ASSERT_GE(address, 0);
    ASSERT_GE(second, 0);
    if (entry < latch) {
      latched.emplace(second >> 15 != 0, address);
    } else {
      refreshed.insert(address);
    }
  }
  std::multiset<std::pair<bool, int>> expected;
  std::multiset<int> outputs;
  for (const image::ImageDevice& each : image.devices) {
    const SpecialRange* special = find_special(each.device, dialect);
    if (each.device.kind == DeviceKind::X || (special != nullptr && is_driven(special->role))) {
      expected.emplace(false, each.address);
    }
    const bool bound = std::any_of(made.bindings.outputs.begin(), made.bindings.outputs.end(),
                                   [&](const auto& line) { return line.device == each.device; });
    if (bound) outputs.insert(each.address);
  }
  for (const image::ImageTicks& each : image.ticks) expected.emplace(true, each.address);
  EXPECT_EQ(latched, expected);
  EXPECT_EQ(refreshed, outputs);
}

std::string file_text(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(LoadFile, EveryGoldenProgramIsInItsFile) {
  int programs = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(RUNG_REPOSITORY) / "tb/golden/programs")) {
    const std::string suffix = entry.path().extension().string();
    if (suffix != ".il" && suffix != ".ld" && suffix != ".csv") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Program program = program_of(file_text(entry.path()), entry.path().string());
    for (const int mpu : {1, 2, 3}) {
      const Made made = make(program, "", mpu);
      if (made.image.devices.size() > 300 && made.words.empty())
        continue;  // more inputs than entries
      ASSERT_FALSE(made.words.empty()) << made.messages;
      expect_as_image(made);
      expect_io_list(made);
    }
    ++programs;
  }
  EXPECT_GE(programs, 20);
}

constexpr const char* kMachine =
    "LD X0\nOR Y0\nANI X1\nOUT Y0\nLD M8013\nOUT Y1\nLD M8002\nSET M600\nLD M0\nOUT T0 K5\nLD "
    "M600\nOUT T250 "
    "K30\nLD X5\nOUT C220 K5\nLD M8000\nMOV D10 D200\nMOV D11 D12\nEND\n";
constexpr const char* kMachineMap = R"(board = "ulx3s"
[controller]
period_ms = 2
watchdog_ms = 100
exchange_points = 300
save_seconds = 7
stop_after_power_up = true
filter_us = 100
[modbus]
unit = 9
baud = 9600
parity = "odd"
[inputs]
X0 = "btn2"
X1 = { pin = "sw1", filter = 6, invert = true }
[outputs]
Y0 = { pin = "led3", safe = "hold" }
Y1 = { pin = "gn0", safe = 1, invert = true }
[analog]
D10 = "adc5"
[pwm]
D12 = { pin = "gp18", hz = 70000 }
)";

TEST(LoadFile, HoldsWhatTheMapSays) {
  const Made made = make(program_of(kMachine), kMachineMap);
  ASSERT_FALSE(made.words.empty()) << made.messages;
  EXPECT_EQ(made.contents.board_id, 1);
  EXPECT_EQ(made.contents.config_id, 1);
  EXPECT_EQ(made.contents.mpu, 3);
  EXPECT_EQ(made.contents.tables, controller::tables);
  const auto wide = [&](int space, int number) {
    return at(made, space, static_cast<std::uint32_t>(number)) |
           at(made, space, static_cast<std::uint32_t>(number) + 1) << 16;
  };
  EXPECT_EQ(wide(space_setup, setup_period_low), 50'000);
  EXPECT_EQ(wide(space_setup, setup_watchdog_low), 2'500'000);
  EXPECT_EQ(at(made, space_setup, setup_exchange_points), 300);
  EXPECT_EQ(at(made, space_setup, setup_filter_clocks), 2499);
  EXPECT_EQ(wide(space_setup, setup_pwm_hz_low), 70'000);
  EXPECT_EQ(at(made, space_setup, setup_filter + 1), 0);
  EXPECT_EQ(at(made, space_setup, setup_filter + 6), 16 + 6);
  EXPECT_EQ(at(made, space_setup, setup_output + 3), 2);
  EXPECT_EQ(at(made, space_setup, setup_output + 4), 1 + 4);
  EXPECT_EQ(at(made, space_host, host_unit), 9);
  // 8 * 2^20 * 9,600 / 25 MHz; 3.5 characters of 11 bits.
  EXPECT_EQ(wide(space_host, host_baud_low), 3221);
  EXPECT_EQ(wide(space_host, host_silence_low), 100'261);
  EXPECT_EQ(at(made, space_host, host_parity), 1);
  EXPECT_EQ(at(made, space_host, host_policy), 2);
  EXPECT_EQ(at(made, space_host, host_save_seconds), 7);
  EXPECT_EQ(at(made, space_host, host_retain_id), made.contents.retain_id);
}

// What the list gives an entry for, device by device.
TEST(LoadFile, TheIoListIsInOrder) {
  const Made made = make(program_of(kMachine), kMachineMap);
  ASSERT_FALSE(made.words.empty()) << made.messages;
  std::map<std::string, std::pair<int, int>> entries;  // kind and index by device
  const int latch = at(made, space_setup, setup_latch_count);
  const int all = latch + at(made, space_setup, setup_refresh_count);
  for (int entry = 0; entry < all; ++entry) {
    const int address = at(made, space_io, static_cast<std::uint32_t>(2 * entry));
    const int second = at(made, space_io, static_cast<std::uint32_t>(2 * entry + 1));
    std::string name = "ticks";
    for (const image::ImageDevice& each : made.image.devices) {
      if (each.address == address && is_word(each.device) == (second >> 15 != 0)) name = each.name;
    }
    if (name == "ticks") name += std::to_string(second & 0xFF);
    entries[name] = {second >> 8 & 0xF, second & 0xFF};
  }
  const std::map<std::string, std::pair<int, int>> expected = {
      {"X0", {latch_pin, 1}},       {"X1", {latch_pin, 6}},       {"X5", {latch_none, 0}},
      {"M8000", {latch_status, 1}}, {"M8002", {latch_status, 2}}, {"M8013", {latch_status, 7}},
      {"ticks2", {latch_ticks, 2}}, {"D10", {latch_adc, 5}},      {"Y0", {refresh_pin, 3}},
      {"Y1", {refresh_pin, 4}},     {"D12", {refresh_pwm, 0}}};
  EXPECT_EQ(entries, expected);
}

TEST(LoadFile, KeepRangesAreTheLatchedDevicesAndTheConstants) {
  const Made made = make(program_of(kMachine), kMachineMap);
  std::set<std::pair<bool, int>> kept;
  for (std::uint32_t range = 0; at(made, space_keep, 4 * range) >= 0; ++range) {
    const int flags = at(made, space_keep, 4 * range);
    EXPECT_EQ(flags & 2, 2);
    for (int i = 0; i < at(made, space_keep, 4 * range + 2); ++i) {
      EXPECT_TRUE(kept.emplace(flags & 1, at(made, space_keep, 4 * range + 1) + i).second);
    }
  }
  std::set<std::pair<bool, int>> expected;
  for (const image::ImageDevice& each : made.image.devices) {
    static const std::set<std::string> kLatched = {"M600",  "TS250", "TN250",  "CS220",
                                                   "CN220", "D200",  "CN220:h"};
    if (kLatched.contains(each.name)) expected.emplace(is_word(each.device), each.address);
  }
  EXPECT_EQ(expected.size(), 7U);
  EXPECT_EQ(kept, expected);
}

// Values are told apart by what they are, not by where they lie.
TEST(LoadFile, TheRetainIdIsThatOfTheLatchedDevices) {
  const auto id = [](const std::string& list) {
    return make(program_of(list), "").contents.retain_id;
  };
  const int first = id("LD X0\nOUT M600\nOUT M601\nEND\n");
  EXPECT_EQ(first, id("LD X0\nOUT M1\nOUT M2\nAND X1\nOUT M600\nOUT M601\nEND\n"));
  EXPECT_NE(first, id("LD X0\nOUT M600\nOUT M602\nEND\n"));
  EXPECT_NE(first, id("LD X0\nOUT M600\nEND\n"));
}

TEST(LoadFile, SixteenRangesAreKeptAndNoMore) {
  const auto list = [](int relays) {
    std::string text = "LD X0\n";
    for (int i = 0; i < 2 * relays; ++i) text += fmt::format("OUT M{}\n", i);
    return text + "END\n";
  };
  const auto map = [](int relays) {
    std::string text = "board = \"simulated\"\n[latched]\ndevices = [";
    for (int i = 0; i < relays; ++i) text += fmt::format("\"M{}\", ", 2 * i);
    return text + "]\n";
  };
  EXPECT_FALSE(make(program_of(list(16)), map(16)).words.empty());
  const Made refused = make(program_of(list(17)), map(17));
  EXPECT_TRUE(refused.words.empty());
  EXPECT_NE(refused.messages.find(
                "error: the devices that are kept lie in 17 ranges; the controller has 16"),
            std::string::npos)
      << refused.messages;
}

TEST(LoadFile, MoreEntriesThanTheListHasAreRefused) {
  std::string text;
  for (int i = 0; i < 256; ++i) text += fmt::format("LD X{:o}\nOUT M{}\n", i, i);
  EXPECT_FALSE(make(program_of(text + "END\n"), "board = \"simulated\"\n").words.empty());
  const Made refused =
      make(program_of(text + "LD M8000\nOUT M300\nEND\n"), "board = \"simulated\"\n");
  EXPECT_TRUE(refused.words.empty());
  EXPECT_NE(refused.messages.find("the controller has room for 256"), std::string::npos)
      << refused.messages;
}

TEST(LoadFile, ClocksThatTheControllerCannotMakeAreRefused) {
  const Program program = program_of(kMachine);
  const auto refused = [&](const std::string& settings, std::int64_t clock_hz, const char* what) {
    const Made made = make(program, "board = \"simulated\"\n" + settings, 3, "ecp5", clock_hz);
    EXPECT_TRUE(made.words.empty()) << settings;
    EXPECT_NE(made.messages.find(what), std::string::npos) << made.messages;
  };
  refused("[modbus]\nbaud = 921600\n", 1'000'000, "cannot make the 921600 baud");
  refused("[controller]\nfilter_us = 3000\n", 25'000'000,
          "a sample of the input filters may be 65536 clocks");
  refused("[controller]\nperiod_ms = 90000\n", 100'000'000,
          "more clocks than the controller counts");
  // A simulated controller, whose millisecond has a thousand clocks.
  const Made slow =
      make(program, "board = \"simulated\"\n[controller]\nperiod_ms = 5\n", 3, "ecp5", 1'000'000);
  EXPECT_EQ(at(slow, space_setup, setup_period_low), 5000);
}

TEST(LoadFile, DevicePortsOfAnLdmicroProgram) {
  const Made made = make(
      program_of(
          "LDmicro0.1\nCYCLE=10000\nBAUD=9600\nIO LIST\nEND\nPROGRAM\nRUNG\nREAD_ADC A\nEND\nRUNG\n"
          "READ_ADC B\nEND\nRUNG\nUART_SEND A\nEND\nRUNG\nPERSIST B\nEND\n",
          "t.ld"),
      "board = \"simulated\"\n[analog]\nA = \"adc6\"\nB = \"adc1\"\n");
  ASSERT_FALSE(made.words.empty()) << made.messages;
  EXPECT_EQ(at(made, space_ports, 0), made.image.port_bits | made.image.port_words << 8);
  EXPECT_EQ(made.image.port_bits, 3);
  EXPECT_EQ(at(made, space_ports, 1) | at(made, space_ports, 2) << 16, 3221);
  EXPECT_EQ(at(made, space_setup, setup_adc_route), 6);
  EXPECT_EQ(at(made, space_setup, setup_adc_route + 1), 1);
  EXPECT_EQ(at(made, space_setup, setup_period_low) | at(made, space_setup, setup_period_low + 1)
                                                          << 16,
            250'000);
  ASSERT_EQ(made.image.persist.size(), 1U);
  EXPECT_EQ(made.image.persist[0], "B");
  // All of it is in the image file too.
  Diagnostics diagnostics;
  const auto back = image::from_bytes(image::to_bytes(made.image), "t.img", diagnostics);
  ASSERT_TRUE(back);
  const io::Subject subject = load::subject_of(*back);
  EXPECT_TRUE(subject.uart);
  EXPECT_FALSE(subject.pwm);
  EXPECT_EQ(back->persist, made.image.persist);
}

TEST(LoadFile, ItsCrcIsThatOfItsBytes) {
  const std::vector<std::uint16_t> words = {0x3132, 0x3334, 0x3536, 0x3738};
  EXPECT_EQ(load::to_bytes(words), "12345678");
  EXPECT_EQ(load::crc32(words), 0x9AE0DAAFU);
}

// Cut anywhere or with a header word changed, the reader refuses it.
TEST(LoadFile, DamageIsNamed) {
  const Made made = make(program_of(kMachine), kMachineMap);
  std::string problem;
  for (std::size_t size = 0; size < made.words.size(); ++size) {
    EXPECT_FALSE(load::read(
        {made.words.begin(), made.words.begin() + static_cast<std::ptrdiff_t>(size)}, problem));
  }
  for (const std::size_t word : {0, 1, 6, 7, 9, 10, 15}) {
    auto bad = made.words;
    bad[word] = static_cast<std::uint16_t>(bad[word] ^ 0x4000);
    EXPECT_FALSE(load::read(bad, problem)) << word;
    EXPECT_NE(problem, "");
  }
  auto twice = made.words;
  const std::vector<std::uint16_t> record = {space_lut << 12 | 1, 0, 7};
  twice.insert(twice.begin() + 16, record.begin(), record.end());
  twice[6] = static_cast<std::uint16_t>(twice.size());
  EXPECT_FALSE(load::read(twice, problem));
  EXPECT_EQ(problem, "address 0 of space 1 is set twice");
}

// The bound, worked out by hand from the table of constants.
TEST(Latency, IsTheSumOfItsParts) {
  const Made made = make(program_of(kMachine), kMachineMap);
  const load::Timing timing = load::timing_of(made.image, made.bindings, 25'000'000);
  EXPECT_EQ(timing.latch, 8 + phases_latch_clocks);
  EXPECT_EQ(timing.scan, made.image.clocks + phases_scan_clocks);
  EXPECT_EQ(timing.refresh, 3 + phases_refresh_clocks);
  EXPECT_EQ(timing.exchange, 300 + micro_exchange_clocks);
  EXPECT_EQ(timing.cycle, timing.latch + timing.scan + timing.refresh + timing.exchange);
  EXPECT_EQ(timing.period, 50'000);
  const auto response =
      timing.latch + timing.scan + timing.refresh + phases_input_clocks + phases_output_clocks;
  EXPECT_EQ(timing.best, response);
  EXPECT_EQ(timing.worst, response + 6 * 2500 + 50'000);
}

}  // namespace
}  // namespace rung::tb
