// SPDX-License-Identifier: Apache-2.0
// The same cam for four controllers: as few knots as do, in the numbers that they take.
#include <cstdio>

#include "jounce/cam/design/design.hpp"
#include "jounce/pvt/reduce.hpp"

using namespace jounce;

int main() {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {5000, 20000, {}, {}}, "rise"},
                   {Law::poly345, {10000, 0, {}, {}}, "return"}};
  spec.periodic = true;
  const Cam cam = design(spec).cam;  // master and slave in pulses

  const auto print = [](const char* what, const Sampled& made) {
    std::printf("%s: %zu knots, at most %.3g pulses off, bound by %s\n", what, made.table.size(),
                made.error.position, name(made.binding.value()));
  };
  print("cubic", reduced(cam, {.rule = Interpolation::cubic_hermite, .tolerance = 1}));
  print("lines", reduced(cam, {.rule = Interpolation::linear, .tolerance = 1}));
  print("17 points", reduced(cam, {.rule = Interpolation::linear, .most = 17, .x_step = 1}));
  print("counts",
        reduced(cam,
                {.rule = Interpolation::cubic_hermite, .tolerance = 2, .x_step = 1, .p_step = 1}));
}

// > cubic: 19 knots, at most 0.895 pulses off, bound by tolerance
// > lines: 184 knots, at most 0.994 pulses off, bound by tolerance
// > 17 points: 17 knots, at most 136 pulses off, bound by most
// > counts: 16 knots, at most 1.57 pulses off, bound by tolerance
