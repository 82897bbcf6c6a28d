// SPDX-License-Identifier: Apache-2.0
#include "device/tcp_gateway.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace rung::device {
namespace {

constexpr std::uint8_t kPathUnavailable = 0x0A;
constexpr std::uint8_t kNoResponse = 0x0B;
constexpr std::uint8_t kHighestUnit = 247;

std::array<std::uint8_t, 2> exception(const MbapRequest& request, std::uint8_t code) {
  return {static_cast<std::uint8_t>(request.pdu[0] | 0x80), code};
}

}  // namespace

TcpGateway::TcpGateway(std::uint16_t port, SharedLine& line) : line_(line) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const place = reinterpret_cast<sockaddr*>(&address);
  if (listener_ < 0 || ::bind(listener_, place, size) != 0 || ::listen(listener_, 8) != 0 ||
      ::getsockname(listener_, place, &size) != 0) {
    const std::string why = std::strerror(errno);
    if (listener_ >= 0) ::close(listener_);
    throw std::runtime_error(
        fmt::format("--tcp {}: {}; another port, or 0 for any free one", port, why));
  }
  port_ = ntohs(address.sin_port);
}

TcpGateway::~TcpGateway() {
  for (const Client& client : clients_) ::close(client.socket);
  ::close(listener_);
}

void TcpGateway::add_to(std::vector<pollfd>& polls) const {
  polls.push_back({listener_, POLLIN, 0});
  for (const Client& client : clients_) {
    if (client.stream.waiting() < kWaiting) polls.push_back({client.socket, POLLIN, 0});
  }
}

void TcpGateway::accept_clients() {
  for (;;) {
    const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0) return;
    if (clients_.size() >= kClients) {
      ::close(socket);
      continue;
    }
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    clients_.push_back({socket, {}, next_id_++});
  }
}

// False: the client is gone.
bool TcpGateway::read(Client& client) const {
  std::array<std::uint8_t, kWaiting> bytes{};
  while (client.stream.waiting() < kWaiting) {
    const std::size_t room = kWaiting - client.stream.waiting();
    const ssize_t got = ::recv(client.socket, bytes.data(), room, 0);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    client.stream.put({bytes.data(), static_cast<std::size_t>(got)});
  }
  return true;
}

void TcpGateway::close(std::size_t index) {
  ::close(clients_[index].socket);
  clients_.erase(clients_.begin() + static_cast<std::ptrdiff_t>(index));
  if (turn_ > index) --turn_;
}

void TcpGateway::reply(std::uint64_t client, const MbapRequest& request,
                       std::span<const std::uint8_t> pdu) {
  const auto found = std::find_if(clients_.begin(), clients_.end(),
                                  [&](const Client& one) { return one.id == client; });
  if (found == clients_.end()) return;  // it did not wait for its answer
  const std::vector<std::uint8_t> bytes = mbap_reply(request, pdu);
  const ssize_t put = ::send(found->socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (put != static_cast<ssize_t>(bytes.size())) {
    close(static_cast<std::size_t>(found - clients_.begin()));
  }
}

void TcpGateway::answer(const SharedLine::Answer& answer) {
  const Pending pending = std::move(*pending_);
  pending_.reset();
  if (pending.request.unit == 0) return;  // a broadcast has no answer
  if (answer.outcome == SharedLine::Outcome::NoTurn) {
    reply(pending.client, pending.request, exception(pending.request, kPathUnavailable));
  } else if (answer.outcome == SharedLine::Outcome::Reply &&
             answer.frame[0] == pending.request.unit &&
             (answer.frame[1] & 0x7F) == pending.request.pdu[0]) {
    reply(pending.client, pending.request, std::span(answer.frame).subspan(1));
  } else {
    reply(pending.client, pending.request, exception(pending.request, kNoResponse));
  }
}

// The next request of the clients in turn: to the line, or answered here.
void TcpGateway::next_request() {
  for (std::size_t tried = clients_.size(); tried > 0 && !pending_; --tried) {
    turn_ %= clients_.size();
    Client& client = clients_[turn_++];
    auto request = client.stream.next();
    if (!request) continue;
    const std::uint64_t id = client.id;
    if (request->unit > kHighestUnit) {
      reply(id, *request, exception(*request, kPathUnavailable));
      return;
    }
    std::vector<std::uint8_t> frame{request->unit};
    frame.insert(frame.end(), request->pdu.begin(), request->pdu.end());
    pending_ = Pending{id, std::move(*request)};
    line_.request(frame);
  }
}

void TcpGateway::step() {
  accept_clients();
  for (std::size_t i = clients_.size(); i-- > 0;) {
    if (!read(clients_[i])) close(i);
  }
  if (pending_) {
    if (const auto end = line_.answer()) answer(*end);
  }
  if (!pending_) next_request();
  // The answers to what came before a broken header have been sent by now or are never asked for.
  for (std::size_t i = clients_.size(); i-- > 0;) {
    const bool busy = pending_ && pending_->client == clients_[i].id;
    if (clients_[i].stream.broken() && !busy) close(i);
  }
}

}  // namespace rung::device
