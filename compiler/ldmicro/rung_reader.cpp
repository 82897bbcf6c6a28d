// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "ldmicro/checks.hpp"
#include "ldmicro/element.hpp"
#include "ldmicro/ldmicro.hpp"
#include "ldmicro/numbers.hpp"

namespace rung {
namespace {

// Open PARALLELs and SERIESes; far beyond what can be drawn, and within what C compilers nest.
constexpr std::size_t kMaxDepth = 100;
// A file with more is none of LDmicro's.
constexpr int kMaxErrors = 100;

class RungReader {
 public:
  RungReader(LdLines& lines, LdContext& context, Program& program)
      : lines_(lines), context_(context), program_(program) {}

  void read() {
    for (; !lines_.at_end(); lines_.advance()) {
      read_line(lines_.line());
      if (open_.size() > kMaxDepth || context_.diagnostics.error_count() > kMaxErrors) return;
    }
    if (!open_.empty()) not_ended("the end of the file");
  }

 private:
  enum class Kind : std::uint8_t { Rung, Series, Parallel };
  struct Open {
    Kind kind;
    SourcePosition position;
    int branches = 0;
  };

  void read_line(const LdLine& line) {
    const std::string& keyword = line.keyword();
    if (keyword == "RUNG") return begin_rung(line);
    if (open_.empty()) return outside(line);
    const bool frame = keyword == "PARALLEL" || keyword == "SERIES" || keyword == "END";
    if (frame && line.words.size() > 1) {
      context_.error(
          line.words[1].position,
          fmt::format("{}: {} stands alone in its line", shown(line.words[1].text), keyword),
          "write what follows in a line of its own");
    }
    if (keyword == "END") {
      end(line);
    } else if (keyword == "PARALLEL") {
      begin_parallel(line);
    } else if (keyword == "SERIES") {
      begin_branch(line);
      open(Kind::Series, line);
    } else {
      begin_branch(line);
      if (auto instruction = read_ld_element(line, context_)) add(std::move(*instruction));
    }
  }

  void add(Instruction instruction) { program_.instructions.push_back(std::move(instruction)); }
  void add_frame(Op op, const LdLine& line, std::string text) {
    Instruction instruction;
    instruction.op = op;
    instruction.position = line.position();
    instruction.text = std::move(text);
    add(std::move(instruction));
  }

  // LDmicro 5 numbers rungs.
  void begin_rung(const LdLine& line) {
    if (!open_.empty()) not_ended(fmt::format("the RUNG of line {}", line.position().line));
    if (line.words.size() > 1) {
      const std::string& number = line.words[1].text;
      if (line.words.size() > 2 || leading_number(number).length != number.size()) {
        context_.error(line.words[1].position,
                       fmt::format("{}: behind RUNG stands its number or nothing", shown(number)),
                       "write what follows in a line of its own");
      }
    }
    program_.networks.push_back({program_.instructions.size(), 0});
    add_frame(Op::Rung, line, "RUNG");
    open(Kind::Rung, line);
    outside_ = false;
  }

  void begin_parallel(const LdLine& line) {
    if (open_.back().kind == Kind::Parallel) {
      context_.error(line.position(), "PARALLEL as a branch of a PARALLEL",
                     "put its branches into the outer one, or put it into a SERIES");
      ++open_.back().branches;
    }
    add_frame(Op::Parallel, line, "PARALLEL");
    open(Kind::Parallel, line);
  }

  // Before an element or SERIES: directly in a PARALLEL it is a branch.
  void begin_branch(const LdLine& line) {
    Open& top = open_.back();
    if (top.kind != Kind::Parallel) return;
    if (top.branches > 0) {
      add_frame(Op::Branch, line, line.keyword() == "SERIES" ? "SERIES" : "");
    }
    ++top.branches;
  }

  void open(Kind kind, const LdLine& line) {
    open_.push_back({kind, line.position()});
    if (open_.size() <= kMaxDepth) return;
    context_.error(line.position(),
                   fmt::format("{} nests deeper than {}", line.keyword(), kMaxDepth),
                   "keep inner results in relays, in rungs of their own");
  }

  void end(const LdLine& line) {
    const Open top = open_.back();
    open_.pop_back();
    if (top.kind == Kind::Parallel) {
      add_frame(Op::Join, line, "END");
      if (top.branches == 0) {
        context_.error(top.position, "PARALLEL without a branch",
                       "put elements into it, or remove it");
      }
    }
    if (top.kind == Kind::Rung) end_rung();
  }

  void end_rung() {
    Network& rung = program_.networks.back();
    rung.count = program_.instructions.size() - rung.first;
  }

  void not_ended(const std::string& where) {
    static constexpr const char* kNames[] = {"RUNG", "SERIES", "PARALLEL"};
    const Open& innermost = open_.back();
    context_.error(innermost.position,
                   fmt::format("{}: its END is not there before {}",
                               kNames[static_cast<std::size_t>(innermost.kind)], where),
                   "write END behind its last element");
    open_.clear();
    end_rung();
  }

  void outside(const LdLine& line) {
    if (!outside_) {
      context_.error(line.position(), fmt::format("{} outside of a rung", shown(line.keyword())),
                     line.keyword() == "END" ? "there is one END more than something to end"
                                             : "elements stand between RUNG and its END");
    }
    outside_ = true;
  }

  LdLines& lines_;
  LdContext& context_;
  Program& program_;
  std::vector<Open> open_;
  bool outside_ = false;  // has been said since the last rung
};

// Sizes are of a VAR LIST, which LDmicro 5 writes; they matter for variables that the program has.
void check_sizes(const LdHeader& header, LdContext& context) {
  for (const LdHeader::OddSize& odd : header.odd_sizes) {
    if (!context.symbols.has_variable(odd.name)) continue;
    context.error(odd.position,
                  fmt::format("{}: a size of {} bits; the variables of 2.3 have 16",
                              shown(odd.name), odd.bits),
                  "give it 16 bits, or 2 bytes, if its values fit");
  }
}

// Where LDmicro 5 does not do what 2.3 does with the same line.
void warn_of_release(const Program& program, LdContext& context) {
  const auto counts = [](const Instruction& instruction) {
    return instruction.op >= Op::Ton && instruction.op <= Op::Ctc && instruction.op != Op::Res;
  };
  const auto found = std::find_if(program.instructions.begin(), program.instructions.end(), counts);
  if (!context.header.extended || found == program.instructions.end()) return;
  context.warn(found->position,
               fmt::format("{}: timers and counters do what LDmicro 2.3 does, whose manual is "
                           "followed; in a file of 0.2 LDmicro 5 lets timers wait one scan longer, "
                           "and its counters stop at their limits",
                           found->text));
}

}  // namespace

std::optional<Program> parse_ldmicro(const SourceText& source, Diagnostics& diagnostics) {
  LdLines lines(source);
  const int before = diagnostics.error_count();
  const LdHeader header = read_ld_header(lines, source.file, diagnostics);
  Program program;
  program.file = source.file;
  program.dialect = Dialect::Ldmicro;
  program.ldmicro = header.settings;
  LdContext context{source.file, header, diagnostics, {}, 0, {}};
  RungReader(lines, context, program).read();
  if (program.networks.empty() && diagnostics.error_count() == before) {
    diagnostics.error(source.file, {}, "the program has no rung", "write RUNG and END at least");
  }
  check_sizes(header, context);
  if (diagnostics.error_count() != before) return std::nullopt;
  program.names = context.symbols.names();
  warn_of_release(program, context);
  check_ld_program(program, diagnostics);
  return program;
}

}  // namespace rung
