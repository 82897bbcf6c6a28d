// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "lower/lower.hpp"
#include "melsec/list.hpp"
#include "programs/samples.hpp"
#include "wide/schedule.hpp"
using namespace rung;
int main(int argc, char** argv) {
  const auto arg = [&](int i, int v) { return i < argc ? atoi(argv[i]) : v; };
  for (int density : {10, 30, 60}) {
    for (int slots : {8, 16}) {
     for (int arity : {3}) {
      int sum = 0;
      wide::Bounds b;
      for (int seed = 1; seed <= 5; ++seed) {
        Diagnostics d;
        auto source = decode_text(sample_program(1, density, seed), "s.il", d);
        auto program = parse_list(*source, Dialect::Paper, d);
        core::Program low = lower::lower(*program);
        auto logic = logic::build(low);
        auto values = values::build(logic, low);
        wide::Machine m;
        m.slots = slots;
        m.units = slots / 2;
        m.dividers = std::min(m.units, arg(5, 2));
        m.arity = arity;
        m.div = arg(1, 12); m.div_interval = arg(2, 1); m.mul = arg(3, 4); m.other = arg(4, 3);
        auto work = wide::make_work(values, m, {}, {});
        wide::untangle(work, values);
        auto s = wide::search(work, values, m, {});
        b = wide::bounds(work, values, m);
        sum += s.steps;
        if (seed == 5)
          fmt::print("density {} slots {} arity {}: {:.1f}  lookups {} groups {} bounds {} {} {} {}\n",
                     density, slots, arity, sum / 5.0, work.look_ups.size(), work.groups.size(),
                     b.look_ups, b.words, b.dividers, b.dependence);
      }
     }
    }
  }
}
