// SPDX-License-Identifier: Apache-2.0
// The golden model: executes the instructions of the source one after another, as a plain
// sequential controller does, by compiler/SEMANTICS.md and compiler/LDMICRO.md. It knows nothing of
// the compiler's later steps or of the processors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "rungs/footprint.hpp"
#include "rungs/format_string.hpp"
#include "rungs/program.hpp"
#include "rungs/special.hpp"

namespace rung {

// One executed write.
struct ReferenceWrite {
  Device device;
  std::int16_t value = 0;       // of a bit: 0 or 1
  std::size_t instruction = 0;  // index into Program::instructions
  bool operator==(const ReferenceWrite&) const = default;
};

// What a drawing of the program shows of one instruction in a scan.
struct Conduction {
  bool executed = false;
  bool rail = false;      // it stands where neither master control nor a step takes the power away
  bool conducts = false;  // of a contact: whatever comes in; of anything else: the result behind it
  bool operator==(const Conduction&) const = default;
};

// A controller that runs `program`, which must outlive it, with `tick_us` from scan to scan. All
// devices are 0 at the start.
class Reference {
 public:
  explicit Reference(const Program& program, std::int64_t tick_us = 10000);
  // A second program on the devices of `other`: each sees what the other one writes. What the
  // controller drives is driven by `other` alone. Edges and timers of the two are their own.
  Reference(const Program& program, const Reference& other);
  Reference(Reference&&) = default;
  // A copy would be a second program too.
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;
  ~Reference() = default;

  // Sets an input for the scans to come, or presets any other device. A bit takes 0 or not 0. What
  // the controller drives (M8000, clocks) it drives again before each scan. Of the device ports,
  // port::adc holds the samples; setting port::uart_rx_data means that this byte arrives; and
  // port::persist_ready, which no stimulus sets, makes the lasting memory ready until a program has
  // given it something to keep.
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
  bool result() const { return now_.result; }
  // From the next scan on, keeps in `seen`, which must outlive this, what each instruction did when
  // it was executed last in the scan.
  void watch(std::vector<Conduction>& seen) { seen_ = &seen; }

  // The writes of the scan so far, in the order of execution: OUT always; the other instructions
  // when they were executed; 32 bits as low word, then high word; digit groups as bits, ascending.
  // Timers, counters, flags, error relays and the states that a step leaves: where they change.
  const std::vector<ReferenceWrite>& writes() const { return writes_; }
  // Whether a division by zero was executed in this scan; it wrote nothing.
  bool error() const { return error_; }
  // The bytes that the transmitter was given in this scan.
  const std::vector<int>& sent() const { return sent_; }

 private:
  // A zone of MC.
  struct Master {
    std::int32_t level;
    bool power;
  };
  using Devices = std::array<std::vector<std::int16_t>, kDeviceKinds>;  // as far as written

  // What a routine, the main program or a subroutine, has of its own.
  struct Routine {
    bool result = false;
    std::vector<bool> blocks;  // results that wait for ANB or ORB
    std::vector<bool> branches;
    std::vector<Master> masters;
    std::vector<Device> states;  // those of the STL that the current zone belongs to
    bool state_power = true;     // of that zone
    std::size_t back = 0;        // where its caller goes on
  };
  struct Loop {
    std::size_t begin;  // the instruction after FOR
    std::int32_t left;  // passes, this one included
  };
  // What a timer or counter has beside its contact and value.
  struct Coil {
    bool on = false;
    bool held = false;                // a counter's: its RST is driven
    std::int64_t executed_scan = -1;  // a timer's: of its last OUT
  };

  // LDmicro: the condition where branches part, and what those that have ended make of it.
  struct Fork {
    bool into;
    bool any;
  };
  // A FORMATTED STRING on its way out.
  struct Message {
    std::vector<StringStep> steps;
    std::size_t next = 0;
    std::int16_t left = 0;     // of the number whose digits are being sent
    bool significant = false;  // a digit that is not 0 has been sent
  };

  // Machine: reference.cpp.
  void execute(const Instruction& instruction);
  void execute_seen(const Instruction& instruction);
  void execute_located(const Instruction& instruction);
  bool power() const;
  // The condition of every output instruction.
  bool condition() const { return now_.result && power(); }
  // Whether an instruction that waits for its condition is executed now; of a pulse form that is
  // when the condition goes on. To be asked once each time.
  bool executes(const Instruction& instruction);
  // The last value of `value` that the current instruction saw; takes over the new one.
  bool exchange_memory(bool value);
  void write(Device device, std::int16_t value);
  // The same for what is listed only where it changes.
  void change(Device device, std::int16_t value);

