#include "felt/solid/outlines.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/fill/curve_area.h"
#include "felt/fill/document_map.h"
#include "felt/fill/fill_map.h"
#include "felt/solid/line_density.h"

namespace felt {
namespace outline_search {

/// A simple closed walk along the outside of a component of the planar map.
struct Lobe {
  std::vector<std::size_t> half_edges;
  std::size_t component = 0;
  std::vector<Cubic> curve;
  std::vector<Point> control_points;  // 3n + 1
  Rect box;
  double area_mm2 = 0.0;
  double length_mm = 0.0;  // about
  int depth = 0;           // the number of lobes around it
  std::size_t parent = 0;  // the smallest of these
};

std::string place_text(Point p) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.2f, %.2f) mm", p.x, p.y);
  return text;
}

std::size_t tail_of(const PlanarMap& map, std::size_t half_edge) {
  return map.edges().edges[half_edge / 2].nodes[half_edge % 2];
}

void add_curve(const PlanarMap& map, Lobe& lobe) {
  for (const std::size_t h : lobe.half_edges) {
    const MapEdge& edge = map.edges().edges[h / 2];
    const auto cubics = map.edges().cubics_of(edge);
    std::vector<Cubic> part(cubics.begin(), cubics.end());
    part.front().p[0] = map.edges().nodes[edge.nodes[0]];
    part.back().p[3] = map.edges().nodes[edge.nodes[1]];
    if (h % 2 != 0) {
      std::reverse(part.begin(), part.end());
      for (Cubic& c : part) c = reversed(c);
    }
    lobe.curve.insert(lobe.curve.end(), part.begin(), part.end());
  }
  lobe.control_points.push_back(lobe.curve.front().p[0]);
  for (const Cubic& c : lobe.curve) {
    lobe.control_points.insert(lobe.control_points.end(), c.p.begin() + 1, c.p.end());
    lobe.box.extend(bounds(c));
    lobe.length_mm += 0.5 * (control_length(c) + distance(c.p[0], c.p[3]));
  }
  lobe.area_mm2 = std::fabs(loop_area(lobe.curve));
}

/// Divides the loop around a component at the nodes that it visits more than once.
std::vector<Lobe> lobes_of(const PlanarMap& map, const MapLoop& loop) {
  std::vector<Lobe> lobes;
  std::vector<std::size_t> stack;
  std::map<std::size_t, std::size_t> at;  // node -> index in the stack
  const auto cut = [&](std::size_t from) {
    Lobe lobe;
    lobe.component = loop.component;
    lobe.half_edges.assign(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end());
    for (const std::size_t h : lobe.half_edges) at.erase(tail_of(map, h));
    stack.resize(from);
    add_curve(map, lobe);
    lobes.push_back(std::move(lobe));
  };
  for (const std::size_t h : loop.half_edges) {
    if (const auto known = at.find(tail_of(map, h)); known != at.end()) cut(known->second);
    at.emplace(tail_of(map, h), stack.size());
    stack.push_back(h);
  }
  if (!stack.empty()) cut(0);
  return lobes;
}

bool is_too_small(const Lobe& lobe) {
  return std::max(lobe.box.width(), lobe.box.height()) < kMinOutlineMm ||
         2.0 * lobe.area_mm2 < kMinMeanWidthMm * lobe.length_mm;
}

/// Returns the stroke with the largest share of the lobe; an empty id if it has only bridges.
StrokeId main_stroke(const PlanarMap& map, const Lobe& lobe) {
  std::map<StrokeId, double> lengths;
  for (const std::size_t h : lobe.half_edges) {
    const MapEdge& edge = map.edges().edges[h / 2];
    if (!edge.stroke) continue;
    for (const Cubic& c : map.edges().cubics_of(edge)) lengths[edge.stroke] += control_length(c);
  }
  StrokeId longest;
  double length = -1.0;
  for (const auto& [id, part] : lengths) {
    if (part > length) longest = id, length = part;
  }
  return longest;
}

