#include "desktop/canvas/mirrored_ink_view.h"

#include <algorithm>

namespace felt::desktop {

void MirroredInkView::set_view(const DeviceView& view) {
  view_ = view;
  for (WetInkView& each : views_) each.set_view(view);
}

void MirroredInkView::set_grain(const Grain& grain, const std::string& medium) {
  grain_ = grain;
  medium_ = medium;
  for (WetInkView& each : views_) each.set_grain(grain, medium);
}

void MirroredInkView::set_outline_mode(bool on) {
  outline_mode_ = on;
  for (WetInkView& each : views_) each.set_outline_mode(on);
}

namespace {

/// Sets `image` to an image of the ink of an overlay.
void set_image(Overlay& image, const Overlay& overlay, const Affine& map) {
  for (const Overlay::InkSegment& segment : overlay.ink) {
    image.ink.push_back(mapped(segment, map));
  }
  image.ink_stroke = overlay.ink_stroke;
  image.ink_stable = overlay.ink_stable;
}

}  // namespace

QRegion MirroredInkView::update(const Overlay& overlay) {
  QRegion dirty = views_.front().update(overlay);
  const std::size_t images = overlay.ink.empty() ? 0 : overlay.ink_images.size();
  while (views_.size() < images + 1) {
    WetInkView& added = views_.emplace_back();
    added.set_view(view_);
    added.set_grain(grain_, medium_);
    added.set_outline_mode(outline_mode_);
  }
  for (std::size_t i = 1; i < views_.size(); ++i) {
    image_.clear();
    image_.ink_color = overlay.ink_color;
    if (i <= images) set_image(image_, overlay, overlay.ink_images[i - 1]);
    dirty += views_[i].update(image_);
  }
  return dirty;
}

void MirroredInkView::dry() {
  for (WetInkView& each : views_) each.dry();
}

QRegion MirroredInkView::release() {
  QRegion dirty;
  for (WetInkView& each : views_) dirty += each.release();
  return dirty;
}

void MirroredInkView::paint(QPainter& painter, const QRect& part, const WetInkView::Cover& cover) {
  for (WetInkView& each : views_) each.paint(painter, part, cover);
}

}  // namespace felt::desktop
