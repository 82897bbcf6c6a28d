// SPDX-License-Identifier: Apache-2.0
#include "view/processor_engine.hpp"

#include <fmt/format.h>

#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

class ProcessorEngine final : public view::Engine {
 public:
  ProcessorEngine(const Program& program, image::Image image, std::int64_t tick_us)
      : image_(std::move(image)),
        processor_(make_processor(image_.mpu, *isa::find_config(image_.config))),
        machine_(image_, *processor_, tick_us),
        lockstep_(program, machine_),
        seen_(program.instructions.size()) {
    lockstep_.watch(seen_);
  }

  std::string name() const override { return fmt::format("mpu{}", static_cast<int>(image_.mpu)); }
  std::int64_t tick_us() const override { return machine_.tick_us(); }
  const std::vector<Conduction>& seen() const override { return seen_; }
  std::vector<int> sent() const override { return machine_.sent(); }
  std::optional<std::uint32_t> clocks() const override { return lockstep_.result().clocks; }

  void scan(std::span<const StimulusEvent> events) override {
    if (const auto difference = lockstep_.scan(events)) {
      throw std::runtime_error("processor and reference differ: " + describe(*difference));
    }
  }

  std::int16_t value(Device device) override {
    if (is_port(device.kind)) return lockstep_.reference().get(device);
    const int index = machine_.find(device);
    return index < 0 ? lockstep_.reference().get(device)
                     : machine_.known_value(static_cast<std::size_t>(index));
  }

 private:
  image::Image image_;
  std::unique_ptr<Processor> processor_;
  Machine machine_;
  Lockstep lockstep_;
  std::vector<Conduction> seen_;
};

}  // namespace

std::unique_ptr<view::Engine> make_processor_engine(const Program& program, image::Image image,
                                                    std::int64_t tick_us) {
  return std::make_unique<ProcessorEngine>(program, std::move(image), tick_us);
}

}  // namespace rung::tb
