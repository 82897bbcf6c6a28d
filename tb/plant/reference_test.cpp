// SPDX-License-Identifier: Apache-2.0
// The plants with the reference as their controller: their programs do what they are for, in an
// hour of plant time. What the simulated controller does with them is in plant_test.cpp.
#include "reference/reference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "melsec/melsec.hpp"
#include "plant/plant.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

Program read(const Plant& plant) {
  Diagnostics diagnostics;
  const std::string file = std::string(RUNG_REPOSITORY) + "/" + plant.program();
  const auto bytes = read_bytes(file, diagnostics);
  const auto text = decode_text(bytes.value(), file, diagnostics);
  auto program = parse_melsec(text.value(), Dialect::Fx, diagnostics);
  if (!program) throw std::runtime_error(file + " is refused");
  return std::move(*program);
}

void run(Plant& plant, int period_ms) {
  const Program program = read(plant);
  Reference reference(program, period_ms * 1000);
  const auto device = [](const std::string& name) {
    return parse_device_name(name, Dialect::Fx).value();
  };
  std::vector<Device> inputs, outputs;
  for (const std::string& name : plant.inputs()) inputs.push_back(device(name));
  for (const std::string& name : plant.outputs()) outputs.push_back(device(name));
  std::uint64_t now = 0;
  for (int ms = 0; ms < 3'600'000; ms += period_ms) {
    const std::uint64_t in = plant.step(now, period_ms);
    for (std::size_t i = 0; i < inputs.size(); ++i) reference.set(inputs[i], in >> i & 1);
    reference.run_scan();
    now = 0;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      now |= std::uint64_t{reference.get(outputs[i]) != 0} << i;
    }
    ASSERT_EQ(plant.accident(), "");
  }
  EXPECT_TRUE(plant.busy()) << plant.work();
  fmt::print("{}: {}\n", plant.name(), plant.work());
}

TEST(PlantWithReference, CrossingForAnHour) { run(*make_crossing(1), 10); }
TEST(PlantWithReference, ConveyorForAnHour) { run(*make_conveyor(1), 10); }

}  // namespace
}  // namespace rung::tb
