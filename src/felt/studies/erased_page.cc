#include "felt/studies/erased_page.h"

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr int kTurns = 4;
constexpr double kAimMm = 1.0;
constexpr double kEraserMm = 2.0;  // the radius by default: EraserSettings
constexpr double kReachMm = kEraserMm + 0.5 * kErasedInkMm;

}  // namespace

ErasedPage erased_page(Point middle, Vec along, double length_mm, Random& random) {
  const double half_mm = 0.5 * length_mm;
  const Vec across = perp(along);
  const auto at = [&](double along_mm, double aside_mm) {
    return middle + along_mm * along + aside_mm * across;
  };
  const double from_mm = -random.between(9.0, 16.0), to_mm = random.between(9.0, 16.0);
  ErasedPage page{.line = {at(-half_mm, 0.0), at(half_mm, 0.0)},
                  .from_mm = half_mm + from_mm,
                  .to_mm = half_mm + to_mm,
                  .others = {}};
  for (const double mark_mm : {from_mm, to_mm}) {
    const double slant_mm = random.between(-4.0, 4.0);
    page.others.push_back({at(mark_mm - slant_mm, -12.0), at(mark_mm + slant_mm, 12.0)});
  }
  for (const double side : {-1.0, 1.0}) {
    const double away_mm = side * (kReachMm + random.between(0.3, 1.2));
    page.others.push_back({at(from_mm + 3.5, away_mm), at(to_mm - 3.5, away_mm)});
  }
  return page;
}

std::vector<Point> erasing_path(const ErasedPage& page, Random& random) {
  const Point middle = point_at_length(page.line, 0.5 * polyline_length(page.line));
  const Vec along = normalized(page.line.back() - page.line.front());
  std::vector<Point> path = {middle};
  for (int turn = 0; turn < kTurns; ++turn) {
    const double stop_mm = turn % 2 == 0 ? page.to_mm - kReachMm : page.from_mm + kReachMm;
    const double aim_mm = stop_mm + kAimMm * random.normal();
    const Point aim =
        page.line.front() + aim_mm * along + 0.5 * kAimMm * random.normal() * perp(along);
    path.insert(path.end(), 2, aim);
  }
  path.push_back(middle);
  return path;
}

}  // namespace felt
