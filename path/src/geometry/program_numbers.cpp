// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/program_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/vector.hpp"

// The list: 1 (its version), the number of axes, that of the path axes, the start; for each axis the
// number of characters of its name, these characters, velocity, acceleration and jerk; velocity,
// acceleration, deceleration, jerk, normal and total acceleration of the path; then the commands,
// each with its word. An omitted limit is -1. If the path is for a machine with joints, the version is
// 2, and the number of joints and their names follow the limits of the path. If the axes have several
// units, the version is 3: the number of joints may then be 0, and the units of all axes and joints
// follow. Before the settings of the first command with other limits of axes come the number of these
// axes and, for each, velocity, acceleration and jerk.

namespace jounce {
namespace {

constexpr double list_version = 1;
constexpr double version_with_joints = 2;
constexpr double version_with_units = 3;
constexpr double omitted = -1;
constexpr double most_characters = 64;  ///< for the name of an axis

/// The first number of a command.
enum class Word : std::uint8_t { settings, line, arc, curve, dwell, event, axis_limits };
constexpr int words = 7;

/// Appends numbers to a list.
class Writer {
 public:
  void number(double value) { list.push_back(value); }
  void limit(double value) { number(std::isfinite(value) ? value : omitted); }
  void limit(const std::optional<double>& value) { number(value.value_or(omitted)); }
  void point(const Point& point, std::size_t axes) {
    list.insert(list.end(), point.begin(), point.begin() + static_cast<std::ptrdiff_t>(axes));
  }
  template <class Enum>
  void word(Enum value) {
    number(static_cast<double>(value));
  }
  void name(const std::string& name) {
    number(static_cast<double>(name.size()));
    for (const char c : name) number(static_cast<unsigned char>(c));
  }

  std::vector<double> list;
};

void write(std::span<const AxisRates> axes, Writer& to) {
  to.word(Word::axis_limits);
  to.number(static_cast<double>(axes.size()));
  for (const AxisRates& axis : axes)
    for (const double limit : {axis.velocity, axis.acceleration, axis.jerk}) to.limit(limit);
}

void write(const PathSettings& s, Writer& to) {
  to.word(Word::settings);
  for (const double limit : {s.velocity, s.acceleration, s.deceleration, s.jerk}) to.limit(limit);
  to.word(s.corner);
  to.number(s.value);
  to.word(s.junction);
}

void write(const Arc& arc, std::size_t n, Writer& to) {
  for (const Point* point : {&arc.center, &arc.e1, &arc.e2, &arc.drift, &arc.to})
    to.point(*point, n);
  for (const double value : {arc.radius, arc.sweep, arc.center_moved}) to.number(value);
}

void write(const PathCurve& curve, std::size_t n, Writer& to) {
  to.point(curve.from, n);
  to.point(curve.to, n);
  to.number(curve.length);
  to.number(static_cast<double>(curve.segments.size()));
  for (const Segment& s : curve.segments) {
    to.number(s.length);
    to.number(s.degree);
    for (int k = 0; k <= s.degree; ++k) to.number(s.c[static_cast<std::size_t>(k)]);
  }
}

void write(const ProgramWord& word, Writer& to) {
  to.word(Word::event);
  to.number(word.line);
  to.word(word.kind);
  to.number(word.number);
}

/// Reads numbers from a list, each within its range.
class Reader {
 public:
  explicit Reader(std::span<const double> list) : list_(list) {}

  [[nodiscard]] bool ended() const { return next_ == list_.size(); }
  double number() {
    if (ended()) fail("nothing", "must be a number: the list ends within a command");
    const double value = list_[next_++];
    if (!std::isfinite(value)) fail(jounce::number(value), "must be finite");
    return value;
  }
  /// A whole number from `low` to `high`.
  std::int64_t whole(double low, double high) {
    const double value = number();
    if (!(value >= low && value <= high && value == std::floor(value)))
      fail(jounce::number(value),
           "must be a whole number from " + jounce::number(low) + " to " + jounce::number(high));
    return static_cast<std::int64_t>(value);
  }
  std::optional<double> limit() {
    const double value = number();
    if (value == omitted) return std::nullopt;
    if (!(value > 0)) fail(jounce::number(value), "must be greater than 0, or -1 for no limit");
    return value;
  }
  double limit_or_none() { return limit().value_or(PathSettings::none); }
  Point point(std::size_t axes) {
    Point point{};
    for (std::size_t i = 0; i < axes; ++i) point[i] = number();
    return point;
  }
  std::string name() { return text(' ', '~'); }
  std::string unit() { return text(1, 255); }
  /// Characters in this range.
  std::string text(double low, double high) {
    std::string all;
    for (std::int64_t left = whole(0, most_characters); left > 0; --left)
      all.push_back(static_cast<char>(whole(low, high)));
    return all;
  }
  int line() { return static_cast<int>(whole(0, 1e9)); }
  [[noreturn]] void fail(const std::string& value, const std::string& rule) const {
    throw InputError("numbers[" + std::to_string(next_) + "]", value, rule);
  }
  /// Fails unless two points agree within rounding of a length.
  void require_same(const Point& a, const Point& b, double scale, const char* what) const {
    const double far = vec::distance(a, b);
    if (!(far <= profiles_detail::rounded_input * scale))
      fail(jounce::number(far), std::string("is the distance of ") + what + ", and must be 0");
  }

