// SPDX-License-Identifier: Apache-2.0
// Reset and power loss at random clocks: in the middle of scans, of downloads and commits, of
// erasing, of saving. After it the old or the new program is there, whole, with values that
// were saved together; and no output is anything but safe before the program runs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <vector>

#include "load/load_file.hpp"
#include "programs/random_source.hpp"
#include "reliability/two_programs.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr int kKept = 100;  // D100 and D101, always written together
constexpr std::uint64_t kBoot = 20'000'000;
constexpr std::uint64_t kOldAnswer = 50'000;  // longer than a request and its answer take

class Power : public testing::Test {
 protected:
  void begin() {
    controller_ = make_controller("hx8k", seed_, false);
    client_ = std::make_unique<Client>(*controller_);
    install(*controller_, *client_, programs_.old.words);
    client_->gap = 160;
    keep(1);
    saved_ = 1;
  }

  const Made& program(bool fresh) const { return fresh ? programs_.fresh : programs_.old; }

  // Writes both values and has them saved; returns when they are.
  void keep(std::uint16_t value) {
    ASSERT_EQ(client_->write(kKept, {value, value}), 0);
    const int saves = client_->holding(c::holding_saves);
    client_->command(6);
    for (int i = 0; client_->holding(c::holding_saves) == saves; ++i) ASSERT_LT(i, 1000);
    finished_ = true;
  }

  enum class Work : std::uint8_t { Idle, Download, Begin, Keep };
  void work(Work what, std::uint16_t value) {
    const Words& other = program(!fresh_).words;
    switch (what) {
      case Work::Idle:
        for (int i = 0; i < 8; ++i) client_->read(0, 4);
        break;
      case Work::Download:
        ASSERT_EQ(client_->download(other), 2);
        finished_ = true;
        break;
      case Work::Begin:
        ASSERT_EQ(client_->begin(other, load::crc32(other)), 0);
        ASSERT_EQ(client_->window(other, 0, 0), 0);
        break;
      case Work::Keep:
        keep(value);
        break;
    }
  }

  // From power-up on: outputs are safe until it runs; then what runs is the program.
  void come_up(const std::string& what) {
    ASSERT_TRUE(run_until(
        *controller_, [&] { return controller_->lamp(device::PinChange::Pin::Run); }, kBoot))
        << what << ": it does not run";
    for (const auto& change : controller_->changes()) {
      if (change.pin == device::PinChange::Pin::Run && change.level) break;
      if (change.pin != device::PinChange::Pin::Output || !change.level) continue;
      ASSERT_EQ(change.index, programs_.y1)
          << what << ": output " << change.index << " is 1 before the program runs";
    }
    // A request whose bytes were still on their way at a reset waits in the controller until it is
    // up, and is answered then; one that comes on top of it would be lost.
    controller_->run(kOldAnswer);
    controller_->receive();
    client_->gap = Client::kGap;
    ASSERT_EQ(client_->holding(c::holding_state), 1) << what;
    client_->gap = 160;
  }

  const std::uint64_t seed_ = base_seed();
  RandomSource random_{seed_};
  const TwoPrograms programs_{"hx8k"};
  std::unique_ptr<SimulatedController> controller_;
  std::unique_ptr<Client> client_;
  bool fresh_ = false;
  bool finished_ = false;
  std::uint16_t saved_ = 0;
};

TEST_F(Power, CutAtRandomMoments) {
  ASSERT_NO_FATAL_FAILURE(begin());
  // How long each kind of work takes.
  std::array<std::uint64_t, 4> lasts{};
  for (std::size_t n = 0; n < lasts.size(); ++n) {
    const std::uint64_t begun = controller_->now();
    ASSERT_NO_FATAL_FAILURE(work(static_cast<Work>(n), 1));
    lasts[n] = controller_->now() - begun;
    if (static_cast<Work>(n) == Work::Download) fresh_ = !fresh_;
  }
  const std::uint64_t all = count(4, 150);
  std::uint64_t resets = 0, in_flash = 0, old_ones = 0, new_ones = 0, old_values = 0,
                new_values = 0;
  std::array<std::uint64_t, 4> works{};
  const std::vector<std::string>& misuses = controller_->flash().misuses();
  std::size_t cut_commands = 0;
  for (std::uint64_t i = 0; i < all; ++i) {
    const auto kind = static_cast<std::size_t>(random_.weighted(std::array{1, 4, 2, 4}));
    const auto value = static_cast<std::uint16_t>(2 + i);
    const bool reset = random_.percent(35);
    const std::string what =
        fmt::format("seed {}, case {}, work {}, {}", seed_, i, kind, reset ? "reset" : "power cut");
    ++works[kind];
    finished_ = false;
    client_->cut_at = controller_->now() + random_.bits() % (lasts[kind] + lasts[kind] / 16 + 1);
    try {
      ASSERT_NO_FATAL_FAILURE(work(static_cast<Work>(kind), value));
      client_->cut_at.reset();
    } catch (const Cut&) {
    }
    if (controller_->flash().busy()) ++in_flash;
    controller_->receive();
    if (reset) {
      ++resets;
      // The flash knows nothing of it: a command under way is cut within a byte.
      const std::size_t before = misuses.size();
      controller_->reset();
      cut_commands += misuses.size() - before;
      controller_->changes();
    } else {
      controller_->set_power(false);
      controller_->run(1000);
      ASSERT_EQ(controller_->outputs(), 0U);
      controller_->changes();
      controller_->set_power(true);
    }
    SCOPED_TRACE(what);
    try {
      ASSERT_NO_FATAL_FAILURE(come_up(what));
    } catch (const std::runtime_error& error) {
      FAIL() << what << ": " << error.what();
    }
    const std::uint32_t crc = client_->holding_long(c::holding_program_crc);
    const bool is_fresh = crc == load::crc32(programs_.fresh.words);
    ASSERT_TRUE(is_fresh || crc == load::crc32(programs_.old.words)) << what;
    if (static_cast<Work>(kind) == Work::Download) {
      if (finished_) {
        ASSERT_NE(is_fresh, fresh_) << what << ": a download that was done is lost";
      }
      ++(is_fresh == fresh_ ? old_ones : new_ones);
    } else {
      ASSERT_EQ(is_fresh, fresh_) << what << ": the program has changed";
    }
    fresh_ = is_fresh;
    const Words kept = client_->read(kKept, 2);
    ASSERT_EQ(kept[0], kept[1]) << what << ": values of two savings";
    if (static_cast<Work>(kind) == Work::Keep) {
      ASSERT_TRUE(kept[0] == value || (kept[0] == saved_ && !finished_))
          << what << ": " << kept[0] << ", saved " << saved_ << ", then " << value;
      ++(kept[0] == value ? new_values : old_values);
      saved_ = kept[0];
    } else {
      ASSERT_EQ(kept[0], saved_) << what << ": a value that was saved is lost";
    }
    ASSERT_TRUE(programs_.runs(*controller_, fresh_)) << what;
    controller_->changes();
  }
  EXPECT_EQ(misuses.size(), cut_commands) << fmt::format("{}", fmt::join(misuses, "; "));
  EXPECT_LE(cut_commands, resets);
  note("cuts", all);
  note("of_them_resets", resets);
  note("while_the_flash_was_busy", in_flash);
  note("idle_download_begin_keep",
       fmt::format("{} {} {} {}", works[0], works[1], works[2], works[3]));
  note("downloads_old_new", fmt::format("{} {}", old_ones, new_ones));
  note("savings_old_new", fmt::format("{} {}", old_values, new_values));
}

}  // namespace
}  // namespace rung::tb
