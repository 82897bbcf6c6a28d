// SPDX-License-Identifier: Apache-2.0
// The tables of the task hardware in a load file.
#include <fmt/format.h>

#include "flow_compile/support.hpp"
#include "load/format.hpp"
#include "load/load_file.hpp"
#include "load/units.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

using namespace flow;

constexpr std::int64_t kHz = 25'000'000;

struct Made {
  std::optional<load::Contents> contents;
  std::string problem;
  std::vector<std::uint16_t> words;

  int at(int space, int address) const {
    const auto value = contents->at(space, static_cast<std::uint32_t>(address));
    return value ? *value : -1;
  }
  int count(int space) const {
    int found = 0;
    for (const auto& [place, value] : contents->values) found += place.first == space ? 1 : 0;
    return found;
  }
};

Made make(const image::Image& image, const std::function<void(io::Settings&)>& change = {}) {
  Made made;
  Diagnostics diagnostics;
  const io::Subject subject = load::subject_of(image);
  auto bindings = io::bind(io::default_map(subject, diagnostics), subject, diagnostics);
  if (change) change(bindings.settings);
  const auto words = load::make(image, bindings, kHz, diagnostics);
  if (!words) {
    made.problem = printed(diagnostics);
    return made;
  }
  made.words = *words;
  made.contents = load::read(*words, made.problem);
  EXPECT_TRUE(made.contents) << made.problem;
  return made;
}

TEST(FlowLoadFile, HoldsTheTables) {
  const image::Image image = image_of(example().chart);
  const image::FlowImage& flow = *image.flow;
  const Made made = make(image);
  ASSERT_TRUE(made.contents);
  EXPECT_EQ(made.at(controller::space_length, 0), flow.ladder_steps);
  EXPECT_EQ(made.count(controller::space_steps),
            static_cast<int>(image.steps.size()) * made.contents->chunks);
  EXPECT_EQ(made.count(space_flow_steps), 4 * 3);
  for (int step = 0; step < 3; ++step) {
    const image::FlowStep& each = flow.steps[static_cast<std::size_t>(step)];
    EXPECT_EQ(made.at(space_flow_steps, 4 * step), each.entry);
    EXPECT_EQ(made.at(space_flow_steps, 4 * step + 1), each.end);
    EXPECT_EQ(made.at(space_flow_steps, 4 * step + 2), each.read);
    EXPECT_EQ(made.at(space_flow_steps, 4 * step + 3), each.write);
  }
  EXPECT_EQ(made.count(space_flow_transfers), 4 * 3);
  const int transfers[3][3] = {{1 * 256 + 3, 400, 4}, {2 * 256 + 5, 7, 2}, {1 * 256 + 0, 20, 3}};
  for (int number = 1; number <= 3; ++number) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(made.at(space_flow_transfers, 4 * number + k), transfers[number - 1][k]);
    }
    EXPECT_EQ(made.at(space_flow_transfers, 4 * number + 3), flow.transfer(number).address);
  }
  EXPECT_EQ(made.count(space_flow_tasks), 2);
  EXPECT_EQ(made.at(space_flow_tasks, 0), 0x8000);
  EXPECT_EQ(made.at(space_flow_tasks, 1), 2);
  const auto setup = [&](int number) { return made.at(space_flow_setup, number); };
  EXPECT_EQ(setup(flow_setup_enable), 1);
  EXPECT_EQ(setup(flow_setup_unit), 1);
  EXPECT_EQ(setup(flow_setup_next_word), flow.next_word);
  EXPECT_EQ(setup(flow_setup_task_word), flow.task_word);
  EXPECT_EQ(setup(flow_setup_status_word), flow.status_word);
  EXPECT_EQ(setup(flow_setup_link_timeout), 50);
  EXPECT_EQ(setup(flow_setup_panel_timeout), 500);
  EXPECT_EQ(setup(flow_setup_panel_unit), 1);
  EXPECT_EQ(setup(flow_setup_panel_baud_low) | setup(flow_setup_panel_baud_high) << 16,
            load::baud_step(115200, kHz));
  EXPECT_EQ(setup(flow_setup_panel_parity), 2);
  // Boards of this unit: memory 0, panel 3.
  EXPECT_EQ(setup(64 + 0), 0b0001);
  EXPECT_EQ(setup(64 + 3), 0b1111);
  EXPECT_EQ(made.count(space_flow_setup), 11 + 2);
}

TEST(FlowLoadFile, HoldsTheSettings) {
  const Made made = make(image_of(example().chart), [](io::Settings& settings) {
    settings.flow = {7, 300, 9, 38400, io::Parity::None, false};
  });
  ASSERT_TRUE(made.contents);
  EXPECT_EQ(made.at(space_flow_setup, flow_setup_enable), 3);
  EXPECT_EQ(made.at(space_flow_setup, flow_setup_link_timeout), 7);
  EXPECT_EQ(made.at(space_flow_setup, flow_setup_panel_timeout), 300);
  EXPECT_EQ(made.at(space_flow_setup, flow_setup_panel_unit), 9);
  EXPECT_EQ(made.at(space_flow_setup, flow_setup_panel_parity), 0);
  const Made fast = make(image_of(example().chart),
                         [](io::Settings& settings) { settings.flow.panel_baud = 50'000'000; });
  EXPECT_FALSE(fast.contents);
  EXPECT_NE(fast.problem.find("50000000 baud of the panel's line"), std::string::npos);
}

