// SPDX-License-Identifier: Apache-2.0
// A proof by exhaustion: programs of bits without memories of their own, in every state of their
// devices and with all inputs, against one scan of the reference. The state is all that such a
// program has, so equal here is equal always.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hardwired/bench.hpp"
#include "hardwired/model.hpp"
#include "reference/reference.hpp"

namespace rung::tb {
namespace {

TEST(Hardwired, EveryStateAndInputOfSmallPrograms) {
  const std::vector<Subject> subjects = subjects_of(RUNG_SET);
  const Batch batch(subjects);
  Bench bench(batch, std::make_unique<VerilatedBatch>());
  std::size_t most = 0;
  for (const Subject& subject : subjects) most = std::max(most, subject.what.devices.size());
  ASSERT_LE(most, 12U);
  std::vector<Reference> references;
  for (const Subject& subject : subjects) references.emplace_back(subject.what.program);
  std::uint64_t compared = 0;
  for (std::uint32_t state = 0; state < 1U << most; ++state) {
    std::vector<bool> running;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const auto& devices = subjects[i].what.devices;
      running.push_back(state < 1U << devices.size());
      if (!running[i]) continue;
      for (std::size_t d = 0; d < devices.size(); ++d) {
        const auto value = static_cast<std::int16_t>(state >> d & 1);
        bench.set(i, devices[d], value);
        references[i].set(devices[d], value);
      }
      references[i].run_scan();
    }
    const std::vector<int> clocks = bench.scan(running);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      if (!running[i]) continue;
      ASSERT_EQ(clocks[i], 1) << "a program of bits is one clock";
      for (const Device device : subjects[i].what.devices) {
        ASSERT_EQ(bench.get(i, device), references[i].get(device))
            << subjects[i].name << " from state " << state << ": "
            << device_name(device, subjects[i].what.program);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 50'000U);
}

}  // namespace
}  // namespace rung::tb
