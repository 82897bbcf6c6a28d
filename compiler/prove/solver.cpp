// SPDX-License-Identifier: Apache-2.0
#include "prove/solver.hpp"

#include <cadical.hpp>
#include <initializer_list>

namespace rung::prove {
namespace {

// Of one question; the hardest of the tests' programs takes a hundredth of it.
constexpr int kConflicts = 1000000;
// Of a question that nothing depends on but time.
constexpr int kFewConflicts = 200;

class Deadline : public CaDiCaL::Terminator {
 public:
  explicit Deadline(std::chrono::steady_clock::time_point end) : end_(end) {}
  bool terminate() override { return std::chrono::steady_clock::now() > end_; }

 private:
  std::chrono::steady_clock::time_point end_;
};

}  // namespace

Solver::Solver(const Terms& terms, double seconds)
    : terms_(terms),
      end_(std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               std::chrono::duration<double>(seconds))) {}

void Solver::cut(Bit bit) {
  if (cut_.size() <= node_of(bit)) cut_.resize(node_of(bit) + 1, false);
  cut_[node_of(bit)] = true;
}

void Solver::cut(const Word& word) {
  for (const Bit bit : word) cut(bit);
}

Answer Solver::ask(Bit bit, NodeId since) {
  if (bit == kFalse) {
    ++effort_.structure;
    return {};
  }
  const Bit roots[] = {bit};
  if (const int pattern = terms_.pattern_with(bit); pattern >= 0) {
    ++effort_.simulation;
    return {Verdict::Possible, terms_.model_of(pattern, terms_.cone(roots))};
  }
  ++effort_.solver;
  Answer answer;
  bool used_cuts = true;
  int result = 0;
  for (const NodeId free : {static_cast<NodeId>(terms_.size()), since, NodeId{0}}) {
    if (!used_cuts || out_of_time()) break;
    used_cuts = false;
    result = solve(bit, free, kConflicts, answer.model, used_cuts);
    if (result == 20) break;
  }
  if (result == 20) return {};
  // With the functions computed: a model may have chosen a product that is none.
  const bool holds = result == 10 && terms_.evaluate(roots, answer.model)[0];
  answer.verdict = holds ? Verdict::Possible : Verdict::Unknown;
  return answer;
}

Answer Solver::ask_quickly(Bit bit, NodeId free) {
  if (bit == kFalse) return {};
  Answer answer{Verdict::Unknown, {}};
  if (out_of_time() || terms_.pattern_with(bit) >= 0) return answer;
  ++effort_.solver;
  bool used_cuts = false;
  const int result = solve(bit, free, kFewConflicts, answer.model, used_cuts);
  if (result == 20) return {};
  const Bit roots[] = {bit};
  if (result == 10 && !used_cuts && terms_.evaluate(roots, answer.model)[0]) {
    answer.verdict = Verdict::Possible;
  }
  return answer;
}

int Solver::solve(Bit bit, NodeId free, int conflicts, Model& model, bool& used_cuts) {
  CaDiCaL::Solver solver;
  solver.set("quiet", 1);
  Deadline deadline(end_);
  std::unordered_map<NodeId, int> numbers;
  std::vector<NodeId> open;
  const auto literal = [&](Bit of) {
    const auto [place, fresh] =
        numbers.try_emplace(node_of(of), static_cast<int>(numbers.size()) + 1);
    if (fresh) open.push_back(node_of(of));
    return (of & 1U) != 0 ? -place->second : place->second;
  };
  const auto clause = [&](std::initializer_list<int> literals) {
    for (const int each : literals) solver.add(each);
    solver.add(0);
  };
  clause({literal(bit)});
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    const int out = numbers.at(node);
    if (node == 0) {
      clause({-out});
      continue;
    }
    if (terms_.is_variable(node)) continue;
    if (node < free && node < cut_.size() && cut_[node]) {
      used_cuts = true;
      continue;
    }
    const int a = literal(terms_.left(node));
    const int b = literal(terms_.right(node));
    clause({-out, a});
    clause({-out, b});
    clause({out, -a, -b});
  }
  solver.connect_terminator(&deadline);
  solver.limit("conflicts", conflicts);
  const int result = solver.solve();
  if (result == 10) {
    model.clear();
    for (const auto& [node, number] : numbers) {
      if (terms_.is_variable(node)) model[node] = solver.val(number) > 0;
    }
  }
  solver.disconnect_terminator();
  return result;
}

}  // namespace rung::prove
