#include "felt/io/picture/pdf_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "felt/io/fill_path.h"
#include "felt/io/picture/pdf_pictures.h"
#include "felt/io/unpack.h"
#include "felt/stroke/outline/outline_path.h"

namespace felt {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kMaxPoints = 14'400.0;
constexpr double kClipMarginMm = 1e6;
constexpr double kPdfStepsPerMm = 1e3;  // a step of coordinates is 1e-3 mm
constexpr double kHairMm = 5e-4;

/// Appends a value with four decimals, without trailing zeros, and a space.
void append_pdf_number(std::string& out, double value) {
  constexpr double kPlaces = 1e4;
  std::array<char, 40> text;
  const double rounded = std::round(value * kPlaces) / kPlaces;
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(),
                                        rounded == 0.0 ? 0.0 : rounded, std::chars_format::fixed)
                              .ptr);
  out += ' ';
}

/// Appends a length in mm as whole steps, and a space.
void append_grid_steps(std::string& out, double mm) {
  std::array<char, 24> text;
  out.append(
      text.data(),
      std::to_chars(text.data(), text.data() + text.size(), std::llround(mm * kPdfStepsPerMm)).ptr);
  out += ' ';
}

/// A part of the page's content. Each part sets its own colour.
class Content {
 public:
  /// Transforms to our coordinate system: steps from the top left of the area, y down, so that
  /// numbers are those of the page.
  void begin(const Rect& area) {
    constexpr int kMatrixDigits = 12;
    std::array<char, 160> text{};
    // The scale needs more digits than the rest, because a page can be 14400 points long.
    std::snprintf(text.data(), text.size(), "%.*f 0 0 %.*f ", kMatrixDigits,
                  kPointsPerMm / kPdfStepsPerMm, kMatrixDigits, -kPointsPerMm / kPdfStepsPerMm);
    out_ += text.data();
    append_pdf_number(out_, -area.x0 * kPointsPerMm);
    append_pdf_number(out_, area.y1 * kPointsPerMm);
    out_ += "cm\n";
  }

  void paper(const Rect& area, Rgba color) {
    set_color(color);
    append_grid_steps(out_, area.x0);
    append_grid_steps(out_, area.y0);
    append_grid_steps(out_, area.width());
    append_grid_steps(out_, area.height());
    out_ += "re f\n";
  }

  /// Appends a stroke. `mask` is the number of its mask, from 1, or 0 if all of the ink is visible.
  void stroke(const Stroke& stroke, double tolerance_mm, std::size_t mask) {
    set_color(stroke.color());
    if (mask > 0) out_ += "q /G" + std::to_string(mask) + " gs\n";
    outline(outline_path(stroke, tolerance_mm));
    out_ += mask > 0 ? "f\nQ\n" : "f\n";
  }

  void fill(const Fill& fill) {
    set_color(fill.color);
    outline(fill_path(fill));
    out_ += "f*\n";
  }

  /// Appends the picture of a layer, if it has one in the file.
  void picture(const PdfPictures& pictures, const Layer& layer) {
    if (!pictures.has(layer)) return;
    set_color({color_.r, color_.g, color_.b, alpha_of(layer)});
    pictures.append_commands(out_, layer, kPdfStepsPerMm);
  }

  [[nodiscard]] const std::string& text() const noexcept { return out_; }

  /// Returns the alpha of the picture of a layer.
  static std::uint8_t alpha_of(const Layer& layer) {
    return static_cast<std::uint8_t>(std::lround(255.0 * layer.opacity));
  }

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
      append_grid_steps(out_, p[i].x);
      append_grid_steps(out_, p[i].y);
    }
    out_ += verb;
  }

  void set_color(Rgba color) {
    if (has_color_ && color == color_) return;
    for (const std::uint8_t c : {color.r, color.g, color.b}) append_pdf_number(out_, c / 255.0);
    out_ += "rg\n";
    if (!has_color_ || color.a != color_.a) out_ += "/A" + std::to_string(color.a) + " gs\n";
    color_ = color;
    has_color_ = true;
  }

  std::string out_;
  Rgba color_{};
  bool has_color_ = false;
};