 private:
  std::span<const double> list_;
  std::size_t next_ = 0;
};

std::vector<AxisRates> axis_limits_of(Reader& from) {
  std::vector<AxisRates> axes(static_cast<std::size_t>(from.whole(0, max_axes)));
  for (AxisRates& axis : axes)
    for (double* limit : {&axis.velocity, &axis.acceleration, &axis.jerk})
      *limit = from.limit_or_none();
  return axes;
}

PathSettings settings_of(Reader& from) {
  PathSettings s;
  for (double* limit : {&s.velocity, &s.acceleration, &s.deceleration, &s.jerk})
    *limit = from.limit_or_none();
  s.corner = static_cast<Corner>(from.whole(0, static_cast<double>(Corner::average)));
  s.value = from.number();
  s.junction = static_cast<Junction>(from.whole(0, static_cast<double>(Junction::look_ahead)));
  return s;
}

double size_of(const Point& a, const Point& b) {
  return 1 + vec::norm(a) + vec::norm(b);
}

/// An arc whose vectors form a circle through its end; Program::arc() checks its start.
Arc arc_of(Reader& from, std::size_t n) {
  Arc arc;
  for (Point* point : {&arc.center, &arc.e1, &arc.e2, &arc.drift, &arc.to}) *point = from.point(n);
  for (double* value : {&arc.radius, &arc.sweep, &arc.center_moved}) *value = from.number();
  const double skew = std::abs(vec::dot(arc.e1, arc.e2)) + std::abs(vec::dot(arc.e1, arc.e1) - 1) +
                      std::abs(vec::dot(arc.e2, arc.e2) - 1);
  if (!(skew <= profiles_detail::rounded_input))
    from.fail(number(skew), "is the error of the unit vectors of an arc, and must be 0");
  if (!(arc.radius > 0 && arc.sweep > 0))
    from.fail(number(arc.radius),
              "is the radius of an arc: radius and sweep must be greater than 0");
  const double scale = size_of(arc.center, arc.to) + arc.radius;
  from.require_same(point_at(arc, arc.sweep), arc.to, scale, "the end of an arc from its circle");
  return arc;
}

PathCurve curve_of(Reader& from, const Point& start, std::size_t n) {
  PathCurve curve;
  curve.axes = n;
  curve.from = from.point(n);
  curve.to = from.point(n);
  curve.length = from.number();
  const auto count = static_cast<std::size_t>(from.whole(1, 1e9));
  if (count % n != 0) from.fail(std::to_string(count), "must be a multiple of the number of axes");
  Point at = start;
  for (std::size_t i = 0; i < count; ++i) {
    Segment s;
    s.length = from.number();
    if (!(s.length > 0)) from.fail(number(s.length), "must be greater than 0");
    s.degree = static_cast<int>(from.whole(0, static_cast<double>(s.c.size()) - 1));
    for (int k = 0; k <= s.degree; ++k) s.c[static_cast<std::size_t>(k)] = from.number();
    curve.segments.push_back(s);
    if (i % n + 1 < n) continue;
    Point begin{};
    Point end{};
    for (std::size_t axis = 0; axis < n; ++axis) {
      const Segment& piece = curve.segments[i + 1 - n + axis];
      begin[axis] = value(piece, 0);
      end[axis] = value(piece, 1);
    }
    from.require_same(begin, at, size_of(begin, at), "a piece of a curve from the piece before it");
    at = end;
  }
  from.require_same(at, curve.to, size_of(at, curve.to), "the end of a curve from its last piece");
  return curve;
}

ProgramWord word_of(Reader& from, std::size_t command) {
  ProgramWord word{.line = from.line(), .command = command};
  word.kind =
      static_cast<ProgramWord::Kind>(from.whole(0, static_cast<double>(ProgramWord::Kind::output)));
  const bool output = word.kind == ProgramWord::Kind::output;
  word.number = static_cast<std::int32_t>(
      from.whole(output ? -ProgramWord::most_outputs : 0,
                 output ? ProgramWord::most_outputs : ProgramWord::most_m_word));
  if (output && word.number == 0) from.fail("0", "must be the number of an output, from 1 on");
  return word;
}

}  // namespace

std::vector<double> numbers_of(const LimitedProgram& all) {
  const Program& program = all.program;
  const std::size_t n = program.axes();
  Writer to;
  const std::size_t joints = all.names.size() > n ? all.names.size() - n : 0;
  const bool with_units = !all.units.empty();
  to.number(with_units ? version_with_units : joints > 0 ? version_with_joints : list_version);
  to.number(static_cast<double>(n));
  to.number(static_cast<double>(program.path_axes()));
  to.point(program.start(), n);
  for (std::size_t k = 0; k < n; ++k) {
    to.name(k < all.names.size() ? all.names[k] : "");
    const Limits axis = k < all.limits.axes.size() ? all.limits.axes[k] : Limits{};
    for (const auto& limit : {axis.velocity, axis.acceleration, axis.jerk}) to.limit(limit);
  }
  const PathLimits& path = all.limits.path;
  for (const double limit : {path.velocity, path.acceleration, path.deceleration, path.jerk,
                             path.normal_acceleration, path.total_acceleration})
    to.limit(limit);
  if (joints > 0 || with_units) to.number(static_cast<double>(joints));
  for (std::size_t k = n; k < n + joints; ++k) to.name(all.names[k]);
  for (std::size_t k = 0; with_units && k < n + joints; ++k)
    to.name(k < all.units.size() ? all.units[k] : "");
  std::optional<std::uint32_t> settings;  // settings of the command before
  std::vector<AxisRates> axes;            // limits of axes in these settings
  std::size_t written = 0;                // words that are in the list
  const auto write_words = [&](std::size_t command) {
    for (; written < all.words.size() && all.words[written].command <= command; ++written)
      write(all.words[written], to);
  };
  for (const Program::Command& command : program.commands()) {
    write_words(static_cast<std::size_t>(&command - program.commands().data()));
    const PathSettings& own = program.settings()[command.settings];
    if (own.axes != axes) write(axes = own.axes, to);
    if (settings != command.settings) write(own, to);
    settings = command.settings;
    const auto word = command.kind == Program::Kind::line    ? Word::line
                      : command.kind == Program::Kind::arc   ? Word::arc
                      : command.kind == Program::Kind::curve ? Word::curve
                                                             : Word::dwell;
    to.word(word);
    to.number(command.line);
    if (word == Word::arc) write(program.arcs()[command.data], n, to);
    if (word == Word::curve) write(program.curves()[command.data], n, to);
    if (word == Word::line)
      for (std::size_t i = 0; i < n; ++i) to.number(program.numbers()[command.data + i]);
    if (word == Word::dwell) to.number(program.numbers()[command.data]);
  }
  write_words(program.commands().size());
  return to.list;
}

LimitedProgram program_of(std::span<const double> numbers) {
  Reader from(numbers);
  const double version = from.number();
  if (version != list_version && version != version_with_joints && version != version_with_units)
    from.fail(number(version), "must be 1, 2 or 3, the version of the list");
  const auto n = static_cast<std::size_t>(from.whole(1, max_axes));
  const auto path_axes = static_cast<std::size_t>(from.whole(1, static_cast<double>(n)));
  LimitedProgram all{.program = Program(n, from.point(n), path_axes), .limits = {}, .names = {}};
  for (std::size_t k = 0; k < n; ++k) {
    all.names.push_back(from.name());
    Limits axis;
    for (auto* limit : {&axis.velocity, &axis.acceleration, &axis.jerk}) *limit = from.limit();
    all.limits.axes.push_back(axis);
  }
  PathLimits& path = all.limits.path;
  for (double* limit : {&path.velocity, &path.acceleration, &path.deceleration, &path.jerk,
                        &path.normal_acceleration, &path.total_acceleration})
    *limit = from.limit_or_none();
  const bool with_units = version == version_with_units;
  if (version == version_with_joints || with_units)
    for (std::int64_t left = from.whole(with_units ? 0 : 1, max_axes); left > 0; --left)
      all.names.push_back(from.name());
  while (with_units && all.units.size() < all.names.size()) all.units.push_back(from.unit());
  std::vector<AxisRates> axes;
  while (!from.ended()) {
    const auto word = static_cast<Word>(from.whole(0, words - 1));
    if (word == Word::settings) {
      PathSettings settings = settings_of(from);
      settings.axes = axes;
      all.program.set(settings);
      continue;
    }
    if (word == Word::axis_limits) {
      axes = axis_limits_of(from);
      continue;
    }
    if (word == Word::event) {
      all.words.push_back(word_of(from, all.program.commands().size()));
      continue;
    }
    const int line = from.line();
    const Point start = all.program.position();
    if (word == Word::line) all.program.line(from.point(n), line);
    if (word == Word::arc) all.program.arc(arc_of(from, n), line);
    if (word == Word::curve) all.program.curve(curve_of(from, start, n), line);
    if (word == Word::dwell) all.program.dwell(from.number(), line);
  }
  return all;
}

}  // namespace jounce
