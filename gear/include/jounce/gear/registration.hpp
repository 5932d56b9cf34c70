// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Registration: a mark on the material is measured once for each product, and a correction moves
/// the slave by the measured error. The correction takes place in a window between the cut and the
/// next sync zone, where the slave is not in step.
///
///     Registration mark{.window_from = 525, .window_length = 400, .most = 2};   // m, m, c
///     Registered now = corrected(mark, state, measured_error);   // one product; a pure function
///     state = now.state;                                       // includes what is not yet applied
///     Cam all = registered(cam, mark, errors);                   // one product for each error
///
/// **Vocabulary.** The correction c(x) is added to the slave, or to the master (a *phase*), and has
/// the same unit. Outside the window it is constant, so it disturbs no sync zone; inside the window
/// it follows a law from rest to rest. An *error* is the required move: a positive error moves the
/// slave (or the phase of the master) forwards. m is the master's unit, c the unit of the
/// correction.
///
/// If an error exceeds `most`, the rest of it is applied to the next products. The applied and the
/// outstanding correction together are the sum of all errors, so nothing drifts.
///
/// **Throws** InputError if the window is not inside the period or not finite, `most` is not
/// positive, the law does not go from rest to rest, an error is not finite, there is no error, or
/// the cam does not repeat (wrap or advance).
struct Registration {
  double window_from = 0;    ///< m, >= 0: start of the window, from the cam's start
  double window_length = 0;  ///< m, > 0
  double most = 0;           ///< c, > 0: greatest correction in one product, in either direction
  Law law = Law::poly345;    ///< law of the correction: from rest to rest
  LawForm form = {};         ///< shape parameters of the law
};

/// State of a registration after a product.
struct RegistrationState {
  double applied = 0;      ///< c: the present correction
  double outstanding = 0;  ///< c: measured, but not yet applied
};

/// The correction of one product: inside the window, it changes from state.applied by `step`.
struct Registered {
  double step = 0;               ///< c: change of the correction
  RegistrationState state = {};  ///< after the product
};

/// Returns the correction of the next product, and the state after it. A pure function.
Registered corrected(const Registration& registration, const RegistrationState& state,
                     double error);

/// Returns the correction over one product of length `period` (m), as segments: constant at `from`,
/// the law, constant at `from + step`. A step of 0 gives a single segment.
std::vector<Segment> correction(const Registration& registration, double period, double from,
                                double step);

/// Returns the slave over several products, one for each error: cam(x) + c(x), exact, beginning in
/// `state`. While all errors are 0, the segments of the cam stay unchanged to the bit. For slaves
/// that rotate (a sealing roll, a knife, an indexer). The result refuses positions outside.
Cam registered(const Cam& cam, const Registration& registration, std::span<const double> errors,
               RegistrationState state = {});

/// Like registered(), but adds the correction to the master: cam(x + c(x)). For slaves that return,
/// such as a flying shear: the shear begins its next motion earlier (c > 0) or later, and its ratio
/// in the sync zone does not change.
///
/// The window is an interval of the phase x + c(x), whose periods are the products. So the window
/// stays between the cut and the next sync zone for every correction. A product takes less travel
/// of the master, by the step of its correction: the result begins at the cam's start -
/// state.applied and covers n periods minus all steps. `most` must be less than the length of the
/// window.
///
/// The composition of two quintics does not fit a segment. So the result is within `tolerance` (u),
/// with a certified error; it is exact where the cam is a line or stands still.
Fitted<OverMaster> registered_phase(const Cam& cam, const Registration& registration,
                                    std::span<const double> errors, double tolerance,
                                    RegistrationState state = {});

/// Returns the largest `most` (at most registration.most) for which no single step, in either
/// direction, breaks the slave's limits over time at a constant line speed (m/s); 0 if the cam
/// alone breaks them. The result is for corrections that are added to the slave (registered()).
/// Exact extrema; bisected to 1e-9 of `most`. For a correction of the phase, use check() on the
/// result of registered_phase().
double greatest_correction(const Cam& cam, const Registration& registration, const Limits& slave,
                           double line_speed);

}  // namespace jounce
