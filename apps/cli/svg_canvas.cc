#include "svg_canvas.h"

#include <fmt/core.h>

#include "felt/stroke/color_text.h"

namespace felt::cli {
namespace {

constexpr double kCapitalHeight = 0.729;  // of DejaVu Sans, of the font size
constexpr double kMeanAdvance = 0.6;      // of a letter, of the font size
constexpr double kHaloWeight = 2.0;       // a font that is heavier is a halo

std::string paint(const char* property, Rgba color) {
  const std::string opaque = color_to_text({color.r, color.g, color.b, 255});
  if (color.a == 255) return fmt::format(" {}=\"{}\"", property, opaque);
  return fmt::format(" {0}=\"{1}\" {0}-opacity=\"{2:.2f}\"", property, opaque, color.a / 255.0);
}

std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    if (c == '<') {
      xml += "&lt;";
    } else if (c == '&') {
      xml += "&amp;";
    } else {
      xml += c;
    }
  }
  return xml;
}

const char* anchor_of(PlotAlign align) {
  switch (align) {
    case PlotAlign::kLeft:
      break;
    case PlotAlign::kCenter:
      return " text-anchor=\"middle\"";
    case PlotAlign::kRight:
      return " text-anchor=\"end\"";
  }
  return "";
}

}  // namespace

void SvgCanvas::polyline(std::span<const Vec> points, const PlotPen& pen) {
  if (points.size() < 2) return;
  out_ += "<polyline fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
  out_ += paint("stroke", pen.color);
  out_ += fmt::format(" stroke-width=\"{:.2f}\"", pen.width);
  if (pen.on > 0.0) out_ += fmt::format(" stroke-dasharray=\"{:.2f} {:.2f}\"", pen.on, pen.off);
  out_ += " points=\"";
  for (const Vec p : points) out_ += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
  out_.back() = '"';
  out_ += "/>\n";
}

void SvgCanvas::text(Vec at, std::string_view text, const PlotFont& font) {
  out_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"DejaVu Sans, sans-serif\" "
      "font-size=\"{:.2f}\"{}{}",
      at.x, at.y, font.size / kCapitalHeight, anchor_of(font.align), paint("fill", font.color));
  if (font.weight > kHaloWeight) {
    out_ += paint("stroke", font.color) + fmt::format(" stroke-width=\"{:.2f}\"", font.weight);
  }
  out_ += ">" + escaped(text) + "</text>\n";
}

double SvgCanvas::text_width(std::string_view text, double size) noexcept {
  return static_cast<double>(text.size()) * size * kMeanAdvance / kCapitalHeight;
}

}  // namespace felt::cli
