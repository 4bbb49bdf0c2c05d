#pragma once

#include <QCursor>
#include <QPointF>
#include <cstdint>
#include <optional>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// Moves the view of a canvas by a drag: of the middle button, of the pen or mouse while Space is
/// held. The cursor says so.
class ViewDrag {
 public:
  enum class Kind : std::uint8_t { kPan, kZoom, kTurn };

  /// The canvas must outlive it.
  explicit ViewDrag(Canvas& canvas) : canvas_(canvas) {}

  /// The next drag will be of this kind (Space is held); none: no drag. Says so by the cursor.
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
  std::optional<QCursor> before_;  // what the canvas had
};

}  // namespace felt::desktop
