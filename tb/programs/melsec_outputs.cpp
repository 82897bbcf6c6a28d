// SPDX-License-Identifier: Apache-2.0
#include "programs/melsec_outputs.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rung {
namespace {

enum class Form : std::uint8_t {
  SourceTarget,  // MOV
  Targets,       // XCH
  Target,        // INC
  Block,         // BMOV
  Fill,          // FMOV
  Three,         // ADD
  TwoOrThree,    // + of q
  Product,       // MUL: the target takes twice the width
  TwoProduct,    // * of q
  Count,         // ROL: target, count below the width
  BitShift,      // SFTL
  WordShift,     // WSFL
  OneBit,        // SFT
  OwnBits,       // BSFL
  OwnWords,      // DSFL
  Compare,       // CMP
  Between,       // ZCP
  Range,         // ZRST
};

constexpr int kFx = 1;
constexpr int kQ = 2;
constexpr int kBoth = kFx | kQ;

struct Row {
  Family family;
  const char* name;
  const char* wide;  // in 32 bits; empty: there is none
  Form form;
  int dialects;
};

// The 32-bit forms of WAND and the like go by two names.
constexpr Row kRows[] = {
    {Family::Moves, "MOV", "DMOV", Form::SourceTarget, kBoth},
    {Family::Moves, "CML", "DCML", Form::SourceTarget, kBoth},
    {Family::Moves, "XCH", "DXCH", Form::Targets, kBoth},
    {Family::Moves, "SWAP", "DSWAP", Form::Target, kBoth},
    {Family::Moves, "BMOV", "", Form::Block, kBoth},
    {Family::Moves, "FMOV", "DFMOV", Form::Fill, kBoth},
    {Family::Arithmetic, "ADD", "DADD", Form::Three, kFx},
    {Family::Arithmetic, "SUB", "DSUB", Form::Three, kFx},
    {Family::Arithmetic, "MUL", "DMUL", Form::Product, kFx},
    {Family::Arithmetic, "DIV", "DDIV", Form::Product, kFx},
    {Family::Arithmetic, "+", "D+", Form::TwoOrThree, kQ},
    {Family::Arithmetic, "-", "D-", Form::TwoOrThree, kQ},
    {Family::Arithmetic, "*", "D*", Form::TwoProduct, kQ},
    {Family::Arithmetic, "/", "D/", Form::TwoProduct, kQ},
    {Family::Arithmetic, "INC", "DINC", Form::Target, kBoth},
    {Family::Arithmetic, "DEC", "DDEC", Form::Target, kBoth},
    {Family::Arithmetic, "NEG", "DNEG", Form::Target, kBoth},
    {Family::Logic, "WAND", "DAND", Form::Three, kFx},
    {Family::Logic, "WAND", "DWAND", Form::Three, kFx},
    {Family::Logic, "WOR", "DOR", Form::Three, kFx},
    {Family::Logic, "WOR", "DWOR", Form::Three, kFx},
    {Family::Logic, "WXOR", "DXOR", Form::Three, kFx},
    {Family::Logic, "WXOR", "DWXOR", Form::Three, kFx},
    {Family::Logic, "WAND", "DAND", Form::TwoOrThree, kQ},
    {Family::Logic, "WAND", "DWAND", Form::TwoOrThree, kQ},
    {Family::Logic, "WOR", "DOR", Form::TwoOrThree, kQ},
    {Family::Logic, "WOR", "DWOR", Form::TwoOrThree, kQ},
    {Family::Logic, "WXOR", "DXOR", Form::TwoOrThree, kQ},
    {Family::Logic, "WXOR", "DWXOR", Form::TwoOrThree, kQ},
    {Family::Logic, "WXNR", "DXNR", Form::TwoOrThree, kQ},
    {Family::Logic, "WXNR", "DWXNR", Form::TwoOrThree, kQ},
    {Family::Shifts, "SFT", "", Form::OneBit, kQ},
    {Family::Shifts, "SFTL", "", Form::BitShift, kBoth},
    {Family::Shifts, "SFTR", "", Form::BitShift, kBoth},
    {Family::Shifts, "BSFL", "", Form::OwnBits, kQ},
    {Family::Shifts, "BSFR", "", Form::OwnBits, kQ},
    {Family::Shifts, "SFL", "", Form::Count, kBoth},
    {Family::Shifts, "SFR", "", Form::Count, kBoth},
    {Family::Shifts, "WSFL", "", Form::WordShift, kBoth},
    {Family::Shifts, "WSFR", "", Form::WordShift, kBoth},
    {Family::Shifts, "DSFL", "", Form::OwnWords, kQ},
    {Family::Shifts, "DSFR", "", Form::OwnWords, kQ},
    {Family::Rotates, "ROL", "DROL", Form::Count, kBoth},
    {Family::Rotates, "ROR", "DROR", Form::Count, kBoth},
    {Family::Rotates, "RCL", "DRCL", Form::Count, kBoth},
    {Family::Rotates, "RCR", "DRCR", Form::Count, kBoth},
    {Family::Ranges, "ZRST", "", Form::Range, kBoth},
    {Family::Codes, "BCD", "DBCD", Form::SourceTarget, kBoth},
    {Family::Codes, "BIN", "DBIN", Form::SourceTarget, kBoth},
    {Family::Compares, "CMP", "DCMP", Form::Compare, kBoth},
    {Family::Compares, "ZCP", "DZCP", Form::Between, kBoth},
};

// What writes outputs; each word family has rows above.
constexpr Family kOutputFamilies[] = {Family::Bits,     Family::Edges,  Family::Timers,
                                      Family::Counters, Family::Moves,  Family::Arithmetic,
                                      Family::Logic,    Family::Shifts, Family::Rotates,
                                      Family::Ranges,   Family::Codes,  Family::Compares};

bool in_dialect(const Row& row, Dialect dialect) {
  return (row.dialects & (dialect == Dialect::Fx ? kFx : kQ)) != 0;
}

bool has_rows(Family family, Dialect dialect) {
  if (family <= Family::Counters) return true;
  for (const Row& row : kRows) {
    if (row.family == family && in_dialect(row, dialect)) return true;
  }
  return false;
}

}  // namespace

