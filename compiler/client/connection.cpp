// SPDX-License-Identifier: Apache-2.0
#include "client/connection.hpp"

#include <fmt/format.h>
#include <modbus/modbus.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace rung::client {
namespace {

constexpr int kTries = 3;
constexpr std::string_view kTcp = "tcp:";

void close_line(_modbus* line) {
  if (line == nullptr) return;
  modbus_close(line);
  modbus_free(line);
}

std::string serial_ports() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) names.push_back("/dev/" + name);
  }
  return names.empty() ? "no serial adapter is there now: plug it in, and see `dmesg`"
                       : fmt::format("there are: {}", fmt::join(names, ", "));
}

[[noreturn]] void fail_to_open(const LineOptions& options, int error) {
  const std::string& port = options.port;
  const bool tcp = port.starts_with(kTcp);
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      throw ClientError(fmt::format("{}: there is no such device", port), serial_ports());
    case EACCES:
    case EPERM:
      throw ClientError(
          fmt::format("{}: permission denied", port),
          "serial ports belong to group dialout: run `sudo usermod -aG dialout $USER` "
          "and log in again");
    case ENOTTY:
    case EINVAL:
      if (!tcp) {
        throw ClientError(fmt::format("{}: this is no serial port", port),
                          "name a serial port, or tcp:HOST:PORT");
      }
      [[fallthrough]];
    default:
      throw ClientError(fmt::format("{}: cannot be opened: {}", port, modbus_strerror(error)),
                        tcp ? "is the gateway running there, and is the port right?"
                            : "is another program using the port?");
  }
}

// A pseudo-terminal (`rung device`) has no parity bit, and the C library refuses to set one.
bool is_pseudo_terminal(const std::string& port) {
  std::error_code ignored;
  return std::filesystem::canonical(port, ignored).string().starts_with("/dev/pts/");
}

_modbus* make_line(const LineOptions& options) {
  if (!options.port.starts_with(kTcp)) {
    const char parity = is_pseudo_terminal(options.port) ? 'N' : options.parity;
    return modbus_new_rtu(options.port.c_str(), options.baud, parity, 8, parity == 'N' ? 2 : 1);
  }
  const std::string address = options.port.substr(kTcp.size());
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == address.size()) {
    throw ClientError(fmt::format("{}: this is no address", options.port),
                      "write tcp:HOST:PORT, for example tcp:127.0.0.1:1502");
  }
  return modbus_new_tcp_pi(address.substr(0, colon).c_str(), address.substr(colon + 1).c_str());
}

// Of the standard's exceptions what they say of a controller.
std::pair<std::string_view, std::string_view> exception_text(int code) {
  switch (code) {
    case MODBUS_EXCEPTION_ILLEGAL_FUNCTION:
      return {"it does not know this function", "is this a Rung controller?"};
    case MODBUS_EXCEPTION_ILLEGAL_DATA_ADDRESS:
      return {"it does not have this address",
              "see `rung export` for addresses, and `rung info` for what is there"};
    case MODBUS_EXCEPTION_ILLEGAL_DATA_VALUE:
      return {"it does not take this value or this many",
              "exchange_points of the program's I/O map bound what a request may ask for"};
    case MODBUS_EXCEPTION_SLAVE_OR_SERVER_FAILURE:
      return {"it could not do it", "see `rung info` for its state"};
    case MODBUS_EXCEPTION_SLAVE_OR_SERVER_BUSY:
      return {"it is busy", "try again"};
    default:
      return {"an exception", ""};
  }
}

}  // namespace

Connection::Connection(LineOptions options)
    : options_(std::move(options)), line_(make_line(options_), close_line) {
  if (line_ == nullptr) fail_to_open(options_, errno);
  set_timeout(options_.timeout_ms);
  modbus_set_slave(line_.get(), options_.unit);
  if (modbus_connect(line_.get()) != 0) fail_to_open(options_, errno);
  modbus_flush(line_.get());
}

void Connection::set_timeout(int milliseconds) {
  modbus_set_response_timeout(line_.get(), static_cast<std::uint32_t>(milliseconds / 1000),
                              static_cast<std::uint32_t>(milliseconds % 1000 * 1000));
}

template <typename Request>
void Connection::ask(int tries, const char* what, int address, Request&& request) {
  for (int left = tries; request() < 0;) {
    const int error = errno;
    const bool line_fault =
        error == ETIMEDOUT || error == EMBBADCRC || error == EMBBADDATA || error == EMBBADSLAVE;
    if (!line_fault || --left == 0) fail(error, what, address);
    modbus_flush(line_.get());
  }
}

void Connection::fail(int error, const char* what, int address) const {
  const std::string head = fmt::format("{}: {} at {:#06x}", options_.port, what, address);
  if (error == ETIMEDOUT) {
    throw TimeoutError(
        head + ": no answer in time",
        fmt::format(
            "is it on, and are unit {}, {} baud and parity {} those of its I/O map? A longer "
            "--timeout may help",
            options_.unit, options_.baud, options_.parity));
  }
  if (error >= EMBXILFUN && error < EMBXILFUN + MODBUS_EXCEPTION_MAX - 1) {
    const int code = error - MODBUS_ENOBASE;
    const auto [says, mend] = exception_text(code);
    throw ExceptionError(code, fmt::format("{}: exception {:02}: {}", head, code, says),
                         std::string(mend));
  }
  if (error == EMBBADCRC || error == EMBBADDATA || error == EMBBADSLAVE) {
    throw ClientError(
        head + ": the answer is garbled",
        "check the cable, baud rate and parity, and that one client alone uses the line");
  }
  throw ClientError(fmt::format("{}: {}", head, modbus_strerror(error)),
                    "is the cable still plugged in?");
}

std::vector<std::uint16_t> Connection::read_words(int address, int count) {
  std::vector<std::uint16_t> words(static_cast<std::size_t>(count));
  ask(kTries, "reading registers", address,
      [&] { return modbus_read_registers(line_.get(), address, count, words.data()); });
  return words;
}

std::vector<bool> Connection::read_bits(int address, int count, bool discrete) {
  std::vector<std::uint8_t> bits(static_cast<std::size_t>(count));
  ask(kTries, discrete ? "reading inputs" : "reading coils", address, [&] {
    return discrete ? modbus_read_input_bits(line_.get(), address, count, bits.data())
                    : modbus_read_bits(line_.get(), address, count, bits.data());
  });
  return {bits.begin(), bits.end()};
}

void Connection::write_words(int address, std::span<const std::uint16_t> words) {
  ask(kTries, "writing registers", address, [&] {
    return modbus_write_registers(line_.get(), address, static_cast<int>(words.size()),
                                  words.data());
  });
}

void Connection::write_bit(int address, bool value) {
  ask(kTries, "writing a coil", address,
      [&] { return modbus_write_bit(line_.get(), address, value ? 1 : 0); });
}

void Connection::write_once(int address, std::uint16_t word) {
  ask(1, "writing a register", address,
      [&] { return modbus_write_register(line_.get(), address, word); });
}

}  // namespace rung::client
