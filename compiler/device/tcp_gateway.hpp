// SPDX-License-Identifier: Apache-2.0
// Modbus TCP on loopback to the RTU line.
#pragma once

#include <poll.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "device/mbap.hpp"
#include "device/shared_line.hpp"

namespace rung::device {

// Requests go to the line one at a time, the clients in turn. A client with more than kWaiting
// bytes of requests is not read until some are answered; one with a header that is not Modbus TCP
// is closed; one more than kClients is closed at once, and so is one that does not take its
// answers.
class TcpGateway {
 public:
  static constexpr std::size_t kClients = 16;
  static constexpr std::size_t kWaiting = 1024;

  // Port 0: any free one. Throws std::runtime_error.
  TcpGateway(std::uint16_t port, SharedLine& line);
  ~TcpGateway();
  TcpGateway(const TcpGateway&) = delete;
  TcpGateway& operator=(const TcpGateway&) = delete;

  std::uint16_t port() const { return port_; }
  // Never waits.
  void step();
  // What to wait for.
  void add_to(std::vector<pollfd>& polls) const;

 private:
  struct Client {
    int socket;
    MbapStream stream;
    std::uint64_t id;
  };
  struct Pending {
    std::uint64_t client;
    MbapRequest request;
  };

  void accept_clients();
  bool read(Client& client) const;
  void next_request();
  void answer(const SharedLine::Answer& answer);
  void reply(std::uint64_t client, const MbapRequest& request, std::span<const std::uint8_t> pdu);
  void close(std::size_t index);

  SharedLine& line_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::vector<Client> clients_;
  std::size_t turn_ = 0;
  std::uint64_t next_id_ = 0;
  std::optional<Pending> pending_;
};

}  // namespace rung::device
