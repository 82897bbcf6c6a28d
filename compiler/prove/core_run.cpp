// SPDX-License-Identifier: Apache-2.0
#include "prove/core_run.hpp"

#include <stdexcept>

namespace rung::prove {
namespace {

using core::Instruction;
using core::Op;

class CoreRun {
 public:
  CoreRun(const core::Program& program, const std::map<Device, int>& places, Terms& terms,
          Start& start, Outside outside)
      : program_(program), places_(places), t_(terms), start_(start), outside_(outside) {}

  Meant run() {
    for (const core::Network& network : program_.networks) {
      since_ = static_cast<NodeId>(t_.size());
      blocks_.clear();
      branches_.clear();
      has_result_ = false;
      for (std::size_t i = 0; i < network.count; ++i) {
        number_ = network.first + i;
        execute(program_.instructions.at(number_));
      }
    }
    return std::move(out_);
  }

 private:
  static void require(bool holds, const char* what) {
    if (!holds) throw std::logic_error(std::string("core program: ") + what);
  }

  Place place(Device device) const { return {is_word(device), places_.at(device)}; }

  Word content(Device device) {
    const auto found = contents_.find(device);
    return found == contents_.end() ? start_.at(place(device)) : found->second;
  }
  Bit bit(Device device) { return content(device)[0]; }
  Word word(const core::WordSource& source) {
    return source.constant ? Terms::constant(static_cast<std::uint16_t>(source.value))
                           : content(source.device);
  }
  std::vector<Word> words(const Instruction& instruction) {
    std::vector<Word> out;
    for (const core::WordSource& source : instruction.sources) out.push_back(word(source));
    return out;
  }

  Bit result() const {
    require(has_result_, "an instruction has no result to work on");
    return result_;
  }
  void set_result(Bit value) {
    result_ = value;
    has_result_ = true;
  }
  static Bit pop(std::vector<Bit>& stack) {
    require(!stack.empty(), "an empty stack is read");
    const Bit top = stack.back();
    stack.pop_back();
    return top;
  }

  void execute(const Instruction& i) {
    switch (i.op) {
      case Op::Nop:
        return;
      case Op::Ld:
      case Op::Ldi:
        // The result before it may be none: nobody then reads it.
        blocks_.push_back(has_result_ ? result_ : kFalse);
        return set_result(bit(i.targets.at(0)) ^ (i.op == Op::Ldi ? 1U : 0U));
      case Op::And:
      case Op::Ani:
        return set_result(t_.both(result(), bit(i.targets.at(0)) ^ (i.op == Op::Ani ? 1U : 0U)));
      case Op::Or:
      case Op::Ori:
        return set_result(t_.either(result(), bit(i.targets.at(0)) ^ (i.op == Op::Ori ? 1U : 0U)));
      case Op::Anb:
        return set_result(t_.both(pop(blocks_), result()));
      case Op::Orb:
        return set_result(t_.either(pop(blocks_), result()));
      case Op::Inv:
        return set_result(inverse(result()));
      case Op::Pop:
        return set_result(pop(blocks_));
      case Op::Mps:
        return branches_.push_back(result());
      case Op::Mrd:
        require(!branches_.empty(), "an empty stack is read");
        return set_result(branches_.back());
      case Op::Mpp:
        return set_result(pop(branches_));
      default:
        return output(i);
    }
  }

