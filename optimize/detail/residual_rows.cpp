#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "jounce/optimize/detail/figure_rows.hpp"
#include "jounce/profiles/vibration_band.hpp"

// What a mode keeps (profiles/vibration_band.hpp, residual_phasor) is linear in the shape: with the
// coordinates z of spline_space.hpp, piece i of length h ending at e_i, the end of all at e, and the pole s,
//
//   (1)  R(z) = sum over i, j of z_ij S_ij e^(s (e - e_i)) r_j(h),   r_j: of the single segment u^j / j!
//   (2)  |R| is the highest of the planes Re(e^(-i t) R) over all directions t
//
// The worst of a band is the highest of the planes of all its modes: convex. To begin with a few modes
// have four planes each; then each part of the band adds the plane that touches where it is worst, if
// that exceeds the level.

namespace jounce::optimizer {
namespace {

using Complex = std::complex<double>;

constexpr int parts = 8;  ///< of a band, each with one cut a round
constexpr double search_tolerance = 1e-6;

/// r_j of (1), j = 0 ... degree.
std::vector<Complex> responses(double length, int degree, const Mode& mode) {
  std::vector<Complex> all;
  double factor = 1;
  for (int j = 0; j <= degree; ++j) {
    Segment f;
    f.length = length;
    f.degree = j;
    f.c[static_cast<std::size_t>(j)] = factor;
    all.push_back(j == 0 ? 0 : residual_phasor(Trajectory({f}), mode));
    factor *= length / (j + 1);
  }
  return all;
}

/// The factors of (1) by coordinate.
struct Phasors {
  std::vector<std::size_t> index;
  std::vector<Complex> factor;

  Phasors(const SplineSpace& space, const Mode& mode) {
    const double w = 2 * std::numbers::pi * mode.frequency;
    const Complex s = w * Complex(-mode.damping, std::sqrt(1 - mode.damping * mode.damping));
    std::vector<Complex> of_piece;
    double length = 0;
    for (std::size_t i = 0; i < space.pieces(); ++i) {
      if (std::abs(space.length(i) - length) > 1e-14 * length) {
        length = space.length(i);
        of_piece = responses(length, space.degree(), mode);
      }
      const Complex decay = std::exp(s * (space.knots().back() - space.knots()[i + 1]));
      for (int j = 1; j <= space.degree(); ++j) {
        index.push_back(space.index(i, j));
        factor.push_back(decay * space.unit(i, j) * of_piece[static_cast<std::size_t>(j)]);
      }
    }
  }

  /// (2) in the direction of a number of magnitude one.
  [[nodiscard]] Form plane(Complex direction) const {
    Form form;
    form.terms.reserve(index.size());
    for (std::size_t k = 0; k < index.size(); ++k)
      form.terms.push_back({index[k], (std::conj(direction) * factor[k]).real()});
    return form;
  }
};

ModeBand band_of(const ResidualOf& f) {
  return {f.low, f.high, f.damping_low, f.damping_high};
}

/// The band cut into parts by frequency; one frequency is one part.
std::vector<ModeBand> parts_of(const ModeBand& band) {
  if (band.low == band.high) return {band};
  std::vector<ModeBand> all(parts, band);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return band.low + (band.high - band.low) * static_cast<double>(k) / parts;
    };
    all[i].low = at(i);
    all[i].high = i + 1 < all.size() ? at(i + 1) : band.high;
  }
  return all;
}

std::vector<Form> planes_to_begin_with(const SplineSpace& space, const ModeBand& band) {
  constexpr std::array directions{Complex(1, 0), Complex(-1, 0), Complex(0, 1), Complex(0, -1)};
  std::vector<Form> planes;
  for (const ModeBand& part : parts_of(band)) {
    const Phasors phasors(space, {(part.low + part.high) / 2, band.damping_low});
    for (const Complex direction : directions) planes.push_back(phasors.plane(direction));
  }
  return planes;
}

}  // namespace

FigureRows rows_of(const ResidualOf& figure, const SplineSpace& space) {
  const ModeBand band = band_of(figure);
  const double begin = space.knots().front();
  FigureRows rows{.name = name(figure), .value = [band, begin](const auto& shape) {
                    return worst_residual(Trajectory(shape, begin), band).residual;
                  }};
  rows.start = planes_to_begin_with(space, band);
  rows.cuts = [band, begin, &space](const std::vector<Segment>& shape, double level) {
    const Trajectory motion(shape, begin);
    std::vector<Form> planes;
    for (const ModeBand& part : parts_of(band)) {
      const WorstMode worst = worst_residual(motion, part, search_tolerance);
      if (!(worst.residual > level)) continue;
      const Complex at = residual_phasor(motion, worst.mode);
      planes.push_back(Phasors(space, worst.mode).plane(at / std::abs(at)));
    }
    return planes;
  };
  rows.natural = space.natural(derivative_of_shape(0));
  return rows;
}

}  // namespace jounce::optimizer
