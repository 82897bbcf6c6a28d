// SPDX-License-Identifier: Apache-2.0
// What a client may ask for, as JSON objects with a `do`.
#pragma once

#include <nlohmann/json.hpp>

#include "view/session.hpp"

namespace rung::view {

// {"do":"mode","mode":"paused|real|fast"}   {"do":"step","scans":1}
// {"do":"set","device":3,"value":1}          {"do":"toggle","device":3}
// {"do":"force","device":3,"value":1|null}   {"do":"release"}: all
// {"do":"break","device":3,"on":true,"value":1|null}
// {"do":"restart","engine":"mpu3"}           {"do":"order","order":"run|stop|scan"}: a controller
// Throws std::runtime_error with what people are to be told.
void obey(Run& run, const nlohmann::json& command);

}  // namespace rung::view
