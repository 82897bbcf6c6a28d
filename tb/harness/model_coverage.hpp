// SPDX-License-Identifier: Apache-2.0
// What Verilator counts of lines, branches and toggles, added up over all models of a program: each
// instance and each set of parameters of a module is the same module. Written to the
// folder that the environment's RUNG_COVERAGE names, in Verilator's own format (`make cov`), when
// the program ends. In any other build nothing is counted.
#pragma once

#include <verilated.h>

#ifdef RUNG_COVERAGE
#include <unistd.h>
#include <verilated_cov.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#endif

namespace rung::tb {

#ifdef RUNG_COVERAGE
class ModelCoverage {
 public:
  // Never destroyed: some models live until the program's own end.
  static ModelCoverage& of_program() {
    static auto* coverage = new ModelCoverage;
    return *coverage;
  }

  // Adds a context's counts; its models must still be there.
  void add(VerilatedContext& context) {
    if (folder_.empty()) return;
    const std::string file = folder_ + "/" + std::to_string(getpid()) + ".tmp";
    context.coveragep()->write(file.c_str());
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      const std::size_t end = line.rfind("' ");
      if (!line.starts_with("C '") || end == std::string::npos) continue;
      std::string point = line.substr(3, end - 3);
      drop(point, "\1h\2");
      counts_[point] += std::strtoull(line.c_str() + end + 2, nullptr, 10);
    }
    std::filesystem::remove(file);
    if (ending_) write();
  }

 private:
  ModelCoverage() {
    if (const char* folder = std::getenv("RUNG_COVERAGE"); folder != nullptr) folder_ = folder;
    // Once for all models, but for static ones that are destroyed after this.
    if (!folder_.empty()) {
      std::atexit([] {
        of_program().ending_ = true;
        of_program().write();
      });
    }
  }

  void write() const {
    std::ofstream out(folder_ + "/" + std::to_string(getpid()) + ".dat");
    out << "# SystemC::Coverage-3\n";
    for (const auto& [point, count] : counts_) out << "C '" << point << "' " << count << "\n";
  }

  // Takes a key and its value out of a point.
  static void drop(std::string& point, const char* key) {
    const std::size_t at = point.find(key);
    if (at == std::string::npos) return;
    const std::size_t end = point.find('\1', at + 1);
    point.erase(at, end == std::string::npos ? end : end - at);
  }

  std::string folder_;
  bool ending_ = false;
  std::map<std::string, std::uint64_t> counts_;
};
#endif

// To be called at a model's end, while it is still there.
inline void count_coverage([[maybe_unused]] VerilatedContext& context) {
#ifdef RUNG_COVERAGE
  ModelCoverage::of_program().add(context);
#endif
}

}  // namespace rung::tb
