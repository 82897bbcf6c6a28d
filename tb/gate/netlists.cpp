// SPDX-License-Identifier: Apache-2.0
#include "gate/netlists.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "gate_headers.inc"
#include "harness/verilated_processor.hpp"
#include "lockstep/machine.hpp"
#include "lockstep/wide_machine.hpp"
#include "wide_rtl/verilated_wide.hpp"

namespace rung::tb {
namespace {

struct Made {
  NetlistInfo info;
  std::function<LoadedMachine(const image::Image&, std::int64_t)> load;
};

template <typename Rtl, typename Netlist, isa::Mpu kMpu, int kSlots>
Made make(const char* name, const char* config_name) {
  const isa::Config* config = isa::find_config(config_name);
  return {{name, kMpu, config, kSlots}, [config](const image::Image& image, std::int64_t tick) {
            using Model = Paired<Rtl, Netlist>;
            LoadedMachine loaded;
            if constexpr (kMpu == isa::Mpu::Mpu4) {
              auto processor = std::make_unique<WideProcessor>(
                  kSlots, std::make_unique<tb::wide::VerilatedWide<Model, kSlots>>(1));
              loaded.machine = std::make_unique<WideMachine>(image, *processor, tick);
              loaded.processor = std::move(processor);
            } else {
              auto processor = std::make_unique<VerilatedProcessor<Model, kMpu>>(*config);
              loaded.machine = std::make_unique<Machine>(image, *processor, tick);
              loaded.processor = std::move(processor);
            }
            return loaded;
          }};
}

const std::vector<Made>& all() {
  static const std::vector<Made> made = {
#define RUNG_NETLIST(name, config, rtl, netlist, mpu, slots) \
  make<rtl, netlist, isa::Mpu::mpu, slots>(name, config),
#include "gate_table.inc"
  };
  return made;
}

}  // namespace

const std::vector<NetlistInfo>& netlists() {
  static const std::vector<NetlistInfo> infos = [] {
    std::vector<NetlistInfo> found;
    for (const Made& made : all()) found.push_back(made.info);
    return found;
  }();
  return infos;
}

LoadedMachine load_netlist(const NetlistInfo& netlist, const image::Image& image,
                           std::int64_t tick_us) {
  const auto made = std::find_if(all().begin(), all().end(),
                                 [&](const Made& each) { return each.info.name == netlist.name; });
  if (made == all().end()) throw std::invalid_argument("no netlist " + netlist.name);
  gate_state.comparing = true;
  return made->load(image, tick_us);
}

void read_all(const NetlistInfo& netlist, const image::Image& image, DeviceMemory& memory) {
  if (!image.wide) {
    for (int i = 0; i < netlist.config->bit_devices; ++i) memory.read_bit(i);
    for (int i = 0; i < netlist.config->word_devices; ++i) memory.read_word(i);
    return;
  }
  const int steps = static_cast<int>(image.wide->code.size());
  for (int i = 0; i < steps * netlist.slots; ++i) memory.read_bit(i);
  for (int i = 0; i < steps * netlist.slots / 2; ++i) memory.read_word(i);
}

}  // namespace rung::tb
