// SPDX-License-Identifier: Apache-2.0
// What the page is told, as JSON: once what is looked at, then what has changed.
#pragma once

#include <nlohmann/json.hpp>

#include "view/session.hpp"

namespace rung::view {

// Rungs, devices and tasks, as page/program.js reads them.
nlohmann::json model_json(Run& run);

// What has changed since version `since` of run `runs`; with 0 everything.
struct FrameState {
  std::uint64_t runs = 0;
  std::uint64_t version = 0;
};
// Nothing if nothing has changed; else `state` is brought up to date.
std::optional<nlohmann::json> frame_json(Run& run, FrameState& state);

// Of an engine that records: its processors' code, and the clocks of the last scan.
nlohmann::json code_json(const Run& run);
nlohmann::json recording_json(const Run& run);

}  // namespace rung::view