MelsecOutputs::MelsecOutputs(RandomSource& random, const RandomMelsecOptions& options,
                             MelsecOperands& operands)
    : random_(random), operands_(operands) {
  for (const Family family : kOutputFamilies) {
    weights_.push_back(has_rows(family, options.dialect) ? options.weight(family) : 0);
  }
  // Something must be left to write.
  weights_.front() = std::max(weights_.front(), 1);
}

std::string MelsecOutputs::output() {
  const Family family = kOutputFamilies[random_.weighted(weights_)];
  switch (family) {
    case Family::Bits:
      return bit();
    case Family::Edges:
      return edge();
    case Family::Timers:
      return timer();
    case Family::Counters:
      return counter();
    default:
      return word(family);
  }
}

std::string MelsecOutputs::bit() {
  const int which = random_.below(100);
  if (which < 60) return "OUT " + operands_.coil(true);
  if (which < 65) return "OUTI " + operands_.coil(true);
  if (which < 82) return "SET " + operands_.coil(true);
  if (which < 97) return "RST " + operands_.coil(true);
  return "RST " + operands_.registers(1, true);
}

std::string MelsecOutputs::edge() {
  const int which = random_.below(100);
  if (which < 35) return "PLS " + operands_.coil(false);
  if (which < 70) return "PLF " + operands_.coil(false);
  if (random_.percent(40)) return "FF " + operands_.coil(false);
  return (operands_.chance(Family::Pulse) ? "ALTP " : "ALT ") + operands_.coil(false);
}

std::string MelsecOutputs::timer() {
  const bool retentive = random_.percent(30);
  const std::string timer = retentive ? operands_.retentive_timer() : operands_.timer();
  if (random_.percent(retentive ? 25 : 10)) return "RST " + timer;
  const char* const name = !operands_.fx() && random_.percent(40) ? "OUTH" : "OUT";
  return fmt::format("{} {} {}", name, timer, operands_.timer_preset());
}

