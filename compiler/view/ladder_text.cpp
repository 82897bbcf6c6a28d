// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "view/terminal.hpp"

namespace rung::view {
namespace {

constexpr int kCell = 12;   // characters of a column
constexpr int kLeft = 6;    // before the left rail: the rung's number
constexpr int kHeight = 3;  // lines of a row: names, wire, values

struct Glyph {
  char32_t c = U' ';
  bool on = false;
};

std::u32string decoded(const std::string& text) {
  std::u32string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t c = length == 1 ? lead : lead & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k) {
      c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    }
    result += c;
    i += length;
  }
  return result;
}

void encode(char32_t c, std::string& out) {
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += {static_cast<char>(0xC0 | c >> 6), static_cast<char>(0x80 | (c & 0x3F))};
  } else if (c < 0x10000) {
    out += {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F)),
            static_cast<char>(0x80 | (c & 0x3F))};
  } else {
    out += {static_cast<char>(0xF0 | c >> 18), static_cast<char>(0x80 | (c >> 12 & 0x3F)),
            static_cast<char>(0x80 | (c >> 6 & 0x3F)), static_cast<char>(0x80 | (c & 0x3F))};
  }
}

std::string_view shape(Sign sign) {
  switch (sign) {
    case Sign::Contact:
      return "] [";
    case Sign::ContactNot:
      return "]/[";
    case Sign::ContactUp:
      return "]^[";
    case Sign::ContactDown:
      return "]v[";
    case Sign::Invert:
      return "/";
    case Sign::EdgeUp:
      return "^";
    case Sign::EdgeDown:
      return "v";
    case Sign::Coil:
      return "( )";
    case Sign::CoilNot:
      return "(/)";
    case Sign::CoilSet:
      return "(S)";
    case Sign::CoilReset:
      return "(R)";
    case Sign::CoilUp:
      return "(^)";
    case Sign::CoilDown:
      return "(v)";
    case Sign::CoilToggle:
      return "(~)";
    case Sign::Open:
      return "+  +";
    default:
      return "";
  }
}

bool is_boxed(Sign sign) {
  return sign == Sign::Box || sign == Sign::Mark || sign == Sign::Compare;
}

// One rung on a canvas of characters.
class Canvas {
 public:
  Canvas(const Run& run, const RungView& rung)
      : run_(run),
        rung_(rung),
        width_(kLeft + 1 + rung.grid.columns * kCell + 1),
        lines_(static_cast<std::size_t>(rung.grid.rows * kHeight),
               std::vector<Glyph>(static_cast<std::size_t>(width_))) {}

  std::vector<std::vector<Glyph>> draw(int number) {
    const bool rail = on(rung_.grid.rail);
    for (int line = 0; line < static_cast<int>(lines_.size()); ++line) {
      put(line, kLeft, U'|', rail);
      put(line, width_ - 1, U'|', rail);
    }
    write(1, 0, fmt::format("{:>5}", number), false);
    for (const Wire& wire : rung_.grid.wires) {
      fill(wire.row, x(wire.from), x(wire.to), on(wire.net));
    }
    for (std::size_t i = 0; i < rung_.symbols.size(); ++i) {
      element(rung_.grid.elements[i], rung_.symbols[i]);
    }
    for (const Upright& each : rung_.grid.uprights) upright(each);
    for (const Turn& turn : rung_.grid.turns) {
      const std::string mark = fmt::format(">{}", turn.number);
      write(line_of(turn.from_row), x(turn.from_column) - 2, mark, on(turn.net));
      write(line_of(turn.to_row), kLeft - 2, mark, on(turn.net));
    }
    return std::move(lines_);
  }

 private:
  static int line_of(int row) { return row * kHeight + 1; }
  static int x(int column) { return kLeft + 1 + column * kCell; }
  bool on(Net net) const { return run_.power()[static_cast<std::size_t>(net)]; }

  void put(int line, int at, char32_t c, bool power) {
    if (line < 0 || line >= static_cast<int>(lines_.size()) || at < 0 || at >= width_) return;
    lines_[static_cast<std::size_t>(line)][static_cast<std::size_t>(at)] = {c, power};
  }
  void write(int line, int at, const std::string& text, bool power) {
    for (const char32_t c : decoded(text)) put(line, at++, c, power);
  }
  void fill(int row, int from, int to, bool power) {
    for (int at = from; at < to; ++at) put(line_of(row), at, power ? U'=' : U'-', power);
  }

