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

#include "felt/io/drawing_styles.h"
#include "felt/io/fill_path.h"
#include "felt/io/picture/pdf_objects.h"
#include "felt/io/picture/pdf_pictures.h"
#include "felt/io/unpack.h"
#include "felt/render/styled_outline.h"

namespace felt {
namespace {

constexpr double kMaxPoints = 14'400.0;
constexpr double kClipMarginMm = 1e6;

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
                  kPdfPointsPerMm / kPdfStepsPerMm, kMatrixDigits,
                  -kPdfPointsPerMm / kPdfStepsPerMm);
    out_ += text.data();
    append_pdf_number(out_, -area.x0 * kPdfPointsPerMm);
    append_pdf_number(out_, area.y1 * kPdfPointsPerMm);
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

  /// Appends a stroke with the outline `path`. `mask` is the number of its mask, from 1, or 0 if
  /// all of the ink is visible.
  void stroke(const OutlinePath& path, Rgba color, std::size_t mask) {
    set_color(color);
    if (mask > 0) out_ += "q /G" + std::to_string(mask) + " gs\n";
    outline(path);
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
    set_color({color_.r, color_.g, color_.b, 255});
    pictures.append_commands(out_, layer, kPdfStepsPerMm);
  }

  /// Appends the form with this number.
  void form(std::size_t number) {
    const std::string name = std::to_string(number);
    out_ += "q /L" + name + " gs /F" + name + " Do Q\n";
  }

