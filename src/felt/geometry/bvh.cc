// Builds and changes the tree; the queries are in bvh_query.cc.
#include "felt/geometry/bvh.h"

#include <algorithm>
#include <limits>

#include "felt/base/check.h"
#include "felt/geometry/bvh_box.h"

namespace felt {

// Orders segments so that each run of 8, 64, 512, ... of them is close together.
struct SegmentBvh::Sorter {
  struct Key {
    float x, y;  // centre of the box
    std::uint32_t handle;
  };

  // Splits [first, last) near the middle, at a multiple of the largest power of 8 below its size,
  // along the axis in which the centres spread more, until each run fits into one node. Depth: log2
  // of the size.
  static void sort(Key* first, Key* last) noexcept {
    const auto count = static_cast<std::size_t>(last - first);
    if (count <= kFanOut) return;
    std::size_t unit = kFanOut;
    while (unit * kFanOut < count) unit *= kFanOut;
    const std::size_t children = (count + unit - 1) / unit;
    Key* const middle = first + static_cast<std::ptrdiff_t>(children / 2 * unit);
    if (wider_than_high(first, last)) {
      std::nth_element(first, middle, last, [](const Key& a, const Key& b) {
        return a.x != b.x ? a.x < b.x : a.handle < b.handle;
      });
    } else {
      std::nth_element(first, middle, last, [](const Key& a, const Key& b) {
        return a.y != b.y ? a.y < b.y : a.handle < b.handle;
      });
    }
    sort(first, middle);
    sort(middle, last);
  }

  static bool wider_than_high(const Key* first, const Key* last) noexcept {
    float x0 = first->x, x1 = x0, y0 = first->y, y1 = y0;
    for (const Key* k = first; k != last; ++k) {
      x0 = std::min(x0, k->x), x1 = std::max(x1, k->x);
      y0 = std::min(y0, k->y), y1 = std::max(y1, k->y);
    }
    return x1 - x0 >= y1 - y0;
  }

  // Returns the centre of the box of a segment. A segment that is not finite is sorted far away, so
  // that it does not enlarge the boxes of others.
  static Key key(const Cubic& curve, std::uint32_t handle) noexcept {
    const Rect box = bounds(curve);
    if (box.empty()) return {float_above(kBvhFarthest), float_above(kBvhFarthest), handle};
    return {float_below(0.5 * box.x0 + 0.5 * box.x1), float_below(0.5 * box.y0 + 0.5 * box.y1),
            handle};
  }
};

void SegmentBvh::build(std::span<const BvhSegment> segments) {
  FELT_CHECK(segments.size() <= std::size_t{1} << 31U);
  std::vector<Sorter::Key> keys(segments.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = Sorter::key(segments[i].curve, i);
  Sorter::sort(keys.data(), keys.data() + keys.size());
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](const Sorter::Key& key) { return key.handle; });
  lay_out(segments, order);
}

void SegmentBvh::rebuild() {
  std::vector<BvhSegment> segments(size());
  for (std::uint32_t h = 0; h < segments.size(); ++h) segments[h] = {curve(h), refs_[h]};
  build(segments);
}

void SegmentBvh::lay_out(std::span<const BvhSegment> segments,
                         std::span<const std::uint32_t> order) {
  const std::size_t n = segments.size();
  levels_ = 0;
  std::size_t total = 0;
  for (std::size_t count = n; levels_ == 0 ? n > 0 : count > 1;) {
    count = (count + kFanOut - 1) / kFanOut;
    level_begin_[levels_++] = total;
    total += count;
  }
  Node empty{};
  for (unsigned i = 0; i < kFanOut; ++i) Box().store(empty, i);
  nodes_.assign(total, empty);
  handles_.assign(order.begin(), order.end());
  curves_.resize(n);
  slots_.resize(n);
  refs_.resize(n);
  for (std::uint32_t slot = 0; slot < n; ++slot) {
    const std::uint32_t handle = handles_[slot];
    curves_[slot] = segments[handle].curve;
    refs_[handle] = segments[handle].ref;
    slots_[handle] = slot;
    Box(bounds(curves_[slot])).store(nodes_[slot / kFanOut], slot % kFanOut);
  }
  fill_inner_levels();
}

void SegmentBvh::fill_inner_levels() noexcept {
  inner_half_perimeters_ = 0.0;
  for (unsigned level = 1; level < levels_; ++level) {
    const std::size_t below = level_begin_[level] - level_begin_[level - 1];
    for (std::size_t j = 0; j < below; ++j) {
      const Box box(nodes_[level_begin_[level - 1] + j]);
      box.store(nodes_[level_begin_[level] + j / kFanOut], static_cast<unsigned>(j % kFanOut));
      inner_half_perimeters_ += box.half_perimeter();
    }
  }
  built_half_perimeters_ = inner_half_perimeters_;
}

void SegmentBvh::refit(std::uint32_t handle, const Cubic& curve) noexcept {
  const std::uint32_t slot = slots_[handle];
  curves_[slot] = curve;
  set_box(slot, Box(bounds(curve)));
}

void SegmentBvh::replace(std::uint32_t handle, const BvhSegment& segment) noexcept {
  refs_[handle] = segment.ref;
  refit(handle, segment.curve);
}

void SegmentBvh::erase(std::uint32_t handle) noexcept {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  constexpr Point kHole{kNowhere, kNowhere};
  refit(handle, Cubic{{kHole, kHole, kHole, kHole}});
}

void SegmentBvh::set_box(std::uint32_t slot, const Box& box) noexcept {
  Box changed = box;
  std::size_t child = slot;
  for (unsigned level = 0; level < levels_; ++level) {
    Node& node = nodes_[level_begin_[level] + child / kFanOut];
    const Box before(node, child % kFanOut);
    if (before == changed) return;  // if so, the boxes above do not change either
    if (level > 0) inner_half_perimeters_ += changed.half_perimeter() - before.half_perimeter();
    changed.store(node, child % kFanOut);
    changed = Box(node);
    child /= kFanOut;
  }
}

double SegmentBvh::degradation() const noexcept {
  return built_half_perimeters_ > 0.0 ? inner_half_perimeters_ / built_half_perimeters_ : 1.0;
}

}  // namespace felt
