#pragma once

#include <QColor>
#include <QPainter>
#include <QPalette>
#include <QRect>

#include "desktop/canvas/canvas_view.h"
#include "felt/document/page.h"

namespace felt::desktop {

/// The background of the canvas: the area around the page in a colour of the theme, a soft shadow,
/// and the page. The page keeps its own colour in a dark theme.
class Desk {
 public:
  void set_page(const Page& page) { page_ = page; }
  void set_palette(const QPalette& palette);
  [[nodiscard]] QColor color() const noexcept { return color_; }
  /// Returns the opaque colour below the ink; white if the page has no paper colour.
  [[nodiscard]] QColor paper() const;
  void paint(QPainter& painter, const QRect& part, const CanvasView& view) const;

 private:
  void paint_edge(QPainter& painter, const QPolygonF& page) const;

  Page page_;
  QColor color_{Qt::gray};
  bool is_dark_ = false;
};

}  // namespace felt::desktop
