// SPDX-License-Identifier: Apache-2.0
#include "fuzz/host_readers.hpp"

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "device/console.hpp"
#include "device/mbap.hpp"
#include "fuzz/require.hpp"
#include "io/map.hpp"
#include "melsec/melsec.hpp"
#include "source/text_file.hpp"
#include "view/commands.hpp"
#include "view/frame.hpp"

namespace rung::fuzz {
namespace {

constexpr const char* kProgram =
    "LD X0\nOR M0\nANI X1\nOUT M0\nOUT Y0\nLD M0\nOUT T0 K2\nLD T0\nOUT Y1\nLD X2\nINC D0\nEND\n";

// What the page looks at: one program, from the start for every input.
struct Viewed {
  Program program;
  std::vector<std::string> lines;

  Viewed() {
    Diagnostics diagnostics;
    const auto text = decode_text(kProgram, "fuzz.il", diagnostics);
    program = parse_melsec(*text, Dialect::Fx, diagnostics).value();
    for (const auto& line : text->lines) lines.push_back(to_utf8(line));
  }
};

}  // namespace

// In two pieces as well as at once: a client's bytes come as they like. Requests and what is left
// are all that was put in, and a reply is a frame that says the same.
void read_mbap(std::string_view bytes) {
  const std::vector<std::uint8_t> all(bytes.begin(), bytes.end());
  const std::size_t cut = all.empty() ? 0 : all.front() % all.size();
  std::vector<std::vector<std::uint8_t>> found[2];
  for (int pieces = 0; pieces < 2; ++pieces) {
    device::MbapStream stream;
    std::size_t taken = 0;
    const auto take = [&] {
      while (const auto request = stream.next()) {
        require(!request->pdu.empty() && request->pdu.size() <= 253, "a PDU of a wrong length");
        taken += 7 + request->pdu.size();
        const auto reply = device::mbap_reply(*request, request->pdu);
        device::MbapStream again;
        again.put(reply);
        const auto back = again.next();
        require(back && back->transaction == request->transaction && back->unit == request->unit &&
                    back->pdu == request->pdu && again.waiting() == 0,
                "a reply that is another frame");
        found[pieces].push_back(reply);
      }
    };
    const std::span<const std::uint8_t> whole(all);
    if (pieces == 1) {
      stream.put(whole.first(cut));
      take();
    }
    stream.put(whole.subspan(pieces == 1 ? cut : 0));
    take();
    require(stream.broken() ? stream.waiting() == 0 : taken + stream.waiting() == all.size(),
            "bytes got lost");
  }
  require(found[0] == found[1], "a stream in pieces has other requests");
}

void read_console(std::string_view bytes) {
  for (const char* const name : {"simulated", "hx8k"}) {
    const controller::Board& board = *io::find_board(name);
    const auto command = device::parse_bench_command(bytes, board);
    if (const auto* const wrong = std::get_if<std::string>(&command)) {
      require(!wrong->empty(), "refused without words");
      continue;
    }
    using Kind = device::BenchCommand::Kind;
    const auto& accepted = std::get<device::BenchCommand>(command);
    require(accepted.kind != Kind::Input ||
                (accepted.index >= 0 && accepted.index < static_cast<int>(board.inputs.size()) &&
                 (accepted.value == 0 || accepted.value == 1)),
            "an input that is not there");
    require(accepted.kind != Kind::Adc || (accepted.index >= 0 && accepted.index < board.adc),
            "a channel that is not there");
  }
}

// Each line is the body of a request to /api/command; after each, the program runs a scan, and
// what the page is told is text.
void read_view(std::string_view bytes) {
  static const Viewed viewed;
  const view::ProgramView shown(viewed.program, viewed.lines, 6);
  view::Run run(shown, {"reference"}, [](const std::string&) {
    return view::make_reference_engine(viewed.program, 100'000);
  });
  view::FrameState state;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const auto command = nlohmann::json::parse(bytes.substr(0, end), nullptr, false);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    try {
      view::obey(run, command);
    } catch (const std::runtime_error& error) {
      require(!nlohmann::json{{"error", error.what()}}.dump().empty(), "refused without words");
    }
    if (run.has_work()) run.one_scan();
    const auto frame = view::frame_json(run, state);
    if (frame) require(!frame->dump().empty(), "a frame without a word");
  }
  require(!view::model_json(run).dump().empty(), "no model");
}

}  // namespace rung::fuzz
