// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/cam/disc/disc.hpp"

#include "cam/src/design/enclosure.hpp"

// The roller's center in the fixed frame of the follower, as a complex number x + i y, with lift L
// over the cam's angle t, sigma = 1 for a cam that turns counterclockwise and -1 otherwise:
//
//   (1)  P = e + i (d + L)             translating: offset e, height d
//   (2)  P = c - l exp(-i psi)         oscillating: psi = psi0 + L / l, arm l, center distance c
//
// In the frame of the cam it is C = P exp(-i sigma t), the pitch curve. Its derivatives are:
//
//   (3)  C' = T exp(-i sigma t),       T  = P' - i sigma P
//   (4)  C'' = T2 exp(-i sigma t),     T2 = T' - i sigma T
//   (5)  n = i sigma T / |T|           outwards; the profile is C - (roller radius) n
//   (6)  kappa = -sigma (T x T2) / |T|^3
//
// and with D = dP/dL / |dP/dL|, the direction of the follower's lift:
//
//   (7)  tan(pressure angle) = (T . D) / (sigma T x D)
//
// For (1) this is (L' - sigma e) / (d + L). See R. Norton, "Cam Design and Manufacturing Handbook",
// ch. 7; the complex form covers both followers and both rotations in one implementation.
namespace jounce::cam_detail {

/// A point, or a direction, with its derivatives by t.
template <std::size_t N>
struct Plane {
  Taylor<N> x, y;

  template <std::size_t M>
  [[nodiscard]] Plane<M> to() const {
    return {x.template to<M>(), y.template to<M>()};
  }
};

template <std::size_t N>
Plane<N> operator+(const Plane<N>& a, const Plane<N>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <std::size_t N>
Plane<N> operator-(const Plane<N>& a, const Plane<N>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <std::size_t N>
Plane<N> operator*(double factor, const Plane<N>& a) {
  return {factor * a.x, factor * a.y};
}
template <std::size_t N>
Taylor<N> dot(const Plane<N>& a, const Plane<N>& b) {
  return a.x * b.x + a.y * b.y;
}
template <std::size_t N>
Taylor<N> cross(const Plane<N>& a, const Plane<N>& b) {
  return a.x * b.y - a.y * b.x;
}
template <std::size_t N>
Plane<N - 1> derivative(const Plane<N>& a) {
  return {derivative(a.x), derivative(a.y)};
}

/// Equation (3): the derivative of a vector that turns with the cam, in the fixed frame.
template <std::size_t N>
Plane<N - 1> turning(const Plane<N>& a, double sigma) {
  const Plane<N - 1> d = derivative(a);
  const Plane<N - 1> b = a.template to<N - 1>();
  return {d.x + sigma * b.y, d.y - sigma * b.x};
}

/// The pitch curve over an interval, in the fixed frame.
struct Pitch {
  double sigma = 1;
  Plane<4> center;     ///< P
  Plane<4> direction;  ///< D
  Plane<3> tangent;    ///< T

  [[nodiscard]] Taylor<3> speed() const { return sqrt(square(tangent.x) + square(tangent.y)); }
  /// Equation (5).
  [[nodiscard]] Plane<3> normal() const {
    const Taylor<3> v = speed();
    return {(-sigma * tangent.y) / v, (sigma * tangent.x) / v};
  }
  /// Equation (6).
  [[nodiscard]] Taylor<2> curvature() const {
    const Taylor<2> v = speed().to<2>();
    return (-sigma * cross(tangent.to<2>(), turning(tangent, sigma))) / (v * v * v);
  }
  /// The numerator and denominator of (7).
  [[nodiscard]] Taylor<2> across() const { return dot(tangent, direction.to<3>()).to<2>(); }
  [[nodiscard]] Taylor<2> along() const {
    return sigma * cross(tangent, direction.to<3>()).to<2>();
  }
  /// The curve parallel to it, `distance` outwards.
  [[nodiscard]] Plane<3> parallel(double distance) const {
    return center.to<3>() + distance * normal();
  }
};

inline double sigma(const DiscSpec& spec) {
  return spec.rotation == Rotation::counterclockwise ? 1 : -1;
}

/// rad of the arm per slave unit.
inline double arm_angle(const DiscSpec& spec) {
  return spec.arm_angle.value_or(1 / spec.arm_length);
}

/// Throws InputError for a length or an angle of the disc that is not finite or has the wrong sign.
void require_lengths(const DiscSpec& spec);

/// Position of the roller on the base circle: Disc::start(). `travel`: greatest lift, in the slave's
/// unit. Throws InputError if the follower does not reach the circle.
double start_of(const DiscSpec& spec, double travel);

/// Equations (1), (2); lift in the slave's unit.
inline Pitch pitch(const DiscSpec& spec, double start, const Taylor<4>& lift) {
  Pitch p;
  p.sigma = sigma(spec);
  if (spec.follower == Follower::translating) {
    p.center = {Taylor<4>(spec.offset), Taylor<4>(start) + lift};
    p.direction = {Taylor<4>(0.0), Taylor<4>(1.0)};
  } else {
    const auto psi = sincos(Taylor<4>(start) + arm_angle(spec) * lift);
    p.center = {Taylor<4>(spec.center_distance) - spec.arm_length * psi.cos,
                spec.arm_length * psi.sin};
    p.direction = {psi.sin, psi.cos};
  }
  p.tangent = turning(p.center, p.sigma);
  return p;
}

/// The same over an interval of the disc's cam.
inline Pitch pitch(const Disc& disc, const SegmentPart& over) {
  return pitch(disc.spec(), disc.start(), enclosure(disc.lift(), over, disc.spec().angle));
}

/// A vector of the fixed frame in the frame of the cam: times exp(-i sigma t).
template <std::size_t N>
Plane<N> seen_from_cam(const Plane<N>& a, const Taylor<N>& t, double sigma) {
  const auto [sn, cs] = sincos(sigma * t);
  return {a.x * cs + a.y * sn, a.y * cs - a.x * sn};
}

/// t over an interval.
template <std::size_t N>
Taylor<N> turned(const Disc& disc, const SegmentPart& over) {
  Taylor<N> t(disc.spec().angle * Interval{position(disc.lift(), over.segment, over.s0),
                                           position(disc.lift(), over.segment, over.s1)});
  if constexpr (N > 0) t.c[1] = Interval(1);
  return t;
}

}  // namespace jounce::cam_detail