/// Finds the outlines in a planar map.
class OutlineFinder {
 public:
  OutlineFinder(const Document& document, const PlanarMap& map) : document_(document), map_(map) {}

  Result<FoundOutlines> find(HoleChoice holes, FaultChoice faults);

 private:
  void collect();
  void leave_out(const Lobe& lobe);
  void drop_small();
  void drop_redrawn();
  Result<void> check_pinches(FaultChoice faults);
  void set_depths();
  [[nodiscard]] tl::unexpected<Error> pinch(std::size_t node, const Lobe& a, const Lobe& b) const;
  [[nodiscard]] std::string first_left_out() const;
  [[nodiscard]] SolidOutline outline_of(std::size_t i, HoleChoice holes) const;

  const Document& document_;
  const PlanarMap& map_;
  std::vector<Lobe> lobes_;
  std::size_t left_out_ = 0;
  std::optional<Lobe> largest_left_out_;
  std::vector<std::string> notes_;
};

void OutlineFinder::collect() {
  for (const MapLoop& loop : map_.loops()) {
    if (!loop.outer) continue;
    std::vector<Lobe> lobes = lobes_of(map_, loop);
    lobes_.insert(lobes_.end(), std::make_move_iterator(lobes.begin()),
                  std::make_move_iterator(lobes.end()));
  }
}

void OutlineFinder::leave_out(const Lobe& lobe) {
  ++left_out_;
  if (!largest_left_out_ || lobe.area_mm2 > largest_left_out_->area_mm2) largest_left_out_ = lobe;
}

/// Drops lobes that are too small, and those of less than a hundredth of the largest lobe of their
/// component: the curl where a hand closes an outline is not meant as a second body.
void OutlineFinder::drop_small() {
  constexpr double kMinShare = 0.01;
  std::map<std::size_t, double> largest;
  for (const Lobe& lobe : lobes_) {
    double& area = largest[lobe.component];
    area = std::max(area, lobe.area_mm2);
  }
  std::erase_if(lobes_, [&](const Lobe& lobe) {
    const bool small = is_too_small(lobe) || lobe.area_mm2 < kMinShare * largest[lobe.component];
    if (small) leave_out(lobe);
    return small;
  });
}

double middle_width_mm(const Stroke& stroke) {
  return stroke.width_mm(0.5 * stroke.segment_count());
}

/// Drops the lines that draw an outline again beside itself: those whose ink touches that of the
/// line around them, on average. Without this, they would be holes that leave a thin ring.
void OutlineFinder::drop_redrawn() {
  set_depths();
  std::vector<bool> is_redrawn(lobes_.size());
  for (std::size_t i = 0; i < lobes_.size(); ++i) {
    if (lobes_[i].depth == 0) continue;
    const Lobe &inner = lobes_[i], &outer = lobes_[inner.parent];
    const StrokeId id = main_stroke(map_, inner), around = main_stroke(map_, outer);
    const StrokePtr one = document_.find(id), other = document_.find(around);
    if (!one || !other) continue;
    const double apart_mm =
        2.0 * (outer.area_mm2 - inner.area_mm2) / (outer.length_mm + inner.length_mm);
    if (apart_mm >= 0.5 * (middle_width_mm(*one) + middle_width_mm(*other))) continue;
    is_redrawn[i] = true;
    char text[80];
    std::snprintf(text, sizeof text, " at a distance of %.2f mm; it was not treated as a hole",
                  apart_mm);
    notes_.push_back("stroke " + stroke_name(id) + " retraces the outline of stroke " +
                     stroke_name(around) + text);
  }
  std::size_t at = 0;
  std::erase_if(lobes_, [&](const Lobe&) { return is_redrawn[at++]; });
}

/// Returns "strokes s1, s2 and s3"; "lines" if there are none, because bridges over gaps meet.
std::string names_of(const std::vector<StrokeId>& strokes) {
  if (strokes.empty()) return "lines";
  std::string names = "strokes ";
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (i > 0) names += i + 1 == strokes.size() ? " and " : ", ";
    names += stroke_name(strokes[i]);
  }
  return names;
}

