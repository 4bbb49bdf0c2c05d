#include "felt/io/svg/svg_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/io/svg/svg_color_spaces.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

/// A colour name of CSS Color 3 (and rebeccapurple of CSS Color 4), 0xrrggbb.
struct SvgColorName {
  std::string_view name;
  std::uint32_t rgb;
};

/// All colour names in alphabetical order.
inline constexpr std::array<SvgColorName, 148> kSvgColorNames{{{"aliceblue", 0xf0f8ff},
                                                               {"antiquewhite", 0xfaebd7},
                                                               {"aqua", 0x00ffff},
                                                               {"aquamarine", 0x7fffd4},
                                                               {"azure", 0xf0ffff},
                                                               {"beige", 0xf5f5dc},
                                                               {"bisque", 0xffe4c4},
                                                               {"black", 0x000000},
                                                               {"blanchedalmond", 0xffebcd},
                                                               {"blue", 0x0000ff},
                                                               {"blueviolet", 0x8a2be2},
                                                               {"brown", 0xa52a2a},
                                                               {"burlywood", 0xdeb887},
                                                               {"cadetblue", 0x5f9ea0},
                                                               {"chartreuse", 0x7fff00},
                                                               {"chocolate", 0xd2691e},
                                                               {"coral", 0xff7f50},
                                                               {"cornflowerblue", 0x6495ed},
                                                               {"cornsilk", 0xfff8dc},
                                                               {"crimson", 0xdc143c},
                                                               {"cyan", 0x00ffff},
                                                               {"darkblue", 0x00008b},
                                                               {"darkcyan", 0x008b8b},
                                                               {"darkgoldenrod", 0xb8860b},
                                                               {"darkgray", 0xa9a9a9},
                                                               {"darkgreen", 0x006400},
                                                               {"darkgrey", 0xa9a9a9},
                                                               {"darkkhaki", 0xbdb76b},
                                                               {"darkmagenta", 0x8b008b},
                                                               {"darkolivegreen", 0x556b2f},
                                                               {"darkorange", 0xff8c00},
                                                               {"darkorchid", 0x9932cc},
                                                               {"darkred", 0x8b0000},
                                                               {"darksalmon", 0xe9967a},
                                                               {"darkseagreen", 0x8fbc8f},
                                                               {"darkslateblue", 0x483d8b},
                                                               {"darkslategray", 0x2f4f4f},
                                                               {"darkslategrey", 0x2f4f4f},
                                                               {"darkturquoise", 0x00ced1},
                                                               {"darkviolet", 0x9400d3},
                                                               {"deeppink", 0xff1493},
                                                               {"deepskyblue", 0x00bfff},
                                                               {"dimgray", 0x696969},
                                                               {"dimgrey", 0x696969},
                                                               {"dodgerblue", 0x1e90ff},
                                                               {"firebrick", 0xb22222},
                                                               {"floralwhite", 0xfffaf0},
                                                               {"forestgreen", 0x228b22},
                                                               {"fuchsia", 0xff00ff},
                                                               {"gainsboro", 0xdcdcdc},
                                                               {"ghostwhite", 0xf8f8ff},
                                                               {"gold", 0xffd700},
                                                               {"goldenrod", 0xdaa520},
                                                               {"gray", 0x808080},
                                                               {"green", 0x008000},
                                                               {"greenyellow", 0xadff2f},
                                                               {"grey", 0x808080},
                                                               {"honeydew", 0xf0fff0},
                                                               {"hotpink", 0xff69b4},
                                                               {"indianred", 0xcd5c5c},
                                                               {"indigo", 0x4b0082},
                                                               {"ivory", 0xfffff0},
                                                               {"khaki", 0xf0e68c},
                                                               {"lavender", 0xe6e6fa},
                                                               {"lavenderblush", 0xfff0f5},
                                                               {"lawngreen", 0x7cfc00},
                                                               {"lemonchiffon", 0xfffacd},
                                                               {"lightblue", 0xadd8e6},
                                                               {"lightcoral", 0xf08080},
                                                               {"lightcyan", 0xe0ffff},
                                                               {"lightgoldenrodyellow", 0xfafad2},
                                                               {"lightgray", 0xd3d3d3},
                                                               {"lightgreen", 0x90ee90},
                                                               {"lightgrey", 0xd3d3d3},
                                                               {"lightpink", 0xffb6c1},
                                                               {"lightsalmon", 0xffa07a},
                                                               {"lightseagreen", 0x20b2aa},
                                                               {"lightskyblue", 0x87cefa},
                                                               {"lightslategray", 0x778899},
                                                               {"lightslategrey", 0x778899},
                                                               {"lightsteelblue", 0xb0c4de},
                                                               {"lightyellow", 0xffffe0},
                                                               {"lime", 0x00ff00},
                                                               {"limegreen", 0x32cd32},
                                                               {"linen", 0xfaf0e6},
                                                               {"magenta", 0xff00ff},
                                                               {"maroon", 0x800000},
                                                               {"mediumaquamarine", 0x66cdaa},
                                                               {"mediumblue", 0x0000cd},
                                                               {"mediumorchid", 0xba55d3},
                                                               {"mediumpurple", 0x9370db},
                                                               {"mediumseagreen", 0x3cb371},
                                                               {"mediumslateblue", 0x7b68ee},
                                                               {"mediumspringgreen", 0x00fa9a},
                                                               {"mediumturquoise", 0x48d1cc},
                                                               {"mediumvioletred", 0xc71585},
                                                               {"midnightblue", 0x191970},
                                                               {"mintcream", 0xf5fffa},
                                                               {"mistyrose", 0xffe4e1},
                                                               {"moccasin", 0xffe4b5},
                                                               {"navajowhite", 0xffdead},
                                                               {"navy", 0x000080},
                                                               {"oldlace", 0xfdf5e6},
                                                               {"olive", 0x808000},
                                                               {"olivedrab", 0x6b8e23},
                                                               {"orange", 0xffa500},
                                                               {"orangered", 0xff4500},
                                                               {"orchid", 0xda70d6},
                                                               {"palegoldenrod", 0xeee8aa},
                                                               {"palegreen", 0x98fb98},
                                                               {"paleturquoise", 0xafeeee},
                                                               {"palevioletred", 0xdb7093},
                                                               {"papayawhip", 0xffefd5},
                                                               {"peachpuff", 0xffdab9},
                                                               {"peru", 0xcd853f},
                                                               {"pink", 0xffc0cb},
                                                               {"plum", 0xdda0dd},
                                                               {"powderblue", 0xb0e0e6},
                                                               {"purple", 0x800080},
                                                               {"rebeccapurple", 0x663399},
                                                               {"red", 0xff0000},
                                                               {"rosybrown", 0xbc8f8f},
                                                               {"royalblue", 0x4169e1},
                                                               {"saddlebrown", 0x8b4513},
                                                               {"salmon", 0xfa8072},
                                                               {"sandybrown", 0xf4a460},
                                                               {"seagreen", 0x2e8b57},
                                                               {"seashell", 0xfff5ee},
                                                               {"sienna", 0xa0522d},
                                                               {"silver", 0xc0c0c0},
                                                               {"skyblue", 0x87ceeb},
                                                               {"slateblue", 0x6a5acd},
                                                               {"slategray", 0x708090},
                                                               {"slategrey", 0x708090},
                                                               {"snow", 0xfffafa},
                                                               {"springgreen", 0x00ff7f},
                                                               {"steelblue", 0x4682b4},
                                                               {"tan", 0xd2b48c},
                                                               {"teal", 0x008080},
                                                               {"thistle", 0xd8bfd8},
                                                               {"tomato", 0xff6347},
                                                               {"turquoise", 0x40e0d0},
                                                               {"violet", 0xee82ee},
                                                               {"wheat", 0xf5deb3},
                                                               {"white", 0xffffff},
                                                               {"whitesmoke", 0xf5f5f5},
                                                               {"yellow", 0xffff00},
                                                               {"yellowgreen", 0x9acd32}}};

