#pragma once

#include <QImage>
#include <QPainter>
#include <QRegion>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "desktop/canvas/dab_rows.h"
#include "felt/render/grain.h"
#include "felt/render/pressure_map.h"
#include "felt/render/raster.h"
#include "felt/render/visit_map.h"

namespace felt::desktop {

/// Fills rows of dabs with the same rasteriser and the same pixels that the library uses for dry
/// ink. Reuses its buffers.
class InkBrush {
 public:
  /// Paints the rows within `part` (widget pixels) in one colour. Where rows overlap, the colour is
  /// applied only once. Requires that the painter uses the widget's transform.
  void paint(QPainter& painter, const QRectF& part, const DeviceView& view, const DabRows& rows,
             Rgba color);
  /// Returns how much of each pixel the segments [from, to) cover, as the alpha channel of a white
  /// picture. The result is valid until the next call.
  QImage& cover(const DabRows& rows, std::size_t from, std::size_t to, const PixelRect& pixels);
  /// Does the same for an outline in device pixels.
  QImage& cover(const Outline& outline, const PixelRect& pixels);

 private:
  void fill(const DabRows& rows, std::size_t from, std::size_t to, const PixelRect& pixels,
            Rgba color);
  void fill(const Outline& outline, const PixelRect& pixels, Rgba color);

  Rasterizer rasterizer_;
  StrokeOutliner outliner_;
  Outline outline_;
  QImage image_;
};

/// The ink of the stroke in progress, which the tool shows as Overlay::ink sample by sample. It
/// looks exactly like the finished stroke, with the same edges, colour, alpha and grain. Segments
/// that no longer change are kept as a mask that stores the maximum coverage of each pixel.
/// Therefore each sample only requires painting the new segments and the provisional end, even if
/// the line crosses itself there.
///
/// A style depends on the whole stroke, so ink with a style is computed and painted again for every
/// update. Strokes of more than kMaxStyled segments are shown without their style until they are
/// finished, so that the cost of an update is bounded.
///
/// After the stroke has been added to the document, the worker may need a moment to update its
/// tiles. Until the tiles contain the stroke, the ink is *drying*: this class continues to paint
/// it.
class WetInkView {
 public:
  static constexpr std::size_t kMaxStyled = 400;

  void set_view(const DeviceView& view);
  /// Sets the grain, and the medium of the strokes in progress by its id.
  void set_grain(const Grain& grain, const std::string& medium);
  /// Sets whether ink is shown as hairlines.
  void set_outline_mode(bool on);

  /// Shows the ink of `overlay`. Returns the part of the widget that changed. Does not compare
  /// stable segments, so that the cost does not depend on the length of the stroke.
  QRegion update(const Overlay& overlay);
  /// Marks the wet ink as drying. Call it when the document contains the stroke. release() removes
  /// the drying ink and returns the part of the widget that it covered.
  void dry();
  [[nodiscard]] bool is_drying() const noexcept { return !drying_.empty(); }
  QRect release();
  [[nodiscard]] bool is_empty() const noexcept { return wet_.segments.empty(); }
  /// Returns the width of the wet ink at the pen, in mm.
  [[nodiscard]] double width_mm() const noexcept;

  /// A function that paints the layers above the wet ink onto `ink` (InkView::cover). `ink` is a
  /// picture with its top left corner at the device pixel `at`.
  using Cover = std::function<void(QImage& ink, QPoint at)>;
  void paint(QPainter& painter, const QRect& part, const Cover& cover = {});

 private:
  struct Row {
    std::vector<Overlay::InkSegment> segments;
    DabRows dabs;
    std::uint64_t stroke = 0;  ///< Overlay::ink_stroke
    std::size_t stable = 0;    ///< Overlay::ink_stable
    Rgba color;
    std::string medium;
    std::size_t firm = 0;  ///< number of segments at the start that the last update did not change
    std::size_t settled = 0;           ///< number of segments in the mask
    std::vector<std::uint8_t> mask{};  ///< one byte per device pixel
    bool has_style = false;
    Outline styled{};  ///< the ink, if it has a style
  };
  void add(Row& row, const Overlay::InkSegment& segment) const;
  void restyle(Row& row);
  void settle(Row& row, std::size_t to);
  void unsettle(Row& row) const;
  void paint_row(QPainter& painter, const QRect& part, const Row& row, const Cover& cover);
  void lay(const PixelRect& pixels, const Row& row, const InkLook& look);
  void ink_pixels(QImage& image, const PixelRect& pixels, const Row& row);
  [[nodiscard]] PixelRect screen() const;

  DeviceView view_;
  Grain grain_;
  std::string medium_ = "pencil";
  bool outline_mode_ = false;
  InkBrush brush_;
  StrokeStyler styler_;
  PressureMap pressure_;
  VisitMap visits_;
  std::vector<TipAt> way_;
  Row wet_;
  std::vector<Row> drying_;
};

/// Shows marked spans as bands below the ink, a little wider than the ink.
class BandView {
 public:
  void set_view(const DeviceView& view);
  /// Shows these spans. Returns the part of the widget that changed.
  QRect update(std::span<const Overlay::Span> spans);
  /// Paints the bands within `part`. `color_of(role)` must return an opaque colour, because pieces
  /// of a band overlap.
  template <class ColorOf>
  void paint(QPainter& painter, const QRect& part, InkBrush& brush, ColorOf color_of) const {
    for (const auto& [role, rows] : bands_) brush.paint(painter, part, view_, rows, color_of(role));
  }

 private:
  DabRows& rows_of(Overlay::Role role);
  void add(const Overlay::Span& span);

  DeviceView view_;
  std::vector<Overlay::Span> spans_;
  std::vector<std::pair<Overlay::Role, DabRows>> bands_;
};

}  // namespace felt::desktop
