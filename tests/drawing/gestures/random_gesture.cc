#include "tests/drawing/gestures/random_gesture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "felt/geometry/rect.h"
#include "felt/tools/tool.h"
#include "tests/drawing/gestures/random_guide.h"

namespace felt::gestures {
namespace {

constexpr int kMaxSamples = 160;
constexpr double kTurn = 2.0 * std::numbers::pi;

using Way = std::vector<Point>;

/// The drawing that a gesture aims at: its strokes, and random points on them or nearby.
class Target {
 public:
  Target(Dice& dice, const Document& document) : dice_(dice) {
    for (const Layer& layer : document.layers()) {
      for (const StrokeId id : layer.strokes) {
        strokes_.push_back(document.find(id));
        bounds_.extend(strokes_.back()->bounds());
      }
    }
    if (bounds_.empty()) bounds_ = {0.0, 0.0, 100.0, 100.0};
    for (const auto& [id, guide] : document.guides()) guides_.push_back(guide);
  }

  [[nodiscard]] const Rect& bounds() const { return bounds_; }
  [[nodiscard]] double size_mm() const { return std::max(bounds_.width(), bounds_.height()); }
  /// Returns a random stroke, or null if the drawing has no strokes.
  StrokePtr any_stroke() { return strokes_.empty() ? nullptr : dice_.any(strokes_); }
  /// Returns a random guide, or null if the drawing has no guides.
  DrawingGuidePtr any_guide() { return guides_.empty() ? nullptr : dice_.any(guides_); }
  Point anywhere() {
    return {dice_.between(bounds_.x0 - 10.0, bounds_.x1 + 10.0),
            dice_.between(bounds_.y0 - 10.0, bounds_.y1 + 10.0)};
  }
  /// Returns a parameter of a stroke, often one that tools treat specially: an end, a joint, the
  /// middle of a segment; or any.
  double telling_u(const Stroke& stroke) {
    const int n = stroke.segment_count();
    switch (dice_.pick(4)) {
      case 0:
        return dice_.chance(0.5) ? 0.0 : n;
      case 1:
        return dice_.pick(0, n);
      case 2:
        return dice_.pick(0, n - 1) + 0.5;
      default:
        return dice_.between(0.0, n);
    }
  }
  /// Returns a point, usually on a stroke or near one.
  Point somewhere() {
    const StrokePtr stroke = any_stroke();
    if (!stroke || dice_.chance(0.1)) return anywhere();
    const Point at = stroke->position(telling_u(*stroke));
    return dice_.chance(0.4) ? at : at + dice_.over_decades(1e-3, 12.0) * dice_.direction();
  }

