// SPDX-License-Identifier: Apache-2.0
#include "rungs/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace rung {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
// fx: a jump to this pointer ends the scan.
constexpr int kEndPointer = 63;

// How deep FOR may nest, and CALL (the makers' programming manuals).
int nesting_limit(Dialect dialect) { return dialect == Dialect::Q ? 16 : 5; }

// What is open around an instruction: the FOR, MC or STL that opened the innermost of it, and the
// place around that.
struct Scope {
  std::size_t opener = kNone;
  std::size_t outer = kNone;  // index of a Scope
  int level = 0;              // of an MC
};

class Flow {
 public:
  Flow(Program& program, Diagnostics& diagnostics)
      : program_(program), code_(program.instructions), diagnostics_(diagnostics) {}

  void resolve() {
    collect_labels();
    walk();
    for (std::size_t i = 0; i < code_.size(); ++i) {
      if (code_[i].op == Op::Cj) jump(i);
      if (code_[i].op == Op::Call) call(i);
    }
    // What follows would only repeat these faults, or not end.
    if (errors_ > 0 || !check_depth()) return;
    check_size();
  }

 private:
  void error(std::size_t at, std::string what, std::string mend) {
    ++errors_;
    diagnostics_.error(program_.file, code_[at].position, std::move(what), std::move(mend));
  }

  void collect_labels() {
    for (std::size_t i = 0; i < code_.size(); ++i) {
      if (code_[i].op != Op::Label) continue;
      const int pointer = code_[i].operand(0).value;
      if (pointer == kEndPointer && program_.dialect != Dialect::Q) {
        error(i, "P63: on an FX this pointer is END itself and labels nothing else",
              "give the label another number");
      }
      const auto [found, is_new] = labels_.try_emplace(pointer, i);
      if (is_new) continue;
      error(i,
            fmt::format("P{}: this label stands at line {} already", pointer,
                        code_[found->second].position.line),
            "give one of the two another number");
    }
  }

  // --- zones, loops, states and routines ---

  void walk() {
    scope_of_.assign(code_.size(), kNone);
    routine_of_.assign(code_.size(), 0);
    for (std::size_t i = 0; i < code_.size(); ++i) {
      if (code_[i].op == Op::Next || code_[i].op == Op::Mcr || code_[i].op == Op::Ret) close(i);
      if (code_[i].op == Op::Stl) open_state(i);
      scope_of_[i] = scope_;
      routine_of_[i] = routine_;
      if (code_[i].op == Op::For) open_loop(i);
      if (code_[i].op == Op::Mc) open_zone(i);
      if (code_[i].op == Op::Fend || code_[i].op == Op::Sret) end_routine(i);
    }
    close_all("the end of the program");
  }

  Op opener_op() const { return scope_ == kNone ? Op::Nop : code_[scopes_[scope_].opener].op; }

  void open(std::size_t at, int level = 0) {
    scopes_.push_back({at, scope_, level});
    scope_ = scopes_.size() - 1;
    ++depths_open_[code_[at].op];
  }
  void leave() {
    --depths_open_[opener_op()];
    scope_ = scopes_[scope_].outer;
  }

  int depth_of(Op op) const {
    const auto found = depths_open_.find(op);
    return found == depths_open_.end() ? 0 : found->second;
  }

  void open_loop(std::size_t at) {
    if (depth_of(Op::Stl) > 0) {
      error(at, "FOR within the state of an STL, which is not supported",
            "put the loop outside of the state, or write its body as often as it runs");
    }
    open(at);
    const int limit = nesting_limit(program_.dialect);
    if (depth_of(Op::For) > limit) {
      error(at,
            fmt::format("FOR opens loop {}, but {} nests at most {}", depth_of(Op::For),
                        dialect_name(program_.dialect), limit),
            "put the inner loops into a subroutine");
    }
  }

