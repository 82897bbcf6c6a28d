// SPDX-License-Identifier: Apache-2.0
// Damaged load files: each must be refused while the old program runs on, or (sent twice, in
// another order) be taken exactly. And damage in the flash itself, found at power-up.
#include <fmt/format.h>

#include <map>

#include "load/load_file.hpp"
#include "programs/random_source.hpp"
#include "reliability/two_programs.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::size_t kWindow = c::holding_window_count;

class Image : public testing::Test {
 protected:
  void begin(const std::string& board, const std::string& more = "",
             const std::string& settings = "") {
    programs_ = std::make_unique<TwoPrograms>(board, more, settings);
    controller_ = make_controller(board, seed_);
    client_ = std::make_unique<Client>(*controller_);
    install(*controller_, *client_, programs_->old.words);
    client_->gap = 160;
    ASSERT_EQ(client_->write(0, {1234}), 0);  // D0, which a restart would clear
    generation_ = client_->holding_long(c::holding_program_generation);
    client_->command(4);
    ASSERT_TRUE(programs_->runs(*controller_, false));
    controller_->changes();
    note("words", programs_->fresh.words.size());
  }

  // Nothing of the old program has changed, not even for a scan.
  testing::AssertionResult untouched() {
    const auto no = [](const std::string& what) { return testing::AssertionFailure() << what; };
    for (const auto& change : controller_->changes()) {
      if (change.pin == device::PinChange::Pin::Output) {
        return no(fmt::format("output {} changed at clock {}", change.index, change.clock));
      }
    }
    if (client_->holding(c::holding_state) != 1) return no("not running");
    if (client_->holding_long(c::holding_program_generation) != generation_)
      return no("generation");
    if (client_->holding_long(c::holding_program_crc) != load::crc32(programs_->old.words)) {
      return no("CRC of the program that runs");
    }
    if (client_->holding(0) != 1234) return no("D0");
    const Words scans = client_->read(c::holding_scan_last, 6);
    if (scans[0] != scans[2] || scans[0] != scans[4]) return no("scans of different lengths");
    const auto runs = programs_->runs(*controller_, false);
    controller_->changes();
    return runs;
  }

  // Sends a file as one of this length and CRC; the load_state, or an exception negative.
  int send(const Words& file, std::size_t length, std::uint32_t crc) {
    const int wrong =
        client_->write(c::holding_load_length, {low(length), high(length), low(crc), high(crc)});
    if (wrong != 0) return -wrong;
    const int refused = client_->write(c::holding_load_command, {1});
    if (refused != 0) return -refused;
    for (std::size_t at = 0; at < file.size(); at += kWindow) {
      const int window = client_->window(file, at, at);
      if (window != 0) return -window;
    }
    return client_->commit();
  }

  void refuse(const Words& file, std::size_t length, std::uint32_t crc, const std::string& what) {
    const int state = send(file, length, crc);
    ASSERT_NE(state, 2) << what << " was taken";
    ++states_[state];
    const auto good = untouched();
    ASSERT_TRUE(good) << what << ", load_state " << state;
  }

  // One byte of a load file, another value.
  Words damaged(std::size_t byte) {
    Words file = programs_->fresh.words;
    file[byte / 2] ^=
        static_cast<std::uint16_t>((1 + random_.below(255)) << (byte % 2 == 0 ? 8 : 0));
    return file;
  }

  void report(std::uint64_t cases) {
    std::string text;
    for (const auto& [state, times] : states_) {
      text += fmt::format("{}{} {}: {}", text.empty() ? "" : ", ",
                          state < 0 ? "exception" : "load_state", std::abs(state), times);
    }
    note("cases", cases);
    note("outcomes", text);
  }

  // Whether the controller answers, after power-up.
  bool booted() {
    client_->gap = Client::kGap;
    client_->read(c::holding_state);
    client_->gap = 160;
    return true;
  }

  const std::uint64_t seed_ = base_seed();
  RandomSource random_{seed_};
  std::unique_ptr<TwoPrograms> programs_;
  std::unique_ptr<SimulatedController> controller_;
  std::unique_ptr<Client> client_;
  std::uint32_t generation_ = 0;
  std::map<int, std::uint64_t> states_;
};

