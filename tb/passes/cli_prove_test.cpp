// SPDX-License-Identifier: Apache-2.0
// rung compile --prove.
#include <nlohmann/json.hpp>

#include "cli_support.hpp"

namespace rung::cli {
namespace {

TEST_F(Cli, ProveSaysWhatIsProven) {
  const std::string program = file("p.il", "LD X0\nOR Y0\nANI X1\nOUT Y0\nADD D0 K1 D1\nEND\n");
  for (const char* mpu : {"1", "2", "3", "4", "4 --no-merge"}) {
    const Result text = rung("compile " + program + " --prove --mpu " + mpu);
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_NE(text.out.find("proven: "), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find("not proven"), std::string::npos) << text.out;
    const Result json = rung("compile " + program + " --prove --json --mpu " + mpu);
    ASSERT_EQ(json.code, 0) << json.err;
    const auto proof = nlohmann::json::parse(json.out).at("proof");
    EXPECT_GE(proof.at("writes"), 2);
    EXPECT_EQ(proof.at("proven"), proof.at("writes"));
    EXPECT_EQ(proof.at("wrong"), 0);
    EXPECT_TRUE(proof.at("not_proven").empty());
    EXPECT_TRUE(proof.at("seconds").is_number());
  }
}

TEST_F(Cli, WithoutProveThereIsNoProof) {
  const std::string program = file("p.il", "LD X0\nOUT Y0\nEND\n");
  const Result json = rung("compile " + program + " --json");
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_FALSE(nlohmann::json::parse(json.out).contains("proof"));
}

}  // namespace
}  // namespace rung::cli
