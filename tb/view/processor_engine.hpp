// SPDX-License-Identifier: Apache-2.0
// A Verilated processor as `rung view` runs it, with the reference beside it: values are the
// processor's, power in the rungs is the reference's, and a difference between the two ends the
// run.
#pragma once

#include <memory>

#include "image/image.hpp"
#include "view/engine.hpp"

namespace rung::tb {

// `program` is what `image` was compiled from, and must outlive it.
std::unique_ptr<view::Engine> make_processor_engine(const Program& program, image::Image image,
                                                    std::int64_t tick_us);

}  // namespace rung::tb
