// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "plant/plant.hpp"
#include "programs/random_source.hpp"

namespace rung::tb {
namespace {

// Lengths in millimetres, times in milliseconds.
class Conveyor final : public Plant {
 public:
  explicit Conveyor(std::uint64_t seed) : random_(seed) {}

  std::string name() const override { return "conveyor"; }
  std::string program() const override { return "tb/plant/programs/sorter.il"; }
  std::vector<std::string> inputs() const override {
    return {"X0", "X1", "X2", "X3", "X4", "X5", "X6", "X7", "X10", "X11"};
  }
  std::vector<std::string> outputs() const override { return {"Y0", "Y1", "Y2", "Y3", "Y4", "Y5"}; }

  std::uint64_t step(std::uint64_t outputs, int ms) override {
    time_ms_ += ms;
    move_belt((outputs & kBelt) != 0, ms);
    move_pusher((outputs & kOut) != 0, (outputs & kBack) != 0, ms);
    operate(outputs, ms);
    return sensors();
  }

  std::string accident() const override { return accident_; }
  std::string work() const override {
    return fmt::format("{} parts left the belt's end, {} were pushed off, {} emergency stops",
                       gone_, pushed_, emergencies_);
  }
  bool busy() const override {
    return gone_ > 0 && pushed_ > 0 && (gone_ + pushed_) * 20'000 > time_ms_;
  }

 private:
  static constexpr std::uint64_t kBelt = 1, kOut = 2, kBack = 4, kGreen = 8, kRed = 16;
  static constexpr double kSpeed = 0.4;  // mm a ms
  static constexpr double kGate = 2000;  // where the photo cells look
  static constexpr double kEnd = 3000;   // where a part leaves
  static constexpr double kPartLength = 120;
  static constexpr double kStroke = 300;  // of the pusher
  static constexpr double kPusherSpeed = 0.8;

  struct Part {
    double front;
    bool tall;
  };

  bool at_gate(const Part& part) const {
    return part.front >= kGate && part.front - kPartLength < kGate;
  }

  void move_belt(bool runs, int ms) {
    if (!runs) return;
    for (Part& part : parts_) part.front += kSpeed * ms;
    if (!parts_.empty() && parts_.front().front - kPartLength > kEnd) {
      if (parts_.front().tall) accident("a tall part left at the end");
      parts_.pop_front();
      ++gone_;
    }
    next_part_ms_ -= ms;
    if (next_part_ms_ > 0) return;
    next_part_ms_ = static_cast<int>(random_.below(6000)) + 1500;
    parts_.push_back({0, random_.percent(40)});
  }

  void move_pusher(bool out, bool back, int ms) {
    if (out && back) accident("the pusher is driven both ways");
    if (out) pusher_ = std::min(kStroke, pusher_ + kPusherSpeed * ms);
    if (back) pusher_ = std::max(0.0, pusher_ - kPusherSpeed * ms);
    if (pusher_ < kStroke / 2) return;
    const auto pushed = std::find_if(parts_.begin(), parts_.end(),
                                     [this](const Part& part) { return at_gate(part); });
    if (pushed == parts_.end()) return;
    if (!pushed->tall) accident("a short part was pushed off");
    parts_.erase(pushed);
    ++pushed_;
  }

  // The operator starts after a second, stops for a while now and then, and acknowledges what the
  // red lamp shows; somebody hits the emergency stop at times.
  void operate(std::uint64_t outputs, int ms) {
    next_act_ms_ -= ms;
    press_ms_ -= ms;
    if ((outputs & kRed) != 0 && !stop_) faulty_ = true;
    if (press_ms_ <= 0) start_ = stop_ = acknowledge_ = false;
    if (next_act_ms_ > 0) return;
    if (emergency_) {
      emergency_ = false;
      next_act_ms_ = 500;
      return;
    }
    next_act_ms_ = 1000;
    press_ms_ = 200;
    if (faulty_) {
      pusher_ = 0;
      acknowledge_ = true;
      faulty_ = false;
    } else if ((outputs & kGreen) == 0) {
      start_ = true;
    } else if (random_.below(300) == 0) {
      stop_ = true;
      next_act_ms_ = 5000;
    } else if (random_.below(300) == 0) {
      emergency_ = true;
      ++emergencies_;
      next_act_ms_ = 2000;
    }
  }

  std::uint64_t sensors() const {
    const auto gate = std::find_if(parts_.begin(), parts_.end(),
                                   [this](const Part& part) { return at_gate(part); });
    const bool leaving = !parts_.empty() && parts_.front().front >= kEnd;
    const bool all[] = {start_,
                        stop_,
                        !emergency_,
                        true,
                        gate != parts_.end(),
                        gate != parts_.end() && gate->tall,
                        pusher_ <= 0,
                        pusher_ >= kStroke,
                        leaving,
                        acknowledge_};
    std::uint64_t inputs = 0;
    for (std::size_t i = 0; i < std::size(all); ++i) inputs |= std::uint64_t{all[i]} << i;
    return inputs;
  }

  void accident(const std::string& what) {
    if (accident_.empty()) accident_ = fmt::format("{} ms: {}", time_ms_, what);
  }

  RandomSource random_;
  std::int64_t time_ms_ = 0;
  std::string accident_;
  std::deque<Part> parts_;  // the foremost first
  double pusher_ = 0;       // how far it is out
  int next_part_ms_ = 500;
  int next_act_ms_ = 1000;
  int press_ms_ = 0;
  bool start_ = false, stop_ = false, acknowledge_ = false, emergency_ = false, faulty_ = false;
  int gone_ = 0, pushed_ = 0, emergencies_ = 0;
};

}  // namespace

std::unique_ptr<Plant> make_conveyor(std::uint64_t seed) {
  return std::make_unique<Conveyor>(seed);
}

}  // namespace rung::tb
