// SPDX-License-Identifier: Apache-2.0
// Paths and transforms of SVG 1.1 (W3C), chapters 7.6, 8.3 and F.6.
#include "io/src/drawing/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::io_detail {
namespace {

[[noreturn]] void fail_near(std::string_view text, const std::string& rule) {
  throw InputError("d", printable(std::string(text.substr(0, 20))), rule);
}

bool is_svg_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

/// Reads the commands of a path.
class PathReader {
 public:
  PathReader(std::vector<Stroke>& strokes, std::string_view d, const Affine& map)
      : strokes_(strokes), scan_(d), map_(map) {}

  void read() {
    char command = 0;
    while (!scan_.is_at_end()) {
      if (!scan_.is_number())
        command = scan_.letter();
      else if (command == 0 || command == 'z' || command == 'Z')
        fail_near("", "must begin with a command, such as M");
      else if (command == 'M' || command == 'm')
        command = command == 'M' ? 'L' : 'l';  // further points of a move are lines
      run(command);
      previous_ = command;
    }
  }

 private:
  void run(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const PlanePoint base = relative ? at_ : PlanePoint();
    const auto next = [&] { return base + scan_.point(); };
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'M':
        at_ = start_ = next();
        break;
      case 'Z':
        line(start_);
        break;
      case 'L':
        line(next());
        break;
      case 'H':
        line({scan_.number() + base.real(), at_.imag()});
        break;
      case 'V':
        line({at_.real(), scan_.number() + base.imag()});
        break;
      case 'C': {
        const PlanePoint first = next(), second = next();
        cubic(first, second, next());
        break;
      }
      case 'S': {
        const PlanePoint first = follows("CcSs") ? 2.0 * at_ - control_ : at_;
        const PlanePoint second = next();
        cubic(first, second, next());
        break;
      }
      case 'Q': {
        const PlanePoint control = next();
        quadratic(control, next());
        break;
      }
      case 'T':
        quadratic(follows("QqTt") ? 2.0 * at_ - control_ : at_, next());
        break;
      case 'A': {
        const double rx = scan_.number(), ry = scan_.number(), angle = scan_.number();
        const bool large = scan_.flag(), sweep = scan_.flag();
        arc(std::abs(rx), std::abs(ry), angle * std::numbers::pi / 180, large, sweep, next());
        break;
      }
      default:
        fail_near(std::string(1, command), "is not a command of a path");
    }
  }

  [[nodiscard]] bool follows(std::string_view commands) const {
    return previous_ != 0 && commands.find(previous_) != commands.npos;
  }

  void line(PlanePoint to) {
    if (to != at_) strokes_.push_back({map_(at_), map_(to)});
    at_ = to;
  }

  void cubic(PlanePoint first, PlanePoint second, PlanePoint to) {
    const PlanePoint from = at_;
    add_curve(
        strokes_,
        [&](double t) {
          const double s = 1 - t;
          return map_(s * s * s * from + 3 * s * s * t * first + 3 * s * t * t * second +
                      t * t * t * to);
        },
        0, 1);
    control_ = second;
    at_ = to;
  }

  void quadratic(PlanePoint control, PlanePoint to) {
    const PlanePoint from = at_;
    add_curve(
        strokes_,
        [&](double t) {
          const double s = 1 - t;
          return map_(s * s * from + 2 * s * t * control + t * t * to);
        },
        0, 1);
    control_ = control;
    at_ = to;
  }

  /// From the two ends to the center of the ellipse (SVG 1.1, F.6.5 and F.6.6).
  void arc(double rx, double ry, double angle, bool large, bool sweep, PlanePoint to) {
    const PlanePoint from = at_;
    if (from == to) return;
    if (rx == 0 || ry == 0) return line(to);
    const PlanePoint turn = std::polar(1.0, angle);
    const PlanePoint half = (from - to) / 2.0 * std::conj(turn);
    const PlanePoint unit(half.real() / rx, half.imag() / ry);
    const double size = std::abs(unit);
    if (size > 1) rx *= size, ry *= size;
    const double u = std::min(size, 1.0);
    const double height = std::sqrt(std::max(0.0, 1 - u * u)) * (large == sweep ? -1 : 1);
    const PlanePoint direction = unit / size;
    const PlanePoint middle = height * PlanePoint(direction.imag(), -direction.real());
    const PlanePoint first = u * direction - middle, last = -u * direction - middle;
    const double begin = std::arg(first);
    double travel = std::arg(last / first);
    if (sweep && travel <= 0) travel += 2 * std::numbers::pi;
    if (!sweep && travel >= 0) travel -= 2 * std::numbers::pi;
    const PlanePoint center =
        (from + to) / 2.0 + PlanePoint(middle.real() * rx, middle.imag() * ry) * turn;
    add_curve(
        strokes_,
        [&](double t) {
          return map_(center + PlanePoint(rx * std::cos(t), ry * std::sin(t)) * turn);
        },
        begin, begin + travel);
    at_ = to;
  }

