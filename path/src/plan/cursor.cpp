// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/timing/stretch.hpp"

namespace jounce {

namespace {

/// The piece at `at`, among those of an interval of the law.
std::size_t piece_at(std::span<const PathPiece> pieces, const LawInterval& interval, double at) {
  const auto first = pieces.begin() + static_cast<std::ptrdiff_t>(interval.piece);
  const auto behind = std::upper_bound(first + 1, first + interval.pieces, at,
                                       [](double x, const PathPiece& p) { return x < p.start; });
  return static_cast<std::size_t>(behind - pieces.begin()) - 1;
}

/// Motion of every axis at u on a piece, by the motion along the path.
void compose(const Path& path, std::size_t piece, double u, const Motion& q,
             std::span<Motion> out) {
  std::array<Jet, max_axes> jet;
  path.jets(piece, std::clamp(u, 0.0, path.pieces()[piece].length),
            std::span(jet).first(out.size()));
  const double v = q.velocity;
  if (path.pieces()[piece].kind == PieceKind::line) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double slope = jet[i][1];
      out[i] = {jet[i][0], slope * v, slope * q.acceleration + 0.0, slope * q.jerk + 0.0};
    }
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Jet& r = jet[i];
    out[i] = {r[0], r[1] * v, r[1] * q.acceleration + r[2] * v * v,
              r[1] * q.jerk + 3 * r[2] * v * q.acceleration + r[3] * v * v * v};
  }
}

}  // namespace

namespace {

/// True at the end of a law that ends at the end of the path. Its distance is a sum: without rounding, the last piece
/// ends there.
bool is_at_end(const Path& path, const TimingLaw& law, const LawStretches::Iterator& at, double t) {
  const LawInterval& interval = *at;
  return t >= interval.time + interval.duration && at.index() + 1 == law.stretches().size() &&
         interval.piece + interval.pieces == path.pieces().size() &&
         interval.start + interval.length >= path.length() * (1 - profiles_detail::rounded_sum);
}

}  // namespace

void Plan::at(double t, std::span<Motion> out) const {
  require_size("out", out.size(), path_.axes());
  const LawStretches::Iterator at_t = law_.find(t);
  const LawInterval& interval = *at_t;
  const Motion q = motion_in(interval, t - interval.time);
  const auto pieces = path_.pieces();
  std::size_t piece = interval.piece;
  double u = q.position + (interval.start - pieces[piece].start);
  if (interval.pieces > 1) {
    const double at = pieces[piece].start + u;
    piece = piece_at(pieces, interval, at);
    u = at - pieces[piece].start;
  }
  if (is_at_end(path_, law_, at_t, t)) u = pieces[piece = pieces.size() - 1].length;
  compose(path_, piece, u, q, out);
}

/// Finds the interval of the law at t, which is usually the next one.
void PlanCursor::seek(double t) {
  const TimingLaw& law = plan_->law();
  constexpr double none = std::numeric_limits<double>::infinity();
  const bool follows = count_ > 0 && to_ < none && t >= to_;
  if (follows) ++interval_;
  if (!follows || !(t < interval_.next_time())) interval_ = law.find(t);
  from_ = interval_.index() == 0 ? -none : interval_->time;
  to_ = interval_.next_time();
  count_ = phases(*interval_, phases_);
  piece_ = interval_->piece;
}

/// True if q is in this piece. The first and the last piece of the interval also include all q
/// before and after them.
bool PlanCursor::is_in_piece(double q, std::size_t piece) const {
  const LawInterval& interval = *interval_;
  const auto pieces = plan_->path().pieces();
  return (piece == interval.piece || pieces[piece].start <= q) &&
         (piece + 1 == interval.piece + interval.pieces || q < pieces[piece + 1].start);
}

void PlanCursor::at(double t, std::span<Motion> out) {
  const Path& path = plan_->path();
  require_size("out", out.size(), path.axes());
  if (!(t >= from_ && t < to_)) seek(t);
  const LawInterval& interval = *interval_;
  const Motion q = motion_of(std::span(phases_).first(count_), t - interval.time);
  const auto pieces = path.pieces();
  double u = q.position + (interval.start - pieces[interval.piece].start);
  if (interval.pieces > 1) {
    const double at = pieces[interval.piece].start + u;
    if (!is_in_piece(at, piece_) &&
        !(piece_ + 1 < interval.piece + interval.pieces && is_in_piece(at, ++piece_)))
      piece_ = piece_at(pieces, interval, at);
    u = at - pieces[piece_].start;
  }
  if (is_at_end(path, plan_->law(), interval_, t)) u = pieces[piece_ = pieces.size() - 1].length;
  compose(path, piece_, u, q, out);
}

}  // namespace jounce
