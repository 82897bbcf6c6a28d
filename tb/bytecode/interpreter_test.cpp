// SPDX-License-Identifier: Apache-2.0
// The interpreter's interface: devices, names, time, start and peripherals.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bytecode/hand_made.hpp"
#include "bytecode/interpreter/rung_io.h"
#include "bytecode/interpreter/rung_ports.h"
#include "bytecode/listing.hpp"
#include "bytecode/vm_engine.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/list.hpp"
#include "programs/random_source.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

using bytecode::Code;

// rung_ports.h is for users, who have nothing of the compiler; here both can be seen.
static_assert(port::uart_rx_full == Device{DeviceKind::PB, RUNG_PORT_UART_RX_FULL});
static_assert(port::uart_tx_ready == Device{DeviceKind::PB, RUNG_PORT_UART_TX_READY});
static_assert(port::persist_ready == Device{DeviceKind::PB, RUNG_PORT_PERSIST_READY});
static_assert(port::uart_rx_data == Device{DeviceKind::PW, RUNG_PORT_UART_RX_DATA});
static_assert(port::uart_tx_data == Device{DeviceKind::PW, RUNG_PORT_UART_TX_DATA});
static_assert(port::pwm_duty == Device{DeviceKind::PW, RUNG_PORT_PWM_DUTY});
static_assert(port::pwm_hz_low == Device{DeviceKind::PW, RUNG_PORT_PWM_HZ_LOW});
static_assert(port::pwm_hz_high == Device{DeviceKind::PW, RUNG_PORT_PWM_HZ_HIGH});
static_assert(port::persist_index == Device{DeviceKind::PW, RUNG_PORT_PERSIST_INDEX});
static_assert(port::adc == Device{DeviceKind::PW, RUNG_PORT_ADC});
static_assert(port::adc_count == RUNG_PORT_ADC_COUNT);
static_assert(port::persist_value == Device{DeviceKind::PW, RUNG_PORT_PERSIST_VALUE});
static_assert(port::persist_value_count == RUNG_PORT_PERSIST_VALUE_COUNT);

Program list(const std::string& text, Dialect dialect = Dialect::Fx) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, "test.il", diagnostics);
  auto program = parse_list(*source, dialect, diagnostics);
  EXPECT_TRUE(program);
  return std::move(*program);
}

Program ld(const std::string& rungs) {
  Diagnostics diagnostics;
  const std::string text =
      "LDmicro0.1\nCYCLE=10000\nCRYSTAL=4000000\nBAUD=2400\n\nIO LIST\nEND\n\nPROGRAM\n" + rungs;
  const auto source = decode_ldmicro(text, "test.ld", diagnostics);
  auto program = source ? parse_ldmicro(*source, diagnostics) : std::nullopt;
  EXPECT_TRUE(program) << (diagnostics.all().empty() ? "" : diagnostics.all().front().what);
  return std::move(*program);
}

TEST(Interpreter, DevicesByNumberStayWithinTheProgram) {
  HandMade file;
  file.constants = {77};
  file.code = op(Code::END);
  Loaded loaded(file.bytes());
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  rung_vm* vm = &loaded.vm();
  EXPECT_EQ(rung_vm_word(vm, 16), 77);
  rung_vm_set_word(vm, 16, 5);
  EXPECT_EQ(rung_vm_word(vm, 16), 77) << "constants are not written";
  rung_vm_set_word(vm, 15, -5);
  EXPECT_EQ(rung_vm_word(vm, 15), -5);
  rung_vm_set_bit(vm, 7, 200);
  EXPECT_EQ(rung_vm_bit(vm, 7), 1);
  rung_vm_set_bit(vm, 8, 1);
  rung_vm_set_word(vm, 17, 1);
  EXPECT_EQ(rung_vm_bit(vm, 8), 0);
  EXPECT_EQ(rung_vm_word(vm, 17), 0);
  rung_vm_reset(vm);
  EXPECT_EQ(rung_vm_word(vm, 15), 0);
  EXPECT_EQ(rung_vm_word(vm, 16), 77);
  EXPECT_EQ(rung_vm_bit(vm, 7), 0);
}

