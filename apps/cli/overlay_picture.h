#pragma once

#include <optional>
#include <string>

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
  std::optional<Point> pen;  ///< nullopt if the pen is not drawn
};

/// Returns a copy of the session's visible state, with the pen at `pen`.
SessionView view_of(const Session& session, std::optional<Point> pen);

/// Returns the smallest part of the page that contains everything in `view`.
Rect bounds_of(const SessionView& view);

/// Returns the opaque colour of a role. It is one of the colours of plot_color(), which people with
/// any kind of colour vision can distinguish. Roles that never occur in the same tool may share a
/// colour.
Rgba role_color(Overlay::Role role) noexcept;

/// Draws a view: marked spans as broad bands below the ink; the guides of the document, cut at the
/// edges of the picture, above it, and then rings, tethers, vectors (with an arrow
/// head), outlines, dots and labels above it; the pen on top. The width of overlay lines is a
/// multiple of `scale` / 150 inch and does not depend on how much of the page is shown. Labels are
/// ASCII; a degree sign becomes "deg". Fails like render_page().
Result<Image> draw_view(const SessionView& view, const PictureOptions& options, double scale = 1.0);

/// Returns the same picture as an SVG for web pages (svg_compact.h), with the labels as text. The
/// grain and the pictures of layers are not shown. Fails like svg_compact_text().
Result<std::string> view_svg(const SessionView& view, const PictureOptions& options,
                             double scale = 1.0);

}  // namespace felt::cli
