#include "felt/io/xopp_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/io/ink_of_points.h"
#include "felt/io/limits.h"
#include "felt/io/unpack.h"
#include "felt/io/xml_text.h"
#include "felt/io/xopp_import.h"
#include "felt/stroke/flatten.h"

namespace felt {
namespace {

/// Points are written in steps of 0.0001 pt, 35 nm.
constexpr double kStepsPerPoint = 1e4;
/// Pieces that a part of a line is cut into at most, however fast its width grows.
constexpr double kMostPieces = 64.0;

class XoppText {
 public:
  Result<std::string> write(const LayeredSketch& drawing) {
    out_ =
        "<?xml version=\"1.0\" standalone=\"no\"?>\n"
        "<xournal creator=\"Feltline\" fileversion=\"4\">\n<title>Feltline drawing</title>\n";
    begin_page(drawing);
    for (const SketchLayer& layer : drawing.layers) {
      if (auto ok = add(layer); !ok) return tl::unexpected(ok.error());
    }
    // A page of Xournal++ has a layer to draw on.
    if (drawing.layers.empty()) out_ += "<layer>\n</layer>\n";
    out_ += "</page>\n</xournal>\n";
    return std::move(out_);
  }

 private:
  void begin_page(const LayeredSketch& drawing) {
    Rgba paper{255, 255, 255, 255};
    Rect area;
    if (drawing.page) {
      area = drawing.page->area();
      if (drawing.page->paper.a > 0) paper = drawing.page->paper;
    } else {
      for (const SketchLayer& layer : drawing.layers) {
        for (const SketchStroke& s : layer.strokes) area.extend(s.stroke.bounds());
      }
      area = area.empty() ? SheetPage{}.area() : area.inflated(kXoppMarginMm);
    }
    corner_ = {area.x0, area.y0};
    out_ += "<page width=\"";
    append_points(area.width());
    out_ += "\" height=\"";
    append_points(area.height());
    paper.a = 255;
    out_ += "\">\n<background type=\"solid\" color=\"" + color(paper) + "\" style=\"plain\"/>\n";
  }

  Result<void> add(const SketchLayer& layer) {
    out_ += "<layer name=\"";
    if (auto ok = append_xml_attribute(out_, layer.name); !ok) {
      return tl::unexpected(with_context(ok.error(), "a layer's name"));
    }
    out_ += "\">\n";
    for (const SketchStroke& s : layer.strokes) {
      ++count_;
      for (const Point& p : s.stroke.data().points) {
        if (std::max(std::fabs(p.x), std::fabs(p.y)) <= limits::kMaxCoordinate) continue;
        return fail(
            ErrorCode::kLimitExceeded,
            "stroke " + std::to_string(count_) + ": a coordinate beyond 1e9 mm cannot be written");
      }
      add(s.stroke);
    }
    out_ += "</layer>\n";
    return {};
  }

  void add(const Stroke& stroke) {
    sample(stroke);
    const auto by_width = [](const WidePoint& a, const WidePoint& b) {
      return a.width_mm < b.width_mm;
    };
    const auto [least, most] = std::minmax_element(line_.begin(), line_.end(), by_width);
    const Rgba ink = stroke.color();
    out_ +=
        ink.a == 255 ? "<stroke tool=\"pen\" color=\"" : "<stroke tool=\"highlighter\" color=\"";
    out_ += color(ink) + "\" width=\"";
    append_points(most->width_mm);
    if (most->width_mm - least->width_mm > 1e-6) {
      for (std::size_t i = 1; i < line_.size(); ++i) {
        out_ += ' ';
        append_points(0.5 * (line_[i - 1].width_mm + line_[i].width_mm));
      }
    }
    out_ += "\" capStyle=\"round\">";
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (i > 0) out_ += ' ';
      append_points(line_[i].position.x - corner_.x);
      out_ += ' ';
      append_points(line_[i].position.y - corner_.y);
    }
    out_ += "</stroke>\n";
  }

  // The stroke as a line whose pieces differ little in width from their neighbours.
  void sample(const Stroke& stroke) {
    flatten(stroke, kXoppToleranceMm, dabs_);
    line_.clear();
    for (std::size_t i = 0; i < dabs_.size(); ++i) {
      const WidePoint to = {dabs_[i].center, 2.0 * dabs_[i].radius_mm};
      if (i > 0) {
        const WidePoint from = {dabs_[i - 1].center, 2.0 * dabs_[i - 1].radius_mm};
        const double grows = to.width_mm - from.width_mm;
        const int pieces = static_cast<int>(
            std::clamp(std::ceil(std::fabs(grows) / kXoppWidthStepMm), 1.0, kMostPieces));
        for (int k = 1; k < pieces; ++k) {
          const double t = static_cast<double>(k) / pieces;
          line_.push_back({lerp(from.position, to.position, t), from.width_mm + t * grows});
        }
      }
      line_.push_back(to);
    }
  }

  void append_points(double mm) {
    const double pt = std::round(mm / kMmPerPoint * kStepsPerPoint) / kStepsPerPoint;
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), pt == 0.0 ? 0.0 : pt,
                                   std::chars_format::fixed)
                         .ptr;
    out_.append(text.data(), end);
  }

  static std::string color(Rgba c) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) {
      text += kDigits[part >> 4];
      text += kDigits[part & 15];
    }
    return text;
  }

  std::string out_;
  Point corner_;
  std::size_t count_ = 0;
  std::vector<Dab> dabs_;
  std::vector<WidePoint> line_;
};

}  // namespace

Result<std::string> xopp_bytes(const LayeredSketch& drawing) {
  const Result<std::string> text = XoppText().write(drawing);
  if (!text) return text;
  return gzip(*text);
}

}  // namespace felt
