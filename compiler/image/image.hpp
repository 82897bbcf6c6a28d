// SPDX-License-Identifier: Apache-2.0
// A compiled program: instruction memory and LUT contents for one processor in one configuration,
// with the names and source lines that traces, listings and errors need.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/program.hpp"
#include "image/flow.hpp"
#include "image/wide.hpp"
#include "isa/isa.hpp"
#include "mapping/mapping.hpp"
#include "rungs/program.hpp"
#include "schedule/schedule.hpp"

namespace rung::image {

// A device that the program names, and where the processor keeps it. An analogue channel is a
// device port with the name of the variable that it is read into.
struct ImageDevice {
  std::string name;  // as traces write it
  Device device;
  int address = 0;           // in bit or word memory
  std::string comment = {};  // the name that a comment file gives it
};

// A word that gets the ticks since the last scan before each scan.
struct ImageTicks {
  int address = 0;
  std::int64_t base_us = 0;
};

// A word that has its value before the first scan and keeps it.
struct ImageConstant {
  int address = 0;
  std::int16_t value = 0;
};

// A source instruction, for listings and messages.
struct SourceLine {
  SourcePosition position;
  std::string text;
};

// Sizes and counts of INTERFACES.md, `compile --json`.
struct Statistics {
  int rungs = 0;
  int instructions = 0;
  int contacts = 0;
  int runs = 0;
  int lookups = 0;
  int lut_rows = 0;
  int bit_devices = 0;  // temporaries included
  int word_devices = 0;
};

struct Image {
  std::string program;  // its file, as the user named it
  std::string dialect;
  isa::Mpu mpu = isa::Mpu::Mpu3;
  bool paper = false;
  std::string config;
  std::vector<std::vector<isa::SlotInstruction>> steps;  // [step][slot]
  std::vector<std::vector<int>> origins;                 // [step][slot]: index into source, or -1
  // [step][slot]: 1 where writing the value that is there already is no write, for traces.
  std::vector<std::vector<std::uint8_t>> quiet;
  std::vector<std::uint8_t> lut;     // function of each row, from row 0
  std::vector<ImageDevice> devices;  // those that the program names, by kind and number
  std::vector<ImageTicks> ticks;
  std::vector<ImageConstant> constants;
  // Device ports from the first up to the highest that the program uses (hdl/isa/ports.toml).
  int port_bits = 0;
  int port_words = 0;
  std::int64_t cycle_us = 0;  // of an LDmicro program: the time from scan to scan
  std::int64_t baud = 0;      // and the speed of its UART
  bool uart = false;          // it has UART instructions
  bool pwm = false;           // it has SET PWM
  bool own_pins = false;      // its IO LIST assigns pins, of a micro-controller
  // Of each PERSIST value the variable, in the order of the lasting memory.
  std::vector<std::string> persist;
  int first_hidden_bit = 0;  // addresses from here are the compiler's own
  int first_hidden_word = 0;
  std::vector<SourceLine> source;  // the instructions of the program
  std::int64_t clocks = 0;         // of one scan, the pipeline's filling included
  Statistics statistics;
  // Of a program with flow tasks: `clocks` are then its ladder's, all else is of the whole.
  std::optional<FlowImage> flow;
  // Of MPU4, in place of steps, origins, quiet and lut.
  std::optional<WideImage> wide;

  // Steps of one scan: what `length` of the load port says.
  std::size_t length() const {
    if (wide) return wide->code.size();
    return flow ? static_cast<std::size_t>(flow->ladder_steps) : steps.size();
  }
};

// MPU1: the core instructions one after the other, each in as many steps as it takes.
Image assemble_mpu1(const Program& source, const core::Program& program, const isa::Config& config);

// MPU2 and MPU3: a schedule with addresses. False, and `image` unchanged, when the program needs
// more than the LUT's rows; mapped without fused look-ups it never does (see order_inputs).
bool assemble_slots(const Program& source, const core::Program& program,
                    const mapping::Mapping& mapping, const schedule::Schedule& schedule,
                    const schedule::Temporaries& temporaries, const isa::Config& config,
                    isa::Mpu mpu, Image& image);

// One instruction as text: with the paper's names for a row of Table 2 when `paper`, e.g.
// "LD OR ANI X0 M0 X1"; else e.g. "LUTO 00110010 X0 X1 M0" with the row's function.
std::string disassemble(const isa::SlotInstruction& instruction, const Image& image);

// The whole program: step, code, instructions, and the source lines they came from.
std::string listing(const Image& image);

}  // namespace rung::image
