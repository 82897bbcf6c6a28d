// SPDX-License-Identifier: Apache-2.0
// A random LDmicro program as a case for the engines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "agree/case.hpp"
#include "agree/ldmicro_coverage.hpp"

namespace rung::tb {

// Program number `seed`.
std::string ldmicro_text_of(std::uint64_t seed);

// A program with the stimulus of `seed`; of a case that `text` is a part of, with what its events
// give to the names that are left. Nothing, and why in `messages`, when `text` is refused.
std::optional<Case> make_ldmicro_case(std::uint64_t seed, const std::string& text,
                                      std::string& messages, const Case* original = nullptr);

// What the reference does, counted in `coverage` if there is one.
Behaviour run_ldmicro_reference(const Case& one, LdmicroCoverage* coverage = nullptr);

}  // namespace rung::tb
