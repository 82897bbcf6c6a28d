// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/numbers.hpp"

#include <charconv>
#include <limits>

namespace rung {

LdNumber leading_number(std::string_view text) {
  LdNumber number;
  // from_chars knows no plus sign.
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const begin = text.data() + (plus ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number.value);
  if (end == begin) return number;
  number.length = static_cast<std::size_t>(end - text.data());
  if (error == std::errc::result_out_of_range) {
    number.value = *begin == '-' ? std::numeric_limits<std::int64_t>::min()
                                 : std::numeric_limits<std::int64_t>::max();
  }
  number.fits = number.value >= std::numeric_limits<std::int32_t>::min() &&
                number.value <= std::numeric_limits<std::int32_t>::max();
  return number;
}

}  // namespace rung
