#include "felt/geometry/intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr double kMinSpan = 0x1p-48;
constexpr std::size_t kStack = 128;  // two curves, 48 halvings each, and the first pairs
constexpr double kSamePlaceMm = 1e-7;
constexpr int kOverlapSamples = 12;  // different cubics meet in at most nine points

double largest_coordinate(const Cubic& c) noexcept {
  double largest = 0.0;
  for (const Point& p : c.p) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

/// A part of a curve: its control points, and its parameter range on the whole curve.
struct Piece {
  Cubic c;
  double t0 = 0.0;
  double width = 1.0;

  static Piece of(const Cubic& c, double t0, double t1) noexcept {
    return {sub_segment(c, t0, t1), t0, t1 - t0};
  }
  [[nodiscard]] double at(double u) const noexcept { return t0 + u * width; }
  [[nodiscard]] std::pair<Piece, Piece> halves() const noexcept {
    const auto [left, right] = split(c, 0.5);
    const double half = 0.5 * width;
    return {Piece{left, t0, half}, Piece{right, t0 + half, half}};
  }
};

struct Pair {
  Piece a, b;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range along(Vec axis, Point origin, const Cubic& c) noexcept {
  Range r;
  for (const Point& p : c.p) {
    const double x = dot(axis, p - origin);
    r.low = std::min(r.low, x);
    r.high = std::max(r.high, x);
  }
  return r;
}

bool apart_along(Vec axis, const Cubic& a, const Cubic& b, double gap_mm) noexcept {
  const Range ra = along(axis, a.p[0], a), rb = along(axis, a.p[0], b);
  return ra.high + gap_mm < rb.low || rb.high + gap_mm < ra.low;
}

/// Returns true if the hulls are certainly more than the gap apart.
bool hulls_apart(const Cubic& a, const Cubic& b, double gap_mm) noexcept {
  if (!control_bounds(a).inflated(gap_mm).intersects(control_bounds(b))) return true;
  for (const Cubic* c : {&a, &b}) {
    const Vec chord = normalized(c->p[3] - c->p[0]);
    if (chord == Vec{}) continue;
    if (apart_along(perp(chord), a, b, gap_mm) || apart_along(chord, a, b, gap_mm)) return true;
  }
  return false;
}

/// Returns true if every direction of travel of `a` is strictly on the same side of every direction
/// of travel of `b`, so that the two curves meet at most once.
bool cross_once(const Cubic& a, const Cubic& b) noexcept {
  constexpr double kNoise = 1e-12;
  int side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec d = a.p[i + 1] - a.p[i];
    if (d == Vec{}) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec e = b.p[j + 1] - b.p[j];
      if (e == Vec{}) continue;
      const double turn = cross(d, e);
      if (!(std::fabs(turn) > kNoise * norm(d) * norm(e))) return false;
      const int s = turn > 0.0 ? 1 : -1;
      if (side == -s) return false;
      side = s;
    }
  }
  return side != 0;
}

/// The nearest points of two straight segments, as a parameter 0..1 on each segment.
struct Closest {
  double a = 0.0, b = 0.0;
  double distance_squared = std::numeric_limits<double>::infinity();

  void offer(double at_a, double at_b, double d2) noexcept {
    if (d2 < distance_squared) *this = {at_a, at_b, d2};
  }
};

Closest closest_of_chords(const Cubic& a, const Cubic& b) noexcept {
  Closest best;
  const Vec da = a.p[3] - a.p[0], db = b.p[3] - b.p[0];
  const double det = cross(da, db);
  if (det != 0.0) {
    const Vec from = b.p[0] - a.p[0];
    const double s = cross(from, db) / det, t = cross(from, da) / det;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) best.offer(s, t, 0.0);
  }
  for (const double end : {0.0, 1.0}) {
    const LineNearest on_b = nearest_on_line(b.p[0], b.p[3], lerp(a.p[0], a.p[3], end));
    best.offer(end, on_b.t, on_b.distance_squared);
    const LineNearest on_a = nearest_on_line(a.p[0], a.p[3], lerp(b.p[0], b.p[3], end));
    best.offer(on_a.t, end, on_a.distance_squared);
  }
  return best;
}

class Search {
 public:
  Search(const Cubic& f, const Cubic& g, int max_pairs) noexcept
      : f_(f),
        g_(g),
        max_pairs_(max_pairs),
        meet_mm_(kMeetMm + 1e-13 * std::max(largest_coordinate(f), largest_coordinate(g))) {}

