// SPDX-License-Identifier: Apache-2.0
#include "prove/wide_prover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "prove/core_run.hpp"
#include "prove/questions.hpp"
#include "prove/wide_decode.hpp"
#include "prove/wide_machine.hpp"
#include "prove/wide_places.hpp"

namespace rung::prove {
namespace {

// The core program first, then all steps of the image, then the comparison: on MPU4 each value has
// a place of its own, so nothing has to be compared while it is still there.
class WideProver {
 public:
  WideProver(const image::Image& image, const image::Meaning& meaning, const wide::Machine& machine,
             const ProofOptions& options, Proof& proof)
      : image_(image),
        wide_(*image.wide),
        meaning_(meaning),
        machine_(machine),
        places_(image, meaning, machine),
        start_(terms_),
        solver_(terms_, options.seconds),
        questions_(
            terms_, start_, solver_,
            [this](Place place) { return places_.name(places_.device_at(place)); }, 0, options,
            proof),
        proof_(proof) {}

  void run() {
    const std::size_t first = proof_.findings.size();
    if (const auto problem = places_.check()) {
      questions_.fail(-1, *problem);
    } else {
      prove();
    }
    // A start is of the devices at their places in the rows.
    for (std::size_t i = first; i < proof_.findings.size(); ++i) {
      for (Finding::Value& value : proof_.findings[i].start) {
        value.place.address = places_.rows().at(places_.device_at(value.place));
      }
    }
    proof_.effort = solver_.effort();
    proof_.terms = terms_.size();
  }

 private:
  // What a device holds at the end of the scan on either side.
  struct End {
    Word image, program;
  };

  void prove() {
    for (const core::ConstantWord& word : meaning_.program.constants) {
      start_.fix(places_.in_start(word.device),
                 Terms::constant(static_cast<std::uint16_t>(word.value)));
    }
    std::map<Place, Word> memory = places_.memory(start_);
    const std::vector<Bit> latched = places_.latched(start_);
    meant_ = run_core(meaning_.program, places_.numbers(), terms_, start_, Outside::LowBits);
    Sweep sweep(terms_, solver_);
    WideMachine machine(machine_, wide_, std::move(memory), latched, terms_, sweep);
    for (std::size_t step = 0; step < wide_.code.size(); ++step) {
      const auto code = decode(wide_.code[step], machine_);
      if (!code) {
        questions_.fail(-1, fmt::format("step {}: the code is no instruction", step));
        return;
      }
      machine.step(*code);
    }
    if (!check_writes()) return;
    if (!wide_.merged) compare_writes(machine);
    compare_last_writes(machine);
    check_windows();
    compare_ends(machine);
    if (questions_.full()) return;
    questions_.ask(terms_.differ(meant_.error, machine.error()), 0, -1,
                   "the error flag of a division by 0 differs");
  }

  // ---- the ends of the scan ----

  Word program_end(Device device) {
    const auto found = meant_.writes.find(device);
    if (found == meant_.writes.end()) return start_.at(places_.in_start(device));
    const auto& [action, target] = found->second.back();
    return meant_.actions[action].contents[target];
  }

  // Devices of the compiler's own count if the next scan depends on them: on either side.
  void compare_ends(WideMachine& machine) {
    std::map<Device, End> ends;
    std::vector<Device> open;
    for (const auto& [device, address] : places_.rows()) {
      if (device.kind != DeviceKind::HB && device.kind != DeviceKind::HW) open.push_back(device);
    }
    std::vector<Bit> roots{meant_.error, machine.error()};
    while (!open.empty()) {
      for (const Device device : open) {
        const End end{machine.content({is_word(device), places_.rows().at(device)}),
                      program_end(device)};
        ends[device] = end;
        roots.insert(roots.end(), end.image.begin(), end.image.end());
        roots.insert(roots.end(), end.program.begin(), end.program.end());
      }
      open.clear();
      std::set<Device> needed;
      for (const NodeId node : terms_.cone(roots)) {
        if (!terms_.is_variable(node) || terms_.is_result(node)) continue;
        const auto* owner = start_.owner(node);
        if (owner != nullptr) needed.insert(places_.device_at(owner->first));
      }
      for (const Device device : needed) {
        if (!ends.contains(device) && places_.rows().contains(device)) open.push_back(device);
      }
    }
    for (const auto& [device, end] : ends) {
      if (questions_.full()) return;
      compare_end(device, end);
    }
  }