/// The objects of the pictures follow the page's content, and then those of the masks, two for each
/// mask: the picture, and the group that places it on the page.
constexpr std::size_t kFirstPictureObject = 6;

/// Collects the picture and the group of each mask as bodies of PDF objects.
class Masks {
 public:
  explicit Masks(std::size_t first_object) : first_object_(first_object) {}

  /// Returns the number of the object with the picture of a mask.
  [[nodiscard]] std::size_t picture_of(std::size_t mask) const noexcept {
    return first_object_ + 2 * (mask - 1);
  }
  [[nodiscard]] std::size_t first_object() const noexcept { return first_object_; }
  [[nodiscard]] std::size_t count() const noexcept { return bodies_.size() / 2; }
  [[nodiscard]] const std::vector<std::string>& bodies() const noexcept { return bodies_; }

  /// Adds a mask and returns its number, from 1.
  std::size_t add(const GrainMask& mask) {
    const std::string packed =
        zlib_packed({reinterpret_cast<const char*>(mask.seen.data()), mask.seen.size()});
    bodies_.push_back("<< /Type /XObject /Subtype /Image /Width " + std::to_string(mask.width) +
                      " /Height " + std::to_string(mask.height) +
                      " /ColorSpace /DeviceGray /BitsPerComponent 8 /Filter /FlateDecode /Length " +
                      std::to_string(packed.size()) + " >>\nstream\n" + packed + "\nendstream");
    // The unit square of a picture has y up; our page has y down. The picture is slightly smaller
    // than its area, because programs that round a picture outwards to whole pixels, such as
    // poppler, would stretch one that ends on a pixel's edge by a pixel.
    const Rect area = mask.area.inflated(-kHairMm);
    std::string place = "q ";
    for (const double v : {area.width(), 0.0, 0.0, -area.height(), area.x0, area.y1}) {
      append_pdf_number(place, kPdfStepsPerMm * v);
    }
    place += "cm /P Do Q\n";
    std::string group = "<< /Type /XObject /Subtype /Form /BBox [";
    for (const double v : {mask.area.x0, mask.area.y0, mask.area.x1, mask.area.y1}) {
      append_pdf_number(group, kPdfStepsPerMm * v);
    }
    group +=
        "] /Group << /S /Transparency /CS /DeviceGray /I true >> /Resources << /XObject << /P " +
        std::to_string(picture_of(count() + 1)) + " 0 R >> >> /Length " +
        std::to_string(place.size()) + " >>\nstream\n" + place + "endstream";
    bodies_.push_back(std::move(group));
    return count();
  }

 private:
  std::size_t first_object_;
  std::vector<std::string> bodies_;
};

std::string page_object(const Rect& area, const std::set<std::uint8_t>& alphas,
                        const PdfPictures& pictures, const Masks& masks) {
  std::string out = "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ";
  append_pdf_number(out, area.width() * kPointsPerMm);
  append_pdf_number(out, area.height() * kPointsPerMm);
  // With this group, transparent colours are blended in the device's RGB space. It is close to
  // sRGB, in which Feltline blends everywhere else.
  out +=
      "] /Contents 4 0 R /Group << /S /Transparency /CS /DeviceRGB >> "
      "/Resources << /ExtGState <<";
  for (const std::uint8_t alpha : alphas) {
    out += " /A" + std::to_string(alpha) + " << /ca ";
    append_pdf_number(out, alpha / 255.0);
    out += ">>";
  }
  for (std::size_t mask = 1; mask <= masks.count(); ++mask) {
    out += " /G" + std::to_string(mask) + " << /SMask << /S /Luminosity /G " +
           std::to_string(masks.picture_of(mask) + 1) + " 0 R >> >>";
  }
  out += " >>";
  if (!pictures.bodies().empty()) out += " /XObject <<" + pictures.resources() + " >>";
  return out + " >> >>";
}

