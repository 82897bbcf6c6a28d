// SPDX-License-Identifier: Apache-2.0
// The file and the listing of an image with flow tasks.
#include <functional>
#include <random>

#include "flow_compile/support.hpp"
#include "image/image_file.hpp"

namespace rung::tb {
namespace {

std::optional<image::Image> back(const image::Image& image, std::string* error = nullptr) {
  Diagnostics diagnostics;
  auto read = image::from_bytes(image::to_bytes(image), "x.img", diagnostics);
  if (error != nullptr) *error = printed(diagnostics);
  return read;
}

TEST(FlowImageFile, ReadsBackTheSame) {
  for (const int mpu : {1, 2, 3}) {
    const image::Image image = image_of(example().chart, mpu);
    const auto read = back(image);
    ASSERT_TRUE(read);
    ASSERT_TRUE(read->flow);
    // What is written is all there is: the bytes of what was read are those that were read.
    EXPECT_EQ(image::to_bytes(*read), image::to_bytes(image));
    EXPECT_EQ(image::listing(*read), image::listing(image));
    const image::FlowImage& flow = *read->flow;
    EXPECT_EQ(flow.ladder_steps, image.flow->ladder_steps);
    EXPECT_EQ(read->length(), image.length());
    EXPECT_EQ(flow.status_word, image.flow->status_word);
    EXPECT_EQ(flow.boards[1].name, "panel");
    EXPECT_TRUE(flow.boards[1].panel && flow.boards[1].exclusive && flow.boards[1].over_link);
    EXPECT_EQ(flow.transfers[1].address, image.flow->transfers[1].address);
    EXPECT_EQ(flow.tasks[1].name, "heat");
    EXPECT_EQ(flow.steps[2].clocks, image.flow->steps[2].clocks);
    EXPECT_EQ(flow.steps[1].next, (std::vector<int>{0}));
    EXPECT_EQ(flow.steps[1].text, "step s1");
    EXPECT_EQ(flow.steps[1].position, image.flow->steps[1].position);
  }
}

TEST(FlowImageFile, DamageIsFound) {
  const std::string good = image::to_bytes(image_of(example().chart));
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const std::size_t at = random() % good.size();
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ (1 << random() % 8));
    Diagnostics diagnostics;
    ASSERT_FALSE(image::from_bytes(bad, "x.img", diagnostics)) << "byte " << at;
    ASSERT_FALSE(image::from_bytes(good.substr(0, at), "x.img", diagnostics)) << "cut at " << at;
  }
}

