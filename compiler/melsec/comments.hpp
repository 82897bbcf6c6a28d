// SPDX-License-Identifier: Apache-2.0
// Device comments, which name the devices in traces, listings and errors.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "rungs/device.hpp"
#include "source/text_file.hpp"

namespace rung {

// Reads a device-comment CSV of GX Works: after a title and headers, rows of device and comment. A
// timer or counter gives its name to its contact and its value. What a program cannot name (devices
// of another controller's range, bits of words, pointers) is passed over. Nothing, with the errors
// in `diagnostics`, when a row is no comment or one device has two.
std::optional<std::map<Device, std::string>> parse_comments(const SourceText& source,
                                                            Dialect dialect,
                                                            Diagnostics& diagnostics);

}  // namespace rung
