// SPDX-License-Identifier: Apache-2.0
#include "c_program.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "backends/c_writer.hpp"
#include "reference/reference.hpp"

namespace rung {
namespace {

char kind_letter(Device device) { return "XYMD"[static_cast<std::size_t>(device.kind)]; }

}  // namespace

CProgram::CProgram(const Program& program) {
  static int number = 0;
  const std::string base = fmt::format("{}/c_program.{}.{}", RUNG_SCRATCH, ::getpid(), number++);
  std::ofstream(base + ".c") << to_c(program);
  const std::string command = fmt::format(
      "'{0}' -std=c99 -Wall -Wextra -pedantic -Wmissing-prototypes -Werror -O2 "
      "-fsanitize=undefined -fsanitize-undefined-trap-on-error -fPIC -shared -o '{1}.so' '{1}.c' "
      "> '{1}.log' 2>&1",
      RUNG_C_COMPILER, base);
  const int failed = std::system(command.c_str());
  std::ifstream log(base + ".log");
  EXPECT_EQ(failed, 0) << std::string(std::istreambuf_iterator<char>(log), {});
  if (failed == 0) library_ = ::dlopen((base + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  EXPECT_NE(library_, nullptr);
  for (const char* const suffix : {".c", ".so", ".log"}) std::filesystem::remove(base + suffix);
}

CProgram::~CProgram() {
  if (library_ != nullptr) ::dlclose(library_);
}

void* CProgram::symbol(const std::string& name) const {
  void* const found = ::dlsym(library_, name.c_str());
  EXPECT_NE(found, nullptr) << name;
  return found;
}

void CProgram::reset() const { reinterpret_cast<void (*)()>(symbol("PlcReset"))(); }
void CProgram::cycle() const { reinterpret_cast<void (*)()>(symbol("PlcCycle"))(); }
bool CProgram::error() const {
  return reinterpret_cast<std::uint8_t (*)()>(symbol("PlcError"))() != 0;
}

std::int16_t CProgram::read(Device device) const {
  void* const function = symbol(fmt::format("PlcRead{}", kind_letter(device)));
  if (is_word(device)) {
    return reinterpret_cast<std::int16_t (*)(std::uint32_t)>(function)(device.number);
  }
  return reinterpret_cast<std::uint8_t (*)(std::uint32_t)>(function)(device.number);
}

void CProgram::write(Device device, std::int16_t value) const {
  void* const function = symbol(fmt::format("PlcWrite{}", kind_letter(device)));
  if (is_word(device)) {
    reinterpret_cast<void (*)(std::uint32_t, std::int16_t)>(function)(device.number, value);
  } else {
    reinterpret_cast<void (*)(std::uint32_t, std::uint8_t)>(function)(
        device.number, static_cast<std::uint8_t>(value));
  }
}

void expect_c_equals_reference(const Program& program, int scans, RandomSource& random) {
  const CProgram c(program);
  ASSERT_TRUE(c.good());
  c.reset();
  Reference reference(program);
  const std::vector<Device> devices = named_devices(program);
  for (int scan = 0; scan < scans; ++scan) {
    for (const Device device : devices) {
      const bool input = device.kind == DeviceKind::X;
      if (!random.percent(input ? 40 : 3)) continue;
      const auto value = static_cast<std::int16_t>(is_word(device) ? random.below(65536) - 32768
                                                                   : random.below(2));
      c.write(device, value);
      reference.set(device, value);
    }
    c.cycle();
    reference.run_scan();
    ASSERT_EQ(c.error(), reference.error()) << "scan " << scan;
    for (const Device device : devices) {
      ASSERT_EQ(c.read(device), reference.get(device))
          << "scan " << scan << ", " << device_name(device, program.dialect);
    }
  }
}

}  // namespace rung
