#include "contours.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <random>
#include <string_view>
#include <utility>

#include "apps/cli/text_table.h"
#include "bench/hand/statistics.h"
#include "felt/base/constants.h"
#include "felt/contour/find_contours.h"
#include "felt/geometry/polyline.h"
#include "hand_task.h"

namespace felt::bench {
namespace {

constexpr double kMaxRatio = 0.65, kMaxWrongShare = 0.02;
constexpr double kSlowPace = 0.25;  // of people who draw slowly: Person::pace
constexpr int kSidePx = 500, kKinds = 5, kShapes = 4;
constexpr double kMmPerPx = 0.2;
constexpr Point kMiddle{50.0, 50.0};
// A contour further away from the shape is another one.
constexpr double kWrongMm = 0.5;

/// Returns a closed shape around the middle of a picture, mm.
std::vector<Point> shape(int which) {
  std::vector<Point> points;
  for (int i = 0; i <= 400; ++i) {
    const double angle = kTau * i / 400.0, c = std::cos(angle), s = std::sin(angle);
    Vec from;
    switch (which) {
      case 0:
        from = {25.0 * c, 25.0 * s};
        break;
      case 1:
        from = {33.0 * c - 6.0 * s, 16.0 * s + 9.0 * c};
        break;
      case 2:
        from = (24.0 + 4.0 * std::cos(5.0 * angle)) * Vec{c, s};
        break;
      default:  // a square with round corners
        from = 22.0 / std::pow(std::pow(c, 4.0) + std::pow(s, 4.0), 0.25) * Vec{c, s};
    }
    points.push_back(kMiddle + from);
  }
  return points;
}

/// Returns how much of a pixel is dark whose middle is this far inside an edge, mm.
double covered(double inside_mm, double blur_mm) {
  return std::clamp(0.5 + inside_mm / std::max(blur_mm, kMmPerPx), 0.0, 1.0);
}

/// Returns the grey value of a picture at a position that is `inside_mm` inside the shape.
double grey_at(int kind, Point p, double inside_mm) {
  const double on_line = 0.5 - std::fabs(inside_mm);
  switch (kind) {
    case 0:  // a silhouette
      return 225.0 - 170.0 * covered(inside_mm, 0.1);
    case 1:  // a pencil line that is stronger and weaker
      return 215.0 - (75.0 + 35.0 * std::sin(0.4 * p.x)) * covered(on_line - 0.25, 0.2);
    case 2:  // a shaded body, out of focus, on a shaded ground
      return 90.0 + 0.8 * p.x + covered(inside_mm, 0.6) * (25.0 + 0.6 * p.y);
    case 3: {  // on a texture, with a second body that crosses its edge
      const double texture = 10.0 * std::sin(2.1 * p.x) * std::sin(2.1 * p.y);
      const double other = covered(14.0 - distance(p, {74.0, 34.0}), 0.1);
      return 190.0 + texture - 80.0 * covered(inside_mm, 0.1) - 40.0 * other;
    }
    default: {  // an ink line with hatching inside
      const double stripe = 0.15 - std::fabs(std::remainder(p.x + p.y, 6.0)) / std::sqrt(2.0);
      const double hatched = inside_mm > 1.0 ? covered(stripe, 0.1) : 0.0;
      return 230.0 - 190.0 * std::max(covered(on_line, 0.1), hatched);
    }
  }
}

/// A picture, the shape that one draws, and what is felt.
struct Picture {
  std::vector<Point> path;
  UseEdges edges;
};

Result<Picture> picture(int kind, int which) {
  constexpr std::array<double, kKinds> kNoise{4.0, 10.0, 8.0, 6.0, 6.0};
  Picture made{.path = shape(which), .edges = {}};
  std::mt19937 random(static_cast<unsigned>(100 * kind + which));
  std::normal_distribution<double> noise(0.0, kNoise[static_cast<std::size_t>(kind)]);
  GreyPicture grey{kSidePx, kSidePx, {}};
  for (int y = 0; y < kSidePx; ++y) {
    for (int x = 0; x < kSidePx; ++x) {
      const Point p{kMmPerPx * (x + 0.5), kMmPerPx * (y + 0.5)};
      const double away = std::sqrt(nearest_on_polyline(made.path, p).distance_squared);
      const double inside = contains(made.path, p, FillRule::kNonZero) ? away : -away;
      const double value = grey_at(kind, p, inside) + noise(random);
      grey.grey.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))));
    }
  }
  auto contours = find_contours(grey, {.mm_per_px = kMmPerPx});
  if (!contours) return tl::unexpected(contours.error());
  for (auto& contour : *contours) {
    for (Point& p : contour) p = {kMmPerPx * p.x, kMmPerPx * p.y};
  }
  made.edges.contours = *std::move(contours);
  return made;
}

/// Adds up for which length the pen is held, and for which of it to another contour.
class HeldLength {
 public:
  explicit HeldLength(const Picture& picture) : picture_(picture) {}

  void add(const TickReport& report) {
    const Point pen = on_page(report.sample.position);
    const double moved = distance(pen, std::exchange(last_, pen));
    if (!in_contact(report.sample)) return;
    drawn_mm_ += moved;
    for (const ForceTerms::Term& term : report.terms) {
      if (std::string_view(term.name) != "guide") continue;
      const Vec force{term.force.x, term.force.y};
      sum_n_ += norm(force);
      if (is_wrong(pen, force)) wrong_mm_ += moved;
    }
    ++ticks_;
  }
  [[nodiscard]] double wrong_share() const noexcept { return wrong_mm_ / std::max(drawn_mm_, 1.0); }
  [[nodiscard]] double mean_n() const noexcept { return sum_n_ / std::max(ticks_, 1); }

