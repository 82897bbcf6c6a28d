// SPDX-License-Identifier: Apache-2.0
// The client library on both kinds of line, with lines and controllers that fail.
#include <gtest/gtest.h>

#include "client/controller.hpp"
#include "host/fake_controller.hpp"
#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

using namespace controller;

client::LineOptions line_to(const FakeController& fake) {
  client::LineOptions options;
  options.port = fake.port();
  options.timeout_ms = options.flash_timeout_ms = 150;
  return options;
}

// Looks like a load file as far as the controller's identity goes.
std::vector<std::uint16_t> some_program(std::size_t words) {
  std::vector<std::uint16_t> out(words);
  for (std::size_t i = 0; i < words; ++i) out[i] = static_cast<std::uint16_t>(i * 40503);
  const std::uint16_t head[] = {0x5250, 1, tables, 1, 0, 3};
  std::copy(std::begin(head), std::end(head), out.begin());
  return out;
}

class Lines : public testing::TestWithParam<FakeController::Line> {
 protected:
  FakeController fake{GetParam()};
};

TEST_P(Lines, ADownloadArrivesWholeAndRuns) {
  client::Controller controller(line_to(fake));
  for (const std::size_t size : {16, 64, 65, 1000}) {
    const auto words = some_program(size);
    std::size_t last = 0;
    const auto status =
        controller.download(words, line_to(fake), [&](std::size_t done, std::size_t all) {
          EXPECT_EQ(all, size);
          EXPECT_GT(done, last);
          last = done;
        });
    EXPECT_EQ(last, size);
    EXPECT_EQ(status.state, 1);
    EXPECT_EQ(status.length, size);
    EXPECT_EQ(fake.program(), words);
    EXPECT_EQ(controller.upload({}), words);
  }
  EXPECT_EQ(controller.status().generation, 4U);
}

TEST_P(Lines, LostAnswersAreAskedForAgain) {
  client::Controller controller(line_to(fake));
  fake.drop = 2;
  EXPECT_EQ(controller.status().state, 4);
  fake.drop = 3;
  EXPECT_THROW(controller.status(), client::TimeoutError);
  fake.drop = 0;
  const auto words = some_program(300);
  fake.drop = 1;
  fake.busy = 0;
  EXPECT_EQ(controller.download(words, line_to(fake), {}).state, 1);
}

TEST_P(Lines, ABusyControllerIsWaitedFor) {
  client::Controller controller(line_to(fake));
  fake.busy = 4;
  const auto words = some_program(200);
  EXPECT_EQ(controller.download(words, line_to(fake), {}).state, 1);
  EXPECT_EQ(fake.program(), words);
}

