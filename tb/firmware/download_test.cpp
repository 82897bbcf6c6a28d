// SPDX-License-Identifier: Apache-2.0
// Programs: download, check, take-over, boot, and power cuts in all of it.
#include "bench.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

class Download : public Bench {};

TEST_F(Download, WithoutProgramThereIsAFault) {
  EXPECT_EQ(holding(c::holding_state), 4);
  EXPECT_EQ(holding(c::holding_fault), 2);
  EXPECT_EQ(machine_->state, 3);
  EXPECT_EQ(ask(pdu(3, {0, 1})), (Bytes{0x83, 4}));
}

TEST_F(Download, ProgramRunsAndIsThereAfterPowerUp) {
  const Words file = sample_program(0xBEEF).words();
  ASSERT_EQ(download(file), 2);
  for (int boots = 0; boots < 2; ++boots) {
    EXPECT_EQ(machine_->state, 1);
    EXPECT_EQ(
        machine_->steps,
        (std::map<int, std::uint16_t>{
            {0, 0xBEEF}, {1, 1}, {2, 2}, {8, 3}, {9, 4}, {10, 5}, {16, 6}, {17, 7}, {18, 0xBEEF}}));
    EXPECT_EQ(machine_->steps_count, 3);
    EXPECT_EQ(machine_->words[7], 0xBEEF);
    EXPECT_EQ(machine_->words[8], 0);
    EXPECT_EQ(machine_->bit_map[area("Y").index + 7], 0x8000 | 107);
    EXPECT_EQ(machine_->bit_map[area("Y").index + 8], 0);
    EXPECT_EQ(machine_->first_scans, 1);
    EXPECT_EQ(machine_->loads_while_running, 0);
    EXPECT_TRUE(machine_->keep_ready);
    const std::uint32_t crc = crc_of(file);
    EXPECT_EQ(read(c::holding_program_generation, 6),
              (Words{1, 0, static_cast<std::uint16_t>(file.size()), 0,
                     static_cast<std::uint16_t>(crc), static_cast<std::uint16_t>(crc >> 16U)}));
    power_on();
  }
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Download, ReadsBackWhatRuns) {
  LoadFile program = sample_program(1);
  for (int n = 0; n < 200; ++n)
    program.record(c::space_lut, 0, Words(255, static_cast<std::uint16_t>(n)));
  const Words file = program.words();  // more than 65,536 bytes
  install(file);
  const Words other = sample_program(2).words();
  ASSERT_EQ(begin(other), 0);
  ASSERT_EQ(windows(other), 0);
  Words back;
  while (back.size() < file.size()) {
    const auto at = static_cast<std::uint16_t>(back.size());
    ASSERT_EQ(write(c::holding_window_offset, {at, static_cast<std::uint16_t>(back.size() >> 16U)}),
              0);
    const Words part = read(c::holding_window, 64);
    back.insert(back.end(), part.begin(), part.end());
  }
  for (std::size_t n = file.size(); n < back.size(); ++n) EXPECT_EQ(back[n], 0);
  back.resize(file.size());
  EXPECT_EQ(back, file);
  ASSERT_EQ(write(c::holding_window_offset, {0, 0}), 0);
  EXPECT_EQ(read(c::holding_window + 6, 1), (Words{file[6]}));
}

TEST_F(Download, GenerationsCountAndCopiesTakeTurns) {
  for (int n = 1; n < 5; ++n) {
    install(sample_program(static_cast<std::uint16_t>(n)).words());
    EXPECT_EQ(holding(c::holding_program_generation), n);
    EXPECT_EQ(holding(c::holding_flags) >> 5, n % 2);
    power_on();
    EXPECT_EQ(mark(), n);
  }
}

