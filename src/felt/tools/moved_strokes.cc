#include "felt/tools/moved_strokes.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "felt/document/copy_limit.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/edit/point_marks.h"
#include "felt/stroke/edit/split.h"
#include "felt/tools/selection_view.h"

namespace felt {
namespace {

bool goes_whole(const Selection::Marks& marks, std::size_t segment) {
  return marks[3 * segment] && marks[3 * segment + 3];
}

/// Returns the runs of segments that have both joints selected, as strokes.
std::vector<StrokePtr> selected_runs(const StrokePtr& stroke, const Selection::Marks& marks) {
  if (all_marked(marks)) return {stroke};
  std::vector<StrokePtr> runs;
  const std::size_t n = marks.size() / 3;
  std::size_t first = 0;
  if (stroke->closed()) {
    // Starts at a gap, so that a run that crosses the seam is not split. A gap exists because not
    // all points are marked.
    while (first < n && goes_whole(marks, first)) ++first;
    if (first == n) return {stroke};
  }
  for (std::size_t k = 0; k < n;) {
    const std::size_t begin = k;
    while (k < n && goes_whole(marks, (first + k) % n)) ++k;
    if (k == begin) {
      ++k;
      continue;
    }
    const std::size_t from = (first + begin) % n, to = (first + k - 1) % n + 1;
    const auto run = sub_stroke(*stroke, static_cast<double>(from), static_cast<double>(to));
    if (run) runs.push_back(std::make_shared<const Stroke>(*run));
  }
  return runs;
}

/// Returns the length of the control polygon of the shortest segment that is mapped as a whole, or
/// infinity if no segment is.
double shortest_segment_mm(const Stroke& stroke, const Selection::Marks& marks) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    if (!marks[at] || !marks[at + 1] || !marks[at + 2] || !marks[at + 3]) continue;
    shortest = std::min(shortest, control_length(stroke.segment(i)));
  }
  return shortest;
}

/// Returns true if a line that is not selected has the same points as one that is: the selection
/// was pasted in place, and what it touches belongs to the originals.
bool lies_on_its_original(const Document& document, const StrokeIndex& index,
                          const Selection& selection, const std::vector<MovedLine>& lines) {
  return std::any_of(lines.begin(), lines.end(), [&](const MovedLine& line) {
    const std::vector<Point>& points = line.stroke->data().points;
    Rect place;
    place.extend(points.front());
    const std::vector<StrokeId> near = index.strokes_in(place);
    return std::any_of(near.begin(), near.end(), [&](StrokeId id) {
      return id != line.id && !selection.strokes().contains(id) &&
             document.find(id)->data().points == points;
    });
  });
}

}  // namespace

MovedStrokes::MovedStrokes(const Document& document, const StrokeIndex& index,
                           const Selection& selection, bool duplicates, bool leaves_originals) {
  if (duplicates) {
    prepare_copies(document, selection);
  } else {
    prepare_originals(document, index, selection, leaves_originals);
  }
  min_scale_ = std::min(min_scale_, 1.0);
}

void MovedStrokes::prepare_originals(const Document& document, const StrokeIndex& index,
                                     const Selection& selection, bool leaves_originals) {
  std::vector<MovedLine> lines;
  for (const auto& [id, marks] : selection.strokes()) {
    StrokePtr stroke = document.find(id);
    if (!stroke || stroke->data().points.size() != marks.size()) continue;
    if (!is_editable(document, id)) continue;
    lines.push_back({id, std::move(stroke), marks, std::nullopt});
    close_marks(*lines.back().stroke, lines.back().marks);
  }
  selected_ = lines.size();
  const bool are_copies =
      leaves_originals && lies_on_its_original(document, index, selection, lines);
  if (lines.size() <= kMaxConnected && !are_copies) {
    ConnectedLines connected = connected_lines(document, index, std::move(lines));
    lines = std::move(connected.lines);
    may_part_ = connected.may_part;
  }
  EditBuilder builder(document);
  for (MovedLine& line : lines) {
    builder.replace(line.id, line.stroke);
    if (!line.leader) {
      for (const std::size_t i : felt::anchors(*line.stroke, line.marks)) {
        anchors_.push_back(line.stroke->data().points[i]);
      }
    }
    add(std::move(line));
  }
  places_ = std::move(builder).build("");
}

std::optional<ConnectedPull> MovedStrokes::connected_pull() const {
  if (!may_part_) return std::nullopt;
  ConnectedPull pull{BrushOptions{}};
  for (std::size_t i = 0; i < std::min(selected_, items_.size()); ++i) {
    if (items_[i].is_selected_whole) pull.keep_shape(places_.changes[i].id);
  }
  return pull;
}

std::optional<Selection> MovedStrokes::selection_after(const Edit& edit,
                                                       const Selection& before) const {
  std::optional<Selection> after;
  for (std::size_t i = 0; i < std::min(selected_, edit.changes.size()); ++i) {
    const StrokeChange& change = edit.changes[i];
    const Selection::Marks& marks = items_[i].marks;
    if (!change.before || !change.after) continue;
    const std::size_t points = change.after->data().points.size();
    if (points == change.before->data().points.size()) continue;
    if (!after) after = before;
    if (points == marks.size()) {
      after->set(change.id, marks);
    } else if (all_marked(marks)) {
      after->set_whole(change.id, points);
    } else {
      after->remove(change.id);
    }
  }
  return after;
}

