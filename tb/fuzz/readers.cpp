// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.hpp"

#include <zlib.h>

#include <optional>
#include <string>
#include <vector>

#include "backends/ld_writer.hpp"
#include "backends/list_writer.hpp"
#include "flowchart/read.hpp"
#include "fuzz/bytecode_reader.hpp"
#include "fuzz/host_readers.hpp"
#include "fuzz/require.hpp"
#include "image/image_file.hpp"
#include "io/bind.hpp"
#include "ldmicro/ldmicro.hpp"
#include "load/load_file.hpp"
#include "melsec/comments.hpp"
#include "melsec/list.hpp"
#include "melsec/melsec.hpp"
#include "reference/flow_rounds.hpp"
#include "rungs/ports.hpp"
#include "rungs/structure.hpp"
#include "trace/ldmicro_trace.hpp"
#include "trace/stimulus.hpp"
#include "trace/trace.hpp"

namespace rung::fuzz {
namespace {

// What is refused has an error, what is accepted none; and printing the messages must do too.
void check(bool accepted, const Diagnostics& diagnostics) {
  require(accepted != diagnostics.has_errors(), "accepted with errors, or refused without");
  std::string all;
  for (const Diagnostic& each : diagnostics.all()) all += each.what + each.mend;
  require(accepted || !all.empty(), "an error without words");
}

bool same(const Program& left, const Program& right) {
  if (left.instructions.size() != right.instructions.size()) return false;
  for (std::size_t i = 0; i < left.instructions.size(); ++i) {
    const Instruction& a = left.instructions[i];
    const Instruction& b = right.instructions[i];
    if (a.op != b.op || a.operands != b.operands || a.width != b.width || a.pulse != b.pulse ||
        a.relation != b.relation || a.base_us != b.base_us || a.destination != b.destination ||
        a.table != b.table || a.note != b.note) {
      return false;
    }
  }
  return true;
}

// Through every dialect; what is accepted is written as a list, which must be the same program.
void read_program(std::string_view bytes, const std::string& file) {
  Diagnostics decoding;
  const auto text = decode_text(bytes, file, decoding);
  check(text.has_value(), decoding);
  if (!text) return;
  for (const std::optional<Dialect> dialect :
       {std::optional<Dialect>(), std::optional(Dialect::Paper), std::optional(Dialect::Fx),
        std::optional(Dialect::Q)}) {
    Diagnostics diagnostics;
    const auto program = parse_melsec(*text, dialect, diagnostics);
    check(program.has_value(), diagnostics);
    if (!program) continue;
    Diagnostics again;
    const auto list = decode_text(to_list(*program), "again.il", again);
    require(list.has_value(), "the written list is no text");
    const auto back = parse_list(*list, program->dialect, again);
    require(back.has_value() && same(*program, *back), "the written list is another program");
  }
}

// What a stimulus may name: lists of two number bases, and a program with names of its own.
std::vector<DeviceNames> all_names() {
  return {Dialect::Paper, Dialect::Fx, Dialect::Q,
          DeviceNames(Dialect::Ldmicro, {{{DeviceKind::X, 0}, "Xa"},
                                         {{DeviceKind::Y, 0}, "Yo"},
                                         {{DeviceKind::M, 0}, "n"},
                                         {{DeviceKind::D, 0}, "n:w"},
                                         {{DeviceKind::D, 1}, "v"},
                                         {{DeviceKind::D, 2}, "Aa"},
                                         {port::adc, "Aa"}})};
}

// A whole image file whose contents are `payload`: else the checksum would keep all others out.
std::string wrapped(std::string_view payload, std::uint8_t version) {
  std::string file = "RUNGIMG";
  file += static_cast<char>(version);
  const auto add = [&](std::uint32_t value) {
    for (int i = 0; i < 4; ++i) file += static_cast<char>(value >> (8 * i) & 0xFFU);
  };
  add(static_cast<std::uint32_t>(payload.size()));
  add(static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(payload.data()), static_cast<uInt>(payload.size()))));
  file += payload;
  return file;
}

void read_image_file(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto image = image::from_bytes(bytes, "fuzz.img", diagnostics);
  check(image.has_value(), diagnostics);
  if (!image) return;
  static_cast<void>(image::listing(*image));
  Diagnostics again;
  require(image::from_bytes(image::to_bytes(*image), "again.img", again).has_value(),
          "the written image cannot be read");
}

}  // namespace

// The suffix frees it from the need of an END.
void read_list(std::string_view bytes) { read_program(bytes, "fuzz.esc"); }

void read_csv(std::string_view bytes) { read_program(bytes, "fuzz.csv"); }

// What is accepted is written, where LDmicro 2.3 has room for it, which must be the same program.
void read_ld(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto text = decode_ldmicro(bytes, "fuzz.ld", diagnostics);
  check(text.has_value(), diagnostics);
  if (!text) return;
  const auto program = parse_ldmicro(*text, diagnostics);
  check(program.has_value(), diagnostics);
  if (!program) return;
  Diagnostics writing;
  const auto file = to_ld(*program, writing);
  check(file.has_value(), writing);
  if (!file) return;
  Diagnostics again;
  const auto written = decode_ldmicro(*file, "again.ld", again);
  require(written.has_value(), "the written file is no text");
  const auto back = parse_ldmicro(*written, again);
  require(back.has_value() && same(*program, *back) && back->names == program->names &&
              back->ldmicro->pins == program->ldmicro->pins,
          "the written file is another program");
}

