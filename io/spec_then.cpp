#include <algorithm>
#include <array>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"

namespace jounce::detail {
namespace {

Operator read_moving_average(MotionFields& f) {
  return MovingAverageSpec{f.reader().number("window", f.units().x)};
}

Operator read_shaper(MotionFields& f) {
  const std::vector<std::string> kinds{"zv", "zvd", "ei"};
  TomlReader& then = f.reader();
  ShaperSpec s;
  s.kind = static_cast<ShaperKind>(then.choice("kind", kinds));
  s.mode.frequency = then.number("frequency", "Hz");
  f.may_in("damping", "1", s.mode.damping);
  if (s.kind == ShaperKind::ei) f.may_in("tolerance", "1", s.tolerance);
  return s;
}

Operator read_notch(MotionFields& f) {
  NotchSpec s;
  s.frequency = f.reader().number("frequency", "Hz");
  f.may_in("damping", "1", s.damping);
  f.may_in("mode_damping", "1", s.mode_damping);
  f.may_in("settled", "1", s.settled);
  return s;
}

Operator read_retime(MotionFields&) {
  return RetimeSpec{};
}

Operator read_override(MotionFields& f) {
  OverrideSpec s;
  f.may_in("factor", "1", s.factor);
  f.may_in("maximum", "1", s.maximum);
  for (TomlReader& each : f.reader().tables("request")) {
    s.requests.push_back({each.number("time", f.units().x), each.number("factor", "1")});
    each.finish();
  }
  return s;
}

ChangeSpec read_change(MotionFields& f, ChangeSpec::To to) {
  ChangeSpec c{.to = to};
  c.time = f.reader().number("time", f.units().x);
  c.dynamics = read_dynamics(f, to != ChangeSpec::To::velocity);
  return c;
}

Operator read_new_target(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::target);
  f.need("to", 0, c.value);
  return c;
}

Operator read_new_velocity(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::velocity);
  f.need("velocity", 1, c.value);
  return c;
}

Operator read_move_additive(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::additive);
  f.need("distance", 0, c.value);
  return c;
}

Operator read_move_superimposed(MotionFields& f) {
  ChangeSpec c = read_change(f, ChangeSpec::To::superimposed);
  f.need("distance", 0, c.value);
  c.abort = f.optional_time("abort");
  return c;
}

Operator read_compensation(MotionFields& f) {
  static const std::vector<std::string> rules{"linear", "cubic"};
  TomlReader& then = f.reader();
  const std::string& unit = f.units().position;
  CompensateSpec s;
  if (const auto rule = then.optional_choice("rule", rules))
    s.table.rule = static_cast<GridRule>(*rule);
  s.axis = then.optional_text("axis").value_or("");
  s.tolerance = f.optional("tolerance", 0);
  s.table.most = f.optional("most", 0).value_or(s.table.most);
  std::size_t points = 1;
  for (TomlReader& reference : then.tables("reference")) {
    GridAxis axis{reference.number("base", unit), reference.number("interval", unit),
                  reference.optional_count("count").value_or(0)};
    s.table.axes.push_back(axis);
    s.references.push_back(reference.optional_text("axis").value_or(""));
    points *= std::min<std::size_t>(axis.count, 1'000'000);
    reference.finish();
  }
  s.table.values = then.numbers(
      "values", std::vector<std::string>(std::min<std::size_t>(points, 1'000'000), unit));
  return s;
}

struct OperatorReader {
  const char* name;
  Operator (*read)(MotionFields& fields);
};
constexpr std::array operators{OperatorReader{"moving_average", read_moving_average},
                               OperatorReader{"shaper", read_shaper},
                               OperatorReader{"notch", read_notch},
                               OperatorReader{"retime", read_retime},
                               OperatorReader{"override", read_override},
                               OperatorReader{"new_target", read_new_target},
                               OperatorReader{"new_velocity", read_new_velocity},
                               OperatorReader{"move_additive", read_move_additive},
                               OperatorReader{"move_superimposed", read_move_superimposed},
                               OperatorReader{"compensation", read_compensation}};

}  // namespace

std::vector<Operator> read_then(TomlReader& top, const Units& units) {
  std::vector<std::string> names;
  for (const OperatorReader& each : operators) names.emplace_back(each.name);
  std::vector<Operator> all;
  for (TomlReader& then : top.tables("then")) {
    MotionFields fields(then, units);
    all.push_back(operators[then.choice("operator", names)].read(fields));
    then.finish();
  }
  return all;
}

}  // namespace jounce::detail
