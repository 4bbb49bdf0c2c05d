#include "felt/io/pdf_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/io/svg_writer.h"
#include "felt/io/unpack.h"
#include "felt/stroke/outline_path.h"

namespace felt {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kMostPoints = 14'400.0;
constexpr double kFarthestMm = 1e6;
constexpr double kStepsPerMm = 1e4;  // of coordinates: 1e-4 mm
constexpr double kHairMm = 5e-4;

/// steps / 10^4 without trailing zeros, and a space.
void append_steps(std::string& out, std::int64_t steps) {
  if (steps < 0) out += '-';
  const auto size = static_cast<std::uint64_t>(steps < 0 ? -steps : steps);
  constexpr auto kOne = static_cast<std::uint64_t>(kStepsPerMm);
  out += std::to_string(size / kOne);
  if (size % kOne != 0) {
    std::string digits = std::to_string(kOne + size % kOne);
    digits.erase(digits.find_last_not_of('0') + 1);
    digits[0] = '.';
    out += digits;
  }
  out += ' ';
}

void append_number(std::string& out, double value) {
  append_steps(out, std::llround(value * kStepsPerMm));
}

/// Content of the page: the coordinate system is turned to ours, mm from the top left of the area,
/// y down, so that numbers are those of the sheet.
class Content {
 public:
  explicit Content(const Rect& area) {
    constexpr int kMatrixDigits = 9;
    std::array<char, 160> text{};
    // The scale needs more digits than the grid of coordinates: 14400 points are a long way.
    std::snprintf(text.data(), text.size(), "%.*f 0 0 %.*f ", kMatrixDigits, kPointsPerMm,
                  kMatrixDigits, -kPointsPerMm);
    out_ += text.data();
    append_number(out_, -area.x0 * kPointsPerMm);
    append_number(out_, area.y1 * kPointsPerMm);
    out_ += "cm\n";
  }

  void paper(const Rect& area, Rgba color) {
    set_color(color);
    append_number(out_, area.x0);
    append_number(out_, area.y0);
    append_number(out_, area.width());
    append_number(out_, area.height());
    out_ += "re f\n";
  }

  /// `mask` counts from 1; 0: all of its ink is seen.
  void stroke(const Stroke& stroke, double tolerance_mm, std::size_t mask) {
    set_color(stroke.color());
    if (mask > 0) out_ += "q /G" + std::to_string(mask) + " gs\n";
    outline(outline_path(stroke, tolerance_mm));
    out_ += mask > 0 ? "f\nQ\n" : "f\n";
  }

  [[nodiscard]] const std::string& text() const noexcept { return out_; }
  /// The alphas that were used.
  [[nodiscard]] const std::map<std::uint8_t, bool>& alphas() const noexcept { return alphas_; }

 private:
  void outline(const OutlinePath& path) {
    const Point* p = path.points.data();
    for (const OutlinePath::Verb verb : path.verbs) {
      switch (verb) {
        case OutlinePath::Verb::kMove:
          points(p, 1, "m\n");
          p += 1;
          break;
        case OutlinePath::Verb::kLine:
          points(p, 1, "l\n");
          p += 1;
          break;
        case OutlinePath::Verb::kCubic:
          points(p, 3, "c\n");
          p += 3;
          break;
        case OutlinePath::Verb::kClose:
          out_ += "h\n";
          break;
      }
    }
  }

  void points(const Point* p, int count, const char* verb) {
    for (int i = 0; i < count; ++i) {
      append_number(out_, p[i].x);
      append_number(out_, p[i].y);
    }
    out_ += verb;
  }

  void set_color(Rgba color) {
    if (has_color_ && color == color_) return;
    for (const std::uint8_t c : {color.r, color.g, color.b}) append_number(out_, c / 255.0);
    out_ += "rg\n";
    if (!has_color_ || color.a != color_.a) {
      out_ += "/A" + std::to_string(color.a) + " gs\n";
      alphas_[color.a] = true;
    }
    color_ = color;
    has_color_ = true;
  }

  std::string out_;
  std::map<std::uint8_t, bool> alphas_;
  Rgba color_{};
  bool has_color_ = false;
};

/// Puts objects one after another and knows where they begin.
class File {
 public:
  File() {
    // The second line tells transfer programs that the file is no text (PDF 1.4, 3.4.1).
    out_ = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";
  }

  void object(const std::string& body) {
    places_.push_back(out_.size());
    out_ += std::to_string(places_.size()) + " 0 obj\n" + body + "\nendobj\n";
  }

  std::string finish() && {
    const std::size_t table = out_.size();
    out_ += "xref\n0 " + std::to_string(places_.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t place : places_) {
      std::array<char, 32> line{};
      std::snprintf(line.data(), line.size(), "%010zu 00000 n \n", place);
      out_ += line.data();
    }
    out_ += "trailer\n<< /Size " + std::to_string(places_.size() + 1) +
            " /Root 1 0 R >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return std::move(out_);
  }

 private:
  std::string out_;
  std::vector<std::size_t> places_;
};

/// The objects of the masks come behind the page's content, two for each: the picture, and the
/// group that lays it on the sheet.
constexpr std::size_t kFirstMaskObject = 5;

std::size_t picture_of(std::size_t mask) {
  return kFirstMaskObject + 2 * (mask - 1);
}

/// Picture and group as bodies of objects.
class Masks {
 public:
  [[nodiscard]] std::size_t count() const noexcept { return bodies_.size() / 2; }
  [[nodiscard]] const std::vector<std::string>& bodies() const noexcept { return bodies_; }

