// SPDX-License-Identifier: Apache-2.0
#include "device/mbap.hpp"

#include <gtest/gtest.h>

namespace rung::device {
namespace {

using Bytes = std::vector<std::uint8_t>;

const Bytes kRead{0x12, 0x34, 0, 0, 0, 6, 1, 3, 0, 0, 0, 2};

TEST(Mbap, OneRequestByteByByte) {
  MbapStream stream;
  for (std::size_t i = 0; i < kRead.size(); ++i) {
    EXPECT_FALSE(stream.next()) << i;
    stream.put(std::span(kRead).subspan(i, 1));
  }
  const auto request = stream.next();
  ASSERT_TRUE(request);
  EXPECT_EQ(request->transaction, 0x1234);
  EXPECT_EQ(request->unit, 1);
  EXPECT_EQ(request->pdu, (Bytes{3, 0, 0, 0, 2}));
  EXPECT_FALSE(stream.next());
  EXPECT_EQ(stream.waiting(), 0U);
}

TEST(Mbap, SeveralAtOnceStayApart) {
  MbapStream stream;
  Bytes both = kRead;
  both.insert(both.end(), kRead.begin(), kRead.end());
  both[12] = 0x56;
  stream.put(both);
  EXPECT_EQ(stream.next()->transaction, 0x1234);
  EXPECT_EQ(stream.next()->transaction, 0x5634);
  EXPECT_FALSE(stream.next());
  EXPECT_FALSE(stream.broken());
}

TEST(Mbap, LengthsAtTheirLimits) {
  for (const auto& [counted, right] :
       {std::pair{0, false}, {1, false}, {2, true}, {254, true}, {255, false}, {0xFFFF, false}}) {
    MbapStream stream;
    Bytes bytes{0,
                1,
                0,
                0,
                static_cast<std::uint8_t>(counted >> 8),
                static_cast<std::uint8_t>(counted & 0xFF),
                1};
    bytes.resize(6 + 254, 3);
    stream.put(bytes);
    const auto request = stream.next();
    EXPECT_EQ(request.has_value(), right) << counted;
    EXPECT_EQ(stream.broken(), !right) << counted;
    if (!request) continue;
    EXPECT_EQ(request->pdu.size(), static_cast<std::size_t>(counted - 1));
  }
}

TEST(Mbap, AnotherProtocolBreaksTheStreamForGood) {
  MbapStream stream;
  Bytes bytes = kRead;
  bytes[3] = 1;
  stream.put(bytes);
  EXPECT_FALSE(stream.next());
  EXPECT_TRUE(stream.broken());
  stream.put(kRead);
  EXPECT_FALSE(stream.next());
}

TEST(Mbap, Reply) {
  EXPECT_EQ(mbap_reply({0x1234, 7, {3}}, Bytes{0x83, 2}),
            (Bytes{0x12, 0x34, 0, 0, 0, 3, 7, 0x83, 2}));
}

}  // namespace
}  // namespace rung::device
