#include "felt/io/svg/svg_shapes.h"

#include <algorithm>
#include <array>
#include <pugixml.hpp>

#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_path_parser.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

constexpr std::array<std::string_view, 7> kShapes{"path", "rect",     "circle", "ellipse",
                                                  "line", "polyline", "polygon"};

/// Reads the lengths of one element.
class Lengths {
 public:
  Lengths(const pugi::xml_node& node, const SvgDeclared& declared, const SvgUnits& units,
          std::string& problem)
      : node_(node), declared_(declared), units_(units), problem_(problem) {}

  /// Returns the attribute, or 0.
  [[nodiscard]] double operator()(const char* name, SvgAxis axis) const {
    return given(name, axis).value_or(0.0);
  }
  /// Returns nullopt if the radius is missing, "auto", not a length, or negative.
  [[nodiscard]] std::optional<double> radius(const char* name, SvgAxis axis) const {
    const std::optional<double> value = given(name, axis);
    return value && *value >= 0.0 ? value : std::nullopt;
  }

 private:
  /// Returns the attribute if it is there. If it is not a length, that is reported as a problem.
  [[nodiscard]] std::optional<double> given(const char* name, SvgAxis axis) const {
    const std::string_view said = declared_.value_of(name);
    const std::string_view text = said.empty() ? svg_trimmed(node_.attribute(name).value()) : said;
    if (text.empty() || svg_same_word(text, "auto")) return std::nullopt;
    const std::optional<double> length = svg_length(text, axis, units_);
    if (!length) problem_ = std::string(name) + " is not a length";
    return length;
  }

  const pugi::xml_node& node_;
  const SvgDeclared& declared_;
  const SvgUnits& units_;
  std::string& problem_;
};

void add_rect(const Lengths& length, SvgPathBuilder& path) {
  const double x = length("x", SvgAxis::kX), y = length("y", SvgAxis::kY);
  const double w = length("width", SvgAxis::kX), h = length("height", SvgAxis::kY);
  if (!(w > 0.0) || !(h > 0.0)) return;
  std::optional<double> rx = length.radius("rx", SvgAxis::kX);
  std::optional<double> ry = length.radius("ry", SvgAxis::kY);
  if (!rx) rx = ry;
  if (!ry) ry = rx;
  const double a = std::min(rx.value_or(0.0), 0.5 * w), b = std::min(ry.value_or(0.0), 0.5 * h);
  if (!(a > 0.0) || !(b > 0.0)) {
    path.move({x, y});
    path.line({x + w, y});
    path.line({x + w, y + h});
    path.line({x, y + h});
    return path.close();
  }
  const auto side = [&](Point p) {
    if (p != path.here()) path.line(p);
  };
  path.move({x + a, y});
  side({x + w - a, y});
  path.arc(a, b, 0.0, false, true, {x + w, y + b});
  side({x + w, y + h - b});
  path.arc(a, b, 0.0, false, true, {x + w - a, y + h});
  side({x + a, y + h});
  path.arc(a, b, 0.0, false, true, {x, y + h - b});
  side({x, y + b});
  path.arc(a, b, 0.0, false, true, {x + a, y});
  path.close();
}

void add_ellipse(Point center, double rx, double ry, SvgPathBuilder& path) {
  if (!(rx > 0.0) || !(ry > 0.0)) return;
  const Point right{center.x + rx, center.y}, below{center.x, center.y + ry};
  const Point left{center.x - rx, center.y}, above{center.x, center.y - ry};
  path.move(right);
  for (const Point p : {below, left, above, right}) path.arc(rx, ry, 0.0, false, true, p);
  path.close();
}

std::string add_points(std::string_view text, bool closed, SvgPathBuilder& path) {
  SvgPointList list = parse_svg_points(text);
  if (list.points.size() < 2) return list.problem;
  path.move(list.points.front());
  for (std::size_t i = 1; i < list.points.size(); ++i) path.line(list.points[i]);
  if (closed) path.close();
  return list.problem;
}

/// Returns the commands of an attribute `d`, or of CSS: path(evenodd, "M0 0...").
std::string_view path_data(std::string_view text) {
  SvgScan scan(text);
  if (svg_same_word(text, "none")) return {};
  if (!scan.take("path(")) return text;
  const std::size_t begin = text.find_first_of("\"'");
  if (begin == std::string_view::npos) return {};
  const std::size_t end = text.find(text[begin], begin + 1);
  return end == std::string_view::npos ? std::string_view()
                                       : text.substr(begin + 1, end - begin - 1);
}

}  // namespace

bool is_svg_shape(std::string_view name) noexcept {
  return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

SvgOutline svg_outline(std::string_view name, const pugi::xml_node& node,
                       const SvgDeclared& declared, const SvgUnits& units,
                       std::size_t max_segments) {
  SvgOutline outline;
  if (name == "path") {
    SvgPathData data = parse_svg_path(path_data(declared[SvgProperty::kD]), max_segments,
                                      limits::kMaxSvgPathNumber);
    return {std::move(data.contours), std::move(data.problem)};
  }
  SvgPathBuilder path(max_segments);
  const Lengths length(node, declared, units, outline.problem);
  const auto x = [&](const char* attribute) { return length(attribute, SvgAxis::kX); };
  const auto y = [&](const char* attribute) { return length(attribute, SvgAxis::kY); };
  if (name == "rect") {
    add_rect(length, path);
  } else if (name == "circle") {
    const double r = length("r", SvgAxis::kDiagonal);
    add_ellipse({x("cx"), y("cy")}, r, r, path);
  } else if (name == "ellipse") {
    const std::optional<double> rx = length.radius("rx", SvgAxis::kX);
    const std::optional<double> ry = length.radius("ry", SvgAxis::kY);
    add_ellipse({x("cx"), y("cy")}, rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0)),
                path);
  } else if (name == "line") {
    path.move({x("x1"), y("y1")});
    path.line({x("x2"), y("y2")});
  } else {
    outline.problem = add_points(node.attribute("points").value(), name == "polygon", path);
  }
  if (path.full()) outline.problem = "too many curves";
  outline.contours = path.take();
  return outline;
}

}  // namespace felt
