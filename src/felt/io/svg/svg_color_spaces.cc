#include "felt/io/svg/svg_color_spaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "felt/io/svg/svg_color.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr int kMaxColorNesting = 8;  // of light-dark() and color-mix()

Triple times(const Matrix& m, const Triple& v) noexcept {
  Triple r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

// Matrices: W3C CSS Color Module Level 4, section 18 (sample code for conversions).
constexpr Matrix kXyzToSrgb{{{3.2409699419045226, -1.5373831775700939, -0.49861076029300355},
                             {-0.9692436362808796, 1.8759675015077202, 0.04155505740717561},
                             {0.05563007969699366, -0.20397695888897652, 1.0569715142428786}}};
constexpr Matrix kP3ToXyz{{{0.48657094864821615, 0.26566769316909306, 0.19821728523436247},
                           {0.2289745640697488, 0.6917385218365064, 0.079286914093745},
                           {0.0, 0.04511338185890264, 1.043944368900976}}};
constexpr Matrix kD50ToD65{{{0.955473421488075, -0.02309845494876471, 0.06325924320057072},
                            {-0.0283697093338637, 1.0099953980813041, 0.021041441191917323},
                            {0.012314014864481998, -0.020507649298898964, 1.330365926242124}}};
constexpr Matrix kOklabToLms{{{1.0, 0.3963377773761749, 0.2158037573099136},
                              {1.0, -0.1055613458156586, -0.0638541728258133},
                              {1.0, -0.0894841775298119, -1.2914855480194092}}};
constexpr Matrix kLmsToXyz{{{1.2268798758459243, -0.5578149944602171, 0.2813910456659647},
                            {-0.0405757452148008, 1.112286803280317, -0.0717110580655164},
                            {-0.0763729366746601, -0.4214933324022432, 1.5869240198367816}}};

double encoded(double linear) noexcept {
  const double size = std::fabs(linear);
  const double value = size > 0.0031308 ? 1.055 * std::pow(size, 1.0 / 2.4) - 0.055 : 12.92 * size;
  return std::copysign(value, linear);
}

double decoded(double value) noexcept {
  const double size = std::fabs(value);
  const double linear = size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4);
  return std::copysign(linear, value);
}

