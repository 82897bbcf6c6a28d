// SPDX-License-Identifier: Apache-2.0
#include "backends/ld_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "backends/ld_limits.hpp"
#include "ldmicro/comment_text.hpp"
#include "ldmicro/ldmicro.hpp"
#include "source/code_page.hpp"

namespace rung {
namespace {

constexpr std::size_t kIndent = 4;

// A file's encoding: a code page, or UTF-8 without one.
using Encoding = std::optional<CodePage>;

std::optional<std::string> encoded(const std::string& text, Encoding encoding) {
  return encoding ? encode(text, *encoding) : text;
}

// The line of a comment, escaped byte by byte in the encoding as LDmicro does it.
std::optional<std::string> comment_line(const std::string& note, Encoding encoding) {
  const auto bytes = encoded(note, encoding);
  if (!bytes) return std::nullopt;
  return "COMMENT " + ld_comment(*bytes);
}

// The lines of the file that need not be ASCII.
std::optional<std::string> texts(const Program& program, Encoding encoding) {
  std::string all;
  for (const std::string& setting : {program.ldmicro->micro, program.ldmicro->compiled}) {
    const auto text = encoded(setting, encoding);
    if (!text) return std::nullopt;
    all += "TEXT=" + *text + '\n';
  }
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op != Op::Comment) continue;
    const auto line = comment_line(instruction.note, encoding);
    if (!line) return std::nullopt;
    all += *line + '\n';
  }
  return all;
}

// LDmicro shows a file in the code page of its Windows, and nothing in the file says which: one in
// which the reader finds the same text again.
Encoding find_encoding(const Program& program) {
  const std::string plain = *texts(program, std::nullopt);
  if (std::all_of(plain.begin(), plain.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x80; })) {
    return std::nullopt;
  }
  Diagnostics ignored;
  const auto wanted = decode_ldmicro(plain, program.file, ignored);
  for (const CodePage page : {CodePage::Japanese, CodePage::Western}) {
    const auto bytes = texts(program, page);
    const auto found = bytes ? decode_ldmicro(*bytes, program.file, ignored) : std::nullopt;
    if (wanted && found && wanted->lines == found->lines) return page;
  }
  return std::nullopt;
}

class LdWriter {
 public:
  LdWriter(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics), encoding_(find_encoding(program)) {}

  std::string write() {
    write_header();
    for (const Network& rung : program_.networks) write_rung(rung);
    return std::move(text_);
  }

 private:
  // An open rung, SERIES or PARALLEL.
  struct Level {
    SourcePosition position;
    bool parallel = false;
    int items = 0;
  };

  void error(SourcePosition position, std::string what, std::string mend) {
    diagnostics_.error(program_.file, position, std::move(what), std::move(mend));
  }

  void write_header() {
    const LdmicroSettings& settings = *program_.ldmicro;
    text_ += "LDmicro0.1\n";
    if (!settings.micro.empty()) add("MICRO=" + *encoded(settings.micro, encoding_), {});
    text_ += fmt::format("CYCLE={}\nCRYSTAL={}\nBAUD={}\n", settings.cycle_us, settings.crystal_hz,
                         settings.baud);
    if (!settings.compiled.empty()) add("COMPILED=" + *encoded(settings.compiled, encoding_), {});
    text_ += "\nIO LIST\n";
    for (const LdmicroSettings::Pin& pin : settings.pins) {
      const std::string line = fmt::format("    {} at {}", pin.name, pin.pin);
      if (line.size() > ld_limits::kPinLine) {
        error({},
              fmt::format("IO LIST: the line of {} has {} characters, of which LDmicro 2.3 "
                          "reads {}",
                          shown(pin.name), line.size(), ld_limits::kPinLine),
              "give it a shorter name");
      }
      text_ += line + '\n';
    }
    text_ += "END\n\nPROGRAM\n";
  }

  // A line, indented where that leaves it short enough.
  void add(const std::string& line, SourcePosition position) {
    if (line.size() > ld_limits::kLine) {
      error(position,
            fmt::format("{}: a line of {} characters, of which LDmicro 2.3 reads {}",
                        shown(line.substr(0, line.find(' '))), line.size(), ld_limits::kLine),
            "use shorter names or texts, or smaller tables");
    }
    const std::size_t indent = kIndent * levels_.size();
    if (indent + line.size() <= ld_limits::kLine) text_.append(indent, ' ');
    text_ += line + '\n';
  }

  void write_rung(const Network& rung) {
    const auto& code = program_.instructions;
    for (std::size_t i = rung.first; i < rung.first + rung.count; ++i) {
      const SourcePosition position = code[i].position;
      switch (code[i].op) {
        case Op::Rung:
          add("RUNG", position);
          levels_.push_back({position});
          break;
        case Op::Parallel:
          count_item(position);
          add("PARALLEL", position);
          levels_.push_back({position, true});
          begin_branch(i + 1);
          break;
        case Op::Branch:
          end_branch();
          begin_branch(i + 1);
          break;
        case Op::Join:
          end_branch();
          close();
          break;
        default:
          if (!levels_.back().parallel) count_item(position);
          write_element(code[i]);
      }
    }
    close();
  }

  // One element alone stands in the PARALLEL itself.
  void begin_branch(std::size_t first) {
    const auto& code = program_.instructions;
    const SourcePosition position = code[first].position;
    count_item(position);
    const Op next = code[first + 1].op;
    const bool single = (!is_frame(code[first].op) || code[first].op == Op::Comment) &&
                        (next == Op::Branch || next == Op::Join);
    if (single) return;
    add("SERIES", position);
    levels_.push_back({position});
  }
  void end_branch() {
    if (!levels_.back().parallel) close();
  }
  void close() {
    levels_.pop_back();
    add("END", {});
  }

  void count_item(SourcePosition position) {
    Level& level = levels_.back();
    if (++level.items != ld_limits::kItems + 1) return;
    error(position,
          fmt::format("{} {} of the {} that begins in line {}, of which LDmicro 2.3 holds {}",
                      level.parallel ? "branch" : "element", level.items,
                      level.parallel ? "PARALLEL" : "row", level.position.line, ld_limits::kItems),
          level.parallel ? "put a PARALLEL of its own around some of them"
                         : "keep an inner result in a relay, in a rung of its own");
  }

  void write_element(const Instruction& instruction) {
    if (instruction.op != Op::Comment) {
      return add(to_ld(instruction, program_), instruction.position);
    }
    const auto line = comment_line(instruction.note, encoding_);
    const std::size_t bytes = unescape_comment(*line).size() - std::string_view("COMMENT ").size();
    if (bytes > ld_limits::kComment) {
      error(instruction.position,
            fmt::format("COMMENT: {} bytes, of which LDmicro 2.3 holds {}", bytes,
                        ld_limits::kComment),
            "part it into two rungs");
    } else {
      add(*line, instruction.position);
    }
  }

  const Program& program_;
  Diagnostics& diagnostics_;
  Encoding encoding_;
  std::vector<Level> levels_;
  std::string text_;
};

}  // namespace

std::optional<std::string> to_ld(const Program& program, Diagnostics& diagnostics) {
  const int before = diagnostics.error_count();
  ld_limits::check(program, diagnostics);
  std::string text = LdWriter(program, diagnostics).write();
  if (diagnostics.error_count() != before) return std::nullopt;
  return text;
}

}  // namespace rung
