// SPDX-License-Identifier: Apache-2.0
#include "driver/compile_wide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "driver/passes.hpp"
#include "driver/peripherals.hpp"
#include "image/frame.hpp"
#include "lower/lower.hpp"
#include "rungs/footprint.hpp"
#include "rungs/special.hpp"
#include "values/values.hpp"
#include "wide/assemble.hpp"

namespace rung {
namespace {

using wide::Machine;

// Bits that the controller sets before each scan, inputs first.
std::vector<Device> latched_bits(const Program& program, const values::Values& values) {
  std::vector<Device> inputs, driven;
  for (const Device device : visible_devices(program)) {
    if (is_word(device) || values.bits.contains(device)) continue;
    const SpecialRange* special = find_special(device, program.dialect);
    if (device.kind == DeviceKind::X) {
      inputs.push_back(device);
    } else if (special != nullptr && is_driven(special->role)) {
      driven.push_back(device);
    }
  }
  inputs.insert(inputs.end(), driven.begin(), driven.end());
  return inputs;
}

std::vector<Device> all_devices(const Program& source, const core::Program& program) {
  std::set<Device> all;
  for (const Device device : visible_devices(source)) all.insert(device);
  for (const Device device : core::devices(program)) all.insert(device);
  for (const core::ConstantWord& word : program.constants) all.erase(word.device);
  return {all.begin(), all.end()};
}

image::WideReport report(const wide::Code& code, const wide::Work& work,
                         const wide::Bounds& bounds) {
  image::WideReport out;
  out.look_ups = static_cast<int>(work.look_ups.size());
  for (const wide::Group& group : work.groups) {
    out.words += static_cast<int>(group.words.size());
    out.divisions += group.divides ? 1 : 0;
  }
  const auto count = [&](const wide::Operand& operand, int lane) {
    const int near = operand.row - wide::kSpecialRow;
    if (near == wide::constant::near_zero || near == wide::constant::near_flag) return;
    if (near > 0) ++out.near_values;
    const bool own = near > 0 && near < wide::constant::near_bus_first;
    if (!own && operand.lane != lane) ++out.captures;
  };
  for (const wide::Step& step : code.steps) {
    for (std::size_t slot = 0; slot < step.bits.size(); ++slot) {
      for (const auto& input : step.bits[slot].inputs) count(input, static_cast<int>(slot));
    }
    for (std::size_t unit = 0; unit < step.words.size(); ++unit) {
      count(step.words[unit].s1, static_cast<int>(unit));
      count(step.words[unit].s2, static_cast<int>(unit));
    }
  }
  out.by_look_ups = bounds.look_ups;
  out.by_words = bounds.words;
  out.by_dividers = bounds.dividers;
  out.by_dependence = bounds.dependence;
  out.binding = bounds.binding();
  return out;
}

class Maker {
 public:
  Maker(const Program& source, const core::Program& program, const CompileOptions& options,
        const Machine& machine)
      : source_(source), program_(program), options_(options), machine_(machine) {}

  Compiled make(const wide::Code& code, const wide::Latch& latch) {
    image::Image image;
    image.program = source_.file;
    image.dialect = dialect_name(source_.dialect);
    image.mpu = isa::Mpu::Mpu4;
    image.config = options_.config->name;
    image.wide.emplace();
    wide_ = &*image.wide;
    wide_->slots = machine_.slots;
    wide_->merged = options_.merge;
    add_devices(code, image);
    add_code(code);
    wide_->first_latch_row = code.first_latch_row;
    wide_->latch_rows = code.latch_rows;
    wide_->latched.assign(latch.position.size(), -1);
    for (const auto& [device, position] : latch.position) {
      wide_->latched[position] = index_.at(device);
    }
    image.clocks = code.clocks();
    image::describe_source(source_, image);
    image.statistics.bit_devices = count(code, false);
    image.statistics.word_devices = count(code, true);
    return {std::move(image), std::nullopt, {}};
  }

 private:
  static int count(const wide::Code& code, bool words) {
    return static_cast<int>(
        std::count_if(code.addresses.begin(), code.addresses.end(),
                      [&](const auto& each) { return is_word(each.first) == words; }));
  }

