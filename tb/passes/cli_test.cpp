// SPDX-License-Identifier: Apache-2.0
// The rung program as users call it: exit codes, where output goes, and what wrong input leaves
// behind.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_support.hpp"

namespace rung::cli {
namespace {

constexpr const char* kMotor = "LD X0\nOR Y0\nANI X1\nOUT Y0\nEND\n";

TEST_F(Cli, CompileSaysItsCountsAsJson) {
  const Result r = rung("compile " + file("motor.il", kMotor) + " --mpu 2 --json");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err, "");
  const auto json = nlohmann::json::parse(r.out);
  for (const char* key :
       {"program", "mpu", "dialect", "config", "rungs", "instructions", "contacts", "runs",
        "lookups", "steps", "clocks", "lut_rows", "bit_devices", "word_devices"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["mpu"], 2);
  EXPECT_EQ(json["rungs"], 1);
  EXPECT_EQ(json["instructions"], 4);
  EXPECT_EQ(json["contacts"], 3);
  EXPECT_EQ(json["runs"], 1);
  EXPECT_EQ(json["lookups"], 1);
  EXPECT_EQ(json["steps"], 1);
  EXPECT_EQ(json["bit_devices"], 3);
}

TEST_F(Cli, AnImageRunsAsTheProgramDoes) {
  const std::string program = file("motor.il", kMotor);
  const std::string stimulus = file("motor.stim", "X0=1\nX0=0\nX1=1\n\n");
  for (const char* mpu : {"1", "2", "3", "4", "4 --slots 16", "4 --slots 4 --no-merge"}) {
    const std::string on = std::string(" --mpu ") + mpu;
    ASSERT_EQ(rung("compile " + program + on + " -o " + path("motor.img")).code, 0);
    ASSERT_EQ(
        rung("run " + path("motor.img") + " --stimulus " + stimulus + " --trace " + path("a")).code,
        0);
    ASSERT_EQ(
        rung("run " + program + on + " --stimulus " + stimulus + " --trace " + path("b")).code, 0);
    EXPECT_EQ(read(path("a")), read(path("b")));
    EXPECT_EQ(rung("check " + path("motor.img") + " --golden " + path("b")).code, 0);
    EXPECT_EQ(rung("check " + program + " --mpu reference --golden " + path("b")).code, 0);
  }
}

TEST_F(Cli, StandardInputAndOutput) {
  const std::string program = file("motor.il", kMotor);
  const Result image = rung("compile - -o -", program);
  EXPECT_EQ(image.code, 0);
  EXPECT_EQ(image.out.substr(0, 7), "RUNGIMG");
  const Result trace = rung("run - --mpu reference --scans 2 --trace -", program);
  EXPECT_EQ(trace.code, 0);
  EXPECT_EQ(std::count(trace.out.begin(), trace.out.end(), '\n'), 3);
}

TEST_F(Cli, ADifferenceFromTheGoldenTraceIsExit3) {
  const std::string program = file("motor.il", kMotor);
  const std::string stimulus = file("motor.stim", "X0=1\n");
  ASSERT_EQ(rung("run " + program + " --stimulus " + stimulus + " --trace " + path("t")).code, 0);
  std::string golden = read(path("t"));
  golden.replace(golden.find("[\"Y0\",1]"), 8, "[\"Y0\",0]");
  const Result r = rung("check " + program + " --golden " + file("bad.golden", golden));
  EXPECT_EQ(r.code, 3);
  for (const char* part : {"bad.golden:2:1", "scan 0", "Y0", "expected nothing", "got 1", "step 0",
                           "OUT Y0", "replay: rung check"}) {
    EXPECT_NE(r.err.find(part), std::string::npos) << part << " is not in\n" << r.err;
  }
}

TEST_F(Cli, WrongUsageIsExit2) {
  const std::string program = file("motor.il", kMotor);
  ASSERT_EQ(rung("compile " + program + " --mpu 2 -o " + path("motor.img")).code, 0);
  for (const std::string& arguments :
       {std::string(), std::string("compile"), "compile " + program + " --mpu 7",
        "compile " + program + " --config none", "compile " + program + " --paper --dialect fx",
        "run " + program + " --tick 0", "run " + program + " --tick 1.2345",
        "run " + program + " --tick abc", "run " + path("motor.img") + " --mpu 3",
        "run " + path("motor.img") + " --mpu reference", "translate " + program + " --to cobol",
        "check " + program}) {
    EXPECT_EQ(rung(arguments).code, 2) << arguments;
  }
}

TEST_F(Cli, ByteCodeIsAFileOrAListing) {
  const std::string program = file("motor.il", kMotor);
  const std::string output = path("motor.rbc");
  const Result r = rung("translate " + program + " --to bytecode -o " + output);
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out + r.err, "");
  EXPECT_EQ(read(output).substr(0, 4), "RBC\x1A");
  EXPECT_EQ(rung("translate " + program + " --to bytecode").out, read(output));
  const Result text = rung("translate " + program + " --to bytecode --listing");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("ANI X1\n"), std::string::npos) << text.out;
  EXPECT_EQ(rung("translate " + program + " --to il --listing").code, 2);
}

