// SPDX-License-Identifier: Apache-2.0
// Device ports as a controller uses them, beyond what LDmicro's simulator does: a lasting memory
// that is ready at times, values that it holds at the start, bytes that arrive, samples that
// change. The processors leave every port as the reference does.
#include <gtest/gtest.h>

#include "driver/compile.hpp"
#include "ldmicro/ldmicro.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "programs/random_source.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

constexpr int kScans = 2000;

constexpr const char* kProgram = R"(LDmicro0.1
CYCLE=10000
PROGRAM
RUNG
    CONTACTS X0 0
    PERSIST a
END
RUNG
    CONTACTS X1 0
    ADD a a 1
    PERSIST b
    OSR
    ADD b b 7
END
RUNG
    CONTACTS X2 0
    SET_PWM a 100000
END
RUNG
    CONTACTS X3 0
    SET_PWM b 2000
END
RUNG
    CONTACTS X4 0
    UART_RECV c
    COIL Y0 0 0 0
END
RUNG
    CONTACTS X5 0
    PARALLEL
        UART_SEND c
        FORMATTED_STRING b 3 92 45 53
        READ_ADC d
    END
    READ_ADC e
    COIL Y1 0 0 0
END
)";

Program program() {
  Diagnostics diagnostics;
  const auto text = decode_ldmicro(kProgram, "ports.ld", diagnostics);
  auto parsed = text ? parse_ldmicro(*text, diagnostics) : std::nullopt;
  EXPECT_TRUE(parsed);
  return parsed ? std::move(*parsed) : Program{};
}

std::vector<StimulusEvent> events(RandomSource& random, bool first) {
  std::vector<StimulusEvent> all;
  const auto word = [&] { return static_cast<std::int16_t>(random.bits()); };
  if (first) {
    // The lasting memory holds something, and the higher frequency comes first.
    for (int i = 0; i < 2; ++i) all.push_back({port::at(port::persist_value, i), word()});
    all.push_back({{DeviceKind::X, 2}, 1});
    return all;
  }
  for (std::uint32_t input = 0; input < 6; ++input) {
    if (!random.percent(30)) continue;
    all.push_back({{DeviceKind::X, input}, static_cast<std::int16_t>(random.bits() & 1)});
  }
  for (int channel = 0; channel < 2; ++channel) {
    if (random.percent(20)) all.push_back({port::at(port::adc, channel), word()});
  }
  if (random.percent(15)) {
    all.push_back({port::uart_rx_data, static_cast<std::int16_t>(random.bits() & 0xFF)});
  }
  if (random.percent(40)) all.push_back({port::persist_ready, 1});
  return all;
}

class Ports : public testing::TestWithParam<isa::Mpu> {};

// Runs the program; all of the ports must have been used.
void run(const Program& source, AnyMachine& machine) {
  Lockstep lockstep(source, machine);
  RandomSource random(5);
  int kept = 0;
  std::size_t sent = 0;
  for (int scan = 0; scan < kScans; ++scan) {
    auto difference = lockstep.scan(events(random, scan == 0));
    const bool was_ready = machine.peripherals().value(port::persist_ready) != 0;
    if (!difference) difference = lockstep.compare_state();
    ASSERT_FALSE(difference) << describe(*difference);
    kept += was_ready ? 0 : 1;
    sent += machine.sent().size();
  }
  EXPECT_GT(kept, kScans / 10);
  EXPECT_LT(kept, kScans);
  EXPECT_GT(sent, 100U);
  EXPECT_EQ(machine.peripherals().value(port::pwm_hz_high), 1);
}

TEST_P(Ports, AreLeftAsTheReferenceLeavesThem) {
  const Program source = program();
  ASSERT_FALSE(source.instructions.empty());
  for (const isa::Config* config : distinct_configs()) {
    SCOPED_TRACE(config->name);
    CompileOptions options;
    options.mpu = GetParam();
    options.config = config;
    Diagnostics diagnostics;
    const auto compiled = compile(source, options, diagnostics);
    ASSERT_TRUE(compiled);
    const auto processor = make_processor(GetParam(), *config);
    {
      Machine machine(compiled->image, *processor);
      run(source, machine);
      if (HasFatalFailure()) return;
    }
    // The machine has left nothing behind for the next one.
    for (int address = 0; address < config->bit_devices; ++address) {
      ASSERT_FALSE(processor->read_bit(address)) << address;
    }
    for (int address = 0; address < config->word_devices; ++address) {
      ASSERT_EQ(processor->read_word(address), 0) << address;
    }
  }
}

TEST(WidePorts, AreLeftAsTheReferenceLeavesThem) {
  const Program source = program();
  static constexpr std::pair<int, bool> kWays[] = {{4, true}, {8, false}, {16, true}};
  for (const auto& [slots, merge] : kWays) {
    SCOPED_TRACE(testing::Message() << slots << " slots, merge " << merge);
    CompileOptions options;
    options.mpu = isa::Mpu::Mpu4;
    options.slots = slots;
    options.merge = merge;
    Diagnostics diagnostics;
    const auto compiled = compile(source, options, diagnostics);
    ASSERT_TRUE(compiled);
    const LoadedMachine loaded = load_machine(compiled->image);
    run(source, *loaded.machine);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Processors, Ports,
                         testing::Values(isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3),
                         [](const auto& info) {
                           return "Mpu" + std::to_string(static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb
