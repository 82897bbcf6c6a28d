// SPDX-License-Identifier: Apache-2.0
#include "backends/c_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

namespace rung {
namespace {

constexpr std::array kKinds = {DeviceKind::X, DeviceKind::Y, DeviceKind::M, DeviceKind::D};
constexpr std::string_view kLower = "xymd";
constexpr std::string_view kUpper = "XYMD";

// Text that can stand in a C comment: neither its end nor a trigraph or line splice.
std::string comment_text(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool ends = c == '*' && i + 1 < text.size() && text[i + 1] == '/';
    const bool begins = c == '/' && i + 1 < text.size() && text[i + 1] == '*';
    safe += static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == '?' ? '_' : c;
    if (ends || begins) safe += ' ';
  }
  return safe;
}

std::string place(Device device) {
  return fmt::format("plc.{}[{}]", kLower[static_cast<std::size_t>(device.kind)], device.number);
}

// A word operand as an int32_t.
std::string operand(const WordSource& source) {
  if (source.constant) return fmt::format("(int32_t){}", source.value);
  return "(int32_t)" + place(source.device);
}

class CWriter {
 public:
  explicit CWriter(const Program& program) : program_(program) {}

  std::string write() {
    measure();
    prologue();
    accessors();
    cycle();
    return std::move(out_);
  }

 private:
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
    out_ += '\n';
  }

  void measure() {
    // C has no arrays of no elements.
    sizes_.fill(1);
    for (const Device device : named_devices(program_)) {
      std::uint32_t& size = sizes_[static_cast<std::size_t>(device.kind)];
      size = std::max(size, device.number + 1);
    }
    for (const Instruction& instruction : program_.instructions) {
      arithmetic_ = arithmetic_ || instruction.op >= Op::Add;
    }
  }

  void prologue() {
    line("/* {}, dialect {}, as C99: {} networks, {} instructions.", comment_text(program_.file),
         dialect_name(program_.dialect), program_.networks.size(), program_.instructions.size());
    line(" *");
    line(" * Before a scan give the inputs with PlcWriteX, then call PlcCycle, then read the");
    line(" * outputs with PlcReadY: nothing is to be put out while it runs. A device goes by its");
    line(" * number: {}. Bits are 0 or 1.", program_.dialect == Dialect::Q
                                                ? "Y10, which is hexadecimal, is 16"
                                                : "Y10, which is octal, is 8");
    line(" * Devices that the program does not name read 0, and writing them does nothing. */");
    line("#include <stdint.h>");
    line("");
    line("void PlcReset(void);     /* all devices 0 */");
    line("void PlcCycle(void);     /* one scan */");
    line(
        "uint8_t PlcError(void);  /* 1: the last cycle divided by zero, and that wrote nothing */");
    for (const DeviceKind kind : kKinds) {
      line("{0} PlcRead{1}(uint32_t number);", type(kind), upper(kind));
      line("void PlcWrite{1}(uint32_t number, {0} value);", type(kind), upper(kind));
    }
    line("");
    line("static struct {{");
    for (const DeviceKind kind : {DeviceKind::X, DeviceKind::Y, DeviceKind::M}) {
      line("  uint8_t {}[{}];", lower(kind), size(kind));
    }
    line("  uint8_t error;");
    line("  int16_t d[{}];", size(DeviceKind::D));
    line("}} plc;");
    line("");
  }

  void accessors() {
    for (const DeviceKind kind : kKinds) {
      line("{0} PlcRead{1}(uint32_t number) {{", type(kind), upper(kind));
      line("  return number < {1}u ? plc.{0}[number] : 0;", lower(kind), size(kind));
      line("}}");
      line("");
      line("void PlcWrite{1}(uint32_t number, {0} value) {{", type(kind), upper(kind));
      line("  if (number < {1}u) plc.{0}[number] = {2};", lower(kind), size(kind),
           kind == DeviceKind::D ? "value" : "value != 0");
      line("}}");
      line("");
    }
    line("uint8_t PlcError(void) {{ return plc.error; }}");
    line("");
    line("void PlcReset(void) {{");
    line("  /* volatile: a compiler must not make these loops calls of a library's memset. */");
    line("  uint32_t i;");
    for (const DeviceKind kind : kKinds) {
      line("  volatile {1} *const {0} = plc.{0};", lower(kind), type(kind));
    }
    for (const DeviceKind kind : kKinds) {
      line("  for (i = 0; i < {1}u; ++i) {0}[i] = 0;", lower(kind), size(kind));
    }
    line("  plc.error = 0;");
    line("}}");
    line("");
    if (!arithmetic_) return;
    line("/* The low 16 bits as a signed word. */");
    line("static int16_t plc_word(uint32_t bits) {{");
    line("  bits &= 0xFFFFu;");
    line("  return (int16_t)(bits < 0x8000u ? (int32_t)bits : (int32_t)bits - 0x10000);");
    line("}}");
    line("");
  }

  void cycle() {
    line("void PlcCycle(void) {{");
    line("  plc.error = 0;");
    for (std::size_t i = 0; i < program_.networks.size(); ++i) {
      line("");
      network(program_.networks[i], i + 1);
    }
    line("}}");
  }