// The settings as a map says them, with what there is to say about it.
Made with_map(const image::Image& image, const std::string& table, std::string& messages) {
  Diagnostics diagnostics;
  std::string text = "board = \"simulated\"\n" + table + "[outputs]\n";
  for (int n = 0; n < 4; ++n) text += fmt::format("Y{0} = \"out{0}\"\n", n);
  const auto map = io::parse_map(text, "m.toml", diagnostics);
  EXPECT_TRUE(map);
  const auto bindings = io::bind(*map, load::subject_of(image), diagnostics);
  messages = printed(diagnostics);
  return make(image, [&](io::Settings& settings) { settings = bindings.settings; });
}

TEST(FlowLoadFile, HoldsWhatTheMapSays) {
  const image::Image image = image_of(example().chart);
  std::string messages;
  const Made made =
      with_map(image,
               "[flow]\nsuspend = true\nlink_timeout_ms = 10000\npanel_timeout_ms = 1\n"
               "panel_unit = 247\npanel_baud = 921600\npanel_parity = \"odd\"\n",
               messages);
  EXPECT_EQ(messages, "");
  ASSERT_TRUE(made.contents);
  const auto setup = [](const Made& of, int number) { return of.at(space_flow_setup, number); };
  EXPECT_EQ(setup(made, flow_setup_enable), 1);
  EXPECT_EQ(setup(made, flow_setup_link_timeout), 10000);
  EXPECT_EQ(setup(made, flow_setup_panel_timeout), 1);
  EXPECT_EQ(setup(made, flow_setup_panel_unit), 247);
  EXPECT_EQ(setup(made, flow_setup_panel_baud_low) | setup(made, flow_setup_panel_baud_high) << 16,
            load::baud_step(921600, kHz));
  EXPECT_EQ(setup(made, flow_setup_panel_parity), 1);

  // What it does not say is as without it.
  const Made other = with_map(image, "[flow]\npanel_unit = 7\n", messages);
  EXPECT_EQ(messages, "");
  Made without = make(image);
  const std::pair key{space_flow_setup, static_cast<std::uint32_t>(flow_setup_panel_unit)};
  without.contents->values[key] = 7;
  for (const auto& [place, value] : without.contents->values) {
    if (place.first == space_flow_setup) {
      EXPECT_EQ(other.at(place.first, static_cast<int>(place.second)), value) << place.second;
    }
  }

  const Made waiting = with_map(image, "[flow]\npanel_unit = 7\nsuspend = false\n", messages);
  EXPECT_EQ(setup(waiting, flow_setup_enable), 3);
  EXPECT_NE(messages.find("m.toml:4:1: warning: suspend: steps wait"), std::string::npos)
      << messages;
}

// A clock that cannot make the panel's rate matters only where there is a panel.
TEST(FlowLoadFile, ARateMattersOnlyWithAPanel) {
  const auto fast = [](io::Settings& settings) { settings.flow.panel_baud = 50'000'000; };
  ChartMaker maker("LD X0\nOUT Y0\n");
  maker.task("t").step("LD X1\nOUT Y1\n").read(kOther, 0, 1, {DeviceKind::D, 0});
  EXPECT_FALSE(make(image_of(maker.chart), fast).contents);
  maker.chart.boards[kPanel].panel = false;
  const Made without = make(image_of(maker.chart), fast);
  ASSERT_TRUE(without.contents) << without.problem;
  EXPECT_EQ(without.at(space_flow_setup, flow_setup_panel_baud_high), 0xF);  // 4 bits
}

TEST(FlowLoadFile, OfAProgramWithoutFlowsHasNoneOfIt) {
  Diagnostics diagnostics;
  const auto compiled = compile(list(ladder_text()), {}, diagnostics);
  ASSERT_TRUE(compiled);
  const Made made = make(compiled->image);
  ASSERT_TRUE(made.contents);
  for (const int space :
       {space_flow_steps, space_flow_transfers, space_flow_tasks, space_flow_setup}) {
    EXPECT_EQ(made.count(space), 0);
  }
}

TEST(FlowLoadFile, AddressesBehindTheTablesAreRefused) {
  const std::vector<std::uint16_t> good = make(image_of(example().chart)).words;
  const std::pair<int, int> lasts[] = {{space_flow_steps, 4 * 2048 - 1},
                                       {space_flow_transfers, 4 * 256 - 1},
                                       {space_flow_tasks, 99},
                                       {space_flow_setup, 64 + 15}};
  for (const auto& [space, last] : lasts) {
    for (const int beyond : {0, 1}) {
      std::vector<std::uint16_t> words = good;
      // One record more, in front of all others.
      const std::uint16_t record[] = {static_cast<std::uint16_t>(space << 12 | 1),
                                      static_cast<std::uint16_t>(last + beyond), 1};
      words.insert(words.begin() + load::kHeaderWords, std::begin(record), std::end(record));
      words[load::kLengthAt] = static_cast<std::uint16_t>(words.size());
      words[load::kLengthAt + 1] = static_cast<std::uint16_t>(words.size() >> 16);
      std::string problem;
      EXPECT_EQ(load::read(words, problem).has_value(), beyond == 0) << problem;
    }
  }
}

}  // namespace
}  // namespace rung::tb
