// SPDX-License-Identifier: Apache-2.0
#include "prove/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "prove/core_run.hpp"
#include "prove/decode.hpp"
#include "prove/machine.hpp"
#include "prove/names.hpp"
#include "prove/questions.hpp"
#include "prove/wide_prover.hpp"

namespace rung::prove {
namespace {

// One routine: the core program first, then the image step by step. Each write of the image has to
// be the next one that the program makes of that device. Once proven equal, what the program left
// there is what the image goes on with, so that every proof is about one rung.
class Prover {
 public:
  Prover(const image::Image& image, const Code& code, const image::Meaning& meaning,
         std::size_t number, double seconds, const ProofOptions& options, Proof& proof)
      : image_(image),
        config_(*isa::find_config(image.config)),
        code_(code),
        meaning_(meaning),
        start_(terms_),
        solver_(terms_, seconds),
        questions_(
            terms_, start_, solver_, [this](Place place) { return name(place); }, number, options,
            proof),
        machine_(image.mpu, config_, image.lut, windows(), terms_, start_),
        proof_(proof) {}

  void run() {
    if (!find_owners()) return;
    meant_ = run_core(meaning_.program, meaning_.places, terms_, start_);
    for (const Action& action : meant_.actions) {
      for (const Word& content : action.contents) solver_.cut(content);
      proof_.writes += 1;
    }
    done_.assign(meant_.actions.size(), false);
    for (step_ = meaning_.first_step; step_ < meaning_.end_step && !full(); ++step_) step();
    if (!full()) finish();
    proof_.proven += static_cast<int>(std::count(done_.begin(), done_.end(), true));
    const Effort& effort = solver_.effort();
    proof_.effort.structure += effort.structure;
    proof_.effort.simulation += effort.simulation;
    proof_.effort.solver += effort.solver;
    proof_.terms += terms_.size();
  }

 private:
  // The devices that the program's indices may reach.
  std::vector<Window> windows() const {
    std::map<Place, int> sizes;
    for (const core::Instruction& instruction : meaning_.program.instructions) {
      if (!core::is_indexed(instruction.op)) continue;
      const bool loads =
          instruction.op == core::Op::LoadWord || instruction.op == core::Op::LoadBit;
      const auto& window = loads ? instruction.reads : instruction.targets;
      const auto head = meaning_.places.find(instruction.head);
      if (head == meaning_.places.end()) continue;  // run_core() throws
      int& size = sizes[{is_word(instruction.head), head->second}];
      size = std::max(size, static_cast<int>(window.size()));
    }
    std::vector<Window> out;
    for (const auto& [head, size] : sizes) out.push_back({head.word, head.address, size});
    return out;
  }

  // ---- what is where ----

  bool find_owners() {
    for (const auto& [device, address] : meaning_.places) {
      const Place place{is_word(device), address};
      const int size = place.word ? config_.word_devices : config_.bit_devices;
      if (address < 0 || address >= size || !owners_.emplace(place, device).second) {
        fail(-1, fmt::format("two devices share an address, or it is beyond the memory: {}",
                             name(place)));
        return false;
      }
    }
    for (const image::ImageDevice& device : image_.devices) {
      const auto found = meaning_.places.find(device.device);
      if (found != meaning_.places.end() && found->second == device.address) continue;
      fail(-1, fmt::format("{} is not where the image says", device.name));
      return false;
    }
    return find_given();
  }

  // Words that are written before a scan, or once before the first.
  bool find_given() {
    for (const core::TickWord& word : meaning_.program.ticks) {
      const int address = meaning_.places.at(word.device);
      const auto there = [&](const image::ImageTicks& ticks) {
        return ticks.address == address && ticks.base_us == word.base_us;
      };
      if (std::any_of(image_.ticks.begin(), image_.ticks.end(), there)) continue;
      return fail(-1, fmt::format("{} gets no ticks in the image", name({true, address})));
    }
    for (const core::ConstantWord& word : meaning_.program.constants) {
      const int address = meaning_.places.at(word.device);
      const auto there = [&](const image::ImageConstant& constant) {
        return constant.address == address && constant.value == word.value;
      };
      if (std::any_of(image_.constants.begin(), image_.constants.end(), there)) continue;
      return fail(-1, fmt::format("{} is not the image's constant", name({true, address})));
    }
    return true;
  }

