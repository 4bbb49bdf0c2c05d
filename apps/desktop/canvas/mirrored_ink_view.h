#pragma once

#include <string>
#include <vector>

#include "desktop/canvas/wet_ink_view.h"

namespace felt::desktop {

/// The ink of the stroke in progress and its mirror images (Overlay::ink_images). The functions are
/// those of WetInkView, and act on the stroke and on all its images.
class MirroredInkView {
 public:
  void set_view(const DeviceView& view);
  void set_grain(const Grain& grain, const std::string& medium);
  void set_outline_mode(bool on);
  QRegion update(const Overlay& overlay);
  void dry();
  [[nodiscard]] bool is_drying() const noexcept { return views_.front().is_drying(); }
  QRegion release();
  [[nodiscard]] bool is_empty() const noexcept { return views_.front().is_empty(); }
  [[nodiscard]] double width_mm() const noexcept { return views_.front().width_mm(); }
  void paint(QPainter& painter, const QRect& part, const WetInkView::Cover& cover = {});

 private:
  std::vector<WetInkView> views_{1};  // of the stroke, then of its images
  DeviceView view_;
  Grain grain_;
  std::string medium_ = "pencil";
  bool outline_mode_ = false;
  Overlay image_;
};

}  // namespace felt::desktop
