// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/key_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/cam/detail/quadrature.hpp"
#include "jounce/design/detail/driven.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/design/detail/sync_check.hpp"

#include "design/src/check/master_check.hpp"

namespace jounce {
namespace {

/// The rms of the derivative of this order.
template <class Over>
double rms(const Curve<Over>& curve, int order) {
  double sum = 0;
  for (const Segment& f : curve.segments())
    cam_detail::quadrature(f, [&](double s, double weight) {
      const double y = evaluate(f, s)[static_cast<std::size_t>(order)];
      sum += weight * f.length * y * y;
    });
  return std::sqrt(sum / curve.length());
}

double saturation_time(const DriveResult& run) {
  double sum = 0;
  for (const Saturation& s : run.saturation) sum += s.to - s.from;
  return sum;
}

bool always(const DriveSpec&) {
  return true;
}

bool has_current(const DriveSpec& spec) {
  return spec.drive.motor.torque_constant > 0;
}

/// The figures of a run of the drive for which the spec has the data. The unit "u" is that of the
/// position.
struct DriveKeyFigure {
  const char* name;
  const char* unit;
  double (*of)(const DriveResult& run);
  std::optional<double> DriveLimits::*limit = nullptr;
  bool (*has)(const DriveSpec& spec) = always;
};
constexpr std::array drive_figures{
    DriveKeyFigure{"peak torque", "N m", [](const auto& run) { return run.torque.value; },
                   &DriveLimits::torque},
    DriveKeyFigure{"rms torque", "N m", [](const auto& run) { return run.rms_torque; },
                   &DriveLimits::rms_torque},
    DriveKeyFigure{"peak current", "A", [](const auto& run) { return run.current.value; },
                   &DriveLimits::current, has_current},
    DriveKeyFigure{"rms current", "A", [](const auto& run) { return run.rms_current; }, nullptr,
                   has_current},
    DriveKeyFigure{"motor velocity", "rad/s", [](const auto& run) { return run.velocity.value; },
                   &DriveLimits::velocity},
    DriveKeyFigure{"following error", "u",
                   [](const auto& run) { return run.following_error.value; },
                   &DriveLimits::following_error},
    DriveKeyFigure{
        "sync following error", "u", [](const auto& run) { return run.sync_following_error.value; },
        &DriveLimits::sync_following_error, [](const auto& spec) { return !spec.sync.empty(); }},
    DriveKeyFigure{"end following error", "u",
                   [](const auto& run) { return run.end_following_error; },
                   &DriveLimits::end_following_error},
    DriveKeyFigure{"residual", "u", [](const auto& run) { return run.residual.value; },
                   &DriveLimits::residual},
    DriveKeyFigure{"residual frequency", "Hz",
                   [](const auto& run) { return run.residual_frequency; }},
    DriveKeyFigure{"settling time", "s",
                   [](const auto& run) {
                     return run.settling_time.value_or(std::numeric_limits<double>::infinity());
                   },
                   &DriveLimits::settling_time,
                   [](const auto& spec) { return spec.limits.settling_band.has_value(); }},
    DriveKeyFigure{"swing", "u", [](const auto& run) { return run.swing.value; }, nullptr,
                   [](const auto& spec) { return spec.drive.pendulum.has_value(); }},
    DriveKeyFigure{"i2t", "", [](const auto& run) { return run.i2t.value; }, nullptr,
                   [](const auto& spec) { return spec.drive.motor.thermal_time > 0; }},
    DriveKeyFigure{"saturation time", "s", saturation_time},
    DriveKeyFigure{"energy", "J", [](const auto& run) { return run.energy.driving; }},
    DriveKeyFigure{"regenerated energy", "J",
                   [](const auto& run) { return run.energy.regenerated; }},
    DriveKeyFigure{"copper loss", "J", [](const auto& run) { return run.energy.copper; }, nullptr,
                   [](const auto& spec) { return spec.drive.motor.resistance > 0; }},
};

/// A figure that is computed when it is requested.
struct Offer {
  std::string name;
  std::string unit;
  std::function<double()> value;
  bool of_drive = false;  ///< true: requires the integration of the drive
  std::optional<double> limit = {};
};

/// One axis of a design. Results that take long are computed at most once.
class Looked {
 public:
  explicit Looked(Input input) : input_(std::move(input)) {}

  [[nodiscard]] const Input& input() const { return input_; }
  const Trajectory& motion() {
    if (!motion_) motion_ = motion_over_time(input_);
    return *motion_;
  }
  const DriveResult& drive() {
    if (!drive_) drive_ = driven(input_);
    if (!drive_->integration.ok())
      throw InputError("drive", "",
                       "could not be integrated to its end: " + drive_->integration.reason);
    return *drive_;
  }

