#pragma once

#include <memory>
#include <vector>

#include "felt/document/document.h"
#include "felt/render/image.h"
#include "felt/render/ink_scene.h"
#include "felt/render/page_painter.h"
#include "felt/render/tile_painter.h"
#include "felt/session/session.h"

namespace felt {

/// The picture of a drawing while a session changes it. Only the parts that changed are painted
/// again, so the cost follows the ink and not the size of the picture:
///
///   auto picture = SessionPicture::create(page, session_options.document);
///   session_options.on_edit = [&](const Edit& edit) { ok = (*picture)->apply(edit); };
///   ... events ...
///   const Result<const Image*> frame = (*picture)->update(session);
///
/// The picture is equal, byte for byte, to render_page() of Session::seen() with the same options
/// and PictureChoice::kMarked: layers that are out of view are not shown. While a gesture is in
/// progress, that document is the one with shown_edit(). Not thread-safe.
class SessionPicture {
 public:
  /// Requires PageOptions::area. Fails like PagePainter::create.
  static Result<std::unique_ptr<SessionPicture>> create(const PageOptions& page,
                                                        const Document& start);

  /// Applies an edit of the document (SessionOptions::on_edit). Fails if the edit does not fit the
  /// edits before (a bug).
  Result<void> apply(const Edit& edit);
  /// Paints what changed since the last call. Lines have the styles of the session's media, unless
  /// the picture has a grain, which has styles. Returns the picture, which is valid until the next
  /// call. Fails if a preview does not fit the document (a bug).
  Result<const Image*> update(const Session& session);
  /// Returns the number of pixels painted so far. Pixels that are painted twice count twice.
  [[nodiscard]] std::int64_t painted_pixels() const noexcept { return painted_; }

 private:
  SessionPicture(Image image, const View& view, const PageOptions& page, const Document& start);
  void set_materials(const Materials& materials);
  Result<void> use_view_of(const Session& session);
  void repaint();
  void paint(PixelRect part);
  [[nodiscard]] std::vector<PixelRect> damaged_parts() const;

  Image image_;
  View view_;
  Rgba paper_;
  InkStyle style_;
  InkScene scene_;
  TilePainter painter_;
  InkDamage damage_;
  std::vector<LayerId> hidden_;  // out of view in the picture, ascending
  std::int64_t painted_ = 0;
};

}  // namespace felt
