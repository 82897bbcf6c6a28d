// SPDX-License-Identifier: Apache-2.0
// The three processors side by side, each beside the reference, and what each of them holds in
// every clock of the last scan.
#pragma once

#include <memory>
#include <vector>

#include "image/image.hpp"
#include "view/engine.hpp"

namespace rung::tb {

// One image a processor, MPU1 first, in configuration kInsideConfig; made of `program`, which must
// outlive this.
inline constexpr const char* kInsideConfig = "ecp5";
std::unique_ptr<view::Engine> make_inside_engine(const Program& program,
                                                 std::vector<image::Image> images,
                                                 std::int64_t tick_us);

}  // namespace rung::tb