 private:
  Input input_;
  std::optional<Trajectory> motion_;
  std::optional<DriveResult> drive_;
};

class Offers {
 public:
  Offers(Looked& looked, bool first, std::vector<Offer>& all)
      : looked_(looked), input_(looked.input()), first_(first), all_(all) {}

  void add_all() {
    const auto* cam = std::get_if<Cam>(&*input_.curve);
    add_table();
    if (cam == nullptr || input_.spec->master) add_motion();
    if (cam != nullptr) add_rates<OverMaster>([cam]() -> const Cam& { return *cam; });
    if (cam != nullptr) add_master(*cam);
    if (first_)
      for (const SyncFigure& f : sync_figures(*input_.spec)) add_known(f.name, f.unit, f.value);
    for (std::size_t i = 0; i < input_.residuals.size(); ++i)
      add_known("predicted residual" + (i == 0 ? "" : " " + std::to_string(i + 1)),
                input_.labels.units.position, input_.residuals[i].after);
    if (input_.drive) add_drive();
  }

 private:
  void add(const std::string& name, const std::string& unit, std::function<double()> value,
           bool of_drive = false) {
    const std::string axis = input_.axis.empty() || name == "duration" ? "" : input_.axis + " ";
    all_.push_back({axis + name, unit, std::move(value), of_drive, {}});
  }
  void add_known(const std::string& name, const std::string& unit, double value) {
    add(name, unit, [value] { return value; });
  }

  void add_table() {
    const Range travel =
        std::visit([](const auto& curve) { return extrema(curve, 0); }, *input_.curve);
    add_known("stroke", input_.labels.units.position, travel.max.value - travel.min.value);
    add_known("knots", "", static_cast<double>(input_.table.table.columns().x.size()));
  }

  void add_motion() {
    Looked& looked = looked_;
    if (first_)
      add("duration", input_.spec->time_unit, [&looked] { return looked.motion().length(); });
    add_rates<OverTime>([&looked]() -> const Trajectory& { return looked.motion(); });
  }

  template <class Over, class Find>
  void add_rates(Find curve) {
    const std::string x =
        std::is_same_v<Over, OverTime> ? input_.spec->time_unit : input_.labels.units.x;
    constexpr bool in_time = std::is_same_v<Over, OverTime>;
    const bool of_cam = std::holds_alternative<Cam>(*input_.curve);
    const Limits& limits = in_time && of_cam ? input_.spec->slave : input_.limits;
    const std::array most{limits.velocity, limits.acceleration, limits.jerk};
    for (int k = 1; k <= 3; ++k) {
      const std::string name = Over::names[static_cast<std::size_t>(k)];
      const std::string unit = rate_unit(input_.labels.units.position, x, k);
      add("peak " + name, unit, [curve, k] { return std::abs(extrema(curve(), k).peak().value); });
      all_.back().limit = most[static_cast<std::size_t>(k - 1)];
      add("rms " + name, unit, [curve, k] { return rms(curve(), k); });
    }
  }

  void add_master(const Cam& cam) {
    const Spec& spec = *input_.spec;
    const std::string unit = master_rate_unit(spec, 1);
    if (spec.master) add_known("master velocity", unit, spec.master->velocity);
    if (const auto period = spec.master_period(); period && spec.master)
      add_period(spec, *period / spec.master->velocity);
    if (has_slave_limits(spec))
      add("fastest master", unit, [&cam, &spec] {
        return greatest_master_velocity(cam, spec.slave, master_rates(spec)).value;
      });
  }

  /// `cycle`: time of one cycle, in the unit of time of the spec.
  void add_period(const Spec& spec, double cycle) {
    add_known("cycle time", spec.time_unit, cycle);
    const auto* const sync = std::get_if<SyncSpec>(&spec.subject);
    if (const auto cuts = sync != nullptr ? cut_list_of(*sync) : std::nullopt)
      add_known(
          "cuts", "1/min",
          static_cast<double>(cuts->list.size()) / (cycle * conversion(spec.time_unit, "min")));
  }

  void add_drive() {
    Looked& looked = looked_;
    const std::string& u = input_.labels.units.position;
    for (const DriveKeyFigure& f : drive_figures) {
      if (!f.has(*input_.drive)) continue;
      add(
          f.name, f.unit == std::string("u") ? u : f.unit,
          [&looked, &f] { return std::abs(f.of(looked.drive())); }, true);
      if (f.limit != nullptr) all_.back().limit = input_.drive->limits.*f.limit;
    }
  }

