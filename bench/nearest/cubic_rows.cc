#include <array>
#include <random>

#include "felt/geometry/nearest.h"
#include "felt/geometry/testing/nearest_cases.h"
#include "rows.h"

#ifdef FELT_HAVE_2GEOM
#include <2geom/bezier-curve.h>
#endif

namespace felt::bench {
namespace {

constexpr std::array<const char*, kCaseKinds> kNames = {
    "random", "near line", "overshoot", "point", "cusp", "loop", "doubled ends", "arc", "tiny"};

std::vector<NearestCase> cases_of(CaseKind kind, std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<NearestCase> cases(count);
  for (NearestCase& c : cases) c = make_case(kind, random);
  return cases;
}

template <class Solve>
Row timed(std::string what, Stopwatch& watch, std::size_t calls, Solve&& solve) {
  Row row;
  row.what = std::move(what);
  row.segments = 1;
  row.ns.resize(calls);
  for (std::size_t i = 0; i < calls; ++i) {
    watch.start();
    solve(i);
    row.ns[i] = watch.stop();
  }
  return row;
}

}  // namespace

void cubic_rows(Table& table, Stopwatch& watch) {
  double sink = 0.0;
  for (int k = 0; k < kCaseKinds; ++k) {
    const auto kind = static_cast<CaseKind>(k);
    const std::string name = kNames[static_cast<unsigned>(k)];
    const std::vector<NearestCase> cases = cases_of(kind, 20000);
    table.add(timed("one cubic, " + name, watch, cases.size(),
                    [&](std::size_t i) { sink += nearest(cases[i].curve, cases[i].query).t; }));
#ifdef FELT_HAVE_2GEOM
    std::vector<Geom::CubicBezier> curves;
    for (const NearestCase& c : cases) {
      const auto& p = c.curve.p;
      curves.emplace_back(Geom::Point(p[0].x, p[0].y), Geom::Point(p[1].x, p[1].y),
                          Geom::Point(p[2].x, p[2].y), Geom::Point(p[3].x, p[3].y));
    }
    table.add(timed("  lib2geom, " + name, watch, cases.size(), [&](std::size_t i) {
      sink += curves[i].nearestTime(Geom::Point(cases[i].query.x, cases[i].query.y), 0.0, 1.0);
    }));
#endif
  }
#ifndef FELT_HAVE_2GEOM
  Table::note(
      "lib2geom was not found when this was built (package lib2geom-dev): its rows are missing");
#endif
  if (sink < 0.0) Table::note("impossible");  // keeps the compiler from removing the calls
}

}  // namespace felt::bench
