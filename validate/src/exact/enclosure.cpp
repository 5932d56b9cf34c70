// SPDX-License-Identifier: Apache-2.0
// How peaks and zeros are enclosed. An output y = q z of z' = M z (equations (1) to (6) of
// ladder.cpp) differs from the chord between its values at the ends of an interval of length H by
//
//     (1)  |y(u) - chord(u)| <= H^2 / 8 max |y''|
//
// y''(u) = q exp(M u) (M^2 z) is a sum over the components of M^2 z:
//
//     (2)  max |y''| <= sum of G_j |(M^2 z)_j|,   G_j >= |q exp(M u)|_j for all u in [0, H]
//
// M^2 z is used rather than z: it vanishes when the drive is in balance with a constant
// acceleration, however large z is. The bound is therefore close if the motion is smooth.
// With H = m h and |M| entry by entry,
//
//     (3)  G = max over i < m of |q exp(M h)^i| exp(|M| h)
//
// because |exp(M v)| <= exp(|M| v) <= exp(|M| h) entry by entry. If (1) does not decide for an
// interval, the interval is divided. On an interval no longer than h, where the norm of M h is at
// most 1/2, y is the polynomial
//
//     (4)  y(u) = sum of q (M H)^k z / k! (u / H)^k,  k = 0 ... 11,  but for 0.5^12 / 12! = 5e-13
//
// The extrema and zeros of this polynomial are isolated like those of any segment. Nothing is
// sampled.

#include "validate/src/exact/enclosure.hpp"

#include "jounce/profiles/detail/tolerances.hpp"

#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_sum;

constexpr std::size_t doublings =
    3;  // in units of h: bounds over a norm of 2 to 4 are still useful

}  // namespace

Enclosure::Enclosure(Ladder& ladder)
    : ladder_(&ladder),
      level_(doublings),
      longest_(std::ldexp(ladder.shortest(), static_cast<int>(doublings))),
      twice_(product(ladder.matrix(), ladder.matrix())),
      second_(ladder.zero()) {
  const Eigen::MatrixXd within = ladder.greatest();
  Eigen::MatrixXd rows = ladder.outputs();
  reach_ = product(rows.cwiseAbs(), within);
  for (int i = 1; i < 1 << doublings; ++i) {  // (3)
    rows = product(rows, ladder.rung(0));
    reach_ = reach_.cwiseMax(product(rows.cwiseAbs(), within));
  }
}

void Enclosure::bend(const Eigen::VectorXd& z, double* found) {
  multiply(twice_, z.data(), twice_.rows(), second_.data());
  for (Eigen::Index k = 0; k < second_.size(); ++k) second_(k) = std::abs(second_(k));
  multiply(reach_, second_.data(), reach_.rows(), found);  // (2)
}

Enclosure::Halves Enclosure::halves(const TrajectorySpan& s) {
  std::size_t rung = 0;  // the longest one with a useful bound
  while (std::ldexp(ladder_->shortest(), static_cast<int>(rung) + 1) < s.length * (1 - rounded_sum))
    ++rung;
  const double gone = std::ldexp(ladder_->shortest(), static_cast<int>(rung));
  Halves h{s, s};
  h.first.length = gone;
  h.second.time += gone;
  h.second.length -= gone;
  multiply(ladder_->rung(rung), s.z.data(), s.z.size(), h.second.z.data());
  ladder_->read(h.second.z, h.first.end.data());
  h.second.begin = h.first.end;
  bend(h.second.z, h.second.bend.data());
  return h;
}

}  // namespace jounce::validate_detail
