#include "felt/io/svg/svg_servers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/io/svg/svg_document.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_style.h"

namespace felt {
namespace {

constexpr int kMostLinks = 16;
/// Among which the stops have to be: every shape may ask again.
constexpr int kMostChildren = 100;

/// The mean of a gradient, from stop to stop: colours are weighted by how much of them is seen.
class GradientMean {
 public:
  void add(double offset, Rgba color) {
    offset = std::clamp(offset, at_, 1.0);
    if (is_first_)
      add_span(offset, color, color);
    else
      add_span(offset - at_, last_, color);
    is_first_ = false;
    at_ = offset;
    last_ = color;
  }

  [[nodiscard]] std::optional<Rgba> color() {
    if (is_first_) return std::nullopt;
    add_span(1.0 - at_, last_, last_);
    at_ = 1.0;
    const auto byte = [](double value) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    if (!(alpha_ > 0.0)) return Rgba{last_.r, last_.g, last_.b, 0};
    return Rgba{byte(sum_[0] / alpha_), byte(sum_[1] / alpha_), byte(sum_[2] / alpha_),
                byte(alpha_)};
  }

 private:
  /// Half of the span in each colour: the mean of a straight change.
  void add_span(double length, Rgba a, Rgba b) {
    for (const Rgba c : {a, b}) {
      const double weight = 0.5 * length * c.a;
      alpha_ += weight;
      sum_[0] += weight * c.r;
      sum_[1] += weight * c.g;
      sum_[2] += weight * c.b;
    }
  }

  std::array<double, 3> sum_{};
  double alpha_ = 0.0, at_ = 0.0;
  Rgba last_{};
  bool is_first_ = true;
};

Rgba stop_color(SvgDocument& document, const pugi::xml_node& stop, Rgba current) {
  SvgDeclared declared;
  std::string clean;
  static_cast<void>(svg_declared(stop, document.sheet(), clean, declared));
  const std::string_view text = declared[SvgProperty::kStopColor];
  Rgba color{0, 0, 0, 255};
  if (svg_same_word(text, "currentColor")) {
    color = svg_color(declared[SvgProperty::kColor]).value_or(current);
  } else if (const std::optional<Rgba> said = svg_color(text)) {
    color = *said;
  }
  return svg_faded(color, svg_share(declared[SvgProperty::kStopOpacity]).value_or(1.0));
}

Rgba solid_color(SvgDocument& document, const pugi::xml_node& node, Rgba current) {
  SvgDeclared declared;
  std::string clean;
  static_cast<void>(svg_declared(node, document.sheet(), clean, declared));
  const std::string_view text = declared[SvgProperty::kSolidColor];
  if (svg_same_word(text, "currentColor")) return current;
  const double opacity = svg_share(node.attribute("solid-opacity").value()).value_or(1.0);
  return svg_faded(svg_color(text).value_or(Rgba{0, 0, 0, 255}), opacity);
}

}  // namespace

SvgServerColor svg_server_color(SvgDocument& document, std::string_view id, Rgba current) {
  SvgServerColor result;
  for (int links = 0; links < kMostLinks; ++links) {
    const pugi::xml_node node = document.find(id);
    const std::string_view name = document.svg_name(node, true);
    if (name == "pattern" || name == "hatch" || name == "mesh" || name == "meshgradient") {
      result.paints = true;
      result.color = Rgba{128, 128, 128, 255};
      return result;
    }
    if (name == "solidColor" || name == "solidcolor") {
      result.paints = result.is_solid = true;
      result.color = solid_color(document, node, current);
      return result;
    }
    if (name != "linearGradient" && name != "radialGradient") return result;
    result.paints = result.is_gradient = true;
    int children = 0;
    GradientMean mean;
    for (const pugi::xml_node child : node.children()) {
      if (++children > kMostChildren) break;
      if (document.svg_name(child, true) != "stop") continue;
      mean.add(svg_share(child.attribute("offset").value()).value_or(0.0),
               stop_color(document, child, current));
    }
    result.color = mean.color();
    if (result.color) return result;
    const std::string_view next = svg_href(node);
    if (next.empty() || next.front() != '#') return result;
    id = next.substr(1);
  }
  return result;
}

}  // namespace felt
