// SPDX-License-Identifier: Apache-2.0
#include "driver/compile_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "driver/flow_parts.hpp"
#include "image/frame.hpp"
#include "lower/lower.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

using flowchart::Flowchart;
using flowchart::Step;
using passes::Lowered;
using passes::Plan;

// Hidden devices of the steps, by place: above all numbers of the lowering.
constexpr std::uint32_t kPool = 1U << 23U;
constexpr std::uint32_t kAliases = 1U << 24U;

class FlowCompiler {
 public:
  FlowCompiler(const Flowchart& chart, const CompileOptions& options, Diagnostics& diagnostics)
      : chart_(chart), options_(options), diagnostics_(diagnostics) {}

  std::optional<Compiled> run() {
    const int errors = diagnostics_.error_count();
    flow_parts::check_chart(chart_, options_, diagnostics_);
    if (diagnostics_.error_count() > errors) return std::nullopt;
    lower();
    place();
    if (slots()) {
      plan(true);
      if (!assemble()) {
        plan(false);
        passes::expect(assemble() ? "" : "the look-ups need more rows than there are", "assembly");
      }
    } else {
      for (const Lowered& each : lowered_) {
        passes::check_stacks(each.source, each.program, diagnostics_);
      }
      assemble();
    }
    check_sizes();
    if (diagnostics_.error_count() > errors) return std::nullopt;
    return std::move(compiled_);
  }

 private:
  bool slots() const { return options_.mpu != isa::Mpu::Mpu1; }

