// SPDX-License-Identifier: Apache-2.0
#include "programs/samples.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "programs/random_source.hpp"

namespace rung {
namespace {

const SampleShape kShapes[] = {
    {1,
     {{1, 78},
      {2, 74},
      {3, 30},
      {4, 34},
      {5, 22},
      {6, 9},
      {7, 7},
      {8, 5},
      {9, 1},
      {10, 1},
      {11, 2},
      {27, 1}},
     355,
     110,
     73,
     51,
     43,
     20},
    {2,
     {{1, 25},
      {2, 68},
      {3, 28},
      {4, 26},
      {5, 13},
      {6, 8},
      {7, 4},
      {8, 4},
      {9, 2},
      {10, 1},
      {11, 1}},
     190,
     38,
     20,
     15,
     7,
     3},
    {3,
     {{1, 25}, {2, 18}, {3, 12}, {4, 11}, {5, 7}, {6, 4}, {7, 3}, {8, 3}, {9, 1}, {10, 1}, {11, 1}},
     122,
     26,
     14,
     10,
     5,
     2},
};

constexpr int kInputs = 128;
constexpr int kOutputs = 64;
constexpr int kFreeWords = 16;  // D0 and on: words that nothing writes

class Generator {
 public:
  Generator(const SampleShape& shape, int density, std::uint64_t seed)
      : shape_(shape), density_(density), random_(seed) {}

  std::string generate() {
    text_ = fmt::format("; stand-in for Sample {}: density {}\n", shape_.number, density_);
    plan_coils();
    const std::vector<int> lengths = shuffled_runs();
    const std::vector<std::string> outputs = shuffled_outputs();
    // Every run has an output; the others go behind runs at random.
    std::vector<int> share(lengths.size(), 1);
    for (std::size_t i = lengths.size(); i < outputs.size(); ++i) {
      ++share[random_.below(static_cast<int>(share.size()))];
    }
    std::size_t next = 0;
    for (std::size_t run = 0; run < lengths.size(); ++run) {
      write_run(lengths[run]);
      for (int i = 0; i < share[run]; ++i) write_output(outputs[next++]);
      finish_rung();
    }
    return text_ + "END\n";
  }

 private:
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[random_.below(static_cast<int>(i))]);
    }
  }

  template <typename T>
  const T& pick(const std::vector<T>& items) {
    return items[random_.below(static_cast<int>(items.size()))];
  }

  // Coils in the order in which they will be written: Y for one in six, M otherwise.
  void plan_coils() {
    int outputs = 0;
    for (int i = 0; i < shape_.out; ++i) {
      if (i > 0 && random_.percent(5)) {
        coils_.push_back(pick(coils_));
      } else if (random_.below(6) == 0 && outputs < kOutputs) {
        coils_.push_back(fmt::format("Y{:o}", outputs++));
      } else {
        coils_.push_back(fmt::format("M{}", relays_++));
      }
    }
  }

  std::vector<int> shuffled_runs() {
    std::vector<int> lengths;
    for (const auto& [length, count] : shape_.runs) lengths.insert(lengths.end(), count, length);
    shuffle(lengths);
    return lengths;
  }

  std::vector<std::string> shuffled_outputs() {
    std::vector<std::string> outputs;
    const auto add = [&](const char* name, int count) {
      outputs.insert(outputs.end(), count, name);
    };
    add("OUT", shape_.out);
    add("MV", shape_.mv);
    add("ADD", shape_.add);
    add("SUB", shape_.sub);
    add("MUL", shape_.mul);
    add("DIV", shape_.div);
    shuffle(outputs);
    return outputs;
  }

  std::string contact() {
    if (!written_bits_.empty() && random_.percent(density_)) return pick(written_bits_);
    if (relays_ > 0 && random_.percent(10)) return fmt::format("M{}", random_.below(relays_));
    return fmt::format("X{:o}", random_.below(kInputs));
  }

  void write_run(int length) {
    text_ += fmt::format("{} {}\n", random_.percent(20) ? "LDI" : "LD", contact());
    for (int i = 1; i < length; ++i) {
      static constexpr const char* kNames[] = {"AND", "ANI", "OR", "ORI"};
      static constexpr int kWeights[] = {45, 25, 22, 8};
      text_ += fmt::format("{} {}\n", kNames[random_.weighted(kWeights)], contact());
    }
  }

  std::string word() {
    if (!written_words_.empty() && random_.percent(density_)) return pick(written_words_);
    return fmt::format("D{}", random_.below(kFreeWords));
  }

  std::string source() {
    if (random_.percent(35)) return fmt::format("K{}", 1 + random_.below(999));
    return word();
  }

  std::string target() {
    const bool again = !written_words_.empty() && random_.percent(10);
    const std::string name =
        again ? pick(written_words_) : fmt::format("D{}", kFreeWords + words_++);
    fresh_words_.push_back(name);
    return name;
  }

  void write_output(const std::string& name) {
    if (name == "OUT") {
      fresh_bits_.push_back(coils_[next_coil_]);
      text_ += fmt::format("OUT {}\n", coils_[next_coil_++]);
    } else if (name == "MV") {
      text_ += fmt::format("MV {} {}\n", source(), target());
    } else if (random_.percent(40)) {
      text_ += fmt::format("{} {} {}\n", name, source(), target());
    } else {
      const std::string first = word();
      text_ += fmt::format("{} {} {} {}\n", name, first, source(), target());
    }
  }

  // What this rung has written, later rungs may read.
  void finish_rung() {
    written_bits_.insert(written_bits_.end(), fresh_bits_.begin(), fresh_bits_.end());
    written_words_.insert(written_words_.end(), fresh_words_.begin(), fresh_words_.end());
    fresh_bits_.clear();
    fresh_words_.clear();
  }

  const SampleShape& shape_;
  int density_;
  RandomSource random_;
  std::string text_;
  std::vector<std::string> coils_;
  std::size_t next_coil_ = 0;
  int relays_ = 0;
  int words_ = 0;
  std::vector<std::string> written_bits_, written_words_;
  std::vector<std::string> fresh_bits_, fresh_words_;
};

}  // namespace

int SampleShape::contacts() const {
  int sum = 0;
  for (const auto& [length, count] : runs) sum += length * count;
  return sum;
}

int SampleShape::instructions() const { return contacts() + out + mv + add + sub + mul + div; }

const SampleShape& sample_shape(int number) {
  if (number < 1 || number > 3) throw std::invalid_argument("samples are numbered 1 to 3");
  return kShapes[number - 1];
}

std::string sample_program(int number, int density, std::uint64_t seed) {
  return Generator(sample_shape(number), density, seed).generate();
}

std::string long_program(bool contacts_only) {
  std::string text;
  int coil = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    std::istringstream lines(sample_program(1, 30, seed));
    for (std::string line; std::getline(lines, line);) {
      const std::string op = line.substr(0, line.find(' '));
      const bool output =
          op == "OUT" || op == "MV" || op == "ADD" || op == "SUB" || op == "MUL" || op == "DIV";
      if (op == "END") continue;
      text += contacts_only && output ? fmt::format("OUT M{}", 1000 + coil++ % 6680) : line;
      text += "\n";
    }
  }
  return text + "END\n";
}

}  // namespace rung
