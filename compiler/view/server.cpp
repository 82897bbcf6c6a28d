// SPDX-License-Identifier: Apache-2.0
#include "view/server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <charconv>
#include <random>

#include "view/commands.hpp"
#include "view/frame.hpp"
#include "view/page_files.hpp"

namespace rung::view {
namespace {

using httplib::Request;
using httplib::Response;
using nlohmann::json;

constexpr int kThreads = 40;
constexpr int kStreams = 24;  // the other threads answer requests
constexpr auto kFrame = std::chrono::milliseconds(16);
constexpr int kQuietFrames = 60;  // then a comment, so that a lost client is noticed
constexpr std::size_t kLongestCommand = 4096;

// The name in a Host header, without the port.
std::string host_name(const std::string& host) {
  if (host.starts_with("[")) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.find(':'));
}

// Takes the same time wherever they differ.
bool equal_secret(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned>(a[i] ^ b[b.empty() ? 0 : i % b.size()]);
  }
  return difference == 0;
}

std::vector<int> devices_of(const Request& request, std::size_t count) {
  std::vector<int> devices;
  std::string number;
  for (const char c : request.get_param_value("d") + ",") {
    if (c >= '0' && c <= '9' && number.size() < 6) {
      number += c;
    } else if (!number.empty()) {
      const int device = std::stoi(number);
      if (device < static_cast<int>(count)) devices.push_back(device);
      number.clear();
    }
  }
  return devices;
}

// A parameter that counts scans; 0 if it is none.
std::int64_t number_of(const Request& request, const char* name) {
  std::int64_t number = 0;
  const std::string text = request.get_param_value(name);
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

void refuse(Response& response, int status, const std::string& what) {
  response.status = status;
  response.set_content(json{{"error", what}}.dump(), "application/json");
}

}  // namespace

struct Server::Parts {
  Session& session;
  ServerSetup setup;
  httplib::Server http;
  int port = 0;
  std::atomic<bool> stopping{false};
  std::atomic<int> streams{0};