  // Operands: operands.cpp.
  // With the index registers added; nothing if an operand is outside of its window.
  std::optional<Instruction> locate(const Instruction& instruction) const;
  // Of one operand that takes so many devices.
  std::optional<Operand> locate(const Operand& operand, int devices) const;
  bool read_bit(const Operand& operand) const;
  void write_bit(const Operand& operand, bool value);
  std::int32_t read_word(const Operand& operand, int width) const;
  void write_word(const Operand& operand, std::uint64_t value, int width);
  // Sets the error relays that the program names.
  void fail();

  // Contacts, blocks and branches: contacts.cpp.
  void execute_contact(const Instruction& instruction);
  bool contact(const Instruction& instruction);
  bool compare(const Instruction& instruction);
  void execute_block(Op op);
  bool pop_block();

  // Zones, jumps, subroutines and loops: flow.cpp.
  void execute_zone(const Instruction& instruction);
  void begin_state(Device state);
  // A SET or OUT of `state` that may be the transition of a step: true if it was.
  bool transition(const Operand& state);
  void execute_flow(const Instruction& instruction);

  // Outputs on bits: bits.cpp.
  void execute_coil(const Instruction& instruction);
  void execute_bits(const Instruction& instruction);
  void shift_between(const Instruction& instruction, bool up);
  void shift_by_one(const Instruction& instruction, bool up);

  // Timers and counters: timers_counters.cpp.
  void out_timer(const Instruction& instruction);
  void out_counter(const Instruction& instruction);
  void count_16(Device contact, std::int32_t preset);
  void count_32(Device contact, std::int32_t preset);
  void reset(const Instruction& instruction);
  void clear(Device timer_or_counter);
  void reset_range(const Instruction& instruction);

  // Word instructions: words.cpp, arithmetic.cpp.
  void execute_word(const Instruction& instruction);
  void execute_arithmetic(const Instruction& instruction);
  void execute_move(const Instruction& instruction);
  void rotate(const Instruction& instruction);
  void divide(const Instruction& instruction, std::int64_t a, std::int64_t b);
  void set_flags(std::int64_t exact, int width);
  void decimal(const Instruction& instruction);
  void write_relations(const Operand& head, std::array<bool, 3> relations);
  // Sets carry if the program names it.
  void set_carry(bool value);

  // LDmicro's elements: ldmicro.cpp.
  void execute_element(const Instruction& instruction);
  void execute_frame(Op op);
  // A variable, or a literal.
  std::int16_t variable_of(const Operand& operand) const;
  // True when the condition goes on; to be asked once each time.
  bool rises();
  // Timers, counters and shift registers: ldmicro_timers.cpp.
  void execute_timer(const Instruction& instruction);
  void execute_counter(const Instruction& instruction);
  void shift_stages(const Instruction& instruction);
  // Tables: ldmicro_tables.cpp.
  void look_up(const Instruction& instruction);
  void interpolate(const Instruction& instruction);
  // Peripherals: ldmicro_peripherals.cpp.
  void execute_peripheral(const Instruction& instruction);
  void set_pwm(const Instruction& instruction);
  void persist(const Instruction& instruction);
  bool transmitter_free() const;
  void transmit(int byte);
  void send_string(const Instruction& instruction);
  static int next_byte(Message& message, std::int16_t variable);

  const Program& program_;
  std::vector<IndexWindow> windows_;
  // Of these the ones that the program names; the others do not exist for it.
  std::vector<Device> errors_, zero_, borrow_, carry_;
  std::vector<bool> begins_network_;  // by instruction

  std::shared_ptr<Devices> devices_;
  bool drives_ = true;
  std::vector<bool> memory_;  // of edges and pulse forms; of an STL: was it active; by instruction
  std::map<Device, Coil> coils_;  // by contact
  std::set<Device> left_states_;  // that go off when their STL is next reached

  ScanTime time_;
  std::size_t next_ = 0;
  std::size_t current_ = 0;  // the instruction that is being executed
  Routine now_;
  std::vector<Routine> callers_;
  std::vector<Loop> loops_;
  std::vector<ReferenceWrite> writes_;
  bool error_ = false;
  bool closed_ = false;  // the contact that was executed last conducts
  std::vector<Conduction>* seen_ = nullptr;

  // LDmicro.
  bool relay_ = true;                        // of MASTER RELAY
  std::vector<Fork> forks_;                  // the innermost last
  std::map<std::size_t, Message> messages_;  // by instruction
  std::optional<std::int64_t> sent_scan_;    // when the transmitter was given its last byte
  std::vector<int> sent_;
};

}  // namespace rung