// A file that is whole but says what cannot be.
TEST(FlowImageFile, NonsenseIsRefused) {
  const image::Image good = image_of(example().chart);
  ASSERT_TRUE(back(good));
  const auto refused = [&](const char* what, const std::function<void(image::FlowImage&)>& change) {
    image::Image bad = good;
    change(*bad.flow);
    std::string error;
    EXPECT_FALSE(back(bad, &error)) << what;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  using Flow = image::FlowImage;
  refused("number of the unit", [](Flow& f) { f.unit = 0; });
  refused("number of the unit", [](Flow& f) { f.unit = 16; });
  refused("words of the task hardware", [](Flow& f) { f.next_word = 1024; });
  refused("words of the task hardware", [](Flow& f) { f.task_word = -1; });
  refused("words of the task hardware", [](Flow& f) { f.status_word = 70000; });
  refused("steps of the ladder", [](Flow& f) { f.ladder_steps = -1; });
  refused("steps of the ladder", [](Flow& f) { f.ladder_steps = 9999; });
  refused("routine of a flow step", [](Flow& f) { f.ladder_steps -= 1; });
  refused("number of tasks", [](Flow& f) { f.tasks.resize(101); });
  refused("first step of a task", [](Flow& f) { f.tasks[0].first = 3; });
  refused("first step of a task", [](Flow& f) { f.tasks[0].first = -1; });
  refused("unit of a board", [](Flow& f) { f.boards[2].unit = 0; });
  refused("number of a board", [](Flow& f) { f.boards[0].number = 16; });
  refused("number of a board", [](Flow& f) { f.boards[2].number = 256; });
  refused("two boards of one number", [](Flow& f) { f.boards[0].number = 3; });
  refused("number of transfers", [](Flow& f) { f.transfers.resize(256, f.transfers[0]); });
  refused("board of a transfer", [](Flow& f) { f.transfers[0].board = 3; });
  refused("words of a transfer", [](Flow& f) { f.transfers[0].count = 0; });
  refused("words of a transfer", [](Flow& f) { f.transfers[0].count = 33; });
  refused("variables of a transfer", [](Flow& f) { f.transfers[0].first = 65533; });
  refused("devices of a transfer", [](Flow& f) { f.transfers[0].address = 1021; });
  refused("number of flow steps", [](Flow& f) { f.steps.resize(2049); });
  refused("task of a flow step", [](Flow& f) { f.steps[0].task = 2; });
  refused("task of a flow step", [](Flow& f) { f.steps[2].task = -1; });
  refused("task of a flow step", [](Flow& f) { f.steps[0].task = 1; });
  refused("routine of a flow step", [](Flow& f) { f.steps[1].entry += 1; });
  refused("routine of a flow step", [](Flow& f) { f.steps[2].end += 1; });
  refused("routine of a flow step", [](Flow& f) { f.steps[0].end = f.steps[0].entry - 1; });
  refused("clocks of a flow step", [](Flow& f) { f.steps[0].clocks = 0; });
  refused("transfer before a flow step", [](Flow& f) { f.steps[0].read = 4; });
  refused("transfer behind a flow step", [](Flow& f) { f.steps[0].write = -1; });
  refused("next flow step", [](Flow& f) { f.steps[0].next = {3}; });
  refused("steps behind the last routine", [](Flow& f) {
    f.steps.pop_back();
    f.tasks[1].first = 0;
  });
  image::Image elsewhere = good;
  elsewhere.flow->steps.clear();
  elsewhere.flow->tasks.clear();
  std::string error;
  EXPECT_FALSE(back(elsewhere, &error));

  // A configuration without the hardware; its addresses are as narrow as this.
  ChartMaker small("");
  small.task("a").step("LD X0\nOUT Y0\n");
  image::Image narrow = image_of(small.chart);
  ASSERT_TRUE(back(narrow));
  narrow.config = "hx8k";
  EXPECT_FALSE(back(narrow, &error));
  EXPECT_NE(error.find("flow tasks in a configuration without them"), std::string::npos) << error;
}

TEST(FlowImageFile, AnImageWithoutFlowsHasNone) {
  CompileOptions options;
  Diagnostics diagnostics;
  const auto compiled = compile(list(ladder_text()), options, diagnostics);
  ASSERT_TRUE(compiled);
  const auto read = back(compiled->image);
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->flow);
  EXPECT_EQ(read->length(), read->steps.size());
}

// A compiler of before flow tasks reads what has none, and refuses what it would take for a ladder.
TEST(FlowImageFile, TheVersionTellsOfFlows) {
  const image::Image with = image_of(example().chart);
  image::Image without = with;
  without.flow.reset();
  constexpr std::size_t kVersionAt = 7;
  std::string files[] = {image::to_bytes(without), image::to_bytes(with)};
  EXPECT_EQ(files[0][kVersionAt], 4);
  EXPECT_EQ(files[1][kVersionAt], 5);
  std::swap(files[0][kVersionAt], files[1][kVersionAt]);
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    EXPECT_FALSE(image::from_bytes(file, "x.img", diagnostics));
    EXPECT_EQ(
        diagnostics.all().at(0).what,
        "the image holds what this program cannot use: processor, flow tasks and the version");
  }
}

TEST(FlowListing, ShowsRoutinesByTaskAndStep) {
  const image::Image image = image_of(example().chart);
  const std::string text = image::listing(image);
  std::size_t at = 0;
  for (const std::string& part :
       {std::string("; ladder, " + std::to_string(image.clocks) + " clocks\n"),
        std::string("; 4: OUT M0\n"), std::string("; task 0, fill, starts with the program\n"),
        std::string(";   step 0, s0, " + std::to_string(image.flow->steps[0].clocks) +
                    " clocks; 12: step s0\n"),
        std::string(";     D100 to D103 <- panel, 400 to 403\n"), std::string(";   step 1, s1, "),
        std::string(";     D110 to D111 -> other, 7 to 8\n"), std::string("; task 1, heat\n"),
        std::string(";   step 2, s2, "), std::string(";     D200 to D202 <- memory, 20 to 22\n"),
        std::string(";     D200 to D202 -> memory, 20 to 22\n"), std::string("; 7: OUT Y2\n")}) {
    const std::size_t next = text.find(part, at);
    ASSERT_NE(next, std::string::npos) << part << "not behind " << text.substr(at);
    at = next;
  }
  // A heading without instructions stands there too.
  ChartMaker maker("");
  maker.task("idle").step("");
  EXPECT_NE(image::listing(image_of(maker.chart)).find("step 0, s0, 7 clocks"), std::string::npos);
}

}  // namespace
}  // namespace rung::tb