TEST_F(Download, WhatIsWrongChangesNothing) {
  install(sample_program(1).words());
  const auto refused = [&](LoadFile file, int state, int crc_error = 0) {
    const int exchanges = machine_->exchanges;
    const int stops = machine_->stops;
    EXPECT_EQ(download(file.words(), crc_error), state);
    EXPECT_EQ(mark(), 1);
    EXPECT_EQ(machine_->state, 1);
    EXPECT_EQ(machine_->stops, stops);
    EXPECT_EQ(machine_->exchanges, exchanges);
    EXPECT_EQ(holding(c::holding_program_generation), 1);
  };
  refused(sample_program(2), 3, 1);
  const auto with = [&](auto&& change) {
    LoadFile file = sample_program(2);
    change(file);
    return file;
  };
  refused(with([](LoadFile& f) { f.magic = 1; }), 4);
  refused(with([](LoadFile& f) { f.format = 2; }), 4);
  refused(with([](LoadFile& f) { ++f.tables; }), 4);
  refused(with([](LoadFile& f) { ++f.config; }), 4);
  refused(with([](LoadFile& f) { f.board = 1; }), 4);
  refused(with([](LoadFile& f) { f.mpu = 2; }), 4);
  refused(with([](LoadFile& f) { f.chunks = 9; }), 6);
  refused(with([](LoadFile& f) { f.chunks = 0; }), 6);
  // With flow tasks there is no space without a meaning.
  if (!kFlow) refused(with([](LoadFile& f) { f.record(12, 0, {1}); }), 6);
  refused(with([](LoadFile& f) { f.record(c::space_words, 0, {}); }), 6);
  refused(with([](LoadFile& f) { f.record(c::space_keep, 64, {1}); }), 6);
  refused(with([](LoadFile& f) { f.record(c::space_keep, 0x10000, {1}); }), 6);
}

TEST_F(Download, StructureIsCheckedToTheEnd) {
  install(sample_program(1).words());
  Words file = sample_program(2).words();
  const auto resize = [&](std::size_t size) {
    file.resize(size);
    file[6] = static_cast<std::uint16_t>(size);
  };
  resize(file.size() + 1);  // a word behind the end
  EXPECT_EQ(download(file), 6);
  resize(file.size() - 2);  // no end
  EXPECT_EQ(download(file), 6);
  resize(file.size() - 1);  // a record cut short
  EXPECT_EQ(download(file), 6);
  resize(file.size() - 2);  // the last record is not the length
  file.back() = 0;
  EXPECT_EQ(download(file), 6);
  EXPECT_EQ(mark(), 1);
}

TEST_F(Download, EveryByteCorrupted) {
  install(sample_program(1).words());
  const Words good = sample_program(2).words();
  const std::uint32_t crc = crc_of(good);
  std::mt19937 random(20);
  for (std::size_t byte = 0; byte < 2 * good.size(); byte += 7) {
    Words file = good;
    file[byte / 2] ^=
        static_cast<std::uint16_t>((1U + random() % 255) << (byte % 2 == 0 ? 8U : 0U));
    ASSERT_EQ(begin(file), 0);
    ASSERT_EQ(windows(file), 0);
    ASSERT_EQ(write(c::holding_load_crc,
                    {static_cast<std::uint16_t>(crc), static_cast<std::uint16_t>(crc >> 16U)}),
              0);
    ASSERT_EQ(commit(), 3);
    ASSERT_EQ(mark(), 1);
  }
}

TEST_F(Download, CutShortOrRepeated) {
  install(sample_program(1).words());
  const Words file = sample_program(2).words();
  // Without its last window; commit too early; the window twice
  ASSERT_EQ(begin(file), 0);
  ASSERT_EQ(windows(Words(file.begin(), file.begin() + 64)), 0);
  EXPECT_EQ(commit(), 3);
  EXPECT_EQ(mark(), 1);
  ASSERT_EQ(begin(file), 0);
  ASSERT_EQ(windows(file), 0);
  ASSERT_EQ(windows(file), 0);
  EXPECT_EQ(commit(), 2);
  EXPECT_EQ(mark(), 2);
}