  void open_zone(std::size_t at) {
    const int level = code_[at].operand(0).value;
    const int next = depth_of(Op::Mc);
    if (depth_of(Op::Stl) > 0) {
      error(at, "MC within the state of an STL, which an FX does not allow",
            "put the zone's condition into each network of the state");
    } else if (level != next) {
      error(
          at,
          next == 0 ? fmt::format("MC N{}: no zone is open here, so that this one is N0", level)
                    : fmt::format("MC N{}: the zones N0 to N{} are open here, so that this one is "
                                  "N{}",
                                  level, next - 1, next),
          level < next ? fmt::format("close the zones from N{} on with MCR N{} first", level, level)
                       : fmt::format("write MC N{} and MCR N{}", next, next));
    }
    open(at, level);
  }

  void open_state(std::size_t at) {
    if (opener_op() == Op::Stl) leave();
    if (depth_of(Op::For) > 0) {
      error(at, "STL within a loop: a state has one place in the scan",
            "put the state outside of FOR and NEXT");
    } else if (routine_ != 0) {
      error(at, "STL outside of the main program", "put states before FEND");
    }
    open(at);
  }

  void close(std::size_t at) {
    const Op op = code_[at].op;
    const Op opener = op == Op::Next ? Op::For : op == Op::Ret ? Op::Stl : Op::Mc;
    const std::string_view name = op == Op::Next ? "NEXT" : op == Op::Ret ? "RET" : "MCR";
    const std::string_view opener_name = op == Op::Next ? "FOR" : op == Op::Ret ? "STL" : "MC";
    if (depth_of(opener) == 0) {
      error(at, fmt::format("{} without {}: none is open here", name, opener_name),
            fmt::format("put {} where it begins, or remove this", opener_name));
      return;
    }
    if (opener_op() != opener) {
      const std::size_t inner = scopes_[scope_].opener;
      error(at,
            fmt::format("{} here, where the {} of line {} is still open", name, opener_text(inner),
                        code_[inner].position.line),
            "close what is inside first");
      while (opener_op() != opener) leave();
    }
    if (op == Op::Mcr) return close_zones(at);
    if (op == Op::Next) {
      code_[at].destination = scopes_[scope_].opener;
      code_[scopes_[scope_].opener].destination = at;
    }
    leave();
  }

  // MCR closes its own level and deeper ones.
  void close_zones(std::size_t at) {
    const int level = code_[at].operand(0).value;
    if (level >= depth_of(Op::Mc)) {
      error(at, fmt::format("MCR N{}: no zone of this level is open here", level),
            fmt::format("write MCR N{}", depth_of(Op::Mc) - 1));
      return leave();
    }
    while (opener_op() == Op::Mc && scopes_[scope_].level > level) leave();
    if (opener_op() == Op::Mc) return leave();
    const std::size_t inner = scopes_[scope_].opener;
    error(at,
          fmt::format("MCR here, where the {} of line {} is still open", opener_text(inner),
                      code_[inner].position.line),
          "close what is inside first");
    while (depth_of(Op::Mc) > level) leave();
  }

  std::string_view opener_text(std::size_t at) const {
    return code_[at].op == Op::For ? "FOR" : code_[at].op == Op::Mc ? "MC" : "STL";
  }

  void end_routine(std::size_t at) {
    const bool is_main = routine_ == 0;
    if (code_[at].op == Op::Sret && is_main) {
      error(at, "SRET without a subroutine: this is the main program",
            "end the main program with FEND and put the subroutine, with its label, behind it");
      return;
    }
    close_all(code_[at].op == Op::Fend ? "FEND" : "SRET");
    ends_.push_back(at);
    ++routine_;
  }

  void close_all(std::string_view where) {
    for (; scope_ != kNone; leave()) {
      const std::size_t opener = scopes_[scope_].opener;
      const std::string_view name = opener_text(opener);
      const std::string_view closer = name == "FOR" ? "NEXT" : name == "MC" ? "MCR" : "RET";
      error(opener, fmt::format("{} without {}: it is still open at {}", name, closer, where),
            fmt::format("put {} where it ends", closer));
    }
  }

