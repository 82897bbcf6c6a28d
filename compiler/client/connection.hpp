// SPDX-License-Identifier: Apache-2.0
// A Modbus line to one unit, RTU on a serial port or TCP, through libmodbus.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

struct _modbus;

namespace rung::client {

struct LineOptions {
  std::string port;  // /dev/ttyUSB0, or tcp:HOST:PORT
  int baud = 19200;
  char parity = 'E';  // N, O, E
  int unit = 1;
  int timeout_ms = 1000;
  int flash_timeout_ms = 5000;  // at least, while a download erases and writes the flash
};

// What went wrong on the line or with what was asked, and what to do about it.
struct ClientError : std::runtime_error {
  ClientError(const std::string& what, std::string remedy)
      : std::runtime_error(what), mend(std::move(remedy)) {}
  std::string mend;
};
// No answer came in time.
struct TimeoutError : ClientError {
  using ClientError::ClientError;
};
// The unit answered with an exception.
struct ExceptionError : ClientError {
  ExceptionError(int number, const std::string& what, std::string remedy)
      : ClientError(what, std::move(remedy)), code(number) {}
  int code;
};

class Connection {
 public:
  // Opens the line; throws ClientError.
  explicit Connection(LineOptions options);

  // Each throws ClientError. What reads, and what may be written twice, is tried three times on a
  // line that garbles it or loses it; `once` is not.
  std::vector<std::uint16_t> read_words(int address, int count);
  std::vector<bool> read_bits(int address, int count, bool discrete);
  void write_words(int address, std::span<const std::uint16_t> words);
  void write_bit(int address, bool value);
  void write_once(int address, std::uint16_t word);

  void set_timeout(int milliseconds);
  const LineOptions& options() const { return options_; }

 private:
  // Runs `request` until it does not give -1.
  template <typename Request>
  void ask(int tries, const char* what, int address, Request&& request);
  [[noreturn]] void fail(int error, const char* what, int address) const;

  LineOptions options_;
  std::unique_ptr<_modbus, void (*)(_modbus*)> line_;
};

}  // namespace rung::client
