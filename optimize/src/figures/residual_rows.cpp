// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/vibration/vibration_band.hpp"

#include "optimize/src/figures/band_peaks.hpp"
#include "optimize/src/program/auxiliary_variables.hpp"
#include "optimize/src/program/chebyshev.hpp"

// The residual R of a mode (jounce/profiles/vibration/vibration_band.hpp, residual_phasor) is
// linear in the shape. With the coordinates z and sizes S of spline_space.hpp, piece i of length h
// that ends at e_i, the end e of the shape, and the pole s,
//
//   (1)  R(z) = sum over i, j of z_ij S_ij e^(s (e - e_i)) r_j(h),   r_j: of the single segment u^j / j!
//   (2)  |R| is the highest of the planes Re(e^(-i t) R) over all directions t
//
// The worst residual of a band is the highest of the planes of all its modes. It is therefore
// convex. The first planes are four for each of a few modes. Each part of the band and each local
// peak then adds the plane that touches it at its worst mode, if that exceeds the level.

namespace jounce::optimize_detail {
namespace {

using profiles_detail::rounded_value;

using Complex = std::complex<double>;

constexpr int parts = 8;  ///< parts of a band; each gives one cut in a round
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
      if (std::abs(space.length(i) - length) > rounded_value * length) {
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

/// Every plane of a band, in the few auxiliary variables of the figure.
class LiftedBand {
 public:
  LiftedBand(const SplineSpace& space, const ModeBand& band)
      : frequencies_(band.low, band.high, 2 * std::numbers::pi * length_of(space)),
        dampings_(band.damping_low, band.damping_high,
                  2 * std::numbers::pi * band.high * length_of(space)),
        usable_(!frequencies_.too_few() && !dampings_.too_few() && band.damping_high <= 0.5 &&
                frequencies_.at().size() * dampings_.at().size() <= most_modes) {}

  /// True if a few modes represent the whole band.
  [[nodiscard]] bool usable() const { return usable_; }

  void auxiliary(const SplineSpace& space, const Auxiliary& from, FigureRows& rows) {
    Eigen::MatrixXd sees = Eigen::MatrixXd::Zero(
        static_cast<Eigen::Index>(2 * frequencies_.at().size() * dampings_.at().size()),
        static_cast<Eigen::Index>(space.size()));
    Eigen::Index row = 0;
    for (const double damping : dampings_.at())
      for (const double frequency : frequencies_.at()) {
        const Phasors phasors(space, {frequency, damping});
        for (std::size_t k = 0; k < phasors.index.size(); ++k) {
          const auto column = static_cast<Eigen::Index>(phasors.index[k]);
          sees(row, column) = phasors.factor[k].real();
          sees(row + 1, column) = phasors.factor[k].imag();
        }
        row += 2;
      }
    const Affine all{Eigen::VectorXd::Zero(sees.rows()), without_joints(sees, space)};
    parts_ = with_auxiliary_variables(all, from, rows);
  }

  /// (2), by (3).
  [[nodiscard]] Form plane(const Mode& mode, Complex direction) const {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(parts_.factor.cols());
    const std::vector<double> of_frequency = frequencies_.shares(mode.frequency);
    Eigen::Index row = 0;
    for (const double d : dampings_.shares(mode.damping))
      for (const double f : of_frequency) {
        by += d * f *
              (direction.real() * parts_.factor.row(row) +
               direction.imag() * parts_.factor.row(row + 1))
                  .transpose();
        row += 2;
      }
    Form form;
    for (Eigen::Index k = 0; k < by.size(); ++k)
      form.terms.push_back({parts_.first + static_cast<std::size_t>(k), by[k]});
    return form;
  }

 private:
  static constexpr std::size_t most_modes = 512;
  static double length_of(const SplineSpace& space) {
    return space.knots().back() - space.knots().front();
  }

  ChebyshevNodes frequencies_, dampings_;
  bool usable_;
  Affine parts_ = {};
};

using Plane = std::function<Form(const Mode& mode, Complex direction)>;

/// The response as the rows use it: with_auxiliary_variables, if that is requested and it has few independent numbers.
Plane planes_of(const SplineSpace& space, const ModeBand& band, const Auxiliary* auxiliary,
                FigureRows& rows) {
  const auto few = std::make_shared<LiftedBand>(space, band);
  if (!auxiliary || !few->usable())
    return [&space](const Mode& mode, Complex direction) {
      return Phasors(space, mode).plane(direction);
    };
  few->auxiliary(space, *auxiliary, rows);
  return [few](const Mode& mode, Complex direction) { return few->plane(mode, direction); };
}

/// The worst mode of the band, as accurate as worst_residual() proves it, and every local peak.
double residual_of(const Trajectory& motion, const ModeBand& band) {
  double most = worst_residual(motion, band).residual;
  for (const WorstMode& peak : band_peaks(motion, band)) most = std::max(most, peak.residual);
  return most;
}

std::vector<Form> planes_to_begin_with(const ModeBand& band, const Plane& plane) {
  constexpr std::array directions{Complex(1, 0), Complex(-1, 0), Complex(0, 1), Complex(0, -1)};
  std::vector<Form> planes;
  for (const ModeBand& part : parts_of(band))
    for (const Complex direction : directions)
      planes.push_back(plane({(part.low + part.high) / 2, band.damping_low}, direction));
  return planes;
}

}  // namespace

FigureRows rows_of(const ResidualOf& figure, const SplineSpace& space, const Auxiliary* auxiliary) {
  const ModeBand band = band_of(figure);
  const double begin = space.knots().front();
  FigureRows rows{.name = name(figure), .value = [band, begin](const auto& shape) {
                    return residual_of(Trajectory(shape, begin), band);
                  }};
  rows.natural = space.natural(derivative_of_shape(0));
  const Plane plane = planes_of(space, band, auxiliary, rows);
  rows.start = planes_to_begin_with(band, plane);
  rows.cuts = [band, begin, plane](const std::vector<Segment>& shape, double level) {
    const Trajectory motion(shape, begin);
    std::vector<Form> planes;
    const auto cut = [&](const WorstMode& worst) {
      if (!(worst.residual > level)) return;
      const Complex at = residual_phasor(motion, worst.mode);
      planes.push_back(plane(worst.mode, at / std::abs(at)));
    };
    for (const ModeBand& part : parts_of(band)) cut(worst_residual(motion, part, search_tolerance));
    for (const WorstMode& peak : band_peaks(motion, band)) cut(peak);
    return planes;
  };
  return rows;
}

}  // namespace jounce::optimize_detail
