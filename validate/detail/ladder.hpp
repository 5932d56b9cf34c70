#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "jounce/profiles/segment.hpp"
#include "jounce/validate/detail/linear_system.hpp"

namespace jounce::detail {

/// A linear system together with all references of one kind: polynomials up to a degree, and sines
/// of given angular frequencies. Such a reference is itself the output of an autonomous linear
/// system, so that both together are z' = M z, and every response is an exponential. The derivation
/// stands at the head of ladder.cpp.
///
/// The ladder holds exp(M h 2^j), each rung the square of the one below. Any length of time is a
/// whole number of h, whose binary digits say which rungs, and a rest that a short series takes.
class Ladder {
 public:
  /// `step` > 0: a length that will be asked for often, made to be one rung.
  Ladder(const LinearSystem& system, int degree, std::vector<double> frequencies, double step);

  /// Whether the segment is of this kind: its degree and its sines' frequencies.
  [[nodiscard]] bool takes(const Segment& f) const;

  [[nodiscard]] Eigen::Index states() const { return states_; }
  [[nodiscard]] Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(m_.rows()); }

  /// Puts the segment's reference at u (0 to its length) into the lower part of z.
  void place(const Segment& f, double u, Eigen::VectorXd& z) const;

  /// The system's part of z after a time; the reference's part must be placed anew. Returns the time
  /// really gone, which differs from what was asked by rounding at most.
  double advance(Eigen::VectorXd& z, double time);

  /// The same, and the integral of (row `output` of y)^2 over that time added to `sum`. The output
  /// must be the same in every call.
  double advance(Eigen::VectorXd& z, double time, Eigen::Index output, double& sum);

  [[nodiscard]] const Eigen::MatrixXd& outputs() const { return outputs_; }  ///< y = outputs() z
  /// The same, into as many numbers as there are outputs.
  void read(const Eigen::VectorXd& z, double* y) const;

 private:
  [[nodiscard]] const Eigen::MatrixXd& rung(std::size_t j);
  [[nodiscard]] const Eigen::MatrixXd& square(std::size_t j, Eigen::Index output);
  void rest(Eigen::VectorXd& z, double time) const;
  [[nodiscard]] double rest_square(const Eigen::VectorXd& z, double time,
                                   Eigen::Index output) const;

  Eigen::Index states_;
  int degree_;
  std::vector<double> frequencies_;
  double h_;
  Eigen::MatrixXd m_;
  Eigen::MatrixXd outputs_;
  std::vector<Eigen::MatrixXd> rungs_;
  std::vector<Eigen::MatrixXd> squares_;
  mutable Eigen::VectorXd term_;
  mutable Eigen::VectorXd next_;
};

}  // namespace jounce::detail