  [[nodiscard]] const std::string& text() const noexcept { return out_; }

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

Result<void> check(const Document& document, const PdfOptions& options, const Rect& area) {
  if (!(options.tolerance_mm > 0.0) || !(options.margin_mm >= 0.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "PDF: the tolerance must be above 0, the margin 0 or more");
  }
  const double longest = std::max(area.width(), area.height()) * kPdfPointsPerMm;
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
/// page (4) come first. The length of the content (5), the page (3), the pictures, the masks, the
/// forms and their resources follow when they are known.
class PdfParts final : public DrawingParts {
 public:
  PdfParts(const Drawing& drawing, const PdfOptions& options, const Rect& area,
           PdfPictures pictures)
      : document_(drawing.document),
        styles_(options.grain ? options.grain->grain.styles() : styles_of(drawing)),
        ranges_(stroke_ranges(drawing.document, LayerChoice::kVisible)),
        options_(options),
        area_(area),
        pictures_(std::move(pictures)),
        masks_(kFirstPdfObject + pictures_.bodies().size()) {
    if (options.grain) grain_.emplace(*options.grain, area);
    if (options.paper.a > 0) alphas_.insert(options.paper.a);
    for (const Layer& layer : document_.layers()) {
      if (!layer.visible) continue;
      for (const StrokeId id : layer.strokes) alphas_.insert(document_.find(id)->color().a);
      for (const FillId id : layer.fills) alphas_.insert(document_.find_fill(id)->color.a);
      if (pictures_.has(layer)) alphas_.insert(255);
    }
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }
  // Masks and forms are numbered in the order in which they are made.
  [[nodiscard]] bool any_order() const override {
    return !grain_ && std::none_of(ranges_.begin(), ranges_.end(),
                                   [this](const StrokeRange& r) { return is_in_form(r); });
  }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    Content content;
    if (i == 0) {
      out.bytes = head() + zlib_head();
      content.begin(area_);
      if (options_.paper.a > 0) content.paper(area_, options_.paper);
    } else {
      if (auto ok = add_page_part(i - 1, content); !ok) return ok;
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
    const PdfResources resources{alphas_, pictures_, masks_, forms_};
    object(3, pdf_page_object(area_, resources));
    for (std::size_t k = 0; k < pictures_.bodies().size(); ++k) {
      object(kFirstPdfObject + k, pictures_.bodies()[k]);
    }
    for (std::size_t k = 0; k < masks_.bodies().size(); ++k) {
      object(masks_.first_object() + k, masks_.bodies()[k]);
    }
    for (std::size_t k = 0; k < forms_.size(); ++k) {
      object(resources.object_of_form(k + 1), pdf_form_object(area_, forms_[k], resources));
    }
    object(resources.object(), resources.text());
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

  [[nodiscard]] const Layer& layer_of(const StrokeRange& range) const {
    return document_.layers()[range.layer];
  }
  [[nodiscard]] static bool is_whole(const Layer& layer) noexcept {
    return layer.opacity < 1.0 || layer.blend != BlendMode::kNormal;
  }
  /// Returns the group of a range that is drawn as a whole, or null.
  [[nodiscard]] const LayerGroup* whole_group(const StrokeRange& range) const {
    const LayerGroup* group = layer_of(range).group.get();
    return group && group->is_whole() ? group : nullptr;
  }
  [[nodiscard]] bool is_in_form(const StrokeRange& range) const {
    return whole_group(range) || is_whole(layer_of(range));
  }

  /// Adds a range to the page. The first range of a form adds the whole form, the others nothing.
  Result<void> add_page_part(std::size_t i, Content& content) const {
    const LayerGroup* group = whole_group(ranges_[i]);
    if (!group) return add_layer_part(i, content);
    const auto is_same = [&](std::size_t k) {
      const LayerGroup* other = whole_group(ranges_[k]);
      return other && other->id == group->id;
    };
    if (i > 0 && is_same(i - 1)) return {};
    Content inside;
    for (std::size_t k = i; k < ranges_.size() && is_same(k); ++k) {
      if (auto ok = add_layer_part(k, inside); !ok) return ok;
    }
    forms_.push_back({inside.text(), group->opacity, group->blend});
    content.form(forms_.size());
    return {};
  }

  Result<void> add_layer_part(std::size_t i, Content& content) const {
    const Layer& layer = layer_of(ranges_[i]);
    if (!is_whole(layer)) return add_strokes(ranges_[i], content);
    if (ranges_[i].first > 0) return {};
    Content inside;
    for (std::size_t k = i; k < ranges_.size() && ranges_[k].layer == ranges_[i].layer; ++k) {
      if (auto ok = add_strokes(ranges_[k], inside); !ok) return ok;
    }
    if (inside.text().empty()) return {};
    forms_.push_back({inside.text(), layer.opacity, layer.blend});
    content.form(forms_.size());
    return {};
  }

  Result<void> add_strokes(const StrokeRange& range, Content& content) const {
    const Layer& layer = layer_of(range);
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
      const StrokeStyle* style = styles_.find(stroke->medium());
      content.stroke(styled_path(*stroke, style, options_.tolerance_mm), stroke->color(), mask);
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
  StrokeStyles styles_;
  std::vector<StrokeRange> ranges_;
  PdfOptions options_;
  Rect area_;
  PdfPictures pictures_;
  std::set<std::uint8_t> alphas_;
  std::uint64_t bytes_ = 0;
  std::uint32_t checksum_ = adler32_of({});
  // Set if the strokes have masks. Used by one thread only, because any_order() is then false.
  mutable std::optional<GrainMasks> grain_;
  mutable PdfMasks masks_;
  mutable std::vector<PdfForm> forms_;  // used by one thread only, too
};

}  // namespace

Result<std::unique_ptr<DrawingParts>> pdf_parts(const Drawing& drawing, const PdfOptions& options) {
  const Rect area = picture_area(ink_bounds(drawing.document), options.area, options.margin_mm);
  if (auto ok = check(drawing.document, options, area); !ok) return tl::unexpected(ok.error());
  return PdfPictures::create(drawing.document, options.pictures, kFirstPdfObject)
      .map([&](PdfPictures pictures) -> std::unique_ptr<DrawingParts> {
        return std::make_unique<PdfParts>(drawing, options, area, std::move(pictures));
      });
}

Result<std::string> pdf_text(const Drawing& drawing, const PdfOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = pdf_parts(drawing, options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

}  // namespace felt
