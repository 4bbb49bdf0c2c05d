#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::testing {

/// Two strokes that share a point: an end of `a` lies on `b`.
struct SharedEnd {
  StrokeId a;
  bool at_end = false;
  StrokeId b;
  double gap_mm = 0.0;
};

/// A drawing of strokes that share points.
struct JoinedDrawing {
  explicit JoinedDrawing(std::uint64_t seed) : random(seed) {}

  RandomStroke random;
  Fixture fixture;
  std::vector<StrokeId> ids;
  std::vector<SharedEnd> shared;

  /// Adds a stroke from a to b, straight or bent by up to a quarter of its length, of one to four
  /// segments.
  StrokeId line(Point a, Point b) {
    const Vec across = 0.25 * perp(b - a);
    const double bend = random.uniform(0, 1) < 0.4 ? 0.0 : random.uniform(-1, 1);
    const int n = 1 + static_cast<int>(random.uniform(0, 4));
    Cubic rest{
        {a, lerp(a, b, 1.0 / 3.0) + bend * across, lerp(a, b, 2.0 / 3.0) + bend * across, b}};
    StrokeData d;
    d.points.push_back(a);
    for (int k = n; k > 0; --k) {
      const auto [first, second] = split(rest, 1.0 / k);
      const Cubic& part = k > 1 ? first : rest;
      d.points.insert(d.points.end(), {part.p[1], part.p[2], part.p[3]});
      if (k > 1) d.joints.push_back(JointKind::kSmooth);
      rest = second;
    }
    d.widths = {{0.0, 1.0}, {static_cast<double>(n), 1.0}};
    ids.push_back(fixture.add(Stroke::create(std::move(d)).value()));
    return ids.back();
  }
  [[nodiscard]] Point direction(double degrees) const {
    const double a = degrees * std::numbers::pi / 180.0;
    return {std::cos(a), std::sin(a)};
  }
  void star(int arms, double least_degrees, double most_degrees) {
    double angle = random.uniform(0, 360);
    for (int k = 0; k < arms; ++k) {
      const Vec d = direction(angle) - Point{};
      // Strokes that start or end at the point that they share.
      const bool ends = random.uniform(0, 1) < 0.5;
      const Point far = Point{} + random.uniform(15, 60) * d;
      const StrokeId id = ends ? line(far, {}) : line({}, far);
      for (std::size_t i = 0; i + 1 < ids.size(); ++i) shared.push_back({id, ends, ids[i]});
      angle += random.uniform(least_degrees, most_degrees);
    }
  }
  void post(StrokeId base, double u, Point far) {
    const Point foot = fixture.document.find(base)->position(u);
    shared.push_back({line(far, foot), true, base});
  }
  void tee() {
    const Vec d = direction(random.uniform(0, 360)) - Point{};
    const StrokeId base = line(Point{} - 40 * d, Point{} + 40 * d);
    const double n = fixture.document.find(base)->segment_count();
    const double u = random.uniform(0.35, 0.65) * n;
    const Point foot = fixture.document.find(base)->position(u);
    post(base, u, foot + random.uniform(15, 50) * (direction(random.uniform(0, 360)) - Point{}));
  }
  void square() {
    const double size = random.uniform(8, 50);
    const Point corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    for (int k = 0; k < 4; ++k) line(corners[k], corners[(k + 1) % 4]);
    for (std::size_t k = 0; k < 4; ++k) shared.push_back({ids[k], true, ids[(k + 1) % 4]});
  }
  /// A line with both ends on another one.
  void bridge() {
    const StrokeId base = line({-40, 0}, {40, 0});
    const double n = fixture.document.find(base)->segment_count();
    const Stroke on = *fixture.document.find(base);
    const Point a = on.position(random.uniform(0.4, 0.48) * n);
    const Point b = on.position(random.uniform(0.52, 0.6) * n);
    const StrokeId id = line(a, b);
    shared.push_back({id, false, base});
    shared.push_back({id, true, base});
  }
  /// A closed line with posts on it, and a post on its seam.
  void ring() {
    const double r = random.uniform(5, 25), k = 0.5523 * r;
    StrokeData d{
        .points = {{r, 0},
                   {r, k},
                   {k, r},
                   {0, r},
                   {-k, r},
                   {-r, k},
                   {-r, 0},
                   {-r, -k},
                   {-k, -r},
                   {0, -r},
                   {k, -r},
                   {r, -k},
                   {r, 0}},
        .joints = {JointKind::kSmooth, JointKind::kSmooth, JointKind::kSmooth, JointKind::kSmooth},
        .closed = true,
        .widths = {{0.0, 1.0}, {4.0, 1.0}}};
    const Vec shift = random.uniform(0, r) * (direction(random.uniform(0, 360)) - Point{});
    for (Point& p : d.points) p += shift;
    const StrokeId id = fixture.add(Stroke::create(std::move(d)).value());
    ids.push_back(id);
    post(id, 0.0, {60, 5});
    post(id, random.uniform(0.5, 1.5), {5, 60});
    post(id, random.uniform(2.0, 3.5), {-60, -30});
  }
  /// Short lines, each of which begins at the end of the last one.
  void chain() {
    const double length = random.uniform(0.6, 6);
    Point at{-15, 0};
    for (int k = 0; k < 30; ++k) {
      const Point next = at + length * (direction(random.uniform(-40, 40)) - Point{});
      const StrokeId id = line(at, next);
      if (k > 0) shared.push_back({id, false, ids[ids.size() - 2]});
      at = next;
    }
  }
  /// Lines across and posts between them.
  void grid() {
    std::vector<StrokeId> rows;
    for (int k = -2; k <= 2; ++k) rows.push_back(line({-40, 7.0 * k}, {40, 7.0 * k}));
    for (int k = 0; k < 12; ++k) {
      const auto row = static_cast<std::size_t>(random.pick(0, 3));
      const double u = random.uniform(0.3, 0.7);
      const StrokePtr a = fixture.document.find(rows[row]);
      const StrokePtr b = fixture.document.find(rows[row + 1]);
      const Point from = a->position(u * a->segment_count());
      const Point to = b->position(u * b->segment_count());
      if (distance(from, to) < 1.0) continue;
      const StrokeId id = line(from, to);
      shared.push_back({id, false, rows[row]});
      shared.push_back({id, true, rows[row + 1]});
    }
  }
  void note_gaps() {
    for (SharedEnd& s : shared) s.gap_mm = gap(s, {});
  }
  [[nodiscard]] const Stroke& shown(StrokeId id, const Edit& preview) const {
    for (const StrokeChange& c : preview.changes) {
      if (c.id == id) return *c.after;
    }
    return *fixture.document.find(id);
  }
  [[nodiscard]] double gap(const SharedEnd& s, const Edit& preview) const {
    const Stroke& a = shown(s.a, preview);
    return distance_to(shown(s.b, preview), a.position(s.at_end ? a.segment_count() : 0.0));
  }
  /// Returns the largest growth of a gap.
  [[nodiscard]] double worst_gap_mm(const Edit& preview) const {
    double worst = 0.0;
    for (const SharedEnd& s : shared) worst = std::max(worst, gap(s, preview) - s.gap_mm);
    return worst;
  }
  /// Adds a locked layer and puts the next strokes into it.
  void begin_locked() {
    fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
    fixture.layer = LayerId{2};
  }
  /// Locks the layer of begin_locked() and puts the next strokes into the first layer.
  void end_locked() {
    fixture.apply(
        {"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", true, true}, 1, 1}}});
    fixture.layer = LayerId{1};
  }
  /// Adds lines that meet at an L, V, X or T, several lines in one point, squares, bridges, rings,
  /// chains and grids.
  void draw(std::uint64_t seed) {
    switch (seed % 10) {
      case 0:
        return star(2, 80, 100);  // L
      case 1:
        return star(2, 10, 70);  // V
      case 2:
        return star(4, 60, 110);  // X
      case 3:
        return tee();
      case 4:
        return star(3 + static_cast<int>(seed / 10 % 4), 30, 60);
      case 5:
        return square();
      case 6:
        return bridge();
      case 7:
        return ring();
      case 8:
        return chain();
      default:
        return grid();
    }
  }
};

}  // namespace felt::testing