TEST_F(Image, EveryByteOfADownload) {
  ASSERT_NO_FATAL_FAILURE(begin("hx8k"));
  const std::size_t bytes = 2 * programs_->fresh.words.size();
  const std::uint32_t crc = load::crc32(programs_->fresh.words);
  const std::size_t stride = full() ? 1 : 61;
  std::uint64_t cases = 0;
  for (std::size_t byte = seed_ % stride; byte < bytes; byte += stride, ++cases) {
    ASSERT_NO_FATAL_FAILURE(
        refuse(damaged(byte), bytes / 2, crc, fmt::format("byte {} damaged", byte)));
  }
  report(cases);
  ASSERT_EQ(client_->download(programs_->fresh.words), 2);
  EXPECT_TRUE(programs_->runs(*controller_, true));
}

// As it is; with its own length and CRC; with a header that says so too.
TEST_F(Image, CutAtEveryWord) {
  ASSERT_NO_FATAL_FAILURE(begin("hx8k"));
  const Words& whole = programs_->fresh.words;
  const std::size_t stride = full() ? 1 : 67;
  std::uint64_t cases = 0;
  for (std::size_t words = seed_ % stride; words < whole.size(); words += stride) {
    Words cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(words));
    const std::string what = fmt::format("cut to {} words", words);
    ASSERT_NO_FATAL_FAILURE(refuse(
        Words(cut.begin(), cut.begin() + static_cast<std::ptrdiff_t>(words / kWindow * kWindow)),
        whole.size(), load::crc32(whole), what + ", as it is"));
    ASSERT_NO_FATAL_FAILURE(refuse(cut, words, load::crc32(cut), what + ", with its CRC"));
    cases += 2;
    if (words < 17) continue;
    cut[6] = low(words);
    ASSERT_NO_FATAL_FAILURE(refuse(cut, words, load::crc32(cut), what + ", with its header"));
    ++cases;
  }
  report(cases);
  ASSERT_EQ(client_->download(whole), 2);
  EXPECT_TRUE(programs_->runs(*controller_, true));
}

// A window in the place of another is refused; sent twice, or in another order, it does no harm.
TEST_F(Image, WindowsRepeated) {
  ASSERT_NO_FATAL_FAILURE(begin("hx8k"));
  const Words whole = programs_->fresh.words;
  const std::size_t count_of = (whole.size() + kWindow - 1) / kWindow;
  const std::uint64_t cases = count(6, 60);
  std::uint64_t taken = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const bool harmless = random_.percent(30);
    std::vector<std::pair<std::size_t, std::size_t>> order;  // from, to
    for (std::size_t n = 0; n < count_of; ++n) order.emplace_back(n, n);
    if (harmless) {
      for (int times = 1 + random_.below(4); times > 0; --times) {
        order.push_back(
            order[static_cast<std::size_t>(random_.below(static_cast<int>(order.size())))]);
      }
      for (std::size_t n = order.size() - 1; n > 0; --n) {
        std::swap(order[n],
                  order[static_cast<std::size_t>(random_.below(static_cast<int>(n + 1)))]);
      }
    } else {
      // The last one is shorter: another one does not fit there.
      const auto to = static_cast<std::size_t>(random_.below(static_cast<int>(count_of - 1)));
      order[to].first =
          (to + 1 + static_cast<std::size_t>(random_.below(static_cast<int>(count_of) - 2))) %
          (count_of - 1);
      if (order[to].first == to) order[to].first = (to + 1) % (count_of - 1);
    }
    ASSERT_EQ(client_->begin(whole, load::crc32(whole)), 0);
    for (const auto& [from, to] : order) {
      ASSERT_EQ(client_->window(whole, from * kWindow, to * kWindow), 0);
    }
    const int state = client_->commit();
    if (!harmless) {
      ASSERT_EQ(state, 3) << "case " << i;
      ASSERT_TRUE(untouched()) << "case " << i;
      continue;
    }
    ASSERT_EQ(state, 2) << "case " << i;
    ++taken;
    ASSERT_TRUE(programs_->runs(*controller_, true));
    ASSERT_EQ(client_->holding_long(c::holding_program_crc), load::crc32(whole));
    ASSERT_EQ(client_->download(programs_->old.words), 2);
    ASSERT_TRUE(programs_->runs(*controller_, false));
    controller_->changes();
    generation_ = client_->holding_long(c::holding_program_generation);
    ASSERT_EQ(client_->write(0, {1234}), 0);
    client_->command(4);
  }
  note("cases", cases);
  note("taken", taken);
}