  // Where the controller looks for device ports.
  bool is_port_place(Place place) const {
    return place.word ? place.address >= config_.word_devices - image_.port_words
                      : place.address >= config_.bit_devices - image_.port_bits;
  }

  std::string name(Place place) const { return place_name(place, owners_, image_); }

  // ---- the image ----

  void step() {
    std::vector<isa::SlotInstruction> instructions;
    for (const std::uint64_t bits : code_.at(static_cast<std::size_t>(step_))) {
      const auto instruction = prove::decode(bits, image_.mpu, config_);
      if (!instruction) {
        fail(-1, fmt::format("step {}: the code {:x} is no instruction", step_, bits));
        return;
      }
      instructions.push_back(*instruction);
    }
    const std::vector<Write> writes = machine_.step(instructions);
    if (writes.size() == 2 && writes[0].word == writes[1].word) {
      ask(both_hit(writes[0], writes[1]), 0, origin(1),
          fmt::format("step {}: both slots write one device", step_));
    }
    for (const Write& write : writes) {
      if (full()) return;
      if (write.indexed) {
        store(write);
      } else {
        match(write);
      }
    }
  }

  Bit both_hit(const Write& a, const Write& b) {
    const auto where = [](const Write& write) {
      return write.indexed ? write.at : Terms::constant(static_cast<std::uint16_t>(write.address));
    };
    return terms_.both(terms_.both(a.condition, b.condition), terms_.equal(where(a), where(b)));
  }

  int origin(std::size_t slot) const {
    return image_.origins.at(static_cast<std::size_t>(step_)).at(slot);
  }
  bool is_quiet(std::size_t slot) const {
    return image_.quiet.at(static_cast<std::size_t>(step_)).at(slot) != 0;
  }

  void match(const Write& write) {
    const Place place{write.word, write.address};
    const auto owner = owners_.find(place);
    const Word behind = terms_.choose(write.condition, write.value, machine_.content(place));
    if (owner == owners_.end()) {
      // A temporary of the image's own: bits that neither a device nor a port has.
      if (place.word || is_port_place(place)) {
        fail(origin(write.slot), fmt::format("step {}: {} is written, which is no device of the "
                                             "program",
                                             step_, name(place)));
      }
      machine_.put(place, behind);
      return;
    }
    const auto planned = next(owner->second);
    if (!planned || meant_.actions[planned->first].indexed) {
      fail(origin(write.slot),
           fmt::format("step {}: {} is written here, which the program does not", step_,
                       name(place)));
      machine_.put(place, behind);
      return;
    }
    const Action& action = meant_.actions[planned->first];
    ++next_[owner->second];
    if (compare(write, action, name(place))) done_[planned->first] = true;
    machine_.put(place, action.contents[0]);
  }

  std::optional<std::pair<std::size_t, std::size_t>> next(Device device) {
    const auto found = meant_.writes.find(device);
    const std::size_t count = next_[device];
    if (found == meant_.writes.end() || count >= found->second.size()) return std::nullopt;
    return found->second[count];
  }

  // The questions of one write. What is compared where nothing is written, or any value will do,
  // is left out.
  bool compare(const Write& write, const Action& action, const std::string& device) {
    const int at = source_of(action);
    bool holds = true;
    if (is_quiet(write.slot) != action.quiet) {
      holds =
          fail(at, fmt::format("step {}: the write of {} is marked otherwise than the program's",
                               step_, device));
    }
    holds &= ask(terms_.differ(write.condition, action.condition), action.since, at,
                 fmt::format("step {}: {} is written under another condition", step_, device),
                 &write.condition, &action.condition);
    const Bit care = terms_.both(action.condition, action.care);
    holds &= ask(terms_.both(care, terms_.differ(write.value, action.value)), action.since, at,
                 fmt::format("step {}: {} gets another value", step_, device), write.value.data(),
                 action.value.data(), action.word ? 16 : 1);
    return holds;
  }

