// SPDX-License-Identifier: Apache-2.0
// load, monitor, force, info, control and export as users call them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/fake_controller.hpp"
#include "load/load_file.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;
using namespace controller;

struct Result {
  int code = -1;
  std::string out, err;
};

class ClientCli : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("rung-client-" + std::string(info->name()) + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  static std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  Result rung(const std::string& arguments) const {
    const std::string command = std::string(RUNG_PROGRAM) + " " + arguments + " </dev/null >" +
                                (folder_ / ".out").string() + " 2>" + (folder_ / ".err").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder_ / ".out"),
            read(folder_ / ".err")};
  }
  // With the fake's port behind the command.
  Result talk(const std::string& arguments) const {
    return rung(arguments + " --timeout 200 --port " + fake_.port());
  }
  static void expect(const Result& result, int code, std::initializer_list<const char*> parts) {
    EXPECT_EQ(result.code, code) << result.out << result.err;
    for (const char* part : parts) {
      EXPECT_NE((result.out + result.err).find(part), std::string::npos)
          << part << " is not in\n"
          << result.out << result.err;
    }
  }

  fs::path folder_;
  mutable FakeController fake_{FakeController::Line::Rtu};
};

constexpr const char* kMotor =
    "LD X0\nOR Y0\nANI X1\nOUT Y0\nLD M0\nOUT C220 K5\nMOV K-3 D7\nEND\n";

TEST_F(ClientCli, LoadCompilesAndDownloads) {
  const std::string program = file("motor.il", kMotor);
  expect(talk("load " + program), 0, {"motor.il: loaded", "generation 1, running"});
  const std::string written = (folder_ / "motor.rlf").string();
  ASSERT_EQ(rung("compile " + program + " --load-file " + written).code, 0);
  EXPECT_EQ(load::to_bytes(fake_.program()), read(written));
  // An image is as good.
  const std::string image = (folder_ / "motor.img").string();
  ASSERT_EQ(rung("compile " + program + " -o " + image).code, 0);
  expect(talk("load " + image), 0, {"generation 2"});
  EXPECT_EQ(load::to_bytes(fake_.program()), read(written));
}

TEST_F(ClientCli, LoadRefusesWhatIsForAnotherController) {
  const std::string program = file("motor.il", kMotor);
  const std::string map = file("board.toml", "board = \"hx8k\"\n");
  expect(
      talk("load " + program + " --io " + map), 1,
      {fake_.port().c_str(), ":1:1: error: the program is for board hx8k; this is board simulated",
       "board = \"simulated\""});
  expect(talk("load " + program + " --mpu 2"), 1, {"has MPU3; the program is compiled for MPU2"});
  fake_.set_register(holding_tables, 1);
  expect(talk("load " + program), 1, {"made from different tables"});
  EXPECT_TRUE(fake_.program().empty());
}

TEST_F(ClientCli, LoadSaysWhenTheCrcIsRefused) {
  fake_.damage = 1;
  expect(talk("load " + file("motor.il", kMotor)), 1, {"error: the controller found a wrong CRC"});
}

TEST_F(ClientCli, ErrorsOfTheLine) {
  expect(rung("info --port /dev/ttyRung"), 1, {"/dev/ttyRung:1:1: error: there is no such device"});
  expect(rung("info --port " + file("text", "x")), 1, {"error: this is no serial port"});
  expect(rung("info --port tcp:127.0.0.1:1"), 1, {"error: cannot be opened: Connection refused"});
  expect(rung("info --port tcp:nowhere"), 1, {"error: this is no address"});
  if (::getuid() != 0) {
    const std::string locked = file("locked", "");
    fs::permissions(locked, fs::perms::none);
    expect(rung("info --port " + locked), 1, {"permission denied", "dialout"});
  }
  expect(talk("info --unit 5"), 1, {"no answer in time", "unit 5, 19200 baud and parity E"});
  fake_.set_register(holding_identity, 0);
  expect(talk("info"), 1, {"this is not a Rung controller"});
}

TEST_F(ClientCli, WrongUsageIsExit2) {
  for (const char* arguments :
       {"info", "load x.il", "force --port x", "monitor --port x", "force --port x X0",
        "control --port x jump", "info --port x --baud 1234", "info --port x --unit 300"}) {
    EXPECT_EQ(rung(arguments).code, 2) << arguments;
  }
}

TEST_F(ClientCli, InfoTellsWhatIsThere) {
  fake_.set_register(holding_overruns, 5);
  fake_.set_register(holding_scan_last, 0x1000);
  fake_.set_register(holding_scan_last + 1, 1);
  fake_.set_register(holding_inputs + 1, 0x8001);
  fake_.set_register(holding_fault, 2);
  expect(talk("info"), 0,
         {"board simulated, configuration ecp5, MPU3", "no program, fault: no program that may run",
          "clocks last 69632", "overruns 5", "inputs at 1: in16 in31", "outputs at 1: none"});
}

