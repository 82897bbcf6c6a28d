// SPDX-License-Identifier: Apache-2.0
#include "melsec/unsupported.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <unordered_map>

#include "melsec/instructions.hpp"

namespace rung {
namespace {

constexpr std::string_view kNotYet = "not supported yet";

// Instructions that share a reason. `forms`: they also have a 32-bit form (D...) and a pulse form
// (...P).
struct Group {
  Effect effect;
  bool forms;
  std::string_view names;  // separated by blanks
  std::string_view reason;
  std::string_view mend;
};

constexpr Group kGroups[] = {
    {Effect::Combine, false, "EGP EGF", "an edge relay, not supported yet",
     "use MEP or MEF, or PLS and PLF with relays"},
    {Effect::Output, false, "OUTHS", "a high-speed retentive timer coil under another name",
     "write OUTH ST0"},
    {Effect::Output, true, "SFWR SFRD", "a queue in data registers, not supported yet", ""},
    {Effect::Output, true, "BXCH SMOV BKRST BKAND BKOR BKXOR BKXNR RBMOV",
     "a transfer of more than one word, not supported yet", ""},
    {Effect::Output, true, "BKBCD BKBIN GRY GBIN DBL WORD HEX ASCI",
     "a conversion, not supported yet", ""},
    {Effect::Output, true,
     "DECO ENCO SUM BON BSET BRST TEST SEG DIS UNI NDIS NUNI WTOB BTOW MAX "
     "MIN SORT WSUM MEAN SER LIMIT BAND ZONE SCL SCL2 SQR ABSD INCD "
     "RAMP ROTC FIFW FIFR FPOP FINS FDEL ANS ANR RND SRND CRC CCD",
     "a data operation, not supported yet", ""},
    {Effect::Output, true, "PID", "a PID controller, not supported yet", ""},
    {Effect::Output, true,
     "EMOV EADD ESUB EMUL EDIV ECMP EZCP EBCD EBIN ESQR EXP LOG LOGE LOG10 SIN COS "
     "TAN ASIN ACOS ATAN RAD DEG FLT INT INTD FLTD ENEG ESTR EVAL",
     "floating-point arithmetic, not supported yet",
     "scale the values to 16-bit integers where that will do"},
    {Effect::Output, true, "STR VAL LEN RIGHT LEFT MIDR MIDW INSTR ASC $MOV $+ PR PRC COMRD",
     "an operation on texts, not supported yet", ""},
    {Effect::Output, true,
     "TCMP TZCP TADD TSUB TRD TWR HTOS STOH HOUR DATERD DATEWR DATE+ DATE- "
     "SECOND",
     "an operation on a real-time clock, which this controller does not have", ""},
    {Effect::Output, false, "STMR TTMR UDCNT1 UDCNT2 DUTY",
     "a timer or counter instruction, not "
     "supported yet",
     ""},
    {Effect::Output, false, "SCJ", "a jump that waits for the next scan, not supported yet",
     "use CJ"},
    {Effect::None, false, "JMP", "a jump without a condition, not supported yet",
     "use LD SM400 and CJ"},
    {Effect::Output, false, "GOEND", "a jump to the end, not supported yet",
     "use CJ to a label before the end"},
    {Effect::Output, false, "FCALL FCALLP ECALL ECALLP EFCALL XCALL",
     "a call that also switches outputs off or leaves the program, not supported yet", "use CALL"},
    {Effect::Output, false, "BREAK BREAKP",
     "a way out of a loop while it runs, which a constant scan cannot have",
     "skip the rest of the body with CJ"},
    {Effect::None, false, "EI DI IRET IMASK",
     "a part of interrupt programs, which a constant scan cannot have",
     "do the work in the scan: it is shorter than a usual interrupt period"},
    {Effect::None, false, "STOP", "an instruction to stop the controller, not supported yet", ""},
    {Effect::None, false, "WDT", "a watchdog refresh in the scan, which a constant scan needs not",
     "remove it"},
    {Effect::None, false, "NOPLF PAGE", "an instruction for printing the list", "remove it"},
    {Effect::Output, true, "TO FROM RBFM WBFM",
     "access to the memory of a special module, which this controller does not have", ""},
    {Effect::Output, true, "PLSY PLSR PLSV ZRN DSZR DVIT DRVI DRVA TBL ABS",
     "pulse output, positioning hardware that this controller does not have",
     "use an external positioning unit and start it with an output (Y)"},
    {Effect::Output, true, "HSCS HSCR HSZ HSCT HCMOV SPD",
     "a high-speed counter instruction, hardware that this controller does not have", ""},
    {Effect::Output, true, "PWM",
     "pulse-width output, hardware that this controller does not "
     "have",
     ""},
    {Effect::Output, false,
     "ICCNTRD1 ICCNTRD2 ICPREWR1 ICPREWR2 ICRNGWR1 ICRNGWR2 ICCOVWR1 "
     "ICCOVWR2 ICLTHRD1 ICLTHRD2 ICSMPRD1 ICSMPRD2 ICRCNT1 ICRCNT2 ICFCNT1 "
     "ICFCNT2 ICPLSRD1 ICPLSRD2 ICPWM1 ICPWM2",
     "for the LCPU's built-in high-speed counter, hardware that this controller does not have", ""},
    {Effect::Output, false,
     "IPPSTRT1 IPPSTRT2 IPDSTRT1 IPDSTRT2 IPSIMUL IPOPR1 IPOPR2 IPJOG1 "
     "IPJOG2 IPABRST1 IPABRST2 IPSTOP1 IPSTOP2 IPSPCHG1 IPSPCHG2 IPTPCHG1 "
     "IPTPCHG2",
     "for the LCPU's built-in positioning, hardware that this controller does not have", ""},
    {Effect::Output, false, "RS RS2 IVCK IVDR IVRD IVWR IVBWR IVMC ADPRW PRUN",
     "serial communication, not supported yet", ""},
    {Effect::Output, true, "REF REFF RFS MTR COM ZCOM RFRP RTOP",
     "a refresh within the scan; here inputs and outputs are refreshed once a scan", "remove it"},
    {Effect::Output, true, "TKY HKY DSW SEGD SEGL ARWS VRRD VRSC IST EXTR",
     "for a keypad, display or similar unit, which this controller does not have", ""},
    {Effect::Output, false,
     "EROMWR EROMRD LOADR SAVER INITR LOGR RWER INITER RSET QDRSET QCDSET "
     "PLOAD PUNLOAD PSWAP PSTOP POFF PSCAN PLOW",
     "for files and memory cards, which this controller does not have", ""},
};

constexpr std::string_view kCompares[] = {"=", "<>", "<", ">", "<=", ">="};

struct DeviceGroup {
  std::string_view prefix;
  bool digits;  // decimal digits follow, else hexadecimal ones
  std::string_view what;
  std::string_view mend = {};
};

// The longer prefixes first.
constexpr DeviceGroup kDevices[] = {
    {"TC", true, "the coil of a timer", "name the timer itself: T0"},
    {"CC", true, "the coil of a counter", "name the counter itself: C0"},
    {"ZR", true, "a file register by its serial number", "use R or D"},
    {"DX", false, "a direct input", "use X: inputs are read once a scan"},
    {"DY", false, "a direct output", "use Y: outputs are refreshed once a scan"},
    {"FX", true, "a function input", "use relays (M): subroutines have no operands here"},
    {"FY", true, "a function output", "use relays (M): subroutines have no operands here"},
    {"FD", true, "a function register", "use words (D): subroutines have no operands here"},
    {"LT", true, "a long timer", "use T"},
    {"LC", true, "a long counter", "use C"},
    {"BL", true, "an SFC block", "use relays (M)"},
    {"I", true, "an interrupt pointer", "a constant scan has no interrupts"},
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool all_digits(std::string_view text, bool decimal) {
  return !text.empty() && is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) {
           return decimal ? std::isdigit(c) != 0 : std::isxdigit(c) != 0;
         });
}

template <typename Visit>
void for_each_name(std::string_view names, Visit visit) {
  while (!names.empty()) {
    const std::size_t blank = std::min(names.find(' '), names.size());
    if (blank > 0) visit(names.substr(0, blank));
    names.remove_prefix(std::min(blank + 1, names.size()));
  }
}

const Group* find_group(std::string_view name) {
  static const std::unordered_map<std::string_view, const Group*> index = [] {
    std::unordered_map<std::string_view, const Group*> groups;
    for (const Group& group : kGroups) {
      for_each_name(group.names, [&](std::string_view each) { groups.emplace(each, &group); });
    }
    return groups;
  }();
  const auto found = index.find(name);
  return found == index.end() ? nullptr : found->second;
}

// True for an instruction that has 32-bit and pulse forms.
bool has_forms(std::string_view name) {
  const Group* group = find_group(name);
  return group != nullptr && group->forms;
}

std::optional<Unsupported> compare_contact(std::string_view name) {
  Effect effect = Effect::Combine;
  if (name.starts_with("LD")) {
    effect = Effect::Load;
    name.remove_prefix(2);
  } else if (name.starts_with("AND")) {
    name.remove_prefix(3);
  } else if (name.starts_with("OR")) {
    name.remove_prefix(2);
  } else {
    return std::nullopt;
  }
  if (name.empty() || (name.front() != 'E' && name.front() != '$')) return std::nullopt;
  const std::string_view what = name.front() == 'E' ? "floating-point numbers" : "texts";
  name.remove_prefix(1);
  if (std::find(std::begin(kCompares), std::end(kCompares), name) == std::end(kCompares)) {
    return std::nullopt;
  }
  return Unsupported{fmt::format("a compare contact on {}, {}", what, kNotYet), {}, effect};
}

// Q's operators of other kinds: B*, E/, BK-.
std::optional<Unsupported> operator_form(std::string_view name) {
  if (name.ends_with('P')) name.remove_suffix(1);
  if (name.empty() || std::string_view("+-*/").find(name.back()) == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view prefix = name.substr(0, name.size() - 1);
  std::string_view kind;
  if (prefix == "B" || prefix == "DB") {
    kind = "BCD";
  } else if (prefix == "E" || prefix == "ED") {
    kind = "floating-point";
  } else if (prefix == "BK" || prefix == "DBK") {
    kind = "block";
  } else {
    return std::nullopt;
  }
  return Unsupported{fmt::format("{} arithmetic, {}", kind, kNotYet), {}, Effect::Output};
}

std::optional<Unsupported> other_width_or_pulse(std::string_view name) {
  std::string_view base = name;
  const bool pulse = base.ends_with('P') && !has_forms(base);
  if (pulse) base.remove_suffix(1);
  const bool wide = base.starts_with('D') && !has_forms(base);
  if (wide) base.remove_prefix(1);
  if ((!pulse && !wide) || !has_forms(base)) return std::nullopt;
  const Group* group = find_group(base);
  return Unsupported{std::string(group->reason), std::string(group->mend), Effect::Output};
}

bool is_module_instruction(std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot > 2 || dot + 2 >= name.size()) return false;
  return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(dot),
                     [](unsigned char c) { return std::isupper(c) != 0; }) &&
         std::isupper(static_cast<unsigned char>(name[dot + 1])) != 0;
}

}  // namespace

