// How the strokes of a symmetry group follow an edit of one of them.
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/fill/follow_edit.h"
#include "felt/geometry/nearest.h"
#include "felt/session/layer_edit.h"
#include "felt/session/layered_edit.h"
#include "felt/session/stroke_joins.h"
#include "felt/session/symmetry_edit.h"

namespace felt {
namespace {

constexpr double kSameShapeMm = 1e-9;
constexpr int kChangeLooks = 8;  // positions at which strokes with other segments are compared
using Complex = std::complex<double>;

/// The result of an edit for one stroke of a group.
struct ImageResult {
  SymmetryImage image;
  StrokePtr before;
  StrokePtr after;                // null: removed or divided
  std::vector<StrokeId> parts{};  // the strokes that the edit added where it was
  bool is_changed = false;
};

double control_length_mm(const Stroke& stroke) {
  const std::vector<Point>& p = stroke.data().points;
  double length_mm = 0.0;
  for (std::size_t i = 1; i < p.size(); ++i) length_mm += distance(p[i - 1], p[i]);
  return length_mm;
}

/// Returns the distance of a point from the centre line of a stroke.
double distance_from_line_mm(const Stroke& stroke, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < stroke.segment_count(); ++i) {
    least = std::min(least, nearest(stroke.segment(i), p).distance_squared);
  }
  return std::sqrt(least);
}

/// Returns how much an edit changes a stroke, to compare it with other strokes of its group.
double size_of_change(const ImageResult& r, const LayeredEdit& edit) {
  double length_mm = r.after ? control_length_mm(*r.after) : 0.0;
  for (const StrokeId id : r.parts) length_mm += control_length_mm(*edit.after(id));
  double size = std::abs(control_length_mm(*r.before) - length_mm);
  if (!r.after) return size;
  const StrokeData &a = r.before->data(), &b = r.after->data();
  if (a.points.size() == b.points.size()) {
    for (std::size_t i = 0; i < a.points.size(); ++i) size += distance(a.points[i], b.points[i]);
  } else {
    for (int k = 0; k <= kChangeLooks; ++k) {
      const double u = r.before->segment_count() * static_cast<double>(k) / kChangeLooks;
      size += distance_from_line_mm(*r.after, r.before->position(u));
    }
  }
  if (a.widths.size() == b.widths.size()) {
    for (std::size_t i = 0; i < a.widths.size(); ++i) {
      size += std::abs(a.widths[i].width_mm - b.widths[i].width_mm);
    }
  }
  return size;
}

/// Returns true if both strokes have the same widths, colour and medium.
bool look_alike(const Stroke& a, const Stroke& b) {
  const auto near = [](const WidthKnot& x, const WidthKnot& y) {
    return x.u == y.u && std::abs(x.width_mm - y.width_mm) <= kSameShapeMm;
  };
  return a.medium() == b.medium() && a.color() == b.color() &&
         std::equal(a.widths().begin(), a.widths().end(), b.widths().begin(), b.widths().end(),
                    near);
}

/// A similarity of the plane: z -> factor z + shift, or factor conj(z) + shift if it flips.
struct Similarity {
  Complex factor{1.0, 0.0}, shift{};
  bool flips = false;

  [[nodiscard]] Complex operator()(Complex z) const {
    return factor * (flips ? std::conj(z) : z) + shift;
  }
};

/// Returns the similarity that maps the strokes before the edit to those after it, fitted by least
/// squares; nullopt if there is none.
std::optional<Similarity> common_similarity(const std::vector<ImageResult>& all, bool flips) {
  std::vector<std::pair<Complex, Complex>> pairs;
  Complex mean{}, mean_after{};
  for (const ImageResult& r : all) {
    const std::vector<Point>&p = r.before->data().points, &q = r.after->data().points;
    if (p.size() != q.size() || !look_alike(*r.after, *all.front().after)) return {};
    for (std::size_t i = 0; i < p.size(); ++i) {
      pairs.emplace_back(Complex(p[i].x, flips ? -p[i].y : p[i].y), Complex(q[i].x, q[i].y));
      mean += pairs.back().first;
      mean_after += pairs.back().second;
    }
  }
  mean /= static_cast<double>(pairs.size());
  mean_after /= static_cast<double>(pairs.size());
  Complex product{};
  double square = 0.0;
  for (const auto& [z, w] : pairs) {
    product += std::conj(z - mean) * (w - mean_after);
    square += std::norm(z - mean);
  }
  if (square == 0.0) return {};
  Similarity map{product / square, {}, flips};
  map.shift = mean_after - map.factor * mean;
  const auto fits = [&map](const auto& pair) {
    return std::abs(map.factor * pair.first + map.shift - pair.second) <= kSameShapeMm;
  };
  if (map.factor == Complex{} || !std::all_of(pairs.begin(), pairs.end(), fits)) return {};
  return map;
}

/// Returns a group whose axes were moved with its strokes. With a flip T, the rotation by k steps
/// becomes T r T^-1, the rotation by -k steps, and axis j becomes axis -j.
SymmetryGroup moved_group(SymmetryGroup group, const Similarity& map) {
  const Complex center = map(Complex(group.center.x, group.center.y));
  group.center = {center.real(), center.imag()};
  const double turn_rad = std::arg(map.factor);
  group.angle_rad = std::remainder(turn_rad + (map.flips ? -1.0 : 1.0) * group.angle_rad, kTau);
  if (!map.flips) return group;
  const int n = group.axes;
  for (SymmetryImage& i : group.images) {
    i.image = i.image < n ? (n - i.image) % n : n + (2 * n - i.image) % n;
  }
  std::sort(group.images.begin(), group.images.end(),
            [](const SymmetryImage& a, const SymmetryImage& b) { return a.image < b.image; });
  return group;
}

/// Lets the strokes of one group follow.
class GroupFollower {
 public:
  GroupFollower(const Document& document, SymmetryId id, std::vector<ImageResult> all,
                LayeredEdit& edit)
      : document_(document),
        id_(id),
        group_(*document.find_symmetry(id)),
        all_(std::move(all)),
        edit_(edit) {}