TEST_F(Cli, VerilogIsAModuleWithItsPortsInTheHead) {
  const std::string program = file("motor.il", kMotor);
  const Result r = rung("translate " + program + " --to verilog");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_NE(r.out.find("The program motor.il as logic"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("\nmodule rung_program ("), std::string::npos) << r.out;
  EXPECT_EQ(rung("translate " + program + " --to verilog --path-ns 6").out, r.out)
      << "a program of bits is one clock whatever its paths are";
  EXPECT_EQ(rung("translate " + program + " --to verilog --path-ns 0").code, 2);
  EXPECT_EQ(rung("translate " + program + " --to c --path-ns 6").code, 2);
}

// Every kind of wrong input: exit 1, a message at its place, and no output file.
TEST_F(Cli, WrongInputIsRefusedAndLeavesNothing) {
  struct Case {
    const char* name;
    std::string text;
    const char* where;
  };
  std::string large;
  for (int i = 0; i < 17000; ++i) large += "LD X0\nOUT M0\nOUT M1\n";
  const Case cases[] = {
      {"unknown.il", "LD X0\nFROB M0\nEND\n", ":2:1: error:"},
      {"device.il", "LD Q0\nOUT M0\nEND\n", ":1:4: error:"},
      {"range.il", "LD M8192\nOUT M0\nEND\n", ":1:4: error:"},
      {"octal.il", "LD X8\nOUT M0\nEND\n", ":1:4: error:"},
      {"stack.il", "LD X0\nLD X1\nOUT M0\nEND\n", ":3:1: error:"},
      {"end.il", "LD X0\nOUT M0\n", " error:"},
      {"empty.il", "", ":1:1: error:"},
      {"binary.il", std::string("LD\0X0\x01\x02", 7), ":1:1: error:"},
      {"large.il", large + "END\n", ":1:1: error: the program needs"},
      {"image.img", "RUNGIMG\x01 damaged", ":1:1: error:"},
      {"ladder.ld", "LDmicro0.1\n", ":1:1: error: this is no LDmicro program"},
      {"export.csv", "\"0\"\t\"\"\t\"LD\"\n", ":1:"},
      {"timer.il", "LD X0\nOUT T0 K40000\nEND\n", ":2:"},
      {"jump.il", "P1\nLD X0\nOUT Y0\nLD X1\nCJ P1\nEND\n", ":5:"},
  };
  for (const Case& one : cases) {
    const std::string program = file(one.name, one.text);
    const std::size_t before = files();
    for (const char* mpu : {"1", "3"}) {
      const Result r = rung("compile " + program + " --mpu " + mpu + " -o " + path("out.img"));
      EXPECT_EQ(r.code, 1) << one.name << r.err;
      EXPECT_EQ(r.out, "") << one.name;
      EXPECT_NE(r.err.find(program + ":"), std::string::npos) << one.name << r.err;
      EXPECT_NE(r.err.find(one.where), std::string::npos) << one.name << r.err;
    }
    EXPECT_EQ(rung("run " + program + " --trace " + path("out.trace")).code, 1) << one.name;
    // C has room for any program.
    if (std::string(one.name) != "large.il") {
      EXPECT_EQ(rung("translate " + program + " --to c -o " + path("out.c")).code, 1) << one.name;
    }
    EXPECT_EQ(files(), before) << one.name << " left a file behind";
  }
}

constexpr const char* kLatch =
    "LDmicro0.1\nCYCLE=20000\n\nPROGRAM\nRUNG\n  PARALLEL\n    CONTACTS Xon 0\n"
    "    CONTACTS Ylamp 0\n  END\n  CONTACTS Xoff 1\n  COIL Ylamp 0 0 0\nEND\n";

TEST_F(Cli, LdmicroProgramsLikeLists) {
  const std::string program = file("latch.ld", kLatch);
  const std::string stimulus = file("latch.stim", "Xon=1\nXon=0\nXoff=1\n");
  for (const char* mpu : {"1", "2", "3", "reference"}) {
    const Result r =
        rung("run " + program + " --mpu " + mpu + " --stimulus " + stimulus + " --trace -");
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("\"dialect\":\"ldmicro\",\"tick_ms\":20"), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\"out\":{\"Ylamp\":1}"), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\"out\":{\"Ylamp\":0}"), std::string::npos) << r.out;
  }
  // By the option where no suffix shows it.
  EXPECT_EQ(rung("compile - --dialect ldmicro --json", program).code, 0);
  const Result json = rung("compile " + program + " --json");
  EXPECT_EQ(nlohmann::json::parse(json.out)["rungs"], 1);
  EXPECT_EQ(nlohmann::json::parse(json.out)["instructions"], 4);
}