TEST_F(Image, StopsAfterABadDownload) {
  ASSERT_NO_FATAL_FAILURE(begin("hx8k", "", "stop_on_bad_download = true"));
  const Words& whole = programs_->fresh.words;
  const std::uint64_t cases = count(4, 60);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const auto byte = static_cast<std::size_t>(random_.below(static_cast<int>(2 * whole.size())));
    ASSERT_EQ(send(damaged(byte), whole.size(), load::crc32(whole)), 3);
    controller_->run(3000);
    ASSERT_EQ(client_->holding(c::holding_state), 0);
    ASSERT_TRUE(programs_->is_safe(*controller_));
    client_->command(1);
    ASSERT_TRUE(programs_->runs(*controller_, false));
  }
  note("cases", cases);
}

TEST_F(Image, LargeProgramDamaged) {
  ASSERT_NO_FATAL_FAILURE(begin("simulated"));
  Made large = make_program(golden("sample_3.il"), "board = \"simulated\"\n[modbus]\nunit = 1\n");
  quicken(large.words);
  const std::uint64_t cases = count(1, 40);
  note("large_words", large.words.size());
  for (std::uint64_t i = 0; i < cases; ++i) {
    Words file = large.words;
    const auto at = static_cast<std::size_t>(random_.below(static_cast<int>(file.size())));
    file[at] ^= static_cast<std::uint16_t>(1 + random_.below(0xFFFF));
    ASSERT_NO_FATAL_FAILURE(
        refuse(file, file.size(), load::crc32(large.words), fmt::format("word {} damaged", at)));
  }
  report(cases);
}

// The newest copy damaged: the one before runs. Both: fault, outputs safe, and it can be mended.
TEST_F(Image, EveryByteOfTheFlash) {
  ASSERT_NO_FATAL_FAILURE(begin("hx8k"));
  ASSERT_EQ(client_->download(programs_->fresh.words), 2);
  const std::vector<std::uint8_t> good = controller_->flash().memory();
  constexpr std::size_t kHeaderBytes = 18;
  const std::size_t base =
      static_cast<std::size_t>(controller_->board().flash_base) * c::flash_sector_bytes;
  const std::size_t copy_bytes = c::flash_copy_sectors * c::flash_sector_bytes;
  const bool in_one = (client_->holding(c::holding_flags) >> 5 & 1) != 0;
  const std::size_t newest = base + (in_one ? copy_bytes : 0);
  const std::size_t before = base + (in_one ? 0 : copy_bytes);
  const std::size_t bytes = kHeaderBytes + 2 * programs_->fresh.words.size();
  const auto place = [&](std::size_t copy, std::size_t byte) {
    return copy + (byte < kHeaderBytes ? byte : c::flash_sector_bytes + byte - kHeaderBytes);
  };
  const auto damage = [&](std::size_t at) {
    controller_->flash().memory()[at] ^= static_cast<std::uint8_t>(1 + random_.below(255));
  };
  const std::size_t stride = full() ? 1 : 173;
  std::uint64_t cases = 0, both = 0;
  for (std::size_t byte = seed_ % stride; byte < bytes; byte += stride, ++cases) {
    controller_->flash().memory() = good;
    damage(place(newest, byte));
    const bool other = cases % 8 == 3;
    if (other)
      damage(place(before, static_cast<std::size_t>(random_.below(static_cast<int>(bytes)))));
    controller_->power_cycle();
    ASSERT_TRUE(booted());
    if (other) {
      ++both;
      ASSERT_EQ(client_->holding(c::holding_state), 4) << "byte " << byte;
      // No program says what is safe then: 0.
      ASSERT_EQ(controller_->outputs(), 0U);
      for (const auto& change : controller_->changes()) {
        ASSERT_FALSE(change.pin == device::PinChange::Pin::Output && change.level) << byte;
      }
    } else {
      ASSERT_EQ(client_->holding(c::holding_state), 1) << "byte " << byte;
      ASSERT_TRUE(programs_->runs(*controller_, false)) << "byte " << byte;
    }
    controller_->changes();
  }
  note("cases", cases);
  note("both_damaged", both);
  client_->gap = Client::kGap;
  ASSERT_EQ(client_->download(programs_->fresh.words), 2);
  EXPECT_TRUE(programs_->runs(*controller_, true));
}

}  // namespace
}  // namespace rung::tb
