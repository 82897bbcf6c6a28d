// SPDX-License-Identifier: Apache-2.0
// Of the image file the part that images for MPU4 have.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "image/image.hpp"

namespace rung::image {

nlohmann::json wide_to_json(const WideImage& wide);
WideImage wide_from_json(const nlohmann::json& in);

// Throws where image.wide, which is there, does not fit the image or the processor.
void check_wide(const Image& image);

// The listing of an image for MPU4.
std::string wide_listing(const Image& image);

}  // namespace rung::image
