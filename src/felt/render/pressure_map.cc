#include "felt/render/pressure_map.h"

#include <algorithm>

#include "felt/render/strip_lane.h"
#include "felt/render/wide_vectors.h"

namespace felt {
namespace {

/// The rows of a map that strips are laid on.
struct MapRows {
  PixelRect area;
  std::size_t stride;
  std::int32_t* values;
};

// Writes the push of one strip into the map: for each pixel, keeps the larger of the new and the
// old value. Eight pixels are processed at a time in plain loops over numbers, so that a compiler
// vectorizes them.
template <bool kTapers>
[[gnu::always_inline]] inline void walk(const TipStrip& strip, SoftEdge soft_edge,
                                        const MapRows& map) noexcept {
  const TipStrip w = strip;
  const SoftEdge edge = soft_edge;
  for (int y = w.y0; y < w.y1; ++y) {
    const PixelSpan span = span_in_row(w, y, map.area.x0, map.area.x1);
    const float py = static_cast<float>(y - w.home_y) + w.rest_y;
    std::int32_t* values = map.values + static_cast<std::size_t>(y - map.area.y0) * map.stride;
    for (int x = span.x0; x < span.x1; x += kTipLanes) {
      std::int32_t* lanes = values + (x - map.area.x0);
      for (int k = 0; k < kTipLanes; ++k) {
        const float px = static_cast<float>(x + k - w.home_x) + w.rest_x;
        const StripLane lane = strip_lane<kTapers>(w, edge, px, py);
        const std::int32_t laid = -lane.is_in & lane.value;
        lanes[k] = lanes[k] < laid ? laid : lanes[k];
      }
    }
  }
}

FELT_WIDE_VECTORS void walk_even(const TipStrip& strip, SoftEdge edge,
                                 const MapRows& map) noexcept {
  walk<false>(strip, edge, map);
}
FELT_WIDE_VECTORS void walk_tapering(const TipStrip& strip, SoftEdge edge,
                                     const MapRows& map) noexcept {
  walk<true>(strip, edge, map);
}

}  // namespace

void PressureMap::begin(PixelRect area, double edge) {
  area_ = area;
  const double from = 1.0 - std::clamp(edge, 0.0, 1.0);
  edge_from_ = edge > 0.0 ? static_cast<float>(from * from) : 2.0F;
  stride_ = static_cast<std::size_t>(area.width()) + kTipLanes;
  values_.assign(stride_ * static_cast<std::size_t>(area.height()), 0);
  strips_.clear();
}

double PressureMap::push_at(int x, int y) const noexcept {
  const std::int32_t value = row(y)[x - area_.x0];
  return value == 0
             ? kMinPush
             : kMinPush + (1.0 - kMinPush) * (value >> kPushShift) / static_cast<double>(kMaxKey);
}

void PressureMap::lay(std::span<const TipAt> way, Vec into, Vec out) {
  const std::size_t old = strips_.size();
  append_strips(way, into, out, area_, strips_);
  const SoftEdge edge{edge_from_, edge_from_ < 1.0F ? 1.0F / (1.0F - edge_from_) : 0.0F};
  const MapRows map{area_, stride_, values_.data()};
  for (std::size_t i = old; i < strips_.size(); ++i) {
    strips_[i].tapers ? walk_tapering(strips_[i], edge, map) : walk_even(strips_[i], edge, map);
  }
}

}  // namespace felt
