// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/design.hpp"

namespace jounce::test {

/// The cam of the PMC600 manual 6.2, Fig. 6.14. The slope at 280 is printed cut off (0.01739...);
/// this value gives all printed digits of both neighbours.
inline CamSpec fig_6_14() {
  CamSpec spec;
  spec.start = {0, 0, 0, 0};
  spec.segments = {{Law::quintic, {75, 100, 1, 0}, "catch up"},
                   {Law::quintic, {200, 225, 1, 0}, "in step"},
                   {Law::quintic, {280, 100, 0.01739120485, 0}, "return"},
                   {Law::quintic, {360, 0, 0, 0}, "settle"}};
  spec.periodic = true;
  return spec;
}

}  // namespace jounce::test
