#include "felt/render/visit_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/render/strip_lane.h"
#include "felt/render/wide_vectors.h"

namespace felt {
namespace {

/// Directions of a stretch differ from its first one by at most 45 degrees. So its chord is at
/// least 0.7 of its length, and two of its points that are kSameVisit widths or more apart along
/// the path do not cover the same pixel.
constexpr float kCosOfStretch = 0.707F;

/// What a strip lays on the eight pixels of a row of a block.
struct LaneRow {
  std::int32_t values[kTipLanes];  // 0 if the strip does not cover the pixel
  float travels[kTipLanes];
};

/// Computes a row. The lower bits of rho^2 become the coverage: 1 half a pixel inside of the edge
/// of the line, 0 half a pixel outside, linear in the squared distance.
template <bool kTapers>
[[gnu::always_inline]] inline void fill_lanes(const TipStrip& w, SoftEdge edge, int x, float py,
                                              LaneRow& row) noexcept {
  constexpr auto kSteps = static_cast<float>(VisitMap::kCoverSteps);
  constexpr std::int32_t kCoverBits = VisitMap::kCoverSteps << PressureMap::kRimShift;
  for (int k = 0; k < kTipLanes; ++k) {
    const float px = static_cast<float>(x + k - w.home_x) + w.rest_x;
    const StripLane lane = strip_lane<kTapers>(w, edge, px, py);
    const float wide = 2.0F * lane.radius - 1.0F;
    const float inside = (lane.radius * lane.radius - lane.beside2) / (wide > 0.5F ? wide : 0.5F);
    const float covered = clamped_lane(inside, 0.0F, 1.0F);
    const auto cover = static_cast<std::int32_t>(covered * kSteps + 0.5F);
    const std::int32_t is_in = lane.is_in & static_cast<std::int32_t>(cover > 0);
    const std::int32_t value = (lane.value & ~kCoverBits) | (cover << PressureMap::kRimShift);
    row.values[k] = -is_in & value;
    row.travels[k] = w.travel0 + lane.t * w.dtravel;
  }
}

/// Makes space for a new visit in the lanes in which the strip begins one.
[[gnu::always_inline]] inline void begin_visits(const LaneRow& row, std::int32_t* values,
                                                float* travels) noexcept {
  std::int32_t begins[kTipLanes];
  int count = 0;
  for (int k = 0; k < kTipLanes; ++k) {
    begins[k] = static_cast<std::int32_t>(row.values[k] != 0) &
                static_cast<std::int32_t>(values[k] != 0) &
                static_cast<std::int32_t>(row.travels[k] - travels[k] > VisitMap::kSameVisit);
    count += begins[k];
  }
  if (count == 0) return;
  // Sorts the last visit among the earlier ones, largest push first; the smallest drops out.
  std::int32_t last[kTipLanes];
  float last_travels[kTipLanes];
  for (int k = 0; k < kTipLanes; ++k) {
    last[k] = begins[k] != 0 ? values[k] : 0;
    last_travels[k] = travels[k];
  }
  for (int n = 1; n < VisitMap::kMax; ++n) {
    std::int32_t* slot = values + n * kTipLanes;
    float* slot_travels = travels + n * kTipLanes;
    for (int k = 0; k < kTipLanes; ++k) {
      const bool is_larger = last[k] > slot[k];
      const std::int32_t value = slot[k];
      const float travel = slot_travels[k];
      slot[k] = is_larger ? last[k] : value;
      slot_travels[k] = is_larger ? last_travels[k] : travel;
      last[k] = is_larger ? value : last[k];
      last_travels[k] = is_larger ? travel : last_travels[k];
    }
  }
  for (int k = 0; k < kTipLanes; ++k) values[k] = begins[k] != 0 ? 0 : values[k];
}

/// Keeps the larger push of the newest visit.
[[gnu::always_inline]] inline void keep_larger(const LaneRow& row, std::int32_t* values,
                                               float* travels) noexcept {
  for (int k = 0; k < kTipLanes; ++k) {
    const bool is_larger = row.values[k] > values[k];
    values[k] = is_larger ? row.values[k] : values[k];
    travels[k] = is_larger ? row.travels[k] : travels[k];
  }
}

/// The blocks of a map, and the buffers of those that are searched.
struct SearchedBlocks {
  PixelRect area;
  std::size_t columns;
  const std::int32_t* blocks;
  std::int32_t* values;
  float* travels;
};

/// Adds a strip to the blocks that are searched.
template <bool kTapers>
[[gnu::always_inline]] inline void lay_visit(const TipStrip& strip, SoftEdge soft_edge,
                                             const SearchedBlocks& map) noexcept {
  constexpr int kSide = kTipLanes;
  constexpr std::size_t kPerRow = std::size_t{VisitMap::kMax} * kSide;
  const TipStrip w = strip;
  const SoftEdge edge = soft_edge;
  for (int y = w.y0; y < w.y1; ++y) {
    const PixelSpan span = span_in_row(w, y, map.area.x0, map.area.x1);
    if (span.x0 >= span.x1) continue;
    const float py = static_cast<float>(y - w.home_y) + w.rest_y;
    const int row_in_block = (y - map.area.y0) % kSide;
    const std::int32_t* blocks =
        map.blocks + static_cast<std::size_t>((y - map.area.y0) / kSide) * map.columns;
    for (int column = (span.x0 - map.area.x0) / kSide; map.area.x0 + column * kSide < span.x1;
         ++column) {
      if (blocks[column] >= 0) continue;
      LaneRow row;
      fill_lanes<kTapers>(w, edge, map.area.x0 + column * kSide, py, row);
      const std::size_t first = (static_cast<std::size_t>(-1 - blocks[column]) * kSide +
                                 static_cast<std::size_t>(row_in_block)) *
                                kPerRow;
      begin_visits(row, map.values + first, map.travels + first);
      keep_larger(row, map.values + first, map.travels + first);
    }
  }
}

FELT_WIDE_VECTORS void lay_even_visit(const TipStrip& strip, SoftEdge edge,
                                      const SearchedBlocks& map) noexcept {
  lay_visit<false>(strip, edge, map);
}
FELT_WIDE_VECTORS void lay_tapering_visit(const TipStrip& strip, SoftEdge edge,
                                          const SearchedBlocks& map) noexcept {
  lay_visit<true>(strip, edge, map);
}

}  // namespace

void VisitMap::find(const PressureMap& map, double ring) {
  area_ = map.area();
  ring_ = static_cast<float>(ring);
  has_visits_ = false;
  if (area_.empty()) return;
  const auto blocks = [](int pixels) {
    return static_cast<std::size_t>((pixels + kSide - 1) / kSide);
  };
  columns_ = blocks(area_.width());
  blocks_.assign(columns_ * blocks(area_.height()), 0);
  searched_ = 0;
  mark(map.strips());
  if (searched_ == 0) return;
  has_visits_ = true;
  values_.assign(searched_ * kSide * kPerRow, 0);
  travels_.assign(searched_ * kSide * kPerRow, 0.0F);
  const float from = map.edge_from();
  const SoftEdge edge{from, from < 1.0F ? 1.0F / (1.0F - from) : 0.0F};
  const SearchedBlocks table{area_, columns_, blocks_.data(), values_.data(), travels_.data()};
  for (const TipStrip& strip : map.strips()) {
    strip.tapers ? lay_tapering_visit(strip, edge, table) : lay_even_visit(strip, edge, table);
  }
}

/// Divides the path into stretches, and finds the blocks that more than one stretch touches.
void VisitMap::mark(std::span<const TipStrip> strips) {
  if (strips.size() < 2) return;
  std::int32_t stretch = 0;
  float dx = 0.0F, dy = 0.0F, end = std::numeric_limits<float>::infinity();
  for (const TipStrip& strip : strips) {
    const bool continues = std::abs(strip.travel0 - end) <= 1e-3F + 1e-6F * end;
    if (!continues || dx * strip.dx + dy * strip.dy < kCosOfStretch) {
      ++stretch;
      dx = strip.dx;
      dy = strip.dy;
    }
    end = strip.travel0 + strip.dtravel;
    mark_strip(strip, stretch);
  }
}

/// Marks the blocks around a strip, piece by piece.
void VisitMap::mark_strip(const TipStrip& strip, std::int32_t stretch) {
  const float radius = std::max(strip.r0, strip.r0 + strip.dr) + 1.0F;
  const float from = std::max(strip.low, -radius), to = std::min(strip.high, strip.len + radius);
  const float step = std::max(static_cast<float>(kSide), 0.5F * radius);
  const float start_x = 0.5F - strip.rest_x, start_y = 0.5F - strip.rest_y;  // from `home`
  const auto column = [](float px, int low, int high) {
    return (std::clamp(static_cast<int>(std::floor(px)), low, high - 1) - low) / kSide;
  };
  for (float at = from; at <= to; at += step) {
    const float next = std::min(at + step, to);
    const float x0 = std::min(at * strip.dx, next * strip.dx) - radius + start_x;
    const float x1 = std::max(at * strip.dx, next * strip.dx) + radius + start_x;
    const float y0 = std::min(at * strip.dy, next * strip.dy) - radius + start_y;
    const float y1 = std::max(at * strip.dy, next * strip.dy) + radius + start_y;
    const int left = area_.x0 - strip.home_x, top = area_.y0 - strip.home_y;
    const int right = area_.x1 - strip.home_x, bottom = area_.y1 - strip.home_y;
    if (x1 < static_cast<float>(left) || x0 > static_cast<float>(right) ||
        y1 < static_cast<float>(top) || y0 > static_cast<float>(bottom)) {
      continue;
    }
    const int first = column(x0, left, right), last = column(x1, left, right);
    for (int row = column(y0, top, bottom); row <= column(y1, top, bottom); ++row) {
      std::int32_t* blocks = blocks_.data() + static_cast<std::size_t>(row) * columns_;
      for (int i = first; i <= last; ++i) {
        if (blocks[i] == 0) {
          blocks[i] = stretch;
        } else if (blocks[i] > 0 && blocks[i] != stretch) {
          blocks[i] = -1 - static_cast<std::int32_t>(searched_++);
        }
      }
    }
  }
}

}  // namespace felt
