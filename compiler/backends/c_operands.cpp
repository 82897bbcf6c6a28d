// SPDX-License-Identifier: Apache-2.0
#include "backends/c_operands.hpp"

#include <algorithm>

#include "rungs/devices.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

using Kind = Operand::Kind;

// INT32_MIN has no literal in C.
std::string literal(std::int32_t value) {
  return value == INT32_MIN ? "(-2147483647 - 1)" : fmt::to_string(value);
}

}  // namespace

std::string_view bare(std::string_view expression) {
  const bool whole = expression.size() > 2 && expression.front() == '(' &&
                     expression.find_first_of("()", 1) == expression.size() - 1;
  return whole ? expression.substr(1, expression.size() - 2) : expression;
}

std::string COperands::bit(std::size_t i) const {
  const Operand& operand = instruction_.operand(i);
  if (operand.kind == Kind::WordBit) {
    return fmt::format("((uint16_t){} >> {} & 1u)", unit_.layout.place(operand.device),
                       operand.bit);
  }
  return place(i);
}

std::string COperands::set_bit(std::size_t i, std::string_view value) const {
  const Operand& operand = instruction_.operand(i);
  if (operand.kind == Kind::WordBit) {
    const std::string word = unit_.layout.place(operand.device);
    return fmt::format("{0} = {1}(((uint16_t){0} & ~(1u << {2})) | (uint32_t)({3}) << {2});", word,
                       unit_.helpers.use(CHelper::Word), operand.bit, value);
  }
  const bool literal = value == "0" || value == "1";
  return fmt::format("{} = {};", place(i),
                     literal ? std::string(value) : fmt::format("(uint8_t)({})", bare(value)));
}

std::string COperands::read_bit(std::size_t i) const {
  if (!instruction_.operand(i).index) return bit(i);
  return fmt::format("({} ? 0u : {})", outside(i, 1), bit(i));
}

std::string COperands::read_value(std::size_t i) const {
  if (!instruction_.operand(i).index) return value(i);
  return fmt::format("({} ? 0 : {})", outside(i, words_of_operand(i)), value(i));
}

std::string COperands::value(std::size_t i, int width) const {
  const Operand& operand = instruction_.operand(i);
  return value_of(operand, places(i, width), width);
}

std::string COperands::value(const Operand& operand, int width) const {
  return value_of(operand, places(operand, width), width);
}

std::string COperands::value_of(const Operand& operand, const std::vector<std::string>& words,
                                int width) const {
  if (operand.kind == Kind::Constant || operand.kind == Kind::Number) {
    return width == 16 ? fmt::to_string(static_cast<std::int16_t>(operand.value))
                       : literal(operand.value);
  }
  if (operand.kind != Kind::Digits) {
    return width == 16
               ? words[0]
               : fmt::format("{}({}, {})", unit_.helpers.use(CHelper::Pair), words[0], words[1]);
  }
  const int count = 4 * operand.digits;
  const std::string number = fmt::format("{}({}, {})", unit_.helpers.use(CHelper::Digits),
                                         unit_.layout.pointer(operand.device), count);
  if (count < width) return "(int32_t)" + number;
  return fmt::format("{}({})", unit_.helpers.use(width == 16 ? CHelper::Word : CHelper::Long),
                     number);
}

void COperands::store(std::size_t i, int width, std::string_view value) const {
  const Operand& operand = instruction_.operand(i);
  if (operand.kind == Kind::Digits) return store(operand, width, value);
  store_words(places(i, width), value);
}

void COperands::store(const Operand& operand, int width, std::string_view value) const {
  if (operand.kind != Kind::Digits) return store_words(places(operand, width), value);
  unit_.body.line("{}({}, {}, {});", unit_.helpers.use(CHelper::SetDigits),
                  unit_.layout.pointer(operand.device), 4 * operand.digits, value);
}

void COperands::store_words(const std::vector<std::string>& words, std::string_view value) const {
  int shift = 0;
  for (const std::string& word : words) {
    const std::string part =
        shift == 0 ? std::string(value) : fmt::format("{} >> {}", value, shift);
    unit_.body.line("{} = {}({});", word, unit_.helpers.use(CHelper::Word),
                    words.size() > 2 ? fmt::format("(uint32_t)({})", part) : part);
    shift += 16;
  }
}

bool COperands::indexed() const {
  return std::any_of(instruction_.operands.begin(), instruction_.operands.end(),
                     [](const Operand& operand) { return operand.index.has_value(); });
}

void COperands::declare_indices() const {
  for (std::size_t i = 0; i < instruction_.operands.size(); ++i) {
    const Operand& operand = instruction_.operand(i);
    if (!operand.index) continue;
    unit_.body.line("const int32_t i{} = {} + {};", i, unit_.layout.number(operand.device),
                    unit_.layout.place(*operand.index));
  }
}

std::string COperands::outside(std::size_t i, int words) const {
  const DeviceKind kind = instruction_.operand(i).device.kind;
  const IndexWindow& window = unit_.layout.window(kind);
  // The window holds the operand itself, and so all of its words.
  const std::uint32_t last = window.last - static_cast<std::uint32_t>(words - 1);
  return fmt::format("i{0} < {1} || i{0} > {2}", i, unit_.layout.number({kind, window.first}),
                     unit_.layout.number({kind, last}));
}

std::string COperands::any_outside() const {
  std::string condition;
  for (std::size_t i = 0; i < instruction_.operands.size(); ++i) {
    if (!instruction_.operand(i).index) continue;
    if (!condition.empty()) condition += " || ";
    condition += outside(i, words_of_operand(i));
  }
  return condition;
}

int COperands::words_of_operand(std::size_t i) const {
  if (!is_word(instruction_.operand(i).device)) return 1;
  const bool result = instruction_.op == Op::Mul || instruction_.op == Op::Div;
  const int width =
      result && i == 2 && instruction_.double_width ? 2 * instruction_.width : instruction_.width;
  return width / 16;
}

std::string COperands::place(std::size_t i) const {
  const Operand& operand = instruction_.operand(i);
  if (!operand.index) return unit_.layout.place(operand.device);
  return fmt::format("@.{}[i{}]", CLayout::array(operand.device.kind), i);
}

std::vector<std::string> COperands::places(std::size_t i, int width) const {
  const Operand& operand = instruction_.operand(i);
  if (!operand.index) return places(operand, width);
  std::vector<std::string> words{place(i)};
  for (int word = 1; word < width / 16; ++word) {
    words.push_back(fmt::format("@.{}[i{} + {}]", CLayout::array(operand.device.kind), i, word));
  }
  return words;
}

std::vector<std::string> COperands::places(const Operand& operand, int width) const {
  std::vector<std::string> words;
  if (operand.kind != Kind::Device) return words;
  for (const Device device : words_of(operand.device, width, unit_.program.dialect)) {
    words.push_back(unit_.layout.place(device));
  }
  return words;
}

}  // namespace rung
