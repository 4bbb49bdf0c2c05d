#include "felt/io/svg/svg_nonzero.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "felt/geometry/cubic.h"
#include "felt/geometry/intersect.h"
#include "felt/geometry/roots.h"

namespace felt {
namespace {

constexpr std::size_t kMaxCurves = 1000;  ///< the search takes quadratic time
constexpr double kSameMm = 1e-6;          ///< ends closer than this are one node
constexpr double kAsideMm = 1e-5;         ///< how far beside a piece its windings are taken

/// A part of the boundary between two nodes.
struct NonzeroPiece {
  Cubic curve;
  std::size_t from = 0, to = 0;
  bool is_used = false;
};

class NonzeroResolver {
 public:
  explicit NonzeroResolver(const std::vector<FillLoop>& loops) {
    for (const FillLoop& loop : loops) {
      for (std::size_t i = 0; i + 1 < loop.points.size(); i += 3) {
        const Cubic c = fill_segment(loop, i / 3);
        if (control_length(c) > kSameMm) curves_.push_back(c);
      }
    }
  }

  std::optional<std::vector<FillLoop>> run() {
    if (curves_.size() > kMaxCurves || !split_curves()) return std::nullopt;
    if (!keep_edges_of_area()) return std::nullopt;
    std::vector<FillLoop> loops;
    for (NonzeroPiece& piece : pieces_) {
      if (piece.is_used) continue;
      std::optional<FillLoop> loop = chain(piece);
      if (!loop) return std::nullopt;
      loops.push_back(*std::move(loop));
    }
    return loops;
  }

 private:
  /// Splits all curves where they meet. Returns false if some of these points may be missing.
  bool split_curves() {
    std::vector<std::vector<double>> cuts(curves_.size(), {0.0, 1.0});
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (const auto self = self_intersection(curves_[i])) {
        cuts[i].insert(cuts[i].end(), {self->t1, self->t2});
      }
      for (std::size_t k = i + 1; k < curves_.size(); ++k) {
        if (!control_bounds(curves_[i]).intersects(control_bounds(curves_[k]))) continue;
        const Crossings found = intersections(curves_[i], curves_[k]);
        if (!found.complete) return false;
        for (const Crossing& c : found) {
          cuts[i].push_back(c.t1);
          cuts[k].push_back(c.t2);
        }
      }
    }
    for (std::size_t i = 0; i < curves_.size(); ++i) add_pieces(curves_[i], cuts[i]);
    return true;
  }

  void add_pieces(const Cubic& c, std::vector<double>& cuts) {
    std::sort(cuts.begin(), cuts.end());
    double from = 0.0;
    for (const double to : cuts) {
      const Cubic part = sub_segment(c, from, to);
      if (control_length(part) <= kSameMm) continue;
      pieces_.push_back({part, node(part.p[0]), node(part.p[3]), false});
      from = to;
    }
  }

  std::size_t node(Point p) {
    const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                                    [p](Point q) { return distance(p, q) <= kSameMm; });
    const auto index = static_cast<std::size_t>(found - nodes_.begin());
    if (index == nodes_.size()) nodes_.push_back(p);
    return index;
  }

  /// Returns how often the loops wind around a point: the crossings of a ray to the right.
  [[nodiscard]] int winding(Point p) const {
    int turns = 0;
    for (const Cubic& c : curves_) {
      const double y0 = c.p[0].y, y1 = c.p[1].y, y2 = c.p[2].y, y3 = c.p[3].y;
      for (const double t : cubic_roots(y0 - p.y, 3.0 * (y1 - y0), 3.0 * (y2 - 2.0 * y1 + y0),
                                        y3 - 3.0 * y2 + 3.0 * y1 - y0)) {
        const double rise = derivative(c, t).y;
        if (evaluate(c, t).x > p.x) turns += rise > 0.0 ? 1 : rise < 0.0 ? -1 : 0;
      }
    }
    return turns;
  }

  /// Drops the pieces with paint on both sides. Returns false if the windings on the sides of a
  /// piece do not differ by one, so the piece lies on another one.
  bool keep_edges_of_area() {
    std::vector<NonzeroPiece> kept;
    for (const NonzeroPiece& piece : pieces_) {
      constexpr double kT = 0.4871;  // no round number, so that rays do not meet corners
      const Vec aside = kAsideMm * perp(tangent(piece.curve, kT));
      const Point at = evaluate(piece.curve, kT);
      const int a = winding(at + aside), b = winding(at - aside);
      if (std::abs(a - b) != 1) return false;
      if ((a == 0) != (b == 0)) kept.push_back(piece);
    }
    pieces_ = std::move(kept);
    return true;
  }

  /// Returns the loop of unused pieces that begins with a piece, or nothing if it does not close.
  std::optional<FillLoop> chain(NonzeroPiece& first) {
    FillLoop loop{{nodes_[first.from]}, {}};
    std::size_t at = first.from;
    NonzeroPiece* next = &first;
    while (next != nullptr) {
      next->is_used = true;
      const Cubic c = next->from == at ? next->curve : reversed(next->curve);
      at = next->from == at ? next->to : next->from;
      loop.points.insert(loop.points.end(), {c.p[1], c.p[2], nodes_[at]});
      if (at == first.from) return loop;
      const auto fits = [at](const NonzeroPiece& piece) {
        return !piece.is_used && (piece.from == at || piece.to == at);
      };
      const auto found = std::find_if(pieces_.begin(), pieces_.end(), fits);
      next = found == pieces_.end() ? nullptr : &*found;
    }
    return std::nullopt;
  }

  std::vector<Cubic> curves_;
  std::vector<NonzeroPiece> pieces_;
  std::vector<Point> nodes_;
};

}  // namespace

bool resolve_crossings(std::vector<FillLoop>& loops) {
  std::optional<std::vector<FillLoop>> resolved = NonzeroResolver(loops).run();
  if (!resolved || resolved->empty()) return false;
  loops = *std::move(resolved);
  return true;
}

}  // namespace felt
