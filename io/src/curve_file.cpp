// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/curve_file.hpp"

#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

#include "jounce/pvt/table.hpp"

namespace jounce {

template <class Over>
std::string curve_json(const Curve<Over>& curve, const Units& units) {
  using Json = nlohmann::ordered_json;
  Json segments = Json::array();
  for (const Segment& f : curve.segments()) {
    Json sines = Json::array();
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
      sines.push_back({f.sine[i].amplitude, f.sine[i].angle, f.sine[i].phase});
    segments.push_back(
        {{"length", f.length},
         {"polynomial", std::vector<double>(f.c.begin(), f.c.begin() + f.degree + 1)},
         {"sines", std::move(sines)}});
  }
  const Json document{{"jounce_curve", 1},
                      {"axis", std::is_same_v<Over, OverTime> ? "time" : "master"},
                      {"outside", name(curve.outside())},
                      {"units", {{"x", units.x}, {"position", units.position}}},
                      {"start", curve.start()},
                      {"segments", std::move(segments)}};
  return document.dump(1) + "\n";
}

template std::string curve_json(const Curve<OverTime>&, const Units&);
template std::string curve_json(const Curve<OverMaster>&, const Units&);

}  // namespace jounce