void read_comments(std::string_view bytes) {
  Diagnostics decoding;
  const auto text = decode_text(bytes, "comments.csv", decoding);
  if (!text) return;
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    Diagnostics diagnostics;
    check(parse_comments(*text, dialect, diagnostics).has_value(), diagnostics);
  }
}

void read_stimulus(std::string_view bytes) {
  Diagnostics decoding;
  const auto text = decode_text(bytes, "fuzz.stim", decoding);
  if (!text) return;
  for (const DeviceNames& names : all_names()) {
    Diagnostics diagnostics;
    const auto stimulus = parse_stimulus(*text, names, diagnostics);
    check(stimulus.has_value(), diagnostics);
    if (stimulus && stimulus->scans() > 0) {
      static_cast<void>(stimulus->events(0));
      static_cast<void>(stimulus->events(stimulus->scans() - 1));
    }
  }
}

void read_trace(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto trace = rung::read_trace(bytes, "fuzz.golden", diagnostics);
  check(trace.has_value(), diagnostics);
  if (!trace) return;
  for (const DeviceNames& names : all_names()) {
    Diagnostics more;
    const auto stimulus = stimulus_of(*trace, names, "fuzz.golden", more);
    check(stimulus.has_value(), more);
  }
  Diagnostics again;
  const auto back = rung::read_trace(to_json_lines(*trace), "again.golden", again);
  require(back.has_value() && back->scans.size() == trace->scans.size(),
          "the written trace is another one");
}

void read_ldmicro_trace(std::string_view bytes) {
  static_cast<void>(is_ldmicro_trace(bytes));
  Diagnostics diagnostics;
  const auto trace = rung::read_ldmicro_trace(bytes, "fuzz.trace", diagnostics);
  check(trace.has_value(), diagnostics);
  if (!trace) return;
  for (const TraceScan& scan : trace->scans) {
    require(!compare_shown(scan, scan), "a scan differs from itself");
  }
}

void read_image(std::string_view bytes) {
  read_image_file(bytes);
  read_image_file(wrapped(bytes, image::kPlainVersion));
  read_image_file(wrapped(bytes, image::kFlowVersion));
  read_image_file(wrapped(bytes, image::kWideVersion));
}

// A map as it is, then bound to a list; of what is refused each line says why.
void read_io_map(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto map = io::parse_map(bytes, "fuzz.toml", diagnostics);
  require(map.has_value() || diagnostics.has_errors(), "refused without an error");
  if (!map) return;
  io::Subject subject;
  subject.config = "ecp5";
  using enum DeviceKind;
  for (const Device device : {Device{X, 0},
                              {X, 1},
                              {Y, 0},
                              {Y, 1},
                              {M, 600},
                              {TS, 250},
                              {CS, 220},
                              {D, 10},
                              {D, 200},
                              {TN, 250},
                              {CN, 220},
                              {CNH, 220}}) {
    subject.devices.push_back({device, device_name(device, subject.dialect), "name"});
  }
  const io::Bindings bindings = io::bind(*map, subject, diagnostics);
  if (!diagnostics.has_errors()) static_cast<void>(io::table(bindings, subject));
}

// As words, the high byte first, once as they are and once with the length that they have.
void read_load_file(std::string_view bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    words.push_back(static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[at]) << 8 |
                                               static_cast<unsigned char>(bytes[at + 1])));
  }
  for (int length = 0; length < 2; ++length) {
    std::string problem;
    const auto contents = load::read(words, problem);
    require(contents.has_value() == problem.empty(),
            "refused without words, or accepted with some");
    if (words.size() < 8) return;
    words[6] = static_cast<std::uint16_t>(words.size() & 0xFFFF);
    words[7] = static_cast<std::uint16_t>(words.size() >> 16);
  }
}

// What is accepted is whole, and runs.
void read_flow(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto text = decode_text(bytes, "fuzz.flow", diagnostics);
  check(text.has_value(), diagnostics);
  if (!text) return;
  const auto chart = flowchart::parse(*text, diagnostics);
  check(chart.has_value(), diagnostics);
  if (!chart) return;
  for (const flowchart::Step& step : chart->steps) {
    for (const std::size_t next : step.next) {
      require(next < chart->steps.size() && chart->steps[next].task == step.task,
              "a step leads nowhere");
    }
    std::vector<StructureItem> items;
    for (const Instruction& each : step.rungs.instructions) {
      items.push_back({effect_of(each.op), each.text, each.position});
    }
    Diagnostics structure;
    check_structure("fuzz.flow", chart->dialect, items, structure);
    require(!structure.has_errors(), "a step's rungs have no structure");
  }
  FlowRounds rounds(*chart);
  for (int i = 0; i < 5; ++i) {
    rounds.run_round();
    if (!rounds.requests().empty()) {
      rounds.complete(rounds.requests().front().id, i % 2, {1, 2, 3});
    }
  }
}

}  // namespace rung::fuzz
