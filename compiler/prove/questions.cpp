// SPDX-License-Identifier: Apache-2.0
#include "prove/questions.hpp"

#include <fmt/format.h>

#include <map>

#include "prove/names.hpp"

namespace rung::prove {

bool Questions::ask(Bit bad, NodeId since, int source, const std::string& what, const Bit* image,
                    const Bit* program, std::size_t bits) {
  const Answer answer = solver_.ask(bad, since);
  if (answer.verdict == Verdict::Never) return true;
  Finding finding;
  finding.wrong = answer.verdict == Verdict::Possible;
  finding.source = source;
  finding.what = what;
  if (finding.wrong) {
    if (image != nullptr) {
      finding.what +=
          fmt::format(": the image's is {}, the program's {}", number(image, bits, answer.model),
                      number(program, bits, answer.model));
    }
    explain(bad, answer.model, finding);
  }
  add(std::move(finding));
  return false;
}

int Questions::number(const Bit* bits, std::size_t count, const Model& model) const {
  const std::vector<bool> values = terms_.evaluate(std::span(bits, count), model);
  std::uint16_t out = 0;
  for (std::size_t i = 0; i < count; ++i) {
    out = static_cast<std::uint16_t>(out | (values[i] ? 1U << i : 0U));
  }
  return count == 1 ? out : static_cast<std::int16_t>(out);
}

void Questions::explain(Bit bad, const Model& model, Finding& finding) const {
  const Bit roots[] = {bad};
  std::map<Place, std::uint16_t> values;
  for (const NodeId node : terms_.cone(roots)) {
    if (!terms_.is_variable(node) || terms_.is_result(node)) continue;
    const auto* owner = start_.owner(node);
    if (owner == nullptr) {
      finding.takes_undefined = true;
      continue;
    }
    const auto found = model.find(node);
    const bool value = found != model.end() && found->second;
    std::uint16_t& all = values[owner->first];
    all = static_cast<std::uint16_t>(all | (value ? 1U << owner->second : 0U));
  }
  for (const auto& [place, value] : values) finding.start.push_back({place, value});
  finding.shown = !finding.takes_undefined;
  finding.what += start_text(finding, name_);
}

bool Questions::fail(int source, std::string what) {
  Finding finding;
  finding.source = source;
  finding.what = std::move(what);
  add(std::move(finding));
  return false;
}

void Questions::add(Finding finding) {
  ++found_;
  finding.meaning = meaning_;
  proof_.findings.push_back(std::move(finding));
}

}  // namespace rung::prove
