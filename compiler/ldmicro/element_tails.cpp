// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "ldmicro/element.hpp"

namespace rung {
namespace {

// An operand that LDmicro 5 has behind those of 0.1. What has no effect there either, or says what
// 2.3 does anyway, is `neutral`.
struct Tail {
  Op op;
  const char* name;
  std::span<const std::string_view> neutral;  // empty: any
  const char* mend;
};

constexpr std::string_view kZero[] = {"0"};
constexpr std::string_view kOne[] = {"1"};
constexpr std::string_view kRising[] = {"/"};
// 0 is what LDmicro 5 writes unasked; -1 is 2.3's count of scans.
constexpr std::string_view kAdjust[] = {"0", "-1"};
constexpr std::string_view kPercent[] = {"0-100%"};

constexpr const char* kDelay = "change the delay instead, one CYCLE for each 1";
constexpr const char* kStart = "write 0, and set the variable in a first scan with OSR and MOVE";
constexpr const char* kEdge = "write /, and put OSF or a contact before the counter";
constexpr const char* kOneByte = "send and receive one byte at a time: write 1";

// Of one element in their order.
constexpr Tail kTails[] = {
    {Op::And, "start value", kZero, "write 0, and set the bit in a first scan with OSR and a coil"},
    {Op::Out, "T-trigger", kZero, "write 0, and toggle with OSR, a contact and a negated coil"},
    {Op::Ton, "adjustment", kAdjust, kDelay},
    {Op::Tof, "adjustment", kAdjust, kDelay},
    {Op::Rto, "adjustment", kAdjust, kDelay},
    {Op::Ctu, "initial value", kZero, kStart},
    {Op::Ctu, "kind of input", kRising, kEdge},
    {Op::Ctd, "initial value", kZero, kStart},
    {Op::Ctd, "kind of input", kRising, kEdge},
    {Op::Ctc, "initial value", kZero, kStart},
    {Op::Ctc, "kind of input", kRising, kEdge},
    {Op::ReadAdc, "reference voltage", kZero, "write 0: the board has one"},
    {Op::SetPwm, "output", {}, ""},
    {Op::SetPwm, "resolution", kPercent, "write 0-100%, and scale the duty"},
    {Op::UartSend, "size", kOne, kOneByte},
    {Op::UartSend, "wait", kZero, "write 0: a scan does not wait"},
    {Op::UartRecv, "size", kOne, kOneByte},
    {Op::UartRecv, "wait", kZero, "write 0: a scan does not wait"},
    {Op::LookUpTable, "name", {}, ""},
    {Op::PiecewiseLinear, "name", {}, ""},
};

// There is one PWM output; 0.2 names it.
void check_output(LdElement& element, const LdWord& word) {
  std::string& name = element.context().pwm_name;
  if (name.empty()) name = word.text;
  if (name == word.text) return;
  element.refuse(
      word.position,
      fmt::format("SET_PWM: {} is a second output beside {}", shown(word.text), shown(name)),
      "drive one PWM output");
}

}  // namespace

void check_ld_tail(LdElement& element, Op op) {
  // `' '` are two words.
  if (element.left() == 1 && element.peek().text == "'" &&
      element.line().words[element.line().words.size() - 2].text == "'") {
    return;
  }
  const auto* tail = std::begin(kTails);
  while (!element.at_end() && op != Op::Comment) {
    const LdWord& word = element.word();
    tail = std::find_if(tail, std::end(kTails), [&](const Tail& each) { return each.op == op; });
    if (tail == std::end(kTails)) {
      return element.refuse(word.position,
                            fmt::format("{}: more operands than {} takes", shown(word.text),
                                        element.line().keyword()),
                            "remove what does not belong to it");
    }
    const bool neutral =
        tail->neutral.empty() ||
        std::find(tail->neutral.begin(), tail->neutral.end(), word.text) != tail->neutral.end();
    if (!neutral) {
      element.refuse(word.position,
                     fmt::format("{}: {} {} is LDmicro 5's, and changes what 2.3 does",
                                 element.line().keyword(), tail->name, shown(word.text)),
                     tail->mend);
    } else if (op == Op::SetPwm && tail->neutral.empty()) {
      check_output(element, word);
    }
    ++tail;
  }
}

}  // namespace rung