  // Every output reads all of its sources before it writes.
  void output(const Instruction& i) {
    const Bit condition = i.always ? kTrue : result();
    const std::vector<Word> s = words(i);
    Bit carry = kFalse;
    switch (i.op) {
      case Op::Out:
        return write(i, kTrue, {bit_word(condition)});
      case Op::Set:
      case Op::Rst:
        return write(i, condition, {bit_word(when(i.op == Op::Set))});
      case Op::Mov:
        return write(i, condition, {s.at(0)});
      case Op::Add:
        return write(i, condition, {t_.add(s.at(0), s.at(1), carry)});
      case Op::Sub:
        return write(i, condition, {t_.subtract(s.at(0), s.at(1), carry)});
      case Op::Wand:
        return write(i, condition, {t_.bitwise(&Terms::both, s.at(0), s.at(1))});
      case Op::Wor:
        return write(i, condition, {t_.bitwise(&Terms::either, s.at(0), s.at(1))});
      case Op::Wxor:
        return write(i, condition, {t_.bitwise(&Terms::differ, s.at(0), s.at(1))});
      case Op::Rol:
        return write(i, condition, {t_.rotate_left(s.at(0), s.at(1))});
      case Op::Minu:
        return write(i, condition, {t_.choose(t_.less(s.at(0), s.at(1)), s.at(0), s.at(1))});
      case Op::Add32:
      case Op::Sub32: {
        const auto step = i.op == Op::Add32 ? &Terms::add : &Terms::subtract;
        const Word low = (t_.*step)(s.at(0), s.at(2), carry);
        return write(i, condition, {low, (t_.*step)(s.at(1), s.at(3), carry)});
      }
      case Op::Mul:
      case Op::Mul32:
        return write(i, condition,
                     t_.call(i.op == Op::Mul ? Function::Multiply16 : Function::Multiply32, s));
      case Op::Div:
      case Op::Div32: {
        const bool wide = i.op == Op::Div32;
        const Bit by_0 = t_.is_zero(std::span(s).subspan(wide ? 2 : 1));
        out_.error = t_.either(out_.error, t_.both(condition, by_0));
        return write(i, t_.both(condition, inverse(by_0)),
                     t_.call(wide ? Function::Divide32 : Function::Divide16, s));
      }
      case Op::Eq:
        return write(i, condition, {bit_word(t_.equal(s.at(0), s.at(1)))});
      case Op::Lt:
        return write(i, condition, {bit_word(t_.less_signed(s.at(0), s.at(1)))});
      case Op::Ltu:
        return write(i, condition, {bit_word(t_.less(s.at(0), s.at(1)))});
      case Op::Lt32:
        carry = t_.less(s.at(0), s.at(2));
        return write(i, condition, {bit_word(t_.less_signed(s.at(1), s.at(3), carry))});
      case Op::Tb:
        return write(i, condition, {bit_word(t_.pick(s.at(0), s.at(1)))});
      case Op::Gather: {
        Word gathered = Terms::constant(0);
        for (std::size_t n = 0; n < i.reads.size(); ++n) gathered.at(n) = bit(i.reads[n]);
        return write(i, condition, {gathered});
      }
      case Op::LoadWord:
        return load(i, condition, s);
      case Op::LoadBit:  // the bit is read whatever the result is, and the write is no gated one
        return load(i, kTrue, s);
      case Op::StoreWord:
      case Op::SetBit:
      case Op::RstBit:
        return store(i, condition, s);
      default:
        require(false, "an instruction without a meaning");
    }
  }

  static Word bit_word(Bit bit) {
    Word out = Terms::constant(0);
    out[0] = bit;
    return out;
  }

  Action action(const Instruction& i, Bit condition, const Word& value) const {
    Action out;
    out.instruction = number_;
    out.condition = condition;
    out.value = value;
    out.quiet = i.quiet;
    out.since = since_;
    return out;
  }

  // The targets get the results from the lowest word on.
  void write(const Instruction& i, Bit condition, const std::vector<Word>& results,
             Bit care = kTrue) {
    for (std::size_t n = 0; n < i.targets.size(); ++n) {
      Action out = action(i, condition, results.at(n));
      out.care = care;
      out.targets = {i.targets[n]};
      out.contents = {t_.choose(condition, out.value, content(i.targets[n]))};
      add(std::move(out));
    }
  }

  void add(Action action) {
    action.word = is_word(action.targets.at(0));
    for (std::size_t n = 0; n < action.targets.size(); ++n) {
      contents_[action.targets[n]] = action.contents[n];
      out_.writes[action.targets[n]].emplace_back(out_.actions.size(), n);
    }
    out_.actions.push_back(std::move(action));
  }