  void add_devices(const wide::Code& code, image::Image& image) {
    for (const auto& [device, address] : code.addresses) {
      const bool channel = is_port(device.kind) && source_.names.contains(device);
      if (is_port(device.kind)) wide_->ports.push_back({device, address});
      if (is_hidden(device.kind) && !channel) continue;
      index_[device] = static_cast<int>(image.devices.size());
      const auto comment = source_.comments.find(device);
      image.devices.push_back({device_name(device, source_), device, address,
                               comment == source_.comments.end() ? "" : comment->second});
    }
    for (const core::TickWord& word : program_.ticks) {
      image.ticks.push_back({code.addresses.at(word.device), word.base_us});
    }
  }

  int origin(std::size_t instruction) const {
    return static_cast<int>(program_.instructions[instruction].origin);
  }

  // A look-up computes its bit in every scan: if the instruction was executed shows only where that
  // changes something, but for OUT, which always is.
  bool quiet(const wide::Write& write) const {
    if (write.instruction == wide::kNoInstruction) return false;
    const core::Instruction& instruction = program_.instructions[write.instruction];
    return instruction.quiet || (!is_word(write.device) && instruction.op != core::Op::Out);
  }

  void add_code(const wide::Code& code) {
    for (std::size_t step = 0; step < code.steps.size(); ++step) {
      auto& chunks = wide_->code.emplace_back();
      auto& origins = wide_->origins.emplace_back();
      for (int slot = 0; slot < machine_.slots; ++slot) {
        chunks.push_back(wide::encode(code.steps[step], slot, machine_));
        const int from = code.origins[step][slot];
        origins.push_back(from < 0 ? -1 : origin(static_cast<std::size_t>(from)));
      }
    }
    for (const wide::Write& write : code.writes) {
      const auto device = index_.find(write.device);
      if (device == index_.end()) continue;
      wide_->writes.push_back({write.step, write.lane, device->second, quiet(write)});
    }
  }

  const Program& source_;
  const core::Program& program_;
  const CompileOptions& options_;
  const Machine& machine_;
  image::WideImage* wide_ = nullptr;
  std::map<Device, int> index_;
};

void check(const Program& program, const char* what, int needed, int available,
           const Machine& machine, Diagnostics& diagnostics) {
  if (needed <= available) return;
  diagnostics.error(program.file, {},
                    fmt::format("the program needs {} {}; MPU4 with {} slots has {}", needed, what,
                                machine.slots, available),
                    "split the program, or compile it for more slots (--slots) or for MPU3");
}

}  // namespace

std::optional<Compiled> compile_wide(const Program& program, const CompileOptions& options,
                                     Diagnostics& diagnostics) {
  const int errors = diagnostics.error_count();
  const Machine* machine = wide::find_machine(options.slots);
  passes::expect(machine != nullptr ? "" : "no such processor", "MPU4");
  check_peripherals(program, *options.config, diagnostics);
  const passes::Lowered lowered = passes::lower(program, options);
  const values::Values values = values::build(lowered.logic, lowered.program);
  const wide::Latch latch = wide::make_latch(latched_bits(program, values), *machine);
  wide::Work work = wide::make_work(values, *machine, latch, {options.merge});
  wide::untangle(work, values);
  wide::SearchOptions search;
  search.seed = options.search.seed;
  const wide::Schedule schedule = wide::search(work, values, *machine, search);
  const wide::Code code =
      wide::assemble(schedule, work, values, *machine, all_devices(program, lowered.program));
  check(program, "steps", static_cast<int>(code.steps.size()), machine->steps, *machine,
        diagnostics);
  check(program, "rows of bits", code.rows, machine->rows, *machine, diagnostics);
  check(program, "rows of words", code.word_rows, machine->word_rows, *machine, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  passes::expect(wide::verify(code, schedule, work, values, *machine), "MPU4");

  Compiled compiled = Maker(program, lowered.program, options, *machine).make(code, latch);
  const wide::Bounds bounds = wide::bounds(work, values, *machine);
  compiled.image.wide->report = report(code, work, bounds);
  compiled.image.statistics.lookups = static_cast<int>(work.look_ups.size());
  compiled.meanings.push_back(image::meaning(program, lowered.program, code.addresses));
  compiled.meanings[0].end_step = static_cast<int>(code.steps.size());
  return compiled;
}

}  // namespace rung