std::optional<Unsupported> unsupported_instruction(std::string_view name) {
  if (!find_instruction(name).empty() || name == "END") return std::nullopt;
  if (const Group* group = find_group(name)) {
    return Unsupported{std::string(group->reason), std::string(group->mend), group->effect};
  }
  if (auto contact = compare_contact(name)) return contact;
  if (auto form = operator_form(name)) return form;
  if (auto form = other_width_or_pulse(name)) return form;
  if (is_module_instruction(name)) {
    return Unsupported{"for an intelligent module or network, which this controller does not have",
                       {},
                       Effect::Output};
  }
  return std::nullopt;
}

std::optional<Unsupported> unsupported_operand(std::string_view text) {
  const auto not_yet = [](std::string_view what) {
    return Unsupported{fmt::format("{}, {}", what, kNotYet), {}, Effect::None};
  };
  if (text.empty()) return std::nullopt;
  if (text.front() == '"') return not_yet("a text constant");
  if (text.front() == '@') return not_yet("an indirect device");
  if (text.find('\\') != std::string_view::npos) {
    return Unsupported{
        "in the memory of a module or network, which this controller does not have", {}, {}};
  }
  if (text.size() >= 2 && text.front() == 'E' &&
      (is_digit(text[1]) || text[1] == '-' || text[1] == '+')) {
    return not_yet("a floating-point constant");
  }
  for (const DeviceGroup& group : kDevices) {
    if (!text.starts_with(group.prefix)) continue;
    if (all_digits(text.substr(group.prefix.size()), group.digits)) {
      return Unsupported{fmt::format("{}, {}", group.what, kNotYet), std::string(group.mend), {}};
    }
  }
  return std::nullopt;
}

bool is_label(std::string_view text) {
  return text.size() >= 2 && text.front() == 'P' && all_digits(text.substr(1), true);
}

bool is_interrupt_label(std::string_view text) {
  return text.size() >= 2 && text.front() == 'I' && all_digits(text.substr(1), true);
}

std::vector<std::string_view> unsupported_names() {
  std::vector<std::string_view> names;
  for (const Group& group : kGroups) {
    for_each_name(group.names, [&](std::string_view name) { names.push_back(name); });
  }
  return names;
}

}  // namespace rung