  Crossings run() noexcept {
    if (hulls_apart(f_, g_, meet_mm_)) {
      result_.pairs = 1;
      return result_;
    }
    if (!begin_with_overlap()) push({Piece{f_}, Piece{g_}});
    while (count_ > 0 && result_.complete) {
      if (result_.pairs >= max_pairs_) {
        result_.complete = false;
        break;
      }
      ++result_.pairs;
      look_at(stack_[--count_]);
    }
    finish();
    return result_;
  }

 private:
  /// A meeting point, and the parts of both curves that it represents.
  struct Found {
    Crossing crossing;
    std::array<double, 2> first, second;
    double gap_mm = 0.0;
  };

  void push(const Pair& pair) noexcept {
    if (count_ < kStack) {
      stack_[count_++] = pair;
    } else {
      result_.complete = false;
    }
  }

  void look_at(const Pair pair) noexcept {
    if (hulls_apart(pair.a.c, pair.b.c, meet_mm_)) return;
    if (cross_once(pair.a.c, pair.b.c) && solve(pair)) return;
    const double straight_mm = 0.25 * meet_mm_;
    const bool a_done = pair.a.width < kMinSpan || flatness(pair.a.c) <= straight_mm;
    const bool b_done = pair.b.width < kMinSpan || flatness(pair.b.c) <= straight_mm;
    if (a_done && b_done) {
      touch(pair);
      return;
    }
    if (b_done || (!a_done && control_length(pair.a.c) >= control_length(pair.b.c))) {
      const auto [left, right] = pair.a.halves();
      push({right, pair.b});
      push({left, pair.b});
    } else {
      const auto [left, right] = pair.b.halves();
      push({pair.a, right});
      push({pair.a, left});
    }
  }

  /// Finds a crossing by Newton's method, clamped to the pieces. Returns false if it does not
  /// converge.
  bool solve(const Pair& pair) noexcept {
    const Closest guess = closest_of_chords(pair.a.c, pair.b.c);
    double s = guess.a, t = guess.b;
    for (int i = 0; i < 16; ++i) {
      const Vec gap = evaluate(pair.b.c, t) - evaluate(pair.a.c, s);
      const Vec da = derivative(pair.a.c, s), db = derivative(pair.b.c, t);
      const double det = cross(da, db);
      if (det == 0.0) break;
      const double s1 = std::clamp(s + cross(gap, db) / det, 0.0, 1.0);
      const double t1 = std::clamp(t + cross(gap, da) / det, 0.0, 1.0);
      const double step = std::fabs(s1 - s) + std::fabs(t1 - t);
      s = s1, t = t1;
      if (step < 1e-15) break;
    }
    const double gap_mm = distance(evaluate(pair.a.c, s), evaluate(pair.b.c, t));
    if (!(gap_mm <= meet_mm_)) return false;
    const double t1 = pair.a.at(s), t2 = pair.b.at(t);
    add({{t1, t2, evaluate(f_, t1), Crossing::Kind::kCross}, {t1, t1}, {t2, t2}, gap_mm});
    return true;
  }

  /// Adds a touch of two straight pieces for which step 2 (intersect.h) found no crossing: the
  /// point where the pieces are nearest, and the parts of both that are within 2 meet_mm_ of each
  /// other.
  void touch(const Pair& pair) noexcept {
    const Closest chords = closest_of_chords(pair.a.c, pair.b.c);
    const double limit = 4.0 * meet_mm_ * meet_mm_;
    if (!(chords.distance_squared <= limit)) return;
    Nearest on_b{chords.b, 0.0, evaluate(pair.b.c, chords.b)}, on_a;
    for (int i = 0; i < 3; ++i) {
      on_a = nearest(pair.a.c, on_b.point);
      on_b = nearest(pair.b.c, on_a.point);
    }
    const double gap_mm = std::sqrt(on_b.distance_squared);
    if (!(gap_mm <= meet_mm_)) return;
    const double t1 = pair.a.at(on_a.t), t2 = pair.b.at(on_b.t);
    Found now{{t1, t2, evaluate(f_, t1), Crossing::Kind::kTouch}, {t1, t1}, {t2, t2}, gap_mm};
    const auto extend = [&](double a, double b) {
      now.first = {std::min(now.first[0], pair.a.at(a)), std::max(now.first[1], pair.a.at(a))};
      now.second = {std::min(now.second[0], pair.b.at(b)), std::max(now.second[1], pair.b.at(b))};
    };
    for (const double end : {0.0, 1.0}) {
      if (const auto hit = nearest_within(pair.b.c, evaluate(pair.a.c, end), limit)) {
        extend(end, hit->t);
      }
      if (const auto hit = nearest_within(pair.a.c, evaluate(pair.b.c, end), limit)) {
        extend(hit->t, end);
      }
    }
    add(now);
  }

