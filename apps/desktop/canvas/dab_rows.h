#pragma once

#include <QRectF>
#include <cstddef>
#include <span>
#include <vector>

#include "desktop/canvas/canvas_view.h"
#include "felt/render/image.h"
#include "felt/render/styled_outline.h"
#include "felt/render/tip_strips.h"
#include "felt/render/view.h"
#include "felt/stroke/outline/outline.h"
#include "felt/tools/overlay.h"

namespace felt::desktop {

/// The transform from the page to device pixels.
struct DeviceView {
  CanvasView view;
  double dpr = 1.0;
  QPointF shift;  ///< a shift by less than one device pixel, in widget pixels

  [[nodiscard]] double px_per_mm() const noexcept { return view.px_per_mm() * dpr; }
  [[nodiscard]] Point to_px(Point mm) const {
    const QPointF px = view.to_px(mm);
    return {(px.x() + shift.x()) * dpr, (px.y() + shift.y()) * dpr};
  }
  [[nodiscard]] Point to_mm(Point px) const {
    return view.to_mm({px.x / dpr - shift.x(), px.y / dpr - shift.y()});
  }
  /// Returns the device pixels that the rectangle `part` of the widget touches.
  [[nodiscard]] PixelRect pixels_of(const QRectF& part) const;
  /// Returns the widget pixels that these device pixels touch.
  [[nodiscard]] QRect part_of(const Rect& px) const;
  /// Returns this transform for the renderer.
  [[nodiscard]] View as_view() const;

  friend bool operator==(const DeviceView&, const DeviceView&) = default;
};

/// Stores curves of changing width as rows of round dabs of ink, in device pixels. Wet ink and
/// bands are drawn from these rows. If only a part of the picture is traced, it looks exactly as if
/// the whole picture had been traced, so it is enough to paint the changed part again. All rows in
/// the painted part are filled in one pass, so that transparent ink does not overlap itself.
class DabRows {
 public:
  /// Sets the view. Curves are rasterised as finely as dry ink.
  void set_view(const DeviceView& view) { view_ = view; }
  void clear();
  /// Appends the segment to the last row if it starts at the end of that row; otherwise begins a
  /// new row. Widths below `min_px` (device pixels) are drawn as `min_px`.
  void add(const Overlay::InkSegment& segment, double min_px = 0.0);
  [[nodiscard]] std::size_t size() const noexcept { return pieces_.size(); }
  /// Keeps the first `n` segments and removes the others.
  void keep(std::size_t n);
  static constexpr std::size_t kAll = static_cast<std::size_t>(-1);
  /// Returns the bounds, in device pixels, of the ink of the segments [from, to).
  [[nodiscard]] Rect bounds(std::size_t from = 0, std::size_t to = kAll) const;

  /// Appends to `out` the outline of those segments of [from, to) that touch `part`. The caller
  /// must fill the whole outline in one pass with the non-zero rule. The outline is correct only
  /// within `part`.
  void trace(const PixelRect& part, StrokeOutliner& outliner, Outline& out, std::size_t from = 0,
             std::size_t to = kAll) const;
  /// Appends to `out` the outline of the stylised ink of all segments; it needs all of them. Any
  /// joint may be a corner.
  void trace_styled(StrokeStyler& styler, const StrokeStyle& style, Outline& out) const;
  /// Calls `lay(dabs, travels)` with the part of each row of dabs that touches `part`, and with
  /// TipAt::travel of these dabs.
  template <class Lay>
  void ways(const PixelRect& part, Lay lay) const;

 private:
  struct Piece {
    std::size_t first = 0;  ///< index of the first dab; unless begins_row is true, this is the last
                            ///< dab of the previous piece
    Rect box;               ///< bounds including the width, device pixels
    bool begins_row = false;
  };
  [[nodiscard]] bool touches(const Piece& piece, const PixelRect& part) const noexcept;
  [[nodiscard]] std::size_t end_of(std::size_t piece) const noexcept;

  DeviceView view_;
  void add_travels(const Piece& piece, double travel);

  std::vector<Dab> dabs_;
  std::vector<double> travels_;  // of dabs_
  std::vector<TipAt> tips_;
  std::vector<Piece> pieces_;
};

template <class Lay>
void DabRows::ways(const PixelRect& part, Lay lay) const {
  for (std::size_t i = 0; i < pieces_.size();) {
    if (!touches(pieces_[i], part)) {
      ++i;
      continue;
    }
    std::size_t next = i + 1;
    while (next < pieces_.size() && !pieces_[next].begins_row && touches(pieces_[next], part)) {
      ++next;
    }
    const std::size_t first = pieces_[i].first;
    const std::size_t count = end_of(next - 1) - first;
    lay(std::span<const Dab>(dabs_).subspan(first, count),
        std::span<const double>(travels_).subspan(first, count));
    i = next;
  }
}

}  // namespace felt::desktop
