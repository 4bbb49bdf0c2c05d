#include "felt/io/svg/svg_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/io/svg/svg_color_names.h"
#include "felt/io/svg/svg_color_spaces.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

std::uint8_t channel(double share) noexcept {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// "#rgba", which the rest of the house does not have, as "#rrggbbaa".
std::optional<Rgba> hex_color(std::string_view text) {
  if (text.size() != 5) return color_from_text(text);
  std::string doubled = "#";
  for (const char c : text.substr(1)) doubled.append(2, c);
  return color_from_text(doubled);
}

/// A number of a colour function and whether it was a percentage.
struct Argument {
  double value = 0.0;
  bool percent = false;
};

/// The arguments up to the closing parenthesis; false where they are not 3 or 4 numbers.
bool color_arguments(SvgScan& scan, std::array<Argument, 4>& v, std::size_t& n) {
  for (n = 0; n < v.size(); ++n) {
    scan.skip_spaces();
    if (scan.take(')')) break;
    if (!scan.number(v[n].value)) return false;
    v[n].percent = scan.take('%');
    if (n == 0 && scan.take("turn")) v[n].value *= 360.0;
    if (n == 0 && scan.take("rad")) v[n].value *= 57.295779513082323;
    if (n == 0) scan.take("deg");
    scan.skip_comma();
    if (n == 2) scan.take('/');
  }
  scan.skip_spaces();
  if (n == v.size() && !scan.take(')')) return false;
  return n >= 3;
}

double alpha_of(const std::array<Argument, 4>& v, std::size_t n) noexcept {
  if (n < 4) return 1.0;
  return v[3].percent ? v[3].value / 100.0 : v[3].value;
}

std::optional<Rgba> rgb_color(const std::array<Argument, 4>& v, std::size_t n) {
  if (v[0].percent != v[1].percent || v[1].percent != v[2].percent) return std::nullopt;
  const auto share = [](const Argument& a) {
    return a.percent ? a.value / 100.0 : a.value / 255.0;
  };
  return Rgba{channel(share(v[0])), channel(share(v[1])), channel(share(v[2])),
              channel(alpha_of(v, n))};
}

/// CSS Color 3, 4.2.4.
std::optional<Rgba> hsl_color(const std::array<Argument, 4>& v, std::size_t n) {
  if (!v[1].percent || !v[2].percent) return std::nullopt;
  double hue = std::fmod(v[0].value, 360.0);
  if (hue < 0.0) hue += 360.0;
  const double saturation = std::clamp(v[1].value / 100.0, 0.0, 1.0);
  const double light = std::clamp(v[2].value / 100.0, 0.0, 1.0);
  const double reach = saturation * std::min(light, 1.0 - light);
  const auto part = [&](double shift) {
    const double k = std::fmod(shift + hue / 30.0, 12.0);
    return light - reach * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
  };
  return Rgba{channel(part(0.0)), channel(part(8.0)), channel(part(4.0)), channel(alpha_of(v, n))};
}

/// A colour at the front of `scan`; what follows stays.
std::optional<Rgba> take_color(SvgScan& scan) {
  if (scan.peek() == '#') {
    const std::string_view from = scan.rest();
    scan.take('#');
    return hex_color(from.substr(0, 1 + scan.name().size()));
  }
  const std::string_view name = scan.name();
  if (scan.take('(')) {
    std::array<Argument, 4> v{};
    std::size_t n = 0;
    if (!color_arguments(scan, v, n)) return std::nullopt;
    if (svg_same_word(name, "rgb") || svg_same_word(name, "rgba")) return rgb_color(v, n);
    if (svg_same_word(name, "hsl") || svg_same_word(name, "hsla")) return hsl_color(v, n);
    return std::nullopt;
  }
  if (svg_same_word(name, "transparent")) return Rgba{0, 0, 0, 0};
  for (const SvgColorName& known : kSvgColorNames) {
    if (!svg_same_word(known.name, name)) continue;
    return Rgba{static_cast<std::uint8_t>(known.rgb >> 16),
                static_cast<std::uint8_t>(known.rgb >> 8 & 0xff),
                static_cast<std::uint8_t>(known.rgb & 0xff), 255};
  }
  return std::nullopt;
}

/// "url(#id)" at the front, with or without quotes.
std::optional<std::string_view> take_reference(SvgScan& scan) {
  if (!scan.take("url(")) return std::nullopt;
  std::string_view id = svg_trimmed(scan.until(')'));
  if (id.size() >= 2 && (id.front() == '"' || id.front() == '\'') && id.back() == id.front()) {
    id = svg_trimmed(id.substr(1, id.size() - 2));
  }
  if (id.empty() || id.front() != '#') return std::string_view();
  return id.substr(1);
}

/// A colour with nothing behind it but another form of the same, for printing.
std::optional<Rgba> whole_color(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  const std::optional<Rgba> color = take_color(scan);
  if (!color) return svg_color_in_space(text);
  if (color && !scan.at_end() && !scan.take("icc-color(")) return std::nullopt;
  return color;
}

/// A paint that is in no other element.
std::optional<SvgPaint> plain_paint(std::string_view text) {
  SvgPaint paint;
  if (svg_same_word(text, "none")) return paint;
  paint.kind = SvgPaint::Kind::kCurrent;
  if (svg_same_word(text, "currentColor")) return paint;
  paint.kind = SvgPaint::Kind::kContextFill;
  if (text == "context-fill") return paint;
  paint.kind = SvgPaint::Kind::kContextStroke;
  if (text == "context-stroke") return paint;
  const std::optional<Rgba> color = whole_color(text);
  if (!color) return std::nullopt;
  paint.kind = SvgPaint::Kind::kColor;
  paint.color = *color;
  return paint;
}

}  // namespace

std::optional<Rgba> svg_color(std::string_view text) {
  return whole_color(text);
}

std::optional<SvgPaint> svg_paint(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  const std::optional<std::string_view> server = take_reference(scan);
  if (!server) return plain_paint(svg_trimmed(text));
  SvgPaint paint;
  paint.kind = SvgPaint::Kind::kServer;
  paint.server = *server;
  if (scan.at_end()) return paint;
  if (const std::optional<SvgPaint> fallback = plain_paint(svg_trimmed(scan.rest()))) {
    paint.fallback = fallback->kind;
    paint.fallback_color = fallback->color;
  }
  return paint;
}

std::string_view svg_reference(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  return take_reference(scan).value_or(std::string_view());
}

std::optional<double> svg_share(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  double value = 0.0;
  if (!scan.number(value)) return std::nullopt;
  if (scan.take('%')) value /= 100.0;
  if (!scan.empty()) return std::nullopt;
  return std::clamp(value, 0.0, 1.0);
}

Rgba svg_faded(Rgba color, double share) noexcept {
  color.a = static_cast<std::uint8_t>(std::lround(color.a * std::clamp(share, 0.0, 1.0)));
  return color;
}

}  // namespace felt
