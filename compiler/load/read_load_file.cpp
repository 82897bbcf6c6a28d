// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "load/format.hpp"
#include "load/load_file.hpp"
#include "rung_flow.hpp"

namespace rung::load {
namespace {

// Addresses of each space in any controller: of what a configuration has less of, the most.
constexpr std::uint32_t kSizes[] = {
    1U << 20, 128, 1U << 15, 1U << 15, 1, 3, 512, 1U << 16, 1U << 16, 256, 64, 16,
    // flow_steps, flow_transfers, flow_tasks, flow_setup
    4 * flow::flow_steps, 4 * flow::flow_transfers, flow::flow_tasks, 64 + flow::flow_boards};

class Reader {
 public:
  explicit Reader(const std::vector<std::uint16_t>& words) : words_(words) {}

  std::optional<Contents> read(std::string& problem) {
    problem = header();
    if (problem.empty()) problem = records();
    if (!problem.empty()) return std::nullopt;
    return std::move(out_);
  }

 private:
  std::string header() {
    if (words_.size() < kHeaderWords + 1) return "it is shorter than its header";
    if (words_[kMagicAt] != kMagic) return "it does not begin as a load file";
    if (words_[kFormatAt] != kFormat) {
      return fmt::format("it has format {}; this program reads {}", words_[kFormatAt], kFormat);
    }
    const std::size_t length = words_[kLengthAt] | static_cast<std::size_t>(words_[kLengthAt + 1])
                                                       << 16;
    if (length != words_.size()) {
      return fmt::format("it has {} words and says {}", words_.size(), length);
    }
    if (words_.size() > kMostWords) return "it is longer than its place in the flash";
    for (std::size_t at = kUnusedAt; at < kHeaderWords; ++at) {
      if (at != kChunksAt && words_[at] != 0)
        return fmt::format("word {} of its header is not 0", at);
    }
    out_.tables = words_[kTablesAt];
    out_.config_id = words_[kConfigAt];
    out_.board_id = words_[kBoardAt];
    out_.mpu = words_[kMpuAt];
    out_.retain_id = words_[kRetainAt];
    out_.chunks = words_[kChunksAt];
    if (out_.chunks < 1 || out_.chunks > static_cast<int>(kStepAddresses)) {
      return fmt::format("a step has {} chunks", out_.chunks);
    }
    return {};
  }

  std::string records() {
    std::size_t at = kHeaderWords;
    bool length = false;
    while (at < words_.size() && words_[at] != 0) {
      if (length) return "a record stands behind that of the length";
      const int space = words_[at] >> 12;
      const std::size_t count = words_[at] & 0xFF;
      if (count == 0) return fmt::format("the record at word {} has no data", at);
      if (at + 2 + count >= words_.size()) return "its last record is cut short";
      std::uint32_t address =
          static_cast<std::uint32_t>(words_[at] >> 8 & 0xF) << 16 | words_[at + 1];
      for (std::size_t i = 0; i < count; ++i) {
        if (const auto problem = set(space, address, words_[at + 2 + i]); !problem.empty()) {
          return problem;
        }
        address = next(space, address);
      }
      length = space == controller::space_length;
      at += 2 + count;
    }
    if (at + 1 != words_.size()) return "its end mark is not at its end";
    return length ? "" : "it has no length";
  }

  std::uint32_t next(int space, std::uint32_t address) const {
    const bool last = space == controller::space_steps &&
                      address % kStepAddresses + 1 == static_cast<std::uint32_t>(out_.chunks);
    return last ? address / kStepAddresses * kStepAddresses + kStepAddresses : address + 1;
  }

  std::string set(int space, std::uint32_t address, std::uint16_t value) {
    if (space >= static_cast<int>(std::size(kSizes)) || address >= kSizes[space]) {
      return fmt::format("space {} has no address {}", space, address);
    }
    if (!out_.values.emplace(std::pair(space, address), value).second) {
      return fmt::format("address {} of space {} is set twice", address, space);
    }
    return {};
  }

  const std::vector<std::uint16_t>& words_;
  Contents out_;
};

}  // namespace

std::optional<std::uint16_t> Contents::at(int space, std::uint32_t address) const {
  const auto found = values.find({space, address});
  if (found == values.end()) return std::nullopt;
  return found->second;
}

std::optional<Contents> read(const std::vector<std::uint16_t>& words, std::string& problem) {
  return Reader(words).read(problem);
}

}  // namespace rung::load
