// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "io/src/drawing/strokes.hpp"

namespace jounce::io_detail {

/// A linear map of the plane, with a translation: the attribute `transform` of SVG.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  [[nodiscard]] PlanePoint operator()(PlanePoint p) const {
    return {a * p.real() + c * p.imag() + e, b * p.real() + d * p.imag() + f};
  }
  /// The map that applies `inner` first.
  [[nodiscard]] Affine operator*(const Affine& inner) const;
};

/// Reads numbers and words of an SVG attribute, separated by white space and commas.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  [[nodiscard]] bool is_at_end();
  /// True if a number follows.
  [[nodiscard]] bool is_number();
  /// A number; throws InputError without a place if none follows.
  double number();
  /// A flag of an arc: 0 or 1, which may stand without a separator.
  bool flag();
  PlanePoint point();
  /// The next character, which is not a number.
  char letter();
  /// Letters before a parenthesis, and the numbers inside it.
  std::string_view function(std::vector<double>& arguments);

 private:
  void skip();

  std::string_view text_;
};

/// Reads the attribute `transform`.
Affine read_transform(std::string_view text);
/// Adds the curves of the attribute `d` of a path. Throws InputError without a place.
void add_path(std::vector<Stroke>& strokes, std::string_view d, const Affine& map);
/// Adds an ellipse.
void add_svg_ellipse(std::vector<Stroke>& strokes, PlanePoint center, double rx, double ry,
                     const Affine& map);

}  // namespace jounce::io_detail
