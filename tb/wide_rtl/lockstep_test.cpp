// SPDX-License-Identifier: Apache-2.0
// Compiled programs on the RTL, on the compiler's simulator of MPU4 and on the reference: every row
// of every step is that of the simulator, every device after every scan that of the reference, and
// the clocks are the image's.
//
// RUNG_SEED=n runs program n alone, RUNG_COUNT=n that many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "driver/compile.hpp"
#include "melsec/list.hpp"
#include "programs/random_program.hpp"
#include "programs/random_source.hpp"
#include "programs/samples.hpp"
#include "reference/reference.hpp"
#include "trace/stimulus.hpp"
#include "wide/simulate.hpp"
#include "wide_rtl/wide_rtl.hpp"

namespace rung::tb::wide {
namespace {

constexpr std::uint64_t kPrograms = 24;
constexpr int kScans = 6;

class Lockstep {
 public:
  Lockstep(const Program& program, const image::Image& image, int seed)
      : image_(image),
        wide_(image.wide.value()),
        machine_(*rung::wide::find_machine(wide_.slots)),
        simulator_(machine_),
        rtl_(make_wide_rtl(wide_.slots, seed)),
        reference_(program),
        inputs_(wide_.latched.size()) {
    for (std::size_t step = 0; step < wide_.code.size(); ++step) {
      for (int slot = 0; slot < wide_.slots; ++slot) {
        const auto& chunks = wide_.code[step][static_cast<std::size_t>(slot)];
        simulator_.load(static_cast<int>(step), slot, chunks);
        rtl_->load_chunks(static_cast<int>(step), slot, chunks);
      }
    }
    const int steps = static_cast<int>(wide_.code.size());
    simulator_.set_program(steps, wide_.first_latch_row, wide_.latch_rows);
    rtl_->set_program(steps, wide_.first_latch_row, wide_.latch_rows);
    // The memories of the RTL start as the registers do, if nobody has written them.
    for (const auto& device : image.devices) put(device.device, device.address, 0);
  }

  void set(std::size_t device, std::int16_t value) {
    const auto& named = image_.devices[device];
    reference_.set(named.device, value);
    for (std::size_t i = 0; i < wide_.latched.size(); ++i) {
      if (wide_.latched[i] == static_cast<int>(device)) inputs_[i] = value != 0 ? 1 : 0;
    }
    put(named.device, named.address, value);
  }

  void scan() {
    reference_.run_scan();
    simulator_.run_scan(inputs_);
    std::vector<bool> inputs(static_cast<std::size_t>(wide_.latch_rows * wide_.slots));
    for (std::size_t i = 0; i < inputs_.size(); ++i) inputs[i] = inputs_[i] != 0;
    const Scan scan = rtl_->scans({inputs}).front();
    ASSERT_EQ(scan.edges, image_.clocks);
    ASSERT_EQ(scan.clocks, image_.clocks);
    ASSERT_EQ(scan.rows.size(), wide_.code.size());
    for (int step = 0; step < static_cast<int>(scan.rows.size()); ++step) {
      const Row& row = scan.rows[static_cast<std::size_t>(step)];
      for (int slot = 0; slot < wide_.slots; ++slot) {
        ASSERT_EQ(row.bits[static_cast<std::size_t>(slot)], simulator_.computed_bit(step, slot))
            << "step " << step << ", slot " << slot;
      }
      for (int unit = 0; unit < wide_.slots / 2; ++unit) {
        ASSERT_EQ(row.words[static_cast<std::size_t>(unit)], simulator_.computed_word(step, unit))
            << "step " << step << ", unit " << unit;
      }
    }
    ASSERT_EQ(scan.error, reference_.error());
    for (const auto& named : image_.devices) {
      const std::int16_t expected = reference_.get(named.device);
      const auto got =
          is_word(named.device)
              ? static_cast<std::int16_t>(
                    rtl_->read_word({named.address / rtl_->units(), named.address % rtl_->units()}))
              : static_cast<std::int16_t>(
                    rtl_->read_bit({named.address / wide_.slots, named.address % wide_.slots}));
      ASSERT_EQ(got, expected) << named.name;
    }
  }

