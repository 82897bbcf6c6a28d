// SPDX-License-Identifier: Apache-2.0
#include "melsec/special_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

namespace rung {
namespace {

struct Reason {
  std::string_view letters;
  int first, last;
  std::string_view what;
  std::string_view mend = {};
};

constexpr std::string_view kConstantScan =
    "constant scan, which is not set by the program here: every scan has the same period";
constexpr std::string_view kClock = "the real-time clock, which this controller does not have";
constexpr std::string_view kDiagnosis = "the self-diagnosis of the maker's controller";
constexpr std::string_view kPositioning =
    "pulse output and positioning, hardware that this controller does not have";
constexpr std::string_view kHighSpeed =
    "high-speed counters, hardware that this controller does not have";
constexpr std::string_view kBuiltInCounter =
    "the LCPU's built-in high-speed counter, hardware that this controller does not have";
constexpr std::string_view kInterrupts = "interrupts, which a constant scan cannot have";
constexpr std::string_view kScanTime = "scan time; here it is constant, and rung compile tells it";

// The first row that fits counts.
constexpr Reason kReasons[] = {
    {"M", 8004, 8009, kDiagnosis},
    {"M", 8015, 8019, kClock},
    {"M", 8023, 8028, "a mode of instructions that are not supported"},
    {"M", 8029, 8029,
     "\"instruction complete\" of positioning, pulse output and similar hardware, which this "
     "controller does not have"},
    {"M", 8030, 8038, "the operating mode of the maker's controller (battery, memory, RUN, STOP)"},
    {"M", 8039, 8039, kConstantScan, "set the scan period with --tick, and remove this"},
    {"M", 8040, 8049, "the control of step ladders by IST, which is not supported"},
    {"M", 8050, 8059, kInterrupts},
    {"M", 8060, 8069, kDiagnosis},
    {"M", 8070, 8099, "links, tracing and the ring counter of the maker's controller"},
    {"M", 8120, 8129, "serial communication, which is not supported"},
    {"M", 8130, 8139, kHighSpeed},
    {"M", 8140, 8160, kPositioning},
    {"M", 8170, 8198, kHighSpeed},
    {"M", 8235, 8255, kHighSpeed},
    {"M", 8338, 8398, kPositioning},
    {"D", 8010, 8012, kScanTime},
    {"D", 8013, 8019, kClock},
    {"D", 8028, 8029, "the index registers Z0 and V0 under their other names", "name Z0 or V0"},
    {"D", 8039, 8039, kConstantScan, "set the scan period with --tick, and remove this"},
    {"D", 8060, 8069, kDiagnosis},
    {"D", 8120, 8129, "serial communication, which is not supported"},
    {"D", 8130, 8160, kPositioning},
    {"SM", 1, 199, kDiagnosis},
    {"SM", 210, 219, kClock},
    {"SM", 414, 434, "a clock whose period is a parameter of the maker's controller",
     "use SM409 to SM413, or a timer"},
    {"SM", 1840, 1879, kPositioning},
    {"SM", 1880, 1919, kBuiltInCounter},
    {"SD", 0, 199, kDiagnosis},
    {"SD", 210, 219, kClock},
    {"SD", 412, 434, "a counter of clocks, which is not supported", "count SM412 with a counter"},
    {"SD", 520, 549, kScanTime},
    {"SD", 1840, 1879, kPositioning},
    {"SD", 1880, 1919, kBuiltInCounter},
};

}  // namespace

Unsupported special_reason(std::string_view name, Dialect dialect) {
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  int number = -1;
  std::from_chars(name.data() + digits, name.data() + name.size(), number);
  const bool is_bit = name.starts_with("M") || name.starts_with("SM");
  const std::string_view kind = is_bit ? "relay" : "register";
  for (const Reason& reason : kReasons) {
    if (reason.letters == name.substr(0, digits) && number >= reason.first &&
        number <= reason.last) {
      return {fmt::format("a special {} of {}", kind, reason.what), std::string(reason.mend), {}};
    }
  }
  const std::string_view known =
      !is_bit ? ""
      : dialect == Dialect::Q
          ? "the special relays here are SM0, SM56, SM400 to SM403, SM409 to SM413 and SM700"
          : "the special relays here are M8000 to M8003, M8011 to M8014, M8020 to M8022, M8067, "
            "M8068 and M8200 to M8234";
  return {fmt::format("a special {} for something that this controller does not have", kind),
          std::string(known),
          {}};
}

}  // namespace rung
