// SPDX-License-Identifier: Apache-2.0
// A controller with its firmware, and a client at its line.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "firmware_config.hpp"
#include "flash.hpp"
#include "load_file.hpp"
#include "machine.hpp"
#include "native.hpp"

namespace rung::tb {

class Bench : public ::testing::Test {
 protected:
  Bench();

  // From power-up, whatever was before
  void power_on(bool run_switch = true);
  void poll(int times = 1);
  // Sends a frame and polls until it is answered; empty: it was not.
  Bytes send(const Bytes& frame);
  // The PDU of a request to `unit_` and of its answer: without the unit, which is checked.
  Bytes ask(const Bytes& pdu);

  Words read(int address, int count = 1);
  int holding(int address) { return read(address).at(0); }
  // 0 or the exception
  int write(int address, const Words& values);
  void command(int value) {
    ASSERT_EQ(write(controller::holding_command, {static_cast<std::uint16_t>(value)}), 0);
  }

  // Downloads as a client does. The load_state it ends with, or the exception negative.
  int download(const Words& file, int commit_crc_error = 0);
  int begin(const Words& file);
  int windows(const Words& file);
  int commit();
  // Gives up the copies and loads this one.
  void install(const Words& file);

  [[nodiscard]] int mark() const {
    return machine_->steps.empty() ? -1 : machine_->steps.begin()->second;
  }

  Flash flash_{1U << 20U};
  std::unique_ptr<Machine> machine_;
  std::unique_ptr<Native> firmware_;
  std::uint8_t unit_ = 1;
  std::uint16_t board_ = 0;
};

// A PDU from its function and words
Bytes pdu(int function, const Words& words);

}  // namespace rung::tb
