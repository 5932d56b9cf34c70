// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/common_pieces.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/compensation.hpp"
#include "jounce/pvt/table.hpp"

#include "pvt/src/compensation/grid_cell.hpp"

// Between two breaks of any of the curves, and two passages of grid lines, all references stay in
// one cell. Inserted into the cell's polynomial, they give a polynomial whose degree is the product
// of the degrees. If this does not fit into a segment, or if sines meet more than a straight line,
// the piece is fitted (detail/hermite.hpp). The same substitution gives the series of the fit at
// both ends, and the majorant of the twelfth derivative.

namespace jounce {
namespace {

using Cell = Compensation::Cell;

/// The part [from, to] of a curve as one segment.
Segment stretch(const Trajectory& f, double from, double to) {
  const auto breaks = f.breaks();
  const double middle = from + (to - from) / 2;
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, middle);
  const auto i = static_cast<std::size_t>(above - breaks.begin()) - 1;
  const Segment& whole = f.segments()[i];
  const double s0 = std::clamp((from - breaks[i]) / whole.length, 0.0, 1.0);
  const double s1 = std::clamp((to - breaks[i]) / whole.length, 0.0, 1.0);
  Segment cut = s0 == 0 && s1 == 1 ? whole : part(whole, s0, s1);
  cut.length = to - from;
  return cut;
}

/// A part of the references that is within one cell: s_j as segments.
struct Piece {
  Cell cell;
  std::array<Segment, 3> s;
  std::size_t references = 1;

  Piece(const Compensation& compensation, std::span<const Segment> x) : references(x.size()) {
    std::array<double, 3> middle{};
    for (std::size_t j = 0; j < references; ++j) middle[j] = value(x[j], 0.5);
    cell = compensation.cell(std::span(middle).first(references));
    for (std::size_t j = 0; j < references; ++j)
      s[j] = scaled(x[j], cell.per_interval[j], -cell.start[j] * cell.per_interval[j]);
  }
  Piece(const Piece& whole, double from, double to)
      : cell(whole.cell), references(whole.references) {
    for (std::size_t j = 0; j < references; ++j) s[j] = part(whole.s[j], from, to);
  }

  template <std::size_t n, class Of>
  [[nodiscard]] pvt_detail::Terms<n> of(const Cell& with, Of terms) const {
    std::array<pvt_detail::Terms<n>, 3> each{};
    for (std::size_t j = 0; j < references; ++j) each[j] = terms(s[j]);
    return pvt_detail::evaluated(with, each, references);
  }

  // Interface that profiles_detail::fit requires.
  [[nodiscard]] double length() const { return s[0].length; }
  [[nodiscard]] profiles_detail::EndSeries end(double at) const {
    return of<6>(cell, [at](const Segment& f) { return profiles_detail::taylor(f, at); });
  }
  [[nodiscard]] double twelfth() const {
    Cell positive = cell;
    for (double& k : positive.k) k = std::abs(k);
    return of<13>(positive, [](const Segment& f) { return profiles_detail::majorant(f, 1); })
        .back();
  }
  [[nodiscard]] std::pair<Piece, Piece> halves() const {
    return {Piece(*this, 0, 0.5), Piece(*this, 0.5, 1)};
  }
};

/// The piece as one segment; nullopt if it does not fit.
std::optional<Segment> exact(const Piece& piece) {
  int degree = 0;
  int sines = 0;
  for (std::size_t j = 0; j < piece.references; ++j) {
    if (piece.cell.per_interval[j] == 0) continue;
    degree += piece.s[j].degree;
    sines += piece.s[j].sines;
  }
  if (piece.references == 1 && piece.cell.order == 2)
    return scaled(piece.s[0], piece.cell.k[1], piece.cell.k[0]);
  degree *= static_cast<int>(piece.cell.order) - 1;
  if (sines > 0 || degree > Segment::max_degree) return std::nullopt;
  Segment f;
  f.length = piece.length();
  f.c = piece.of<Segment::max_degree + 1>(piece.cell, [](const Segment& s) { return s.c; });
  f.degree = degree;
  return f;
}

std::vector<double> cuts(const Trajectory& motion, const Compensation& compensation,
                         std::span<const Trajectory> references) {
  std::vector<double> all(motion.breaks().begin(), motion.breaks().end());
  for (std::size_t j = 0; j < references.size(); ++j) {
    all.insert(all.end(), references[j].breaks().begin(), references[j].breaks().end());
    const GridAxis& axis = compensation.axes()[j];
    const Range travel = extrema(references[j], 0);
    const double first = std::ceil((travel.min.value - axis.base) / axis.interval);
    const double last = std::floor((travel.max.value - axis.base) / axis.interval);
    for (double i = std::max(first, 0.0); i <= std::min(last, static_cast<double>(axis.count - 1));
         ++i)
      for (const double t : crossings(references[j], 0, axis.base + i * axis.interval))
        all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  const double apart = 1e-13 * std::max(std::abs(motion.start()), std::abs(motion.end()));
  std::vector<double> kept{motion.start()};
  for (const double t : all)
    if (t - kept.back() > apart && motion.end() - t > apart) kept.push_back(t);
  kept.push_back(motion.end());
  return kept;
}

void require_one_pass(const Trajectory& motion, const std::string& key) {
  if (motion.outside() == Extrapolation::advance)
    throw InputError(
        key, name(motion.outside()),
        "advances from pass to pass, but the grid does not: use as many passes as the axis runs");
}

void require_references(const Trajectory& motion, const Compensation& compensation,
                        std::span<const Trajectory> references) {
  if (references.size() != compensation.references())
    throw InputError("references", std::to_string(references.size()),
                     "the grid has " + std::to_string(compensation.references()));
  require_one_pass(motion, "motion");
  for (std::size_t j = 0; j < references.size(); ++j)
    require_one_pass(references[j], "references[" + std::to_string(j + 1) + "]");
  const double scale = std::max(std::abs(motion.start()), std::abs(motion.end()));
  for (std::size_t j = 0; j < references.size(); ++j)
    if (!profiles_detail::same_place(references[j].start(), motion.start(), scale) ||
        !profiles_detail::same_place(references[j].end(), motion.end(), scale))
      throw InputError(
          "references[" + std::to_string(j + 1) + "]",
          number(references[j].start()) + " to " + number(references[j].end()),
          "must span the motion, " + number(motion.start()) + " to " + number(motion.end()));
}

}  // namespace

Fitted<OverTime> compensated(const Trajectory& motion, const Compensation& compensation,
                             std::span<const Trajectory> references, double tolerance) {
  require_references(motion, compensation, references);
  profiles_detail::require_tolerance(tolerance, compensation.peak());
  const std::vector<double> at = cuts(motion, compensation, references);
  std::vector<Segment> out;
  std::vector<Segment> fitted;
  std::vector<Segment> x(references.size());
  Jet error{};
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = stretch(references[j], at[i], at[i + 1]);
    const Piece piece(compensation, x);
    const Segment y = stretch(motion, at[i], at[i + 1]);
    if (const auto c = exact(piece))
      if (const auto both = sum(y, *c)) {
        out.push_back(*both);
        continue;
      }
    fitted.clear();
    profiles_detail::fit(piece, tolerance, fitted, error);
    double from = 0;
    for (const Segment& c : fitted) {
      const double to = std::min(1.0, from + c.length / y.length);
      Segment under = part(y, from, to);
      under.length = c.length;
      out.push_back(*sum(under, c));  // a fit has no sines
      from = to;
    }
  }
  return {Trajectory(std::move(out), motion.start(), motion.outside()), error};
}

}  // namespace jounce
