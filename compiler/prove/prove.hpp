// SPDX-License-Identifier: Apache-2.0
// Translation validation: is what an image does what its core program means? Checked by this
// folder's own reading of both (README.md), for every start of a scan at once.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/meaning.hpp"
#include "prove/solver.hpp"
#include "prove/start.hpp"

namespace rung::prove {

// What is wrong, or could not be proven.
struct Finding {
  bool wrong = true;
  std::size_t meaning = 0;  // the routine, among the image's meanings
  int source = -1;          // index into Image::source, or -1
  std::string what;
  // A start of a scan that shows it: the devices that matter, in the order of their addresses. If
  // it also takes a value that nothing defines, as that of a result collected too early, or if what
  // is wrong is the code itself, no start alone shows it.
  struct Value {
    Place place;
    std::uint16_t value = 0;
  };
  std::vector<Value> start;
  bool takes_undefined = false;
  bool shown = false;
};

struct Proof {
  int writes = 0;  // values that the core program writes
  int proven = 0;  // those that the image writes too, alike in condition, value and order
  std::vector<Finding> findings;
  Effort effort;
  std::size_t terms = 0;
  double seconds = 0;

  bool holds() const { return findings.empty() && proven == writes; }
  int wrong() const;
};

struct ProofOptions {
  double seconds = 120;       // for all of it
  std::size_t findings = 20;  // of each routine; what comes behind them is not looked at
};

// Bits of the instruction memory: [step][slot].
using Code = std::vector<std::vector<std::uint64_t>>;
Code code_of(const image::Image& image);

// Everything else of the image is taken from `image`: LUT, source lines, where the program's
// devices are.
Proof prove(const image::Image& image, const Code& code, std::span<const image::Meaning> meanings,
            const ProofOptions& options = {});
Proof prove(const image::Image& image, std::span<const image::Meaning> meanings,
            const ProofOptions& options = {});

// The findings as errors at their places in the source.
void report(const Proof& proof, const image::Image& image, std::span<const image::Meaning> meanings,
            Diagnostics& diagnostics);

// "proven: 12 writes (9 by equal structure, ...), 0.01 s"
std::string to_string(const Proof& proof);

}  // namespace rung::prove
