// SPDX-License-Identifier: Apache-2.0
#include "validate/src/exact/exact_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_sum;

std::vector<double> frequencies(const Segment& f) {
  std::vector<double> found;
  for (int i = 0; i < f.sines; ++i)
    found.push_back(f.sine[static_cast<std::size_t>(i)].angle / f.length);
  return found;
}

/// The number of times from the first on that follow one another by `step`, to the rounding of times.
int equally_spaced(std::span<const double> times, double step, double end) {
  const double first = times[0];
  int count = 1;
  for (; count < Ladder::block && static_cast<std::size_t>(count) < times.size(); ++count) {
    const double t = times[static_cast<std::size_t>(count)];
    const double slack = rounded_sum * step + 2 * std::numeric_limits<double>::epsilon() *
                                                  std::max(std::abs(t), std::abs(first));
    if (!(t < end) || std::abs(t - first - count * step) > slack) break;
  }
  return count;
}

}  // namespace

ExactPath::ExactPath(const LinearSystem& system, const Trajectory& reference, double step,
                     PathStart start)
    : system_(system), reference_(reference), step_(step), start_(std::move(start)) {
  for (const Segment& f : reference.segments()) degree_ = std::max(degree_, f.degree);
  standstill_.c[0] = evaluate(reference.segments().back(), 1)[0];
}

Ladder& ExactPath::ladder_for(const Segment& f) {
  for (Ladder& ladder : ladders_)
    if (ladder.takes(f)) return ladder;
  return ladders_.emplace_back(system_, degree_, frequencies(f), step_);
}

const Segment& ExactPath::segment(std::size_t i) const {
  const auto segments = reference_.segments();
  return i < segments.size() ? segments[i] : standstill_;
}

void ExactPath::begin() {
  segment_ = nullptr;
  z_ = start_.state;
  before_ = {evaluate(segment(0), 0)[0], start_.velocity};
}

const Segment& ExactPath::enter(std::size_t i) {
  const Segment& f = segment(i);
  const Jet r = evaluate(f, 0);
  ladder_ = &ladder_for(f);
  segment_ = &f;
  Eigen::VectorXd z = ladder_->zero();
  z.head(system_.states()) = z_.head(system_.states()) -
                             (r[0] - before_[0]) * system_.follows_position -
                             (r[1] - before_[1]) * system_.follows_velocity;
  z_.swap(z);
  ladder_->place(f, 0, z_);
  return f;
}

void ExactPath::leave() {
  const Jet r = evaluate(*segment_, 1);
  before_ = {r[0], r[1]};
}

void ExactPath::read(std::span<const double> times, double begin, double u, double* found) {
  const auto count = static_cast<int>(times.size());
  const auto outputs = static_cast<std::size_t>(system_.outputs());
  ladder_->read_ahead(z_, count, ahead_.data());
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    std::copy_n(ahead_.data() + at * outputs, outputs, found + at * (outputs + 1));
    const double here = i == 0 ? u : times[at] - begin;
    found[at * (outputs + 1) + outputs] = value(*segment_, std::min(1.0, here / segment_->length));
  }
}

ExactPath::Whole ExactPath::along(std::span<const double> times, Eigen::MatrixXd& found) {
  Whole whole;
  const std::size_t count = reference_.segments().size();
  const auto breaks = reference_.breaks();
  std::size_t next = 0;
  found.resize(system_.outputs() + 1, static_cast<Eigen::Index>(times.size()));
  ahead_.resize(static_cast<std::size_t>(Ladder::block * system_.outputs()));
  begin();
  for (std::size_t i = 0; i <= count; ++i) {
    enter(i);
    const bool rests = i == count;
    if (rests) whole.state = z_.head(system_.states());
    const double end = rests ? std::numeric_limits<double>::infinity() : breaks[i + 1];
    ProductIntegral square;  // square of the first output
    double u = 0;
    while (next < times.size() && times[next] < end) {
      u += ladder_->advance(z_, times[next] - breaks[i] - u, std::span(&square, rests ? 0 : 1));
      ladder_->place(*segment_, rests ? 0 : u, z_);
      const int together = equally_spaced(times.subspan(next), ladder_->step(), end);
      read(times.subspan(next, static_cast<std::size_t>(together)), breaks[i], rests ? 0 : u,
           found.col(static_cast<Eigen::Index>(next)).data());
      next += static_cast<std::size_t>(together);
    }
    if (rests) break;
    ladder_->advance(z_, segment_->length - u, std::span(&square, rests ? 0 : 1));
    ladder_->place(*segment_, segment_->length, z_);
    whole.square += square.sum;
    whole.output = ladder_->outputs() * z_;
    reached_ = z_.head(system_.states());
    leave();
  }
  return whole;
}

ExactPath::Whole ExactPath::whole() {
  Eigen::MatrixXd none;
  return along({}, none);
}

}  // namespace jounce::validate_detail