  // The ladder's routine is number 0, that of step i number i + 1.
  void lower() {
    lowered_.reserve(chart_.steps.size() + 1);
    std::vector<core::Program> steps;
    steps.reserve(chart_.steps.size());
    std::set<Device> used;
    for (const Step& step : chart_.steps) {
      core::Program& program = steps.emplace_back(lower::lower(step.rungs));
      const std::string problem = flow_parts::remembers(program);
      passes::expect(problem.empty() ? "" : fmt::format("step {}: {}", step.name, problem),
                     "the lowering of a step");
      for (const Device device : core::devices(program)) used.insert(device);
    }
    core::Program ladder = lower::lower(chart_.ladder);
    flow_parts::count_time(ladder, used);
    lowered_.push_back(passes::lower(chart_.ladder, std::move(ladder), options_));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      lowered_.push_back(passes::lower(chart_.steps[i].rungs, std::move(steps[i]), options_));
    }
  }

  // The addresses of all devices that several routines may see, and each step's view of its own.
  void place() {
    whole_ = flow_parts::whole_program(chart_);
    std::set<Device> all = flow_parts::table_devices(chart_);
    for (const Device device : visible_devices(whole_)) all.insert(device);
    for (const Device device : core::devices(lowered_[0].program)) all.insert(device);
    for (const core::TickWord& word : lowered_[0].program.ticks) all.insert(word.device);

    // Of each step's hidden devices, which of the pool they are.
    std::vector<std::map<Device, Device>> pooled(chart_.steps.size());
    for (std::size_t i = 0; i < chart_.steps.size(); ++i) {
      const core::Program& program = lowered_[i + 1].program;
      std::uint32_t bits = kPool;
      std::uint32_t words = kPool;
      for (const Device device : core::devices(program)) {
        if (!flow_parts::is_private(device)) {
          all.insert(device);
        } else {
          const std::uint32_t number = is_word(device) ? words++ : bits++;
          pooled[i][device] = {device.kind, number};
        }
      }
      for (const auto& [device, place] : pooled[i]) all.insert(place);
    }
    common_.emplace(all, *options_.config);
    views_.reserve(lowered_.size());
    views_.emplace_back(*common_, std::map<Device, int>{});
    for (const auto& places : pooled) {
      std::map<Device, int> own;
      for (const auto& [device, place] : places) own[device] = common_->of(place);
      views_.emplace_back(*common_, std::move(own));
    }
  }

  // Where a routine's devices are: those of all, and its own instead of the pool.
  std::map<Device, int> places_of(std::size_t routine) const {
    std::map<Device, int> out = views_[routine].devices();
    for (const auto& [device, address] : common_->devices()) {
      if (is_hidden(device.kind) && device.number >= kPool) continue;
      // A hidden device of the ladder's may have the number of one of the step's: under another
      // number it still stands there as one that the step may not touch.
      const bool fresh = out.emplace(device, address).second;
      if (!fresh && out.at(device) != address) {
        out.emplace(Device{device.kind, device.number + kAliases}, address);
      }
    }
    return out;
  }

  void plan(bool fuse) {
    plans_.clear();
    plans_.reserve(lowered_.size());
    mapping::Options how;
    how.fuse = fuse;
    for (const Lowered& each : lowered_) {
      Plan plan = passes::plan(each, how, options_);
      auto waiting = passes::plan_waiting(each, plan, how, options_);
      plans_.push_back(waiting ? std::move(*waiting) : std::move(plan));
    }
  }

  // False: more LUT rows than there are.
  bool assemble() {
    const isa::Config& config = *options_.config;
    image::Image image =
        image::start_image(whole_, lowered_[0].program, *common_, config, options_.mpu);
    image::FlowImage flow =
        flow_parts::tables(chart_, [&](Device device) { return int{common_->of(device)}; });
    image::Rows rows;
    std::vector<image::Meaning> meanings;
    int temporaries = 0;
    int origin = 0;
    for (std::size_t i = 0; i < lowered_.size(); ++i) {
      const core::Program& program = lowered_[i].program;
      const int entry = static_cast<int>(image.steps.size());
      image::Routine routine;
      if (slots()) {
        const Plan& plan = plans_[i];
        routine = image::assemble_routine(program, plan.mapping, plan.schedule, plan.temporaries,
                                          views_[i], rows, config);
        temporaries = std::max(temporaries, plan.temporaries.count);
      } else {
        routine = image::assemble_routine(program, views_[i], config);
      }
      image::append(image, routine, origin);
      const int first_origin = origin;
      origin += static_cast<int>(lowered_[i].source.instructions.size());
      const int end = static_cast<int>(image.steps.size());
      image::Meaning meaning = image::meaning(lowered_[i].source, program, places_of(i));
      meaning.first_step = entry;
      meaning.end_step = end;
      meaning.first_origin = first_origin;
      if (i > 0) meaning.step = chart_.steps[i - 1].name;
      meanings.push_back(std::move(meaning));
      if (i == 0) {
        image.clocks = routine.clocks;
        flow.ladder_steps = end;
        continue;
      }
      flow.steps[i - 1].entry = entry;
      flow.steps[i - 1].end = end;
      flow.steps[i - 1].clocks = routine.clocks;
    }
    image.lut = rows.lut();
    image.statistics.lut_rows = rows.used();
    image.statistics.bit_devices += temporaries;
    image.flow = std::move(flow);
    compiled_.image = std::move(image);
    compiled_.meanings = std::move(meanings);
    if (slots()) compiled_.schedule = plans_[0].report;
    return rows.fit();
  }

  void check_sizes() {
    const isa::Config& config = *options_.config;
    const image::Image& image = compiled_.image;
    const int steps = static_cast<int>(image.steps.size());
    const int there = config.steps(options_.mpu);
    if (steps > there) {
      diagnostics_.error(
          chart_.file, {},
          fmt::format("the program needs {} instruction steps, {} of its ladder and {} of its {} "
                      "flow steps; configuration {} has {}",
                      steps, image.flow->ladder_steps, steps - image.flow->ladder_steps,
                      chart_.steps.size(), config.name, there),
          "split the program, or choose a larger configuration with --config");
    }
    passes::check_size(chart_.file, "bit devices", image.statistics.bit_devices, config.bit_devices,
                       config, diagnostics_);
    passes::check_size(chart_.file, "word devices", image.statistics.word_devices,
                       config.word_devices, config, diagnostics_);
  }

  const Flowchart& chart_;
  const CompileOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<Lowered> lowered_;
  Program whole_;
  std::optional<image::Addresses> common_;
  std::vector<image::Addresses> views_;  // of the routines
  std::vector<Plan> plans_;
  Compiled compiled_;
};

}  // namespace

std::optional<Compiled> compile_flow(const Flowchart& chart, const CompileOptions& options,
                                     Diagnostics& diagnostics) {
  return FlowCompiler(chart, options, diagnostics).run();
}

}  // namespace rung
