#pragma once

#include <optional>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "felt/session/session.h"
#include "picture.h"

namespace felt::cli {

/// What the eye sees of a drawing session at one moment: the strokes, a gesture in work included
/// (its preview), what the tool shows besides them, and the pen.
struct SessionView {
  Document document;
  Overlay overlay;
  std::optional<Point> pen;  ///< none: it is not drawn
};

/// Takes a copy of it.
SessionView view_of(const Session& session, std::optional<Point> pen);

/// The part of the sheet that holds all of it.
Rect bounds_of(const SessionView& view);

/// The colour of a role, opaque: from the palette that people with any colour vision tell apart
/// (plot_color). Roles that never meet in one tool may share one.
Rgba role_color(Overlay::Role role) noexcept;

/// Draws a view: marked spans below the ink as broad bands, rings, tethers, vectors (with an arrow
/// head), outlines, dots and labels above it, the pen on top of all. Lines keep their width on the
/// picture whatever part of the sheet it shows, `scale` times 1/150 inch a unit. Labels are ASCII;
/// a degree sign becomes "deg". Error: as render_page.
Result<Image> draw_view(const SessionView& view, const PictureOptions& options, double scale = 1.0);

}  // namespace felt::cli