Result<void> check(const Document& document, const PdfOptions& options, const Rect& area) {
  if (!(options.tolerance_mm > 0.0) || !(options.margin_mm >= 0.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "PDF: the tolerance must be above 0, the margin 0 or more");
  }
  const double longest = std::max(area.width(), area.height()) * kPointsPerMm;
  if (!(area.width() > 0.0) || !(area.height() > 0.0) || !(longest <= kMaxPoints)) {
    return fail(ErrorCode::kLimitExceeded,
                "the sides of a PDF page must be above 0 and at most 5080 mm");
  }
  const Rect reach = area.inflated(kClipMarginMm);
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const auto is_near = [&reach](const Rect& ink) {
      return ink.x0 >= reach.x0 && ink.y0 >= reach.y0 && ink.x1 <= reach.x1 && ink.y1 <= reach.y1;
    };
    for (const StrokeId id : layer.strokes) {
      if (is_near(document.find(id)->bounds())) continue;
      return fail(ErrorCode::kLimitExceeded,
                  "stroke " + stroke_name(id) + " extends more than 1e6 mm from the page");
    }
    for (const FillId id : layer.fills) {
      if (is_near(fill_bounds(*document.find_fill(id)))) continue;
      return fail(ErrorCode::kLimitExceeded,
                  "fill " + fill_name(id) + " extends more than 1e6 mm from the page");
    }
  }
  return {};
}

