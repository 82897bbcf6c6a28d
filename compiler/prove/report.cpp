// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "prove/prove.hpp"

namespace rung::prove {

int Proof::wrong() const {
  return static_cast<int>(
      std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.wrong; }));
}

namespace {

// "rung 3, OUT Y0: ", of a flow task with its step.
std::string subject(const Finding& finding, const image::Image& image,
                    const image::Meaning& meaning) {
  std::string out = meaning.step.empty() ? "" : fmt::format("step {}, ", meaning.step);
  if (finding.source < 0) return out;
  const auto own = static_cast<std::size_t>(finding.source - meaning.first_origin);
  const auto behind = std::upper_bound(meaning.rungs.begin(), meaning.rungs.end(), own);
  return out + fmt::format("rung {}, {}: ", behind - meaning.rungs.begin(),
                           image.source.at(static_cast<std::size_t>(finding.source)).text);
}

}  // namespace

void report(const Proof& proof, const image::Image& image, std::span<const image::Meaning> meanings,
            Diagnostics& diagnostics) {
  for (const Finding& finding : proof.findings) {
    const SourcePosition position =
        finding.source < 0 ? SourcePosition{}
                           : image.source.at(static_cast<std::size_t>(finding.source)).position;
    const std::string who = subject(finding, image, meanings[finding.meaning]);
    if (finding.wrong) {
      diagnostics.error(image.program, position, who + finding.what,
                        "the compiler has made something else of the program; please report it");
    } else {
      diagnostics.error(image.program, position,
                        fmt::format("{}not proven within the limits whether {}", who, finding.what),
                        "split the rung, or compile without --prove");
    }
  }
}

std::string to_string(const Proof& proof) {
  std::string out = fmt::format(
      "proven: {} of {} writes; {} questions answered by equal structure, {} by "
      "CaDiCaL; {} terms, {:.2f} s\n",
      proof.proven, proof.writes, proof.effort.structure, proof.effort.solver, proof.terms,
      proof.seconds);
  const int wrong = proof.wrong();
  const auto open = static_cast<int>(proof.findings.size()) - wrong;
  if (wrong > 0) out += fmt::format("wrong: {}\n", wrong);
  if (open > 0 || proof.proven < proof.writes) {
    out += fmt::format("not proven: {} writes, {} questions without an answer\n",
                       proof.writes - proof.proven, open);
  }
  return out;
}

}  // namespace rung::prove