void MovedStrokes::prepare_copies(const Document& document, const Selection& selection) {
  // Uses the drawing order, so that the copies keep it.
  EditBuilder originals(document);
  for (const auto& [id, marks] : selection.strokes()) {
    const StrokePtr stroke = document.find(id);
    if (!stroke || stroke->data().points.size() != marks.size()) continue;
    if (is_editable(document, id)) originals.replace(id, stroke);
  }
  Edit order = std::move(originals).build("");
  std::sort(order.changes.begin(), order.changes.end(),
            [](const StrokeChange& a, const StrokeChange& b) {
              return std::pair(a.before_place.layer, a.before_place.index) <
                     std::pair(b.before_place.layer, b.before_place.index);
            });
  EditBuilder builder(document);
  copies_.emplace();
  for (const StrokeChange& original : order.changes) {
    for (StrokePtr& run : selected_runs(original.before, *selection.find(original.id))) {
      const std::size_t points = run->data().points.size();
      copies_->set_whole(builder.add(original.before_place.layer, run), points);
      add({StrokeId{}, std::move(run), Selection::Marks(points, 1), std::nullopt});
    }
  }
  places_ = std::move(builder).build("");
  if (const Result<void> fits = check_copies(document, {items_.size(), points_}); !fits) {
    *this = MovedStrokes();
    refusal_ = fits.error();
  }
}

void MovedStrokes::add(MovedLine line) {
  const bool is_small = line.stroke->segment_count() == 1 && all_marked(line.marks);
  if (!is_small) {
    // The factor allows for rounding.
    const double smallest =
        (1.0 + 1e-6) * kMinSegmentMm / shortest_segment_mm(*line.stroke, line.marks);
    min_scale_ = std::max(min_scale_, smallest);
  }
  points_ += line.marks.size();
  items_.push_back({std::move(line.stroke), std::move(line.marks), is_small, line.is_selected_whole,
                    line.leader});
}

MovedStrokes::Aim MovedStrokes::aim_of(const Item& item, const Aim& aim,
                                       const std::vector<StrokeChange>& done) const {
  if (!item.leader) return aim;
  const auto [leader, u] = *item.leader;
  return {translation(done[leader].after->position(u) - items_[leader].before->position(u)), 1.0};
}

StrokePtr MovedStrokes::moved(const Item& item, const Aim& aim) {
  auto stroke = with_marked_moved(*item.before, item.marks, aim.map, aim.width_factor);
  if (!stroke && item.is_small) {
    // A dot stays a dot: restores the minimum length.
    const Cubic image = apply(aim.map, item.before->segment(0));
    const double length = control_length(image);
    const double grow = length > 0.0 ? 1.001 * kMinSegmentMm / length : 0.0;
    const Affine map = then(aim.map, scaling(grow, lerp(image.p[0], image.p[3], 0.5)));
    stroke = with_marked_moved(*item.before, item.marks, map, aim.width_factor);
  }
  return stroke ? std::make_shared<const Stroke>(*std::move(stroke)) : nullptr;
}

std::optional<Edit> MovedStrokes::step(const Affine& map, double width_factor) {
  if (items_.empty() || points_ > kMaxPreviewPoints) return std::nullopt;
  if (!aim_) {
    const Aim next{map, width_factor};
    if (done_ == next) return std::nullopt;
    aim_ = next;
    work_ = {};
    work_.changes.reserve(items_.size());
    shown_.resize(items_.size());
  }
  for (std::size_t points = 0; points < kPointsPerStep && work_.changes.size() < items_.size();) {
    const std::size_t i = work_.changes.size();
    StrokePtr after = moved(items_[i], aim_of(items_[i], *aim_, work_.changes));
    if (!after) {
      aim_.reset();
      return std::nullopt;
    }
    points += items_[i].marks.size();
    work_.changes.push_back(places_.changes[i]);
    shown_[i].before = std::exchange(shown_[i].last, after);
    work_.changes.back().after = std::move(after);
  }
  if (work_.changes.size() < items_.size()) return std::nullopt;
  done_ = std::exchange(aim_, std::nullopt);
  return std::exchange(work_, {});
}

Edit MovedStrokes::finished(const Affine& map, double width_factor, std::string label) const {
  if (auto edit = all_moved({map, width_factor}, label)) return *std::move(edit);
  if (!done_ || done_->map == Affine{}) return {};
  return all_moved(*done_, label).value_or(Edit{});
}

std::optional<Edit> MovedStrokes::all_moved(const Aim& aim, std::string label) const {
  Edit edit = places_;
  edit.label = std::move(label);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    edit.changes[i].after = moved(items_[i], aim_of(items_[i], aim, edit.changes));
    if (!edit.changes[i].after) return std::nullopt;
  }
  return edit;
}

}  // namespace felt
