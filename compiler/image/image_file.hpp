// SPDX-License-Identifier: Apache-2.0
// The image as a file: "RUNGIMG" and a format version byte, the length and the CRC-32 of what
// follows (both 32 bits, little endian), then the image as CBOR.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace rung::image {

// Of an image with flow tasks, and of one without, which a compiler that knows of no flow tasks
// reads too.
inline constexpr std::uint8_t kFlowVersion = 5, kPlainVersion = 4;
// Of an image for MPU4.
inline constexpr std::uint8_t kWideVersion = 6;

// True if `bytes` begin like an image, whole or damaged.
bool is_image(std::string_view bytes);

std::string to_bytes(const Image& image);

// Nothing, with errors at 1:1 of `file`, when the bytes are not a whole image of this version or
// hold what the processor does not have.
std::optional<Image> from_bytes(std::string_view bytes, const std::string& file,
                                Diagnostics& diagnostics);

}  // namespace rung::image
