// SPDX-License-Identifier: Apache-2.0
#include "cli/common/picture.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/base/file.hpp"
#include "jounce/plot/curve_figure.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce::cli {
namespace {

/// Where the segments of the spec meet, not the pieces of a law.
std::vector<double> knots(std::span<const double> breaks, const Labels& labels) {
  std::vector<double> all{breaks.front()};
  for (const auto& group : groups(breaks.size() - 1, labels)) all.push_back(breaks[group.last + 1]);
  return all;
}

/// The segments of a cam's spec, as reports call them, and their laws.
std::vector<std::vector<Shade>> strips(std::span<const double> breaks, const Input& input) {
  if (!input.spec || !std::holds_alternative<CamSpec>(input.spec->subject)) return {};
  const auto& segments = std::get<CamSpec>(input.spec->subject).segments;
  std::vector<Shade> names;
  std::vector<Shade> laws;
  for (const auto& group : groups(breaks.size() - 1, input.labels)) {
    if (names.size() == segments.size()) break;
    const CamSegment& segment = segments[names.size()];
    names.push_back({breaks[group.first], breaks[group.last + 1], group.label});
    laws.push_back({breaks[group.first], breaks[group.last + 1], name(segment.law)});
  }
  return {std::move(names), std::move(laws)};
}

struct Removed {
  std::string folder;
  ~Removed() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
};

CurveLook look_of(const Input& input) {
  CurveLook look{.title = input.name,
                 .axis_unit = input.labels.units.x,
                 .unit = input.labels.units.position,
                 .limits = input.limits};
  for (const SyncZone& zone : input.zones) look.shades.push_back({zone.from, zone.to, zone.name});
  if (const auto* cam = std::get_if<Cam>(&*input.curve); cam != nullptr && look.shades.empty())
    look.shades = in_step(*cam, input.labels);
  const auto breaks = std::visit([](const auto& curve) { return curve.breaks(); }, *input.curve);
  look.knots = knots(breaks, input.labels);
  look.strips = strips(breaks, input);
  return look;
}

/// The curve of another input in the units of this one.
template <class Over>
Curve<Over> in_units_of(const Input& input, const Input& other, const Curve<Over>& curve) {
  const Version version = in_units({other.name, curve, other.labels}, input.labels.units);
  return std::get<Curve<Over>>(version.curve);
}

/// Adds what another axis does to a panel.
void add(Panel& panel, Panel other) {
  if (panel.lower != other.lower) panel.lower.reset();
  if (panel.upper != other.upper) panel.upper.reset();
  panel.noise = std::max(panel.noise, other.noise);
  for (Series& series : other.series) panel.series.push_back(std::move(series));
  for (Marker& marker : other.markers) panel.markers.push_back(std::move(marker));
}

Figure figure_of_axis(const Input& input) {
  CurveLook look = look_of(input);
  if (!input.axis.empty()) look.label = input.axis;
  return std::visit([&](const auto& curve) { return curve_figure(curve, look); }, *input.curve);
}

}  // namespace

std::vector<Shade> in_step(const Cam& cam, const Labels& labels) {
  std::vector<Shade> shades;
  for (std::size_t i = 0; i < cam.segments().size(); ++i) {
    const Range v = segment_extrema(cam, i)[1];
    const double peak = std::abs(v.peak().value);
    if (peak == 0 || v.max.value - v.min.value > 1e-9 * peak) continue;
    const std::string label = labels.segments.empty() ? "" : labels.segments[i];
    shades.push_back({cam.breaks()[i], cam.breaks()[i + 1],
                      label.substr(std::min(label.size(), label.find(' ') + 1))});
  }
  return shades;
}

Figure figure_of(const std::vector<Input>& axes) {
  Figure figure = figure_of_axis(axes.front());
  if (axes.size() == 1) return figure;
  if (axes.front().spec) figure.title = axes.front().spec->name;
  figure.knots.clear();  // each axis has its own
  for (std::size_t i = 1; i < axes.size(); ++i) {
    if (axes[i].labels.units.position != axes.front().labels.units.position)
      throw InputError("--axis", "",
                       "is missing: " + axes.front().axis + " and " + axes[i].axis +
                           " have different units, so one picture cannot show both");
    Figure other = figure_of_axis(axes[i]);
    for (std::size_t k = 0; k < figure.panels.size(); ++k)
      add(figure.panels[k], std::move(other.panels[k]));
  }
  for (Panel& panel : figure.panels)  // every axis rests at 0 somewhere: not worth a number each
    std::erase_if(panel.markers, [](const Marker& marker) { return marker.y == 0; });
  return figure;
}

Figure figure_of(const Input& input, const std::optional<Input>& before) {
  CurveLook look = look_of(input);
  if (!before)
    return std::visit([&](const auto& curve) { return curve_figure(curve, look); }, *input.curve);
  look.label = input.name;
  look.before = before->name == input.name ? "before" : before->name;
  return std::visit(
      [&]<class Over>(const Curve<Over>& curve) {
        const auto* other = std::get_if<Curve<Over>>(&*before->curve);
        if (other == nullptr)
          throw InputError("--before", before->name,
                           "has another independent axis than " + input.name);
        return curve_figure(curve, in_units_of(input, *before, *other), look);
      },
      *input.curve);
}

namespace {

void write_png(const std::string& path, const std::string& svg) {
  std::string folder = std::filesystem::temp_directory_path() / "jounce.XXXXXX";
  if (mkdtemp(folder.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make a temporary folder");
  const Removed removed{folder};
  const std::string source = folder + "/picture.svg";
  const std::string target = folder + "/picture.png";
  write_file(source, svg);
  const std::array<std::string, 6> words{"rsvg-convert", "--zoom=2", "--background-color=white",
                                         "-o",           target,     source};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = const_cast<char*>(words[i].c_str());
  pid_t child = 0;
  int status = -1;
  const int spawned =
      posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (spawned == 0) waitpid(child, &status, 0);
  if (spawned != 0)
    throw std::system_error(
        spawned, std::generic_category(),
        "needs rsvg-convert (Debian: librsvg2-bin); write .svg instead, or install it");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::system_error(EIO, std::generic_category(), "rsvg-convert failed");
  write_file(path, read_file(target));
}

}  // namespace

void require_picture(const char* option, const std::string& path) {
  if (!path.ends_with(".png") && !path.ends_with(".svg") && path != "-")
    throw InputError(option, path, "must end in .svg or .png, or be - for SVG on standard output");
}

void write_svg(const std::string& path, const std::string& picture) {
  require_picture("--output", path);
  if (path.ends_with(".png"))
    write_png(path, picture);
  else
    write_file(path, picture);
}

void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options) {
  require_picture("--output", path);
  write_svg(path, svg(figure, options));
}

}  // namespace jounce::cli