tl::unexpected<Error> OutlineFinder::pinch(std::size_t node, const Lobe& a, const Lobe& b) const {
  std::vector<StrokeId> strokes;
  for (const Lobe* lobe : {&a, &b}) {
    for (const std::size_t h : lobe->half_edges) {
      const MapEdge& edge = map_.edges().edges[h / 2];
      if (edge.stroke && (edge.nodes[0] == node || edge.nodes[1] == node)) {
        strokes.push_back(edge.stroke);
      }
    }
  }
  std::sort(strokes.begin(), strokes.end());
  strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
  const std::string at = place_text(map_.edges().nodes[node]);
  if (strokes.size() == 1) {
    return fail(ErrorCode::kInvalidData, "stroke " + stroke_name(strokes.front()) +
                                             " crosses itself at " + at +
                                             ", so its parts meet in only one point");
  }
  return fail(ErrorCode::kInvalidData, names_of(strokes) +
                                           " enclose areas that meet in only one point, " + at +
                                           ": let them overlap, or move them apart");
}

/// Fails if two lobes have a node in common. With FaultChoice::kLeaveOut, drops the smaller one.
Result<void> OutlineFinder::check_pinches(FaultChoice faults) {
  std::vector<std::size_t> order(lobes_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (faults == FaultChoice::kLeaveOut) {
    // Larger lobes come first, so that a lobe can only meet one that stays.
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return lobes_[a].area_mm2 > lobes_[b].area_mm2;
    });
  }
  std::map<std::size_t, std::size_t> owner;  // node -> lobe
  std::vector<bool> is_dropped(lobes_.size());
  for (const std::size_t i : order) {
    std::optional<std::size_t> shared;
    for (const std::size_t h : lobes_[i].half_edges) {
      if (!shared && owner.contains(tail_of(map_, h))) shared = tail_of(map_, h);
    }
    if (shared) {
      const auto met = pinch(*shared, lobes_[owner.at(*shared)], lobes_[i]);
      if (faults == FaultChoice::kRefuse) return met;
      notes_.push_back("left out the smaller part: " + met.value().message);
      is_dropped[i] = true;
      continue;
    }
    for (const std::size_t h : lobes_[i].half_edges) owner.emplace(tail_of(map_, h), i);
  }
  std::size_t at = 0;
  std::erase_if(lobes_, [&](const Lobe&) { return is_dropped[at++]; });
  return {};
}

void OutlineFinder::set_depths() {
  for (std::size_t i = 0; i < lobes_.size(); ++i) {
    Lobe& lobe = lobes_[i];
    lobe.depth = 0;
    const Point p = lobe.control_points.front();
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
      const Lobe& around = lobes_[k];
      if (around.component == lobe.component || !around.box.contains(p)) continue;
      if (!is_inside(around.control_points, p)) continue;
      ++lobe.depth;
      if (around.area_mm2 < smallest) smallest = around.area_mm2, lobe.parent = k;
    }
  }
}

SolidOutline OutlineFinder::outline_of(std::size_t i, HoleChoice holes) const {
  SolidOutline outline;
  outline.loops.push_back(lobes_[i].curve);
  for (const Lobe& hole : lobes_) {
    const bool is_hole = hole.depth == lobes_[i].depth + 1 && hole.parent == i;
    if (is_hole && holes == HoleChoice::kKeep) outline.loops.push_back(hole.curve);
  }
  outline.stroke = main_stroke(map_, lobes_[i]);
  if (const StrokePtr stroke = document_.find(outline.stroke)) outline.color = stroke->color();
  return outline;
}

