// SPDX-License-Identifier: Apache-2.0
// compiler/bytecode/README.md says what the code does: its table of instructions, and its example,
// which is built and run as a user would.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "bytecode/opcodes.hpp"
#include "bytecode/vm_engine.hpp"
#include "melsec/list.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

const std::string kInterpreter = RUNG_REPOSITORY "/compiler/bytecode/interpreter";

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

const std::string& page() {
  static const std::string text = read(RUNG_REPOSITORY "/compiler/bytecode/README.md");
  return text;
}

// A folder of the test's own, that goes when it ends.
class Folder {
 public:
  Folder()
      : path_(fs::path(RUNG_SCRATCH) /
              testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

// What a command prints, and whether it went well.
bool run(const std::string& command, const std::string& output) {
  return std::system(fmt::format("{} >{} 2>&1", command, output).c_str()) == 0;
}

TEST(Page, HasEveryInstruction) {
  for (const bytecode::CodeInfo& code : bytecode::codes()) {
    const std::string row = fmt::format("| {} | {} | {} | {} | {} |\n", static_cast<int>(code.code),
                                        code.name, code.operands, code.effect, code.meaning);
    EXPECT_NE(page().find(row), std::string::npos) << row;
  }
}

TEST(Page, HasTheVersion) {
  const std::string version = fmt::format("now {}.{}", RUNG_FORMAT_MAJOR, RUNG_FORMAT_MINOR);
  EXPECT_NE(page().find(version), std::string::npos);
}

TEST(Page, ItsExampleBuildsAndRuns) {
  const std::size_t begin = page().find("```c\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string example = page().substr(begin + 5, page().find("```", begin + 5) - begin - 5);
  Diagnostics diagnostics;
  const auto source = decode_text("LD X0\nOR Y0\nANI X1\nOUT Y0\nEND\n", "motor.il", diagnostics);
  const auto program = parse_list(*source, Dialect::Fx, diagnostics);
  ASSERT_TRUE(program);
  const std::string file = bytecode_of(*program);

  const Folder folder;
  std::ofstream(folder / "main.c") << example;
  std::ofstream array(folder / "motor.h");
  array << "static const unsigned char motor_rbc[] = {";
  for (const char byte : file) array << static_cast<int>(static_cast<std::uint8_t>(byte)) << ",";
  array << "};\nstatic const unsigned int motor_rbc_len = sizeof motor_rbc;\n";
  array.close();
  for (const char* const standard : {"c99", "c89"}) {
    const std::string command = fmt::format(
        "{0} -std={1} -Wall -Wextra -pedantic -Wconversion -Wshadow -Werror -I{2} {3}/main.c "
        "{2}/rung_check.c {2}/rung_vm.c {2}/rung_access.c {2}/rung_io.c -o {3}/motor",
        RUNG_C_COMPILER, standard, kInterpreter, folder / "");
    ASSERT_TRUE(run(command, folder / "log")) << standard << ":\n" << read(folder / "log");
    ASSERT_TRUE(run(folder / "motor", folder / "out"));
    EXPECT_EQ(read(folder / "out"), "Y0 = 0\nY0 = 0\nY0 = 1\nY0 = 1\nY0 = 1\n") << standard;
  }
}

// int has 16 bits there, and the file lies in flash.
TEST(Page, TheInterpreterBuildsForAnAvr) {
  if (std::system("avr-gcc --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "skipped: no avr-gcc";
  const Folder folder;
  for (const char* const file : {"rung_check", "rung_vm", "rung_access", "rung_io"}) {
    for (const char* const flash : {"", "-DRUNG_VM_READ=pgm_read_byte -include avr/pgmspace.h"}) {
      const std::string command = fmt::format(
          "avr-gcc -mmcu=atmega328p -Os -std=c99 -Wall -Wextra {} -Wconversion -Werror {} -c "
          "{}/{}.c -o {}",
          *flash == '\0' ? "-pedantic" : "", flash, kInterpreter, file, folder / "out.o");
      EXPECT_TRUE(run(command, folder / "log")) << read(folder / "log");
    }
  }
}

}  // namespace
}  // namespace rung::tb