  // A store through ix: the next write of every device in the window.
  void store(const Write& write) {
    const Window* window =
        write.address < 0 ? nullptr : machine_.window_at(write.word, write.address);
    if (window == nullptr) {
      fail(origin(write.slot), fmt::format("step {}: a store through an index of which nobody "
                                           "knows where it may lead",
                                           step_));
      return;
    }
    std::optional<std::size_t> all;
    for (int n = 0; n < window->size; ++n) {
      const auto owner = owners_.find({write.word, window->first + n});
      const auto planned = owner == owners_.end() ? std::nullopt : next(owner->second);
      if (!planned || (all && *all != planned->first) || !meant_.actions[planned->first].indexed) {
        fail(origin(write.slot),
             fmt::format("step {}: an indexed store may change {} here, which the program does not",
                         step_, name({write.word, window->first + n})));
        return;
      }
      all = planned->first;
    }
    const Action& action = meant_.actions[*all];
    const std::string device = name({write.word, window->first}) + " with an index";
    const int at = source_of(action);
    bool holds = compare(write, action, device);
    holds &= ask(terms_.both(action.condition, terms_.differ(write.at, action.address)),
                 action.since, at, fmt::format("step {}: {} is another device", step_, device));
    holds &= ask(terms_.both(action.condition, inverse(action.inside)), action.since, at,
                 fmt::format("step {}: {} may be outside of its window", step_, device));
    done_[*all] = holds;
    for (std::size_t n = 0; n < action.targets.size(); ++n) {
      ++next_[action.targets[n]];
      machine_.put({write.word, window->first + static_cast<int>(n)}, action.contents[n]);
    }
  }

  // All writes are there, and so is the error.
  void finish() {
    for (const auto& [device, writes] : meant_.writes) {
      if (full()) return;
      if (next_[device] >= writes.size()) continue;
      const Action& action = meant_.actions[writes[next_[device]].first];
      fail(source_of(action), fmt::format("the image never writes {} here",
                                          name({is_word(device), meaning_.places.at(device)})));
    }
    ask(terms_.differ(meant_.error, machine_.error()), 0, -1,
        "the error flag of a division by 0 differs");
  }

  // ---- questions and findings ----

  int source_of(const Action& action) const {
    const core::Instruction& instruction = meaning_.program.instructions[action.instruction];
    return meaning_.first_origin + static_cast<int>(instruction.origin);
  }

  bool ask(Bit bad, NodeId since, int source, const std::string& what, const Bit* image = nullptr,
           const Bit* program = nullptr, std::size_t bits = 1) {
    return questions_.ask(bad, since, source, what, image, program, bits);
  }
  bool fail(int source, std::string what) { return questions_.fail(source, std::move(what)); }
  bool full() const { return questions_.full(); }

  const image::Image& image_;
  const isa::Config& config_;
  const Code& code_;
  const image::Meaning& meaning_;
  Terms terms_;
  Start start_;
  Solver solver_;
  Questions questions_;
  Machine machine_;
  Proof& proof_;
  std::map<Place, Device> owners_;
  Meant meant_;
  std::map<Device, std::size_t> next_;
  std::vector<bool> done_;
  int step_ = 0;
};

double since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Code code_of(const image::Image& image) {
  const isa::Config& config = *isa::find_config(image.config);
  Code out;
  for (const auto& step : image.steps) {
    auto& slots = out.emplace_back();
    for (const auto& instruction : step) {
      slots.push_back(isa::encode(instruction, image.mpu, config));
    }
  }
  return out;
}

Proof prove(const image::Image& image, const Code& code, std::span<const image::Meaning> meanings,
            const ProofOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Proof proof;
  if (image.wide) {
    prove_wide(image, meanings.front(), options, proof);
    proof.seconds = since(begin);
    return proof;
  }
  int step = 0;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    if (meanings[i].first_step != step) {
      throw std::logic_error("internal error in the proof: steps that no routine has");
    }
    step = meanings[i].end_step;
    Prover(image, code, meanings[i], i, options.seconds - since(begin), options, proof).run();
  }
  if (step != static_cast<int>(code.size())) {
    throw std::logic_error("internal error in the proof: steps that no routine has");
  }
  proof.seconds = since(begin);
  return proof;
}

Proof prove(const image::Image& image, std::span<const image::Meaning> meanings,
            const ProofOptions& options) {
  return prove(image, image.wide ? Code{} : code_of(image), meanings, options);
}

}  // namespace rung::prove
