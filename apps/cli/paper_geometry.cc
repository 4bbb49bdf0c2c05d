#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/session/session.h"
#include "felt/stroke/width_profile.h"
#include "paper_equations.h"
#include "paper_samples.h"

namespace felt::cli {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

/// Returns the four basis functions of equation 1 at t, as evaluate() has them.
std::array<double, 4> basis_at(double t) {
  std::array<double, 4> b{};
  for (std::size_t k = 0; k < 4; ++k) {
    Cubic c{};
    c.p[k].x = 1.0;
    b[k] = evaluate(c, t).x;
  }
  return b;
}

/// Returns numbers between 0 and 1 that are spread evenly, always the same.
double spread(int i, double ratio) {
  return std::fmod((i + 1) * ratio, 1.0);
}

template <class Visit>
void for_each_segment(const std::vector<StrokePtr>& strokes, Visit visit) {
  for (const StrokePtr& stroke : strokes) {
    for (int i = 0; i < stroke->segment_count(); ++i) visit(*stroke, i);
  }
}

PaperEquation curve_equation(const std::vector<StrokePtr>& cat) {
  double largest = 0.0;
  int segments = 0;
  for_each_segment(cat, [&](const Stroke& stroke, int i) {
    const Cubic c = stroke.segment(i);
    ++segments;
    for (int k = 0; k <= 100; ++k) {
      const double t = 0.01 * k, s = 1.0 - t;
      const std::array b{std::pow(s, 3), 3 * t * s * s, 3 * t * t * s, std::pow(t, 3)};
      Vec sum{};
      for (std::size_t j = 0; j < 4; ++j) sum += b[j] * (c.p[j] - Point{});
      largest = std::max({largest, distance(evaluate(c, t), Point{} + sum),
                          distance(split(c, t).first.p[3], Point{} + sum)});
    }
  });
  return {
      "(1)",
      "f(t) = (1-t)^3 B1 + 3t(1-t)^2 B2 + 3t^2(1-t) B3 + t^3 B4",
      "the same",
      "",
      fmt::format("The curves of the library differ from it by at most {:.1e} mm, at 101 points "
                  "of each of the {} segments of the cat.",
                  largest, segments),
      ""};
}

/// The joints of a fit: how many, and how much the curve turns there.
struct Joints {
  int segments = 0;
  int joints = 0;
  int smooth = 0;
  double largest_gap_mm = 0.0;
  double largest_deg = 0.0;
};

Joints joints_of(const std::vector<StrokePtr>& strokes) {
  Joints found;
  for_each_segment(strokes, [&](const Stroke& stroke, int i) {
    ++found.segments;
    if (i == 0) return;
    const Cubic before = stroke.segment(i - 1), after = stroke.segment(i);
    const double deg = kDegPerRad * angle_between(tangent(before, 1.0), tangent(after, 0.0));
    ++found.joints;
    found.smooth += deg <= 1e-6;
    found.largest_gap_mm = std::max(found.largest_gap_mm, distance(before.p[3], after.p[0]));
    found.largest_deg = std::max(found.largest_deg, deg);
  });
  return found;
}

/// Returns the mean distance between the data points P_i and P_(i+s) of the cat, by which the ends
/// of two neighbours would be apart if both equations held as printed.
Result<double> printed_gap_mm(int shared) {
  constexpr double kDataPointMm = 0.25;
  const Result<std::vector<std::vector<InkSample>>> strokes = cat_samples();
  if (!strokes) return tl::unexpected(strokes.error());
  double sum = 0.0;
  int count = 0;
  for (const std::vector<InkSample>& samples : *strokes) {
    std::vector<Point> points;
    for (const InkSample& sample : samples) {
      if (points.empty() || distance(points.back(), sample.position) >= kDataPointMm)
        points.push_back(sample.position);
    }
    for (std::size_t i = static_cast<std::size_t>(shared); i < points.size(); ++i, ++count) {
      sum += distance(points[i - static_cast<std::size_t>(shared)], points[i]);
    }
  }
  return sum / std::max(count, 1);
}

Result<PaperEquation> fit_equation() {
  std::vector<std::vector<std::string>> rows;
  std::string main;
  const auto add = [&rows](std::string name, const std::string& gap, const Joints& j) {
    rows.push_back({std::move(name), gap, fmt::format("{}", j.segments),
                    fmt::format("{}", j.joints), fmt::format("{}", j.smooth),
                    fmt::format("{:.1f}", j.largest_deg), fmt::format("{:.3f}", j.largest_gap_mm)});
  };
  for (const int shared : {0, 2, 4, 8}) {
    const auto fitted = cat_fitted_by(FitScheme::kPaper2002, shared);
    const Result<double> gap_mm = printed_gap_mm(shared);
    if (!fitted) return tl::unexpected(fitted.error());
    if (!gap_mm) return tl::unexpected(gap_mm.error());
    const Joints joints = joints_of(*fitted);
    add(fmt::format("equation 2, s = {}", shared), fmt::format("{:.2f}", *gap_mm), joints);
    if (shared != InkFitOptions{}.shared_samples) continue;
    main = fmt::format(
        "With s = {}, the ends of two neighbours would be {:.2f} mm apart as printed; "
        "as read they meet, but turn by up to {:.1f} degrees.",
        shared, *gap_mm, joints.largest_deg);
  }
  const auto ours = cat_fitted_by(FitScheme::kFeltline);
  if (!ours) return tl::unexpected(ours.error());
  add("Feltline's own fit", "", joints_of(*ours));
  return PaperEquation{
      "(2)",
      "B1 = P_s, B4 = P_(n-s)",
      "B1 = P_(1+s), B4 = P_(n-s); neighbours share 2s + 1 points",
      "E7, E8, E9",
      main,
      markdown_table({"fit of the cat", "gap as printed, mm", "segments", "joints", "smooth joints",
                      "largest angle, degrees", "largest gap as read, mm"},
                     rows)};
}

PaperEquation width_equation(const std::vector<StrokePtr>& cat) {
  double largest = 0.0;
  int knots = 0, segments = 0;
  for (const StrokePtr& stroke : cat) {
    segments += stroke->segment_count();
    const auto profile = stroke->widths();
    for (std::size_t k = 1; k < profile.size(); ++k, ++knots) {
      for (const double tw : {0.0, 0.2, 0.5, 0.7, 1.0}) {
        const double u = profile[k - 1].u + tw * (profile[k].u - profile[k - 1].u);
        const double w = (1.0 - tw) * profile[k - 1].width_mm + tw * profile[k].width_mm;
        largest = std::max(largest, std::abs(width_at(profile, u) - w));
      }
    }
  }
  return {
      "(3)",
      "W = (1 - tw) W1 + tw W2",
      "the same; W1 stays, W2 by least squares",
      "E10, E11",
      fmt::format("The widths of the library differ from it by at most {:.1e} mm. The cat has {} "
                  "width segments on {} Bezier segments.",
                  largest, knots, segments),
      ""};
}

/// What equations 4 to 6 give for pens all over the cat.
std::vector<PaperEquation> nearest_equations(const std::vector<StrokePtr>& cat) {
  constexpr int kPens = 1000;
  double best_excess = 0.0, largest_slope = 0.0;
  int at_ends = 0;
  std::vector<Cubic> curves;
  for_each_segment(cat, [&](const Stroke& s, int i) { curves.push_back(s.segment(i)); });
  for (int pen = 0; pen < kPens; ++pen) {
    const Point p{150.0 * spread(pen, std::numbers::phi), 140.0 * spread(pen, std::sqrt(2.0))};
    const Cubic& c = curves[static_cast<std::size_t>(pen) % curves.size()];
    const Nearest near = nearest(c, p);
    const double d = std::sqrt(near.distance_squared);
    for (int k = 0; k <= 1000; ++k) {
      best_excess = std::max(best_excess, d - distance(evaluate(c, 1e-3 * k), p));
    }
    if (near.t <= 0.0 || near.t >= 1.0) {
      ++at_ends;
    } else if (d > 0.1) {
      const Vec v = p - near.point;
      largest_slope = std::max(largest_slope, std::abs(dot(normalized(v), tangent(c, near.t))));
    }
  }
  const double beside_mm = 0.5, deep_mm = 3.0;
  const Nearest near = nearest(straight({0, 0}, {10, 0}), {5.0, beside_mm});
  return {
      {"(4)", "g(t) = (x-fx)^2 + (y-fy)^2 + (z-fz)^2", "only x and y", "E12",
       fmt::format("For a pen {} mm beside a line and {} mm deep, g = {:.2f} mm^2 as printed and "
                   "{:.2f} mm^2 as read.",
                   beside_mm, deep_mm, near.distance_squared + deep_mm * deep_mm,
                   near.distance_squared),
       ""},
      {"(5)", "dg/dt = 0", "the nearest point of all roots and ends", "E13",
       fmt::format(
           "Of {} pens all over the page of the cat, {} are nearest to an end of their "
           "segment, where the equation need not hold. Of 1001 other points of the segment, "
           "none is nearer than the library's by more than {:.1e} mm.",
           kPens, at_ends, best_excess),
       ""},
      {"(6)", "V = (x,y,z) - f(t)", "in the plane", "E12",
       fmt::format("Where (5) holds, V is perpendicular to the curve: the cosine of the angle is "
                   "at most {:.1e}.",
                   largest_slope),
       ""}};
}

/// A session whose pen pulls one line.
class PullTrial {
 public:
  PullTrial(const Cubic& line, const char* mode, const char* weights)
      : session_(make_tools(), {.device = {}, .document = document_of(std::array{line_of(line)})}) {
    ok_ = session_.apply({0, SelectTool{"pull"}})
              .and_then([&] { return set("pull.mode", std::string(mode)); })
              .and_then([&] { return set("pull.weights", std::string(weights)); });
  }

