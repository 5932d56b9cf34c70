// SPDX-License-Identifier: Apache-2.0
// A rotary knife: the cam of one cut, what it asks of the knife, and how fast the line may run.
#include <cstdio>
#include <numbers>

#include "jounce/gear/cut_length_map.hpp"
#include "jounce/gear/rotary_knife.hpp"

int main() {
  using namespace jounce;
  RotaryKnifeSpec spec{
      .diameter = 3, .cut_length = 4.71, .sync_angle = 10 * std::numbers::pi / 180};  // in, rad
  const SyncCam knife = rotary_knife(spec);
  const RotaryKnifeFigures f = figures(spec);
  std::printf("C %.6f in, rho %.6f, longest %.6f in\n", f.synchronous, f.rho, f.longest);
  std::printf("a cut turns the knife by %.6f rad\n", knife.cam.advance());

  const CamOfLength cams = [&](double length) -> std::optional<Cam> {
    if (!(length > f.sync_length)) return std::nullopt;
    spec.cut_length = length;
    return rotary_knife(spec).cam;
  };
  const CutLimits limits{{.velocity = 40, .acceleration = 400}, 60};
  for (const double length : {2.0, 4.71, 9.42477796076938}) {
    const CutSpeed fastest = fastest_cut(cams, length, limits);
    std::printf("%.2f in: %.4f in/s, %s\n", length, fastest.speed, fastest.limit.c_str());
  }
  std::printf("shortest at 20 in/s: %.6f in\n",
              *shortest_length(cams, limits, 20, f.sync_length, f.synchronous));
}
// > C 9.424778 in, rho 0.485454, longest 19.896753 in
// > a cut turns the knife by 6.283185 rad
// > 2.00 in: 6.5030 in/s, acceleration
// > 4.71 in: 20.0846 in/s, velocity
// > 9.42 in: 60.0000 in/s, line
// > shortest at 20 in/s: 4.695499 in
