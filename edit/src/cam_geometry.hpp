// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/cam/design/design.hpp"

/// Changes of the knots of a cam, as values.
namespace jounce::edit_detail {

/// The knot with this number, from 0, the start of the cam.
const CamKnot& knot_of(const CamSpec& cam, std::size_t knot);
CamKnot& knot_of(CamSpec& cam, std::size_t knot);

/// Derivatives of a knot that a spec may give, because the laws on both sides accept them.
struct Settable {
  bool velocity = false;
  bool acceleration = false;
};
Settable settable_at(const CamSpec& cam, std::size_t knot);

/// Moves a knot. Knots that a dwell joins to it, and the other end of a period, get the same change
/// of the slave position. A speed that the knots of a line give stays the speed of the line.
CamSpec moved(CamSpec cam, std::size_t knot, double master, double slave);

/// A change of an axis of the whole cam: x becomes scale x + shift.
struct Affine {
  double scale = 1;
  double shift = 0;
};
/// Changes all slave positions, with the derivatives.
CamSpec with_slave(CamSpec cam, const Affine& change);
/// Changes all master positions, with the derivatives. Requires a scale > 0.
CamSpec with_master(CamSpec cam, const Affine& change);
/// Mirrors the slave positions in the middle between the lowest and the highest knot.
CamSpec mirrored_slave(const CamSpec& cam);
/// Reverses the cam: it begins at its end. Throws InputError for a law through points.
CamSpec mirrored_master(const CamSpec& cam);

/// The two halves of a segment: a new segment, which becomes the first half, and the changed cam,
/// whose segment `at` (index from 0) is the second half.
struct Split {
  std::size_t at = 0;
  CamSegment first;
  CamSpec cam;
};
/// Divides the segment that contains the master position, at a knot on the curve. A line, a dwell
/// and a quintic keep their shape. A law from rest to rest becomes two quintics, because its halves
/// are joined in motion. `curve`: the curve of the cam. Throws InputError for a position outside, one
/// on a knot, and for a law through points.
Split split(const CamSpec& cam, const Cam& curve, double master);

}  // namespace jounce::edit_detail