  /// Returns true if two parts of a curve are less than kSamePlaceMm apart along the curve.
  static bool adjoin(const Cubic& c, const std::array<double, 2>& a,
                     const std::array<double, 2>& b) noexcept {
    const double from = std::min(a[1], b[1]), to = std::max(a[0], b[0]);
    return from >= to || control_length(sub_segment(c, from, to)) <= kSamePlaceMm;
  }

  /// Adds a result, merged with all results next to it. An end of an overlap has priority, then a
  /// crossing, then the smaller gap.
  void add(Found now) noexcept {
    for (std::size_t i = 0; i < found_count_;) {
      const Found& old = found_[i];
      if (!adjoin(f_, old.first, now.first) || !adjoin(g_, old.second, now.second)) {
        ++i;
        continue;
      }
      if (rank(old) < rank(now) || (rank(old) == rank(now) && old.gap_mm < now.gap_mm)) {
        now.crossing = old.crossing;
        now.gap_mm = old.gap_mm;
      }
      now.first = {std::min(now.first[0], old.first[0]), std::max(now.first[1], old.first[1])};
      now.second = {std::min(now.second[0], old.second[0]), std::max(now.second[1], old.second[1])};
      found_[i] = found_[--found_count_];
      i = 0;
    }
    if (found_count_ < Crossings::kMax) {
      found_[found_count_++] = now;
    } else {
      result_.complete = false;
    }
  }

  static int rank(const Found& f) noexcept {
    switch (f.crossing.kind) {
      case Crossing::Kind::kOverlap:
        return 0;
      case Crossing::Kind::kCross:
        return 1;
      case Crossing::Kind::kTouch:
        break;
    }
    return 2;
  }

  /// The parameters of a point on both curves.
  struct Match {
    double s = 0.0, t = 0.0;
  };

  /// Returns the parameter of the point f(s) on g, or nullopt if the point is not on g. If an end
  /// of g is at the same point, returns the parameter that is closest to `near`.
  [[nodiscard]] std::optional<double> on_second(double s, double near) const noexcept {
    const Point p = evaluate(f_, s);
    const double limit = 4.0 * meet_mm_ * meet_mm_;
    const auto hit = nearest_within(g_, p, limit);
    if (!hit) return std::nullopt;
    double t = hit->t;
    for (const double end : {0.0, 1.0}) {
      if (distance_squared(evaluate(g_, end), p) > limit) continue;
      if (std::fabs(end - near) < std::fabs(t - near)) t = end;
    }
    return t;
  }

  /// Returns the lowest and highest s on f at which an end of one curve lies on the other curve.
  [[nodiscard]] Range ends_that_lie_on_the_other() const noexcept {
    Range s;
    const double limit = meet_mm_ * meet_mm_;
    const auto extend = [&](double at) {
      s.low = std::min(s.low, at);
      s.high = std::max(s.high, at);
    };
    for (const double end : {0.0, 1.0}) {
      if (nearest_within(g_, evaluate(f_, end), limit)) extend(end);
      if (const auto hit = nearest_within(f_, evaluate(g_, end), limit)) extend(hit->t);
    }
    return s;
  }

  /// Returns true if the curves share a part. If so, adds the ends of that part and pushes the
  /// remaining pairs.
  bool begin_with_overlap() noexcept {
    const Range s = ends_that_lie_on_the_other();
    if (!(s.low < s.high)) return false;
    if (control_length(sub_segment(f_, s.low, s.high)) <= 1e-3) return false;
    std::array<Match, kOverlapSamples> shared{};
    for (std::size_t i = 0; i < shared.size(); ++i) {
      // Starts inside the shared part, so that each match gives the guess for the next; its ends,
      // where g may pass twice, come last.
      const double share = (static_cast<double>(i) + 0.5) / kOverlapSamples;
      const double at = s.low + share * (s.high - s.low);
      const auto t = on_second(at, i > 0 ? shared[i - 1].t : 0.5);
      if (!t) return false;
      shared[i] = {at, *t};
    }
    const auto t_low = on_second(s.low, shared.front().t),
               t_high = on_second(s.high, shared.back().t);
    if (!t_low || !t_high) return false;
    add_overlap({s.low, *t_low}, {s.high, *t_high});
    return true;
  }