std::string MelsecOutputs::counter() {
  const bool wide = operands_.fx() && random_.percent(40);
  const std::string counter = operands_.counter(wide);
  if (random_.percent(25)) return "RST " + counter;
  return fmt::format("OUT {} {}", counter, operands_.counter_preset(wide));
}

std::string MelsecOutputs::word(Family family) {
  std::vector<const Row*> rows;
  const Dialect dialect = operands_.fx() ? Dialect::Fx : Dialect::Q;
  for (const Row& row : kRows) {
    if (row.family == family && in_dialect(row, dialect)) rows.push_back(&row);
  }
  const Row& row = *rows[static_cast<std::size_t>(random_.below(static_cast<int>(rows.size())))];
  const bool wide = *row.wide != '\0' && operands_.chance(Family::Wide);
  const int width = wide ? 32 : 16;
  std::string text = wide ? row.wide : row.name;
  if (operands_.chance(Family::Pulse)) text += 'P';
  const auto add = [&](const std::string& operand) { text += ' ' + operand; };
  const auto add_number = [&](int number) { text += fmt::format(" K{}", number); };
  const auto sources = [&](int count) {
    for (int i = 0; i < count; ++i) add(operands_.source(width));
  };
  switch (row.form) {
    case Form::SourceTarget:
      sources(1);
      add(operands_.target(width));
      break;
    case Form::Targets:
      add(operands_.target(width));
      add(operands_.target(width));
      break;
    case Form::Target:
      add(operands_.target(width));
      break;
    case Form::Block: {
      const int count = 1 + random_.below(4);
      const int n = 1 + random_.below(4);
      const bool digits = operands_.chance(Family::Digits);
      add(digits && random_.percent(70) ? operands_.digits(n, false)
                                        : operands_.registers(count, false));
      add(digits && random_.percent(70) ? operands_.digits(n, true)
                                        : operands_.registers(count, false));
      add_number(count);
      break;
    }
    case Form::Fill: {
      const int count = 1 + random_.below(3);
      sources(1);
      add(operands_.chance(Family::Digits) ? operands_.digits(1 + random_.below(width / 4), true)
                                           : operands_.registers(count * width / 16, false));
      add_number(count);
      break;
    }
    case Form::Three:
      sources(2);
      add(operands_.target(width));
      break;
    case Form::TwoOrThree:
      sources(1 + random_.below(2));
      add(operands_.target(width));
      break;
    case Form::Product:
      sources(2);
      add(operands_.registers(width / 8, true));
      break;
    case Form::TwoProduct:
      sources(1 + random_.below(2));
      add(operands_.registers(width / 8, true));
      break;
    case Form::Count: {
      // A rotation by the whole width is one for fx only.
      const int most = row.family == Family::Rotates && operands_.fx() ? width : width - 1;
      add(operands_.target(width));
      add_number(random_.below(random_.percent(70) ? 4 : most + 1));
      break;
    }
    case Form::BitShift: {
      const int length = 1 + random_.below(8);
      const int count = 1 + random_.below(length);
      add(operands_.source_bits(count));
      add(operands_.target_bits(length));
      add_number(length);
      add_number(count);
      break;
    }
    case Form::WordShift: {
      const int length = 1 + random_.below(4);
      const int count = 1 + random_.below(length);
      add(operands_.registers(count, false));
      add(operands_.registers(length, false));
      add_number(length);
      add_number(count);
      break;
    }
    case Form::OneBit:
      add(fmt::format("M{}", 1 + random_.below(6)));
      break;
    case Form::OwnBits: {
      const int length = 1 + random_.below(8);
      add(operands_.target_bits(length));
      add_number(length);
      break;
    }
    case Form::OwnWords: {
      const int length = 1 + random_.below(4);
      add(operands_.registers(length, false));
      add_number(length);
      break;
    }
    case Form::Compare:
      sources(2);
      add(operands_.target_bits(3));
      break;
    case Form::Between:
      sources(3);
      add(operands_.target_bits(3));
      break;
    case Form::Range:
      add(operands_.range());
      break;
  }
  return text;
}

}  // namespace rung
