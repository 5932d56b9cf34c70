// SPDX-License-Identifier: Apache-2.0
// Two versions of a cam: how far they differ and where, exactly, and which knot was touched.
#include <cstdio>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/difference.hpp"

using namespace jounce;

int main() {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {120, 50, {}, {}}, "rise"},
                   {Law::dwell, {200, 50, {}, {}}, "dwell"},
                   {Law::poly345, {360, 0, {}, {}}, "return"}};
  const Cam before = design(spec).cam;  // master in deg, slave in mm
  spec.segments[0].law = Law::inclined_sine;
  spec.segments[1].end.master = 190;
  const Cam after = design(spec).cam;

  const Changes changes = compare(before, after);
  const Extremum& most = changes[0].largest;
  std::printf("position: at most %.6g mm, at %.6g deg\n", most.value, most.where);
  std::printf("peak geo_velocity: %.6g, now %.6g mm/deg\n", changes[1].before.peak().value,
              changes[1].after.peak().value);
  const double knots_before[] = {0, 120, 200, 360};
  const double knots_after[] = {0, 120, 190, 360};
  for (const KnotChange& knot : knot_changes(before, knots_before, after, knots_after))
    std::printf("knot %zu moved from %g to %g deg\n", knot.after->index + 1, knot.before->where,
                knot.after->where);
}

// > position: at most -3.13918 mm, at 261.106 deg
// > peak geo_velocity: 0.733168, now 0.833333 mm/deg
// > knot 3 moved from 200 to 190 deg
