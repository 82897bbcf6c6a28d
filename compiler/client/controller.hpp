// SPDX-License-Identifier: Apache-2.0
// A Rung controller at the other end of a Modbus line: its registers (hdl/isa/controller.toml) as
// what they mean.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/connection.hpp"
#include "io/modbus_map.hpp"

namespace rung::client {

struct Identity {
  int interface = 0, board = 0, config = 0, mpu = 0, tables = 0;
};

struct Status {
  int state = 0, fault = 0, flags = 0;
  std::uint32_t scan_count = 0, scan_last = 0, scan_min = 0, scan_max = 0;
  int overruns = 0, exchange_points = 0;
  int frames = 0, bad_frames = 0, bad_bytes = 0, lost_frames = 0, exceptions = 0, saves = 0;
  std::uint32_t generation = 0, length = 0, crc = 0;
  std::vector<std::uint16_t> inputs, outputs;
  int forces = 0;
};

struct Force {
  int address = 0;
  bool value = false;
};

// Names of states, faults, boards and configurations, for people.
std::string_view state_name(int state);
std::string_view fault_name(int fault);
std::string board_name(int board);
std::string config_name(int config);

// Words sent so far, of how many.
using Progress = std::function<void(std::size_t, std::size_t)>;

class Controller {
 public:
  // Connects, and reads who is there; throws ClientError if it is no Rung controller or speaks
  // another version of the map.
  explicit Controller(LineOptions options);

  const Identity& identity() const { return identity_; }
  // Its configuration; "" if this program does not know it.
  std::string config() const { return config_name(identity_.config); }

  Status status();
  // `command` of the table; throws ClientError where it is refused.
  void command(int command);

  void force(int address, bool value);
  void release(int address);
  std::vector<Force> forces();

  // Downloads a load file, lets the controller check and run it, and returns what it then says;
  // throws ClientError, with the old program as it was or the controller stopped, if anything goes
  // wrong. `after`: the line as the new program's I/O map sets it.
  Status download(const std::vector<std::uint16_t>& words, const LineOptions& after,
                  const Progress& progress);
  // The load file that it runs.
  std::vector<std::uint16_t> upload(const Progress& progress);

  Connection& line() { return *line_; }

 private:
  void check_target(const std::vector<std::uint16_t>& words) const;
  void send(const std::vector<std::uint16_t>& words, const Progress& progress);
  int wait_for_load(const LineOptions& after);
  void reopen(const LineOptions& options);
  // Repeats while the unit says that it is busy.
  template <typename Request>
  void patiently(Request&& request);

  std::unique_ptr<Connection> line_;
  Identity identity_;
};

// A device to read: its place, and whether it is two words.
struct Watched {
  io::Point point;
  bool wide = false;
};
// The values, in as few requests as `exchange_points` and the protocol allow.
std::vector<std::int32_t> read_values(Connection& line, const std::vector<Watched>& devices,
                                      int exchange_points);

}  // namespace rung::client