std::uint8_t byte_of(double share) noexcept {
  if (std::isnan(share)) return 0;
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

Rgba from_srgb(const Triple& c, double alpha) noexcept {
  return {byte_of(c[0]), byte_of(c[1]), byte_of(c[2]), byte_of(alpha)};
}

Rgba from_linear(const Triple& c, double alpha) noexcept {
  return from_srgb({encoded(c[0]), encoded(c[1]), encoded(c[2])}, alpha);
}

Rgba from_xyz(const Triple& xyz, double alpha) noexcept {
  return from_linear(times(kXyzToSrgb, xyz), alpha);
}

Rgba from_lab(const Triple& lab, double alpha) noexcept {
  constexpr double kKappa = 24389.0 / 27.0, kEpsilon = 216.0 / 24389.0;
  const double fy = (lab[0] + 16.0) / 116.0, fx = lab[1] / 500.0 + fy, fz = fy - lab[2] / 200.0;
  const auto part = [&](double f) {
    return f * f * f > kEpsilon ? f * f * f : (116.0 * f - 16.0) / kKappa;
  };
  const double y = lab[0] > kKappa * kEpsilon ? fy * fy * fy : lab[0] / kKappa;
  const Triple d50{0.9642956764295677 * part(fx), y, 0.8251046025104602 * part(fz)};
  return from_xyz(times(kD50ToD65, d50), alpha);
}

Rgba from_oklab(const Triple& lab, double alpha) noexcept {
  Triple lms = times(kOklabToLms, lab);
  for (double& v : lms) v = v * v * v;
  return from_xyz(times(kLmsToXyz, lms), alpha);
}

/// Converts lightness, chroma and hue to lightness and two axes.
Triple from_polar(const Triple& lch) noexcept {
  const double hue = lch[2] * (std::numbers::pi / 180.0);
  return {lch[0], lch[1] * std::cos(hue), lch[1] * std::sin(hue)};
}

Rgba from_hwb(const Triple& hwb, double alpha) noexcept {
  const double white = hwb[1], black = hwb[2];
  if (white + black >= 1.0) {
    const double grey = white / (white + black);
    return from_srgb({grey, grey, grey}, alpha);
  }
  const auto part = [&](double shift) {
    double k = std::fmod(shift + hwb[0] / 30.0, 12.0);
    if (k < 0.0) k += 12.0;
    const double pure = 0.5 - 0.5 * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
    return white + pure * (1.0 - white - black);
  };
  return from_srgb({part(0.0), part(8.0), part(4.0)}, alpha);
}

/// Reads three components, then "/ alpha". 100 % of a component is the value of that component in
/// `full`.
bool components(SvgScan& scan, const Triple& full, Triple& v, double& alpha) {
  for (std::size_t i = 0; i < 3; ++i) {
    scan.skip_comma();
    if (scan.take("none")) {
      v[i] = 0.0;
      continue;
    }
    if (!scan.number(v[i])) return false;
    if (scan.take('%')) v[i] *= full[i] / 100.0;
    if (scan.take("turn")) v[i] *= 360.0;
    if (scan.take("grad")) v[i] *= 0.9;
    if (scan.take("rad")) v[i] *= 180.0 / std::numbers::pi;
    scan.take("deg");
  }
  scan.skip_spaces();
  if (!scan.take('/')) return scan.at_end();
  const std::optional<double> share = svg_share(svg_trimmed(scan.rest()));
  alpha = share.value_or(1.0);
  return share.has_value();
}

std::optional<Rgba> color_function(SvgScan& scan) {
  scan.skip_spaces();
  const std::string_view space = scan.name();
  Triple v{};
  double alpha = 1.0;
  if (!components(scan, {1.0, 1.0, 1.0}, v, alpha)) return std::nullopt;
  if (space == "srgb") return from_srgb(v, alpha);
  if (space == "srgb-linear") return from_linear(v, alpha);
  if (space == "xyz" || space == "xyz-d65") return from_xyz(v, alpha);
  if (space == "xyz-d50") return from_xyz(times(kD50ToD65, v), alpha);
  if (space == "display-p3") {
    return from_xyz(times(kP3ToXyz, {decoded(v[0]), decoded(v[1]), decoded(v[2])}), alpha);
  }
  return std::nullopt;
}

/// Returns the position of the first comma outside parentheses, or the end.
std::size_t comma_of(std::string_view text) noexcept {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (text[i] == ',' && depth == 0) return i;
  }
  return text.size();
}

/// A colour of color-mix() with its percentage: "red 30%" or "30% red".
struct Mixed {
  Rgba color;
  std::optional<double> share;
};
std::optional<Mixed> mixed_color(std::string_view text) {
  text = svg_trimmed(text);
  Mixed mixed;
  SvgScan scan(text);
  double number = 0.0;
  if (scan.at_number() && scan.number(number) && scan.take('%')) {
    mixed.share = number / 100.0;
    text = svg_trimmed(scan.rest());
  } else if (!text.empty() && text.back() == '%') {
    const std::size_t space = text.find_last_of(" \t\n");
    if (space == std::string_view::npos) return std::nullopt;
    mixed.share = svg_share(text.substr(space + 1));
    text = svg_trimmed(text.substr(0, space));
  }
  const std::optional<Rgba> color = svg_color(text);
  if (!color) return std::nullopt;
  mixed.color = *color;
  return mixed;
}

