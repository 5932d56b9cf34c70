// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::bench {

/// The yardstick of drive_through(): CVODES as one would call it for this one axis and no other. Two
/// masses, a P-PI controller with feed-forward, the integral of the squared torque; BDF, dense Newton
/// with its Jacobian, restarts at steps of the reference's acceleration. No limits, no peaks, no events,
/// nothing watched. References of degree 3 at most.
class ByHand {
 public:
  ByHand(const Trajectory& move, const Drive& drive, double end)
      : move_(move),
        d_(drive),
        c_(drive.controller),
        load_(drive.train[0]),
        rad_(2 * std::numbers::pi / drive.position_per_rev),
        total_(d_.motor.inertia + load_.inertia),
        end_(end) {}

  /// The load's distance from the reference's end after the standstill, u; `steps` of the solver.
  double run(double relative, long& steps) {
    y_ = N_VNew_Serial(size, context_);
    N_VConst(0, y_);
    N_Vector absolute = N_VClone(y_);
    tolerances(relative, NV_DATA_S(absolute));
    SUNMatrix matrix = SUNDenseMatrix(size, size, context_);
    SUNLinearSolver linear = SUNLinSol_Dense(y_, matrix, context_);
    void* cvode = CVodeCreate(CV_BDF, context_);
    CVodeInit(cvode, &ByHand::rhs, 0, y_);
    CVodeSetUserData(cvode, this);
    CVodeSVtolerances(cvode, relative, absolute);
    CVodeSetLinearSolver(cvode, linear, matrix);
    CVodeSetJacFn(cvode, &ByHand::jacobian);
    CVodeSetMaxNumSteps(cvode, 1'000'000);
    steps = integrate(cvode);
    const double residual = NV_Ith_S(y_, 2) / rad_;
    CVodeFree(&cvode);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(absolute);
    N_VDestroy(y_);
    return residual;
  }

 private:
  static constexpr sunindextype size = 6;  // x_0, x_0', x_1, x_1' of the reference, z, T^2

  /// Those of drive_run.cpp, so that both runs are of one accuracy.
  void tolerances(double relative, double* to) const {
    double speed = 0, acceleration = 0;
    for (const double t : move_.breaks()) {
      speed = std::max(speed, rad_ * std::abs(move_.jet(t)[1]));
      acceleration = std::max(acceleration, rad_ * std::abs(move_.jet(t)[2]));
    }
    const double stroke = rad_ * std::abs(move_.jet(move_.end(), Side::left)[0]);
    const double torque = total_ * acceleration;
    to[0] = to[2] = 3e-4 * relative * stroke;
    to[1] = to[3] = 5e-4 * relative * speed;
    to[4] = 3e-4 * relative * torque;
    to[5] = 0.1 * relative * torque * torque;
  }

  long integrate(void* cvode) {
    long all = 0;
    double t = 0, before = 0;
    const auto follow = [&](double stop, bool anew) {
      if (anew) {
        if (t > 0) {
          CVodeGetNumSteps(cvode, &before_);
          all += before_;
          CVodeReInit(cvode, t, y_);
        }
      }
      CVodeSetStopTime(cvode, stop);
      CVode(cvode, stop, y_, &t, CV_NORMAL);
    };
    begin_ = 0;
    for (const Segment& s : move_.segments()) {
      segment_ = &s;
      const double a = at(begin_).a;
      follow(begin_ + s.length, std::abs(a - before) > 1e-4 * 40'000 * rad_);
      before = at(begin_ + s.length).a;
      begin_ += s.length;
    }
    segment_ = nullptr;
    follow(end_, true);
    CVodeGetNumSteps(cvode, &before_);
    return all + before_;
  }

  struct Reference {
    double w, a;
  };
  [[nodiscard]] Reference at(double t) const {
    if (segment_ == nullptr) return {0, 0};
    const double h = segment_->length, s = (t - begin_) / h;
    const auto& c = segment_->c;
    return {rad_ * (c[1] + s * (2 * c[2] + s * 3 * c[3])) / h,
            rad_ * (2 * c[2] + s * 6 * c[3]) / (h * h)};
  }

  static int rhs(double t, N_Vector y, N_Vector dy, void* self) {
    const auto& d = *static_cast<ByHand*>(self);
    const double *x = NV_DATA_S(y), k = d.c_.velocity_gain;
    double* to = NV_DATA_S(dy);
    const Reference r = d.at(t);
    const double e = k * (-d.c_.position_gain * x[0] - x[1]);
    const double torque = e + x[4] + d.total_ * r.a;
    const double shaft = d.load_.stiffness * (x[0] - x[2]) + d.load_.damping * (x[1] - x[3]);
    to[0] = x[1];
    to[1] =
        (torque - shaft - d.d_.motor.friction.viscous * (x[1] + r.w)) / d.d_.motor.inertia - r.a;
    to[2] = x[3];
    to[3] = (shaft - d.load_.friction.viscous * (x[3] + r.w)) / d.load_.inertia - r.a;
    to[4] = e / d.c_.integral_time;
    to[5] = torque * torque;
    return 0;
  }

  static int jacobian(double t, N_Vector y, N_Vector, SUNMatrix m, void* self, N_Vector, N_Vector,
                      N_Vector) {
    const auto& d = *static_cast<ByHand*>(self);
    const double k = d.c_.velocity_gain, p = d.c_.position_gain;
    const double motor = d.d_.motor.inertia, load = d.load_.inertia;
    const double spring = d.load_.stiffness, damper = d.load_.damping;
    const double* x = NV_DATA_S(y);
    const double torque = k * (-p * x[0] - x[1]) + x[4] + d.total_ * d.at(t).a;
    SM_ELEMENT_D(m, 0, 1) = SM_ELEMENT_D(m, 2, 3) = 1;
    SM_ELEMENT_D(m, 1, 0) = (-k * p - spring) / motor;
    SM_ELEMENT_D(m, 1, 1) = (-k - damper - d.d_.motor.friction.viscous) / motor;
    SM_ELEMENT_D(m, 1, 2) = spring / motor;
    SM_ELEMENT_D(m, 1, 3) = damper / motor;
    SM_ELEMENT_D(m, 1, 4) = 1 / motor;
    SM_ELEMENT_D(m, 3, 0) = spring / load;
    SM_ELEMENT_D(m, 3, 1) = damper / load;
    SM_ELEMENT_D(m, 3, 2) = -spring / load;
    SM_ELEMENT_D(m, 3, 3) = -(damper + d.load_.friction.viscous) / load;
    SM_ELEMENT_D(m, 4, 0) = -k * p / d.c_.integral_time;
    SM_ELEMENT_D(m, 4, 1) = -k / d.c_.integral_time;
    SM_ELEMENT_D(m, 5, 0) = -2 * torque * k * p;
    SM_ELEMENT_D(m, 5, 1) = -2 * torque * k;
    SM_ELEMENT_D(m, 5, 4) = 2 * torque;
    return 0;
  }

  const Trajectory& move_;
  const Drive& d_;
  const Controller& c_;
  const Mass& load_;
  double rad_, total_, end_;
  sundials::Context context_;
  N_Vector y_ = nullptr;
  const Segment* segment_ = nullptr;
  double begin_ = 0;
  long before_ = 0;
};

}  // namespace jounce::bench
