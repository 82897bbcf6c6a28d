// SPDX-License-Identifier: Apache-2.0
// Whether the controller's clock can make what a program asks of its peripherals.
#pragma once

#include "isa/isa.hpp"
#include "rungs/program.hpp"
#include "source/diagnostics.hpp"

namespace rung {

// Of a program that uses the UART the baud rate, of each SET_PWM the frequency: an error where the
// clock of the configuration cannot make it at all, a warning where it comes out wrong by more than
// 2 % or, of PWM, with steps of more than 1 %. Names what it would be.
void check_peripherals(const Program& program, const isa::Config& config, Diagnostics& diagnostics);

}  // namespace rung