  // --- jumps and calls ---

  std::optional<std::size_t> label_of(std::size_t at, std::string_view name) {
    const int pointer = code_[at].operand(0).value;
    const auto found = labels_.find(pointer);
    if (found != labels_.end()) return found->second;
    error(at, fmt::format("{} P{}: there is no label P{}", name, pointer, pointer),
          fmt::format("put P{} before the instruction it leads to", pointer));
    return std::nullopt;
  }

  void jump(std::size_t at) {
    const int pointer = code_[at].operand(0).value;
    if (pointer == kEndPointer && program_.dialect != Dialect::Q) {
      code_[at].destination = code_.size();
      if (routine_of_[at] == 0 && scope_of_[at] == kNone) return;
      error(at, "CJ P63: END from within a subroutine, loop, zone or state is not supported",
            "jump to a label at its end");
      return;
    }
    const auto label = label_of(at, "CJ");
    if (!label) return;
    code_[at].destination = *label;
    if (*label < at) {
      error(at,
            fmt::format("CJ P{}: a backward jump, to line {}: the scan would not be constant",
                        pointer, code_[*label].position.line),
            "use FOR with a constant count, or let the next scan go on");
    } else if (routine_of_[*label] != routine_of_[at]) {
      error(at, fmt::format("CJ P{}: leads out of its routine, over FEND or SRET", pointer),
            "a subroutine is entered by CALL");
    } else if (scope_of_[*label] != scope_of_[at]) {
      error(at,
            fmt::format("CJ P{}: leads {} a loop, a zone of MC or the state of an STL", pointer,
                        is_within(scope_of_[at], scope_of_[*label]) ? "out of" : "into"),
            "jump within it, or over the whole of it");
    }
  }

  bool is_within(std::size_t scope, std::size_t outer) const {
    while (scope != kNone && scope != outer) scope = scopes_[scope].outer;
    return scope == outer;
  }

  void call(std::size_t at) {
    const auto label = label_of(at, "CALL");
    if (!label) return;
    code_[at].destination = *label;
    const int pointer = code_[at].operand(0).value;
    if (routine_of_[*label] == 0) {
      if (!calls_main_.insert({*label, at}).second) return;
      const bool has_fend = !ends_.empty();
      error(at,
            fmt::format("CALL P{}: the label, at line {}, is in the main program", pointer,
                        code_[*label].position.line),
            has_fend ? "put the subroutine behind FEND"
                     : "end the main program with FEND, before its first subroutine");
      return;
    }
    if (scope_of_[*label] != kNone) {
      error(at, fmt::format("CALL P{}: leads into a loop or a zone of MC", pointer),
            "put the label before it");
      return;
    }
    const std::size_t end = end_of(*label);
    if (end != kNone && code_[end].op == Op::Sret) return;
    if (!no_sret_.insert({*label, at}).second) return;
    error(*label, fmt::format("P{}: this subroutine has no SRET", pointer),
          "end it with SRET, before the next label that is called and before END");
    diagnostics_.note(program_.file, code_[at].position,
                      fmt::format("P{} is called here", pointer));
  }

  // The FEND or SRET that ends the routine of instruction `at`, or kNone.
  std::size_t end_of(std::size_t at) const {
    const auto found = std::lower_bound(ends_.begin(), ends_.end(), at);
    return found == ends_.end() ? kNone : *found;
  }

  // --- depth and size ---

