#pragma once

#include <vector>

#include "felt/render/image.h"
#include "felt/render/view.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// How hard a stroke was pressed on, pixel by pixel, for grain. One thread; keeps its buffers.
///
/// The stroke is walked along, and where the tip has been its pressure is written: 1 in the middle
/// of the tip, less towards its edge, which touches the sheet less. Where the stroke crosses itself
/// the harder one stays, hence the order does not matter.
class PressureMap {
 public:
  /// Of this stroke, for the pixels of `area`.
  void make(const Stroke& stroke, const View& view, PixelRect area);
  /// The same by hand: of nothing yet, for the pixels of `area` ...
  void begin(PixelRect area);
  /// ... and then each place where the tip has been, a quarter of its radius apart at most.
  void press(Vec center_px, double radius_px, double pressure);
  /// 0..1 for a pixel of the area; 0 where the tip has not been.
  [[nodiscard]] float at(int x, int y) const noexcept {
    return values_[static_cast<std::size_t>(y - area_.y0) *
                       static_cast<std::size_t>(area_.width()) +
                   static_cast<std::size_t>(x - area_.x0)];
  }

 private:
  PixelRect area_;
  std::vector<float> values_;
};

}  // namespace felt
