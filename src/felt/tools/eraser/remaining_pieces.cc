#include "felt/tools/eraser/remaining_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/stroke/edit/split.h"

namespace felt {
namespace {

using Interval = ParameterSet::Interval;

/// Returns segment i of a stroke. On a closed stroke i may exceed the count and wraps around.
Cubic segment_of(const Stroke& stroke, int i) {
  return stroke.segment(i % stroke.segment_count());
}

/// Calls visit(curve) for each segment, or part of a segment, within `part` until it returns false.
template <class Visit>
void for_each_part(const Stroke& stroke, Interval part, Visit visit) {
  for (int i = static_cast<int>(part.from); i < part.to; ++i) {
    const double t0 = std::max(0.0, part.from - i), t1 = std::min(1.0, part.to - i);
    if (!visit(sub_segment(segment_of(stroke, i), t0, t1))) return;
  }
}

bool is_as_long_as(const Stroke& stroke, Interval part, double length_mm) {
  double chords = 0.0;
  for_each_part(stroke, part, [&](const Cubic& c) {
    chords += distance(c.p[0], c.p[3]);
    return chords < length_mm;
  });
  if (chords >= length_mm) return true;
  double length = 0.0;
  for_each_part(stroke, part, [&](const Cubic& c) {
    length += arc_length(c, 1e-6);
    return length < length_mm;
  });
  return length >= length_mm;
}

/// Returns `part` without the segments at its ends that are too short.
Interval without_slivers(const Stroke& stroke, Interval part) {
  const auto is_sliver = [&](int i, double t0, double t1) {
    return control_length(sub_segment(segment_of(stroke, i), t0, t1)) < kMinSegmentMm;
  };
  const int first = static_cast<int>(std::floor(part.from));
  if (part.from > first && part.to > first + 1 && is_sliver(first, part.from - first, 1.0)) {
    part.from = first + 1;
  }
  const int last = static_cast<int>(std::ceil(part.to)) - 1;
  if (part.to < last + 1 && part.from < last && is_sliver(last, 0.0, part.to - last)) {
    part.to = last;
  }
  return part;
}

Result<Stroke> sub_stroke_of(const Stroke& stroke, Interval part) {
  const double n = stroke.segment_count();
  const double from = part.from >= n ? part.from - n : part.from;
  return sub_stroke(stroke, from, part.to > n ? part.to - n : part.to);
}

}  // namespace

std::optional<std::vector<Interval>> RemainingPieces::gaps(const ParameterSet& erased) const {
  const double n = stroke_->segment_count();
  std::vector<Interval> holes;
  for (const Interval& hole : erased.intervals()) {
    double size = 0.0;
    for_each_part(*stroke_, hole, [&](const Cubic& c) {
      size += control_length(c);
      return size < kMinHoleMm;
    });
    if (size >= kMinHoleMm) holes.push_back(hole);
  }
  if (holes.empty()) return std::nullopt;
  std::vector<Interval> result;
  const auto add = [&](double from, double to) {
    if (from < to) result.push_back({from, to});
  };
  if (!stroke_->closed()) add(0.0, holes.front().from);
  for (std::size_t i = 0; i + 1 < holes.size(); ++i) add(holes[i].to, holes[i + 1].from);
  const double seam = holes.back().to;
  if (!stroke_->closed()) {
    add(seam, n);
  } else if (seam >= n) {
    add(0.0, holes.front().from);
  } else {
    add(seam, n + holes.front().from);
  }
  return result;
}

std::shared_ptr<const Stroke> RemainingPieces::make(Interval part) const {
  part = without_slivers(*stroke_, part);
  const double n = stroke_->segment_count();
  const double middle = 0.5 * (part.from + part.to);
  const double width = stroke_->width_mm(middle > n ? middle - n : middle);
  const double smallest = crumbs_ == Crumbs::kOfLine ? std::max(kMinPieceMm, 0.5 * width)
                                                     : std::max(kMinSegmentMm, kMinPieceMm - width);
  if (!is_as_long_as(*stroke_, part, smallest)) return nullptr;
  auto piece = sub_stroke_of(*stroke_, part);
  if (!piece) {
    // Making the piece can fail because of rounding if the ink is kilometres away from the page.
    // Then the piece contains only whole segments, because they are copied bit for bit.
    const Interval inner{std::ceil(part.from), std::floor(part.to)};
    if (inner.from >= inner.to) return nullptr;
    piece = sub_stroke_of(*stroke_, inner);
    if (!piece) return nullptr;
  }
  return std::make_shared<const Stroke>(*std::move(piece));
}

void RemainingPieces::cut(const ParameterSet& erased, std::vector<WidthKnot> widths) {
  const auto before = std::exchange(stroke_, whole_stroke_);
  if (!widths.empty()) {
    StrokeData data = whole_stroke_->data();
    data.widths = std::move(widths);
    auto narrowed = Stroke::create(std::move(data));
    if (narrowed) stroke_ = std::make_shared<const Stroke>(*std::move(narrowed));
  }
  const bool same_widths = std::ranges::equal(before->widths(), stroke_->widths());
  const auto parts = gaps(erased);
  const std::vector<Piece> old = std::exchange(pieces_, {});
  whole_ = !parts && stroke_ == whole_stroke_;
  if (whole_) return;
  if (!parts) {
    pieces_.push_back({0.0, static_cast<double>(stroke_->segment_count()), stroke_});
    return;
  }
  for (const Interval& part : *parts) {
    const auto same = std::lower_bound(old.begin(), old.end(), part.from,
                                       [](const Piece& p, double from) { return p.from < from; });
    const bool stays = same != old.end() && same->from == part.from && same->to == part.to;
    Piece piece{part.from, part.to, stays && same_widths ? same->stroke : make(part)};
    if (stays && piece.stroke && same->stroke && *piece.stroke == *same->stroke) {
      piece.stroke = same->stroke;
    }
    pieces_.push_back(std::move(piece));
  }
}

std::vector<std::shared_ptr<const Stroke>> RemainingPieces::pieces() const {
  std::vector<std::shared_ptr<const Stroke>> kept;
  for (const Piece& p : pieces_) {
    if (p.stroke) kept.push_back(p.stroke);
  }
  return kept;
}

}  // namespace felt
