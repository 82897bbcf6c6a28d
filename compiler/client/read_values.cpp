// SPDX-License-Identifier: Apache-2.0
#include <modbus/modbus.h>

#include <algorithm>
#include <map>

#include "client/controller.hpp"

namespace rung::client {
namespace {

using io::Table;

// Points of no interest that are read along rather than asked for around.
constexpr int kGap = 16;

// One request: points `first` to `last` of an area.
struct Request {
  Table table = Table::Coil;
  int first = 0;
  int last = 0;
};

std::vector<Request> requests_of(const std::vector<Watched>& devices, int exchange_points) {
  std::map<std::pair<Table, int>, int> points;  // and the last address of their area
  for (const Watched& each : devices) {
    points[{each.point.table, each.point.address}] = each.point.last;
    if (each.wide) points[{each.point.table, each.point.address + 1}] = each.point.last;
  }
  std::vector<Request> requests;
  int area = 0;
  for (const auto& [place, last] : points) {
    const auto [table, address] = place;
    const int protocol = table == Table::Holding ? MODBUS_MAX_READ_REGISTERS : MODBUS_MAX_READ_BITS;
    const int most = std::min(protocol, std::max(1, exchange_points));
    if (!requests.empty() && requests.back().table == table && area == last &&
        address - requests.back().last <= kGap && address - requests.back().first < most) {
      requests.back().last = address;
    } else {
      requests.push_back({table, address, address});
    }
    area = last;
  }
  return requests;
}

}  // namespace

std::vector<std::int32_t> read_values(Connection& line, const std::vector<Watched>& devices,
                                      int exchange_points) {
  std::map<std::pair<Table, int>, std::uint16_t> got;
  for (const Request& request : requests_of(devices, exchange_points)) {
    const int count = request.last - request.first + 1;
    if (request.table == Table::Holding) {
      const auto words = line.read_words(request.first, count);
      for (int i = 0; i < count; ++i) {
        got[{request.table, request.first + i}] = words[static_cast<std::size_t>(i)];
      }
    } else {
      const auto bits = line.read_bits(request.first, count, request.table == Table::Discrete);
      for (int i = 0; i < count; ++i) {
        got[{request.table, request.first + i}] = bits[static_cast<std::size_t>(i)] ? 1 : 0;
      }
    }
  }
  std::vector<std::int32_t> values;
  for (const Watched& each : devices) {
    const std::uint16_t low = got.at({each.point.table, each.point.address});
    if (each.wide) {
      const std::uint32_t high = got.at({each.point.table, each.point.address + 1});
      values.push_back(static_cast<std::int32_t>(low | high << 16));
    } else if (each.point.table == Table::Holding) {
      values.push_back(static_cast<std::int16_t>(low));
    } else {
      values.push_back(low);
    }
  }
  return values;
}

}  // namespace rung::client
