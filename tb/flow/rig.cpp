// SPDX-License-Identifier: Apache-2.0
#include "flow/rig.hpp"

#include <Vflow_mpu2.h>
#include <Vflow_mpu3.h>

#include "flow/verilated_rig.hpp"

namespace rung::tb::flow {

std::shared_ptr<Rig> make_rig(isa::Mpu mpu) {
  static std::shared_ptr<Rig> mpu2 = std::make_shared<VerilatedRig<Vflow_mpu2, isa::Mpu::Mpu2>>();
  static std::shared_ptr<Rig> mpu3 = std::make_shared<VerilatedRig<Vflow_mpu3, isa::Mpu::Mpu3>>();
  const std::shared_ptr<Rig>& rig = mpu == isa::Mpu::Mpu2 ? mpu2 : mpu3;
  rig->reset();
  rig->answer = nullptr;
  rig->takes_replies = true;
  return rig;
}

}  // namespace rung::tb::flow
