// SPDX-License-Identifier: Apache-2.0
#include "study/src/optimum/shape_words.hpp"

#include <algorithm>

namespace jounce::study_detail {
namespace {

constexpr double active_margin = 1e-6;  ///< a smaller margin is that of an active limit

}  // namespace

std::vector<PrintedFigure> printed_figures(const CamRunOutcome& run, const ShapeWords& words) {
  const double length = words.length(run);
  const bool alone = words.minimized() == 1;
  std::vector<PrintedFigure> all;
  for (std::size_t i = 0; i < run.shape.figures.size() && i < words.figures().size(); ++i) {
    const ShapeFigureSpec& spec = words.figures()[i];
    const FigureResult& figure = run.shape.figures[i];
    PrintedFigure t{
        spec, shown(spec, figure.given, length), shown(spec, figure.reached, length), {}, {}};
    std::optional<double> bound = figure.bound;
    if (i == 0 && alone && run.shape.bound && run.shape.value > 0)
      bound = std::max(bound.value_or(0), figure.reached * *run.shape.bound / run.shape.value);
    if (bound && *bound > 0) t.bound = shown(spec, *bound, length);  // 0 is no news
    if (t.bound && t.reached > 0) t.could_save = std::max(0.0, 1 - *t.bound / t.reached);
    all.push_back(t);
  }
  return all;
}

const Finding* next_limit(const CamRunOutcome& run) {
  const Finding* next = nullptr;
  for (const Finding& f : run.shape.limits.findings) {
    const bool met = std::any_of(run.shape.active.begin(), run.shape.active.end(),
                                 [&](const Finding& a) { return a.quantity == f.quantity; });
    if (f.broken || met || f.margin <= active_margin) continue;
    if (next == nullptr || f.margin < next->margin) next = &f;
  }
  return next;
}

}  // namespace jounce::study_detail
