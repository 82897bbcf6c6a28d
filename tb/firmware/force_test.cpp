// SPDX-License-Identifier: Apache-2.0
// Forces of inputs and outputs.
#include "bench.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

class Force : public Bench {
 protected:
  Force() { install(program(1).words()); }

  // sample_program() with 60 inputs more, behind the outputs' entries in the device map only or in
  // the list too
  static LoadFile program(std::uint16_t mark) {
    LoadFile file = sample_program(mark);
    file.at(c::space_bit_map, area("X").index + 9, 0x8000 | 209);  // a device, but not in the list
    return file;
  }
  int force(int point, int value) {
    return write(c::holding_force_point,
                 {static_cast<std::uint16_t>(point), static_cast<std::uint16_t>(value)});
  }
  Words list() { return read(c::holding_force_list, 5); }
};

TEST_F(Force, InputsAndOutputs) {
  EXPECT_EQ(list(), Words(5, 0x7FFF));
  EXPECT_EQ(force(0x3402, 1), 0);
  EXPECT_EQ(machine_->forces[2], 3);
  EXPECT_EQ(force(0x3303, 0), 0);
  EXPECT_EQ(machine_->forces[8 + 3], 2);
  EXPECT_EQ(list(), (Words{0xB402, 0x3303, 0x7FFF, 0x7FFF, 0x7FFF}));
  EXPECT_EQ(holding(c::holding_force_count), 2);
  EXPECT_EQ(holding(c::holding_flags) & 4, 4);
  EXPECT_EQ(force(0x3402, 0), 0);
  EXPECT_EQ(machine_->forces[2], 2);
  EXPECT_EQ(list(), (Words{0x3402, 0x3303, 0x7FFF, 0x7FFF, 0x7FFF}));
  EXPECT_EQ(force(0x3402, 2), 0);
  EXPECT_EQ(machine_->forces[2], 0);
  EXPECT_EQ(list(), (Words{0x3303, 0x7FFF, 0x7FFF, 0x7FFF, 0x7FFF}));
  EXPECT_EQ(force(0x3402, 2), 0) << "released already";
  EXPECT_EQ(holding(c::holding_force_count), 1);
}

TEST_F(Force, WhatCannotBeForced) {
  EXPECT_EQ(force(0x3409, 1), 2) << "not in the list";
  EXPECT_EQ(force(0x3408, 1), 2) << "no device";
  EXPECT_EQ(force(0x3308, 1), 2);
  EXPECT_EQ(force(0x0001, 1), 2) << "M";
  EXPECT_EQ(force(0x7FFF, 2), 2);
  EXPECT_EQ(force(0x3401, 3), 3);
  EXPECT_EQ(holding(c::holding_force_count), 0);
  EXPECT_EQ(holding(c::holding_force_point), 0) << "refused as a whole";
  for (const std::uint16_t entry : machine_->forces) EXPECT_EQ(entry, 0);
}

TEST_F(Force, EveryPointHasItsEntry) {
  for (int n = 0; n < 8; ++n) {
    EXPECT_EQ(force(0x3400 + n, 1), 0);
    EXPECT_EQ(force(0x3300 + n, 1), 0);
  }
  for (int n = 0; n < 16; ++n) EXPECT_EQ(machine_->forces[n], 3);
  command(7);
  for (int n = 0; n < 256; ++n) EXPECT_EQ(machine_->forces[n], 0);
  EXPECT_EQ(holding(c::holding_force_count), 0);
}

TEST_F(Force, EndsWithAnotherProgramAndPower) {
  EXPECT_EQ(force(0x3402, 1), 0);
  command(2);
  command(1);
  EXPECT_EQ(holding(c::holding_force_count), 1) << "kept";
  EXPECT_EQ(machine_->forces[2], 3);
  EXPECT_EQ(download(program(2).words(), 1), 3);
  EXPECT_EQ(holding(c::holding_force_count), 1) << "this program runs on";
  install(program(2).words());
  EXPECT_EQ(holding(c::holding_force_count), 0);
  EXPECT_EQ(machine_->forces[2], 0);
  EXPECT_EQ(force(0x3402, 1), 0);
  power_on();
  EXPECT_EQ(holding(c::holding_force_count), 0);
}

// Records in any order and of any size, entries across records, long records before them
TEST_F(Force, FindsEntriesWhereverTheyAre) {
  LoadFile file;
  file.at(c::space_setup, c::setup_latch_count, 70)
      .at(c::space_setup, c::setup_exchange_points, 100);
  file.at(c::space_setup, c::setup_refresh_first, 70).at(c::space_setup, c::setup_refresh_count, 1);
  for (int n = 0; n < 300; ++n) file.record(c::space_lut, n, Words(255));
  Words io;
  Words map;
  const int inputs = std::min(area("X").count, 66);
  for (int n = 0; n < 70; ++n) {
    const auto device = static_cast<std::uint16_t>(300 + (n * 9) % 70);
    io.insert(io.end(), {device, 0x0100});
  }
  io.insert(io.end(), {300, 0x0100});  // an output with the device of an input
  for (int n = 0; n < inputs; ++n)
    map.push_back(static_cast<std::uint16_t>(0x8000 | (300 + (n * 9) % 70)));
  file.record(c::space_io, 0, Words(io.begin(), io.begin() + 7));
  file.record(c::space_io, 7, Words(io.begin() + 7, io.end()));
  file.record(c::space_bit_map, area("X").index, map);
  file.at(c::space_length, 0, 1);
  install(file.words());
  unit_ = 1;
  for (int n = 0; n < inputs; ++n) {
    ASSERT_EQ(force(0x3400 + n, 1), n < 64 ? 0 : 4) << n;
    EXPECT_EQ(machine_->forces[n], n < 64 ? 3 : 0);
  }
  EXPECT_EQ(holding(c::holding_force_count), std::min(inputs, 64));
  EXPECT_EQ(force(0x3400, 0), 0) << "one that is forced already";
  EXPECT_EQ(read(c::holding_force_list + 63), (Words{0x8000 | 0x343F}));
}

}  // namespace
}  // namespace rung::tb
