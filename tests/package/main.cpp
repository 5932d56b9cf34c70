#include <cstdio>

#include <jounce/profiles/extrema.hpp>
#include <jounce/profiles/s_curve.hpp>

int main() {
  const jounce::Trajectory move =
      jounce::trapezoid({.to = 50000, .velocity = 50, .acceleration = 0.25, .deceleration = 0.125})
          .curve();
  const jounce::Range v = jounce::extrema(move, 1);
  std::printf("%g ms, at most %g pulse/ms\n", move.end(), v.max.value);
}
