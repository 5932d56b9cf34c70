// SPDX-License-Identifier: Apache-2.0
// Times and positions become a table, its velocities filled in without overshoot or within limits.
#include <cstdio>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/pvt/fill.hpp"

using namespace jounce;

int main() {
  FillSpec spec{.x = {0, 2, 3, 4, 6, 11}, .p = {0, 153.333, 42.123, 161.21, 177, 83.333}};
  spec.v = {0, {}, {}, {}, {}, 0};  // at rest at both ends
  for (const Filling filling : {Filling::natural, Filling::shape_preserving}) {
    spec.filling = filling;
    const Range p = extrema(filled(spec).table.curve<OverTime>(), 0);
    std::printf("%s: %.4g ... %.4g mm\n", name(filling), p.min.value, p.max.value);
  }

  spec.filling = Filling::within_limits;
  spec.limits = {.velocity = 130};
  for (const Finding& f : filled(spec).report.findings)
    std::printf("piece %zu: %.4g s, needs %.4g s\n", *f.segment + 1, f.value, f.limit);
}
// > natural: 0 ... 215.1 mm
// > shape_preserving: 0 ... 177 mm
// > piece 2: 1 s, needs 1.007 s
