// SPDX-License-Identifier: Apache-2.0
// Every program of tb/golden/programs against its golden trace, on every engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "driver/compile.hpp"
#include "ldmicro/ldmicro.hpp"
#include "lockstep/any_machine.hpp"
#include "melsec/melsec.hpp"
#include "melsec/paper.hpp"
#include "reference/run.hpp"
#include "trace/compare.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(RUNG_GOLDEN_PROGRAMS)) {
    if (entry.path().extension() == ".golden") found.push_back(entry.path().stem().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Golden : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const fs::path path = fs::path(RUNG_GOLDEN_PROGRAMS) / GetParam();
    Diagnostics diagnostics;
    const auto bytes = read_bytes(path.string() + ".golden", diagnostics);
    ASSERT_TRUE(bytes);
    auto golden = read_trace(*bytes, GetParam(), diagnostics);
    ASSERT_TRUE(golden);
    golden_ = std::move(*golden);
    dialect_ = find_dialect(golden_.header.dialect).value_or(Dialect::Fx);
    // The program stands beside it, as a list, as an export or as LDmicro writes it.
    for (const char* suffix : {".il", ".csv", ".ld"}) {
      if (fs::exists(path.string() + suffix)) source_ = path.string() + suffix;
    }
    auto program = read_program(diagnostics);
    ASSERT_TRUE(program);
    program_ = std::move(*program);
    auto stimulus = stimulus_of(golden_, program_, GetParam(), diagnostics);
    ASSERT_TRUE(stimulus);
    stimulus_ = std::move(*stimulus);
  }

  std::optional<Program> read_program(Diagnostics& diagnostics) const {
    const auto bytes = read_bytes(source_, diagnostics);
    if (!bytes) return std::nullopt;
    const bool ld = dialect_ == Dialect::Ldmicro;
    const auto text = ld ? decode_ldmicro(*bytes, source_, diagnostics)
                         : decode_text(*bytes, source_, diagnostics);
    if (!text) return std::nullopt;
    return ld ? parse_ldmicro(*text, diagnostics) : parse_melsec(*text, dialect_, diagnostics);
  }

  void run(isa::Mpu mpu, bool paper, const isa::Config& config) {
    SCOPED_TRACE(testing::Message()
                 << "MPU" << static_cast<int>(mpu) << (paper ? " --paper " : " ") << config.name
                 << "; replay: build/bin/rung check " << source_ << " --golden tb/golden/programs/"
                 << GetParam() << ".golden --mpu " << static_cast<int>(mpu) << " --config "
                 << config.name << (paper ? " --paper" : ""));
    CompileOptions options;
    options.mpu = mpu;
    options.paper = paper;
    options.config = &config;
    Diagnostics diagnostics;
    const auto compiled = compile(program_, options, diagnostics);
    if (!compiled) {
      // Only what the configuration is too small for.
      EXPECT_GT(program_.instructions.size(), 40U);
      return;
    }
    run(compiled->image);
  }

  // By the values after each scan, or by every write.
  void run_wide(int slots, bool merge) {
    SCOPED_TRACE(testing::Message()
                 << "MPU4, " << slots << " slots; replay: build/bin/rung check " << source_
                 << " --golden tb/golden/programs/" << GetParam() << ".golden --mpu 4 --slots "
                 << slots << (merge ? "" : " --no-merge"));
    CompileOptions options;
    options.mpu = isa::Mpu::Mpu4;
    options.slots = slots;
    options.merge = merge;
    options.search.tries = 4;
    Diagnostics diagnostics;
    const auto compiled = compile(program_, options, diagnostics);
    ASSERT_TRUE(compiled) << diagnostics.all().front().what;
    run(compiled->image);
  }

  void run(const image::Image& image) {
    const LoadedMachine loaded = load_machine(image, golden_.header.tick_us);
    MachineRun engine(*loaded.machine, true);
    TraceComparison comparison(false, engine.header().merged);
    for (std::size_t k = 0; k < golden_.scans.size(); ++k) {
      const TraceScan got = engine.scan(stimulus_.events(k));
      const auto difference = comparison.next(golden_.scans[k], got);
      ASSERT_FALSE(difference) << describe(*difference);
      ASSERT_EQ(got.clocks, image.clocks) << "scan " << k;
    }
    ++ran_;
  }

  Dialect dialect_ = Dialect::Fx;
  std::string source_;
  Trace golden_;
  Program program_;
  Stimulus stimulus_;
  int ran_ = 0;
};

TEST_P(Golden, Reference) {
  ReferenceRun engine(program_, true, golden_.header.tick_us);
  TraceComparison comparison(false);
  for (std::size_t k = 0; k < golden_.scans.size(); ++k) {
    const auto difference = comparison.next(golden_.scans[k], engine.scan(stimulus_.events(k)));
    ASSERT_FALSE(difference) << describe(*difference);
  }
  EXPECT_GE(golden_.scans.size(), 5U);
}

TEST_P(Golden, Processors) {
  Diagnostics diagnostics;
  const bool table4 = dialect_ == Dialect::Paper && check_paper(program_, diagnostics);
  for (const isa::Config* config : distinct_configs()) {
    for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
      run(mpu, false, *config);
      if (table4) run(mpu, true, *config);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GE(ran_, 3) << "every program fits the largest configuration";
}

TEST_P(Golden, WideProcessor) {
  for (const int slots : {4, 8, 16}) {
    for (const bool merge : {true, false}) {
      run_wide(slots, merge);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_EQ(ran_, 6);
}

INSTANTIATE_TEST_SUITE_P(Programs, Golden, testing::ValuesIn(names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace rung::tb
