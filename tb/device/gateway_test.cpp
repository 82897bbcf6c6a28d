// SPDX-License-Identifier: Apache-2.0
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "device/tcp_gateway.hpp"
#include "responder.hpp"

namespace rung::device {
namespace {

using Bytes = std::vector<std::uint8_t>;

class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  bool connected() const { return connected_; }
  void send(const Bytes& bytes) const {
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  // What is there; `closed` if nothing will come any more.
  Bytes receive() {
    Bytes bytes(4096);
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got == 0 || (got < 0 && errno != EAGAIN)) closed_ = true;
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  bool closed() const { return closed_; }

 private:
  int socket_;
  bool connected_ = false;
  bool closed_ = false;
};

struct Gateway : testing::Test {
  tb::Responder machine;
  SharedLine line{machine};
  TcpGateway gateway{0, line};

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      gateway.step();
      machine.run(tb::Responder::kClocksPerMs);
      line.step();
    }
    gateway.step();
  }
};

Bytes read_request(std::uint8_t transaction, std::uint8_t unit = 1) {
  return {0, transaction, 0, 0, 0, 6, unit, 3, 0, 0, 0, 1};
}

TEST_F(Gateway, RequestAndException) {
  Client client(gateway.port());
  ASSERT_TRUE(client.connected());
  machine.registers[0] = 0xBEEF;
  client.send(read_request(5));
  run_ms(50);
  EXPECT_EQ(client.receive(), (Bytes{0, 5, 0, 0, 0, 5, 1, 3, 2, 0xBE, 0xEF}));
  client.send({0, 6, 0, 0, 0, 6, 1, 3, 0, 9, 0, 5});
  run_ms(50);
  EXPECT_EQ(client.receive(), (Bytes{0, 6, 0, 0, 0, 3, 1, 0x83, 2}));
}

TEST_F(Gateway, UnitsThatDoNotAnswer) {
  Client client(gateway.port());
  client.send(read_request(1, 7));
  run_ms(1200);
  EXPECT_EQ(client.receive(), (Bytes{0, 1, 0, 0, 0, 3, 7, 0x83, 0x0B}));
  client.send(read_request(2, 248));  // no address of a unit
  run_ms(2);
  EXPECT_EQ(client.receive(), (Bytes{0, 2, 0, 0, 0, 3, 248, 0x83, 0x0A}));
  machine.wrong_crc = true;
  client.send(read_request(3));
  run_ms(50);
  EXPECT_EQ(client.receive(), (Bytes{0, 3, 0, 0, 0, 3, 1, 0x83, 0x0B}));
}

TEST_F(Gateway, BroadcastIsSentAndNotAnswered) {
  Client client(gateway.port());
  client.send({0, 1, 0, 0, 0, 6, 0, 6, 0, 4, 0, 77});
  client.send(read_request(2));
  run_ms(100);
  EXPECT_EQ(machine.registers[4], 77);
  EXPECT_EQ(client.receive(), (Bytes{0, 2, 0, 0, 0, 5, 1, 3, 2, 0, 0}));
}

// Two clients with many requests at once are answered in turn, each with its own.
TEST_F(Gateway, SeveralClients) {
  Client first(gateway.port()), second(gateway.port());
  Bytes many;
  for (std::uint8_t i = 0; i < 10; ++i) {
    const Bytes one = read_request(i);
    many.insert(many.end(), one.begin(), one.end());
  }
  first.send(many);
  second.send(many);
  run_ms(60);
  const Bytes of_first = first.receive(), of_second = second.receive();
  EXPECT_FALSE(of_first.empty());
  EXPECT_FALSE(of_second.empty());
  EXPECT_LT(of_first.size(), 110U);
  run_ms(600);
  const auto whole = [](Bytes all, const Bytes& rest) {
    all.insert(all.end(), rest.begin(), rest.end());
    ASSERT_EQ(all.size(), 110U);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(all[11 * i + 1], i);
  };
  whole(of_first, first.receive());
  whole(of_second, second.receive());
  EXPECT_EQ(machine.bad_frames, 0);
}

TEST_F(Gateway, BadHeaderClosesItsClientOnly) {
  Client bad(gateway.port()), good(gateway.port());
  bad.send({0, 1, 0, 9, 0, 6, 1, 3, 0, 0, 0, 1});
  good.send(read_request(1));
  run_ms(50);
  bad.receive();
  EXPECT_TRUE(bad.closed());
  EXPECT_EQ(good.receive().size(), 11U);
  EXPECT_FALSE(good.closed());
}

// What came before the bad header is answered first.
TEST_F(Gateway, RequestBeforeABadHeader) {
  Client client(gateway.port());
  Bytes bytes = read_request(1);
  bytes.insert(bytes.end(), 12, 0xFF);
  client.send(bytes);
  run_ms(100);
  EXPECT_EQ(client.receive().size(), 11U);
  client.receive();
  EXPECT_TRUE(client.closed());
}

TEST_F(Gateway, ClientThatLeavesBeforeItsAnswer) {
  {
    Client client(gateway.port());
    client.send(read_request(1));
    run_ms(2);
  }
  run_ms(50);
  Client next(gateway.port());
  next.send(read_request(2));
  run_ms(50);
  EXPECT_EQ(next.receive(), (Bytes{0, 2, 0, 0, 0, 5, 1, 3, 2, 0, 0}));
}

TEST_F(Gateway, ClientsAreBounded) {
  std::vector<std::unique_ptr<Client>> clients;
  for (std::size_t i = 0; i < TcpGateway::kClients + 1; ++i) {
    clients.push_back(std::make_unique<Client>(gateway.port()));
    run_ms(1);
  }
  clients.back()->receive();
  EXPECT_TRUE(clients.back()->closed());
  clients.front()->send(read_request(1));
  run_ms(50);
  EXPECT_EQ(clients.front()->receive().size(), 11U);
}

// A client that sends requests without end and takes no answers is bounded too.
TEST_F(Gateway, FloodOfRequests) {
  Client client(gateway.port());
  Bytes many;
  for (int i = 0; i < 400; ++i) {
    const Bytes one = read_request(1);
    many.insert(many.end(), one.begin(), one.end());
  }
  client.send(many);
  Client other(gateway.port());
  other.send(read_request(2));
  run_ms(100);
  EXPECT_EQ(other.receive().size(), 11U);
}

TEST(GatewayPort, TakenIsSaid) {
  tb::Responder machine;
  SharedLine line(machine);
  TcpGateway first(0, line);
  try {
    TcpGateway second(first.port(), line);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("another port"), std::string::npos);
  }
}

}  // namespace
}  // namespace rung::device