std::optional<Rgba> color_mix(std::string_view text) {
  const std::size_t in = comma_of(text);
  if (!svg_same_word(svg_trimmed(text).substr(0, 2), "in") || in == text.size()) {
    return std::nullopt;
  }
  text.remove_prefix(in + 1);
  const std::size_t comma = comma_of(text);
  if (comma == text.size()) return std::nullopt;
  const std::optional<Mixed> a = mixed_color(text.substr(0, comma));
  const std::optional<Mixed> b = mixed_color(text.substr(comma + 1));
  if (!a || !b) return std::nullopt;
  double of_a = a->share.value_or(b->share ? 1.0 - *b->share : 0.5);
  double of_b = b->share.value_or(1.0 - of_a);
  const double sum = of_a + of_b;
  if (!(sum > 0.0)) return std::nullopt;
  const double faded = std::min(sum, 1.0);
  of_a /= sum;
  of_b /= sum;
  const double alpha = of_a * a->color.a + of_b * b->color.a;  // premultiplied, as CSS requires
  const auto part = [&](std::uint8_t x, std::uint8_t y) {
    return alpha > 0.0 ? (of_a * a->color.a * x + of_b * b->color.a * y) / alpha / 255.0 : 0.0;
  };
  return from_srgb(
      {part(a->color.r, b->color.r), part(a->color.g, b->color.g), part(a->color.b, b->color.b)},
      alpha / 255.0 * faded);
}

/// Returns a system colour (CSS Color 4, section 10) with its value in a light theme.
std::optional<Rgba> system_color(std::string_view name) {
  constexpr std::array<std::string_view, 4> kWhite{"Canvas", "Field", "HighlightText",
                                                   "AccentColorText"};
  constexpr std::array<std::string_view, 7> kBlack{"CanvasText",   "FieldText", "ButtonText",
                                                   "ButtonBorder", "MarkText",  "WindowText",
                                                   "InfoText"};
  const auto is = [&](std::string_view known) { return svg_same_word(known, name); };
  if (std::any_of(kBlack.begin(), kBlack.end(), is)) return Rgba{0, 0, 0, 255};
  if (std::any_of(kWhite.begin(), kWhite.end(), is)) return Rgba{255, 255, 255, 255};
  if (is("GrayText")) return Rgba{128, 128, 128, 255};
  if (is("LinkText")) return Rgba{0, 0, 238, 255};
  if (is("VisitedText")) return Rgba{85, 26, 139, 255};
  if (is("Highlight") || is("AccentColor")) return Rgba{0, 120, 215, 255};
  return std::nullopt;
}

bool is_too_nested(std::string_view text) noexcept {
  return std::count(text.begin(), text.end(), '(') > kMaxColorNesting;
}

}  // namespace

std::optional<Rgba> svg_color_in_space(std::string_view text) {
  text = svg_trimmed(text);
  SvgScan scan(text);
  const std::string_view name = scan.name();
  if (scan.empty()) return system_color(name);
  if (!scan.take('(') || text.back() != ')' || is_too_nested(text)) return std::nullopt;
  const std::string_view inside = scan.rest().substr(0, scan.rest().size() - 1);
  if (svg_same_word(name, "light-dark")) return svg_color(inside.substr(0, comma_of(inside)));
  if (svg_same_word(name, "color-mix")) return color_mix(inside);
  SvgScan arguments(inside);
  if (svg_same_word(name, "color")) return color_function(arguments);
  Triple v{};
  double alpha = 1.0;
  const auto take = [&](const Triple& full) { return components(arguments, full, v, alpha); };
  if (svg_same_word(name, "lab") && take({100.0, 125.0, 125.0})) return from_lab(v, alpha);
  if (svg_same_word(name, "lch") && take({100.0, 150.0, 360.0})) {
    return from_lab(from_polar(v), alpha);
  }
  if (svg_same_word(name, "oklab") && take({1.0, 0.4, 0.4})) return from_oklab(v, alpha);
  if (svg_same_word(name, "oklch") && take({1.0, 0.4, 360.0})) {
    return from_oklab(from_polar(v), alpha);
  }
  // Numbers without a percent sign are also percentages.
  if (svg_same_word(name, "hwb") && take({360.0, 100.0, 100.0})) {
    return from_hwb({v[0], v[1] / 100.0, v[2] / 100.0}, alpha);
  }
  return std::nullopt;
}

}  // namespace felt