  Looked& looked_;
  const Input& input_;
  bool first_;
  std::vector<Offer>& all_;
};

double margin(const Report& report) {
  double least = std::numeric_limits<double>::infinity();
  for (const Finding& f : report.findings)
    if (states_limit(f)) least = std::min(least, f.margin);
  return least;
}

void append(Report& all, Report part, const std::string& axis) {
  for (Finding& f : part.findings) {
    if (!axis.empty()) f.axis = f.axis.empty() ? axis : axis + " " + f.axis;
    all.findings.push_back(std::move(f));
  }
}

Report report_of(std::vector<Looked>& axes, bool with_drive) {
  Report all;
  for (Looked& axis : axes) {
    const Input& input = axis.input();
    append(all, check_all(input), input.axis);
    if (input.drive && with_drive) append(all, axis.drive().report, input.axis);
  }
  sort(all);
  return all;
}

std::vector<LimitMargin> margins_of(const Input& input) {
  std::vector<LimitMargin> margins = std::visit(
      [&](const auto& curve) { return limit_margins(curve, input.limits); }, *input.curve);
  for (LimitMargin& margin : margins)
    if (!input.axis.empty()) margin.rule += " " + input.axis;
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr || !input.spec->master || !has_slave_limits(*input.spec)) return margins;
  if (master_rates(*input.spec).acceleration > 0) return margins;
  for (LimitMargin& margin : limit_margins(*cam, slave_limits_by_master(*input.spec)))
    margins.push_back({"limit/master_velocity", std::move(margin.segments)});
  return margins;
}

[[noreturn]] void refuse(const std::string& name, const std::vector<Offer>& offers) {
  std::vector<std::string> known;
  for (const Offer& offer : offers) known.push_back(offer.name);
  const std::string hint = nearest(name, known);
  throw InputError(
      "figure", '"' + name + '"',
      "must be one of " + listed(known) + (hint.empty() ? "" : ": did you mean \"" + hint + "\"?"));
}

std::vector<const Offer*> chosen(const std::vector<Offer>& offers,
                                 const std::vector<std::string>& names) {
  std::vector<const Offer*> all;
  if (names.empty())
    for (const Offer& offer : offers) all.push_back(&offer);
  for (const std::string& name : names) {
    const auto at = std::find_if(offers.begin(), offers.end(),
                                 [&](const Offer& offer) { return offer.name == name; });
    if (at == offers.end()) refuse(name, offers);
    all.push_back(&*at);
  }
  return all;
}

Assessment assessed(std::vector<Looked>& axes, const std::vector<std::string>& names) {
  Assessment all;
  std::vector<Offer> offers;
  for (Looked& axis : axes) Offers(axis, &axis == &axes.front(), offers).add_all();
  offers.push_back({"margin", "", [&] { return margin(all.report); }, true, {}});
  const std::vector<const Offer*> wanted = chosen(offers, names);
  all.report = report_of(axes, std::any_of(wanted.begin(), wanted.end(),
                                           [](const Offer* offer) { return offer->of_drive; }));
  for (const Offer* offer : wanted)
    all.figures.push_back({offer->name, offer->value(), offer->unit, offer->limit});
  return all;
}

}  // namespace

bool states_limit(const Finding& f) {
  return f.severity == Severity::required &&
         (f.broken ||
          !(f.rule.family() == RuleFamily::table || f.rule.family() == RuleFamily::continuity));
}

std::optional<double> Assessment::value(const std::string& name) const {
  const auto at = std::find_if(figures.begin(), figures.end(),
                               [&](const KeyFigure& f) { return f.name == name; });
  if (at == figures.end()) return std::nullopt;
  return at->value;
}

namespace {

Assessment assessed(const Spec& spec, const std::vector<std::string>& names, bool by_segment) {
  std::vector<Looked> axes;
  for (Input& input : inputs_of(spec, spec.document.name)) axes.emplace_back(std::move(input));
  try {
    Assessment all = assessed(axes, names);
    for (const Looked& axis : axes)
      if (by_segment)
        for (LimitMargin& margin : margins_of(axis.input()))
          all.margins.push_back(std::move(margin));
    return all;
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace

Assessment assess(const Spec& spec, const std::vector<std::string>& names) {
  return assessed(spec, names, false);
}

Assessment assess_by_segment(const Spec& spec, const std::vector<std::string>& names) {
  return assessed(spec, names, true);
}

std::string rule_of(const Finding& finding) {
  return finding.rule.text() + (finding.axis.empty() ? "" : " " + finding.axis);
}

}  // namespace jounce