TEST(Interpreter, ATableIsAWindowOfConstants) {
  HandMade file;
  file.constants = {10, 20, -30};
  file.code = op(Code::LOADW, 0, 16, 3, 1) + op(Code::END);
  Loaded loaded(file.bytes());
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  const int expected[] = {10, 20, -30, 0};
  for (std::int16_t i = 0; i < 4; ++i) {
    rung_vm_set_word(&loaded.vm(), 0, i);
    rung_vm_scan(&loaded.vm(), 0);
    EXPECT_EQ(rung_vm_word(&loaded.vm(), 1), expected[i]) << i;
  }
}

TEST(Interpreter, NamesAreThoseOfTraces) {
  VmEngine engine(list("LD X17\nOUT Y0\nMOV D3 D4\nEND\n"));
  rung_vm_device device = {};
  ASSERT_EQ(rung_vm_find(&engine.vm(), "X17", &device), 1);
  EXPECT_EQ(device.space, RUNG_SPACE_BIT);
  EXPECT_EQ(device.use, RUNG_USE_INPUT);
  ASSERT_EQ(rung_vm_find(&engine.vm(), "Y0", &device), 1);
  EXPECT_EQ(device.use, RUNG_USE_OUTPUT);
  ASSERT_EQ(rung_vm_find(&engine.vm(), "D4", &device), 1);
  EXPECT_EQ(device.space, RUNG_SPACE_WORD);
  EXPECT_EQ(device.use, RUNG_USE_INNER);
  for (const char* const other : {"", "X", "X1", "X170", "x17", "D5"}) {
    EXPECT_EQ(rung_vm_find(&engine.vm(), other, &device), 0) << other;
  }
  std::string all;
  char name[4];
  for (std::uint16_t i = 0; rung_vm_name(&engine.vm(), i, name, sizeof name, &device) != 0; ++i) {
    all += std::string(name) + " ";
  }
  EXPECT_EQ(all, "X17 Y0 D3 D4 ");
  EXPECT_EQ(rung_vm_name(&engine.vm(), 0, name, 3, &device), 1);
  EXPECT_EQ(std::string(name), "X1") << "as far as there is room";
  EXPECT_EQ(rung_vm_name(&engine.vm(), 0, name, 0, &device), 0);
}

TEST(Interpreter, AFileWithoutNamesRunsTheSame) {
  const Program program = list("LD X0\nADD D0 K5 D1\nOUT Y0\nEND\n");
  Loaded loaded(bytecode_of(program, false));
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  EXPECT_EQ(loaded.vm().names_count, 0);
  EXPECT_LT(bytecode_of(program, false).size(), bytecode_of(program).size());
  rung_vm_set_bit(&loaded.vm(), 0, 1);  // X0, Y0; D0, D1: in the order of a trace
  rung_vm_scan(&loaded.vm(), 0);
  EXPECT_EQ(rung_vm_bit(&loaded.vm(), 1), 1);
  EXPECT_EQ(rung_vm_word(&loaded.vm(), 1), 5);
}

// Intervals of any length, against the definition: floor(t / base) and floor(2t / period) mod 2.
TEST(Interpreter, TimeAddsUpWhateverTheIntervals) {
  HandMade file;
  file.ticks = {0, 0, 0x10, 0x27, 0, 0};      // word 0: 10,000 us
  file.driven = {0, 0, 4, 0xA1, 0x86, 1, 0};  // bit 0: a clock of 100,001 us
  file.code = op(Code::END);
  Loaded loaded(file.bytes());
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  RandomSource random(3);
  std::uint64_t now = 0;
  rung_vm_scan(&loaded.vm(), 123456);
  EXPECT_EQ(rung_vm_word(&loaded.vm(), 0), 0) << "no time has passed before the first scan";
  EXPECT_EQ(rung_vm_bit(&loaded.vm(), 0), 0);
  for (int i = 0; i < 5000; ++i) {
    const auto elapsed = static_cast<std::uint32_t>(random.percent(2) ? random.bits() & 0x7FFFFFFF
                                                                      : random.below(60000));
    const std::uint64_t before = now;
    now += elapsed;
    rung_vm_scan(&loaded.vm(), elapsed);
    const std::uint64_t ticks = std::min<std::uint64_t>(now / 10000 - before / 10000, 32767);
    ASSERT_EQ(rung_vm_word(&loaded.vm(), 0), static_cast<int>(ticks)) << i;
    ASSERT_EQ(rung_vm_bit(&loaded.vm(), 0), static_cast<int>(2 * now / 100001 % 2)) << i;
  }
}

