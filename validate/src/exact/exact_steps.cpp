// SPDX-License-Identifier: Apache-2.0
#include "validate/src/exact/exact_steps.hpp"

#include <array>
#include <limits>

#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {
namespace {

constexpr Eigen::Index block = 256;
constexpr double none = 1e-12;  // number of a segment that does not step

}  // namespace

void ExactSteps::enter(std::size_t i, double begin) {
  segment_ = &path_->enter(i);
  rests_ = path_->rests();
  begin_ = begin;
  gone_ = 0;
  Ladder& ladder = path_->ladder();
  enclosure_ = &enclosures_.try_emplace(&ladder, ladder).first->second;
  const std::size_t level = enclosure_->level();
  static_cast<void>(ladder.rung(level));  // made now, so that pointers into it stay valid
  whole_ = {nullptr, &ladder.integral(level, torque_row, torque_row),
            &ladder.integral(level, torque_row, velocity_row)};
  whole_.step = &ladder.rung(level);
  next_.resize(path_->state().size());
}

const Steps* ExactSteps::next(double to) {
  Ladder& ladder = path_->ladder();
  const double step = enclosure_->longest();
  const double left = to - begin_ - gone_;
  if (!(left > none * step)) return nullptr;
  steps_.time.assign(1, begin_ + gone_);
  steps_.squared.clear();
  steps_.work.clear();
  const auto size = path_->state().size();
  const auto most = std::min(block, static_cast<Eigen::Index>(std::min(left / step, 1e6)) + 1);
  steps_.z.resize(size, most + 1);
  steps_.y.resize(ladder.outputs().rows(), most + 1);
  steps_.bend.resize(ladder.outputs().rows(), most);
  steps_.z.col(0) = path_->state();
  ladder.read(path_->state(), steps_.y.data());
  while (steps_.count() < most && to - begin_ - gone_ > none * step)
    add(std::min(step, to - begin_ - gone_));
  const Eigen::VectorXd sizes =
      steps_.z.leftCols(steps_.count() + 1).cwiseAbs().rowwise().maxCoeff();
  steps_.rounding =
      64 * std::numeric_limits<double>::epsilon() * (ladder.outputs().cwiseAbs() * sizes);
  return &steps_;
}

void ExactSteps::add(double length) {
  Ladder& ladder = path_->ladder();
  Eigen::VectorXd& z = path_->state();
  const Eigen::Index i = steps_.count();
  enclosure_->bend(z, steps_.bend.col(i).data());
  if (length == enclosure_->longest()) {
    steps_.squared.push_back(form(*whole_.squared, z));
    steps_.work.push_back(form(*whole_.work, z));
    multiply(*whole_.step, z.data(), ladder.states(), next_.data());
    z.head(ladder.states()) = next_.head(ladder.states());
  } else {
    std::array products{ProductIntegral{torque_row, torque_row, 0},
                        ProductIntegral{torque_row, velocity_row, 0}};
    ladder.advance(z, length, products);
    steps_.squared.push_back(products[0].sum);
    steps_.work.push_back(products[1].sum);
  }
  gone_ += length;
  ladder.place(*segment_, rests_ ? 0 : std::min(gone_, segment_->length), z);
  steps_.z.col(i + 1) = z;
  ladder.read(z, steps_.y.col(i + 1).data());
  steps_.time.push_back(begin_ + gone_);
}

}  // namespace jounce::validate_detail
