// SPDX-License-Identifier: Apache-2.0
#include "image/flow.hpp"

#include "rung_flow.hpp"

namespace rung::image {

int FlowImage::bits(const FlowBoard& board) {
  return 1 << flow::board_bit_there |
         (board.over_link || board.panel ? 1 : 0) << flow::board_bit_over_link |
         (board.exclusive ? 1 : 0) << flow::board_bit_exclusive |
         (board.panel ? 1 : 0) << flow::board_bit_panel;
}

}  // namespace rung::image