TEST(Interpreter, DrivenBitsFollowTheirRole) {
  HandMade file;
  file.driven = {0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0,
                 2, 0, 2, 0, 0, 0, 0, 3, 0, 3, 0, 0, 0, 0};
  file.code = op(Code::END);
  Loaded loaded(file.bytes());
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  rung_vm* vm = &loaded.vm();
  const auto bits = [&] {
    std::string text;
    for (std::uint16_t i = 0; i < 4; ++i) text += rung_vm_bit(vm, i) != 0 ? '1' : '0';
    return text;
  };
  rung_vm_set_bit(vm, 1, 1);
  rung_vm_scan(vm, 0);
  EXPECT_EQ(bits(), "1010");
  rung_vm_scan(vm, 0);
  EXPECT_EQ(bits(), "1001");
  rung_vm_reset(vm);
  rung_vm_scan(vm, 0);
  EXPECT_EQ(bits(), "1010") << "a reset begins again";
}

TEST(Interpreter, TheErrorFlagIsOfTheLastScan) {
  VmEngine engine(list("LD X0\nDIV D0 D1 D2\nEND\n"));
  const Device x0{DeviceKind::X, 0};
  engine.apply(std::vector<StimulusEvent>{{x0, 1}});
  engine.scan();
  EXPECT_TRUE(engine.error());
  engine.apply(std::vector<StimulusEvent>{{x0, 0}});
  engine.scan();
  EXPECT_FALSE(engine.error());
}

// Peripherals as a user would write them.
struct Board {
  bool ready = true;
  std::vector<int> sent;
  std::vector<int> arriving;
  std::int16_t sample = 0;
  std::vector<std::pair<std::uint32_t, int>> pwm;
  bool lasting = false;
  std::int16_t kept = 0;
  int keeps = 0;

  rung_io io() {
    rung_io io = {};
    io.user = this;
    io.uart_ready = [](void* user) { return of(user).ready ? 1 : 0; };
    io.uart_send = [](void* user, std::uint8_t byte) { of(user).sent.push_back(byte); };
    io.uart_receive = [](void* user) {
      if (of(user).arriving.empty()) return -1;
      const int byte = of(user).arriving.front();
      of(user).arriving.erase(of(user).arriving.begin());
      return byte;
    };
    io.adc = [](void* user, std::uint8_t channel) {
      return static_cast<std::int16_t>(of(user).sample + channel);
    };
    io.pwm = [](void* user, std::uint32_t hz, std::int16_t duty) {
      of(user).pwm.emplace_back(hz, duty);
    };
    io.persist_ready = [](void* user) { return of(user).lasting ? 1 : 0; };
    io.persist_value = [](void* user, std::uint8_t) { return of(user).kept; };
    io.persist_keep = [](void* user, std::uint8_t, std::int16_t value) {
      of(user).kept = value;
      ++of(user).keeps;
    };
    return io;
  }
  static Board& of(void* user) { return *static_cast<Board*>(user); }
};

class Peripherals : public testing::Test {
 protected:
  void load(const std::string& rungs) {
    loaded_ = std::make_unique<Loaded>(bytecode_of(ld(rungs)));
    ASSERT_EQ(loaded_->error(), RUNG_VM_OK);
  }
  void scan() {
    const rung_io io = board_.io();
    rung_io_scan(&io, &loaded_->vm(), 10000);
  }
  int value(const char* name) {
    rung_vm_device device = {};
    EXPECT_EQ(rung_vm_find(&loaded_->vm(), name, &device), 1) << name;
    return rung_vm_value(&loaded_->vm(), device);
  }
  void set(const char* name, int value) {
    rung_vm_device device = {};
    EXPECT_EQ(rung_vm_find(&loaded_->vm(), name, &device), 1) << name;
    rung_vm_set_value(&loaded_->vm(), device, static_cast<std::int16_t>(value));
  }

  Board board_;
  std::unique_ptr<Loaded> loaded_;
};

TEST_F(Peripherals, AByteWaitsForTheTransmitter) {
  load("RUNG\n  UART_SEND c\nEND\n");
  set("c", 0x141);
  board_.ready = false;
  scan();
  EXPECT_TRUE(board_.sent.empty());
  board_.ready = true;
  scan();
  scan();
  EXPECT_EQ(board_.sent, (std::vector<int>{0x41, 0x41}));
}

