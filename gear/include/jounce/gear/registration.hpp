// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Registration: a mark on the material is measured once a product, and the slave is moved by the
/// error while it is not in step: after the cut, before the next sync zone.
///
///     Registration mark{.window_from = 525, .window_length = 400, .most = 2};   // m, m, c
///     Registered now = corrected(mark, state, measured_error);   // one product; pure
///     state = now.state;                                         // what is left is carried on
///     Cam all = registered(cam, mark, errors);                   // errors.size() products
///
/// **Vocabulary.** The correction c(x) is superposed: constant outside the window, so that it
/// disturbs no sync zone, and a law from rest to rest inside. Its unit is the slave's if it is
/// added to the slave, the master's if it is added to the master (a phase). An error is the
/// required move: a positive one moves the slave (the master's phase) further.
///
/// The part of an error beyond `most` is carried to the next product. The sum of the applied and
/// the outstanding correction is the sum of the errors: nothing creeps.
///
/// **Throws** InputError if the window is not in the period or not finite, `most` is not positive,
/// the law does not go from rest to rest, an error is not finite, or the cam does not repeat.
struct Registration {
  double window_from = 0;    ///< m from the cam's start, >= 0
  double window_length = 0;  ///< m > 0
  double most = 0;           ///< u or m > 0: of a correction in one product, either way
  Law law = Law::poly345;
  LawForm form = {};
};

/// State of a registration from product to product.
struct RegistrationState {
  double applied = 0;      ///< the correction that holds now
  double outstanding = 0;  ///< measured, not yet applied
};

/// One product: from state.applied the correction goes by `step` within the window.
struct Registered {
  double step = 0;
  RegistrationState state = {};  ///< afterwards
};

/// The step of the next product, and the state after it.
Registered corrected(const Registration& registration, const RegistrationState& state,
                     double error);

/// The correction over one product of `period`, as segments: constant, the law, constant. A step of
/// 0 makes one segment.
std::vector<Segment> correction(const Registration& registration, double period, double from,
                                double step);

/// The slave over one product per error: cam(x) + c(x), exactly, beginning in `state`. Errors of 0
/// leave the cam's segments unchanged to the bit. For rotating slaves (a sealing roll, a knife, an
/// indexer). The result rejects positions outside.
Cam registered(const Cam& cam, const Registration& registration, std::span<const double> errors,
               RegistrationState state = {});

/// The same with the correction added to the master: cam(x + c(x)), for slaves that come home: a
/// flying shear begins its next run earlier (c > 0) or later. In step the ratio is untouched: the
/// window is one of the phase x + c(x), of which each product is a period, so that it stays between
/// the cut and the next sync zone for every applied correction. A product then takes less of the
/// master, by its step: the result begins at the cam's start - state.applied, and covers n periods
/// less all steps. `most` must be less than the length of the window. A quintic behind a quintic
/// fits no segment: the result is within `tolerance` (u), with a certified error; it is exact if
/// the cam is a line or stands still.
Fitted<OverMaster> registered_phase(const Cam& cam, const Registration& registration,
                                    std::span<const double> errors, double tolerance,
                                    RegistrationState state = {});

/// For corrections that are added to the slave (registered()): the largest `most` (<=
/// registration.most) with which no single step, in either direction, breaks the slave's limits
/// over time at a constant line speed. 0 if the cam alone breaks them. Exact extrema, bisected to
/// 1e-9 of `most`. It does not apply to a correction of the phase: apply check() to the result of
/// registered_phase().
double greatest_correction(const Cam& cam, const Registration& registration, const Limits& slave,
                           double line_speed);

}  // namespace jounce
