#include "felt/document/segment_forest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

/// Limit of the coordinates in the tree of boxes. SegmentBvh clamps the coordinates of segments to
/// the same limit.
constexpr double kFarthest = 1e18;
/// Largest size of a segment of the first size class. Each further class is four times as large.
constexpr double kSmallMm = 16.0;
constexpr int kLargestClass = 20;
/// Number of segments in a leaf after a full build. It leaves space for more.
constexpr std::size_t kFreshSegments = SegmentForest::kLeafSegments * 3 / 4;

/// Relative margin in comparisons of distances, so that no segment at the same distance is lost.
constexpr double kSlack = 1e-12;

constexpr Point kHole{std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::quiet_NaN()};
constexpr BvhSegment kNothing{{{kHole, kHole, kHole, kHole}}, {}};

std::uint32_t index_of(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

double half_perimeter(const Rect& box) {
  return box.width() + box.height();
}

Rect joined(Rect a, const Rect& b) {
  a.extend(b);
  return a;
}

bool is_inside(const Rect& inner, const Rect& outer) {
  return joined(outer, inner) == outer;
}

/// Returns the middle of a box. Halves the coordinates first, because the sum of huge ones would be
/// infinite.
Point middle_of(const Rect& box) {
  return {0.5 * box.x0 + 0.5 * box.x1, 0.5 * box.y0 + 0.5 * box.y1};
}

int class_of(const Rect& box) {
  const double size = std::max(box.width(), box.height());
  int size_class = 0;
  for (double limit = kSmallMm; size > limit && size_class < kLargestClass; limit *= 4.0) {
    ++size_class;
  }
  return size_class;
}

/// Returns a straight curve with the bounding box `box`.
Cubic diagonal(const Rect& box) {
  if (box.empty()) return kNothing.curve;
  const auto held = [](double v) { return std::clamp(v, -kFarthest, kFarthest); };
  const Point a{held(box.x0), held(box.y0)}, b{held(box.x1), held(box.y1)};
  return {{a, a, b, b}};
}

/// Data of a segment while it is sorted.
struct Key {
  Point middle;
  int size_class = 0;
  std::uint32_t item = 0;
};

std::vector<Key> keys_of(std::span<const BvhSegment> segments) {
  std::vector<Key> keys(segments.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Rect box = bounds(segments[i].curve);
    keys[i] = {middle_of(box), class_of(box), index_of(i)};
  }
  return keys;
}

/// Sorts the keys into two halves along the longer side of the area that they cover. Returns the
/// size of the first half.
std::size_t halve(std::span<Key> keys) {
  Rect cover;
  for (const Key& k : keys) cover.extend(k.middle);
  const bool by_x = cover.width() >= cover.height();
  const std::size_t middle = keys.size() / 2;
  std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(middle), keys.end(),
                   [by_x](const Key& a, const Key& b) {
                     const double u = by_x ? a.middle.x : a.middle.y;
                     const double v = by_x ? b.middle.x : b.middle.y;
                     return u != v ? u < v : a.item < b.item;
                   });
  return middle;
}

std::vector<BvhSegment> chosen(std::span<const BvhSegment> segments, std::span<const Key> keys) {
  std::vector<BvhSegment> result;
  result.reserve(keys.size());
  for (const Key& k : keys) result.push_back(segments[k.item]);
  return result;
}

Rect box_of(std::span<const BvhSegment> segments) {
  Rect box;
  for (const BvhSegment& s : segments) box.extend(bounds(s.curve));
  return box;
}

bool is_hole(const SegmentBvh& tree, std::uint32_t handle) {
  return std::isnan(tree.curve(handle).p[0].x);
}

}  // namespace

