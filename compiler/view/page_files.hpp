// SPDX-License-Identifier: Apache-2.0
// The files of the page (compiler/view/page), as the build has put them into this program.
#pragma once

#include <span>
#include <string_view>

namespace rung::view {

struct PageFile {
  std::string_view name;
  std::string_view type;  // of its contents
  std::string_view text;
};
std::span<const PageFile> page_files();
// A program to look at when none is named: its list and its device comments.
std::string_view example_list();
std::string_view example_comments();

}  // namespace rung::view