  void add_overlap(Match from, Match to) noexcept {
    for (const Match& m : {from, to}) {
      const Point p = evaluate(f_, m.s);
      add({{m.s, m.t, p, Crossing::Kind::kOverlap},
           {m.s, m.s},
           {m.t, m.t},
           distance(p, evaluate(g_, m.t))});
    }
    const double low = std::min(from.t, to.t), high = std::max(from.t, to.t);
    const Piece shared = Piece::of(f_, from.s, to.s), all{g_};
    push_unless_nothing({Piece::of(f_, 0.0, from.s), all});
    push_unless_nothing({Piece::of(f_, to.s, 1.0), all});
    push_unless_nothing({shared, Piece::of(g_, 0.0, low)});
    push_unless_nothing({shared, Piece::of(g_, high, 1.0)});
  }

  void push_unless_nothing(const Pair& pair) noexcept {
    if (control_length(pair.a.c) > kSamePlaceMm && control_length(pair.b.c) > kSamePlaceMm) {
      push(pair);
    }
  }

  void finish() noexcept {
    for (std::size_t i = 0; i < found_count_; ++i) result_.places[i] = found_[i].crossing;
    result_.count = found_count_;
    std::sort(result_.places.begin(),
              result_.places.begin() + static_cast<std::ptrdiff_t>(found_count_),
              [](const Crossing& a, const Crossing& b) {
                return a.t1 != b.t1 ? a.t1 < b.t1 : a.t2 < b.t2;
              });
  }

  const Cubic& f_;
  const Cubic& g_;
  int max_pairs_;
  double meet_mm_;
  Crossings result_;
  std::array<Pair, kStack> stack_;  // written before it is read
  std::size_t count_ = 0;
  std::array<Found, Crossings::kMax> found_{};
  std::size_t found_count_ = 0;
};

}  // namespace

Crossings intersections(const Cubic& first, const Cubic& second, int max_pairs) noexcept {
  if (!is_finite(first) || !is_finite(second)) return {};
  return Search(first, second, max_pairs).run();
}

std::optional<Crossing> self_intersection(const Cubic& c) noexcept {
  if (!is_finite(c)) return std::nullopt;
  const Vec k1 = 3.0 * (c.p[1] - c.p[0]), k2 = 3.0 * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0]));
  const Vec k3 = (c.p[3] - c.p[0]) - 3.0 * (c.p[2] - c.p[1]);
  const double det = cross(k2, k3);
  if (det == 0.0) return std::nullopt;
  const double sum = -cross(k1, k3) / det;
  const double spread = 4.0 * (cross(k1, k2) / det) - 3.0 * sum * sum;  // (t2 - t1)^2
  constexpr double kSlack = 1e-9;
  if (!(spread > 1e-12)) return std::nullopt;
  double s = 0.5 * (sum - std::sqrt(spread)), t = 0.5 * (sum + std::sqrt(spread));
  if (!(s >= -kSlack && t <= 1.0 + kSlack)) return std::nullopt;
  for (int i = 0; i < 4; ++i) {
    s = std::clamp(s, 0.0, 1.0), t = std::clamp(t, 0.0, 1.0);
    const Vec gap = evaluate(c, t) - evaluate(c, s);
    const Vec ds = derivative(c, s), dt = derivative(c, t);
    const double turn = cross(ds, dt);
    if (turn == 0.0) break;
    s += cross(gap, dt) / turn;
    t += cross(gap, ds) / turn;
  }
  s = std::clamp(s, 0.0, 1.0), t = std::clamp(t, 0.0, 1.0);
  const Point p = evaluate(c, s);
  if (!(s < t && distance(p, evaluate(c, t)) <= kMeetMm + 1e-13 * largest_coordinate(c))) {
    return std::nullopt;
  }
  return Crossing{s, t, p, Crossing::Kind::kCross};
}

}  // namespace felt