  // The address that an index means; the window has to lie side by side from its head on.
  Word address(const Instruction& i, const std::vector<Device>& window, const Word& index) {
    require(!window.empty() && window.front() == i.head, "a window does not begin at its head");
    const int first = places_.at(i.head);
    for (std::size_t n = 0; n < window.size(); ++n) {
      require(places_.at(window[n]) == first + static_cast<int>(n), "a window has gaps");
    }
    Bit carry = kFalse;
    return t_.add(index, Terms::constant(static_cast<std::uint16_t>(first)), carry);
  }

  // As many of them as it takes to tell the places of the window, and one that is none.
  Bit low_bits_are(const Word& index, std::size_t number, std::size_t size) {
    Bit all = kTrue;
    for (std::size_t bit = 0; size >> bit != 0; ++bit) {
      all = t_.both(all, (number >> bit & 1U) != 0 ? index.at(bit) : inverse(index.at(bit)));
    }
    return all;
  }

  std::vector<Word> contents(const std::vector<Device>& devices) {
    std::vector<Word> out;
    for (const Device device : devices) out.push_back(content(device));
    return out;
  }

  void load(const Instruction& i, Bit condition, const std::vector<Word>& s) {
    const Word at = address(i, i.reads, s.at(0));
    const Selected found = select(t_, at, places_.at(i.head), contents(i.reads));
    if (outside_ == Outside::LowBits) {
      Word value = is_word(i.head) ? content(i.targets.at(0)) : Terms::constant(0);
      for (std::size_t n = 0; n < i.reads.size(); ++n) {
        const Bit hit = t_.both(condition, low_bits_are(s.at(0), n, i.reads.size()));
        value = t_.choose(hit, content(i.reads[n]), value);
      }
      write(i, condition, {value}, found.inside);
      // It is what was there where nothing is loaded.
      if (is_word(i.head)) contents_[i.targets.at(0)] = out_.actions.back().contents[0] = value;
      return;
    }
    Word outside = Terms::constant(0);
    for (std::size_t n = 0; n < (is_word(i.head) ? 16U : 1U); ++n) outside[n] = t_.variable();
    write(i, condition, {t_.choose(found.inside, found.value, outside)}, found.inside);
  }

  void store(const Instruction& i, Bit condition, const std::vector<Word>& s) {
    Action out =
        action(i, condition, i.op == Op::StoreWord ? s.at(1) : bit_word(when(i.op == Op::SetBit)));
    out.indexed = true;
    out.address = address(i, i.targets, s.at(0));
    const int first = places_.at(i.head);
    out.inside = select(t_, out.address, first, contents(i.targets)).inside;
    out.targets = i.targets;
    for (std::size_t n = 0; n < i.targets.size(); ++n) {
      const auto here = static_cast<std::uint16_t>(first + static_cast<int>(n));
      const Bit there = outside_ == Outside::LowBits ? low_bits_are(s.at(0), n, i.targets.size())
                                                     : t_.equal(out.address, Terms::constant(here));
      const Bit hit = t_.both(condition, there);
      out.hits.push_back(hit);
      out.contents.push_back(t_.choose(hit, out.value, content(i.targets[n])));
    }
    add(std::move(out));
  }

  const core::Program& program_;
  const std::map<Device, int>& places_;
  Terms& t_;
  Start& start_;
  Outside outside_;
  std::map<Device, Word> contents_;
  std::vector<Bit> blocks_, branches_;
  Bit result_ = kFalse;
  bool has_result_ = false;
  NodeId since_ = 0;
  std::size_t number_ = 0;
  Meant out_;
};

}  // namespace

Meant run_core(const core::Program& program, const std::map<Device, int>& places, Terms& terms,
               Start& start, Outside outside) {
  return CoreRun(program, places, terms, start, outside).run();
}

}  // namespace rung::prove
