// SPDX-License-Identifier: Apache-2.0
// The driver of the ULX3S's converter against a model of the chip.
#include <gtest/gtest.h>

#include <cstdint>

#include "Vmax11123.h"
#include "harness/clocked.hpp"
#include "peripherals/max11123_chip.hpp"

namespace rung::tb {
namespace {

constexpr int kFrame = 36 * 4;  // clocks, as hdl/peripherals/max11123.v says
constexpr int kStart =
    (4 + 2 + 9) * kFrame + 2;  // settings, frames without an answer, all channels
constexpr int kOldest = 10 * kFrame;

class Converter {
 public:
  explicit Converter(int latency) : chip(latency) {
    adc_->miso_i = 1;
    adc_.reset();
  }
  void clocks(int count) {
    for (int i = 0; i < count; ++i) {
      adc_->miso_i = present && !chip.clock(adc_->csn_o, adc_->sck_o, adc_->mosi_o) ? 0 : 1;
      adc_.tick();
    }
  }
  // The chip sees it too.
  void reset() {
    adc_->rst_ni = 0;
    clocks(8);
    adc_->rst_ni = 1;
  }
  std::uint16_t sample(int channel) {
    return static_cast<std::uint16_t>(adc_->samples_o[channel / 2] >> (channel % 2 * 16));
  }
  void expect_inputs() {
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(sample(i), chip.inputs.at(static_cast<std::size_t>(i))) << "channel " << i;
    }
  }

  Max11123Chip chip;
  bool present = true;

 private:
  Clocked<Vmax11123> adc_;
};

// An answer tells its channel, so it does not matter in which frame it comes.
class Max11123 : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Latency, Max11123, testing::Values(1, 2));

TEST_P(Max11123, EveryChannelShowsItsInput) {
  Converter adc(GetParam());
  adc.chip.inputs = {0x000, 0xfff, 0xa55, 0x5aa, 0x001, 0x800, 0x7ff, 0x123};
  adc.clocks(kStart);
  adc.expect_inputs();
  EXPECT_EQ(adc.chip.faults, 0);
  EXPECT_EQ(adc.chip.resets, 1);
  EXPECT_EQ(adc.chip.frames, kStart / kFrame);
}

TEST_P(Max11123, ChangesShowInTimeAndOnlyTheirOwn) {
  Converter adc(GetParam());
  adc.clocks(kStart);
  for (int channel = 0; channel < 8; ++channel) {
    for (const int value : {0xfff, 0x400, 0}) {
      adc.chip.inputs.at(static_cast<std::size_t>(channel)) = static_cast<std::uint16_t>(value);
      for (int i = 0; i < kOldest; ++i) {
        adc.clocks(1);
        const int now = adc.sample(channel);
        ASSERT_TRUE(now == value || now == (value == 0xfff ? 0 : value == 0x400 ? 0xfff : 0x400));
      }
      adc.expect_inputs();
    }
  }
  EXPECT_EQ(adc.chip.faults, 0);
}

TEST_P(Max11123, ALineWithoutAChipShowsNothing) {
  Converter adc(GetParam());
  adc.present = false;
  adc.clocks(3 * kStart);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(adc.sample(i), 0);
}

TEST_P(Max11123, AResetAtAnyTimeBeginsAnew) {
  for (int when = 0; when < 2 * kFrame; when += 7) {
    Converter adc(GetParam());
    adc.chip.inputs.fill(0xfff);
    adc.clocks(kStart + when);
    adc.reset();
    for (int i = 0; i < 8; ++i) EXPECT_EQ(adc.sample(i), 0) << when;
    adc.chip.inputs = {1, 2, 3, 4, 5, 6, 7, 8};
    adc.clocks(kStart);
    adc.expect_inputs();
    EXPECT_EQ(adc.chip.resets, 2) << when;
    EXPECT_LE(adc.chip.faults, 2) << when;  // the frame that the reset cut short
  }
}

}  // namespace
}  // namespace rung::tb