  void follow() {
    const auto is = [this](auto test) { return std::all_of(all_.begin(), all_.end(), test); };
    if (is([](const auto& r) { return r.is_changed && r.after && r.parts.empty(); })) {
      if (keep_together()) return;
    }
    lead(*std::max_element(all_.begin(), all_.end(), [this](const auto& a, const auto& b) {
      return size_of(a) < size_of(b);
    }));
  }

 private:
  [[nodiscard]] double size_of(const ImageResult& r) const {
    return r.is_changed ? size_of_change(r, edit_) : -1.0;
  }

  /// If the edit moved all strokes together, moves the axes with them.
  bool keep_together() {
    for (const bool flips : {false, true}) {
      const std::optional<Similarity> map = common_similarity(all_, flips);
      if (!map) continue;
      SymmetryGroup moved = moved_group(group_, *map);
      if (!check_symmetry_group(moved)) moved.images.clear();
      const bool stays = !flips && map->factor == Complex(1.0, 0.0) && map->shift == Complex{};
      if (stays) return true;
      edit_.set_group(id_, moved.images.empty()
                               ? nullptr
                               : std::make_shared<const SymmetryGroup>(std::move(moved)));
      return true;
    }
    return false;
  }

  /// Gives every other stroke the mirrored result of the leader.
  void lead(const ImageResult& leader) {
    SymmetryGroup whole{group_.center, group_.angle_rad, group_.axes, {}};
    std::vector<SymmetryGroup> parts(leader.parts.size(), whole);
    const bool all_follow = std::all_of(all_.begin(), all_.end(), [&](const ImageResult& r) {
      if (r.image == leader.image) return add_leader(leader, whole, parts);
      return !is_open_for(r) || follow_leader(leader, r, whole, parts);
    });
    if (!all_follow) return edit_.set_group(id_, nullptr);
    const bool is_group = whole.images.size() > 1;
    if (!is_group) {
      edit_.set_group(id_, nullptr);
    } else if (whole != group_) {
      edit_.set_group(id_, std::make_shared<const SymmetryGroup>(std::move(whole)));
    }
    for (SymmetryGroup& group : parts) {
      if (group.images.size() > 1) edit_.add_group(std::move(group));
    }
  }

  static bool add_leader(const ImageResult& leader, SymmetryGroup& whole,
                         std::vector<SymmetryGroup>& parts) {
    if (leader.after) whole.images.push_back(leader.image);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i].images.push_back({leader.parts[i], leader.image.image});
    }
    return true;
  }

  /// Returns true if tools may change the stroke of a partner.
  [[nodiscard]] bool is_open_for(const ImageResult& r) const {
    const Layer* layer = document_.layer(document_.layer_of(r.image.stroke));
    return layer && is_open(*layer);
  }

  bool follow_leader(const ImageResult& leader, const ImageResult& partner, SymmetryGroup& whole,
                     std::vector<SymmetryGroup>& parts) {
    const Affine map = image_map(group_, leader.image.image, partner.image.image);
    StrokePtr after = leader.after ? mirrored(*leader.after, map) : nullptr;
    if (leader.after && !after) return false;
    std::vector<StrokePtr> images;
    for (const StrokeId id : leader.parts) {
      images.push_back(mirrored(*edit_.after(id), map));
      if (!images.back()) return false;
    }
    for (const StrokeId id : partner.parts) edit_.drop(id);
    if (after) whole.images.push_back(partner.image);
    edit_.set(partner.image.stroke, std::move(after));
    StrokeId below = partner.image.stroke;
    for (std::size_t i = 0; i < images.size(); ++i) {
      below = edit_.add_above(below, std::move(images[i]));
      parts[i].images.push_back({below, partner.image.image});
    }
    return true;
  }

  const Document& document_;
  SymmetryId id_;
  const SymmetryGroup& group_;
  std::vector<ImageResult> all_;
  LayeredEdit& edit_;
};