  /// Which it is, from 1.
  std::size_t add(const GrainMask& mask) {
    const std::string packed =
        zlib_packed({reinterpret_cast<const char*>(mask.seen.data()), mask.seen.size()});
    bodies_.push_back("<< /Type /XObject /Subtype /Image /Width " + std::to_string(mask.width) +
                      " /Height " + std::to_string(mask.height) +
                      " /ColorSpace /DeviceGray /BitsPerComponent 8 /Filter /FlateDecode /Length " +
                      std::to_string(packed.size()) + " >>\nstream\n" + packed + "\nendstream");
    // The unit square of a picture stands upright; y goes down on our sheet. A hair less than its
    // area: programs that round a picture outwards to whole pixels, as poppler does, would stretch
    // one that ends on a pixel's edge by a pixel.
    const Rect area = mask.area.inflated(-kHairMm);
    std::string place = "q ";
    for (const double v : {area.width(), 0.0, 0.0, -area.height(), area.x0, area.y1}) {
      append_number(place, v);
    }
    place += "cm /P Do Q\n";
    std::string group = "<< /Type /XObject /Subtype /Form /BBox [";
    for (const double v : {mask.area.x0, mask.area.y0, mask.area.x1, mask.area.y1}) {
      append_number(group, v);
    }
    group +=
        "] /Group << /S /Transparency /CS /DeviceGray /I true >> /Resources << /XObject << /P " +
        std::to_string(picture_of(count() + 1)) + " 0 R >> >> /Length " +
        std::to_string(place.size()) + " >>\nstream\n" + place + "endstream";
    bodies_.push_back(std::move(group));
    return count();
  }

 private:
  std::vector<std::string> bodies_;
};

std::string page_object(const Rect& area, const Content& content, const Masks& masks) {
  std::string out = "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ";
  append_number(out, area.width() * kPointsPerMm);
  append_number(out, area.height() * kPointsPerMm);
  // A group: transparency is worked out in sRGB-like device colours, as everywhere else here.
  out +=
      "] /Contents 4 0 R /Group << /S /Transparency /CS /DeviceRGB >> "
      "/Resources << /ExtGState <<";
  for (const auto& [alpha, used] : content.alphas()) {
    out += " /A" + std::to_string(alpha) + " << /ca ";
    append_number(out, alpha / 255.0);
    out += ">>";
  }
  for (std::size_t mask = 1; mask <= masks.count(); ++mask) {
    out += " /G" + std::to_string(mask) + " << /SMask << /S /Luminosity /G " +
           std::to_string(picture_of(mask) + 1) + " 0 R >> >>";
  }
  return out + " >> >> >>";
}

Result<void> check(const Sketch& sketch, const PdfOptions& options, const Rect& area) {
  if (!(options.tolerance_mm > 0.0) || !(options.margin_mm >= 0.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "PDF: the tolerance must be above 0, the margin 0 or more");
  }
  const double longest = std::max(area.width(), area.height()) * kPointsPerMm;
  if (!(area.width() > 0.0) || !(area.height() > 0.0) || !(longest <= kMostPoints)) {
    return fail(ErrorCode::kLimitExceeded, "a PDF page has sides from above 0 to 5080 mm");
  }
  const Rect reach = area.inflated(kFarthestMm);
  for (const SketchStroke& s : sketch) {
    const Rect ink = s.stroke.bounds();
    if (ink.x0 >= reach.x0 && ink.y0 >= reach.y0 && ink.x1 <= reach.x1 && ink.y1 <= reach.y1) {
      continue;
    }
    return fail(ErrorCode::kLimitExceeded,
                "stroke " + s.id + " reaches farther than 1e6 mm from the page");
  }
  return {};
}

Result<void> add_strokes(const Sketch& sketch, const PdfOptions& options, const Rect& area,
                         Content& content, Masks& masks) {
  std::optional<GrainMasks> grain;
  if (options.grain) grain.emplace(*options.grain, area);
  for (const SketchStroke& s : sketch) {
    std::size_t mask = 0;
    if (grain) {
      const Result<std::optional<GrainMask>> seen = grain->of(s.stroke);
      if (!seen) return tl::unexpected(with_context(seen.error(), "stroke " + s.id));
      if (*seen) mask = masks.add(**seen);
    }
    content.stroke(s.stroke, options.tolerance_mm, mask);
  }
  return {};
}

}  // namespace

Result<std::string> pdf_text(const Sketch& sketch, const PdfOptions& options) {
  Rect ink;
  for (const SketchStroke& s : sketch) ink.extend(s.stroke.bounds());
  const Rect area = svg_area(ink, {.sheet = options.sheet, .margin_mm = options.margin_mm});
  if (auto ok = check(sketch, options, area); !ok) return tl::unexpected(ok.error());
  Content content(area);
  if (options.paper.a > 0) content.paper(area, options.paper);
  Masks masks;
  if (auto ok = add_strokes(sketch, options, area, content, masks); !ok) {
    return tl::unexpected(ok.error());
  }
  File file;
  file.object("<< /Type /Catalog /Pages 2 0 R >>");
  file.object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
  file.object(page_object(area, content, masks));
  file.object("<< /Length " + std::to_string(content.text().size()) + " >>\nstream\n" +
              content.text() + "endstream");
  for (const std::string& body : masks.bodies()) file.object(body);
  return std::move(file).finish();
}

Result<void> write_pdf(const std::string& path, const Sketch& sketch, const PdfOptions& options) {
  const Result<std::string> text = pdf_text(sketch, options);
  if (text) return write_file(path, *text);
  return tl::unexpected(with_context(text.error(), path == "-" ? "stdout" : path));
}

}  // namespace felt
