// SPDX-License-Identifier: Apache-2.0
#include "agree/c_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "backends/c_writer.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

// Device ports that the main program needs, in the order of its enum.
std::vector<Device> harness_ports() {
  std::vector<Device> ports = {port::uart_rx_full, port::uart_tx_ready, port::uart_rx_data,
                               port::uart_tx_data};
  for (int i = 0; i < port::adc_count; ++i) ports.push_back(port::at(port::adc, i));
  return ports;
}

// The main program behind the translated ones. Its input, in 32-bit numbers: for each program the
// tick and how many scans, for each scan how many events, for each event which device and value.
// Its output, 16 bits each: after each scan the values of all devices, then the byte that was sent,
// or -1. Device ports stand behind the devices. The transmitter is busy in the scan of a byte and
// in the next one; a received byte waits until it is taken or another one comes.
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

enum { RX_FULL, TX_READY, RX_DATA, TX_DATA };

static int next(void) {
  int32_t value = 0;
  return fread(&value, sizeof value, 1, stdin) == 1 ? value : 0;
}

static int value_of(const struct plc_device *device) {
  return device->bit ? *device->bit : device->word ? *device->word : 0;
}

static void set(const struct plc_device *device, int value) {
  if (device->bit) *device->bit = (uint8_t)value;
  if (device->word) *device->word = (int16_t)value;
}

static void run(const struct plc *p) {
  static const struct plc_device *at[20000];
  static int16_t values[20000];
  int tick = next();
  int scans = next();
  int scan, i, busy = 0;
  const struct plc_device *const *port = at + p->count;
  for (i = 0; p->names[i]; i++) {
    for (at[i] = p->table; at[i]->name && strcmp(at[i]->name, p->names[i]) != 0;) at[i]++;
  }
  p->reset();
  if (p->elapsed) p->elapsed((uint32_t)tick);
  for (scan = 0; scan < scans; scan++) {
    int events = next();
    for (; events > 0; events--) {
      int index = next();
      set(at[index], next());
      if (index == p->count + RX_DATA) set(port[RX_FULL], 1);
    }
    set(port[TX_READY], !busy);
    p->cycle();
    for (i = 0; i < p->count; i++) values[i] = (int16_t)value_of(at[i]);
    values[i] = -1;
    if (port[TX_READY]->bit && !busy && !value_of(port[TX_READY])) {
      values[i] = (int16_t)(value_of(port[TX_DATA]) & 255);
      busy = 1;
    } else {
      busy = 0;
    }
    fwrite(values, sizeof values[0], (size_t)p->count + 1, stdout);
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
    const Program& program = cases[i].program;
    for (const Device device : cases[i].devices) {
      text += fmt::format(
          "\"{}\",", is_port(device.kind) ? c_port_name(device) : device_name(device, program));
    }
    for (const Device device : harness_ports()) {
      text += fmt::format("\"{}\",", c_port_name(device));
    }
    text += "0};\n";
  }
  text += "static const struct plc all[] = {\n";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool own_time = cases[i].program.dialect == Dialect::Ldmicro;
    text += fmt::format("{{{0}Reset, {0}Cycle, {3}, {0}Devices, n{1}, {2}}},\n", prefix_of(i), i,
                        cases[i].devices.size(), own_time ? "0" : prefix_of(i) + "Elapsed");
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
    std::size_t number = 0;  // a port may stand among the devices, too
    for (const Device device : one.devices) index.emplace(device, number++);
    for (const Device port : harness_ports()) index.emplace(port, number++);
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
Behaviour behaviour_of(const Case& one, const std::string& output, std::size_t& at) {
  Behaviour behaviour;
  const std::size_t size = (one.devices.size() + 1) * sizeof(std::int16_t);
  for (int scan = 0; scan < one.scans() && at + size <= output.size(); ++scan, at += size) {
    std::vector<std::int16_t>& state = behaviour.states.emplace_back(one.devices.size() + 1);
    std::copy_n(output.data() + at, size, reinterpret_cast<char*>(state.data()));
    std::vector<int>& sent = behaviour.sent.emplace_back();
    if (state.back() >= 0) sent.push_back(state.back());
    state.pop_back();
  }
  return behaviour;
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
  for (const Case& one : cases) run.behaviours.push_back(behaviour_of(one, output, at));
  return run;
}

}  // namespace rung::tb