std::string OutlineFinder::first_left_out() const {
  const Lobe& lobe = *largest_left_out_;
  char size[64];
  std::snprintf(size, sizeof size, "%.2f x %.2f mm", lobe.box.width(), lobe.box.height());
  const StrokeId id = main_stroke(map_, lobe);
  return (id ? "of stroke " + stroke_name(id) + " " : std::string()) + "at " +
         place_text(lobe.control_points.front()) + ", " + size;
}

Result<FoundOutlines> OutlineFinder::find(HoleChoice holes, FaultChoice faults) {
  collect();
  if (holes == HoleChoice::kFill) {
    // Lines inside an outline do not matter then, and may cross each other as they like.
    set_depths();
    std::erase_if(lobes_, [](const Lobe& lobe) { return lobe.depth > 0; });
  }
  drop_small();
  if (lobes_.empty() && largest_left_out_) {
    return fail(ErrorCode::kInvalidData,
                "every closed outline is too small or too narrow; the "
                "largest is that " +
                    first_left_out());
  }
  if (lobes_.empty()) return fail(ErrorCode::kNotFound, "contains no closed outline");
  drop_redrawn();
  if (Result<void> simple = check_pinches(faults); !simple) return tl::unexpected(simple.error());
  set_depths();
  FoundOutlines found;
  found.notes = std::move(notes_);
  for (std::size_t i = 0; i < lobes_.size(); ++i) {
    if (lobes_[i].depth % 2 == 0) found.outlines.push_back(outline_of(i, holes));
  }
  if (left_out_ > 0) {
    found.notes.push_back("left out " + std::to_string(left_out_) + " small closed " +
                          (left_out_ == 1 ? "line, " : "lines, the largest ") + first_left_out());
  }
  return found;
}

/// Returns the message that there is no outline, with the place of the smallest gap of one.
Error no_outline(FillMap& map, double max_gap_mm) {
  Error error{ErrorCode::kNotFound, "contains no closed outline"};
  for (double gap = 0.5; gap <= FillMap::kMaxNamedGapMm; gap *= 2.0) {
    if (gap <= max_gap_mm) continue;
    const PlanarMap& planar = map.map(gap);
    for (std::size_t i = 0; i < planar.loops().size(); ++i) {
      if (planar.loops()[i].outer || planar.loops()[i].area_mm2 < kMinOutlineMm) continue;
      const TipLink* widest = nullptr;
      const FoundFill found = map.fill_of(i, gap, {});
      for (const TipLink& bridge : found.bridges) {
        if (!widest || bridge.length_mm > widest->length_mm) widest = &bridge;
      }
      if (!widest) continue;
      char text[80];
      std::snprintf(text, sizeof text, ": there is a gap of %.2f mm at ", widest->length_mm);
      error.message += text + place_text(widest->from.point) + ", at the end of stroke " +
                       stroke_name(widest->from.stroke);
      return error;
    }
  }
  return error;
}

}  // namespace outline_search

Result<FoundOutlines> find_outlines(const Document& document, double max_gap_mm, HoleChoice holes,
                                    FaultChoice faults) {
  std::vector<FillLine> lines;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) lines.push_back({id, document.find(id)});
  }
  if (lines.empty()) return fail(ErrorCode::kNotFound, "contains no visible strokes");
  if (lines.size() > DocumentMap::kMaxNearStrokes) {
    return fail(ErrorCode::kLimitExceeded, "has more than 100,000 visible strokes");
  }
  if (Result<void> sparse = check_line_density(lines); !sparse) {
    return tl::unexpected(sparse.error());
  }
  FillMap map;
  map.update(lines);
  Result<FoundOutlines> found =
      outline_search::OutlineFinder(document, map.map(max_gap_mm)).find(holes, faults);
  // Looking for a gap takes several maps, so only drawings that a window could show are searched.
  const bool is_searched = lines.size() <= DocumentMap::kMaxStrokes;
  if (!found && found.error().code == ErrorCode::kNotFound && is_searched) {
    return tl::unexpected(outline_search::no_outline(map, max_gap_mm));
  }
  return found;
}

}  // namespace felt
