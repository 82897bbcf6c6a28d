// SPDX-License-Identifier: Apache-2.0
// usage: hardwired_batch all|agree|exhaustive FILE
// Writes the programs of a set, hard-wired, as one Verilog file.
#include <cstdio>
#include <exception>
#include <fstream>

#include "hardwired/batch.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: hardwired_batch all|agree|exhaustive FILE\n");
    return 2;
  }
  try {
    const std::string text = rung::tb::Batch(rung::tb::subjects_of(argv[1])).verilog();
    std::ofstream file(argv[2], std::ios::binary);
    file << text;
    if (file.flush()) return 0;
    std::fprintf(stderr, "cannot write %s\n", argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hardwired_batch: %s\n", error.what());
  }
  return 1;
}