TEST_F(Peripherals, AReceivedByteWaitsForTheProgram) {
  load("RUNG\n  CONTACTS Xtake 0\n  UART_RECV c\n  COIL Ygot 0 0 0\nEND\n");
  board_.arriving = {7, 8};
  scan();
  scan();
  EXPECT_EQ(board_.arriving.size(), 1U) << "the second is not asked for while the first waits";
  EXPECT_EQ(value("c"), 0);
  set("Xtake", 1);
  scan();
  EXPECT_EQ(value("c"), 7);
  EXPECT_EQ(value("Ygot"), 1);
  scan();
  EXPECT_EQ(value("c"), 8);
  scan();
  EXPECT_EQ(value("Ygot"), 0);
}

TEST_F(Peripherals, SamplesAndPwm) {
  load("RUNG\n  READ_ADC a\nEND\nRUNG\n  CONTACTS Xon 0\n  SET_PWM a 70000\nEND\n");
  board_.sample = 42;
  scan();
  EXPECT_EQ(value("a"), 42);
  EXPECT_TRUE(board_.pwm.empty()) << "off until the first SET_PWM";
  set("Xon", 1);
  scan();
  ASSERT_EQ(board_.pwm.size(), 1U);
  EXPECT_EQ(board_.pwm[0], (std::pair<std::uint32_t, int>(70000, 42)));
}

TEST_F(Peripherals, LastingMemoryIsReadOnceAndWrittenWhenTheValueChanges) {
  load("RUNG\n  PERSIST p\nEND\n");
  board_.kept = 300;
  scan();
  EXPECT_EQ(value("p"), 0) << "it is not ready";
  board_.lasting = true;
  scan();
  EXPECT_EQ(value("p"), 300);
  EXPECT_EQ(board_.keeps, 0);
  set("p", 301);
  scan();
  EXPECT_EQ(board_.kept, 301);
  scan();
  EXPECT_EQ(board_.keeps, 1);
}

TEST_F(Peripherals, NoneAreNeeded) {
  load(
      "RUNG\n  UART_RECV c\n  UART_SEND c\nEND\nRUNG\n  READ_ADC a\n  SET_PWM a 1000\n  PERSIST "
      "a\nEND\n");
  const rung_io none = {};
  rung_io_scan(&none, &loaded_->vm(), 10000);
  EXPECT_EQ(value("a"), 0);
}

TEST(Listing, NamesDevicesConstantsTicksAndPorts) {
  const std::string timer = bytecode::listing(bytecode_of(list("LD X0\nOUT T0 K5\nEND\n")));
  EXPECT_EQ(timer.find("; byte code 1.0: "), 0U);
  for (const char* const part : {"LD X0\n", "TN0", " K5 ", "ticks of 100000 us", "IF +", "END\n"}) {
    EXPECT_NE(timer.find(part), std::string::npos) << part << "\n" << timer;
  }
  const std::string sends = bytecode::listing(bytecode_of(ld("RUNG\n  UART_SEND c\nEND\n")));
  for (const char* const part : {"uart_tx_ready", "MOV c uart_tx_data", "scan period 10000 us"}) {
    EXPECT_NE(sends.find(part), std::string::npos) << part << "\n" << sends;
  }
}

// Nothing is pushed that nobody pops, and a guard stands before what the result decides about.
TEST(Code, IsAsShortAsItCanBe) {
  const auto code = [](const std::string& text) {
    std::string lines = bytecode::listing(bytecode_of(list(text)));
    std::string found;
    for (std::size_t at = lines.find('\n') + 1; at < lines.size();) {
      const std::size_t end = lines.find('\n', at);
      found += lines.substr(at + 8, end - at - 8) + ";";
      at = end + 1;
    }
    return found;
  };
  EXPECT_EQ(code("LD X0\nOUT Y0\nLD X1\nAND X2\nLD X3\nAND X4\nORB\nOUT Y1\nEND\n"),
            "LD X0;OUT Y0;LD X1;AND X2;BLD X3;AND X4;ORB;OUT Y1;END;");
  EXPECT_EQ(code("LD X0\nSET Y0\nLD X1\nMOV K5 D0\nADD D0 D1 D2\nSET Y1\nEND\n"),
            "LD X0;SET Y0;LD X1;IF +9;MOV K5 D0;ADD D0 D1 D2;ON Y1;END;");
  EXPECT_EQ(code("LD M8000\nMOV K5 D0\nEND\n"), "LD M8000;MOV K5 D0;END;");
}

}  // namespace
}  // namespace rung::tb