  void network(const Network& network, std::size_t number) {
    const auto* const first = program_.instructions.data() + network.first;
    const auto* const last = first + network.count;
    line("  /* Network {}, by the lines of its source", number);
    for (const auto* i = first; i != last; ++i) {
      line("   * {:5}: {}{}", i->position.line, comment_text(i->text), i + 1 == last ? " */" : "");
    }
    declare(first, last);
    blocks_ = 0;
    branches_ = 0;
    for (const auto* i = first; i != last; ++i) instruction(*i);
    line("  }}");
  }

  // r0, r1, ... are the open blocks, s0, s1, ... the branches that MPS keeps.
  void declare(const Instruction* first, const Instruction* last) {
    int blocks = 0;
    int most_blocks = 0;
    int branches = 0;
    int most_branches = 0;
    for (const auto* i = first; i != last; ++i) {
      if (i->op == Op::Ld || i->op == Op::Ldi) most_blocks = std::max(most_blocks, ++blocks);
      if (i->op == Op::Anb || i->op == Op::Orb) --blocks;
      if (i->op == Op::Mps) most_branches = std::max(most_branches, ++branches);
      if (i->op == Op::Mpp) --branches;
    }
    line("  {{");
    for (int i = 0; i < most_blocks; ++i) line("    unsigned r{};", i);
    for (int i = 0; i < most_branches; ++i) line("    unsigned s{};", i);
  }

  void instruction(const Instruction& instruction) {
    const std::string device = place(instruction.device);
    const int top = blocks_ - 1;
    switch (instruction.op) {
      case Op::Nop:
        return;
      case Op::Ld:
        return line("    r{} = {};", blocks_++, device);
      case Op::Ldi:
        return line("    r{} = {} ^ 1u;", blocks_++, device);
      case Op::And:
        return line("    r{} &= {};", top, device);
      case Op::Ani:
        return line("    r{} &= {} ^ 1u;", top, device);
      case Op::Or:
        return line("    r{} |= {};", top, device);
      case Op::Ori:
        return line("    r{} |= {} ^ 1u;", top, device);
      case Op::Anb:
        --blocks_;
        return line("    r{} &= r{};", top - 1, top);
      case Op::Orb:
        --blocks_;
        return line("    r{} |= r{};", top - 1, top);
      case Op::Mps:
        return line("    s{} = r{};", branches_++, top);
      case Op::Mrd:
        return line("    r{} = s{};", top, branches_ - 1);
      case Op::Mpp:
        return line("    r{} = s{};", top, --branches_);
      case Op::Out:
        return line("    {} = (uint8_t)r{};", device, top);
      case Op::Set:
        return line("    if (r{}) {} = 1;", top, device);
      case Op::Rst:
        return line("    if (r{}) {} = 0;", top, device);
      case Op::Mov:
        return line("    if (r{}) {} = {};", top, device,
                    instruction.sources[0].constant ? fmt::to_string(instruction.sources[0].value)
                                                    : place(instruction.sources[0].device));
      default:
        return arithmetic(instruction, top);
    }
  }

  void arithmetic(const Instruction& instruction, int top) {
    const Device next{instruction.device.kind, instruction.device.number + 1};
    const std::string low = place(instruction.device);
    const std::string high = place(next);
    line("    if (r{}) {{", top);
    line("      const int32_t a = {}, b = {};", operand(instruction.sources[0]),
         operand(instruction.sources[1]));
    switch (instruction.op) {
      case Op::Add:
        line("      {} = plc_word((uint32_t)(a + b));", low);
        break;
      case Op::Sub:
        line("      {} = plc_word((uint32_t)(a - b));", low);
        break;
      case Op::Mul:
        line("      const uint32_t product = (uint32_t)(a * b);");
        line("      {} = plc_word(product);", low);
        if (instruction.double_width) line("      {} = plc_word(product >> 16);", high);
        break;
      default:
        line("      if (b == 0) {{");
        line("        plc.error = 1;");
        line("      }} else {{");
        line("        {} = plc_word((uint32_t)(a / b));", low);
        if (instruction.double_width) line("        {} = (int16_t)(a % b);", high);
        line("      }}");
        break;
    }
    line("    }}");
  }

  static char lower(DeviceKind kind) { return kLower[static_cast<std::size_t>(kind)]; }
  static char upper(DeviceKind kind) { return kUpper[static_cast<std::size_t>(kind)]; }
  static std::string_view type(DeviceKind kind) {
    return kind == DeviceKind::D ? "int16_t" : "uint8_t";
  }
  std::uint32_t size(DeviceKind kind) const { return sizes_[static_cast<std::size_t>(kind)]; }

  const Program& program_;
  std::string out_;
  std::array<std::uint32_t, 4> sizes_{};
  bool arithmetic_ = false;
  int blocks_ = 0;
  int branches_ = 0;
};

}  // namespace

std::string to_c(const Program& program) { return CWriter(program).write(); }

}  // namespace rung
