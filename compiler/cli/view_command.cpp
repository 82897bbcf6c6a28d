// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <thread>

#include "cli/client_input.hpp"
#include "melsec/comments.hpp"
#include "melsec/melsec.hpp"
#include "source/text_file.hpp"
#include "view/board_engine.hpp"
#include "view/inside_engine.hpp"
#include "view/page_files.hpp"
#include "view/processor_engine.hpp"
#include "view/server.hpp"
#include "view/terminal.hpp"

namespace rung::cli {
namespace {

constexpr const char* kExample = "example: bottling line";

// The program and its view, which refers to it.
struct Subject {
  Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  Input input;
  std::unique_ptr<view::ProgramView> view;
  std::int64_t tick_us = 10000;
};

// Of a rung, before it is turned.
int columns_of(const Options& options) {
  constexpr int kPage = 10, kTerminal = 6;
  return options.text ? kTerminal : kPage;
}

std::vector<std::string> lines_of(const SourceText& text) {
  std::vector<std::string> lines;
  for (const auto& line : text.lines) lines.push_back(to_utf8(line));
  return lines;
}

std::unique_ptr<Subject> read_example(const Options& options, Diagnostics& diagnostics) {
  auto subject = std::make_unique<Subject>();
  const auto list = decode_text(view::example_list(), kExample, diagnostics);
  const auto names = decode_text(view::example_comments(), kExample, diagnostics);
  subject->input.program = parse_melsec(*list, Dialect::Fx, diagnostics);
  subject->input.program->comments = *parse_comments(*names, Dialect::Fx, diagnostics);
  subject->tick_us = tick_of(options, subject->input).value_or(10000);
  subject->view = std::make_unique<view::ProgramView>(*subject->input.program, lines_of(*list),
                                                      columns_of(options));
  return subject;
}

// `options` gets the configuration of an I/O map.
std::unique_ptr<Subject> read_subject(Options& options, Diagnostics& diagnostics) {
  if (options.program.empty()) return read_example(options, diagnostics);
  if (options.program == "-") throw UsageError("view: give the program as a file");
  const auto map = read_io(options, diagnostics);
  auto input = read_input(options, false, std::nullopt, diagnostics);
  if (!input) return nullptr;
  check_io(*input, map, options, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  auto subject = std::make_unique<Subject>();
  subject->input = std::move(*input);
  subject->tick_us = tick_of(options, subject->input).value_or(10000);
  // A list's comments and a flow's steps are shown as they stand there.
  std::vector<std::string> lines;
  Diagnostics ignored;
  if (const auto text = read_text(options.program, ignored)) lines = lines_of(*text);
  const int columns = columns_of(options);
  subject->view =
      subject->input.flow
          ? std::make_unique<view::ProgramView>(*subject->input.flow, lines, columns)
          : std::make_unique<view::ProgramView>(*subject->input.program, lines, columns);
  return subject;
}

image::Image compile_for(const Subject& subject, Options options, int mpu) {
  options.mpu = std::to_string(mpu);
  Diagnostics diagnostics;
  auto compiled = compile_input(subject.input, options, diagnostics);
  if (!compiled) {
    const auto first =
        std::find_if(diagnostics.all().begin(), diagnostics.all().end(),
                     [](const Diagnostic& each) { return each.severity == Severity::Error; });
    throw std::runtime_error(fmt::format("MPU{} does not take this program: line {}: {}", mpu,
                                         first->position.line, first->what));
  }
  return std::move(compiled->image);
}

std::unique_ptr<view::Engine> make_inside(const Subject& subject, Options options) {
  options.config = tb::kInsideConfig;
  std::vector<image::Image> images;
  for (const int mpu : {1, 2, 3}) images.push_back(compile_for(subject, options, mpu));
  return tb::make_inside_engine(*subject.input.program, std::move(images), subject.tick_us);
}

std::unique_ptr<view::Run> make_run(const Subject& subject, const Options& options) {
  if (!options.port.empty()) {
    const client::LineOptions line = line_of(options, std::nullopt);
    return std::make_unique<view::Run>(*subject.view, std::vector<std::string>{"controller"},
                                       [&subject, line](const std::string&) {
                                         return view::make_board_engine(*subject.view, line);
                                       });
  }
  if (subject.input.flow) {
    const std::string config(config_of(options).name);
    return std::make_unique<view::Run>(*subject.view, std::vector<std::string>{"reference"},
                                       [&subject, config](const std::string&) {
                                         return view::make_flow_engine(*subject.input.flow,
                                                                       subject.tick_us, config);
                                       });
  }
  std::vector<std::string> engines{"mpu3", "mpu2", "mpu1", "inside", "reference"};
  const int mpu = mpu_of(options).value_or(options.default_mpu);
  const std::string first = mpu == 0 ? "reference" : fmt::format("mpu{}", mpu);
  std::stable_partition(engines.begin(), engines.end(),
                        [&](const std::string& name) { return name == first; });
  return std::make_unique<view::Run>(
      *subject.view, engines,
      [&subject, options](const std::string& name) -> std::unique_ptr<view::Engine> {
        if (name == "reference") {
          return view::make_reference_engine(*subject.input.program, subject.tick_us);
        }
        if (name == "inside") return make_inside(subject, options);
        return tb::make_processor_engine(*subject.input.program,
                                         compile_for(subject, options, name.back() - '0'),
                                         subject.tick_us);
      });
}

// [ADDRESS:]PORT
view::ServerSetup setup_of(const Options& options) {
  view::ServerSetup setup;
  if (!options.listen.empty()) {
    const std::size_t colon = options.listen.rfind(':');
    const std::string port =
        colon == std::string::npos ? options.listen : options.listen.substr(colon + 1);
    if (colon != std::string::npos) setup.address = options.listen.substr(0, colon);
    if (setup.address.starts_with("[") && setup.address.ends_with("]")) {
      setup.address = setup.address.substr(1, setup.address.size() - 2);
    }
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), setup.port);
    if (error != std::errc{} || end != port.data() + port.size() || setup.port < 0 ||
        setup.port > 65535 || setup.address.empty()) {
      throw UsageError(fmt::format("--listen {}: write PORT or ADDRESS:PORT", options.listen));
    }
    setup.fixed = true;
  }
  setup.token = options.token;
  if (setup.token.empty() && !view::is_loopback(setup.address)) setup.token = view::new_token();
  return setup;
}

void open_browser(const std::string& url) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const pid_t child = ::fork();
  if (child != 0) {
    if (child > 0) ::waitpid(child, nullptr, 0);
    return;
  }
  // A grandchild, which nobody waits for.
  if (::fork() == 0) {
    ::execlp("xdg-open", "xdg-open", url.c_str(), static_cast<char*>(nullptr));
    ::_exit(1);
  }
  ::_exit(0);
}

int serve(const Subject& subject, const Options& options) {
  // The signals are waited for in a thread of their own; no other one takes them.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);

  view::Session session(make_run(subject, options));
  view::Server server(session, setup_of(options));
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  if (!options.no_browser) open_browser(server.url());
  std::thread waiter([&] {
    int signal = 0;
    sigwait(&signals, &signal);
    server.stop();
  });
  server.run();
  waiter.join();
  return kDone;
}

}  // namespace

int view_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  const auto subject = read_subject(options, diagnostics);
  if (!subject) return report(diagnostics);
  if (const int code = report(diagnostics); code != kDone) return code;
  const auto look = [&] {
    if (!options.text) return serve(*subject, options);
    auto run = make_run(*subject, options);
    std::optional<Stimulus> stimulus;
    if (!options.stimulus.empty()) {
      stimulus = read_stimulus(options.stimulus, names_of(subject->input), diagnostics);
      if (!stimulus) return report(diagnostics);
    }
    return view::show_in_terminal(std::move(run), options.scans, stimulus);
  };
  if (options.port.empty()) return look();
  return with_controller(options, diagnostics, look);
}

}  // namespace rung::cli
