// SPDX-License-Identifier: Apache-2.0
// What is written for a program, and what is refused.
#include "hardwired/verilog.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "melsec/list.hpp"

namespace rung::hardwired {
namespace {

Program program_of(const std::string& text, Dialect dialect = Dialect::Fx) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, "line.il", diagnostics);
  auto program = parse_list(*source, dialect, diagnostics);
  if (!program) throw std::runtime_error(diagnostics.all().at(0).what);
  return std::move(*program);
}

Module module_of(const std::string& text, double step_ns = kDefaultStepNs) {
  Diagnostics diagnostics;
  Options options;
  options.step_ns = step_ns;
  auto module = to_verilog(program_of(text), options, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return std::move(*module);
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Verilog, BitsAreOneClockHoweverLongTheirPathIs) {
  std::string text;
  for (int i = 0; i < 200; ++i) {
    text += "LD M" + std::to_string(i) + "\nANI X0\nOUT M" + std::to_string(i + 1) + "\n";
  }
  const Module module = module_of(text + "END\n", 1.0);
  EXPECT_EQ(module.clocks, 1);
  EXPECT_EQ(module.holds, 0U);
  EXPECT_EQ(module.text.find("phase_q"), std::string::npos);
}

TEST(Verilog, WordsTakeMoreClocksTheShorterThePathIs) {
  std::string text = "LD X0\n";
  for (int i = 0; i < 12; ++i)
    text += "ADD D" + std::to_string(i) + " K3 D" + std::to_string(i + 1) + "\n";
  text += "END\n";
  const int few = module_of(text, 30).clocks;
  const int some = module_of(text, 8).clocks;
  const int many = module_of(text, 4).clocks;
  EXPECT_LT(few, some);
  EXPECT_LT(some, many);
  EXPECT_EQ(module_of(text, 1000).clocks, 1);
}

TEST(Verilog, MultiplicationsShareAUnit) {
  const Module module = module_of("LD X0\nMUL D0 D1 D2\nMUL D4 D5 D6\nDIV D0 D1 D8\nEND\n");
  EXPECT_EQ(count(module.text, "module rung_program_mul16"), 1);
  EXPECT_EQ(count(module.text, "rung_program_mul16 mul16 ("), 1);
  EXPECT_EQ(count(module.text, "module rung_program_div16"), 1);
  EXPECT_EQ(count(module.text, "mul32"), 0);
  // Two multiplications in the unit one after the other, and a division of eleven clocks.
  EXPECT_GE(module.clocks, 12);
}

TEST(Verilog, PortsAreTheDevices) {
  const Module module = module_of("LD X0\nOR Y1\nANI X3\nOUT Y1\nOUT T0 K5\nMOV D0 D7\nEND\n");
  const Interface& interface = module.interface;
  const std::vector<Device> inputs{{DeviceKind::X, 0}, {DeviceKind::X, 3}};
  EXPECT_EQ(interface.inputs, inputs);
  EXPECT_EQ(interface.outputs, (std::vector<Device>{{DeviceKind::Y, 1}}));
  EXPECT_EQ(interface.ticks, std::vector<std::int64_t>{100'000});
  // X0 X3 Y1 TS0, and the words D0 D7 TN0.
  EXPECT_EQ(interface.state_width, 4 + 3 * 16);
  EXPECT_NE(module.text.find("//             1  X3\n"), std::string::npos);
  EXPECT_NE(module.text.find("output wire [51:0] state_o"), std::string::npos);
}

TEST(Verilog, IndexedOperandsOverVeryManyDevicesAreRefused) {
  std::string text = "LD X0\nMOV K1 D7999\nMOV K1 D0\n";
  for (int i = 0; i < 40; ++i) text += "MOV D0Z0 D1Z1\n";
  const Program program = program_of(text + "END\n");
  Diagnostics diagnostics;
  EXPECT_FALSE(to_verilog(program, {}, diagnostics));
  ASSERT_EQ(diagnostics.error_count(), 1);
  const Diagnostic& error = diagnostics.all()[0];
  EXPECT_NE(error.what.find("input of a multiplexer"), std::string::npos) << error.what;
  EXPECT_GT(error.position.line, 3);
}

TEST(Verilog, NamesOfLdmicroCannotBeTakenForVerilog) {
  Program source = program_of("LD X0\nOUT Y0\nEND\n");
  source.dialect = Dialect::Ldmicro;
  source.names = {{{DeviceKind::X, 0}, "Xreg"},
                  {{DeviceKind::Y, 0}, "Yreg"},
                  {{DeviceKind::M, 0}, "R a"},
                  {{DeviceKind::M, 1}, "R_a"},
                  {{DeviceKind::M, 2}, "r_a"}};
  Names names(source);
  std::vector<std::string> given;
  for (const auto& [device, name] : source.names) given.push_back(names.of(device));
  std::sort(given.begin(), given.end());
  EXPECT_EQ(std::adjacent_find(given.begin(), given.end()), given.end());
  for (const std::string& name : given) {
    EXPECT_TRUE(std::all_of(name.begin(), name.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    })) << name;
  }
}

}  // namespace
}  // namespace rung::hardwired
