// SPDX-License-Identifier: Apache-2.0
// The firmware as native code, with RAM of its own: a new one is one after power-up.
#pragma once

#include <memory>

#include "machine.hpp"

namespace rung::tb {

class Native {
 public:
  explicit Native(Machine& machine);
  // Where `other` is, on a copy of its machine.
  Native(const Native& other, Machine& machine);
  ~Native();
  Native(const Native&) = delete;
  Native& operator=(const Native&) = delete;

  void reset();
  void poll();

 private:
  struct Firmware;
  std::unique_ptr<Firmware> firmware_;
};

}  // namespace rung::tb