TEST_F(ClientCli, MonitorShowsAndRecords) {
  fake_.set_bit(0x3400, true);
  fake_.set_word(7, 0xFFFD);
  fake_.set_bit(0x3200 + 220, false);
  fake_.set_word(0xA408 + 40, 0x0001);
  fake_.set_word(0xA408 + 41, 0x0001);
  const std::string csv = (folder_ / "a.csv").string();
  const Result shown = talk("monitor X0 D7 C220 --count 3 --interval 10 --csv " + csv);
  expect(shown, 0, {"Z X0=1 D7=-3 CS220=0 CN220=65537\n"});
  EXPECT_EQ(std::count(shown.out.begin(), shown.out.end(), '\n'), 3);
  const std::string rows = read(csv);
  EXPECT_EQ(rows.substr(0, rows.find('\n')), "time,X0,D7,CS220,CN220");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 4);
  EXPECT_TRUE(rows.ends_with("Z,1,-3,0,65537\n")) << rows;
}

TEST_F(ClientCli, MonitorOfAProgramShowsAllOfIt) {
  for (const int bit : {0x3400, 0x3401, 0x3300, 0, 0x3200 + 220}) fake_.set_bit(bit, true);
  for (const int word : {7, 0xA408 + 40, 0xA408 + 41}) fake_.set_word(word, 1);
  const std::string program = file("motor.il", kMotor);
  expect(talk("monitor " + program + " --count 1"), 0,
         {"X0=1 X1=1 Y0=1 M0=1 CS220=1 D7=1 CN220=65537\n"});
  const std::string names = file("names.csv", "Device,Comment\nX0,Start\nY0,Motor\n");
  expect(talk("monitor " + program + " Start Motor --comments " + names + " --count 1"), 0,
         {"X0=1 Y0=1\n"});
  expect(talk("monitor " + program + " Strat --comments " + names), 1, {"did you mean Start?"});
  expect(talk("monitor M9000"), 1, {"this is neither a device nor a name"});
  expect(talk("monitor D100 --count 1"), 1, {"exception 02"});
}

TEST_F(ClientCli, ForceListsAndReleases) {
  fake_.allow_force(0x3405);
  fake_.allow_force(0x3300);
  expect(talk("force X5=1 Y0=0"), 0, {"Y0 = 0\nX5 = 1\n"});
  expect(talk("force --list"), 0, {"Y0 = 0\nX5 = 1\n"});
  expect(talk("force Y0=release"), 0, {"X5 = 1\n"});
  expect(talk("force --release-all --list"), 0, {"nothing is forced"});
  expect(talk("force X6=1"), 1, {"X6: ", "exception 02", "needs a pin in the I/O map"});
  expect(talk("force M0=1"), 1, {"M0=1:1:1: error: inputs (X) and outputs (Y) can be forced"});
  expect(talk("force X9=1"), 1, {"neither a device nor a name"});
  expect(talk("force X5=1 --dialect q"), 0, {"X5 = 1"});
  const std::string program = file("motor.il", "LD X5\nOUT Y0\nEND\n");
  const std::string names = file("names.csv", "Device,Comment\nX5,Start\n");
  expect(talk("force Start=0 --program " + program + " --comments " + names), 0, {"X5 Start = 0"});
}

TEST_F(ClientCli, ControlGivesCommands) {
  expect(talk("control run"), 0, {": running"});
  expect(talk("control scan"), 1, {"exception 03"});
  expect(talk("control stop"), 0, {": stopped"});
  expect(talk("control save"), 0, {});
  EXPECT_EQ(fake_.commands(), (std::vector<int>{1, 3, 2, 6}));
}

TEST_F(ClientCli, ExportGivesEveryAddress) {
  const std::string program =
      file("p.il", "LD X0\nOUT Y1\nLD M600\nOUT C220 K5\nMOV D1 D999\nMOV D2 R5000\nEND\n");
  const std::string names = file("names.csv", "Device,Comment\nX0,\"Start, left\"\n");
  const Result all = rung("export " + program + " --symbols - --comments " + names);
  expect(all, 0,
         {"name,comment,device,table,address,type\n", "X0,\"Start, left\",X0,discrete,13312,bit\n",
          "Y1,,Y1,coil,13057,bit\n", "CN220,,CN220,holding,42032,int32\n",
          "D999,,D999,holding,999,int16\n", "R5000,,R5000,none,,int16\n",
          "warning: devices of the program without a Modbus address on a controller of "
          "configuration ecp5: 1"});
  EXPECT_EQ(all.out.find("CN220:h"), std::string::npos);
}

TEST_F(ClientCli, CompileTellsBoundsAndBindings) {
  const std::string program = file("motor.il", kMotor);
  const std::string map = file(
      "b.toml", "board = \"hx8k\"\n[inputs]\nX0 = \"t1\"\nX1 = \"r3\"\n[outputs]\nY0 = \"led0\"\n");
  expect(rung("compile " + program + " --io " + map), 0,
         {"MPU2", "scan cycle: latch ", "input edge to output edge: "});
  expect(rung("compile " + program + " --io " + map + " --bindings"), 0,
         {"board hx8k: iCE40-HX8K breakout", "led0"});
  expect(rung("compile " + program + " --io " + map + " --json"), 0,
         {"\"config\":\"hx8k\"", "\"controller\":{\"board\":\"hx8k\"",
          "\"edge_to_edge_most_clocks\":"});
  expect(rung("run " + program + " --io " + map), 0, {"equal to the reference"});
  expect(rung("run " + program + " --mpu reference --io " +
              file("bad.toml", "board = \"hx8k\"\n[inputs]\nX0 = \"t4\"\n")),
         1, {"bad.toml:3:6: error: t4: board hx8k has no input pin"});
}

}  // namespace
}  // namespace rung::tb