  Parts(Session& s, ServerSetup given) : session(s), setup(std::move(given)) {
    http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http.set_tcp_nodelay(true);
    // The library's own would share the port with another server that has it.
    http.set_socket_options([](int socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http.set_keep_alive_timeout(2);
    http.set_payload_max_length(kLongestCommand);
    http.set_pre_routing_handler([this](const Request& request, Response& response) {
      return admit(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                      : httplib::Server::HandlerResponse::Handled;
    });
    define_page();
    define_data();
    define_commands();
    bind();
  }

  // Pages of other sites must not reach this one: neither by another name for this address, nor by
  // a request from their own.
  bool admit(const Request& request, Response& response) {
    response.set_header("Content-Security-Policy",
                        "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
                        "data:; frame-ancestors 'none'");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cache-Control", "no-store");
    const std::string host = request.get_header_value("Host");
    if (setup.token.empty()) {
      const std::string name = host_name(host);
      if (!is_loopback(name)) {
        refuse(response, 403, "this server answers on its own machine only");
        return false;
      }
    } else if (!knows_token(request, response)) {
      refuse(response, 403, "the address needs the token that rung view has printed");
      return false;
    }
    const std::string origin = request.get_header_value("Origin");
    if (!origin.empty() && origin != "http://" + host) {
      refuse(response, 403, "a page of another site asked for this");
      return false;
    }
    return true;
  }

  // In the address once, in a cookie from then on.
  bool knows_token(const Request& request, Response& response) {
    const std::string name = fmt::format("rung_{}=", port);
    if (request.has_param("token") && equal_secret(request.get_param_value("token"), setup.token)) {
      response.set_header("Set-Cookie", name + setup.token + "; HttpOnly; SameSite=Strict; Path=/");
      return true;
    }
    const std::string cookies = request.get_header_value("Cookie");
    const std::size_t at = cookies.find(name);
    if (at == std::string::npos) return false;
    const std::string rest = cookies.substr(at + name.size());
    return equal_secret(rest.substr(0, rest.find(';')), setup.token);
  }

  void define_page() {
    for (const PageFile& file : page_files()) {
      const std::string path = file.name == "index.html" ? "/" : "/" + std::string(file.name);
      http.Get(path, [&file](const Request&, Response& response) {
        response.set_content(file.text.data(), file.text.size(), std::string(file.type));
      });
    }
  }

  void define_data() {
    http.Get("/api/program", [this](const Request&, Response& response) {
      const json model = session.call([](Run& run) { return model_json(run); });
      response.set_content(model.dump(), "application/json");
    });
    http.Get("/api/events", [this](const Request&, Response& response) { stream(response); });
    http.Get("/api/history", [this](const Request& request, Response& response) {
      const std::int64_t from = number_of(request, "from");
      const json history = session.call([&](Run& run) {
        json rows = json::array();
        for (const int device : devices_of(request, run.values().size())) {
          json changes = json::array();
          for (const auto& change : run.history().of(device, from)) {
            changes.push_back(change.scan);
            changes.push_back(change.value);
          }
          rows.push_back({{"device", device}, {"changes", changes}});
        }
        return json{{"run", run.runs()},
                    {"first", run.history().first()},
                    {"last", run.history().last()},
                    {"rows", rows}};
      });
      response.set_content(history.dump(), "application/json");
    });
    http.Get("/api/code", [this](const Request&, Response& response) {
      const json code = session.call([](Run& run) { return code_json(run); });
      response.set_content(code.dump(), "application/json");
    });
    http.Get("/api/recording", [this](const Request&, Response& response) {
      const json clocks = session.call([](Run& run) { return recording_json(run); });
      response.set_content(clocks.dump(), "application/json");
    });
    define_export("vcd", to_vcd, "text/plain");
    define_export("csv", to_csv, "text/csv");
  }

  template <typename Writer>
  void define_export(const std::string& suffix, Writer writer, const std::string& type) {
    http.Get("/api/rung." + suffix, [=, this](const Request& request, Response& response) {
      const std::string text = session.call([&](Run& run) {
        return writer(run.history(), run.view(), devices_of(request, run.values().size()),
                      run.engine().tick_us());
      });
      response.set_header("Content-Disposition", "attachment; filename=rung." + suffix);
      response.set_content(text, type);
    });
  }

  void define_commands() {
    http.Post("/api/command", [this](const Request& request, Response& response) {
      // A form of another site cannot send this type.
      if (request.get_header_value("Content-Type") != "application/json") {
        return refuse(response, 415, "send JSON");
      }
      const json command = json::parse(request.body, nullptr, false);
      try {
        session.call([&](Run& run) {
          obey(run, command);
          return 0;
        });
        response.set_content("{}", "application/json");
      } catch (const std::exception& error) {
        refuse(response, 400, error.what());
      }
    });
  }

  void stream(Response& response) {
    if (streams >= kStreams) return refuse(response, 503, "too many pages are open");
    ++streams;
    auto state = std::make_shared<FrameState>();
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, state](std::size_t, httplib::DataSink& sink) { return send_frame(*state, sink); },
        [this](bool) { --streams; });
  }

  bool send_frame(FrameState& state, httplib::DataSink& sink) {
    for (int i = 0; i < kQuietFrames && !stopping; ++i) {
      const auto frame = session.call([&](Run& run) { return frame_json(run, state); });
      if (frame) {
        const std::string text = "data: " + frame->dump() + "\n\n";
        if (!sink.write(text.data(), text.size())) return false;
        std::this_thread::sleep_for(kFrame);
        return true;
      }
      std::this_thread::sleep_for(kFrame);
    }
    if (stopping) {
      sink.done();
      return true;
    }
    return sink.write(":\n\n", 3);
  }

  void bind() {
    const bool any = setup.port == 0;
    if (!any && http.bind_to_port(setup.address, setup.port)) {
      port = setup.port;
    } else if (any || !setup.fixed) {
      port = http.bind_to_any_port(setup.address);
    }
    if (port <= 0) {
      throw std::runtime_error(fmt::format(
          "cannot listen on {}:{}: choose another one with --listen", setup.address, setup.port));
    }
  }
};

bool is_loopback(const std::string& address) {
  // A name may begin with 127. too.
  return address == "localhost" || address == "::1" ||
         (address.starts_with("127.") &&
          address.find_first_not_of("0123456789.") == std::string::npos);
}

std::string new_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

Server::Server(Session& session, ServerSetup setup)
    : parts_(std::make_unique<Parts>(session, std::move(setup))) {}

Server::~Server() { stop(); }

int Server::port() const { return parts_->port; }

std::string Server::url() const {
  std::string host = parts_->setup.address;
  if (host == "0.0.0.0") host = "localhost";
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  return fmt::format("http://{}:{}/{}", host, parts_->port,
                     parts_->setup.token.empty() ? "" : "?token=" + parts_->setup.token);
}

void Server::run() { parts_->http.listen_after_bind(); }

void Server::stop() {
  parts_->stopping = true;
  parts_->http.stop();
}

}  // namespace rung::view
