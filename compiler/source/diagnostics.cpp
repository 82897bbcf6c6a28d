// SPDX-License-Identifier: Apache-2.0
#include "source/diagnostics.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace rung {
namespace {

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      break;
  }
  return "note";
}

}  // namespace

void Diagnostics::error(const std::string& file, SourcePosition position, std::string what,
                        std::string mend) {
  all_.push_back({Severity::Error, file, position, std::move(what), std::move(mend)});
  ++errors_;
}

void Diagnostics::warning(const std::string& file, SourcePosition position, std::string what,
                          std::string mend) {
  all_.push_back({Severity::Warning, file, position, std::move(what), std::move(mend)});
}

void Diagnostics::note(const std::string& file, SourcePosition position, std::string what) {
  all_.push_back({Severity::Note, file, position, std::move(what), {}});
}

void Diagnostics::print(std::ostream& out) const {
  // A note explains the error or warning before it, so it moves with it.
  struct Group {
    std::size_t file_rank;
    SourcePosition position;
    std::size_t first;
    std::size_t count;
  };
  std::vector<Group> groups;
  std::vector<std::string_view> files;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Diagnostic& diagnostic = all_[i];
    if (diagnostic.severity == Severity::Note && !groups.empty()) {
      ++groups.back().count;
      continue;
    }
    const auto known = std::find(files.begin(), files.end(), diagnostic.file);
    const auto rank = static_cast<std::size_t>(std::distance(files.begin(), known));
    if (known == files.end()) files.push_back(diagnostic.file);
    groups.push_back({rank, diagnostic.position, i, 1});
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return std::tie(a.file_rank, a.position.line, a.position.column) <
           std::tie(b.file_rank, b.position.line, b.position.column);
  });
  for (const Group& group : groups) {
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const Diagnostic& diagnostic = all_[i];
      fmt::print(out, "{}:{}:{}: {}: {}\n", diagnostic.file, diagnostic.position.line,
                 diagnostic.position.column, severity_name(diagnostic.severity), diagnostic.what);
      if (!diagnostic.mend.empty()) fmt::print(out, "    {}\n", diagnostic.mend);
    }
  }
}

}  // namespace rung
