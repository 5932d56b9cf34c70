// SPDX-License-Identifier: Apache-2.0
// chart_values SPEC: prints the chart_data() of the first axis of a spec.
// chart_values SPEC VIEW: reads places of the x axis, one a line, and prints for each the value and three derivatives,
// and the texts that a report shows for them, as JSON. VIEW: 0 is the figure, 1 is the slave over time.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <nlohmann/json.hpp>

#include "jounce/design/over_time.hpp"
#include "jounce/plot/chart_data.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/label.hpp"

#include "plot/src/figure/input_look.hpp"

namespace {

constexpr int cursor_digits = 9;

nlohmann::json values(const jounce::Input& input) {
  const jounce::Figure figure = jounce::figure_of(input);
  const jounce::CurveLook look = jounce::look_of(input);
  nlohmann::json all = nlohmann::json::array();
  std::visit(
      [&](const auto& curve) {
        for (std::string line; std::getline(std::cin, line);) {
          const double x = std::strtod(line.c_str(), nullptr);
          const auto side = x == curve.end() ? jounce::Side::left : jounce::Side::right;
          const jounce::Jet jet = curve.jet(x, side);
          nlohmann::json texts = nlohmann::json::array();
          for (std::size_t k = 0; k < jet.size(); ++k) {
            const double value = jet[k] / jounce::panel_unit(look, static_cast<int>(k)).size;
            const bool rounding = std::abs(value) <= figure.panels[k].noise;
            texts.push_back(jounce::short_number(rounding ? 0 : value, cursor_digits));
          }
          all.push_back({{"jet", jet}, {"texts", texts}});
        }
      },
      *input.curve);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const jounce::Input input = jounce::read_inputs(argv[1]).front();
  if (argc == 2)
    std::cout << jounce::chart_data(input);
  else
    std::cout << values(argv[2][0] == '1' ? jounce::over_time(input) : input);
}
