// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "plant/plant.hpp"
#include "programs/random_source.hpp"

namespace rung::tb {
namespace {

class Crossing final : public Plant {
 public:
  explicit Crossing(std::uint64_t seed) : random_(seed) {}

  std::string name() const override { return "crossing"; }
  std::string program() const override { return "tb/plant/programs/crossing.il"; }
  std::vector<std::string> inputs() const override { return {"X0", "X1", "X2"}; }
  std::vector<std::string> outputs() const override { return {"Y0", "Y1", "Y2", "Y3", "Y4", "Y5"}; }

  std::uint64_t step(std::uint64_t outputs, int ms) override {
    time_ms_ += ms;
    look(outputs);
    come(ms);
    service(ms);
    std::uint64_t inputs = 0;
    for (int side = 0; side < 2; ++side) {
      pressed_ms_[side] -= ms;
      if (pressed_ms_[side] > 0) inputs |= 1U << side;
    }
    if (out_of_service_) inputs |= 4;
    return inputs;
  }

  std::string accident() const override { return accident_; }
  std::string work() const override {
    return fmt::format("{} people came, {} walked in {} walks, {} times out of service", came_,
                       walked_, walks_, services_);
  }
  bool busy() const override { return walks_ * 120'000 > time_ms_ && walked_ > 0; }

 private:
  static constexpr std::uint64_t kCarsRed = 1, kCarsAmber = 2, kCarsGreen = 4, kRedMan = 8,
                                 kGreenMan = 16;

  void look(std::uint64_t outputs) {
    const bool walk = (outputs & kGreenMan) != 0;
    if (walk && (outputs & kCarsRed) == 0) accident("green man, and cars have no red");
    if (walk && (outputs & kCarsGreen) != 0) accident("green for both");
    if (walk && (outputs & kRedMan) != 0) accident("both men");
    if ((outputs & kCarsGreen) != 0 && (outputs & (kCarsRed | kCarsAmber)) != 0) {
      accident("green and another light for cars");
    }
    // The green man blinks at the end: a walk ends when the red one comes.
    if (walk && !walking_) {
      ++walks_;
      walking_ = true;
      walked_ += waiting_;
      waiting_ = 0;
    }
    if ((outputs & kRedMan) != 0) walking_ = false;
  }

  // Some 3 people a minute; most press the button, those who see the lamp lit may not.
  void come(int ms) {
    next_ms_ -= ms;
    if (next_ms_ > 0) return;
    next_ms_ = static_cast<int>(random_.below(40'000)) + 500;
    ++came_;
    ++waiting_;
    const int side = random_.percent(50) ? 0 : 1;
    pressed_ms_[side] = static_cast<int>(random_.below(900)) + 50;
  }

  void service(int ms) {
    service_ms_ -= ms;
    if (service_ms_ > 0) return;
    out_of_service_ = !out_of_service_;
    services_ += out_of_service_ ? 1 : 0;
    service_ms_ = out_of_service_ ? 20'000 : 600'000;
  }

  void accident(const std::string& what) {
    if (accident_.empty()) accident_ = fmt::format("{} ms: {}", time_ms_, what);
  }

  RandomSource random_;
  std::int64_t time_ms_ = 0;
  std::string accident_;
  int next_ms_ = 2000;
  int service_ms_ = 200'000;
  bool out_of_service_ = false;
  int pressed_ms_[2] = {0, 0};
  bool walking_ = false;
  int waiting_ = 0;
  int came_ = 0, walked_ = 0, walks_ = 0, services_ = 0;
};

}  // namespace

std::unique_ptr<Plant> make_crossing(std::uint64_t seed) {
  return std::make_unique<Crossing>(seed);
}

}  // namespace rung::tb
