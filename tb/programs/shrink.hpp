// SPDX-License-Identifier: Apache-2.0
// Makes a failing program smaller.
#pragma once

#include <functional>
#include <string>

namespace rung {

// The lines of `text` that are left when no run of them can be taken out without `still_fails`
// becoming false. It is false for texts that are no valid programs any more.
std::string shrink(const std::string& text,
                   const std::function<bool(const std::string&)>& still_fails);

// The same for an `.ld` file: rungs, elements and branches are taken out, and a branch takes the
// place of its PARALLEL.
std::string shrink_ldmicro(const std::string& text,
                           const std::function<bool(const std::string&)>& still_fails);

}  // namespace rung