  void compare_end(Device device, const End& end) {
    const auto written = meant_.writes.find(device);
    const bool is_written = written != meant_.writes.end();
    const Action* last = is_written ? &meant_.actions[written->second.back().first] : nullptr;
    const int lanes = is_word(device) ? machine_.units : machine_.slots;
    const int address = places_.rows().at(device);
    const std::string what =
        fmt::format("{}, in row {}, lane {}, has another value at the end of the scan",
                    places_.name(device), address / lanes, address % lanes);
    const bool holds =
        questions_.ask(terms_.differ(end.image, end.program), is_written ? last->since : 0,
                       is_written ? source_of(*last) : -1, what, end.image.data(),
                       end.program.data(), is_word(device) ? 16 : 1);
    if (!is_written) return;
    proof_.writes += 1;
    proof_.proven += holds ? 1 : 0;
  }

  // What is stored by an index is inside of its window: outside of it nothing else would be the
  // same on both sides.
  void check_windows() {
    for (const Action& action : meant_.actions) {
      if (!action.indexed || questions_.full()) continue;
      questions_.ask(terms_.both(action.condition, inverse(action.inside)), action.since,
                     source_of(action), "a store by an index may be outside of its window");
    }
  }

  // ---- writes, as a trace shows them ----

  std::vector<image::WideWrite> writes_of(int number) const {
    std::vector<image::WideWrite> out;
    for (const image::WideWrite& write : wide_.writes) {
      if (write.device == number) out.push_back(write);
    }
    return out;
  }

  // What is listed last is what the device's place holds in the end.
  void compare_last_writes(WideMachine& machine) {
    for (std::size_t i = 0; i < image_.devices.size() && !questions_.full(); ++i) {
      const image::ImageDevice& device = image_.devices[i];
      const auto writes = writes_of(static_cast<int>(i));
      const bool word = is_word(device.device);
      const Word end = machine.content({word, device.address});
      const Word listed =
          writes.empty() ? start_.at(places_.in_start(device.device))
                         : machine.computed(word, writes.back().step, writes.back().lane).value;
      questions_.ask(terms_.differ(listed, end), 0, source_of(device.device),
                     device.name + " does not end with the last of its writes in traces");
    }
  }

  // Steps and lanes that there are.
  bool check_writes() {
    const auto steps = static_cast<int>(wide_.code.size());
    for (const image::WideWrite& write : wide_.writes) {
      const auto& device = image_.devices.at(static_cast<std::size_t>(write.device));
      const int lanes = is_word(device.device) ? machine_.units : machine_.slots;
      if (write.step < 0 || write.step >= steps || write.lane < 0 || write.lane >= lanes) {
        return questions_.fail(-1, device.name + " is written in a step that is none");
      }
    }
    return true;
  }

  // Of a program compiled without merging every write, in the program's order.
  void compare_writes(const WideMachine& machine) {
    for (std::size_t i = 0; i < image_.devices.size() && !questions_.full(); ++i) {
      const Device device = image_.devices[i].device;
      const auto planned = meant_.writes.find(device);
      auto writes = writes_of(static_cast<int>(i));
      // Of a word those that cannot happen may be left out on either side.
      std::erase_if(writes, [&](const image::WideWrite& write) {
        return is_word(device) && is_never(machine.computed(true, write.step, write.lane).written);
      });
      auto next = writes.begin();
      bool alike = true;
      if (planned != meant_.writes.end()) {
        for (const auto& [action, target] : planned->second) {
          const Action& meant = meant_.actions[action];
          bool holds = false;
          if (is_word(device)) {
            holds = match_word(machine, device, meant, target, next, writes.end());
          } else if (next == writes.end()) {
            missing(device, meant);
          } else {
            holds = match_value(machine, device, meant, target, *next++);
          }
          proof_.writes += 1;
          proof_.proven += holds ? 1 : 0;
          alike &= holds;
          if (!holds) break;
        }
      }
      if (alike && next != writes.end() && !questions_.full()) {
        questions_.fail(source_of(device),
                        fmt::format("step {}: {} is written here, which the program does not",
                                    next->step, places_.name(device)));
      }
    }
  }

  using Next = std::vector<image::WideWrite>::iterator;

  bool is_never(Bit condition) {
    return condition == kFalse ||
           (condition != kTrue && solver_.ask(condition, 0).verdict == Verdict::Never);
  }

