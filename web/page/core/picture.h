#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "felt/document/page.h"
#include "felt/render/tile_painter.h"
#include "felt/tools/overlay.h"

namespace felt::page {

/// Wet ink as strokes, which the rasteriser draws like dry ink. Converts again only what changed.
class WetInk {
 public:
  /// Shows the ink of this overlay in this medium. Adds the area that looks different to `damage`.
  void update(const Overlay& overlay, const std::string& medium, InkDamage& damage);
  [[nodiscard]] bool is_empty() const noexcept { return segments_.empty(); }
  [[nodiscard]] const std::vector<StrokePtr>& strokes() const noexcept { return strokes_; }
  [[nodiscard]] double width_mm() const noexcept {
    return segments_.empty() ? 0.0 : segments_.back().end_width_mm;
  }

 private:
  void remake();

  std::vector<Overlay::InkSegment> segments_;
  std::vector<Affine> images_;
  Rgba color_{};
  std::string medium_;
  std::vector<StrokePtr> strokes_;
};

/// The picture on the canvas: desk, paper, ink, previews and wet ink, in device pixels. It is kept
/// from frame to frame and repainted where it changed, in tiles.
class Picture {
 public:
  Picture();

  void open(const Document& document);
  void apply(const Edit& edit);
  void show(const std::optional<Edit>& preview);
  void show_wet(const Overlay& overlay, const std::string& medium, double opacity);

  void resize(int width, int height);
  /// If only the place on the page changes, by whole pixels, the picture is moved; otherwise it is
  /// scaled until it is painted again.
  void set_view(const View& view);
  [[nodiscard]] const View& view() const noexcept { return view_; }
  void set_ground(const Page& page, Rgba desk);
  void set_grain(const Grain& grain);
  [[nodiscard]] const Grain& grain() const noexcept { return style_.grain; }

  /// Repaints what changed, until `is_late` returns true; then the rest is left for the next call.
  /// Returns true if there is more to do.
  bool paint(const std::function<bool()>& is_late);
  [[nodiscard]] bool is_stale() const noexcept;
  /// The pixels that the last paint() changed.
  [[nodiscard]] PixelRect painted() const noexcept { return painted_; }
  [[nodiscard]] Pixels pixels() noexcept { return of(shown_); }
  [[nodiscard]] const WetInk& wet() const noexcept { return wet_; }

 private:
  struct Tile {
    PixelRect dirty{};  // in the picture
    bool is_missing = false;
    TileSplit split;
  };

  [[nodiscard]] Pixels of(std::vector<std::uint8_t>& bytes) const noexcept;
  [[nodiscard]] PixelRect all() const noexcept { return {0, 0, width_, height_}; }
  [[nodiscard]] PixelRect pixels_of(const Rect& mm) const noexcept;
  [[nodiscard]] PixelRect rect_of(std::size_t tile) const noexcept;
  void damage(const InkDamage& areas);
  void damage(PixelRect px, bool is_missing);
  void drop_splits();
  void paint_tile(std::size_t index);
  void paint_ground(PixelRect part, Pixels target) const;
  void paint_wet(PixelRect part);
  void move(int dx, int dy);
  void scale_from(const View& before);

  int width_ = 0, height_ = 0, columns_ = 0;
  View view_{{0, 0}, 4.0};
  Page page_;
  Rgba desk_{200, 200, 204, 255};
  InkStyle style_;
  std::unique_ptr<InkScene> scene_;
  TilePainter painter_;
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> base_;   // without wet ink
  std::vector<std::uint8_t> shown_;  // with wet ink
  std::vector<std::uint8_t> tile_;   // of one tile, transparent
  WetInk wet_;
  double wet_opacity_ = 1.0;
  PixelRect wet_dirty_{}, painted_{}, moved_{};
};

}  // namespace felt::page
