// SPDX-License-Identifier: Apache-2.0
// chart_values SPEC: prints the chart_data() of the first axis of a spec.
// chart_values SPEC VIEW: reads places of the x axis, one a line, and prints for each the value and three derivatives,
// and the texts that a report shows for them, as JSON. Where a value jumps, the text has both sides. VIEW: 0 is the
// figure, 1 is the slave over time.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "jounce/design/over_time.hpp"
#include "jounce/plot/chart_data.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/label.hpp"

#include "plot/src/figure/input_look.hpp"

namespace {

constexpr int cursor_digits = 9;

std::string text(double value, double noise) {
  return jounce::short_number(std::abs(value) <= noise ? 0 : value, cursor_digits);
}

nlohmann::json values(const jounce::Input& input) {
  const jounce::Figure figure = jounce::figure_of(input);
  const jounce::CurveLook look = jounce::look_of(input);
  nlohmann::json all = nlohmann::json::array();
  std::visit(
      [&](const auto& curve) {
        for (std::string line; std::getline(std::cin, line);) {
          const double x = std::strtod(line.c_str(), nullptr);
          const jounce::Jet left =
              curve.jet(x, x > curve.start() ? jounce::Side::left : jounce::Side::right);
          const jounce::Jet right =
              curve.jet(x, x < curve.end() ? jounce::Side::right : jounce::Side::left);
          nlohmann::json texts = nlohmann::json::array();
          for (std::size_t k = 0; k < right.size(); ++k) {
            const double size = jounce::panel_unit(look, static_cast<int>(k)).size;
            const double noise = figure.panels[k].noise;
            const std::string before = text(left[k] / size, noise);
            const std::string after = text(right[k] / size, noise);
            const bool jumps = std::abs(left[k] - right[k]) / size > noise && before != after;
            texts.push_back(jumps ? before + " → " + after : after);
          }
          all.push_back({{"jet", right}, {"texts", texts}});
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