  // How deep calls nest below the instructions from `first` up to the end of their routine; nothing
  // after an error.
  std::optional<int> call_depth(std::size_t first) {
    const auto known = depths_.find(first);
    if (known != depths_.end()) return known->second;
    calling_.push_back(first);
    const std::size_t end = std::min(end_of(first), code_.size());
    int deepest = 0;
    for (std::size_t i = first; i < end; ++i) {
      if (code_[i].op != Op::Call) continue;
      const std::size_t label = code_[i].destination;
      if (std::find(calling_.begin(), calling_.end(), label) != calling_.end()) {
        error(i,
              fmt::format("CALL P{}: recursion: P{} is being called already",
                          code_[i].operand(0).value, code_[i].operand(0).value),
              "a constant scan has no recursion: use FOR with a constant count");
        return std::nullopt;
      }
      const auto below = call_depth(label);
      if (!below) return std::nullopt;
      deepest = std::max(deepest, 1 + *below);
      const int limit = nesting_limit(program_.dialect);
      if (static_cast<int>(calling_.size()) - 1 + 1 + *below > limit) {
        error(i,
              fmt::format("CALL P{}: with it, calls nest more than the {} deep that {} allows",
                          code_[i].operand(0).value, limit, dialect_name(program_.dialect)),
              "write a subroutine's instructions where it is called");
        return std::nullopt;
      }
    }
    calling_.pop_back();
    depths_.emplace(first, deepest);
    return deepest;
  }

  bool check_depth() {
    for (std::size_t i = 0; i < code_.size(); ++i) {
      const bool begins = i == 0 || (code_[i].op == Op::Label && routine_of_[i] != 0);
      if (begins && !call_depth(i)) return false;
    }
    return true;
  }

  // Instructions from `first` to before `end`, loops and calls written out; at most one more than
  // the limit.
  std::int64_t expanded(std::size_t first, std::size_t end) {
    std::int64_t size = 0;
    for (std::size_t i = first; i < end && size <= kMostExpandedInstructions; ++i) {
      std::int64_t own = 1;
      if (code_[i].op == Op::For) {
        own = code_[i].operand(0).value * expanded(i + 1, code_[i].destination);
      } else if (code_[i].op == Op::Call) {
        own = subroutine_size(code_[i].destination);
      }
      size += own;
      if (size > kMostExpandedInstructions && too_large_ == kNone) too_large_ = i;
      if (code_[i].op == Op::For) i = code_[i].destination;
    }
    return std::min(size, kMostExpandedInstructions + 1);
  }

  std::int64_t subroutine_size(std::size_t label) {
    const auto known = sizes_.find(label);
    if (known != sizes_.end()) return known->second;
    const std::int64_t size = expanded(label, end_of(label));
    sizes_.emplace(label, size);
    return size;
  }

  void check_size() {
    const bool flat = std::none_of(code_.begin(), code_.end(), [](const Instruction& each) {
      return each.op == Op::For || each.op == Op::Call;
    });
    const std::size_t end = std::min(end_of(0), code_.size());
    if (flat || expanded(0, end) <= kMostExpandedInstructions) return;
    error(too_large_,
          fmt::format("with loops and subroutines written out, which is how a constant scan runs "
                      "them, the program has more than {} instructions here",
                      kMostExpandedInstructions),
          "let loops run less often");
  }

  Program& program_;
  std::vector<Instruction>& code_;
  Diagnostics& diagnostics_;
  int errors_ = 0;
  std::map<int, std::size_t> labels_;
  std::vector<Scope> scopes_;
  std::size_t scope_ = kNone;
  std::map<Op, int> depths_open_;                            // of FOR, MC, STL
  std::vector<std::size_t> scope_of_;                        // of each instruction
  std::size_t routine_ = 0;                                  // 0 is the main program
  std::vector<std::size_t> routine_of_;                      // of each instruction
  std::vector<std::size_t> ends_;                            // FEND and SRET, ascending
  std::map<std::size_t, std::size_t> calls_main_, no_sret_;  // label: the first call of it
  std::vector<std::size_t> calling_;
  std::map<std::size_t, int> depths_;
  std::map<std::size_t, std::int64_t> sizes_;
  std::size_t too_large_ = kNone;
};

}  // namespace

void resolve_flow(Program& program, Diagnostics& diagnostics) {
  Flow(program, diagnostics).resolve();
}

}  // namespace rung
