#include "felt/io/svg/svg_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_variables.h"

namespace felt {
namespace {

struct Unit {
  std::string_view name;
  double mm;
};

/// Units that do not depend on the context.
constexpr std::array<Unit, 6> kPaperUnits{{{"px", kSvgMmPerPx},
                                           {"pt", 25.4 / 72.0},
                                           {"pc", 25.4 / 6.0},
                                           {"mm", 1.0},
                                           {"cm", 10.0},
                                           {"in", 25.4}}};

std::optional<double> paper_unit_mm(std::string_view name) {
  for (const Unit& u : kPaperUnits) {
    if (svg_same_word(u.name, name)) return u.mm;
  }
  if (svg_same_word("q", name)) return 0.25;
  return std::nullopt;
}

/// Returns the size of a relative unit.
std::optional<double> relative_unit(std::string_view name, const SvgUnits& u) {
  if (svg_same_word(name, "em")) return u.font_size;
  if (svg_same_word(name, "ex") || svg_same_word(name, "ch")) return 0.5 * u.font_size;
  if (svg_same_word(name, "rem")) return u.root_font_size;
  if (svg_same_word(name, "vw") || svg_same_word(name, "vi")) return 0.01 * u.root_width;
  if (svg_same_word(name, "vh") || svg_same_word(name, "vb")) return 0.01 * u.root_height;
  if (svg_same_word(name, "vmin")) return 0.01 * std::min(u.root_width, u.root_height);
  if (svg_same_word(name, "vmax")) return 0.01 * std::max(u.root_width, u.root_height);
  return std::nullopt;
}

double percent_base(SvgAxis axis, const SvgUnits& u) {
  if (axis == SvgAxis::kX) return u.view_width;
  if (axis == SvgAxis::kY) return u.view_height;
  return std::hypot(u.view_width, u.view_height) / std::numbers::sqrt2;
}

/// Reads an argument of a transform in user units or degrees. In CSS it is followed by a unit.
bool transform_argument(SvgScan& scan, double& value) {
  if (!scan.number(value)) return false;
  const std::string_view unit = scan.letters();
  if (unit.empty() || svg_same_word(unit, "px") || svg_same_word(unit, "deg")) return true;
  if (const std::optional<double> mm = paper_unit_mm(unit)) {
    value *= *mm / kSvgMmPerPx;
  } else if (svg_same_word(unit, "rad")) {
    value *= 180.0 / std::numbers::pi;
  } else if (svg_same_word(unit, "grad")) {
    value *= 0.9;
  } else if (svg_same_word(unit, "turn")) {
    value *= 360.0;
  } else {
    return false;
  }
  return true;
}

/// Returns the rotation about `center` by an angle in degrees. Quarter turns are exact.
Affine turned(double deg, Point center) {
  const double quarter = std::fmod(deg, 360.0) / 90.0;
  if (quarter != std::floor(quarter)) {
    return rotation(deg * (std::numbers::pi / 180.0), center);
  }
  constexpr std::array<double, 4> kSine{0.0, 1.0, 0.0, -1.0};
  const auto i = static_cast<std::size_t>(static_cast<int>(quarter) + 4) % 4;
  const double sine = kSine[i], cosine = kSine[(i + 1) % 4];
  return about(center, cosine, sine, -sine, cosine);
}

std::optional<Affine> one_transform(std::string_view name, const std::array<double, 6>& v,
                                    std::size_t n) {
  const auto tangent = [](double deg) { return std::tan(deg * (std::numbers::pi / 180.0)); };
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return translation({v[0], n == 2 ? v[1] : 0.0});
  if (name == "translateX" && n == 1) return translation({v[0], 0.0});
  if (name == "translateY" && n == 1) return translation({0.0, v[0]});
  if (name == "scale" && (n == 1 || n == 2)) return scaling(v[0], n == 2 ? v[1] : v[0]);
  if (name == "scaleX" && n == 1) return scaling(v[0], 1.0);
  if (name == "scaleY" && n == 1) return scaling(1.0, v[0]);
  if (name == "rotate" && n == 1) return turned(v[0], {});
  if (name == "rotate" && n == 3) return turned(v[0], {v[1], v[2]});
  if (name == "skewX" && n == 1) return Affine{1.0, 0.0, tangent(v[0]), 1.0, 0.0, 0.0};
  if (name == "skewY" && n == 1) return Affine{1.0, tangent(v[0]), 0.0, 1.0, 0.0, 0.0};
  return std::nullopt;
}

/// Returns the fraction of the free space before the box: xMin 0, xMid 0.5, xMax 1.
double alignment(std::string_view aspect, char axis) {
  const std::size_t at = aspect.find(axis);
  const std::string_view word = at == std::string_view::npos ? "" : aspect.substr(at + 1, 3);
  return word == "Min" ? 0.0 : word == "Max" ? 1.0 : 0.5;
}

bool is_vertical(std::string_view word) {
  return svg_same_word(word, "top") || svg_same_word(word, "bottom");
}

/// Reads one coordinate of transform-origin.
double origin_part(std::string_view word, SvgAxis axis, const SvgUnits& units) {
  if (svg_same_word(word, "left") || svg_same_word(word, "top")) word = "0%";
  if (svg_same_word(word, "center")) word = "50%";
  if (svg_same_word(word, "right") || svg_same_word(word, "bottom")) word = "100%";
  return svg_length(word, axis, units).value_or(0.0);
}

}  // namespace

std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgUnits& units) {
  if (SvgScan calc(svg_trimmed(text)); calc.take("calc(")) {
    const std::string_view whole = svg_trimmed(text);
    return svg_calc(whole, [&](std::string_view one) { return svg_length(one, axis, units); });
  }
  SvgScan scan(svg_trimmed(text));
  double value = 0.0;
  if (!scan.number(value)) return std::nullopt;
  if (scan.empty()) return value;
  const std::string_view unit = scan.rest();
  double factor = 0.0;
  if (unit == "%") {
    factor = 0.01 * percent_base(axis, units);
  } else if (const std::optional<double> mm = paper_unit_mm(unit)) {
    factor = *mm / kSvgMmPerPx;
  } else if (const std::optional<double> size = relative_unit(unit, units)) {
    factor = *size;
  } else {
    return std::nullopt;
  }
  const double length = value * factor;
  return std::fabs(length) <= 1e12 ? std::optional(length) : std::nullopt;
}

