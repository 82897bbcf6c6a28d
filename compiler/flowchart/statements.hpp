// SPDX-License-Identifier: Apache-2.0
// The lines of a step: read, actions, write, transitions; and, behind a wait, the same again.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flowchart/expression.hpp"
#include "flowchart/flowchart.hpp"
#include "flowchart/names.hpp"

namespace rung::flowchart {

struct Action {
  enum class Kind { Bit, Word, Set, Reset, Start, Stop };
  Kind kind = Kind::Bit;
  SourcePosition position;
  Operand target;
  std::size_t task = 0;      // Start, Stop
  ExpressionPointer source;  // Bit, Word
  ExpressionPointer guard;   // null: always
};

struct Exit {
  enum class Kind {
    Next,  // to what follows in the text
    Stay,  // does it all again
    Step,
    End,
  };
  Kind kind = Kind::Next;
  std::size_t step = 0;  // of the task, counting its named ones
  SourcePosition position;
};

struct Transition {
  ExpressionPointer condition;
  Exit exit;
};

// What stands between waits.
struct Part {
  SourcePosition position;
  std::string text;
  std::optional<Transfer> read, write;
  std::vector<Action> actions;
  std::vector<Transition> whens;
  bool asks_failed = false;  // one of `whens`
  Exit otherwise;
  ExpressionPointer wait_until;  // then `otherwise` is behind it
  int wait_ticks = 0;            // so is it here
  bool wait_tenths = false;      // the ticks are 100 ms
  SourcePosition wait_position;

  bool waits() const { return wait_until || wait_ticks > 0; }
  bool does_something() const { return read || write || !actions.empty() || !whens.empty(); }
};

// Reads the lines of one step one after the other.
class StepReader {
 public:
  struct World {
    Dialect dialect = Dialect::Fx;
    const std::vector<Board>& boards;
    const Names& board_names;
    const Names& tasks;
    const Names& steps;                                // of this task
    const std::map<std::string, std::string>& owners;  // of any: a task that has it
    std::vector<bool>& asked;                          // by task
    std::vector<bool>& started;                        // by task: some step starts it
  };
  StepReader(const World& world, SourcePosition position, std::string text);

  // Throws a Refusal.
  void line(const Line& line);
  // The parts, at least one.
  std::vector<Part> finish();

 private:
  // How far a part has come; a line that belongs before this is refused.
  enum class Phase { Read, Actions, Write, Whens, Done };

  Part& part() { return parts_.back(); }
  void advance(Phase phase, const Token& token);
  void open_part(const Token& token);
  void read_transfer(Cursor& cursor, bool write);
  void check_exclusive(std::size_t board, SourcePosition position) const;
  Device transfer_head(const Token& token, int count) const;
  void command(Cursor& cursor);
  void bit_command(Cursor& cursor);
  void assignment(Cursor& cursor);
  void guard(Cursor& cursor, Action& action);
  void when(Cursor& cursor);
  void wait(Cursor& cursor);
  Exit read_exit(Cursor& cursor);
  Scope scope(std::string no_failed, std::string mend) const;
  Scope action_scope() const;
  void note(const Scope& scope);

  World world_;
  std::vector<Part> parts_;
  std::string text_;
  Phase phase_ = Phase::Read;
  int commands_ = 0;     // starts and stops of the part
  bool closed_ = false;  // by goto or end
  bool waited_ = false;  // the last line was a wait
  int closed_line_ = 0;
  bool transfers_ = false;  // a read or write stands in the part, good or bad
};

}  // namespace rung::flowchart
