// SPDX-License-Identifier: Apache-2.0
#include "view/inside_engine.hpp"

#include <fmt/format.h>

#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "rungs/ports.hpp"
#include "view/recorder.hpp"

namespace rung::tb {
namespace {

// One processor, in the order in which its parts must live.
struct Beside {
  image::Image image;
  std::unique_ptr<RecordedProcessor> recorded;
  Machine machine;
  Lockstep lockstep;

  Beside(const Program& program, image::Image given, std::int64_t tick_us)
      : image(std::move(given)),
        recorded(make_recorded_processor(image.mpu, *isa::find_config(image.config))),
        machine(image, recorded->processor(), tick_us),
        lockstep(program, machine) {}
};

class InsideEngine final : public view::Engine {
 public:
  InsideEngine(const Program& program, std::vector<image::Image> images, std::int64_t tick_us)
      : seen_(program.instructions.size()) {
    for (image::Image& image : images) {
      all_.push_back(std::make_unique<Beside>(program, std::move(image), tick_us));
      view::RecordedProcessor recording;
      recording.mpu = static_cast<int>(all_.back()->image.mpu);
      recording.code = recorded_code(all_.back()->image);
      recordings_.push_back(std::move(recording));
    }
    all_.back()->lockstep.watch(seen_);
  }

  std::string name() const override { return "inside"; }
  std::int64_t tick_us() const override { return all_.front()->machine.tick_us(); }
  const std::vector<Conduction>& seen() const override { return seen_; }
  std::vector<int> sent() const override { return all_.back()->machine.sent(); }
  std::optional<std::uint32_t> clocks() const override {
    return all_.back()->lockstep.result().clocks;
  }
  const std::vector<view::RecordedProcessor>& recordings() const override { return recordings_; }

  void scan(std::span<const StimulusEvent> events) override {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Beside& each = *all_[i];
      each.recorded->begin(each.image);
      const auto difference = each.lockstep.scan(events);
      recordings_[i].clocks = each.recorded->clocks();
      if (difference) {
        throw std::runtime_error(fmt::format("MPU{} and reference differ: {}", recordings_[i].mpu,
                                             describe(*difference)));
      }
    }
  }

  std::int16_t value(Device device) override {
    Beside& last = *all_.back();
    const int index = is_port(device.kind) ? -1 : last.machine.find(device);
    return index < 0 ? last.lockstep.reference().get(device)
                     : last.machine.known_value(static_cast<std::size_t>(index));
  }

 private:
  std::vector<std::unique_ptr<Beside>> all_;
  std::vector<view::RecordedProcessor> recordings_;
  std::vector<Conduction> seen_;
};

}  // namespace

std::unique_ptr<view::Engine> make_inside_engine(const Program& program,
                                                 std::vector<image::Image> images,
                                                 std::int64_t tick_us) {
  return std::make_unique<InsideEngine>(program, std::move(images), tick_us);
}

}  // namespace rung::tb
