#include "jounce/profiles/profile.hpp"

#include <cassert>
#include <vector>

namespace jounce {
namespace {

struct State {
  double position;
  double velocity;
};

Segment phase_segment(const Profile::Phase& phase, const State& at_start) {
  const double t = phase.duration;
  Segment f;
  f.length = t;
  f.degree = phase.jerk != 0 ? 3 : (phase.acceleration != 0 ? 2 : 1);
  f.c[0] = at_start.position;
  f.c[1] = at_start.velocity * t;
  f.c[2] = phase.acceleration * t * t / 2;
  f.c[3] = phase.jerk * t * t * t / 6;
  return f;
}

State after(const Profile::Phase& phase, const State& s) {
  const double t = phase.duration;
  return {s.position + t * (s.velocity + t * (phase.acceleration / 2 + t * phase.jerk / 6)),
          s.velocity + t * (phase.acceleration + t * phase.jerk / 2)};
}

State before(const Profile::Phase& phase, const State& s) {
  const double t = phase.duration;
  const double v = s.velocity - t * (phase.acceleration + t * phase.jerk / 2);
  return {s.position - t * (v + t * (phase.acceleration / 2 + t * phase.jerk / 6)), v};
}

bool is_cruise(const Profile::Phase& phase) {
  return phase.acceleration == 0 && phase.jerk == 0;
}

}  // namespace

void Profile::add(double phase_duration, double acceleration, double jerk) {
  assert(count < phases.size());
  if (phase_duration > 0) phases[count++] = {phase_duration, acceleration, jerk};
}

double Profile::duration() const {
  double t = 0;
  for (const auto& phase : used()) t += phase.duration;
  return t;
}

Trajectory Profile::curve() const {
  std::vector<Segment> segments(count);
  State forward{from, 0};
  for (std::size_t i = 0; i < accelerating; ++i) {
    segments[i] = phase_segment(phases[i], forward);
    forward = after(phases[i], forward);
  }
  State backward{to, 0};
  std::size_t i = count;
  while (i > accelerating && !is_cruise(phases[i - 1])) {
    --i;
    backward = before(phases[i], backward);
    segments[i] = phase_segment(phases[i], backward);
  }
  // What rounding left between the two halves goes into the cruise.
  if (i > accelerating)
    segments[i - 1] = line(phases[i - 1].duration, forward.position, backward.position);
  return Trajectory(std::move(segments), 0, Outside::hold);
}

}  // namespace jounce
