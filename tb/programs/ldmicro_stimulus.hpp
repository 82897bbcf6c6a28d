// SPDX-License-Identifier: Apache-2.0
// What a random LDmicro program is given in each scan: inputs, presets, samples, received bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "rungs/program.hpp"
#include "trace/stimulus.hpp"

namespace rung {

// The events of `scans` scans for what `program` names: inputs come and go, variables begin with
// corner values or small numbers and are preset now and then, analogue channels drift, and where
// the program receives, bytes arrive, at times two before one is taken. Most programs that have
// PERSIST meet a lasting memory, which LDmicro's simulator does not have.
std::vector<std::vector<StimulusEvent>> ldmicro_stimulus(std::uint64_t seed, const Program& program,
                                                         int scans);

}  // namespace rung
