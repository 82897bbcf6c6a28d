// SPDX-License-Identifier: Apache-2.0
// A controller at the other end of a Modbus line, that runs by itself: looked at sample by sample.
#pragma once

#include <memory>

#include "client/connection.hpp"
#include "view/engine.hpp"
#include "view/program_view.hpp"

namespace rung::view {

// Connects; throws client::ClientError. `view` must outlive it. Whether the controller runs this
// program is not asked: what it has at the program's addresses is shown.
std::unique_ptr<Engine> make_board_engine(const ProgramView& view, const client::LineOptions& line);

}  // namespace rung::view
