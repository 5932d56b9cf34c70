// SPDX-License-Identifier: Apache-2.0
#include "cam/src/fit/refine.hpp"

#include <cmath>

#include <Eigen/Cholesky>

#include "jounce/profiles/error.hpp"

namespace jounce::cam_detail {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Distances as shares of the tolerances; nullopt if the spec is not a cam.
std::optional<VectorXd> distances(const CamSpec& spec, const MeasuredCam& measured,
                                  const std::vector<std::size_t>& points) {
  try {
    const Cam cam = design(spec).cam;
    VectorXd all(static_cast<Eigen::Index>(points.size()));
    Eigen::Index row = 0;
    for (const std::size_t i : points) {
      const SplinePoint& p = measured.points[i];
      const Side side = p.master > cam.start() ? Side::left : Side::right;
      all[row++] = (cam.jet(p.master, side)[0] - p.slave) / p.tolerance;
    }
    return all;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Derivatives of the distances by the parameters, each in the unit of its scale.
MatrixXd slopes(const CamSpec& spec, const std::vector<Parameter>& parameters,
                const MeasuredCam& measured, const std::vector<std::size_t>& points,
                const VectorXd& now) {
  constexpr double step = 1e-7;  // share of the scale: half of the digits of a double
  MatrixXd all = MatrixXd::Zero(now.size(), static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t j = 0; j < parameters.size(); ++j)
    for (const double sign : {1.0, -1.0}) {
      CamSpec trial = spec;
      change(trial, parameters[j], sign * step * parameters[j].scale);
      const auto moved = distances(trial, measured, points);
      if (!moved) continue;
      all.col(static_cast<Eigen::Index>(j)) = (*moved - now) / (sign * step);
      break;
    }
  return all;
}

Deviation summary(const VectorXd& distances, const std::vector<std::size_t>& points) {
  if (points.empty()) return {0, 0, 0};
  Eigen::Index at = 0;
  const double worst = distances.cwiseAbs().maxCoeff(&at);
  return {worst, std::sqrt(distances.squaredNorm() / static_cast<double>(points.size())),
          points[static_cast<std::size_t>(at)]};
}

}  // namespace

double* field(CamSpec& spec, Parameter::Kind kind, std::size_t at) {
  switch (kind) {
    case Parameter::Kind::master:
      return &knot(spec, at).master;
    case Parameter::Kind::slave:
      return &knot(spec, at).slave;
    case Parameter::Kind::geo_velocity:
      return &*knot(spec, at).geo_velocity;
    case Parameter::Kind::geo_acceleration:
      return &*knot(spec, at).geo_acceleration;
    case Parameter::Kind::inflection:
      return &*spec.segments[at].form.inflection;
    case Parameter::Kind::straight:
      break;
  }
  return &*spec.segments[at].form.straight;
}

CamKnot& knot(CamSpec& spec, std::size_t number) {
  return number == 0 ? spec.start : spec.segments[number - 1].end;
}
const CamKnot& knot(const CamSpec& spec, std::size_t number) {
  return number == 0 ? spec.start : spec.segments[number - 1].end;
}

double value(const CamSpec& spec, const Parameter& parameter) {
  return *field(const_cast<CamSpec&>(spec), parameter.kind, parameter.at.front());
}

void change(CamSpec& spec, const Parameter& parameter, double by) {
  for (const std::size_t at : parameter.at) *field(spec, parameter.kind, at) += by;
}

Deviation deviation(const CamSpec& spec, const MeasuredCam& measured,
                    const std::vector<std::size_t>& points) {
  const auto found = distances(spec, measured, points);
  return found ? summary(*found, points) : Deviation{};
}

std::optional<double> oscillation(const CamSpec& spec, const MeasuredCam& measured,
                                  const std::vector<std::size_t>& points) {
  constexpr double near = 2;  // tolerances
  const Cam cam = design(spec).cam;
  const auto& all = measured.points;
  const auto bend = [&](std::size_t k) {  // greatest distance of a parabola from its chord
    if (k == 0 || k + 1 >= all.size()) return 0.0;
    const double before = all[k].master - all[k - 1].master;
    const double after = all[k + 1].master - all[k].master;
    const double slopes =
        (all[k + 1].slave - all[k].slave) / after - (all[k].slave - all[k - 1].slave) / before;
    return std::abs(slopes) * std::max(before, after) / 4;
  };
  double worst = 1;
  std::optional<double> where;
  for (const std::size_t k : points) {
    if (k + 1 >= all.size()) continue;
    const double at = (all[k].master + all[k + 1].master) / 2;
    const double distance = std::abs(cam.jet(at)[0] - (all[k].slave + all[k + 1].slave) / 2);
    const double share = (distance - std::max(bend(k), bend(k + 1))) / (near * all[k].tolerance);
    if (share > worst) worst = share, where = at;
  }
  return where;
}

Deviation refine(CamSpec& spec, const std::vector<Parameter>& parameters,
                 const MeasuredCam& measured, const std::vector<std::size_t>& points) {
  auto now = distances(spec, measured, points);
  if (!now) return {};
  if (parameters.empty() || points.empty()) return summary(*now, points);
  constexpr double least_decrease = 1e-9;  // share of the sum of squares: ends the search
  constexpr int most_steps = 60;
  constexpr double most_damping = 1e8;
  constexpr double no_effect = 1e-30;  // keeps the system regular if a parameter has no effect
  double damping = 1e-3;
  for (int i = 0; i < most_steps; ++i) {
    const MatrixXd j = slopes(spec, parameters, measured, points, *now);
    const MatrixXd square = j.transpose() * j;
    const VectorXd gradient = j.transpose() * *now;
    const double before = now->squaredNorm();
    bool better = false;
    for (; !better && damping < most_damping; damping *= better ? 0.1 : 4) {
      MatrixXd damped = square;
      damped.diagonal() += damping * square.diagonal();
      damped.diagonal().array() += no_effect;
      const VectorXd step = damped.ldlt().solve(-gradient);
      CamSpec trial = spec;
      for (std::size_t k = 0; k < parameters.size(); ++k)
        change(trial, parameters[k], step[static_cast<Eigen::Index>(k)] * parameters[k].scale);
      auto then = distances(trial, measured, points);
      better = then && then->squaredNorm() < before;
      if (!better) continue;
      spec = std::move(trial);
      now = std::move(then);
    }
    if (!better || before - now->squaredNorm() <= least_decrease * before) break;
  }
  return summary(*now, points);
}

}  // namespace jounce::cam_detail
