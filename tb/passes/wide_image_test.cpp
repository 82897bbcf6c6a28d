// SPDX-License-Identifier: Apache-2.0
// Images of MPU4 as files: what is written is read, and what the processor does not have is
// refused.
#include <functional>

#include "image/image_file.hpp"
#include "passes/support.hpp"

namespace rung::image {
namespace {

// Inputs, a timer's ticks, a division and a device that nobody writes.
constexpr const char* kProgram =
    "LD X0\nOR M0\nANI X1\nOUT M0\nOUT T0 K5\nLD T0\nDIV D0 D7 D2\nSET Y0\nEND\n";

Image example(int slots = 8, bool merge = true) {
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = slots;
  options.merge = merge;
  Diagnostics diagnostics;
  auto compiled = compile(parse(kProgram), options, diagnostics);
  if (!compiled) throw std::runtime_error("does not fit");
  return std::move(compiled->image);
}

TEST(WideImage, ReadsBackTheSame) {
  for (const int slots : {4, 8, 16}) {
    for (const bool merge : {true, false}) {
      const Image image = example(slots, merge);
      const std::string bytes = to_bytes(image);
      EXPECT_EQ(bytes[7], 6) << "format version";
      Diagnostics diagnostics;
      const auto back = from_bytes(bytes, "x.img", diagnostics);
      ASSERT_TRUE(back);
      ASSERT_TRUE(back->wide);
      EXPECT_EQ(back->wide->slots, slots);
      EXPECT_EQ(back->wide->merged, merge);
      EXPECT_EQ(back->wide->code, image.wide->code);
      EXPECT_EQ(back->wide->latched, image.wide->latched);
      EXPECT_EQ(back->clocks, image.clocks);
      EXPECT_EQ(back->ticks.size(), 1U);
      EXPECT_EQ(to_bytes(*back), bytes);
      EXPECT_EQ(listing(*back), listing(image));
    }
  }
}

TEST(WideImage, DamageIsFound) {
  const std::string good = to_bytes(example());
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    Diagnostics diagnostics;
    ASSERT_FALSE(from_bytes(bad, "x.img", diagnostics)) << "byte " << i;
    ASSERT_EQ(diagnostics.error_count(), 1);
  }
  for (std::size_t i = 0; i < good.size(); i += 7) {
    Diagnostics diagnostics;
    ASSERT_FALSE(from_bytes(good.substr(0, i), "x.img", diagnostics)) << "cut at " << i;
  }
}

// With a right checksum: somebody has made such a file.
TEST(WideImage, WhatTheProcessorDoesNotHaveIsRefused) {
  using Change = std::function<void(Image&)>;
  const std::pair<const char*, Change> changes[] = {
      {"slots", [](Image& i) { i.wide->slots = 5; }},
      {"other slots", [](Image& i) { i.wide->slots = 16; }},
      {"slots of a step", [](Image& i) { i.wide->code[0].pop_back(); }},
      {"chunks of an instruction", [](Image& i) { i.wide->code[0][1].push_back(0); }},
      {"no instruction", [](Image& i) { i.wide->code[0][0].clear(); }},
      {"origins", [](Image& i) { i.wide->origins.pop_back(); }},
      {"origin", [](Image& i) { i.wide->origins[0][0] = 1000; }},
      {"steps",
       [](Image& i) {
         i.wide->code.resize(513, i.wide->code[0]);
         i.wide->origins.resize(513, i.wide->origins[0]);
       }},
      {"no steps",
       [](Image& i) {
         i.clocks -= static_cast<std::int64_t>(i.wide->code.size());
         i.wide->code.clear();
         i.wide->origins.clear();
         i.wide->writes.clear();
       }},
      {"first latch row", [](Image& i) { i.wide->first_latch_row = -1; }},
      {"last latch row", [](Image& i) { i.wide->first_latch_row = 1016; }},
      {"latched bits", [](Image& i) { i.wide->latched.resize(9, 0); }},
      {"latched device", [](Image& i) { i.wide->latched[0] = 1000; }},
      {"latched word",
       [](Image& i) {
         for (std::size_t k = 0; k < i.devices.size(); ++k) {
           if (is_word(i.devices[k].device)) i.wide->latched[0] = static_cast<int>(k);
         }
       }},
      {"device of a write", [](Image& i) { i.wide->writes[0].device = -1; }},
      {"step of a write", [](Image& i) { i.wide->writes[0].step = 400; }},
      {"lane of a write", [](Image& i) { i.wide->writes[0].lane = 8; }},
      {"place of a device", [](Image& i) { i.devices[0].address = 1016 * 8; }},
      {"place of the ticks", [](Image& i) { i.ticks[0].address = -1; }},
      {"base of the ticks", [](Image& i) { i.ticks[0].base_us = 0; }},
      {"port",
       [](Image& i) {
         i.wide->ports.push_back({{DeviceKind::PW, 0}, 1016 * 4});
       }},
      {"clocks", [](Image& i) { ++i.clocks; }},
      {"processor", [](Image& i) { i.mpu = isa::Mpu::Mpu3; }},
  };
  for (const auto& [what, change] : changes) {
    Image image = example();
    change(image);
    Diagnostics diagnostics;
    EXPECT_FALSE(from_bytes(to_bytes(image), "x.img", diagnostics)) << what;
    EXPECT_EQ(diagnostics.error_count(), 1) << what;
  }
}

}  // namespace
}  // namespace rung::image
