#pragma once

#include <QObject>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// A line or a fill under the pen, for the eyedropper.
struct PickedInk {
  Rgba color;
  std::string medium;     ///< empty for a fill
  double width_mm = 0.0;  ///< width of the line at that point; 0 for a fill
};

/// Returns the ink of the topmost visible line or fill at the point. If there is none, returns the
/// nearest line within reach_mm, or nullopt. Takes linear time in the number of lines and fills.
std::optional<PickedInk> ink_at(const Document& document, Point at, double reach_mm);

/// The eyedropper: uses the colour of a line that is already drawn. If the pen is over the page, it
/// picks at once, otherwise at the next click on the page; Escape ends it. With Shift it also
/// uses the line's medium and width. Selected lines get the colour, too. Adds edit.pick_color and
/// edit.pick_all to the actions.
class Eyedropper : public QObject {
  Q_OBJECT

 public:
  Eyedropper(Actions& actions, Canvas& canvas);

  enum class What { kColor, kAll };

  /// Picks the ink at the point. Returns false if there is none; then the status line says so.
  bool pick(Point at, What what);
  /// Picks at the next click on the page.
  void arm(What what);
  [[nodiscard]] bool is_armed() const noexcept { return armed_.has_value(); }

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void start(What what);
  void disarm();
  void take_medium_and_width(const PickedInk& ink);

  Canvas& canvas_;
  Studio& studio_;
  std::optional<What> armed_;
};

}  // namespace felt::desktop