void SegmentForest::update(std::span<const Change> changes) {
  std::size_t coming = 0;
  for (const Change& c : changes) {
    if (c.after && !places_.contains(c.id)) {
      coming += static_cast<std::size_t>(c.after->segment_count());
    }
  }
  const bool all_anew = coming > kFreshSegments && coming > segments_;
  std::vector<BvhSegment> segments;
  for (const Change& c : changes) {
    if (!c.after) {
      remove(c.id);
    } else if (!all_anew || places_.contains(c.id)) {
      change(c.id, *c.after);
    } else {
      for (int i = 0; i < c.after->segment_count(); ++i) {
        segments.push_back({c.after->segment(i), {c.id.value, static_cast<std::uint32_t>(i)}});
      }
    }
  }
  if (all_anew) build(std::move(segments));
}

void SegmentForest::change(StrokeId id, const Stroke& after) {
  std::vector<Place>& places = places_[id];
  const auto size = static_cast<std::size_t>(after.segment_count());
  for (; places.size() > size; places.pop_back()) erase(places.back());
  for (std::size_t i = 0; i < size; ++i) {
    const BvhSegment segment{after.segment(static_cast<int>(i)), {id.value, index_of(i)}};
    if (i < places.size()) {
      const Place at = places[i];
      Leaf& leaf = leaves_[at.leaf];
      if (leaf.tree.curve(at.handle) == segment.curve) continue;
      const Rect box = bounds(segment.curve);
      if (class_of(box) == leaf.size_class && is_inside(box, leaf.box)) {
        leaf.tree.refit(at.handle, segment.curve);
        ++leaf.changes;
        tidy_if_due(at.leaf);
        continue;
      }
      erase(at);
    } else {
      places.emplace_back();
    }
    // If this splits a leaf, it updates the places of the moved segments, also of this stroke.
    places[i] = insert(segment);
  }
}

void SegmentForest::remove(StrokeId id) {
  const auto found = places_.find(id);
  if (found == places_.end()) return;
  for (const Place& at : found->second) erase(at);
  places_.erase(found);
}

SegmentForest::Place SegmentForest::insert(const BvhSegment& segment) {
  const Rect box = bounds(segment.curve);
  std::uint32_t at = leaf_for(box);
  while (leaves_[at].live == kLeafSegments) {
    cut(at);
    at = leaf_for(box);
  }
  if (leaves_[at].holes.empty()) fill(at, live_segments(at));
  Leaf& leaf = leaves_[at];
  const std::uint32_t handle = leaf.holes.back();
  leaf.holes.pop_back();
  leaf.tree.replace(handle, segment);
  ++leaf.live;
  ++leaf.changes;
  ++segments_;
  if (!is_inside(box, leaf.box)) {
    leaf.box.extend(box);
    show_box(at);
  }
  tidy_if_due(at);
  return {at, handle};
}

void SegmentForest::erase(Place place) {
  Leaf& leaf = leaves_[place.leaf];
  leaf.tree.erase(place.handle);
  leaf.holes.push_back(place.handle);
  --leaf.live;
  ++leaf.changes;
  --segments_;
  if (leaf.live > 0) {
    tidy_if_due(place.leaf);
    return;
  }
  leaf = {};
  free_leaves_.push_back(place.leaf);
  show_box(place.leaf);
}

/// Returns a leaf of the box's size class near the middle of the box: the leaf that needs to grow
/// least. Makes a new leaf if the class has no leaf.
std::uint32_t SegmentForest::leaf_for(const Rect& box) {
  const int size_class = class_of(box);
  const Point middle = middle_of(box);
  std::uint32_t best = SegmentBvh::kNone;
  double best_growth = 0.0, best_size = 0.0;
  const auto consider = [&](std::uint32_t i) {
    const Leaf& leaf = leaves_[i];
    if (leaf.size_class != size_class) return;
    const double size = half_perimeter(leaf.box);
    const double growth = half_perimeter(joined(leaf.box, box)) - size;
    const bool better =
        best == SegmentBvh::kNone || growth < best_growth ||
        (growth == best_growth && (size < best_size || (size == best_size && i < best)));
    if (better) best = i, best_growth = growth, best_size = size;
  };
  Rect area{middle.x, middle.y, middle.x, middle.y};
  leaf_boxes_.for_each_in(area, consider);
  for (double reach = kSmallMm; best == SegmentBvh::kNone && reach < kFarthest; reach *= 8.0) {
    leaf_boxes_.for_each_in(area.inflated(reach), consider);
  }
  return best != SegmentBvh::kNone ? best : new_leaf(size_class);
}

