// SPDX-License-Identifier: Apache-2.0
#include "c_program.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "backends/c_writer.hpp"
#include "reference/reference.hpp"
#include "rungs/devices.hpp"
#include "rungs/ports.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

// As in the names of the access functions.
std::string kind_name(Device device) {
  return device.kind == DeviceKind::CNH ? "CNH" : std::string(kind_letters(device.kind));
}

std::int16_t random_value(Device device, RandomSource& random) {
  if (!is_word(device)) return static_cast<std::int16_t>(random.below(2));
  static constexpr std::int16_t kCorners[] = {0, 1, -1, 2, 9, 100, INT16_MAX, INT16_MIN};
  return random.percent(50) ? kCorners[random.below(std::size(kCorners))]
                            : static_cast<std::int16_t>(random.below(65536) - 32768);
}

bool is_driven_device(Device device, Dialect dialect) {
  const SpecialRange* const special = find_special(device, dialect);
  return special != nullptr && is_driven(special->role);
}

// Something comes from outside: a sample, a byte.
void stir_peripherals(CPeripherals& peripherals, Reference& reference, const Program& program,
                      RandomSource& random) {
  for (const auto& [device, name] : program.names) {
    if (!is_port(device.kind) || !random.percent(30)) continue;
    const int value = random.below(1024);
    peripherals.sample(static_cast<int>(device.number - port::adc.number), value);
    reference.set(device, static_cast<std::int16_t>(value));
  }
  if (program.dialect == Dialect::Ldmicro && random.percent(20)) {
    const int byte = random.below(256);
    peripherals.receive(byte);
    reference.set(port::uart_rx_data, static_cast<std::int16_t>(byte));
  }
}

void expect_equal(const CPrograms& c, std::size_t index, const Program& program, int scans,
                  RandomSource& random, std::uint32_t tick_us) {
  c.reset(index);
  if (program.dialect != Dialect::Ldmicro) c.elapsed(index, tick_us);
  CPeripherals peripherals(c, index);
  Reference reference(program, tick_us);
  const std::vector<Device> devices = named_devices(program);
  for (int scan = 0; scan < scans; ++scan) {
    for (const Device device : devices) {
      const bool input = device.kind == DeviceKind::X;
      if (is_driven_device(device, program.dialect) || !random.percent(input ? 40 : 3)) continue;
      const std::int16_t value = random_value(device, random);
      c.set(index, device_name(device, program), value);
      reference.set(device, value);
    }
    stir_peripherals(peripherals, reference, program, random);
    reference.run_scan();
    ASSERT_EQ(peripherals.cycle(), reference.sent()) << "program " << index << ", scan " << scan;
    ASSERT_EQ(c.error(index), reference.error()) << "program " << index << ", scan " << scan;
    for (const Device device : devices) {
      const std::string name = device_name(device, program);
      ASSERT_EQ(c.get(index, name), reference.get(device))
          << "program " << index << ", scan " << scan << ", " << name;
    }
  }
}

}  // namespace

CPrograms::CPrograms(std::span<const Program> programs) {
  static int number = 0;
  const std::string base = fmt::format("{}/c_program.{}.{}", RUNG_SCRATCH, ::getpid(), number++);
  {
    std::ofstream file(base + ".c");
    for (std::size_t i = 0; i < programs.size(); ++i) {
      file << write_c(programs[i],
                      {.prefix = fmt::format("p{}_", i), .table = true, .hooks = false});
    }
  }
  const std::string command = fmt::format(
      "'{0}' -std=c99 -Wall -Wextra -pedantic -Wmissing-prototypes -Werror -O1 "
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

CPrograms::~CPrograms() {
  if (library_ != nullptr) ::dlclose(library_);
}

void* CPrograms::symbol(std::size_t program, const std::string& name) const {
  void* const found = ::dlsym(library_, fmt::format("p{}_{}", program, name).c_str());
  EXPECT_NE(found, nullptr) << name;
  return found;
}

void CPrograms::reset(std::size_t program) const {
  reinterpret_cast<void (*)()>(symbol(program, "Reset"))();
}

void CPrograms::cycle(std::size_t program) const {
  reinterpret_cast<void (*)()>(symbol(program, "Cycle"))();
}

void CPrograms::elapsed(std::size_t program, std::uint32_t microseconds) const {
  reinterpret_cast<void (*)(std::uint32_t)>(symbol(program, "Elapsed"))(microseconds);
}

bool CPrograms::error(std::size_t program) const {
  return reinterpret_cast<std::uint8_t (*)()>(symbol(program, "Error"))() != 0;
}

long CPrograms::get(std::size_t program, const std::string& device) const {
  return reinterpret_cast<long (*)(const char*)>(symbol(program, "Get"))(device.c_str());
}

bool CPrograms::set(std::size_t program, const std::string& device, long value) const {
  return reinterpret_cast<int (*)(const char*, long)>(symbol(program, "Set"))(device.c_str(),
                                                                              value) != 0;
}

std::int16_t CPrograms::read(std::size_t program, Device device) const {
  void* const function = symbol(program, "Read" + kind_name(device));
  if (is_word(device)) {
    return reinterpret_cast<std::int16_t (*)(std::uint32_t)>(function)(device.number);
  }
  return reinterpret_cast<std::uint8_t (*)(std::uint32_t)>(function)(device.number);
}

void CPrograms::write(std::size_t program, Device device, std::int16_t value) const {
  void* const function = symbol(program, "Write" + kind_name(device));
  if (is_word(device)) {
    reinterpret_cast<void (*)(std::uint32_t, std::int16_t)>(function)(device.number, value);
  } else {
    reinterpret_cast<void (*)(std::uint32_t, std::uint8_t)>(function)(
        device.number, static_cast<std::uint8_t>(value));
  }
}

void CPeripherals::set(Device port, long value) const {
  c_.set(program_, c_port_name(port), value);
}

void CPeripherals::receive(int byte) const {
  set(port::uart_rx_data, byte);
  set(port::uart_rx_full, 1);
}

void CPeripherals::sample(int channel, int value) const {
  set(port::at(port::adc, channel), value);
}

std::vector<int> CPeripherals::cycle() {
  set(port::uart_tx_ready, busy_ ? 0 : 1);
  c_.cycle(program_);
  const auto get = [&](Device port) {
    return static_cast<int>(c_.get(program_, c_port_name(port)));
  };
  // A program that sends nothing has no such port, and it reads 0.
  const bool has_port = c_.set(program_, c_port_name(port::uart_tx_data), get(port::uart_tx_data));
  busy_ = has_port && !busy_ && get(port::uart_tx_ready) == 0;
  return busy_ ? std::vector<int>{get(port::uart_tx_data) & 0xFF} : std::vector<int>{};
}

void expect_c_equals_reference(const Program& program, int scans, RandomSource& random,
                               std::uint32_t tick_us) {
  const std::span programs(&program, 1);
  expect_c_equals_reference(CPrograms(programs), programs, scans, random, tick_us);
}

void expect_c_equals_reference(const CPrograms& c, std::span<const Program> programs, int scans,
                               RandomSource& random, std::uint32_t tick_us) {
  ASSERT_TRUE(c.good());
  for (std::size_t i = 0; i < programs.size() && !testing::Test::HasFailure(); ++i) {
    expect_equal(c, i, programs[i], scans, random, tick_us);
  }
}

}  // namespace rung
