// SPDX-License-Identifier: Apache-2.0
#include "agree/c_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "backends/c_writer.hpp"

namespace rung::tb {
namespace {

// The main program behind the translated ones. Its input, in 32-bit numbers: for each program the
// tick and how many scans, for each scan how many events, for each event which device and value.
// Its output: the values of all devices after each scan, 16 bits each.
constexpr const char* kMain = R"(
#include <stdio.h>
#include <string.h>

struct plc {
  void (*reset)(void);
  void (*cycle)(void);
  void (*elapsed)(uint32_t);
  const struct plc_device *table;
  const char *const *names;
  int count;
};

static int next(void) {
  int32_t value = 0;
  return fread(&value, sizeof value, 1, stdin) == 1 ? value : 0;
}

static void run(const struct plc *p) {
  static const struct plc_device *at[20000];
  static int16_t values[20000];
  int tick = next();
  int scans = next();
  int scan, i;
  for (i = 0; i < p->count; i++) {
    for (at[i] = p->table; at[i]->name && strcmp(at[i]->name, p->names[i]) != 0;) at[i]++;
  }
  p->reset();
  p->elapsed((uint32_t)tick);
  for (scan = 0; scan < scans; scan++) {
    int events = next();
    for (; events > 0; events--) {
      const struct plc_device *device = at[next()];
      int value = next();
      if (device->bit) *device->bit = (uint8_t)value;
      if (device->word) *device->word = (int16_t)value;
    }
    p->cycle();
    for (i = 0; i < p->count; i++) {
      values[i] = (int16_t)(at[i]->bit ? *at[i]->bit : at[i]->word ? *at[i]->word : 0);
    }
    fwrite(values, sizeof values[0], (size_t)p->count, stdout);
  }
  fflush(stdout);
}
)";

std::string prefix_of(std::size_t i) { return fmt::format("p{}_", i); }

std::string source_of(std::span<const Case> cases) {
  std::string text;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    COptions options;
    options.prefix = prefix_of(i);
    options.bare = true;
    text += write_c(cases[i].program, options);
  }
  text += kMain;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    text += fmt::format("static const char *const n{}[] = {{", i);
    for (const Device device : cases[i].devices) {
      text += fmt::format("\"{}\",", device_name(device, cases[i].program.dialect));
    }
    text += "0};\n";
  }
  text += "static const struct plc all[] = {\n";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    text += fmt::format("{{{0}Reset, {0}Cycle, {0}Elapsed, {0}Devices, n{1}, {2}}},\n",
                        prefix_of(i), i, cases[i].devices.size());
  }
  text += fmt::format(
      "}};\nint main(void) {{\n  int i;\n  for (i = 0; i < {}; i++) run(&all[i]);\n  return "
      "0;\n}}\n",
      cases.size());
  return text;
}

std::string input_of(std::span<const Case> cases) {
  std::string bytes;
  const auto add = [&](std::int64_t value) {
    const auto number = static_cast<std::int32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  for (const Case& one : cases) {
    std::map<Device, std::size_t> index;
    for (std::size_t i = 0; i < one.devices.size(); ++i) index[one.devices[i]] = i;
    add(one.tick_us);
    add(one.scans());
    for (const auto& events : one.events) {
      add(static_cast<std::int64_t>(events.size()));
      for (const StimulusEvent& event : events) {
        add(static_cast<std::int64_t>(index.at(event.device)));
        add(event.value);
      }
    }
  }
  return bytes;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// As many whole scans as `output` holds from `at` on.
States states_of(const Case& one, const std::string& output, std::size_t& at) {
  States states;
  const std::size_t size = one.devices.size() * sizeof(std::int16_t);
  for (int scan = 0; scan < one.scans() && at + size <= output.size(); ++scan, at += size) {
    std::vector<std::int16_t>& state = states.emplace_back(one.devices.size());
    std::copy_n(output.data() + at, size, reinterpret_cast<char*>(state.data()));
  }
  return states;
}

}  // namespace

CRun run_as_c(std::span<const Case> cases, CCompiler compiler, const std::string& folder,
              const std::string& name) {
  const std::string base = folder + "/" + name;
  write(base + ".c", source_of(cases));
  write(base + ".in", input_of(cases));
  CRun run;
  const bool fast = compiler == CCompiler::Fast && *RUNG_FAST_C_COMPILER != '\0';
  const std::string command =
      fast ? RUNG_FAST_C_COMPILER " -w"
           : RUNG_C_COMPILER
          " -O0 -std=c99 -Wall -Wextra -pedantic -Werror -fsanitize=undefined "
          "-fsanitize-undefined-trap-on-error";
  if (std::system(fmt::format("{0} {1}.c -o {1} >{1}.log 2>&1", command, base).c_str()) != 0) {
    run.failure = read(base + ".log").substr(0, 4000);
    return run;
  }
  if (std::system(fmt::format("{0} <{0}.in >{0}.out", base).c_str()) != 0) {
    run.failure = fmt::format("{} ended early\n", base);
  }
  const std::string output = read(base + ".out");
  std::size_t at = 0;
  for (const Case& one : cases) run.states.push_back(states_of(one, output, at));
  return run;
}

}  // namespace rung::tb
