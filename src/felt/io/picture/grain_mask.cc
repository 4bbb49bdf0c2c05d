#include "felt/io/picture/grain_mask.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/io/picture/png.h"
#include "felt/render/image.h"
#include "felt/render/view.h"

namespace felt {
namespace {

/// Rows that are drawn at a time.
constexpr int kBandRows = 256;
/// If the coverage of a pixel (0..255) is below this, as at the edge of a stroke, its visible share
/// of the ink cannot be measured reliably and is taken from the neighbouring pixels.
constexpr std::uint8_t kSure = 48;
/// Ink counts as fully visible from this value (0..255) on, because rounding may reduce 255 to it.
constexpr std::uint8_t kWhole = 253;

/// Returns the pixels that both the stroke and the area may touch, with a border of one pixel for
/// smooth scaling.
PixelRect pixels_of(const Rect& ink, const Rect& area, const View& view) noexcept {
  const Rect seen{std::max(ink.x0, area.x0), std::max(ink.y0, area.y0), std::min(ink.x1, area.x1),
                  std::min(ink.y1, area.y1)};
  if (!(seen.x1 > seen.x0) || !(seen.y1 > seen.y0)) return {};
  const Rect px = view.area_px(seen);
  return {static_cast<int>(std::floor(px.x0)) - 1, static_cast<int>(std::floor(px.y0)) - 1,
          static_cast<int>(std::ceil(px.x1)) + 1, static_cast<int>(std::ceil(px.y1)) + 1};
}

/// Replaces the value of pixels with little ink, at the very edge, by the mean of the neighbours
/// with enough ink.
void spread(GrainMask& mask, const std::vector<std::uint8_t>& coverage) {
  const std::vector<std::uint8_t> inside = mask.seen;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                      static_cast<std::size_t>(x);
      if (coverage[at] >= kSure) continue;
      unsigned sum = 0, count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(mask.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(mask.width - 1, x + 1); ++u) {
          const auto beside = static_cast<std::size_t>(v) * static_cast<std::size_t>(mask.width) +
                              static_cast<std::size_t>(u);
          if (coverage[beside] < kSure) continue;
          sum += inside[beside];
          ++count;
        }
      }
      if (count > 0) mask.seen[at] = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
  }
}

}  // namespace

Result<std::string> GrainMask::png(double dpi) const {
  Result<Image> image = Image::create(width, height);
  if (!image) return tl::unexpected(image.error());
  const Pixels pixels = image->pixels();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    std::fill_n(pixels.data + 4 * i, 4, seen[i]);  // white, premultiplied
  }
  return encode_png(*image, dpi);
}

std::optional<double> GrainMasks::dpi_for_all(std::span<const StrokePtr> strokes, const Rect& area,
                                              double dpi) noexcept {
  for (;;) {
    const View page = View::at_dpi({area.x0, area.y0}, dpi);
    double pixels = 0.0;
    for (const StrokePtr& stroke : strokes) {
      const PixelRect part = pixels_of(stroke->bounds(), area, page);
      if (!part.empty()) pixels += 1.0 * part.width() * part.height();
    }
    if (pixels <= static_cast<double>(kMaxPixels)) return dpi;
    if (!(dpi > GrainPrint::kMinDpi)) return std::nullopt;
    // Slightly less than the exact fit, because every mask is rounded up to whole pixels.
    const double share = 0.98 * std::sqrt(static_cast<double>(kMaxPixels) / pixels);
    dpi = std::max(GrainPrint::kMinDpi, dpi * share);
  }
}

GrainMasks::GrainMasks(const GrainPrint& print, const Rect& area) noexcept
    : print_(print), area_(area) {}

/// Computes `seen` and coverage_ of a mask of known size. `view` begins at its corner.
void GrainMasks::draw(const Stroke& stroke, const View& view, GrainMask& mask) {
  const auto row = static_cast<std::size_t>(mask.width);
  const double tolerance_mm = kRasterTolerancePx / view.px_per_mm;
  const StrokeStyle* style = print_.grain.styles().find(stroke.medium());
  const Outline& outline = style ? styler_.ink(stroke, *style, tolerance_mm).outline
                                 : outliner_.trace(stroke, tolerance_mm);
  for (int top = 0; top < mask.height; top += kBandRows) {
    const int rows = std::min(kBandRows, mask.height - top);
    const std::size_t count = row * static_cast<std::size_t>(rows);
    const auto picture = [&](std::vector<std::uint8_t>& bytes) {
      bytes.assign(4 * count, 0);
      return Pixels{bytes.data(), mask.width, rows, std::ptrdiff_t{4} * mask.width,
                    PixelOrder::kRgba};
    };
    const View here = view.from({0.0, static_cast<double>(top)});
    const Pixels covered = picture(covered_), ink = picture(ink_);
    rasterizer_.fill(outline, here, covered.rect(), {0, 0, 0, 255}, covered);
    rasterizer_.draw(stroke, here, ink.rect(), print_.grain, ink);
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned whole = covered_[4 * i + 3], seen = ink_[4 * i + 3];
      const std::size_t at = row * static_cast<std::size_t>(top) + i;
      coverage_[at] = static_cast<std::uint8_t>(whole);
      if (whole == 0) continue;
      mask.seen[at] = static_cast<std::uint8_t>(std::min(255U, (255U * seen + whole / 2U) / whole));
    }
  }
}

Result<std::optional<GrainMask>> GrainMasks::of(const Stroke& stroke) {
  if (!(print_.dpi >= GrainPrint::kMinDpi) || !(print_.dpi <= GrainPrint::kMaxDpi)) {
    return fail(ErrorCode::kInvalidArgument,
                "the resolution of grain must be 20 to 1200 dots per inch");
  }
  const View page = View::at_dpi({area_.x0, area_.y0}, print_.dpi);
  const Rect side = page.area_px(area_);
  const auto too_many = [this] {
    return fail(ErrorCode::kLimitExceeded,
                "the grain of all strokes has more than 200 million pixels at " +
                    std::to_string(std::lround(print_.dpi)) +
                    " dots per inch; choose fewer, or a smaller part of the page");
  };
  if (!(side.width() < 1e6) || !(side.height() < 1e6)) return too_many();
  const PixelRect part = pixels_of(stroke.bounds(), area_, page);
  if (part.empty()) return std::nullopt;
  const std::int64_t pixels = std::int64_t{part.width()} * part.height();
  if (pixels > pixels_left_) return too_many();

  GrainMask mask;
  mask.width = part.width();
  mask.height = part.height();
  mask.area = page.area_mm({static_cast<double>(part.x0), static_cast<double>(part.y0)},
                           {static_cast<double>(part.x1), static_cast<double>(part.y1)});
  mask.seen.assign(static_cast<std::size_t>(pixels), 0);
  coverage_.assign(static_cast<std::size_t>(pixels), 0);
  StrokeData opaque = stroke.data();
  opaque.color = {0, 0, 0, 255};
  const Result<Stroke> black = Stroke::create(std::move(opaque));
  if (!black) return tl::unexpected(black.error());
  draw(*black, page.from({static_cast<double>(part.x0), static_cast<double>(part.y0)}), mask);
  bool is_whole = true;
  for (std::size_t i = 0; i < mask.seen.size() && is_whole; ++i) {
    is_whole = coverage_[i] < kSure || mask.seen[i] >= kWhole;
  }
  if (is_whole) return std::nullopt;
  pixels_left_ -= pixels;
  spread(mask, coverage_);
  return mask;
}

}  // namespace felt