 private:
  /// Returns true if the nearest contour in the direction of the force is not that of the shape.
  [[nodiscard]] bool is_wrong(Point pen, Vec force) const {
    if (norm(force) < 0.01) return false;
    double best = 2.0;
    bool is_other = false;
    for (const std::vector<Point>& contour : picture_.edges.contours) {
      const PolylineNearest near = nearest_on_polyline(contour, pen);
      const double mm = std::sqrt(near.distance_squared);
      if (mm >= best || dot(near.point - pen, force) <= 0.7 * mm * norm(force)) continue;
      best = mm;
      is_other =
          nearest_on_polyline(picture_.path, near.point).distance_squared > kWrongMm * kWrongMm;
    }
    return is_other;
  }

  const Picture& picture_;
  Point last_;
  double drawn_mm_ = 0.0, wrong_mm_ = 0.0, sum_n_ = 0.0;
  int ticks_ = 0;
};

/// What one person did, on average over the pictures.
struct Drawn {
  double error_mm = 0.0, wrong_share = 0.0, mean_n = 0.0;
};

Result<Drawn> draw_all(const std::vector<Picture>& pictures, const Person& person,
                       const StylusPreset& device, bool is_on) {
  Drawn sum;
  const double share = 1.0 / static_cast<double>(pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    HandTask task{.path = pictures[i].path, .trial = i};
    if (is_on) task.edges = pictures[i].edges;
    HeldLength held(pictures[i]);
    const Result<HandTaskResult> done =
        run_task(task, person, device, [&held](const TickReport& tick) { held.add(tick); });
    if (!done) return tl::unexpected(done.error());
    sum.error_mm += share * done->stats.distance.mean_mm();
    sum.wrong_share += share * held.wrong_share();
    sum.mean_n += share * held.mean_n();
  }
  return sum;
}

/// What a population did without and with contours.
struct Totals {
  std::vector<double> off_mm, on_mm, changes, wrong_shares, forces_n;
};

Result<Totals> totals_of(const std::vector<Picture>& pictures, const StylusPreset& device,
                         PersonModel model, std::size_t people) {
  Totals totals;
  for (Person person : population(people, 1, model)) {
    person.pace = kSlowPace;
    auto off =
        std::async(std::launch::async, [&] { return draw_all(pictures, person, device, false); });
    const Result<Drawn> on = draw_all(pictures, person, device, true);
    const Result<Drawn> without = off.get();
    if (!on) return tl::unexpected(on.error());
    if (!without) return tl::unexpected(without.error());
    totals.off_mm.push_back(without->error_mm);
    totals.on_mm.push_back(on->error_mm);
    totals.changes.push_back(on->error_mm / without->error_mm - 1.0);
    totals.wrong_shares.push_back(on->wrong_share);
    totals.forces_n.push_back(on->mean_n);
  }
  return totals;
}

}  // namespace

Result<bool> compare_contours(const std::vector<std::string>& devices, std::size_t people) {
  std::vector<Picture> pictures;
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int which = 0; which < kShapes; ++which) {
      Result<Picture> made = picture(kind, which);
      if (!made) return tl::unexpected(made.error());
      pictures.push_back(*std::move(made));
    }
  }
  using Align = cli::TextTable::Align;
  std::vector<cli::TextTable::Column> columns = {{"device", Align::kLeft}, {"model", Align::kLeft}};
  for (const char* name : {"off mm", "on mm", "change (95 %)", "mean N", "wrong %"}) {
    columns.push_back({name, Align::kRight});
  }
  cli::TextTable table(columns);
  bool is_met = true;
  for (const std::string& name : devices) {
    for (const PersonModel model : kPersonModels) {
      const auto totals = totals_of(pictures, *find_stylus_preset(name), model, people);
      if (!totals) return tl::unexpected(totals.error());
      const double off = mean_over_people(totals->off_mm).mean;
      const double on = mean_over_people(totals->on_mm).mean;
      const double wrong = mean_over_people(totals->wrong_shares).mean;
      const MeanOverPeople change = mean_over_people(totals->changes);
      is_met = is_met && on <= kMaxRatio * off && wrong <= kMaxWrongShare;
      table.add_row({name, std::string(person_model_name(model)), fmt::format("{:.3f}", off),
                     fmt::format("{:.3f}", on),
                     fmt::format("{:+.1f} % ({:+.1f} to {:+.1f})", 100.0 * change.mean,
                                 100.0 * change.low, 100.0 * change.high),
                     fmt::format("{:.3f}", mean_over_people(totals->forces_n).mean),
                     fmt::format("{:.2f}", 100.0 * wrong)});
    }
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people who draw slowly over {} pictures of {} kinds, default options without "
      "and with the contours\nof the pictures. Change of the mean distance from the shape, per "
      "person, with the 95 % interval over people.\nwrong: share of the length for which another "
      "contour holds the pen.\nBars: {:.2f} times the error, {:.0f} % of the length: {}\n",
      people, pictures.size(), kKinds, kMaxRatio, 100.0 * kMaxWrongShare,
      is_met ? "met" : "MISSED");
  return is_met;
}

}  // namespace felt::bench