std::uint32_t SegmentForest::new_leaf(int size_class) {
  if (free_leaves_.empty()) {
    free_leaves_.push_back(index_of(leaves_.size()));
    leaves_.emplace_back();
  }
  const std::uint32_t made = free_leaves_.back();
  free_leaves_.pop_back();
  leaves_[made].size_class = size_class;
  return made;
}

void SegmentForest::fill(std::uint32_t at, std::span<const BvhSegment> segments) {
  const std::size_t size = segments.size();
  std::vector<BvhSegment> padded(segments.begin(), segments.end());
  padded.resize(std::min(kLeafSegments, size + size / 4 + 16), kNothing);
  Leaf& leaf = leaves_[at];
  leaf.tree.build(padded);
  leaf.box = box_of(segments);
  leaf.live = size;
  leaf.changes = 0;
  leaf.holes.clear();
  for (std::size_t h = padded.size(); h > size; --h) leaf.holes.push_back(index_of(h - 1));
  sorted_ += size;
  auto stroke = places_.end();
  for (std::size_t h = 0; h < size; ++h) {
    const StrokeId id{segments[h].ref.stroke};
    if (stroke == places_.end() || stroke->first != id) stroke = places_.find(id);
    stroke->second[segments[h].ref.segment] = {at, index_of(h)};
  }
  show_box(at);
}

std::vector<BvhSegment> SegmentForest::live_segments(std::uint32_t at) const {
  const SegmentBvh& tree = leaves_[at].tree;
  std::vector<BvhSegment> live;
  for (std::uint32_t h = 0; h < tree.size(); ++h) {
    if (!is_hole(tree, h)) live.push_back({tree.curve(h), tree.ref(h)});
  }
  return live;
}

void SegmentForest::cut(std::uint32_t at) {
  const std::vector<BvhSegment> segments = live_segments(at);
  std::vector<Key> keys = keys_of(segments);
  const auto middle = halve(keys);
  const std::uint32_t other = new_leaf(leaves_[at].size_class);
  fill(at, chosen(segments, std::span(keys).first(middle)));
  fill(other, chosen(segments, std::span(keys).subspan(middle)));
}

void SegmentForest::tidy_if_due(std::uint32_t at) {
  Leaf& leaf = leaves_[at];
  const bool many = leaf.changes > leaf.live / 2 + 16;
  const bool some = leaf.changes > leaf.live / 8 + 8;
  if (!many && !(some && leaf.tree.rebuild_advised())) return;
  leaf.tree.rebuild();
  leaf.changes = 0;
  leaf.box = {};
  for (std::uint32_t h = 0; h < leaf.tree.size(); ++h) leaf.box.extend(bounds(leaf.tree.curve(h)));
  sorted_ += leaf.live;
  show_box(at);
}

void SegmentForest::show_box(std::uint32_t at) {
  if (at < leaf_boxes_.size()) {
    leaf_boxes_.refit(at, diagonal(leaves_[at].box));
    ++box_changes_;
    if (box_changes_ < leaf_count() / 16 + 16 || !leaf_boxes_.rebuild_advised()) return;
  }
  sort_leaves();
}

void SegmentForest::sort_leaves() {
  std::vector<BvhSegment> boxes;
  for (const Leaf& leaf : leaves_) boxes.push_back({diagonal(leaf.box), {}});
  boxes.resize(boxes.size() + boxes.size() / 4 + 16, kNothing);
  leaf_boxes_.build(boxes);
  box_changes_ = 0;
  sorted_leaves_ += leaves_.size();
}