TEST_F(Download, OrderOfCommands) {
  install(sample_program(1).words());
  const Words file = sample_program(2).words();
  EXPECT_EQ(write(c::holding_load_command, {2}), 4);
  EXPECT_EQ(write(c::holding_load_command, {0}), 3);
  EXPECT_EQ(write(c::holding_load_command, {4}), 3);
  EXPECT_EQ(write(c::holding_window, Words(64)), 4);
  ASSERT_EQ(begin(file), 0);
  EXPECT_EQ(holding(c::holding_load_state), 1);
  EXPECT_EQ(write(c::holding_load_command, {3}), 0);
  EXPECT_EQ(holding(c::holding_load_state), 0);
  EXPECT_EQ(windows(file), 4);
  // Lengths that cannot be
  for (const Words& length :
       {Words{0, 0}, Words{16, 0}, Words{0xF801, 1}, Words{0, 2}, Words{0xFFFF, 0xFFFF}}) {
    ASSERT_EQ(write(c::holding_load_length, length), 0);
    EXPECT_EQ(write(c::holding_load_command, {1}), 3);
  }
  ASSERT_EQ(write(c::holding_load_length, {0xF800, 1}), 0);
  EXPECT_EQ(write(c::holding_load_command, {1}), 0);
}

TEST_F(Download, WindowsAreWholePagesOrTheEnd) {
  install(sample_program(1).words());
  ASSERT_EQ(begin(Words(130)), 0);
  const auto window = [&](Words offset, int count, int from = 0) {
    EXPECT_EQ(write(c::holding_window_offset, offset), 0);
    return write(c::holding_window + from, Words(count, 0xFFFF));
  };
  EXPECT_EQ(window({0, 0}, 64), 0);
  EXPECT_EQ(window({0, 0}, 63), 3);
  EXPECT_EQ(window({1, 0}, 64), 3);
  EXPECT_EQ(window({64, 0}, 64), 0);
  EXPECT_EQ(window({128, 0}, 64), 3);
  EXPECT_EQ(window({128, 0}, 2), 0);
  EXPECT_EQ(window({128, 0}, 1), 3);
  EXPECT_EQ(window({192, 0}, 64), 3);
  EXPECT_EQ(window({0, 1}, 64), 3);
  EXPECT_EQ(window({0, 0}, 1, 1), 3);
  EXPECT_EQ(window({0, 0}, 63, 1), 3);
  // A length that was made larger behind `begin` does not lead out of the copy.
  ASSERT_EQ(write(c::holding_load_length, {0xFFFF, 0xFFFF}), 0);
  const int writes = flash_.writes;
  EXPECT_EQ(window({0, 0x7000}, 64), 3);
  EXPECT_EQ(flash_.writes, writes);
}

TEST_F(Download, PolicyStopsAfterFailure) {
  LoadFile first = sample_program(1);
  first.at(c::space_host, c::host_policy, 1);
  install(first.words());
  EXPECT_EQ(download(sample_program(2).words(), 1), 3);
  EXPECT_EQ(machine_->state, 0);
  EXPECT_EQ(holding(c::holding_state), 0);
}

TEST_F(Download, BootChoices) {
  install(sample_program(1).words());
  LoadFile second = sample_program(2);
  second.at(c::space_host, c::host_policy, 2);
  install(second.words());
  EXPECT_EQ(machine_->state, 1);  // the policy is for power-up
  power_on();
  EXPECT_EQ(machine_->state, 0);
  EXPECT_EQ(mark(), 2);
  // The newest one damaged: the one before (copies from sector 1 on; the first download is copy 1)
  flash_.data()[(1 + 1) * 4096 + 40] ^= 1U;
  power_on(false);
  EXPECT_EQ(mark(), 1);
  EXPECT_EQ(machine_->state, 0);  // by the switch
  machine_->run_switch = true;
  poll(2);
  EXPECT_EQ(machine_->state, 1);
  machine_->run_switch = false;
  poll(8);
  EXPECT_EQ(machine_->state, 0);
  flash_.data()[(1 + 64 + 1) * 4096 + 40] ^= 1U;
  power_on();
  unit_ = 1;
  EXPECT_EQ(holding(c::holding_state), 4);
  EXPECT_EQ(holding(c::holding_fault), 3);
  EXPECT_EQ(machine_->state, 3);
  // And a new one goes in again, with the highest generation.
  install(sample_program(3).words());
  power_on();
  EXPECT_EQ(mark(), 3);
}

