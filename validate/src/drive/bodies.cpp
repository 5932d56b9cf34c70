// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/bodies.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace jounce::validate_detail {
namespace {

void rub(Body& body, Friction f) {
  body.viscous += f.viscous;
  f.breakaway = std::max(f.breakaway, f.coulomb);
  if (f.breakaway > 0) body.dry.push_back(f);
}

void join(Body& body, const Mass& m) {
  body.inertia += m.inertia;
  body.load += m.load_torque;
  if (m.gravity_torque != 0)
    body.gravity.push_back({m.gravity_torque, m.gravity_angle, m.gravity_ratio});
  rub(body, m.friction);
}

/// For small angles a pendulum acts on its pivot like a spring with the same frequency: with l th'' + x'' = -g
/// th and u = x + l th its force is J_p g th / l = J_p (2 pi f)^2 (u - x).
Body hung(const Pendulum& p, double inertia) {
  const double w = 2 * std::numbers::pi * p.frequency;
  Body body;
  body.inertia = inertia;
  body.stiffness = inertia * w * w;
  body.damping = 2 * p.damping * w * inertia;
  return body;
}

template <class Part>
double sum(const std::vector<Body>& train, Part part) {
  return std::transform_reduce(train.begin(), train.end(), 0.0, std::plus<>{}, part);
}

}  // namespace

std::vector<Body> bodies(const Drive& drive) {
  std::vector<Body> train(1);
  train[0].inertia = drive.motor.inertia;
  rub(train[0], drive.motor.friction);
  for (const Mass& mass : drive.train) {
    if (mass.stiffness > 0) {
      Body& body = train.emplace_back();
      body.stiffness = mass.stiffness;
      body.damping = mass.damping;
      body.half_gap = mass.backlash / 2;
      body.efficiency = mass.efficiency;
    }
    join(train.back(), mass);
  }
  if (drive.pendulum) {
    const double swinging = drive.pendulum->share * drive.train.back().inertia;
    train.back().inertia -= swinging;
    train.push_back(hung(*drive.pendulum, swinging));
  }
  return train;
}

double coulomb(const std::vector<Body>& train) {
  return sum(train, [](const Body& b) {
    return std::transform_reduce(b.dry.begin(), b.dry.end(), 0.0, std::plus<>{},
                                 [](const Friction& f) { return f.coulomb; });
  });
}

double viscous(const std::vector<Body>& train) {
  return sum(train, [](const Body& b) { return b.viscous; });
}

double inertia(const std::vector<Body>& train) {
  return sum(train, [](const Body& b) { return b.inertia; });
}

}  // namespace jounce::validate_detail
