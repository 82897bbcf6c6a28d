// SPDX-License-Identifier: Apache-2.0
// Which mutant of a netlist is run: the netlist asks once, when its model starts. The environment
// says RUNG_MUTANT=netlist:number; without it, and for all other netlists, it is 0, the hardware as
// it is.
#include <cstdlib>
#include <string_view>

extern "C" int rung_mutant_number(const char* netlist) {
  const char* text = std::getenv("RUNG_MUTANT");
  if (text == nullptr) return 0;
  const std::string_view chosen(text);
  const auto colon = chosen.rfind(':');
  if (colon == std::string_view::npos || chosen.substr(0, colon) != netlist) return 0;
  return std::atoi(text + colon + 1);
}