  void upright(const Upright& each) {
    const int at = x(each.column);
    for (int line = line_of(each.from); line <= line_of(each.to); ++line) {
      const bool row = line % kHeight == 1;
      put(line, at, row ? U'+' : U'|', on(each.net));
    }
  }

  // Of two lines of text the middle ones.
  void centre(int line, int from, int width, const std::string& text, bool power) {
    const int length = std::min(static_cast<int>(decoded(text).size()), width);
    int at = from + (width - length) / 2;
    int left = length;
    for (const char32_t c : decoded(text)) {
      if (left-- == 0) break;
      put(line, at++, c, power);
    }
  }

  void element(const Placed& placed, const Symbol& symbol) {
    const int from = x(placed.column), width = placed.width * kCell;
    const bool in = on(placed.in), out = on(placed.out);
    const bool ends = placed.in == placed.out;
    fill(placed.row, from, from + width / 2, in);
    fill(placed.row, from + width / 2, from + width, out);
    const int line = line_of(placed.row);
    if (is_boxed(symbol.sign)) {
      const auto text = decoded(symbol.text);
      const int room = width - 4;
      std::string shown = symbol.text;
      if (static_cast<int>(text.size()) > room) {
        shown.clear();
        for (int i = 0; i < room - 1; ++i) encode(text[static_cast<std::size_t>(i)], shown);
        shown += "~";
      }
      centre(line, from, width, "[" + shown + "]", ends ? in : out);
      values(symbol, line + 1, from, width);
      return;
    }
    centre(line, from, width, std::string(shape(symbol.sign)), ends ? in : out);
    if (!symbol.text.empty()) {
      const int device = symbol.devices.empty() ? -1 : run_.view().find(symbol.devices.front());
      const bool forced = device >= 0 && run_.forced().contains(device);
      const bool set = device >= 0 && run_.values()[static_cast<std::size_t>(device)] != 0;
      centre(line - 1, from, width - 1, (forced ? "!" : "") + symbol.text, set);
    }
  }

  void values(const Symbol& symbol, int line, int from, int width) {
    std::string text;
    for (const Device device : symbol.devices) {
      const int index = run_.view().find(device);
      if (index < 0) continue;
      if (!text.empty()) text += ' ';
      text += fmt::format("{}={}", run_.view().devices()[static_cast<std::size_t>(index)].name,
                          run_.values()[static_cast<std::size_t>(index)]);
    }
    centre(line, from, width - 1, text, false);
  }

  const Run& run_;
  const RungView& rung_;
  int width_;
  std::vector<std::vector<Glyph>> lines_;
};

std::string text_of(const std::vector<Glyph>& line, TextStyle style) {
  std::string text;
  bool lit = false;
  std::size_t end = line.size();
  while (end > 0 && line[end - 1].c == U' ') --end;
  for (std::size_t i = 0; i < end; ++i) {
    if (style.color && line[i].on != lit) {
      lit = line[i].on;
      text += lit ? "\x1b[1;32m" : "\x1b[0m";
    }
    encode(line[i].c, text);
  }
  if (lit) text += "\x1b[0m";
  return text;
}

}  // namespace

std::vector<std::string> ladder_text(const Run& run, TextStyle style, std::vector<int>* rung_of) {
  std::vector<std::string> text;
  const auto add = [&](std::string line, int rung) {
    text.push_back(std::move(line));
    if (rung_of != nullptr) rung_of->push_back(rung);
  };
  int number = 0;
  for (const RungView& rung : run.view().rungs()) {
    for (std::size_t at = 0; at < rung.note.size();) {
      const std::size_t end = std::min(rung.note.find('\n', at), rung.note.size());
      add(fmt::format("{:>{}}; {}", "", kLeft, rung.note.substr(at, end - at)), number);
      at = end + 1;
    }
    for (const auto& line : Canvas(run, rung).draw(number + 1)) add(text_of(line, style), number);
    ++number;
  }
  for (std::size_t i = 0; i < run.view().tasks().size(); ++i) {
    const TaskView& task = run.view().tasks()[i];
    const auto state = run.engine().task(i);
    add(fmt::format("task {}{}", task.name, state && !state->started ? " (not running)" : ""), -1);
    for (const StepView& step : task.steps) {
      const bool here = state && state->started && state->step == step.number;
      std::string line =
          fmt::format("  {} {}{}", here ? ">" : " ", step.added ? "(after wait) " : "", step.name);
      add(here && style.color ? "\x1b[1;32m" + line + "\x1b[0m" : line, -1);
      for (const std::string& each : step.lines) add("        " + each, -1);
    }
  }
  return text;
}

}  // namespace rung::view