  bool missing(Device device, const Action& meant) {
    return questions_.fail(source_of(meant),
                           fmt::format("the image never writes {} here", places_.name(device)));
  }

  bool same_mark(const image::WideWrite& write, Device device, const Action& meant) {
    const core::Op op = meaning_.program.instructions[meant.instruction].op;
    // A look-up computes its bit in every scan.
    const bool quiet = meant.quiet || (!is_word(device) && op != core::Op::Out);
    return write.quiet == quiet ||
           questions_.fail(source_of(meant),
                           fmt::format("step {}: the write of {} is marked otherwise than the "
                                       "program's",
                                       write.step, places_.name(device)));
  }

  // Of a write that is none if it changes nothing only the value counts.
  bool match_value(const WideMachine& machine, Device device, const Action& meant,
                   std::size_t target, const image::WideWrite& write) {
    const bool word = is_word(device);
    const Word& image = machine.computed(word, write.step, write.lane).value;
    const Word& program = meant.contents[target];
    const Bit care = terms_.either(inverse(meant.condition), meant.care);
    return same_mark(write, device, meant) &&
           questions_.ask(terms_.both(care, terms_.differ(image, program)), meant.since,
                          source_of(meant),
                          fmt::format("step {}, lane {}: {} gets another value", write.step,
                                      write.lane, places_.name(device)),
                          image.data(), program.data(), word ? 16 : 1);
  }

  // An access by an index is a write for each device of its window, of which one happens.
  bool match_word(const WideMachine& machine, Device device, const Action& meant,
                  std::size_t target, Next& next, Next end) {
    const Bit condition = meant.indexed ? meant.hits.at(target) : meant.condition;
    if (is_never(condition)) return true;
    const bool loads = meaning_.program.instructions[meant.instruction].op == core::Op::LoadWord;
    if (meant.quiet && !loads && next != end) {
      return match_value(machine, device, meant, target, *next++);
    }
    Bit any = kFalse;
    int step = 0;
    do {
      if (next == end) return missing(device, meant);
      const image::WideWrite& write = *next++;
      step = write.step;
      const Computed& computed = machine.computed(true, write.step, write.lane);
      const std::string where =
          fmt::format("step {}, unit {}: {}", write.step, write.lane, places_.name(device));
      const Bit care = terms_.both(terms_.both(computed.written, condition), meant.care);
      if (!same_mark(write, device, meant) ||
          !questions_.ask(terms_.both(any, computed.written), meant.since, source_of(meant),
                          where + " is written twice") ||
          !questions_.ask(terms_.both(care, terms_.differ(computed.value, meant.value)),
                          meant.since, source_of(meant), where + " gets another value",
                          computed.value.data(), meant.value.data(), 16)) {
        return false;
      }
      any = terms_.either(any, computed.written);
    } while (loads && next != end && !is_never(terms_.both(condition, terms_.differ(any, kTrue))));
    const Bit care = terms_.either(inverse(condition), meant.care);
    return questions_.ask(
        terms_.both(care, terms_.differ(any, condition)), meant.since, source_of(meant),
        fmt::format("step {}: {} is written under another condition", step, places_.name(device)),
        &any, &condition);
  }

  // ---- places in the source ----

  int source_of(const Action& action) const {
    const core::Instruction& instruction = meaning_.program.instructions[action.instruction];
    return meaning_.first_origin + static_cast<int>(instruction.origin);
  }
  // The last instruction that writes it.
  int source_of(Device device) const {
    const auto found = meant_.writes.find(device);
    return found == meant_.writes.end() ? -1
                                        : source_of(meant_.actions[found->second.back().first]);
  }

  const image::Image& image_;
  const image::WideImage& wide_;
  const image::Meaning& meaning_;
  const wide::Machine& machine_;
  WidePlaces places_;
  Terms terms_;
  Start start_;
  Solver solver_;
  Questions questions_;
  Proof& proof_;
  Meant meant_;
};

}  // namespace

void prove_wide(const image::Image& image, const image::Meaning& meaning,
                const ProofOptions& options, Proof& proof) {
  const wide::Machine* machine = wide::find_machine(image.wide->slots);
  if (machine == nullptr) throw std::logic_error("internal error in the proof: no such processor");
  WideProver(image, meaning, *machine, options, proof).run();
}

}  // namespace rung::prove
