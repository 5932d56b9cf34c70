#include <cmath>

#include "jounce/cam/coupling.hpp"
#include "jounce/cam/detail/settle.hpp"

namespace jounce {
namespace {

Finding finding(std::string rule, const char* quantity, double where, double value, bool broken,
                const char* advice) {
  return {.rule = std::move(rule),
          .axis = {},
          .quantity = quantity,
          .where = where,
          .value = value,
          .limit = 0,
          .margin = broken ? -1.0 : 0.0,
          .broken = broken,
          .segment = {},
          .advice = broken ? advice : ""};
}

/// The fastest end of a cam that runs once: there the slave is let go.
void add_end(const Coupling& coupling, Report& report) {
  const Cam& cam = coupling.cam();
  for (const auto& [where, side] : {std::pair{cam.start(), Side::right}, {cam.end(), Side::left}})
    if (const double slope = cam.jet(where, side)[1]; slope != 0)
      report.findings.push_back(finding("coupling/end", "geo_velocity", where, slope, false, ""));
}

}  // namespace

Report check(const Coupling& coupling, const MotionState& slave, const Jet& master) {
  Report report;
  const Engagement in = engage(coupling, slave, master, 0);
  const double X = in.engaged.placement.at(master[0]);
  if (!in) {
    report.findings.push_back(finding(std::string("coupling/") + name(in.status), "master", X,
                                      master[0], true, explain(in.status)));
    return report;
  }
  const Jet y = placed(coupling.cam(), in.engaged.placement, master);
  const Jet near = detail::roundings(coupling, slave, y, master);
  const std::array<double, 3> jumps{in.jump.position, in.jump.velocity, in.jump.acceleration};
  for (std::size_t k = 0; k < jumps.size(); ++k)
    report.findings.push_back(finding("coupling/start", OverTime::names[k], X, jumps[k],
                                      std::abs(jumps[k]) > near[k],
                                      "the slave jumps by so much: start = \"ramp_in\" does not"));
  if (coupling.periodic())
    report.findings.push_back(
        finding("coupling/period", "position", coupling.cam().end(), coupling.period_jump(),
                std::abs(coupling.period_jump()) > near[0],
                "the slave jumps so far at each period's end: slave_absolute = false goes on"));
  else
    add_end(coupling, report);
  sort(report);
  return report;
}

}  // namespace jounce
