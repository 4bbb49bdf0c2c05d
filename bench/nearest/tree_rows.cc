#include <algorithm>
#include <random>

#include "felt/geometry/bvh.h"
#include "felt/geometry/testing/nearest_cases.h"
#include "rows.h"
#include "scene.h"

namespace felt::bench {
namespace {

constexpr std::size_t kTicks = 100000;

struct QueryPlan {
  const char* what;
  std::vector<Point> points;
  double radius = std::numeric_limits<double>::infinity();
  bool seeded = false;
  std::size_t swept_bytes = 0;  // read between calls to evict the tree from the caches
};

Row timed_queries(const SegmentBvh& tree, const QueryPlan& plan, Stopwatch& watch) {
  Row row;
  row.what = plan.what;
  row.segments = tree.size();
  row.ns.reserve(plan.points.size());
  std::vector<char> sweep(plan.swept_bytes, 1);
  SegmentBvh::Query query;
  query.radius_mm = plan.radius;
  for (const Point& p : plan.points) {
    for (std::size_t i = 0; i < sweep.size(); i += 64) sweep[i] = static_cast<char>(sweep[i] + 1);
    query.point = p;
    watch.start();
    const SegmentBvh::Hit hit = tree.nearest(query);
    row.ns.push_back(watch.stop());
    if (plan.seeded) query.seed = hit.handle;
    row.nodes += hit.used.nodes;
    row.pieces += hit.used.pieces;
    row.unproven += hit.proven ? 0.0 : 1.0;
  }
  const auto calls = static_cast<double>(plan.points.size());
  row.nodes /= calls, row.pieces /= calls, row.unproven /= calls;
  return row;
}

std::vector<Point> random_points(std::size_t count, double side) {
  std::mt19937_64 random(11);
  std::vector<Point> points(count);
  for (Point& p : points) {
    p.x = uniform(random, 0.0, side);
    p.y = uniform(random, 0.0, side);
  }
  return points;
}

// Moves random segments by up to half a unit, as one step of a pull does.
Row timed_refits(SegmentBvh& tree, Stopwatch& watch) {
  Row row{"refit one segment", tree.size(), {}, 0.0, 0.0, 0.0};
  std::mt19937_64 random(13);
  for (std::size_t i = 0; i < kTicks; ++i) {
    const auto handle = static_cast<std::uint32_t>(random() % tree.size());
    Cubic curve = tree.curve(handle);
    curve.p[1].x += uniform(random, -0.5, 0.5);
    curve.p[2].y += uniform(random, -0.5, 0.5);
    watch.start();
    tree.refit(handle, curve);
    row.ns.push_back(watch.stop());
  }
  return row;
}

}  // namespace

void tree_rows(Table& table, Stopwatch& watch, std::size_t n) {
  const std::vector<BvhSegment> segments = page(n, 1);
  const double side = canvas_side(n);
  SegmentBvh tree;
  Row build{"build", n, {}, 0.0, 0.0, 0.0};
  const double cpu = thread_cpu_ns();
  tree.build(segments);
  build.ns.push_back(thread_cpu_ns() - cpu);
  table.add(build);
  table.add(timed_queries(tree, {"query, random", random_points(kTicks, side)}, watch));
  table.add(
      timed_queries(tree, {"query, random, radius 10", random_points(kTicks, side), 10.0}, watch));
  QueryPlan path{"query, pen path", pen_path(kTicks, side, 3)};
  path.seeded = true;
  table.add(timed_queries(tree, path, watch));
  path.what = "query, pen path, cold caches";
  path.points.resize(2000);
  path.swept_bytes = std::size_t{16} << 20U;
  table.add(timed_queries(tree, path, watch));
  table.add(timed_refits(tree, watch));
}

void adversarial_rows(Table& table, Stopwatch& watch) {
  for (const std::size_t n : {1000U, 100000U, 1000000U}) {
    SegmentBvh tree;
    const Point centre{500.0, 500.0};
    tree.build(circle_of_arcs(n, centre, 400.0));
    table.add(timed_queries(tree, {"circle of arcs, pen at centre", {1000, centre}}, watch));
  }
  // Every segment crosses every box, so a query has many near misses that each need several
  // pieces.
  std::mt19937_64 random(17);
  std::vector<BvhSegment> tangle(100000);
  for (BvhSegment& s : tangle) s.curve = make_case(CaseKind::kLoop, random).curve;
  SegmentBvh tree;
  tree.build(tangle);
  table.add(timed_queries(tree, {"tangle of loops, random", random_points(10000, 100.0)}, watch));
  // All segments are equal, so the boxes cannot exclude any of them.
  std::fill(tangle.begin(), tangle.end(), tangle[0]);
  tree.build(tangle);
  table.add(timed_queries(tree, {"equal loops, random", random_points(10000, 100.0)}, watch));
}

}  // namespace felt::bench
