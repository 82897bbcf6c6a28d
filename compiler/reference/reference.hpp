// SPDX-License-Identifier: Apache-2.0
// The golden model: executes the instructions of the source one after another, as a plain
// sequential controller does. It knows nothing of the compiler's later steps or of the processors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rungs/program.hpp"

namespace rung {

// One executed write.
struct ReferenceWrite {
  Device device;
  std::int16_t value = 0;       // of a bit: 0 or 1
  std::size_t instruction = 0;  // index into Program::instructions
  bool operator==(const ReferenceWrite&) const = default;
};

// A controller that runs `program`, which must outlive it. All devices are 0 at the start.
class Reference {
 public:
  explicit Reference(const Program& program);

  // Sets an input for the scans to come, or presets any other device. A bit takes 0 or not 0. The
  // device must be in its range of the program's dialect.
  void set(Device device, std::int16_t value);
  std::int16_t get(Device device) const;

  // One scan: all instructions in order.
  void run_scan();

  // The same, one instruction at a time: begin_scan(), then step() until it gives false.
  void begin_scan();
  // Executes the next instruction; false when the scan has none left.
  bool step();
  // Index of the instruction that the next step() executes.
  std::size_t next_instruction() const { return next_; }
  // The current result, which contacts compute and outputs use.
  bool result() const { return result_; }

  // The writes of the scan so far, in the order of execution: OUT always; SET, RST and word
  // instructions when their condition was 1; of MUL and DIV with two words, low word (quotient)
  // then high word (remainder).
  const std::vector<ReferenceWrite>& writes() const { return writes_; }
  // Whether a division by zero was executed in this scan; it wrote nothing.
  bool error() const { return error_; }

 private:
  void execute(const Instruction& instruction);
  void execute_word(const Instruction& instruction);
  std::int16_t value(const WordSource& source) const;
  void load(bool value);
  bool pop_block();
  void write(Device device, std::int16_t value);

  const Program& program_;
  std::array<std::vector<std::int16_t>, 4> devices_;  // by kind
  std::size_t next_ = 0;
  std::size_t network_ = 0;  // the one that next_ is in, or that begins there
  bool result_ = false;
  std::vector<bool> blocks_;  // results that wait for ANB or ORB
  std::vector<bool> branches_;
  std::vector<ReferenceWrite> writes_;
  bool error_ = false;
};

}  // namespace rung
