#include "felt/io/xopp/xopp_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/io/ink_of_points.h"
#include "felt/io/limits.h"
#include "felt/io/xml/xml_text.h"
#include "felt/io/xopp/xopp_import.h"
#include "felt/stroke/outline/outline.h"

namespace felt {
namespace {

/// Points are written in steps of 0.0001 pt, 35 nm.
constexpr double kStepsPerPoint = 1e4;
/// Largest number of pieces into which one part of a line is divided, even if its width changes
/// very fast.
constexpr double kMaxPieces = 64.0;

void append_points(std::string& out, double mm) {
  const double pt = std::round(mm / kMmPerPoint * kStepsPerPoint) / kStepsPerPoint;
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), pt == 0.0 ? 0.0 : pt,
                                 std::chars_format::fixed)
                       .ptr;
  out.append(text.data(), end);
}

std::string color_text(Rgba c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) {
    text += kDigits[part >> 4];
    text += kDigits[part & 15];
  }
  return text;
}

/// Converts a stroke to a line of pieces that differ little in width from their neighbours.
class WideLine {
 public:
  const std::vector<WidePoint>& sample(const Stroke& stroke) {
    flatten(stroke, kXoppToleranceMm, dabs_);
    line_.clear();
    for (std::size_t i = 0; i < dabs_.size(); ++i) {
      const WidePoint to = {dabs_[i].center, 2.0 * dabs_[i].radius_mm};
      if (i > 0) {
        const WidePoint from = {dabs_[i - 1].center, 2.0 * dabs_[i - 1].radius_mm};
        const double grows = to.width_mm - from.width_mm;
        const int pieces = static_cast<int>(
            std::clamp(std::ceil(std::fabs(grows) / kXoppWidthStepMm), 1.0, kMaxPieces));
        for (int k = 1; k < pieces; ++k) {
          const double t = static_cast<double>(k) / pieces;
          line_.push_back({lerp(from.position, to.position, t), from.width_mm + t * grows});
        }
      }
      line_.push_back(to);
    }
    return line_;
  }

 private:
  std::vector<Dab> dabs_;
  std::vector<WidePoint> line_;
};

/// Part 0 is the head. The other parts contain the strokes. The first part of a layer also contains
/// the start tag of the layer, and the last part its end tag.
class XoppParts final : public DrawingParts {
 public:
  XoppParts(const Drawing& drawing, const std::optional<Rgba>& paper)
      : document_(drawing.document), ranges_(stroke_ranges(drawing.document, LayerChoice::kAll)) {
    head_ =
        "<?xml version=\"1.0\" standalone=\"no\"?>\n"
        "<xournal creator=\"Feltline\" fileversion=\"4\">\n<title>Feltline drawing</title>\n";
    begin_page(drawing, paper);
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    if (i == 0) {
      out.bytes = head_;
      return {};
    }
    const StrokeRange& range = ranges_[i - 1];
    const Layer& layer = document_.layers()[range.layer];
    if (range.first == 0) {
      out.bytes += "<layer name=\"";
      if (auto ok = append_xml_attribute(out.bytes, layer.name); !ok) {
        return tl::unexpected(with_context(ok.error(), "a layer's name"));
      }
      out.bytes += "\">\n";
    }
    WideLine line;
    for (std::size_t k = range.first; k < range.last; ++k) {
      const StrokePtr stroke = document_.find(layer.strokes[k]);
      if (auto ok = check(*stroke, range.before + (k - range.first) + 1); !ok) return ok;
      append(out.bytes, stroke->color(), line.sample(*stroke));
    }
    if (range.last == layer.strokes.size()) out.bytes += "</layer>\n";
    return {};
  }

  std::string tail() override { return "</page>\n</xournal>\n"; }

 private:
  void begin_page(const Drawing& drawing, const std::optional<Rgba>& wanted_paper) {
    Rgba paper{255, 255, 255, 255};
    Rect area;
    if (drawing.has_page) {
      area = drawing.page.area();
      const Rgba color = wanted_paper.value_or(drawing.page.paper);
      if (color.a > 0) paper = color;
    } else {
      area = ink_bounds(document_, LayerChoice::kAll);
      area = area.empty() ? Page{}.area() : area.inflated(kXoppMarginMm);
    }
    corner_ = {area.x0, area.y0};
    head_ += "<page width=\"";
    append_points(head_, area.width());
    head_ += "\" height=\"";
    append_points(head_, area.height());
    paper.a = 255;
    head_ +=
        "\">\n<background type=\"solid\" color=\"" + color_text(paper) + "\" style=\"plain\"/>\n";
  }

  static Result<void> check(const Stroke& stroke, std::size_t number) {
    for (const Point& p : stroke.data().points) {
      if (is_in_range(p)) continue;
      return fail(ErrorCode::kLimitExceeded, "stroke " + std::to_string(number) +
                                                 ": a coordinate beyond 1e9 mm cannot be written");
    }
    return {};
  }

  void append(std::string& out, Rgba ink, const std::vector<WidePoint>& line) const {
    const auto by_width = [](const WidePoint& a, const WidePoint& b) {
      return a.width_mm < b.width_mm;
    };
    const auto [smallest, largest] = std::minmax_element(line.begin(), line.end(), by_width);
    out += ink.a == 255 ? "<stroke tool=\"pen\" color=\"" : "<stroke tool=\"highlighter\" color=\"";
    out += color_text(ink) + "\" width=\"";
    append_points(out, largest->width_mm);
    if (largest->width_mm - smallest->width_mm > 1e-6) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        out += ' ';
        append_points(out, 0.5 * (line[i - 1].width_mm + line[i].width_mm));
      }
    }
    out += "\" capStyle=\"round\">";
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) out += ' ';
      append_points(out, line[i].position.x - corner_.x);
      out += ' ';
      append_points(out, line[i].position.y - corner_.y);
    }
    out += "</stroke>\n";
  }

  const Document& document_;
  std::vector<StrokeRange> ranges_;
  std::string head_;
  Point corner_;
};

}  // namespace

Result<std::unique_ptr<DrawingParts>> xopp_parts(const Drawing& drawing,
                                                 const std::optional<Rgba>& paper) {
  return gzip_parts(std::make_unique<XoppParts>(drawing, paper));
}

Result<std::string> xopp_bytes(const Drawing& drawing) {
  const Result<std::unique_ptr<DrawingParts>> parts = xopp_parts(drawing);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

}  // namespace felt
