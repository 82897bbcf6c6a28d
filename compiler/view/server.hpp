// SPDX-License-Identifier: Apache-2.0
// The web server behind the page: its files, which are part of this program, the program as JSON,
// a stream of what changes, and commands.
#pragma once

#include <memory>
#include <string>

#include "view/session.hpp"

namespace rung::view {

struct ServerSetup {
  std::string address = "127.0.0.1";
  int port = 8310;     // 0: any
  bool fixed = false;  // this port or none; else another one if it is taken
  std::string token;   // that every client must show; empty: none
};

// True for addresses that only programs on this machine can reach.
bool is_loopback(const std::string& address);
// 128 random bits in hexadecimal.
std::string new_token();

class Server {
 public:
  // Binds; throws std::runtime_error if it cannot.
  Server(Session& session, ServerSetup setup);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  // What a browser opens, the token included.
  std::string url() const;
  // Serves until stop(), which another thread or a signal's handler calls.
  void run();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rung::view
