// SPDX-License-Identifier: Apache-2.0
// Every program of tb/golden/programs as byte code against its golden trace: the outputs of every
// scan, and all devices where the trace has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "bytecode/vm_engine.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/melsec.hpp"
#include "rungs/names.hpp"
#include "source/text_file.hpp"
#include "trace/trace.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

std::optional<Program> read_program(const std::string& path, Dialect dialect,
                                    Diagnostics& diagnostics) {
  if (dialect == Dialect::Ldmicro) {
    const auto bytes = read_bytes(path, diagnostics);
    const auto source = bytes ? decode_ldmicro(*bytes, path, diagnostics) : std::nullopt;
    return source ? parse_ldmicro(*source, diagnostics) : std::nullopt;
  }
  const auto source = read_text(path, diagnostics);
  return source ? parse_melsec(*source, dialect, diagnostics) : std::nullopt;
}

void run(const fs::path& golden_path) {
  Diagnostics diagnostics;
  const auto bytes = read_bytes(golden_path.string(), diagnostics);
  ASSERT_TRUE(bytes);
  const auto golden = read_trace(*bytes, golden_path.string(), diagnostics);
  ASSERT_TRUE(golden);
  fs::path source = golden_path;
  for (const char* suffix : {".il", ".csv", ".ld"}) {
    if (fs::exists(source.replace_extension(suffix))) break;
  }
  const auto program =
      read_program(source.string(), *find_dialect(golden->header.dialect), diagnostics);
  ASSERT_TRUE(program);
  const auto stimulus = stimulus_of(*golden, *program, golden_path.string(), diagnostics);
  ASSERT_TRUE(stimulus);

  const DeviceNames names(*program);
  VmEngine engine(*program, golden->header.tick_us);
  std::map<std::string, std::int32_t> outputs;
  for (std::size_t k = 0; k < golden->scans.size(); ++k) {
    engine.apply(stimulus->events(k));
    engine.scan();
    const TraceScan& scan = golden->scans[k];
    for (const TraceValue& value : scan.out) outputs[value.device] = value.value;
    for (const auto& [name, value] : outputs) {
      ASSERT_EQ(engine.value(*names.device(name)), value) << "scan " << k << ": " << name;
    }
    if (!scan.state) continue;
    for (const TraceValue& value : *scan.state) {
      ASSERT_EQ(engine.value(*names.device(value.device)), value.value)
          << "scan " << k << ": " << value.device;
    }
  }
}

TEST(Golden, ByteCode) {
  int ran = 0;
  for (const auto& entry : fs::directory_iterator(RUNG_GOLDEN_PROGRAMS)) {
    if (entry.path().extension() != ".golden") continue;
    SCOPED_TRACE(entry.path().string());
    run(entry.path());
    if (HasFatalFailure()) return;
    ++ran;
  }
  EXPECT_GT(ran, 20);
}

}  // namespace
}  // namespace rung::tb
