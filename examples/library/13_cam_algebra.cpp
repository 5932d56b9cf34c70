// SPDX-License-Identifier: Apache-2.0
// Cams made of cams, and the way back: which master position belongs to a slave position.
#include <cstdio>

#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/cam/algebra/inverse.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/limits/limits.hpp"

using namespace jounce;

int main() {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {120, 50, {}, {}}, "rise"},
                   {Law::dwell, {200, 50, {}, {}}, "dwell"},
                   {Law::poly345, {360, 0, {}, {}}, "return"}};
  spec.periodic = true;
  const Cam cam = design(spec).cam;  // master in deg, slave in mm

  const Cam lane2 = phased(cam, 180);
  std::printf("lane 2 at 240 deg: %.4g mm, period %.4g deg\n", lane2.at(240).position,
              lane2.length());

  // A shake of 2 mm, three times in two turns: the sum repeats after two turns.
  const Cam rise({quintic(120, 0, 0, 0, 2, 0, 0)});
  const Cam shake = with(concatenated(rise, reversed(rise)), Extrapolation::wrap);
  const Cam both = superimposed(cam, shake);
  std::printf("together: period %.4g deg, smooth: %s\n", both.length(),
              check_continuity(both, 2).ok() ? "yes" : "no");

  // The rise behind a camshaft that itself rises by a cycloid: degree and sines fit no segment.
  Segment cycloid = line(360, 0, 120);
  cycloid.sines = 1;
  cycloid.sine[0] = {-120 / 6.283185307179586, 6.283185307179586, 0};
  const auto driven = composed_within(cam, Cam({cycloid}), 1e-6);
  std::printf("behind the shaft: %zu segments, at most %.2g mm off\n",
              driven.curve.segments().size(), driven.error[0]);

  const Inversion inverse = inverted(cam);
  for (const Finding& finding : inverse.report.findings)
    std::printf("%s: %s\n", finding.rule.text().c_str(), finding.advice.c_str());
  const Transfer there = inverse.branches[0].at(25);
  std::printf("25 mm on the rise: %.6g deg, %.4g deg/mm\n", there.position, there.geo_velocity);
  for (const MasterSpan& at : positions_for(cam, 50))
    std::printf("50 mm: from %.4g to %.4g deg\n", at.from, at.to);
}

// > lane 2 at 240 deg: 25 mm, period 360 deg
// > together: period 720 deg, smooth: yes
// > behind the shaft: 12 segments, at most 2.3e-07 mm off
// > inverse/dwell: the slave stands still from 120 to 200: the master jumps
// > inverse/reversal: the slave runs back from 200 to 360: choose a branch
// > 25 mm on the rise: 60 deg, 1.364 deg/mm
// > 50 mm: from 120 to 200 deg
