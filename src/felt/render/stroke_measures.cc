#include "felt/render/stroke_measures.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <type_traits>

#include "felt/render/segments_in_area.h"
#include "felt/render/tip_travel.h"

namespace felt {
namespace {

/// Returns true if two lists of numbers have the same bytes.
template <class T>
bool same_bytes(std::span<const T> a, std::span<const T> b) noexcept {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

bool StrokeMeasures::Entry::is_of(const Stroke& stroke) const noexcept {
  return closed == stroke.closed() &&
         same_bytes(std::span<const Point>(points), std::span(stroke.data().points)) &&
         same_bytes(std::span<const WidthKnot>(widths), stroke.widths());
}

void StrokeMeasures::use(const Stroke& stroke) {
  if (stroke.segment_count() < kMinKeptSegments) {
    measure(stroke, short_);
    current_ = &short_;
    return;
  }
  const auto found = std::find_if(kept_.rbegin(), kept_.rend(),
                                  [&stroke](const Entry& e) { return e.is_of(stroke); });
  if (found != kept_.rend()) {
    kept_.splice(kept_.end(), kept_, std::prev(found.base()));
    current_ = &kept_.back();
    return;
  }
  const auto size_of = [](std::size_t segments, std::size_t widths) { return segments + widths; };
  const std::size_t size =
      size_of(static_cast<std::size_t>(stroke.segment_count()), stroke.widths().size());
  while (!kept_.empty() && (kept_.size() >= kMaxKept || kept_segments_ + size > kMaxKeptSegments)) {
    kept_segments_ -= size_of(kept_.front().areas.size(), kept_.front().widths.size());
    kept_.pop_front();
  }
  Entry& entry = kept_.emplace_back();
  entry.points = stroke.data().points;
  entry.widths = stroke.data().widths;
  entry.closed = stroke.closed();
  measure(stroke, entry);
  kept_segments_ += size;
  current_ = &entry;
}

void StrokeMeasures::measure(const Stroke& stroke, Entry& entry) {
  ++measured_;
  entry.areas.clear();
  for (int i = 0; i < stroke.segment_count(); ++i) entry.areas.push_back(segment_area(stroke, i));
  entry.px_per_mm = 0.0;
}

std::span<const double> StrokeMeasures::travels(const Stroke& stroke, double px_per_mm) {
  Entry& entry = *current_;
  if (entry.px_per_mm == px_per_mm) return entry.travels;
  const auto radius = [&](int i) { return 0.5 * px_per_mm * stroke.width_mm(i); };
  entry.travels.assign(1, 0.0);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    Cubic px = stroke.segment(i);
    for (Point& p : px.p) p = {px_per_mm * p.x, px_per_mm * p.y};
    entry.travels.push_back(entry.travels.back() + segment_travel(px, radius(i), radius(i + 1)));
  }
  entry.px_per_mm = px_per_mm;
  return entry.travels;
}

}  // namespace felt