std::optional<double> svg_paper_mm(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  double value = 0.0;
  if (!scan.number(value)) return std::nullopt;
  if (scan.empty()) return value * kSvgMmPerPx;
  if (const std::optional<double> mm = paper_unit_mm(scan.rest())) return value * *mm;
  const std::optional<double> size = relative_unit(scan.rest(), SvgUnits{});
  if (!size || !(*size > 0.0)) return std::nullopt;
  return value * *size * kSvgMmPerPx;
}

std::optional<Rect> svg_view_box(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  std::array<double, 4> v{};
  for (double& value : v) {
    if (!scan.number(value)) return std::nullopt;
    scan.skip_comma();
  }
  if (!scan.at_end() || !(v[2] > 0.0) || !(v[3] > 0.0)) return std::nullopt;
  return Rect{v[0], v[1], v[0] + v[2], v[1] + v[3]};
}

Affine svg_view_transform(const Rect& box, double width, double height, std::string_view aspect) {
  double sx = width / box.width(), sy = height / box.height();
  aspect = svg_trimmed(aspect);
  if (aspect.substr(0, 5) == "defer") aspect = svg_trimmed(aspect.substr(5));
  if (aspect.substr(0, 4) == "none") return {sx, 0.0, 0.0, sy, -sx * box.x0, -sy * box.y0};
  const bool slice = aspect.find("slice") != std::string_view::npos;
  // If the scales differ only by rounding they become equal, so that a millimetre stays exact.
  if (std::fabs(sx - sy) > 1e-12 * std::fabs(sx)) sx = slice ? std::max(sx, sy) : std::min(sx, sy);
  sy = sx;
  const double free_x = width - sx * box.width(), free_y = height - sy * box.height();
  return {sx,
          0.0,
          0.0,
          sy,
          alignment(aspect, 'x') * free_x - sx * box.x0,
          alignment(aspect, 'Y') * free_y - sy * box.y0};
}

std::optional<Affine> svg_transform(std::string_view text) {
  Affine all;
  SvgScan scan(text);
  if (svg_same_word(svg_trimmed(text), "none")) return all;
  while (!scan.at_end()) {
    const std::string_view name = scan.name();
    scan.skip_spaces();
    if (!scan.take('(')) return std::nullopt;
    std::array<double, 6> v{};
    std::size_t n = 0;
    scan.skip_spaces();
    while (!scan.take(')')) {
      if (n == v.size() || !transform_argument(scan, v[n++])) return std::nullopt;
      scan.skip_comma();
    }
    const std::optional<Affine> one = one_transform(name, v, n);
    if (!one) return std::nullopt;
    all = then(*one, all);  // the last transform of the list applies first
    scan.skip_comma();
  }
  constexpr double kMax = 1e38;
  for (const double v : {all.a, all.b, all.c, all.d, all.e, all.f}) {
    if (!(std::fabs(v) <= kMax)) return std::nullopt;
  }
  return all;
}

Vec svg_transform_origin(std::string_view text, const SvgUnits& units) {
  SvgScan scan(svg_trimmed(text));
  std::array<std::string_view, 2> words{};
  for (std::string_view& word : words) {
    const std::string_view from = scan.rest();
    while (!scan.empty() && !is_svg_space(scan.peek())) scan.take(scan.peek());
    word = from.substr(0, from.size() - scan.rest().size());
    scan.skip_spaces();
  }
  if (words[0].empty()) return {};
  if (words[1].empty()) words[1] = "center";
  if (is_vertical(words[0]) || svg_same_word(words[1], "left") ||
      svg_same_word(words[1], "right")) {
    std::swap(words[0], words[1]);
  }
  return {origin_part(words[0], SvgAxis::kX, units), origin_part(words[1], SvgAxis::kY, units)};
}

}  // namespace felt
