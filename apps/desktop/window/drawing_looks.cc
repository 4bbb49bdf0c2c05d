#include "desktop/window/drawing_looks.h"

#include <algorithm>

namespace felt::desktop {
namespace {

Viewport stored_view(const CanvasView& view) {
  const auto half = [](double px) { return 0.5 * px; };
  const Point center = view.to_mm({half(view.size().width()), half(view.size().height())});
  const auto near = [](double mm) { return std::clamp(mm, -Viewport::kMaxMm, Viewport::kMaxMm); };
  return {{near(center.x), near(center.y)},
          view.px_per_mm(),
          std::clamp(view.angle_deg(), -180.0, 180.0),
          view.is_mirrored()};
}

/// Returns the stored view, adapted to the present size of the widget.
CanvasView canvas_view(const Viewport& stored, const CanvasView& present) {
  CanvasView view;
  view.set_size(present.size());
  if (stored.mirrored) view.mirror();
  view.set_angle(stored.angle_deg);
  view.set_scale(stored.px_per_mm);
  view.center_on(stored.center);
  return view;
}

}  // namespace

DrawingLooks looks_of(Canvas& canvas, ColorsPanel& colors) {
  return {.report =
              [&](Drawing& drawing) {
                drawing.view = stored_view(canvas.view());
                drawing.palette = colors.shown_palette();
              },
          .show =
              [&](const Drawing& drawing) {
                if (drawing.view) canvas.set_view(canvas_view(*drawing.view, canvas.view()));
                colors.show_drawing_palette(drawing.palette);
              }};
}

}  // namespace felt::desktop
