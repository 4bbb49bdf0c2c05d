#pragma once

#include <QRectF>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "desktop/canvas/canvas_view.h"
#include "felt/render/image.h"
#include "felt/stroke/outline.h"
#include "felt/tools/overlay.h"

namespace felt::desktop {

/// From the sheet to device pixels.
struct DeviceView {
  CanvasView view;
  double dpr = 1.0;
  QPointF shift;  ///< of the picture, in pixels of the widget: less than one of the device

  [[nodiscard]] double px_per_mm() const noexcept { return view.px_per_mm() * dpr; }
  [[nodiscard]] Point to_px(Point mm) const {
    const QPointF px = view.to_px(mm);
    return {(px.x() + shift.x()) * dpr, (px.y() + shift.y()) * dpr};
  }
  [[nodiscard]] Point to_mm(Point px) const {
    return view.to_mm({px.x / dpr - shift.x(), px.y / dpr - shift.y()});
  }
  /// The device pixels that a part of the widget touches.
  [[nodiscard]] PixelRect pixels_of(const QRectF& part) const;
  /// The widget's pixels that these touch.
  [[nodiscard]] QRect part_of(const Rect& px) const;

  friend bool operator==(const DeviceView&, const DeviceView&) = default;
};

/// Curves of changing width as rows of dabs in device pixels: what wet ink and bands are drawn
/// from. Any part of the picture can be traced by itself, and looks exactly as if all of it had
/// been traced in one go, so that only what changed is ever painted again and ink with alpha
/// covers every place once.
class DabRows {
 public:
  /// Rasterisation is as fine as that of dry ink.
  void set_view(const DeviceView& view) { view_ = view; }
  void clear();
  /// Goes on where the last one ends, or begins another row. Widths of less than `least_px`
  /// (device pixels) are that.
  void add(const Overlay::InkSegment& segment, double least_px = 0.0);
  [[nodiscard]] std::size_t size() const noexcept { return pieces_.size(); }
  /// Keeps the first n segments.
  void keep(std::size_t n);
  static constexpr std::size_t kAll = static_cast<std::size_t>(-1);
  /// Around the ink of the segments from the n-th on, up to another, in device pixels.
  [[nodiscard]] Rect bounds(std::size_t from = 0, std::size_t to = kAll) const;

  /// Adds to `out` the outline of all that touches the part, for one fill by the non-zero rule.
  /// Right within the part only. Of the segments from the n-th on, up to another.
  void trace(const PixelRect& part, StrokeOutliner& outliner, Outline& out, std::size_t from = 0,
             std::size_t to = kAll) const;
  /// Calls `press(dab)` for dabs at most `step` of their radius apart, along all that touches it.
  template <class Press>
  void walk(const PixelRect& part, double step, Press press) const;

 private:
  struct Piece {
    std::size_t first = 0;  ///< dab that it begins on; the last one of the piece before in a row
    Rect box;               ///< device pixels, with its width
    bool begins_row = false;
  };
  [[nodiscard]] bool touches(const Piece& piece, const PixelRect& part) const noexcept;
  [[nodiscard]] std::size_t end_of(std::size_t piece) const noexcept;

  DeviceView view_;
  std::vector<Dab> dabs_;
  std::vector<Piece> pieces_;
};

template <class Press>
void DabRows::walk(const PixelRect& part, double step, Press press) const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!touches(pieces_[i], part)) continue;
    for (std::size_t k = pieces_[i].first; k + 1 < end_of(i); ++k) {
      const Dab &a = dabs_[k], &b = dabs_[k + 1];
      const double way = distance(a.center, b.center);
      const double thin = a.radius_mm < b.radius_mm ? a.radius_mm : b.radius_mm;
      const double steps = std::ceil(way / std::max(0.7, step * thin));
      for (double n = 0; n < std::max(1.0, steps); ++n) {
        const double t = steps > 0.0 ? n / steps : 0.0;
        press(Dab{lerp(a.center, b.center, t), a.radius_mm + t * (b.radius_mm - a.radius_mm)});
      }
    }
    press(dabs_[end_of(i) - 1]);
  }
}

}  // namespace felt::desktop