 private:
  Dice& dice_;
  std::vector<StrokePtr> strokes_;
  std::vector<DrawingGuidePtr> guides_;
  Rect bounds_;
};

Way line(Point a, Point b, int n) {
  Way way;
  for (int i = 0; i <= n; ++i) way.push_back(lerp(a, b, static_cast<double>(i) / n));
  return way;
}

Way ellipse(Point center, double rx, double ry, double from, double turns, int n) {
  Way way;
  for (int i = 0; i <= n; ++i) {
    const double a = kTurn * (from + turns * i / n);
    way.push_back(center + Vec{rx * std::cos(a), ry * std::sin(a)});
  }
  return way;
}

int any_count(Dice& dice) {
  return std::max(1, static_cast<int>(dice.over_decades(1.0, kMaxSamples)));
}

Way tap(Dice& dice, Target& target) {
  return Way(static_cast<std::size_t>(dice.pick(1, 6)), target.somewhere());
}

Way rest(Dice& dice, Target& target) {
  const Point at = target.somewhere();
  Way way;
  for (int k = any_count(dice); k >= 0; --k) way.push_back(at + 0.03 * dice.direction());
  return way;
}

Way straight(Dice& dice, Target& target) {
  const Point a = target.somewhere();
  const Point b =
      dice.chance(0.5) ? a + dice.over_decades(0.01, 80.0) * dice.direction() : target.somewhere();
  return line(a, b, any_count(dice));
}

Way out_and_back(Dice& dice, Target& target) {
  Way way = straight(dice, target);
  way.insert(way.end(), way.rbegin(), way.rend());
  return way;
}

Way circle(Dice& dice, Target& target) {
  const double r = dice.over_decades(0.2, 40.0), from = dice.between(0.0, 1.0);
  const Point start = target.somewhere();
  const Point center = start - r * Vec{std::cos(kTurn * from), std::sin(kTurn * from)};
  return ellipse(center, r, r, from, dice.between(-3.0, 3.0), any_count(dice));
}

Way scribble(Dice& dice, Target& target) {
  const Point middle = target.somewhere();
  const double size = dice.over_decades(0.3, 30.0), a = dice.between(1.0, 9.0),
               b = dice.between(1.0, 9.0);
  Way way;
  const int n = any_count(dice);
  for (int i = 0; i <= n; ++i) {
    const double t = 0.06 * i;
    way.push_back(middle + size * Vec{std::sin(a * t), std::cos(b * t + 1.0)});
  }
  return way;
}

Way jumps(Dice& dice, Target& target) {
  Way way;
  for (int k = dice.pick(2, 8); k > 0; --k) {
    const Way stop(static_cast<std::size_t>(dice.pick(1, 6)), target.somewhere());
    way.insert(way.end(), stop.begin(), stop.end());
  }
  return way;
}

Way along(Dice& dice, Target& target) {
  const StrokePtr stroke = target.any_stroke();
  if (!stroke) return straight(dice, target);
  const double a = target.telling_u(*stroke), b = target.telling_u(*stroke);
  const Vec beside = dice.chance(0.5) ? Vec{} : dice.over_decades(0.01, 3.0) * dice.direction();
  Way way;
  const int n = any_count(dice);
  for (int i = 0; i <= n; ++i) way.push_back(stroke->position(a + (b - a) * i / n) + beside);
  return way;
}

/// Returns a path from an end of a stroke to an end of another one, or to its own other end.
Way end_to_end(Dice& dice, Target& target) {
  const StrokePtr from = target.any_stroke(), to = target.any_stroke();
  if (!from || !to) return straight(dice, target);
  const auto tip = [&dice](const Stroke& s) {
    return s.position(dice.chance(0.5) ? 0.0 : s.segment_count());
  };
  return line(tip(*from), tip(*to) + dice.between(0.0, 2.0) * dice.direction(), any_count(dice));
}

Way round_one_or_all(Dice& dice, Target& target) {
  Rect box = target.bounds();
  if (const StrokePtr stroke = target.any_stroke(); stroke && dice.chance(0.7)) {
    box = stroke->bounds();
  }
  const double grow = dice.between(0.3, 1.6);
  const Point center{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  return ellipse(center, grow * box.width() + 0.5, grow * box.height() + 0.5,
                 dice.between(0.0, 1.0), dice.chance(0.5) ? 1.0 : -0.9, any_count(dice));
}

/// Returns a path to and fro over a stroke: a scratch-out, more or less.
Way to_and_fro(Dice& dice, Target& target) {
  Rect box = target.bounds();
  if (const StrokePtr stroke = target.any_stroke()) box = stroke->bounds();
  const double margin = dice.between(-0.5, 2.0);
  const int passes = dice.pick(4, 12);
  Way way;
  for (int i = 0; i <= passes; ++i) {
    const double y = box.y0 + (box.height() + 1.0) * i / passes;
    const double x = i % 2 == 0 ? box.x0 - margin : box.x1 + margin;
    if (!way.empty()) {
      const Point from = way.back();
      for (int k = 1; k < 12; ++k) way.push_back(lerp(from, {x, y}, k / 12.0));
    }
    way.push_back({x, y});
  }
  return way;
}

Way twice_around(Dice& dice, Target& target) {
  Rect box = target.bounds();
  if (const StrokePtr stroke = target.any_stroke()) box = stroke->bounds();
  const Point center{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  return ellipse(center, box.width() + 3.0, box.height() + 3.0, dice.between(0.0, 1.0),
                 dice.between(1.7, 2.3), kMaxSamples);
}

/// Returns a line, a circle or a triangle after which the pen rests, and then sometimes goes on.
Way held_shape(Dice& dice, Target& target) {
  const Point at = target.somewhere();
  const double size = dice.over_decades(2.0, 60.0);
  Way way;
  switch (dice.pick(3)) {
    case 0:
      way = line(at, at + size * dice.direction(), 40);
      break;
    case 1:
      way = ellipse(at, size, dice.between(0.3, 1.0) * size, 0.0, dice.between(0.5, 1.1), 60);
      break;
    default:
      for (const Vec corner : {Vec{1.0, 0.0}, Vec{0.2, 1.0}, Vec{0.0, 0.0}}) {
        const Way side = line(way.empty() ? at : way.back(), at + size * corner, 20);
        way.insert(way.end(), side.begin(), side.end());
      }
  }
  const Point end = way.back();
  for (int k = dice.pick(20, 400); k > 0; --k) way.push_back(end + 0.05 * dice.direction());
  if (dice.chance(0.3)) {
    const Way on = line(end, end + dice.between(1.0, 30.0) * dice.direction(), 20);
    way.insert(way.end(), on.begin(), on.end());
  }
  return way;
}

Way along_a_guide(Dice& dice, Target& target) {
  const DrawingGuidePtr guide = target.any_guide();
  return guide ? path_along(dice, *guide, dice.pick(20, kMaxSamples)) : straight(dice, target);
}

Way too_fast(Dice& dice, Target& target) {
  const Point a = target.somewhere();
  return line(a, a + (20.0 + target.size_mm()) * dice.direction(), dice.pick(1, 4));
}

Way far_off(Dice& dice, Target& target) {
  const Point a = target.somewhere();
  return line(a, a + dice.over_decades(1e3, 1e9) * dice.direction(), dice.pick(1, 20));
}

struct Kind {
  std::string_view name;
  Way (*make)(Dice&, Target&);
};
constexpr std::array kKinds{
    Kind{"tap", tap},
    Kind{"rest", rest},
    Kind{"straight", straight},
    Kind{"straight", straight},
    Kind{"back", out_and_back},
    Kind{"circle", circle},
    Kind{"circle", circle},
    Kind{"scribble", scribble},
    Kind{"scribble", scribble},
    Kind{"jumps", jumps},
    Kind{"along", along},
    Kind{"along", along},
    Kind{"along", along},
    Kind{"ends", end_to_end},
    Kind{"ends", end_to_end},
    Kind{"round", round_one_or_all},
    Kind{"round", round_one_or_all},
    Kind{"to and fro", to_and_fro},
    Kind{"twice around", twice_around},
    Kind{"held shape", held_shape},
    Kind{"along a guide", along_a_guide},
    Kind{"along a guide", along_a_guide},
    Kind{"along a guide", along_a_guide},
    Kind{"fast", too_fast},
    Kind{"far", far_off},
};
constexpr std::array kMeantKinds{
    Kind{"to and fro", to_and_fro},
    Kind{"twice around", twice_around},
    Kind{"held shape", held_shape},
    Kind{"along a guide", along_a_guide},
};

/// Converts a path into pen samples.
class Reporter {
 public:
  Reporter(Dice& dice, std::int64_t now_ns) : dice_(dice), now_ns_(now_ns) {
    constexpr std::array<std::int64_t, 6> kPeriods{1'000'000, 1'000'000, 1'000'000,
                                                   200'000,   4'000'000, 7'500'000};
    period_ns_ = dice.any(kPeriods);
    depth_mm_ = dice.over_decades(0.01, 5.0);
    swing_ = dice.chance(0.3) ? dice.between(0.0, 1.0) : 0.0;
    if (dice.chance(0.3)) pressure_ = dice.between(0.0, 1.0);
    is_rough_ = dice.chance(0.15);
    if (dice.chance(0.4)) buttons_ = static_cast<std::uint32_t>(dice.pick(1, 3));
    changes_buttons_ = dice.chance(0.1);
  }

  /// Makes the pen that of a tablet which reports every 8 ms, with a steady pressure.
  void make_plain() {
    period_ns_ = 8'000'000;
    depth_mm_ = 0.1;
    swing_ = 0.0;
    pressure_ = 0.5;
    buttons_ = 0;
    is_rough_ = changes_buttons_ = false;
  }

  void air(Point at, double z) { report({at.x, at.y, z}, std::nullopt); }
  void page(Point at) {
    if (is_rough_) disturb(at);
    const double part = 1.0 - swing_ * 0.5 * (1.0 + std::sin(0.1 * ++count_));
    // The pen of a tablet stays on the surface and reports its pressure.
    const bool by_pressure = pressure_ && dice_.chance(0.5);
    std::optional<double> pressure = pressure_;
    if (pressure) *pressure *= part;
    report({at.x, at.y, by_pressure && *pressure > 0.0 ? 0.0 : -depth_mm_ * part}, pressure);
  }
  std::vector<PenSample> take() { return std::move(samples_); }

 private:
  void report(const Vec3& at, std::optional<double> pressure) {
    const bool stands_still = is_rough_ && dice_.chance(0.05);
    if (!stands_still) now_ns_ += period_ns_;
    PenSample sample;
    sample.time_ns = now_ns_;
    sample.position = at;
    sample.pressure = pressure;
    if (changes_buttons_ && dice_.chance(0.1)) {
      buttons_ = static_cast<std::uint32_t>(dice_.pick(0, 7));
    }
    sample.buttons = buttons_;
    samples_.push_back(sample);
  }
  void disturb(Point at) {
    if (dice_.chance(0.05)) {
      for (int k = dice_.pick(1, 8); k > 0; --k) air(at, dice_.between(0.0, 0.45));  // a bounce
    }
    if (dice_.chance(0.05)) report({at.x, std::numeric_limits<double>::quiet_NaN(), -1.0}, {});
    if (dice_.chance(0.02)) now_ns_ += 300'000'000;
    if (dice_.chance(0.02)) report({at.x, at.y, -1.0}, std::numeric_limits<double>::quiet_NaN());
  }

  Dice& dice_;
  std::vector<PenSample> samples_;
  std::int64_t now_ns_;
  std::int64_t period_ns_;
  double depth_mm_, swing_;
  std::optional<double> pressure_;
  std::uint32_t buttons_ = 0;
  bool is_rough_ = false, changes_buttons_ = false;
  int count_ = 0;
};

}  // namespace

PenGesture random_gesture(Dice& dice, const Document& document, std::int64_t start_ns) {
  Target target(dice, document);
  const Kind& kind = dice.any(kKinds);
  Way way = kind.make(dice, target);
  // The script format has this limit; the session drops samples beyond it.
  for (Point& p : way) p = {std::clamp(p.x, -1e9, 1e9), std::clamp(p.y, -1e9, 1e9)};
  Reporter reporter(dice, start_ns);
  const Point begin = way.front();
  for (int k = dice.pick(0, 12); k > 0; --k) {
    reporter.air(begin + 0.3 * static_cast<double>(k) * dice.direction(), 0.6 * k);
  }
  for (const Point& p : way) reporter.page(p);
  if (dice.chance(0.95)) {
    for (int k = dice.pick(1, 8); k > 0; --k)
      reporter.air(way.back(), dice.chance(0.9) ? 6.0 : 0.2);
  }
  return {kind.name, reporter.take()};
}

PenGesture meant_gesture(Dice& dice, const Document& document, std::int64_t start_ns) {
  Target target(dice, document);
  const Kind& kind = dice.any(kMeantKinds);
  Reporter reporter(dice, start_ns);
  reporter.make_plain();
  const Way way = kind.make(dice, target);
  for (const Point& p : way) reporter.page(p);
  for (int k = 0; k < 8; ++k) reporter.air(way.back(), 6.0);
  return {kind.name, reporter.take()};
}

}  // namespace felt::gestures