  Result<void> set(const char* option, const OptionValue& value) {
    return session_.apply({0, SetOption{option, value}});
  }
  /// Moves the pen to a point in `ms`; above the surface if `z_mm` is positive.
  void move(Point p, double z_mm, int ms = 1) {
    const Vec3 from = at_;
    for (int i = 1; i <= ms && ok_; ++i) {
      PenSample sample;
      sample.time_ns = now_ns_ += 1'000'000;
      sample.position = lerp(from, {p.x, p.y, z_mm}, static_cast<double>(i) / ms);
      ok_ = session_.sample(sample);
      at_ = sample.position;
    }
  }
  /// Returns the line as the pull has changed it so far.
  [[nodiscard]] StrokePtr line() const {
    const Document seen = session_.preview() ? shown() : session_.document();
    return seen.find(seen.layers().front().strokes.front());
  }
  [[nodiscard]] const Result<void>& ok() const { return ok_; }

 private:
  static StrokePtr line_of(const Cubic& c) {
    StrokeData data{.points = {c.p.begin(), c.p.end()}, .joints = {}, .widths = {{0, 1}, {1, 1}}};
    return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
  }
  [[nodiscard]] Document shown() const {
    Document document = session_.document();
    (void)document.apply(*session_.preview());
    return document;
  }

