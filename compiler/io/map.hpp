// SPDX-License-Identifier: Apache-2.0
// The I/O map as its file says it: which device or name is which pin, channel or UART of a board,
// and the controller's settings. The format is on README.md beside this.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostics.hpp"

namespace rung::controller {
struct Board;
}

namespace rung::io {

enum class Safe : std::uint8_t { Low, High, Hold };
enum class Parity : std::uint8_t { None, Odd, Even };

// Of programs with flow tasks: the table [flow].
struct FlowSettings {
  int link_timeout_ms = 50;  // of a request to another unit
  int panel_timeout_ms = 500;
  int panel_unit = 1;  // Modbus address of the panel
  int panel_baud = 115200;
  Parity panel_parity = Parity::Even;
  bool suspension = true;  // false: steps wait in their place for their data (flow_setup enable)
};

struct Settings {
  std::int64_t period_us = 0;         // 0: free running
  std::int64_t watchdog_us = 200000;  // 0: none
  int exchange_points = 2000;
  int save_seconds = 60;
  bool stop_on_bad_download = false;
  bool stop_after_power_up = false;
  std::int64_t filter_us = 100;  // from sample to sample of the input filters
  int unit = 1;
  int baud = 19200;
  Parity parity = Parity::Even;
  FlowSettings flow;
};

// Of a line whose pin is refused: its name can be checked still.
inline constexpr int kNoPin = -1;

// A line of the file that binds `name`.
struct Line {
  std::string name;
  SourcePosition position;  // of the name
};
struct InputLine : Line {
  int pin = 0;
  int filter = 0;  // equal samples, 0: not filtered
  bool invert = false;
};
struct OutputLine : Line {
  int pin = 0;
  Safe safe = Safe::Low;
  bool invert = false;
};
struct AnalogLine : Line {
  int channel = 0;
};
struct PwmLine : Line {
  int pin = 0;
  std::int64_t hz = 0;  // 0: not given
};

struct Map {
  std::string file;  // empty: made up, without --io
  const controller::Board* board = nullptr;
  Settings settings;
  bool has_period = false;
  SourcePosition period_position, watchdog_position;
  std::vector<InputLine> inputs;
  std::vector<OutputLine> outputs;
  std::vector<AnalogLine> analog;
  std::vector<PwmLine> pwm;
  // Of the table [flow] and of its `suspend`, where the file has them.
  std::optional<SourcePosition> flow_position, suspend_position;
  std::optional<Line> uart;  // the board's UART that the ladder's is on
  SourcePosition uart_position;
  std::optional<std::vector<Line>> latched;  // "M100-M199", "D5"; nothing: the dialect's own
};

// The board called `name`, or null.
const controller::Board* find_board(std::string_view name);

// Nothing, with an error, when the text is no TOML or names no board; every other error is reported
// and the lines that have none are in the map.
std::optional<Map> parse_map(std::string_view text, const std::string& file,
                             Diagnostics& diagnostics);

}  // namespace rung::io
