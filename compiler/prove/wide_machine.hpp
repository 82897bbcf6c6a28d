// SPDX-License-Identifier: Apache-2.0
// MPU4 on terms: what each step of its instructions reads and computes, and what its memories hold
// at the end of the scan. Written from hdl/wide/README.md and hdl/isa/wide.toml. Whatever they do
// not define is an unknown value: a row read as it is written, a flag before the first test, a
// result that nothing has started.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "image/wide.hpp"
#include "prove/start.hpp"
#include "prove/sweep.hpp"
#include "wide/code.hpp"

namespace rung::prove {

// Of a bit or a word computed: what it is, and of a word whether the operation has given it.
struct Computed {
  Word value;  // of a bit in bit 0
  Bit written = kTrue;
};

class WideMachine {
 public:
  // `memory`: what places hold before the scan, those of the latch excepted, of which `latched`
  // says by position what they get. Addresses are row * lanes + lane.
  WideMachine(const wide::Machine& machine, const image::WideImage& image,
              std::map<Place, Word> memory, std::vector<Bit> latched, Terms& terms, Sweep& sweep);

  void step(const wide::Step& step);

  // After the last step.
  Word content(Place place);
  const Computed& computed(bool word, int step, int lane) const;
  Bit error() const { return error_; }

 private:
  using Opcode = wide::Opcode;
  struct Product {
    Word low, high;
  };
  struct Quotient {
    Word quotient, remainder;
    Bit by_0 = kFalse;
  };
  // Of LDH and the MULD or DIVD behind it.
  struct Wide {
    int step = 0;  // of MULD or DIVD
    bool divide = false;
    std::vector<Word> words;
    Bit by_0 = kFalse;
    bool disturbed = false;  // what came too early has left nothing that is defined
  };
  struct Unit {
    std::vector<Bit> flags;  // by step: the flag after it
    std::vector<Word> accs;  // by step: acc after it
    Bit flag = kFalse;       // of the last step
    Word acc;
    Bit carry = kFalse;
    std::map<int, Product> products;  // by the step that has started them
    std::map<int, Quotient> quotients;
    int high_step = -1;  // of the last LDH
    Word high1, high2;
    std::vector<Wide> wides;
  };
  // What one word instruction works on.
  struct Job {
    Opcode opcode;
    int unit;
    Word s1, s2;
    Bit gate;
    bool always;
  };

  int lanes(bool word) const { return word ? machine_.units : machine_.slots; }
  int step_of_latch(int row) const;
  bool is_latch(bool word, int row) const;
  Word latched(int row, int lane);
  Word undefined(bool word);
  const Word& before(Place place);
  Word read(const wide::Operand& operand, bool word, int lane);
  Word read_row(const wide::Operand& operand, bool word);
  Bit flag(int unit) const;
  Bit look_up(unsigned table, const std::vector<Bit>& operands, std::size_t from, unsigned address);
  Computed compute(const Job& job, const std::vector<Bit>& beside);
  Computed sum(const Job& job, bool subtract, bool with_carry);
  Computed test(const Job& job, Bit value);
  Computed collect_product(const Job& job);
  Computed collect_quotient(const Job& job);
  Computed collect_wide(const Job& job);
  Computed divided(const Job& job, const Word& value, Bit by_0);
  void start_quotient(const Job& job);
  void start_wide(const Job& job);

  const wide::Machine& machine_;
  const image::WideImage& image_;
  std::map<Place, Word> memory_;
  std::vector<Bit> latched_;
  Terms& t_;
  Sweep& sweep_;
  std::vector<std::vector<Computed>> bits_, words_;  // by step and lane
  std::vector<Unit> units_;
  std::vector<Bit> first_flags_;
  std::vector<Word> first_accs_;
  int step_ = 0;
  Bit error_ = kFalse;
};

}  // namespace rung::prove
