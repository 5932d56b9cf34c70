// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <span>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/curve/signal.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

namespace validate_detail {

/// Returns the motion of a slave over time, for a master that moves at constant velocities; nullopt
/// for any other master.
std::optional<Trajectory> steady(const Followed& slave);

}  // namespace validate_detail

/// A view of any signal through one type, so that the integrators are compiled only once. A signal
/// converts to a view implicitly. The view refers to the signal, which must outlive the view.
class SignalView {
 public:
  template <class S>
  requires(!std::same_as<S, SignalView> && Signal<S>)
      SignalView(const S& signal)  // NOLINT(google-explicit-constructor): a view, as std::span is
      : start_(signal.start()),
        end_(signal.end()),
        breaks_(signal.breaks()),
        over_master_(runs_over_master(signal)),
        signal_(&signal),
        jet_([](const void* s, double x, Side side) {
          return static_cast<const S*>(s)->jet(x, side);
        }),
        trajectory_([](const void* s) { return trajectory_of(*static_cast<const S*>(s)); }) {}

  /// Start of the signal: time, s, or master position.
  [[nodiscard]] double start() const { return start_; }
  /// End of the signal.
  [[nodiscard]] double end() const { return end_; }
  /// Breaks of the signal, ascending.
  [[nodiscard]] std::span<const double> breaks() const { return breaks_; }
  /// Returns the value and derivatives at x.
  [[nodiscard]] Jet jet(double x, Side side = Side::right) const { return jet_(signal_, x, side); }

  /// Returns the signal as exact segments, for a Trajectory, a Table over time, and a Followed
  /// whose master moves at constant velocities; nullopt for any other signal.
  [[nodiscard]] std::optional<Trajectory> trajectory() const { return trajectory_(signal_); }

  /// True if the signal is over a master position (a Cam, or a Table over a master), not over time.
  [[nodiscard]] bool over_master() const { return over_master_; }

 private:
  template <Signal S>
  static bool runs_over_master(const S& signal) {
    if constexpr (requires {
                    { signal.axis() } -> std::same_as<Domain>;
                  }) {
      return signal.axis() == Domain::master;
    } else {
      return requires {
        { signal.at(0.0) } -> std::same_as<Transfer>;
      };
    }
  }

  template <Signal S>
  static std::optional<Trajectory> trajectory_of(const S& signal) {
    if constexpr (std::same_as<S, Trajectory>) {
      return signal;
    } else if constexpr (std::same_as<S, Table>) {
      if (signal.axis() == Domain::time) return signal.template curve<OverTime>();
    } else if constexpr (std::same_as<S, Followed>) {
      return validate_detail::steady(signal);
    }
    return std::nullopt;
  }

  double start_;
  double end_;
  std::span<const double> breaks_;
  bool over_master_;
  const void* signal_;
  Jet (*jet_)(const void*, double, Side);
  std::optional<Trajectory> (*trajectory_)(const void*);
};

}  // namespace jounce
