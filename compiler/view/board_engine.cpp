// SPDX-License-Identifier: Apache-2.0
#include "view/board_engine.hpp"

#include <fmt/format.h>

#include <map>

#include "client/controller.hpp"
#include "rungs/devices.hpp"

namespace rung::view {
namespace {

// From sample to sample; a slow line takes longer.
constexpr std::int64_t kSample = 100'000;
// Numbers of the command register.
constexpr int kRun = 1, kStop = 2, kScan = 3;

class BoardEngine final : public Engine {
 public:
  BoardEngine(const ProgramView& view, client::LineOptions line)
      : view_(view), line_(std::move(line)), seen_(view.program().instructions.size()) {
    connect();
  }

  std::string name() const override { return "controller"; }
  bool is_live() const override { return true; }
  std::int64_t tick_us() const override { return kSample; }
  const std::vector<Conduction>& seen() const override { return seen_; }
  std::optional<std::uint32_t> clocks() const override { return status_.scan_last; }
  std::string state() override { return state_; }

  void scan(std::span<const StimulusEvent> events) override {
    talk([&] {
      for (const StimulusEvent& event : events) write(event);
      status_ = controller_->status();
      state_ = fmt::format("{}, {} scans", client::state_name(status_.state), status_.scan_count);
      if (status_.fault != 0) state_ += fmt::format(", {}", client::fault_name(status_.fault));
      const auto values =
          client::read_values(controller_->line(), watched_, status_.exchange_points);
      for (std::size_t i = 0; i < values.size(); ++i) {
        values_[devices_[i]] = static_cast<std::int16_t>(values[i]);
      }
      forces_ = status_.forces == 0 ? std::vector<client::Force>{} : controller_->forces();
    });
    conduct(
        view_.program(), [this](Device device) { return value(device); }, seen_);
  }

  std::int16_t value(Device device) override {
    const auto found = values_.find(device);
    return found == values_.end() ? std::int16_t{0} : found->second;
  }

  void force(Device device, std::optional<std::int16_t> value) override {
    if (device.kind != DeviceKind::X && device.kind != DeviceKind::Y) {
      throw std::runtime_error("a controller forces inputs (X) and outputs (Y) only: set it");
    }
    talk([&] {
      const io::Point point = point_of(device);
      if (value) {
        controller_->force(point.address, *value != 0);
      } else {
        controller_->release(point.address);
      }
    });
  }

  std::vector<Forced> forces() override {
    std::vector<Forced> all;
    for (const client::Force& each : forces_) {
      for (const io::Table table : {io::Table::Coil, io::Table::Discrete}) {
        const auto device = io::device_at(table, each.address, dialect(), config_);
        if (!device) continue;
        all.push_back({*device, static_cast<std::int16_t>(each.value)});
        break;
      }
    }
    return all;
  }

  void order(Order order) override {
    talk([&] {
      controller_->command(order == Order::Run ? kRun : order == Order::Stop ? kStop : kScan);
    });
  }

 private:
  Dialect dialect() const {
    return view_.chart() ? view_.chart()->dialect : view_.program().dialect;
  }

  void connect() {
    controller_ = std::make_unique<client::Controller>(line_);
    config_ = controller_->config();
    watched_.clear();
    devices_.clear();
    for (const DeviceView& each : view_.devices()) {
      const auto point = io::point_of(each.device, dialect(), config_);
      if (!point || each.device.kind == DeviceKind::CNH) continue;
      devices_.push_back(each.device);
      watched_.push_back({*point, false});
    }
  }

  // A line that has failed is opened anew with the next request.
  template <typename Requests>
  void talk(Requests requests) {
    try {
      if (!controller_) connect();
      requests();
    } catch (const client::ExceptionError& error) {
      throw std::runtime_error(fmt::format("{}; {}", error.what(), error.mend));
    } catch (const client::ClientError& error) {
      controller_.reset();
      throw std::runtime_error(fmt::format("{}; {}", error.what(), error.mend));
    }
  }

  io::Point point_of(Device device) const {
    const auto point = io::point_of(device, dialect(), config_);
    if (!point) throw std::runtime_error("the controller has no address for this device");
    return *point;
  }

  void write(const StimulusEvent& event) {
    if (event.device.kind == DeviceKind::X) {
      throw std::runtime_error("an input of a controller comes from its pin: force it instead");
    }
    const io::Point point = point_of(event.device);
    if (point.table == io::Table::Holding) {
      const std::uint16_t word = static_cast<std::uint16_t>(event.value);
      controller_->line().write_words(point.address, {&word, 1});
    } else {
      controller_->line().write_bit(point.address, event.value != 0);
    }
  }

  const ProgramView& view_;
  client::LineOptions line_;
  std::unique_ptr<client::Controller> controller_;
  std::string config_;
  std::vector<client::Watched> watched_;
  std::vector<Device> devices_;  // of watched_
  std::map<Device, std::int16_t> values_;
  client::Status status_;
  std::string state_;
  std::vector<client::Force> forces_;
  std::vector<Conduction> seen_;
};

}  // namespace

std::unique_ptr<Engine> make_board_engine(const ProgramView& view,
                                          const client::LineOptions& line) {
  return std::make_unique<BoardEngine>(view, line);
}

}  // namespace rung::view