void SegmentForest::build(std::vector<BvhSegment> segments) {
  for (const BvhSegment& s : segments) {
    std::vector<Place>& places = places_[StrokeId{s.ref.stroke}];
    places.resize(std::max<std::size_t>(places.size(), s.ref.segment + 1));
  }
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    const std::vector<BvhSegment> live = live_segments(i);
    segments.insert(segments.end(), live.begin(), live.end());
  }
  segments_ = segments.size();
  leaves_.clear();
  free_leaves_.clear();
  leaf_boxes_.build({});
  std::vector<Key> keys = keys_of(segments);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const Key& a, const Key& b) { return a.size_class < b.size_class; });
  // Runs of keys of one size class are halved until each fits into a leaf.
  std::vector<std::span<Key>> waiting;
  for (std::span<Key> rest(keys); !rest.empty();) {
    const auto end = std::find_if(rest.begin(), rest.end(), [&](const Key& k) {
      return k.size_class != rest.front().size_class;
    });
    const auto size = static_cast<std::size_t>(end - rest.begin());
    waiting.push_back(rest.first(size));
    rest = rest.subspan(size);
  }
  while (!waiting.empty()) {
    const std::span<Key> run = waiting.back();
    waiting.pop_back();
    if (run.size() > kFreshSegments) {
      const std::size_t middle = halve(run);
      waiting.push_back(run.first(middle));
      waiting.push_back(run.subspan(middle));
    } else {
      fill(new_leaf(run.front().size_class), chosen(segments, run));
    }
  }
  sort_leaves();
}

/// Searches leaves for the nearest segment. Holds the nearest one so far.
struct SegmentForest::Search {
  const Point place;
  double reach_mm;  // segments farther away are ignored
  BvhWorkCap left{};
  std::optional<Hit> best{};
  int leaves = 0;

  void ask(const Leaf& leaf) {
    const double far = distance_squared(leaf.box, place);
    if (far > reach_mm * reach_mm * (1.0 + kSlack)) return;
    ++leaves;
    const SegmentBvh::Hit hit = leaf.tree.nearest({place, reach_mm, SegmentBvh::kNone, left});
    left.nodes -= hit.used.nodes;
    left.pieces -= hit.used.pieces;
    if (!hit) return;
    const SegmentRef ref = hit.ref;
    if (best) {
      const double d = hit.nearest.distance_squared, known = best->nearest.distance_squared;
      const SegmentRef other{best->stroke.value, static_cast<std::uint32_t>(best->segment)};
      if (d > known || (d == known && ref > other)) return;
    }
    best = Hit{StrokeId{ref.stroke}, static_cast<int>(ref.segment), hit.nearest};
    // The reach is slightly larger than the distance, so that other segments at the same distance
    // are visited.
    reach_mm = std::min(reach_mm, std::sqrt(hit.nearest.distance_squared) * (1.0 + kSlack));
  }
};

std::optional<SegmentForest::Hit> SegmentForest::nearest(Point place, double radius_mm,
                                                         Work* work) const {
  if (!(radius_mm >= 0.0)) return std::nullopt;
  Search search{place, radius_mm};
  // Searches the leaves around the place first, because a segment found there excludes most of the
  // other leaves.
  Rect area{place.x, place.y, place.x, place.y};
  leaf_boxes_.for_each_in(area, [&](std::uint32_t i) {
    if (leaves_[i].box.contains(place)) search.ask(leaves_[i]);
  });
  leaf_boxes_.for_each_in(area.inflated(search.reach_mm), [&](std::uint32_t i) {
    if (!leaves_[i].box.contains(place)) search.ask(leaves_[i]);
  });
  if (work) {
    constexpr BvhWorkCap kAll{};
    *work = {search.leaves, kAll.nodes - search.left.nodes, kAll.pieces - search.left.pieces};
  }
  return search.best;
}

}  // namespace felt
