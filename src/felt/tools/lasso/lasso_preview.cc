#include "felt/tools/lasso/lasso_preview.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/edit/point_marks.h"

namespace felt {
namespace {

constexpr double kPatchMm = 5.0;
constexpr std::int64_t kMaxPatches = 40'000;  // a square metre
/// Limits of the work per look().
constexpr std::size_t kPatchesPerLook = 8;
constexpr std::size_t kSegmentsPerLook = 64;
constexpr std::size_t kPointsPerLook = 250;
/// Maximum number of outline points per look(). A longer outline is prepared only in every second,
/// third, ... look().
constexpr std::size_t kOutlinePerLook = 256;

std::int64_t line_of(double mm) {
  return static_cast<std::int64_t>(std::floor(std::clamp(mm, -1e9, 1e9) / kPatchMm));
}

/// Returns the segments that have marked joints at both ends.
std::vector<Overlay::Span> marked_spans(const Stroke& stroke, const Selection::Marks& marks) {
  std::vector<Overlay::Span> spans;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    if (!marks[at] || !marks[at + 3]) continue;
    spans.push_back({stroke.segment(i), stroke.width_mm(i + 0.5), Overlay::Role::kSelected});
  }
  return spans;
}

}  // namespace

void LassoPreview::begin() {
  *this = {};
}

void LassoPreview::look(std::span<const Point> outline, const Rect& bounds, LassoTake take,
                        const Document& document, const StrokeIndex& index) {
  if (bounds.empty() || gave_up_) return;
  cover(bounds);
  find_strokes(index);
  const std::size_t every = 1 + outline.size() / kOutlinePerLook;
  if (looks_++ % every == 0) area_.emplace(std::vector<Point>(outline.begin(), outline.end()));
  test_strokes(take, document);
}

/// Queues the patches that are within these bounds but were not within the previous bounds.
void LassoPreview::cover(const Rect& bounds) {
  const Patch low{line_of(bounds.x0), line_of(bounds.y0)};
  const Patch high{line_of(bounds.x1) + 1, line_of(bounds.y1) + 1};
  if ((high.column - low.column) * (high.row - low.row) > kMaxPatches) {
    begin();
    gave_up_ = true;
    return;
  }
  const auto add = [&](std::int64_t row, std::int64_t from, std::int64_t to) {
    for (std::int64_t column = from; column < to; ++column) patches_.push_back({column, row});
  };
  for (std::int64_t row = low.row; row < high.row; ++row) {
    const bool is_covered = row >= low_.row && row < high_.row;
    add(row, low.column, is_covered ? low_.column : high.column);
    if (is_covered) add(row, high_.column, high.column);
  }
  low_ = low;
  high_ = high;
}

void LassoPreview::find_strokes(const StrokeIndex& index) {
  std::size_t segments = 0;
  for (std::size_t k = 0; k < kPatchesPerLook && segments < kSegmentsPerLook; ++k) {
    if (patches_.empty() || candidates_.size() >= kMaxStrokes) return;
    const Patch patch = patches_.front();
    patches_.pop_front();
    const double x = kPatchMm * static_cast<double>(patch.column);
    const double y = kPatchMm * static_cast<double>(patch.row);
    for (const StrokeId id : index.strokes_in({x, y, x + kPatchMm, y + kPatchMm})) {
      ++segments;
      if (known_.insert(id).second) candidates_.push_back({id, {}});
    }
  }
}

void LassoPreview::test_strokes(LassoTake take, const Document& document) {
  std::size_t points = 0;
  for (std::size_t k = 0; k < candidates_.size() && points < kPointsPerLook; ++k) {
    Candidate& candidate = candidates_[next_];
    next_ = next_ + 1 < candidates_.size() ? next_ + 1 : 0;
    const StrokePtr stroke = document.find(candidate.id);
    if (!stroke) continue;
    Selection::Marks marks = marks_inside(*stroke, *area_, take);
    close_marks(*stroke, marks);
    candidate.spans = marked_spans(*stroke, marks);
    points += marks.size();
  }
}

void LassoPreview::draw(Overlay& overlay) const {
  std::size_t spans = 0;
  for (const Candidate& c : candidates_) {
    spans += c.spans.size();
    if (spans > kMaxStrokes) return;
    overlay.spans.insert(overlay.spans.end(), c.spans.begin(), c.spans.end());
  }
}

std::size_t LassoPreview::count() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      candidates_.begin(), candidates_.end(), [](const Candidate& c) { return !c.spans.empty(); }));
}

}  // namespace felt
