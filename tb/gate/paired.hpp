// SPDX-License-Identifier: Apache-2.0
// A processor's RTL and its netlist as one model: both get the same inputs, and in every clock
// after a reset their outputs must be equal: all that a user of the chip can see of it, the answers
// of the load port and the words written among them. The retire port is the RTL's, the netlist has
// none; so each test of the RTL is one of the netlist as it stands (tb/harness, tb/wide_rtl).
#pragma once

#include <fmt/format.h>
#include <verilated.h>

#include <cstdint>
#include <stdexcept>

namespace rung::tb {

// Counts, and the fault that models made from now on have (0: none), if they have a port for it.
struct GateState {
  std::uint64_t clocks = 0;   // in which outputs were compared
  std::uint64_t answers = 0;  // of the load port
  std::uint64_t words = 0;    // written
  std::uint8_t fault = 0;
  bool comparing = true;  // load_netlist() begins to
};
inline GateState gate_state;

// Declared behind a machine: while that is taken apart nothing is compared, as a destructor, which
// may write to the processor, has no way to say that something differs.
class QuietEnd {
 public:
  QuietEnd() = default;
  ~QuietEnd() { gate_state.comparing = false; }
  QuietEnd(const QuietEnd&) = delete;
  QuietEnd& operator=(const QuietEnd&) = delete;
};

template <typename Rtl, typename Netlist>
class Paired : public Rtl {
 public:
  explicit Paired(VerilatedContext* context) : Rtl(context, "RTL"), netlist_(context, "NETLIST") {
    if constexpr (requires { netlist_.fault_i; }) netlist_.fault_i = gate_state.fault;
  }

  void eval() {
    netlist_.clk_i = this->clk_i;
    netlist_.rst_ni = this->rst_ni;
    netlist_.start_i = this->start_i;
    netlist_.load_valid_i = this->load_valid_i;
    netlist_.load_write_i = this->load_write_i;
    netlist_.load_space_i = this->load_space_i;
    netlist_.load_addr_i = this->load_addr_i;
    netlist_.load_data_i = this->load_data_i;
    if constexpr (kRange) {
      netlist_.range_i = this->range_i;
      netlist_.entry_i = this->entry_i;
      netlist_.end_i = this->end_i;
    } else {
      netlist_.in_i = this->in_i;
    }
    Rtl::eval();
    netlist_.eval();
    if (this->clk_i == 0 || !gate_state.comparing) return;
    after_reset_ = after_reset_ || this->rst_ni == 0;
    if (after_reset_ && this->rst_ni != 0) compare();
  }

  void final() {
    Rtl::final();
    netlist_.final();
  }

 private:
  // MPU1 to MPU3 run a range of steps and show the words they write; MPU4 takes inputs.
  static constexpr bool kRange = requires(Rtl & rtl) { rtl.range_i; };

  void compare() {
    ++gate_state.clocks;
    equal("busy_o", this->busy_o, netlist_.busy_o);
    equal("done_o", this->done_o, netlist_.done_o);
    equal("error_o", this->error_o, netlist_.error_o);
    equal("load_rvalid_o", this->load_rvalid_o, netlist_.load_rvalid_o);
    if (this->load_rvalid_o != 0) {
      ++gate_state.answers;
      equal("load_rdata_o", this->load_rdata_o, netlist_.load_rdata_o);
    }
    // The counter has no reset: a scan sets it.
    if (this->done_o != 0) equal("clocks_o", this->clocks_o, netlist_.clocks_o);
    if constexpr (kRange) {
      equal("write_valid_o", this->write_valid_o, netlist_.write_valid_o);
      for (int slot = 0; slot < 2; ++slot) {
        if ((this->write_valid_o >> slot & 1) == 0) continue;
        ++gate_state.words;
        const std::uint32_t mask = 0xffffU << 16 * slot;
        equal("write_addr_o", this->write_addr_o & mask, netlist_.write_addr_o & mask);
        equal("write_data_o", this->write_data_o & mask, netlist_.write_data_o & mask);
      }
    }
  }

  void equal(const char* port, std::uint32_t rtl, std::uint32_t netlist) const {
    if (rtl == netlist) return;
    throw std::runtime_error(
        fmt::format("{}: {:#x} from the RTL, {:#x} from the netlist", port, rtl, netlist));
  }

  Netlist netlist_;
  bool after_reset_ = false;
};

}  // namespace rung::tb
