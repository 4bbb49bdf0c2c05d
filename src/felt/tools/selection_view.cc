#include "felt/tools/selection_view.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace felt {

namespace {

/// If so few strokes have too many segments, only the first segments are marked.
constexpr std::size_t kFewStrokes = 16;

}  // namespace

bool is_editable(const Document& document, StrokeId id) {
  const Layer* layer = document.layer(document.layer_of(id));
  return layer && layer->visible && !layer->locked;
}

void SelectionView::look(const Document& document, const Selection& selection) {
  go_on(document, selection, kPointsPerLook);
}

void SelectionView::look_at_all(const Document& document, const Selection& selection) {
  start_over();
  go_on(document, selection, std::numeric_limits<std::size_t>::max());
}

bool SelectionView::go_on(const Document& document, const Selection& selection,
                          std::size_t points) {
  if (!looked_at_) {
    Sight fresh;
    std::swap(fresh.spans, round_.spans);  // reuses the memory
    std::swap(fresh.span_ends, round_.span_ends);
    fresh.spans.clear();
    fresh.span_ends.clear();
    round_ = std::move(fresh);
  }
  std::size_t looked = 0;
  auto next = selection.strokes().upper_bound(looked_at_);
  for (; next != selection.strokes().end() && looked < points; ++next) {
    const auto& [id, marks] = *next;
    looked_at_ = id;
    const StrokePtr stroke = document.find(id);
    if (!stroke || stroke->data().points.size() != marks.size()) continue;
    looked += marks.size();
    if (is_editable(document, id)) add(id, *stroke, marks);
  }
  if (next != selection.strokes().end()) return false;
  round_.marks = round_.hash.value();
  round_.hash.add_value(round_.box);
  if (!round_.box.empty()) {
    round_.ink_box.extend(Point{round_.box.x0, round_.box.y0});
    round_.ink_box.extend(Point{round_.box.x1, round_.box.y1});
  }
  round_.fingerprint = round_.hash.value();
  std::swap(seen_, round_);
  looked_at_ = {};
  return true;
}

void SelectionView::add(StrokeId id, const Stroke& stroke, const Selection::Marks& marks) {
  ++round_.strokes;
  round_.hash.add_value(id.value);
  round_.hash.add(std::as_bytes(std::span(marks)));
  bool whole = true;
  const auto& points = stroke.data().points;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i]) {
      round_.box.extend(points[i]);
    } else {
      whole = false;
    }
  }
  if (!whole) ++round_.partial;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    if (!marks[at] && !marks[at + 1] && !marks[at + 2] && !marks[at + 3]) continue;
    const double beside = 0.5 * stroke.width_mm(i + 0.5) - kBesideMm;
    const Rect ink = bounds(stroke.segment(i)).inflated(std::max(0.0, beside));
    round_.ink_box.extend(Point{ink.x0, ink.y0});
    round_.ink_box.extend(Point{ink.x1, ink.y1});
  }
  mark(stroke, marks);
}

void SelectionView::mark(const Stroke& stroke, const Selection::Marks& marks) {
  if ((round_.strokes - 1) % round_.stride != 0) return;
  std::size_t added = 0;
  for (int i = 0; i < stroke.segment_count() && added < kMaxSpans; ++i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    const int marked = marks[at] + marks[at + 1] + marks[at + 2] + marks[at + 3];
    if (marked == 0) continue;
    const bool goes = marks[at] && marks[at + 3];
    round_.spans.push_back({stroke.segment(i), stroke.width_mm(i + 0.5),
                            goes ? Overlay::Role::kSelected : Overlay::Role::kSpan});
    ++added;
  }
  round_.span_ends.push_back(round_.spans.size());
  while (round_.spans.size() > kMaxSpans) {
    if (round_.span_ends.size() > kFewStrokes) {
      thin_out();
    } else {
      round_.spans.resize(kMaxSpans);
      round_.span_ends.back() = kMaxSpans;
    }
  }
}

void SelectionView::thin_out() {
  std::size_t kept = 0, spans = 0, begin = 0;
  for (std::size_t i = 0; i < round_.span_ends.size(); ++i) {
    const std::size_t end = round_.span_ends[i];
    if (i % 2 == 0) {
      for (std::size_t k = begin; k < end; ++k) round_.spans[spans++] = round_.spans[k];
      round_.span_ends[kept++] = spans;
    }
    begin = end;
  }
  round_.span_ends.resize(kept);
  round_.spans.resize(spans);
  round_.stride *= 2;
}

void SelectionView::draw(Overlay& overlay) const {
  overlay.spans.insert(overlay.spans.end(), seen_.spans.begin(), seen_.spans.end());
  if (seen_.stride == 1 && seen_.spans.size() < kMaxSpans) return;
  const Rect& b = seen_.box;
  overlay.outlines.push_back(
      {{{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}}, true, Overlay::Role::kSelected});
}

}  // namespace felt
