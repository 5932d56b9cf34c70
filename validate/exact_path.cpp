#include "jounce/validate/detail/exact_path.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace jounce::detail {
namespace {

std::vector<double> frequencies(const Segment& f) {
  std::vector<double> found;
  for (int i = 0; i < f.sines; ++i)
    found.push_back(f.sine[static_cast<std::size_t>(i)].angle / f.length);
  return found;
}

}  // namespace

ExactPath::ExactPath(const LinearSystem& system, const Trajectory& reference, double step,
                     Eigen::VectorXd rest)
    : system_(system), reference_(reference), step_(step), rest_(std::move(rest)) {
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
  z_ = rest_;
  before_ = {evaluate(segment(0), 0)[0], 0};
}

void ExactPath::enter(const Segment& f) {
  const Jet r = evaluate(f, 0);
  ladder_ = &ladder_for(f);
  segment_ = &f;
  Eigen::VectorXd z = ladder_->zero();
  z.head(system_.states()) = z_.head(system_.states()) -
                             (r[0] - before_[0]) * system_.follows_position -
                             (r[1] - before_[1]) * system_.follows_velocity;
  z_.swap(z);
  ladder_->place(f, 0, z_);
}

void ExactPath::leave() {
  const Jet r = evaluate(*segment_, 1);
  before_ = {r[0], r[1]};
}

Eigen::MatrixXd ExactPath::at(std::span<const double> times) {
  Eigen::MatrixXd found(system_.outputs(), static_cast<Eigen::Index>(times.size()));
  const std::size_t count = reference_.segments().size();
  const auto breaks = reference_.breaks();
  std::size_t next = 0;
  begin();
  for (std::size_t i = 0; i <= count && next < times.size(); ++i) {
    enter(segment(i));
    double u = 0;
    for (; next < times.size() && (i == count || times[next] < breaks[i + 1]); ++next) {
      u += ladder_->advance(z_, times[next] - breaks[i] - u);
      ladder_->place(*segment_, i == count ? 0 : u, z_);
      ladder_->read(z_, found.col(static_cast<Eigen::Index>(next)).data());
    }
    if (i == count) break;
    ladder_->advance(z_, segment_->length - u);
    leave();
  }
  return found;
}

ExactPath::Whole ExactPath::whole() {
  Whole whole;
  begin();
  for (const Segment& f : reference_.segments()) {
    enter(f);
    ladder_->advance(z_, f.length, 0, whole.square);
    ladder_->place(f, f.length, z_);
    leave();
  }
  whole.output = ladder_->outputs() * z_;
  enter(standstill_);
  whole.state = z_.head(system_.states());
  return whole;
}

}  // namespace jounce::detail
