// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "jounce/profiles/curve/segment.hpp"

#include "validate/src/linear/linear_system.hpp"

namespace jounce::validate_detail {

/// The integral of the product of the outputs a and b.
struct ProductIntegral {
  Eigen::Index a = 0;
  Eigen::Index b = 0;
  double sum = 0;
};

/// A linear system together with all references of one kind: polynomials up to a degree, and sines
/// of given angular frequencies. Such a reference is itself the output of an autonomous linear
/// system. Both together are z' = M z, and every response is an exponential. The derivation is at
/// the head of ladder.cpp.
///
/// The ladder contains exp(M h 2^j) for j = 0, 1, ...; each is the square of the one before. Any
/// time is a whole number of h, whose binary digits select these matrices, and a rest, for which a
/// short series is used.
class Ladder {
 public:
  /// `step` > 0: a frequent length, which becomes a rung.
  Ladder(const LinearSystem& system, int degree, std::vector<double> frequencies, double step);

  /// True if the segment is of this kind: its degree, and the frequencies of its sines.
  [[nodiscard]] bool takes(const Segment& f) const;

  /// Number of states of the system.
  [[nodiscard]] Eigen::Index states() const { return states_; }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(m_.rows()); }

  /// M.
  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return m_; }
  /// h: the norm of the system's part of M h is at most 1/2.
  [[nodiscard]] double shortest() const { return h_; }
  /// Returns exp(M h 2^j).
  [[nodiscard]] const Eigen::MatrixXd& rung(std::size_t j);
  /// Returns W of (7) for outputs a and b over h 2^j.
  [[nodiscard]] const Eigen::MatrixXd& integral(std::size_t j, Eigen::Index a, Eigen::Index b);
  /// Returns exp(|M| h). Entry by entry, it is at least |exp(M u)| for any u in [0, h].
  [[nodiscard]] Eigen::MatrixXd greatest() const;
  /// Returns output `row` over a time of at most shortest() from z on, as a polynomial.
  [[nodiscard]] Segment polynomial(const Eigen::VectorXd& z, Eigen::Index row, double time);

  /// Writes the reference of the segment at u (0 to its length) into the lower part of z.
  void place(const Segment& f, double u, Eigen::VectorXd& z) const;

  /// Advances the system's part of z by a time. The caller must set the reference's part again.
  /// Returns the exact time of the step, which differs from the given one by rounding at most. Adds
  /// the integrals of products of outputs over that time, at most two, to their sums.
  double advance(Eigen::VectorXd& z, double time, std::span<ProductIntegral> products = {});

  [[nodiscard]] const Eigen::MatrixXd& outputs() const { return outputs_; }  ///< y = outputs() z
  /// Writes the outputs at z to y, one number for each.
  void read(const Eigen::VectorXd& z, double* y) const;

  /// Greatest number of instants for read_ahead().
  static constexpr int block = 32;
  /// Writes the outputs at z and at the next instants, `step` apart, to y; `count` instants in all,
  /// 1 to block. All outputs of one instant follow the outputs of the previous instant.
  void read_ahead(const Eigen::VectorXd& z, int count, double* y);

 private:
  [[nodiscard]] const Eigen::MatrixXd& ahead();
  [[nodiscard]] Eigen::MatrixXd series(Eigen::Index output) const;
  void derivative(const Eigen::VectorXd& z, Eigen::VectorXd& by_time) const;
  void rest(Eigen::VectorXd& z, double time, std::span<ProductIntegral> products);

  Eigen::Index states_;
  int degree_;
  std::vector<double> frequencies_;
  double h_;
  double step_;
  std::size_t step_rung_ = 0;  // step_ = h_ 2^step_rung_
  Eigen::MatrixXd m_;
  Eigen::MatrixXd outputs_;
  Eigen::MatrixXd ahead_;
  std::vector<Eigen::MatrixXd> rungs_;
  std::map<std::pair<Eigen::Index, Eigen::Index>, std::vector<Eigen::MatrixXd>> integrals_;
  Eigen::VectorXd term_;
  Eigen::VectorXd next_;
};

}  // namespace jounce::validate_detail
