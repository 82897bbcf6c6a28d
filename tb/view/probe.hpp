// SPDX-License-Identifier: Apache-2.0
// A signal of a model by its hierarchical name, of those that inside.vlt makes public.
#pragma once

#include <fmt/format.h>
#include <verilated.h>
#include <verilated_syms.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace rung::tb {

class Probe {
 public:
  Probe() = default;
  // "TOP.mpu3.core.fetch", "f1_pc_q"; at most 32 bits.
  Probe(const VerilatedContext& context, const std::string& scope, const char* name) {
    const VerilatedScope* found = context.scopeFind(scope.c_str());
    const VerilatedVar* variable = found != nullptr ? found->varFind(name) : nullptr;
    if (variable == nullptr) {
      throw std::logic_error(fmt::format("{}.{}: the model does not show it", scope, name));
    }
    data_ = variable->datap();
    bytes_ = variable->entSize();
  }

  std::uint32_t value() const {
    switch (bytes_) {
      case 1:
        return *static_cast<const CData*>(data_);
      case 2:
        return *static_cast<const SData*>(data_);
      case 4:
        return *static_cast<const IData*>(data_);
      default:
        return 0;
    }
  }

 private:
  const void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace rung::tb