  Session session_;
  Result<void> ok_;
  Vec3 at_{0, 0, 5};
  std::int64_t now_ns_ = 0;
};

const Cubic kLine{{{{0, 0}, {10, -6}, {25, 6}, {36, 0}}}};
constexpr Vec kPullMm{1.5, 8.0};

/// What one grab of the line at t does.
struct Grabbed {
  std::array<double, 4> weights{};  ///< of V, by which B1 to B4 move
  double share = 0.0;               ///< of V, by which the point at t moves
};

Result<Grabbed> grabbed(double t, const char* weights) {
  PullTrial pull(kLine, "grab", weights);
  if (Result<void> freed = pull.set("pull.free_ends", true); !freed)
    return tl::unexpected(freed.error());
  const Point at = evaluate(kLine, t);
  pull.move(at, 5.0);
  pull.move(at, -1.0);
  pull.move(at + kPullMm, -1.0, 20);
  if (!pull.ok()) return tl::unexpected(pull.ok().error());
  const Cubic now = pull.line()->segment(0);
  Grabbed result;
  for (std::size_t k = 0; k < 4; ++k) {
    result.weights[k] = dot(now.p[k] - kLine.p[k], kPullMm) / norm_squared(kPullMm);
  }
  result.share = dot(evaluate(now, t) - at, kPullMm) / norm_squared(kPullMm);
  return result;
}

/// Returns after how many steps of the paper's loop (mode sweep, of 1 ms each) the curve is within
/// 1 % of its first distance from a pen that stands still.
Result<int> steps_to_pen(const char* weights) {
  constexpr int kMaxSteps = 2000;
  constexpr double kFastestS = 0.005;
  PullTrial pull(kLine, "sweep", weights);
  if (Result<void> set = pull.set("pull.sweep_time_s", kFastestS); !set)
    return tl::unexpected(set.error());
  const Point pen{18.0, 5.0};
  const auto away = [&] {
    double best = 1e300;
    const StrokePtr line = pull.line();
    for (int i = 0; i < line->segment_count(); ++i) {
      best = std::min(best, nearest(line->segment(i), pen).distance_squared);
    }
    return std::sqrt(best);
  };
  pull.move(pen, 5.0);
  pull.move(pen, -1.0);
  const double first = away();
  for (int step = 1; step <= kMaxSteps; ++step) {
    pull.move(pen, -1.0);
    if (!pull.ok()) return tl::unexpected(pull.ok().error());
    if (away() <= 0.01 * first) return step;
  }
  return kMaxSteps;
}

Result<PaperEquation> pull_equation() {
  std::vector<std::vector<std::string>> rows;
  std::string main;
  for (const double t : {0.0, 0.1, 0.25, 0.39, 0.5, 0.75, 0.9, 1.0}) {
    const std::array<double, 4> b = basis_at(t);
    double corrected = 0.0;
    for (const double part : b) corrected += part * part;
    const Result<Grabbed> printed = grabbed(t, "printed"), paper = grabbed(t, "paper"),
                          soft = grabbed(t, "soft");
    for (const auto* each : {&printed, &paper, &soft}) {
      if (!*each) return tl::unexpected(each->error());
    }
    rows.push_back({fmt::format("{}", t), fmt::format("{:.4f}", printed->weights[3]),
                    fmt::format("{:.4f}", b[3]), fmt::format("{:.4f}", printed->share),
                    fmt::format("{:.4f}", corrected), fmt::format("{:.4f}", paper->weights[1]),
                    fmt::format("{:.4f}", paper->share), fmt::format("{:.4f}", soft->share)});
    if (t != 0.5) continue;
    main = fmt::format(
        "At t = 0.5, B4 moves by {:.3f} V as printed instead of {:.3f} V, and {:.4f} "
        "of V arrives at the pen, {:.4f} with t^3; with the cases as read {:.4f}.",
        printed->weights[3], b[3], printed->share, corrected, paper->share);
  }
  const Result<int> printed = steps_to_pen("printed"), paper = steps_to_pen("paper");
  if (!printed) return tl::unexpected(printed.error());
  if (!paper) return tl::unexpected(paper.error());
  main += fmt::format(
      " The loop of the paper, with steps of 1 - exp(-0.2) of V, leaves 1 % of the "
      "distance after {} steps as printed and {} as read.",
      *printed, *paper);
  return PaperEquation{
      "(7)",
      "B1' = B1 + (1-t)^3 V, B2' = B2 + 3t(1-t)^2 V, B3' = B3 + 3t^2(1-t) V, B4' = B4 + t V",
      "the three cases, blended: B_i' = B_i + w_i V with sum b_i w_i = 1",
      "E1, E2, E3, E4, E5",
      main,
      markdown_table(
          {"t", "B4 moves by, of V, printed", "with t^3", "of V arrives, printed", "with t^3",
           "B2 moves by, of V, cases as read", "of V arrives, cases as read", "of V arrives, soft"},
          rows)};
}

}  // namespace

Result<std::vector<PaperEquation>> paper_geometry() {
  const Result<std::vector<StrokePtr>> cat = cat_fitted_by(FitScheme::kFeltline);
  if (!cat) return tl::unexpected(cat.error());
  Result<PaperEquation> fit = fit_equation(), pull = pull_equation();
  if (!fit) return tl::unexpected(fit.error());
  if (!pull) return tl::unexpected(pull.error());
  std::vector<PaperEquation> equations{curve_equation(*cat), *std::move(fit), width_equation(*cat)};
  for (PaperEquation& equation : nearest_equations(*cat)) equations.push_back(std::move(equation));
  equations.push_back(*std::move(pull));
  return equations;
}

}  // namespace felt::cli