TEST_F(Download, AnotherBoardsFlashDoesNotRun) {
  install(sample_program(1).words());
  board_ = 1;
  power_on();
  unit_ = 1;
  EXPECT_EQ(holding(c::holding_fault), 3);
}

TEST_F(Download, PowerCutsLeaveOldOrNew) {
  install(sample_program(1).words());
  install(sample_program(2).words());
  const Words file = sample_program(3).words();
  const Bytes before = flash_.data();
  const int writes = flash_.writes;
  ASSERT_EQ(download(file), 2);
  const int in_download = flash_.writes - writes;
  int old_ones = 0;
  int new_ones = 0;
  for (unsigned cut = 0; cut < 8U * static_cast<unsigned>(in_download); ++cut) {
    flash_.data() = before;
    power_on();
    flash_.cut_at(static_cast<int>(cut / 8), cut % 8 != 0, cut);
    bool was_cut = false;
    try {
      download(file);
    } catch (const PowerCut&) {
      was_cut = true;
    }
    power_on();
    ASSERT_TRUE(was_cut);
    ASSERT_TRUE(mark() == 2 || mark() == 3) << "cut " << cut << ": " << mark();
    ASSERT_EQ(machine_->state, 1);
    ASSERT_EQ(machine_->words[7], mark());
    mark() == 2 ? ++old_ones : ++new_ones;
    // It goes on from there.
    if (cut % 8 == 1) {
      ASSERT_EQ(download(sample_program(4).words()), 2);
      power_on();
      ASSERT_EQ(mark(), 4);
    }
  }
  EXPECT_GT(old_ones, 0);
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Download, BrokenFlashEnds) {
  install(sample_program(1).words());
  const Words file = sample_program(2).words();
  flash_.stuck_busy = true;
  EXPECT_EQ(begin(file), 4);
  EXPECT_EQ(holding(c::holding_load_state), 5);
  EXPECT_EQ(machine_->state, 1);
  flash_.stuck_busy = false;
  poll(8);
  ASSERT_EQ(begin(file), 0);
  flash_.ignores_writes = true;
  ASSERT_EQ(windows(file), 0);
  EXPECT_EQ(commit(), 3);
  EXPECT_EQ(mark(), 1);
  flash_.absent = true;
  power_on();
  EXPECT_EQ(machine_->state, 3);
}

TEST_F(Download, HeaderThatCannotBeWrittenBringsTheOldProgramBack) {
  install(sample_program(1).words());
  const Words file = sample_program(2).words();
  ASSERT_EQ(begin(file), 0);
  ASSERT_EQ(windows(file), 0);
  flash_.ignores_writes = true;
  EXPECT_EQ(commit(), 5);
  EXPECT_EQ(mark(), 1);
  EXPECT_EQ(machine_->state, 1);
  EXPECT_EQ(holding(c::holding_program_generation), 1);
}

TEST_F(Download, WhileItCommits) {
  install(sample_program(1).words());
  const Words file = sample_program(2).words();
  ASSERT_EQ(begin(file), 0);
  ASSERT_EQ(windows(file), 0);
  machine_->receive({17, 6, 0xE1, 0x00, 0, 2});
  machine_->sending = 0;
  poll();
  ASSERT_FALSE(machine_->waiting);
  machine_->sending = 0;
  EXPECT_EQ(holding(c::holding_load_state), 1);
  machine_->sending = 0;
  EXPECT_EQ(write(c::holding_command, {2}), 4);
  machine_->sending = 0;
  EXPECT_EQ(write(c::holding_load_length, {1}), 4);
  poll(20);
  EXPECT_EQ(mark(), 2);
}

TEST_F(Download, LineSettingsAreTheProgrammes) {
  LoadFile file = sample_program(1);
  for (std::uint16_t n = 0; n < 5; ++n) file.at(c::space_host, c::host_baud_low + n, 100 + n);
  install(file.words());
  for (std::uint16_t n = 0; n < 5; ++n) {
    EXPECT_EQ(machine_->line_settings.at(static_cast<std::uint16_t>(c::reg_line_baud_low + n)),
              100 + n);
  }
}

}  // namespace
}  // namespace rung::tb
