// SPDX-License-Identifier: Apache-2.0
// All passes from a program of flow tasks to one image of many routines: the ladder's from step 0
// of the instruction memory on, behind it each flow step's, entered and left by the task hardware.
//
// Addresses and LUT rows are common to all. Each routine runs from its first step to its last with
// none between, so that the steps share their hidden devices, which lie behind the ladder's: what
// lowering gives a step must not remember anything, and that is checked. The words and bits of
// flowchart.hpp are common to all routines.
#pragma once

#include <optional>

#include "driver/compile.hpp"
#include "flowchart/flowchart.hpp"

namespace rung {

// Nothing, with errors, when the program does not fit the configuration or the task hardware. Every
// pass is verified; throws std::logic_error if one of them has failed, or for a flowchart that no
// front end may make: one whose indices lead nowhere, or with a step that remembers. The schedule's
// report is the ladder's.
std::optional<Compiled> compile_flow(const flowchart::Flowchart& chart,
                                     const CompileOptions& options, Diagnostics& diagnostics);

}  // namespace rung