TEST_F(Cli, LdmicroProgramsAreTranslated) {
  const std::string program = file("latch.ld", kLatch);
  const Result r = rung("translate " + program + " --to ld -o " + path("again.ld"));
  EXPECT_EQ(r.code, 0) << r.err;
  const std::string text = read(path("again.ld"));
  EXPECT_EQ(text.substr(0, 23), "LDmicro0.1\nCYCLE=20000\n");
  const Result again = rung("translate " + path("again.ld") + " --to ld");
  EXPECT_EQ(again.out, text);
  EXPECT_EQ(rung("translate " + program + " --to c").code, 0);
  // Neither form holds all of the other.
  const Result list = rung("translate " + program + " --to il -o " + path("out.il"));
  EXPECT_EQ(list.code, 1);
  EXPECT_NE(list.err.find("latch.ld:1:1: error:"), std::string::npos) << list.err;
  EXPECT_EQ(rung("translate " + file("motor.il", kMotor) + " --to ld").code, 1);
  EXPECT_FALSE(fs::exists(path("out.il")));
  // Nothing is written of what passes a limit of LDmicro 2.3.
  const std::string comment =
      "LDmicro0.1\nPROGRAM\nRUNG\nCOMMENT " + std::string(400, 'c') + "\nEND\n";
  const Result refused =
      rung("translate " + file("long.ld", comment) + " --to ld -o " + path("out.ld"));
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("long.ld:4:1: error: COMMENT: 400 bytes"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out.ld")));
}

TEST_F(Cli, OptionsOfListsAreWrongUsageForLdmicroPrograms) {
  const std::string program = file("latch.ld", kLatch);
  const std::string names = file("names.csv", "\"X0\",\"start\"\n");
  for (const std::string& option :
       {std::string("--paper"), "--comments " + names, std::string("--tick 5")}) {
    const Result r = rung("run " + program + " " + option);
    EXPECT_EQ(r.code, 2) << option << r.err;
    EXPECT_NE(r.err.find(option.substr(0, 6)), std::string::npos) << r.err;
  }
}

TEST_F(Cli, CommentsNameDevicesInTracesAndListings) {
  const std::string program = file("door.il", "LD X0\nOUT Y0\nEND\n");
  const std::string names =
      file("names.csv", "\"COMMENT\"\n\"Device Name\"\t\"Comment\"\n\"X0\"\t\"gate open\"\n");
  const std::string options = program + " --comments " + names;
  for (const char* mpu : {"2", "reference"}) {
    const Result r = rung("run " + options + " --mpu " + mpu + " --trace -");
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("\"comments\":{\"X0\":\"gate open\"}"), std::string::npos) << r.out;
  }
  EXPECT_NE(rung("compile " + options + " --listing").out.find("; X0: gate open\n"),
            std::string::npos);
  const std::string bad =
      file("bad.csv", "\"COMMENT\"\n\"Device Name\"\t\"Comment\"\n\"Q0\"\t\"x\"\n");
  const Result r = rung("run " + program + " --comments " + bad);
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find(bad + ":1:1: error:"), std::string::npos) << r.err;
}

// The contact goes on in the first scan whose ticks since the coil's reach the preset.
TEST_F(Cli, TheTickIsTheTimeFromScanToScan) {
  const std::string program = file("timer.il", "LD X0\nOUT T0 K2\nLD T0\nOUT Y0\nEND\n");
  const std::string stimulus = file("timer.stim", "X0=1\n*9\n");
  const std::pair<const char*, const char*> cases[] = {
      {"100", "\"scan\":2,"}, {"50", "\"scan\":4,"}, {"70.5", "\"scan\":3,"}};
  for (const auto& [tick, scan] : cases) {
    for (const char* mpu : {"1", "2", "3", "reference"}) {
      const Result r = rung("run " + program + " --stimulus " + stimulus + " --tick " + tick +
                            " --mpu " + mpu + " --trace -");
      const std::size_t on = r.out.find("\"out\":{\"Y0\":1}");
      ASSERT_NE(on, std::string::npos) << r.out << r.err;
      const std::size_t line = r.out.rfind('\n', on);
      EXPECT_EQ(r.out.substr(line + 2, std::string(scan).size()), scan) << tick << " MPU" << mpu;
    }
  }
}