  std::vector<Stroke>& strokes_;
  SvgScanner scan_;
  const Affine& map_;
  PlanePoint at_ = {}, start_ = {};
  PlanePoint control_ = {};  ///< last control point of the curve before
  char previous_ = 0;        ///< command before
};

/// One function of a transform.
Affine transform_of(std::string_view name, const std::vector<double>& v) {
  const auto value = [&](std::size_t i, double otherwise) {
    return i < v.size() ? v[i] : otherwise;
  };
  constexpr double degree = std::numbers::pi / 180;
  if (name == "matrix" && v.size() == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && !v.empty()) return {1, 0, 0, 1, v[0], value(1, 0)};
  if (name == "scale" && !v.empty()) return {v[0], 0, 0, value(1, v[0]), 0, 0};
  if (name == "skewX" && v.size() == 1) return {1, 0, std::tan(v[0] * degree), 1, 0, 0};
  if (name == "skewY" && v.size() == 1) return {1, std::tan(v[0] * degree), 0, 1, 0, 0};
  if (name == "rotate" && (v.size() == 1 || v.size() == 3)) {
    const double c = std::cos(v[0] * degree), s = std::sin(v[0] * degree);
    const Affine turn{c, s, -s, c, 0, 0};
    const double x = value(1, 0), y = value(2, 0);
    return Affine{1, 0, 0, 1, x, y} * turn * Affine{1, 0, 0, 1, -x, -y};
  }
  throw InputError("transform", printable(std::string(name)),
                   "must be matrix, translate, scale, rotate, skewX or skewY, with its numbers");
}

}  // namespace

Affine Affine::operator*(const Affine& inner) const {
  const PlanePoint x = (*this)({inner.a, inner.b}), y = (*this)({inner.c, inner.d}),
                   o = (*this)({0, 0});
  const PlanePoint at = (*this)({inner.e, inner.f});
  return {(x - o).real(), (x - o).imag(), (y - o).real(), (y - o).imag(), at.real(), at.imag()};
}

void SvgScanner::skip() {
  while (!text_.empty() && (is_svg_space(text_.front()) || text_.front() == ','))
    text_.remove_prefix(1);
}

bool SvgScanner::is_at_end() {
  skip();
  return text_.empty();
}

bool SvgScanner::is_number() {
  skip();
  if (text_.empty()) return false;
  const char c = text_.front();
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
}

double SvgScanner::number() {
  skip();
  const std::size_t sign = text_.starts_with('+') ? 1 : 0;
  double value = 0;
  const auto [end, error] =
      std::from_chars(text_.data() + sign, text_.data() + text_.size(), value);
  if (error != std::errc() || !std::isfinite(value)) fail_near(text_, "must be a number");
  text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
  return value;
}

bool SvgScanner::flag() {
  skip();
  if (text_.empty() || (text_.front() != '0' && text_.front() != '1'))
    fail_near(text_, "must be 0 or 1, a flag of an arc");
  const bool set = text_.front() == '1';
  text_.remove_prefix(1);
  return set;
}

PlanePoint SvgScanner::point() {
  const double x = number();
  return {x, number()};
}

char SvgScanner::letter() {
  const char c = text_.front();
  text_.remove_prefix(1);
  return c;
}

std::string_view SvgScanner::function(std::vector<double>& arguments) {
  const auto open = text_.find('(');
  std::string_view name = text_.substr(0, open);
  while (!name.empty() && is_svg_space(name.back())) name.remove_suffix(1);
  text_.remove_prefix(open == text_.npos ? text_.size() : open + 1);
  while (is_number()) arguments.push_back(number());
  if (!text_.starts_with(')'))
    throw InputError("transform", printable(std::string(name)), "is not complete");
  text_.remove_prefix(1);
  return name;
}

Affine read_transform(std::string_view text) {
  Affine map;
  SvgScanner scan(text);
  while (!scan.is_at_end()) {
    std::vector<double> arguments;
    const std::string_view name = scan.function(arguments);
    map = map * transform_of(name, arguments);
  }
  return map;
}

void add_path(std::vector<Stroke>& strokes, std::string_view d, const Affine& map) {
  PathReader(strokes, d, map).read();
}

void add_svg_ellipse(std::vector<Stroke>& strokes, PlanePoint center, double rx, double ry,
                     const Affine& map) {
  if (!(rx > 0 && ry > 0)) return;  // SVG does not draw it
  add_curve(
      strokes,
      [&](double t) { return map(center + PlanePoint(rx * std::cos(t), ry * std::sin(t))); }, 0,
      2 * std::numbers::pi);
}

}  // namespace jounce::io_detail