  const image::Image& image() const { return image_; }

 private:
  void put(Device device, int address, std::int16_t value) {
    if (is_word(device)) {
      simulator_.set_word(address, static_cast<std::uint16_t>(value));
      rtl_->write_word({address / rtl_->units(), address % rtl_->units()},
                       static_cast<std::uint16_t>(value));
    } else {
      simulator_.set_bit(address, value != 0);
      rtl_->write_bit({address / wide_.slots, address % wide_.slots}, value != 0);
    }
  }

  const image::Image& image_;
  const image::WideImage& wide_;
  const rung::wide::Machine& machine_;
  rung::wide::Simulator simulator_;
  std::unique_ptr<WideRtl> rtl_;
  Reference reference_;
  std::vector<std::uint8_t> inputs_;
};

// Compiles and runs with random values of inputs and, less often, of all else.
void run(const std::string& text, Dialect dialect, int slots, bool merge, std::uint64_t seed) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, fmt::format("random-{}.il", seed), diagnostics);
  const auto program = parse_list(*source, dialect, diagnostics);
  ASSERT_TRUE(program);
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = slots;
  options.merge = merge;
  options.search.tries = 4;
  const auto compiled = compile(*program, options, diagnostics);
  std::ostringstream said;
  diagnostics.print(said);
  ASSERT_TRUE(compiled) << said.str();
  testing::Test::RecordProperty("clocks", static_cast<int>(compiled->image.clocks));
  testing::Test::RecordProperty("latch_rows", compiled->image.wide->latch_rows);
  Lockstep lockstep(*program, compiled->image, static_cast<int>(seed));
  RandomSource random(seed ^ 0x72746c);
  for (int scan = 0; scan < kScans; ++scan) {
    for (std::size_t i = 0; i < compiled->image.devices.size(); ++i) {
      const Device device = compiled->image.devices[i].device;
      const bool chosen = is_word(device) ? random.percent(scan == 0 ? 50 : 5)
                                          : random.percent(is_input(device) ? 50 : 5);
      const auto value = static_cast<std::int16_t>(random.bits());
      if (chosen) lockstep.set(i, is_word(device) ? value : static_cast<std::int16_t>(value & 1));
    }
    SCOPED_TRACE(fmt::format("{} slots, scan {}", slots, scan));
    lockstep.scan();
    if (testing::Test::HasFatalFailure()) return;
  }
}

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

TEST(WideLockstep, RandomPrograms) {
  const std::uint64_t only = from_environment("RUNG_SEED", 0);
  const std::uint64_t count = only != 0 ? 1 : from_environment("RUNG_COUNT", kPrograms);
  const std::uint64_t first = only != 0 ? only : 1;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("RUNG_SEED={} wide_rtl --gtest_filter='*RandomPrograms'", seed));
    RandomSource random(seed ^ 0x6c6f636b);
    RandomProgramOptions options;
    options.dialect = Dialect::Paper;
    options.networks = 16 + random.below(10);
    const int density = random.below(3);
    options.inputs = 4 << density;
    options.outputs = 2 << 2 * density;
    options.relays = 3 << 2 * density;
    options.words = 3 << density;
    static constexpr int kSlots[] = {4, 8, 16};
    run(random_program(seed, options), options.dialect, kSlots[seed % 3], seed / 3 % 2 == 0, seed);
    if (HasFatalFailure()) return;
  }
}

class WideSample : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Slots, WideSample, testing::Values(8, 16));

TEST_P(WideSample, Sample1) { run(sample_program(1, 30, 1), Dialect::Paper, GetParam(), true, 1); }

}  // namespace
}  // namespace rung::tb::wide