TEST_P(Lines, WhatWasDamagedOnTheWayIsRefusedByItsCrc) {
  client::Controller controller(line_to(fake));
  fake.damage = 1;
  try {
    controller.download(some_program(200), line_to(fake), {});
    FAIL() << "taken";
  } catch (const client::ClientError& error) {
    EXPECT_NE(std::string(error.what()).find("wrong CRC"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fake.program().empty());
}

TEST_P(Lines, ProgramsForAnotherControllerAreNotSent) {
  client::Controller controller(line_to(fake));
  struct Wrong {
    std::size_t word;
    std::uint16_t value;
    const char* what;
  };
  for (const Wrong& wrong : {Wrong{2, 0, "different tables"}, Wrong{3, 2, "configuration hx8k"},
                             Wrong{4, 1, "board ulx3s; this is board simulated"},
                             Wrong{5, 2, "for MPU2; the controller has MPU3"}}) {
    auto words = some_program(100);
    words[wrong.word] = wrong.value;
    const int before = fake.requests();
    try {
      controller.download(words, line_to(fake), {});
      FAIL() << wrong.what;
    } catch (const client::ClientError& error) {
      EXPECT_NE(std::string(error.what()).find(wrong.what), std::string::npos) << error.what();
      EXPECT_NE(error.mend, "");
    }
    EXPECT_EQ(fake.requests(), before);
  }
}

TEST_P(Lines, EveryWayToRefuseAProgramIsNamed) {
  client::Controller controller(line_to(fake));
  const std::pair<int, const char*> kEnds[] = {{3, "wrong CRC"},
                                               {4, "another board"},
                                               {5, "cannot write its flash"},
                                               {6, "cannot load a record"}};
  for (const auto& [state, what] : kEnds) {
    fake.load_ends = state;
    try {
      controller.download(some_program(100), line_to(fake), {});
      FAIL() << what;
    } catch (const client::ClientError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
}

// The new program answers as another unit: the client follows it.
TEST_P(Lines, TheLineChangesWithTheProgram) {
  client::Controller controller(line_to(fake));
  fake.unit_after_commit = 17;
  client::LineOptions after = line_to(fake);
  after.unit = 17;
  EXPECT_EQ(controller.download(some_program(100), after, {}).state, 1);
  EXPECT_EQ(controller.line().options().unit, 17);
}

TEST_P(Lines, ForcesAreSetListedAndReleased) {
  fake.allow_force(0x3405);
  fake.allow_force(0x3300);
  client::Controller controller(line_to(fake));
  EXPECT_TRUE(controller.forces().empty());
  controller.force(0x3405, true);
  controller.force(0x3300, false);
  auto forces = controller.forces();
  ASSERT_EQ(forces.size(), 2U);
  EXPECT_EQ(forces[0].address, 0x3300);
  EXPECT_FALSE(forces[0].value);
  EXPECT_TRUE(forces[1].value);
  controller.release(0x3300);
  EXPECT_EQ(controller.forces().size(), 1U);
  EXPECT_THROW(controller.force(0x3401, true), client::ExceptionError);
  controller.command(7);
  EXPECT_TRUE(controller.forces().empty());
}

TEST_P(Lines, ValuesAreReadInFewRequestsAndWithinTheirBounds) {
  for (int address = 0; address < 300; ++address)
    fake.set_word(address, static_cast<std::uint16_t>(address - 5));
  for (int address = 0; address < 600; ++address) fake.set_bit(address, address % 3 == 0);
  fake.set_word(0xA408, 0x5678);
  fake.set_word(0xA409, 0xFFFF);
  client::Controller controller(line_to(fake));
  std::vector<client::Watched> devices;
  for (int i = 0; i < 300; ++i) {
    devices.push_back({{io::Table::Holding, i, 0, 7999}, false});
    devices.push_back({{io::Table::Coil, i, 0, 7679}, false});
  }
  devices.push_back({{io::Table::Holding, 0xA408, 0, 0xA477}, true});
  for (const int points : {2000, 40}) {
    fake.set_register(holding_exchange_points, static_cast<std::uint16_t>(points));
    const int before = fake.requests();
    const auto values = client::read_values(controller.line(), devices, points);
    const int requests = fake.requests() - before;
    EXPECT_EQ(requests, points == 2000 ? 3 + 1 + 1 : 8 + 8 + 1);
    for (int i = 0; i < 300; ++i) {
      EXPECT_EQ(values[static_cast<std::size_t>(2 * i)], i - 5);
      EXPECT_EQ(values[static_cast<std::size_t>(2 * i + 1)], i % 3 == 0 ? 1 : 0);
    }
    EXPECT_EQ(values.back(), static_cast<std::int32_t>(0xFFFF5678));
  }
}

TEST_P(Lines, WhoIsNoRungControllerIsSaidSo) {
  fake.set_register(holding_identity, 7);
  try {
    client::Controller controller(line_to(fake));
    FAIL();
  } catch (const client::ClientError& error) {
    EXPECT_NE(std::string(error.what()).find("this is not a Rung controller"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Client, Lines,
                         testing::Values(FakeController::Line::Tcp, FakeController::Line::Rtu),
                         [](const auto& info) {
                           return info.param == FakeController::Line::Tcp ? "Tcp" : "Rtu";
                         });

TEST(Rtu, GarbledAnswersAreAskedForAgain) {
  FakeController fake(FakeController::Line::Rtu);
  client::Controller controller(line_to(fake));
  fake.garble = 2;
  EXPECT_EQ(controller.status().state, 4);
  fake.garble = 3;
  try {
    controller.status();
    FAIL();
  } catch (const client::ClientError& error) {
    EXPECT_NE(std::string(error.what()).find("the answer is garbled"), std::string::npos);
  }
}

}  // namespace
}  // namespace rung::tb
