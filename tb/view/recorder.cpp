// SPDX-License-Identifier: Apache-2.0
#include "view/recorder.hpp"

#include <Vinside_mpu1.h>
#include <Vinside_mpu2.h>
#include <Vinside_mpu3.h>

#include <array>

#include "harness/verilated_processor.hpp"
#include "view/probe.hpp"

namespace rung::tb {
namespace {

using isa::Mpu;
using view::Forwarded;
using view::RecordedClock;
using view::RecordedSlot;

// What operand.v forwards: from how far, by writer.
struct OperandProbes {
  char name = 'a';
  Probe hit1, hit2, hit3, hit4;

  OperandProbes(const VerilatedContext& context, const std::string& scope, char operand)
      : name(operand),
        hit1(context, scope, "x_hit1_q"),
        hit2(context, scope, "d3_hit2"),
        hit3(context, scope, "d2_hit3"),
        hit4(context, scope, "d2_hit4_q") {}
};

struct SlotProbes {
  Probe exc, function, operands, s1, s2;
  std::vector<OperandProbes> sources;
};

// The flags of one operand in the clocks that matter for the step that is in EX now: the decisions
// for distance 2 fell one clock before, those for 3 and 4 two clocks before.
struct Flags {
  bool hit2 = false, hit3 = false, hit4 = false;
};

// Which operands an instruction has, of those that are devices.
std::string devices_of(const isa::SlotInstruction& instruction, Mpu mpu) {
  const isa::OpcodeInfo& info = isa::info(instruction.opcode);
  const bool word = info.format == isa::Format::Word || info.format == isa::Format::Test;
  if (word) {
    std::string names;
    if (instruction.kind != isa::WordKind::ConstantDevice) names += '1';
    if (instruction.kind != isa::WordKind::DeviceConstant) names += '2';
    return names;
  }
  if (info.format != isa::Format::Bit) return {};
  if (mpu == Mpu::Mpu1) return instruction.opcode == isa::Opcode::Out ? "" : "c";
  switch (instruction.opcode) {
    case isa::Opcode::Lut:
    case isa::Opcode::Luto:
    case isa::Opcode::Luts:
    case isa::Opcode::Lutr: {
      std::string names;
      if (!instruction.a.n0) names += 'a';
      if (!instruction.b.n0) names += 'b';
      if (!instruction.c.n0) names += 'c';
      return names;
    }
    case isa::Opcode::Ld:
    case isa::Opcode::Mvbx:
      return "a";
    case isa::Opcode::Get:
      return "abc";
    default:
      return {};
  }
}

template <typename Dut, Mpu kMpu>
class Recorder final : public RecordedProcessor {
 public:
  explicit Recorder(const isa::Config& config) : processor_(config) {
    const VerilatedContext& context = *processor_.dut().contextp();
    const std::string core = fmt::format("TOP.mpu{}.core", static_cast<int>(kMpu));
    const auto probe = [&](const std::string& scope, const char* name) {
      return Probe(context, scope, name);
    };
    const std::string fetch = core + ".fetch";
    active1_ = probe(fetch, "f1_active_q");
    pc1_ = probe(fetch, "f1_pc_q");
    stop1_ = probe(fetch, "f1_stop_q");
    valid_ = {probe(fetch, "f2_valid_q"), probe(fetch, "f3_valid_q"), probe(fetch, "d1_valid_q"),
              probe(core, "d2_retire_q"), probe(core, "d3_retire_q"), probe(core, "x_retire_q")};
    number_ = {probe(fetch, "f2_number_q"), probe(fetch, "f3_number_q"),
               probe(fetch, "d1_number_q"), probe(core, "d2_number_q"),
               probe(core, "d3_number_q"),  probe(core, "x_number_q")};
    for (int s = 0; s < kSlots; ++s) add_slot(context, fmt::format("{}.g_slot[{}].slot", core, s));
    processor_.observe_clocks([this] { clock(); });
  }

  Processor& processor() override { return processor_; }
  const std::vector<RecordedClock>& clocks() const override { return clocks_; }

  void begin(const image::Image& image) override {
    image_ = &image;
    clocks_.clear();
    for (auto& each : history_) each.assign(flags_, {});
    if (bits_.empty()) name_devices();
  }

 private:
  static constexpr int kSlots = kMpu == Mpu::Mpu3 ? 2 : 1;
  static constexpr bool kLookUp = kMpu != Mpu::Mpu1;

  void add_slot(const VerilatedContext& context, const std::string& scope) {
    const std::string bits = scope + (kLookUp ? ".g_look_up.bits" : ".g_contact.bits");
    SlotProbes slot;
    slot.exc = Probe(context, bits, "exc_q");
    slot.operands = Probe(context, bits, kLookUp ? "x_operands" : "x_device");
    if (kLookUp) slot.function = Probe(context, bits, "x_function_q");
    slot.s1 = Probe(context, scope + ".words", "x_s1");
    slot.s2 = Probe(context, scope + ".words", "x_s2");
    if (kLookUp) {
      for (int i = 0; i < 3; ++i) {
        slot.sources.emplace_back(context, fmt::format("{}.g_operand[{}].operand", bits, i),
                                  static_cast<char>('c' - i));
      }
    } else {
      slot.sources.emplace_back(context, bits + ".operand", 'c');
    }
    slot.sources.emplace_back(context, scope + ".words.s1", '1');
    slot.sources.emplace_back(context, scope + ".words.s2", '2');
    flags_ += slot.sources.size();
    slots_.push_back(std::move(slot));
  }

