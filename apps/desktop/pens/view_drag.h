#pragma once

#include <QCursor>
#include <QPointF>
#include <cstdint>
#include <optional>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// Pans, zooms or turns the view of a canvas, or changes the size of the tool, when the user
/// drags. A drag with the middle button, or
/// with a button that has the role kPan, pans; a drag with pen or mouse while Space is held has the
/// kind set by offer(). The shape of the cursor shows the kind of drag.
class ViewDrag {
 public:
  enum class Kind : std::uint8_t { kPan, kZoom, kTurn, kSize };

  /// The canvas must outlive this object.
  explicit ViewDrag(Canvas& canvas) : canvas_(canvas) {}

  /// Sets the kind of the next drag and shows the cursor for it. Called when Space is pressed. Also
  /// called with nullopt when Space is released; the next drag then does not move the view.
  void offer(std::optional<Kind> kind);
  [[nodiscard]] std::optional<Kind> offered() const noexcept { return offered_; }

  void begin(Kind kind, QPointF px);
  void move(QPointF px);
  void end();
  [[nodiscard]] bool is_on() const noexcept { return kind_.has_value(); }

 private:
  void show_cursor();

  Canvas& canvas_;
  std::optional<Kind> offered_, kind_;
  QPointF start_, last_;
  double start_size_mm_ = 0.0;
  std::optional<QCursor> before_;  // the canvas's cursor before the drag
};

}  // namespace felt::desktop
