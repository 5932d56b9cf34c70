// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/drive_figures.hpp"

#include <variant>

namespace jounce {

std::string name(DriveFigure figure) {
  switch (figure) {
    case DriveFigure::torque:
      return "drive torque";
    case DriveFigure::rms_torque:
      return "drive rms torque";
    case DriveFigure::residual:
      return "drive residual";
    case DriveFigure::following_error:
      return "drive following error";
    case DriveFigure::end_following_error:
      return "drive end following error";
  }
  return "";
}

std::optional<DriveFigure> drive_figure(const std::string& called) {
  for (const DriveFigure figure : all_drive_figures)
    if (name(figure) == called) return figure;
  return std::nullopt;
}

ShapeFigure asked(DriveFigure figure) {
  if (figure == DriveFigure::rms_torque) return RmsResponseOf{name(figure), {}};
  return ResponseOf{name(figure), {}};
}

std::optional<DriveFigure> drive_figure(const ShapeFigure& figure) {
  if (!std::holds_alternative<ResponseOf>(figure) && !std::holds_alternative<RmsResponseOf>(figure))
    return std::nullopt;
  return drive_figure(name(figure));
}

}  // namespace jounce
