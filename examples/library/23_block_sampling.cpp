// SPDX-License-Identifier: Apache-2.0
// A table at every cycle of a controller: in a block, one by one, and its verdict.
#include <cstdio>
#include <vector>

#include "jounce/pvt/check.hpp"
#include "jounce/pvt/cursor.hpp"

using namespace jounce;

int main() {
  // HIMC HMPL manual 5.2.8 (MovePVT), in s and mm.
  const Table table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                    {{0, 2, 3, 4, 6, 11},
                     {0, 153.333, 42.123, 161.21, 177, 83.333},
                     {0, 1000, 800, 1660, 450, 0},
                     {}});

  // A column each, as an executor or a file wants them: every millisecond.
  std::vector<double> p(11001), v(p.size()), a(p.size());
  table.sample({.start = 0, .step = 0.001}, p, v, a);
  std::printf("at 1 s: %.4f mm, %.4f mm/s, %.3f mm/s^2\n", p[1000], v[1000], a[1000]);

  // One by one, where instants mostly stay between two knots: the same to the bit.
  Cursor cursor(table);
  std::size_t equal = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    equal += static_cast<std::size_t>(cursor.jet(static_cast<double>(k) * 0.001)[0] == p[k]);
  std::printf("%zu of %zu equal to the bit\n", equal, p.size());

  // Beyond the samples: the exact peaks, and the findings between the knots.
  const Report report = check(table, {.position_min = 0, .position_max = 200});
  const Finding& worst = report.findings.front();
  std::printf("%zu broken; worst %.1f mm at %.3f s\n", report.broken(), worst.value, worst.where);
}

// > at 1 s: -173.3335 mm, -135.0002 mm/s, 500.000 mm/s^2
// > 11001 of 11001 equal to the bit
// > 6 broken; worst 596.1 mm at 4.588 s
