// SPDX-License-Identifier: Apache-2.0
// The proof of an image for MPU4: what each device holds at the end of a scan and, of a program
// compiled without merging, the sequence of its values (compiler/values/MERGING.md).
#pragma once

#include "prove/prove.hpp"

namespace rung::prove {

// Into `proof`, but for the time that it took.
void prove_wide(const image::Image& image, const image::Meaning& meaning,
                const ProofOptions& options, Proof& proof);

}  // namespace rung::prove