/// Finds out what an edit made of the strokes of groups.
class ResultFinder {
 public:
  explicit ResultFinder(const Edit& edit) {
    for (const StrokeChange& c : edit.changes) changes_.emplace(c.id, &c);
    for (LineEdit& line : line_edits(edit)) lines_.emplace(line.id, std::move(line));
  }

  ImageResult find(const SymmetryImage& image, const StrokePtr& stroke) {
    ImageResult r{image, stroke, stroke};
    if (const auto c = changes_.find(image.stroke); c != changes_.end()) {
      r.after = c->second->after;
      r.is_changed = !r.after || *r.after != *stroke;
    }
    const auto line = lines_.find(image.stroke);
    if (line == lines_.end()) return r;
    for (const StrokeId id : line->second.after) {
      if (id == image.stroke) continue;
      const StrokeChange& other = *changes_.at(id);
      // A copy of the line may lie on it in another layer.
      const bool is_beside =
          other.after_place.layer == changes_.at(image.stroke)->before_place.layer;
      if (!other.before && is_beside && is_piece_of(*other.after, *stroke)) {
        if (claimed_.insert(id).second) r.parts.push_back(id);
      }
    }
    return r;
  }

 private:
  std::map<StrokeId, const StrokeChange*> changes_;
  std::map<StrokeId, LineEdit> lines_;
  std::set<StrokeId> claimed_;  // parts of strokes that were found
};

/// Returns the groups with a stroke that the edit changes.
std::set<SymmetryId> changed_groups(const Document& document, const Edit& edit) {
  std::set<SymmetryId> groups;
  for (const StrokeChange& c : edit.changes) {
    if (!c.before || c.before == c.after || (c.after && *c.before == *c.after)) continue;
    if (const SymmetryId group = document.symmetry_of(c.id)) groups.insert(group);
  }
  for (const SymmetryChange& c : edit.symmetries) groups.erase(c.id);
  return groups;
}

/// Returns true if two strokes are the same image of two groups with the same axes and images, so
/// that their partners are to be joined in the same way.
bool are_same_image(const Document& document, StrokeId a, StrokeId b) {
  const SymmetryId id_a = document.symmetry_of(a), id_b = document.symmetry_of(b);
  if (!id_a || !id_b || id_a == id_b) return false;
  const SymmetryGroup &p = *document.find_symmetry(id_a), &q = *document.find_symmetry(id_b);
  if (p.center != q.center || p.angle_rad != q.angle_rad || p.axes != q.axes) return false;
  return std::equal(p.images.begin(), p.images.end(), q.images.begin(), q.images.end(),
                    [a, b](const SymmetryImage& x, const SymmetryImage& y) {
                      return x.image == y.image && (x.stroke == a) == (y.stroke == b);
                    });
}

/// Returns the groups that end because the edit joins one of their strokes with a stroke whose
/// partners cannot be joined in the same way.
std::set<SymmetryId> groups_that_end(const Document& document, const Edit& edit) {
  const std::vector<StrokeJoin> joins = stroke_joins(edit);
  std::set<SymmetryId> ended;
  const auto end = [&](StrokeId stroke) {
    const SymmetryId id = document.symmetry_of(stroke);
    return id && ended.insert(id).second;
  };
  for (const StrokeJoin& join : joins) {
    if (are_same_image(document, join.from, join.into)) continue;
    end(join.from);
    end(join.into);
  }
  // A group that ends also ends those that would follow it.
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const StrokeJoin& join : joins) {
      const bool ends = ended.contains(document.symmetry_of(join.from)) ||
                        ended.contains(document.symmetry_of(join.into));
      if (ends && (int{end(join.from)} + int{end(join.into)}) > 0) is_done = false;
    }
  }
  return ended;
}

}  // namespace

void let_images_follow(const Document& document, Edit& edit) {
  if (document.symmetries().empty() || edit.changes.empty()) return;
  const std::set<SymmetryId> groups = changed_groups(document, edit);
  if (groups.empty()) return;
  ResultFinder finder(edit);
  std::vector<std::pair<SymmetryId, std::vector<ImageResult>>> results;
  for (const SymmetryId id : groups) {
    std::vector<ImageResult> all;
    for (const SymmetryImage& image : document.find_symmetry(id)->images) {
      const StrokePtr stroke = document.find(image.stroke);
      if (!stroke || document.symmetry_of(image.stroke) != id) continue;
      all.push_back(finder.find(image, stroke));
    }
    results.emplace_back(id, std::move(all));
  }
  const std::set<SymmetryId> ended = groups_that_end(document, edit);
  LayeredEdit layered(document, edit);
  for (auto& [id, all] : results) {
    if (ended.contains(id)) {
      layered.set_group(id, nullptr);
    } else {
      GroupFollower(document, id, std::move(all), layered).follow();
    }
  }
  layered.finish();
}

}  // namespace felt