TEST_F(Cli, SeveralErrorsInOneRun) {
  const Result r = rung("compile " + file("bad.il", "LD X9\nFROB M0\nOUT D0\nLD Y0\nEND\n"));
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find(":1:4: error:"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find(":2:1: error:"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find(":3:5: error:"), std::string::npos) << r.err;
}

TEST_F(Cli, PaperRefusesWhatTable4DoesNotHave) {
  const Result r = rung("compile " + file("set.il", "LD X0\nSET M0\nEND\n") + " --paper");
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find(":2:1: error:"), std::string::npos) << r.err;
}

TEST_F(Cli, AnUnwritableOutputIsAnError) {
  const Result r = rung("compile " + file("motor.il", kMotor) + " -o " + path("none/motor.img"));
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find("error:"), std::string::npos);
}

// An LDmicro program: its names, its cycle, what it sends; and what LDmicro's own simulator showed.
constexpr const char* kEcho =
    "LDmicro0.1\nCYCLE=20000\nPROGRAM\nRUNG\n    CONTACTS Xgo 0\n    READ_ADC level\n"
    "    UART_SEND level\n    COIL Ybusy 0 0 0\nEND\n";

TEST_F(Cli, LdmicroProgramsRunByTheirNames) {
  const std::string program = file("echo.ld", kEcho);
  const std::string stimulus = file("echo.stim", "level=300 *2\nXgo=1\n\nXgo=0 RX=1\n");
  for (const char* mpu : {"reference", "1", "2", "3", "4"}) {
    const std::string on = std::string(" --mpu ") + mpu;
    const Result r = rung("run " + program + on + " --stimulus " + stimulus + " --trace -");
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("\"dialect\":\"ldmicro\",\"tick_ms\":20"), std::string::npos) << r.out;
    for (const char* part :
         {"\"in\":{\"level\":300}", "\"in\":{\"Xgo\":1}", "[\"level\",300]",
          "\"out\":{\"Ybusy\":1},\"tx\":[44]", "\"in\":{\"Xgo\":0,\"RX\":[1]}"}) {
      EXPECT_NE(r.out.find(part), std::string::npos) << mpu << ": " << part << "\n" << r.out;
    }
    const std::string golden = file("echo.golden", r.out);
    EXPECT_EQ(rung("check " + program + on + " --golden " + golden).code, 0);
  }
  ASSERT_EQ(rung("compile " + program + " -o " + path("echo.img")).code, 0);
  EXPECT_EQ(rung("check " + path("echo.img") + " --golden " + path("echo.golden")).code, 0);
}

TEST_F(Cli, CheckTakesATraceOfLdmicrosSimulator) {
  const std::string program = file("echo.ld", kEcho);
  const std::string stimulus = " --stimulus " + file("echo.stim", "level=300\nXgo=1\n\nXgo=0\n");
  const std::string shown =
      "0: Xgo=0 Ybusy=0\n1: Xgo=1 Ybusy=1 level=300 TX=44\n2: Xgo=1 Ybusy=1 level=300\n";
  const std::string good = file("good.trace", shown + "3: Xgo=0 Ybusy=0 level=300\n");
  const std::string stopped = file("stopped.trace", shown + "3: Xgo=0 DIVZERO_HALT\n");
  const std::string bad = file("bad.trace", shown + "3: Xgo=0 Ybusy=1 level=300\n");
  const std::string check = "check " + program + " --golden ";
  for (const char* mpu : {"reference", "1", "2", "3", "4"}) {
    const std::string on = stimulus + " --mpu " + mpu;
    EXPECT_EQ(rung(check + good + on).code, 0) << mpu;
    const Result note = rung(check + stopped + on);
    EXPECT_EQ(note.code, 0);
    EXPECT_NE(note.err.find("stopped.trace:4:1: note: "), std::string::npos) << note.err;
    const Result r = rung(check + bad + on);
    EXPECT_EQ(r.code, 3);
    EXPECT_NE(r.err.find("bad.trace:4:1: scan 3: state of Ybusy: expected 1, got 0"),
              std::string::npos)
        << r.err;
  }
  EXPECT_EQ(rung(check + good).code, 2) << "without a stimulus";
  EXPECT_EQ(rung(check + good + stimulus + " --tick 10").code, 2);
  EXPECT_EQ(rung("run " + program + " --tick 20").code, 2);
  EXPECT_EQ(rung(check + file("no.trace", "1: Xgo=0\n") + stimulus).code, 1);
}

}  // namespace
}  // namespace rung::cli
