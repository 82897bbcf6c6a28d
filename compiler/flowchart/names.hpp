// SPDX-License-Identifier: Apache-2.0
// Names that a `.flow` text declares: of its tasks, of its boards, of the steps of a task.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "flowchart/tokens.hpp"

namespace rung::flowchart {

class Names {
 public:
  // What they are names of: "task".
  explicit Names(std::string_view what) : what_(what) {}

  // Numbers them in their order. Throws a Refusal, having counted it all the same, where the name
  // is taken already.
  void declare(const Token& name);
  // What `name` stands for; throws a Refusal where nothing has that name.
  std::size_t find(const Token& name) const;
  // The same for those who know what to say.
  std::optional<std::size_t> index(std::string_view name) const;
  std::size_t size() const { return size_; }
  // One whose name could not be read.
  void skip() { ++size_; }

 private:
  struct Declared {
    std::size_t index;
    int line;
  };

  std::string_view what_;
  std::map<std::string, Declared, std::less<>> names_;
  std::size_t size_ = 0;
};

}  // namespace rung::flowchart
