#pragma once

#include <optional>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "felt/session/session.h"
#include "picture.h"

namespace felt::cli {

/// The visible state of a drawing session at one moment: the strokes, including a gesture in
/// progress (its preview), the tool's overlay, and the pen.
struct SessionView {
  Document document;
  Overlay overlay;
  std::optional<Point> pen;  ///< none: the pen is not drawn
};

/// Returns a copy of that state.
SessionView view_of(const Session& session, std::optional<Point> pen);

/// Returns the part of the page that contains all of it.
Rect bounds_of(const SessionView& view);

/// Returns the colour of a role, opaque, from the palette that is distinguishable with any colour
/// vision (plot_color). Roles that never occur in the same tool may share a colour.
Rgba role_color(Overlay::Role role) noexcept;

/// Draws a view: marked spans as broad bands below the ink; rings, tethers, vectors (with an arrow
/// head), outlines, dots and labels above it; the pen on top. Lines keep their width in the picture
/// for any part of the page, `scale` times 1/150 inch per unit. Labels are ASCII; a degree sign
/// becomes "deg". Fails like render_page.
Result<Image> draw_view(const SessionView& view, const PictureOptions& options, double scale = 1.0);

}  // namespace felt::cli