  void name_devices() {
    const isa::Config& config = processor_.config();
    // The compiler's own as its listing calls them.
    for (int i = 0; i < config.bit_devices; ++i) {
      bits_.push_back(fmt::format("t{}", i - image_->first_hidden_bit));
    }
    for (int i = 0; i < config.word_devices; ++i) {
      words_.push_back(fmt::format("w{}", i - image_->first_hidden_word));
    }
    for (const image::ImageDevice& each : image_->devices) {
      (is_word(each.device) ? words_ : bits_).at(static_cast<std::size_t>(each.address)) =
          each.name;
    }
  }

  void clock() {
    if (image_ == nullptr) return;
    RecordedClock now;
    now.steps[0] = active1_.value() != 0 && pc1_.value() != stop1_.value()
                       ? static_cast<int>(pc1_.value())
                       : -1;
    for (std::size_t i = 0; i < valid_.size(); ++i) {
      now.steps[i + 1] = valid_[i].value() != 0 ? static_cast<int>(number_[i].value()) : -1;
    }
    std::size_t flag = 0;
    for (int s = 0; s < kSlots; ++s) now.slots.push_back(slot(s, now.steps.back(), flag));
    remember();
    clocks_.push_back(std::move(now));
  }

  RecordedSlot slot(int s, int step, std::size_t& flag) {
    Dut& dut = processor_.dut();
    const SlotProbes& probes = slots_[static_cast<std::size_t>(s)];
    const std::size_t first = flag;
    flag += probes.sources.size();
    RecordedSlot slot;
    slot.completes = (dut.retire_valid_o >> s & 1) != 0;
    if (!slot.completes) return slot;
    slot.exc_before = probes.exc.value() != 0;
    slot.exc_after = (dut.retire_exc_o >> s & 1) != 0;
    slot.operands = static_cast<std::uint8_t>(probes.operands.value());
    if (kLookUp) slot.function = static_cast<std::uint8_t>(probes.function.value());
    slot.s1 = static_cast<std::uint16_t>(probes.s1.value());
    slot.s2 = static_cast<std::uint16_t>(probes.s2.value());
    const std::string devices = devices_of(
        image_->steps[static_cast<std::size_t>(step)][static_cast<std::size_t>(s)], kMpu);
    for (std::size_t i = 0; i < probes.sources.size(); ++i) {
      const OperandProbes& source = probes.sources[i];
      if (devices.find(source.name) == std::string::npos) continue;
      const Flags one = history_[0][first + i], two = history_[1][first + i];
      // The nearest write is the newest.
      const int distance = source.hit1.value() != 0 ? 1
                           : one.hit2               ? 2
                           : two.hit3               ? 3
                           : two.hit4               ? 4
                                                    : 0;
      if (distance != 0) slot.forwarded.push_back({source.name, distance});
    }
    if ((dut.retire_bit_we_o >> s & 1) != 0) {
      slot.written = bits_[dut.retire_bit_addr_o >> 16 * s & 0xFFFF];
      slot.value = static_cast<std::int16_t>(dut.retire_bit_data_o >> s & 1);
    }
    if ((dut.retire_word_we_o >> s & 1) != 0) {
      slot.written = words_[dut.retire_word_addr_o >> 16 * s & 0xFFFF];
      slot.value = static_cast<std::int16_t>(dut.retire_word_data_o >> 16 * s);
    }
    return slot;
  }

  void remember() {
    std::swap(history_[0], history_[1]);
    history_[0].clear();
    for (const SlotProbes& probes : slots_) {
      for (const OperandProbes& each : probes.sources) {
        history_[0].push_back(
            {each.hit2.value() != 0, each.hit3.value() != 0, each.hit4.value() != 0});
      }
    }
  }

  VerilatedProcessor<Dut, kMpu> processor_;
  Probe active1_, pc1_, stop1_;
  std::array<Probe, 6> valid_, number_;  // IF2 to EX
  std::vector<SlotProbes> slots_;
  std::size_t flags_ = 0;                      // operands of all slots
  std::array<std::vector<Flags>, 2> history_;  // one clock before, and two
  const image::Image* image_ = nullptr;
  std::vector<std::string> bits_, words_;  // names by address
  std::vector<RecordedClock> clocks_;
};

}  // namespace

std::unique_ptr<RecordedProcessor> make_recorded_processor(Mpu mpu, const isa::Config& config) {
  switch (mpu) {
    case Mpu::Mpu1:
      return std::make_unique<Recorder<Vinside_mpu1, Mpu::Mpu1>>(config);
    case Mpu::Mpu2:
      return std::make_unique<Recorder<Vinside_mpu2, Mpu::Mpu2>>(config);
    case Mpu::Mpu3:
      return std::make_unique<Recorder<Vinside_mpu3, Mpu::Mpu3>>(config);
    case Mpu::Mpu4:
      break;  // its rows of results have no picture yet
  }
  throw std::invalid_argument("no such processor");
}

std::vector<std::vector<view::RecordedCode>> recorded_code(const image::Image& image) {
  std::vector<std::vector<view::RecordedCode>> code;
  for (std::size_t step = 0; step < image.steps.size(); ++step) {
    std::vector<view::RecordedCode> slots;
    for (std::size_t s = 0; s < image.steps[step].size(); ++s) {
      const isa::SlotInstruction& instruction = image.steps[step][s];
      const bool looks_up =
          image.mpu != Mpu::Mpu1 &&
          (instruction.opcode == isa::Opcode::Lut || instruction.opcode == isa::Opcode::Luto ||
           instruction.opcode == isa::Opcode::Luts || instruction.opcode == isa::Opcode::Lutr);
      slots.push_back({image::disassemble(instruction, image), image.origins[step][s],
                       looks_up ? instruction.row : -1});
    }
    code.push_back(std::move(slots));
  }
  return code;
}

}  // namespace rung::tb