std::uint8_t channel(double share) noexcept {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// Converts "#rgba", which no other format here has, to "#rrggbbaa".
std::optional<Rgba> hex_color(std::string_view text) {
  if (text.size() != 5) return color_from_text(text);
  std::string doubled = "#";
  for (const char c : text.substr(1)) doubled.append(2, c);
  return color_from_text(doubled);
}

/// An argument of a colour function: a number, or a percentage.
struct Argument {
  double value = 0.0;
  bool percent = false;
};

/// Reads the arguments up to the closing parenthesis. Returns false unless they are 3 or 4 numbers.
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

/// Converts HSL as in CSS Color 3, section 4.2.4.
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

/// Reads a colour at the front of `scan` and leaves the text after it unread.
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

/// Reads "url(#id)" at the front, with or without quotes.
std::optional<std::string_view> take_reference(SvgScan& scan) {
  if (!scan.take("url(")) return std::nullopt;
  std::string_view id = svg_trimmed(scan.until(')'));
  if (id.size() >= 2 && (id.front() == '"' || id.front() == '\'') && id.back() == id.front()) {
    id = svg_trimmed(id.substr(1, id.size() - 2));
  }
  if (id.empty() || id.front() != '#') return std::string_view();
  return id.substr(1);
}

/// Reads a whole text as a colour. The only thing that may follow it is icc-color(...), which is
/// the same colour for printing.
std::optional<Rgba> whole_color(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  const std::optional<Rgba> color = take_color(scan);
  if (!color) return svg_color_in_space(text);
  if (color && !scan.at_end() && !scan.take("icc-color(")) return std::nullopt;
  return color;
}

/// Reads a paint that needs no other element.
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