/// Makes a PDF file. The objects for the catalogue (1), the pages (2) and the packed content of the
/// page (4) come first. The length of the content (5), the page (3), the pictures and the masks
/// follow when they are known.
class PdfParts final : public DrawingParts {
 public:
  PdfParts(const Document& document, const PdfOptions& options, const Rect& area,
           PdfPictures pictures)
      : document_(document),
        ranges_(stroke_ranges(document, LayerChoice::kVisible)),
        options_(options),
        area_(area),
        pictures_(std::move(pictures)),
        masks_(kFirstPictureObject + pictures_.bodies().size()) {
    if (options.grain) grain_.emplace(*options.grain, area);
    if (options.paper.a > 0) alphas_.insert(options.paper.a);
    for (const Layer& layer : document.layers()) {
      if (!layer.visible) continue;
      for (const StrokeId id : layer.strokes) alphas_.insert(document.find(id)->color().a);
      for (const FillId id : layer.fills) alphas_.insert(document.find_fill(id)->color.a);
      if (pictures_.has(layer)) alphas_.insert(Content::alpha_of(layer));
    }
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }
  // Parts with masks must be made in order, because masks are numbered in that order.
  [[nodiscard]] bool any_order() const override { return !grain_; }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    Content content;
    if (i == 0) {
      out.bytes = head() + zlib_head();
      content.begin(area_);
      if (options_.paper.a > 0) content.paper(area_, options_.paper);
    } else {
      if (auto ok = add_strokes(ranges_[i - 1], content); !ok) return ok;
    }
    append_deflated(out.bytes, content.text());
    out.raw_bytes = content.text().size();
    out.checksum = adler32_of(content.text());
    return {};
  }

  void add(const DrawingPart& part) override {
    bytes_ += part.bytes.size();
    checksum_ = adler32_joined(checksum_, part.checksum, part.raw_bytes);
  }

  std::string tail() override {
    std::string out;
    append_deflate_end(out);
    append_zlib_tail(out, checksum_);
    const std::uint64_t length = bytes_ + out.size() - head().size();
    out += "endstream\nendobj\n";
    std::map<std::size_t, std::uint64_t> places = {{1, kCatalog}, {2, kPages}, {4, kContent}};
    const auto object = [&](std::size_t number, const std::string& body) {
      places[number] = bytes_ + out.size();
      out += std::to_string(number) + " 0 obj\n" + body + "\nendobj\n";
    };
    object(5, std::to_string(length));
    object(3, page_object(area_, alphas_, pictures_, masks_));
    for (std::size_t k = 0; k < pictures_.bodies().size(); ++k) {
      object(kFirstPictureObject + k, pictures_.bodies()[k]);
    }
    for (std::size_t k = 0; k < masks_.bodies().size(); ++k) {
      object(masks_.first_object() + k, masks_.bodies()[k]);
    }
    append_table(out, places);
    return out;
  }

 private:
  // The second line tells transfer programs that the file is binary (PDF 1.4, 3.4.1).
  static constexpr std::string_view kStart = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";
  static constexpr std::string_view kFirst = "1 0 obj\n<< /Type /Catalog /Pages 2 0 R >>\nendobj\n";
  static constexpr std::string_view kSecond =
      "2 0 obj\n<< /Type /Pages /Kids [3 0 R] /Count 1 >>\nendobj\n";
  static constexpr std::uint64_t kCatalog = kStart.size();
  static constexpr std::uint64_t kPages = kCatalog + kFirst.size();
  static constexpr std::uint64_t kContent = kPages + kSecond.size();

  static std::string head() {
    return std::string(kStart) + std::string(kFirst) + std::string(kSecond) +
           "4 0 obj\n<< /Length 5 0 R /Filter /FlateDecode >>\nstream\n";
  }

  Result<void> add_strokes(const StrokeRange& range, Content& content) const {
    const Layer& layer = document_.layers()[range.layer];
    if (range.first == 0) {
      content.picture(pictures_, layer);
      for (const FillId id : layer.fills) content.fill(*document_.find_fill(id));
    }
    for (std::size_t i = range.first; i < range.last; ++i) {
      const StrokeId id = layer.strokes[i];
      const StrokePtr stroke = document_.find(id);
      std::size_t mask = 0;
      if (grain_) {
        const Result<std::optional<GrainMask>> seen = grain_->of(*stroke);
        if (!seen) return tl::unexpected(with_context(seen.error(), "stroke " + stroke_name(id)));
        if (*seen) mask = masks_.add(**seen);
      }
      content.stroke(*stroke, options_.tolerance_mm, mask);
    }
    return {};
  }

  void append_table(std::string& out, const std::map<std::size_t, std::uint64_t>& places) const {
    const std::uint64_t table = bytes_ + out.size();
    const std::string size = std::to_string(places.size() + 1);
    out += "xref\n0 " + size + "\n0000000000 65535 f \n";
    for (const auto& [number, place] : places) {
      std::array<char, 32> line{};
      std::snprintf(line.data(), line.size(), "%010llu 00000 n \n",
                    static_cast<unsigned long long>(place));
      out += line.data();
    }
    out += "trailer\n<< /Size " + size + " /Root 1 0 R >>\nstartxref\n" + std::to_string(table) +
           "\n%%EOF\n";
  }

  const Document& document_;
  std::vector<StrokeRange> ranges_;
  PdfOptions options_;
  Rect area_;
  PdfPictures pictures_;
  std::set<std::uint8_t> alphas_;
  std::uint64_t bytes_ = 0;
  std::uint32_t checksum_ = adler32_of({});
  // Set if the strokes have masks. Used by one thread only, because any_order() is then false.
  mutable std::optional<GrainMasks> grain_;
  mutable Masks masks_;
};

}  // namespace

Result<std::unique_ptr<DrawingParts>> pdf_parts(const Drawing& drawing, const PdfOptions& options) {
  const Rect area = picture_area(ink_bounds(drawing.document), options.area, options.margin_mm);
  if (auto ok = check(drawing.document, options, area); !ok) return tl::unexpected(ok.error());
  return PdfPictures::create(drawing.document, options.pictures, kFirstPictureObject)
      .map([&](PdfPictures pictures) -> std::unique_ptr<DrawingParts> {
        return std::make_unique<PdfParts>(drawing.document, options, area, std::move(pictures));
      });
}

Result<std::string> pdf_text(const Drawing& drawing, const PdfOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = pdf_parts(drawing, options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

}  // namespace felt
