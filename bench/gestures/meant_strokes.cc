#include "meant_strokes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/haptics/bricks/friction.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/force_memory.h"
#include "felt/recognise/round_fit.h"
#include "felt/recognise/scratch_out.h"
#include "felt/recognise/shape_guess.h"
#include "felt/session/session.h"
#include "felt/tools/pencil/shape_hold.h"

namespace felt::bench {
namespace {

constexpr double kTickS = 0.001;
constexpr double kRestS = 1.0;  // how long a person rests who wants a shape
constexpr Point kMiddle{90.0, 90.0};
/// Relative sizes: small, usual, large.
constexpr double kSizes[] = {0.5, 1.0, 2.0};
/// The pace of gestures, relative to the pace of writing of the same person: crossing out and
/// circling are quick, shapes are careful (chosen).
constexpr double kQuick = 2.0, kCareful = 1.0;

using Path = std::vector<Point>;

Path ellipse(double a, double b, double from, double sweep, double angle) {
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  const int count = std::max(8, static_cast<int>(24.0 * std::abs(sweep) / kTau));
  Path path;
  for (int i = 0; i <= count; ++i) {
    const double t = from + sweep * i / count;
    path.push_back(kMiddle + a * std::cos(t) * u + b * std::sin(t) * v);
  }
  return path;
}

/// Returns a path through corners. Each is given twice, which makes it sharp (smooth_path).
Path corners(const Path& points) {
  Path path;
  for (std::size_t i = 0; i < points.size(); ++i) {
    path.push_back(points[i]);
    if (i > 0 && i + 1 < points.size()) path.push_back(points[i]);
  }
  return path;
}

Path scratch(Random& random, double size) {
  const double length = 25.0 * size, angle = random.between(-0.6, 0.6);
  const int passes = 6 + static_cast<int>(random.between(0.0, 5.0));
  const double advance = random.between(0.05, 0.2) * length;
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  Path points;
  for (int i = 0; i <= passes; ++i) {
    const double side = (i % 2 == 0 ? -0.5 : 0.5) * random.between(0.85, 1.15);
    points.push_back(kMiddle + side * length * u + (0.5 * advance * (i - 0.5 * passes)) * v);
  }
  return random.between(0.0, 1.0) < 0.5 ? corners(points) : points;
}

Path polygon(Random& random, double size, int count) {
  const double turn = random.between(0.0, kTau);
  Path points;
  for (int i = 0; i <= count; ++i) {
    const double a = turn + kTau * i / count;
    const double r = i < count ? 18.0 * size * random.between(0.9, 1.1) : 0.0;
    points.push_back(kMiddle + r * Vec{std::cos(a), std::sin(a)});
  }
  points.back() = points.front() + size * Vec{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  return corners(points);
}

Path rectangle(Random& random, double size) {
  const double w = size * random.between(14.0, 28.0), h = size * random.between(10.0, 20.0);
  const double angle = random.between(0.0, 1.0) < 0.5 ? 0.0 : random.between(0.0, kTau);
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  const Point a = kMiddle - w * u - h * v;
  return corners({a, a + 2.0 * w * u, a + 2.0 * w * u + 2.0 * h * v, a + 2.0 * h * v,
                  a + size * random.between(0.2, 1.0) * v});
}

Path meant_path(Random& random, OfferKind kind, double size) {
  const double from = random.between(0.0, kTau), angle = random.between(0.0, kTau);
  const double sign = random.between(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  const double once = sign * kTau * random.between(0.97, 1.04), r = 15.0 * size;
  switch (kind) {
    case OfferKind::kDelete:
      return scratch(random, size);
    case OfferKind::kSelect:
      return ellipse(r, random.between(0.7, 1.0) * r, from, sign * kTau * random.between(1.92, 2.1),
                     angle);
    case OfferKind::kLine:
      return {kMiddle - r * Vec{std::cos(angle), std::sin(angle)},
              kMiddle + r * Vec{std::cos(angle), std::sin(angle)}};
    case OfferKind::kArc:
      return ellipse(r, r, from, sign * random.between(1.2, 4.5), 0.0);
    case OfferKind::kCircle:
      return ellipse(r, r, from, once, 0.0);
    case OfferKind::kEllipse:
      return ellipse(r, random.between(0.4, 0.7) * r, from, once, angle);
    case OfferKind::kTriangle:
      return polygon(random, size, 3);
    case OfferKind::kRectangle:
      return rectangle(random, size);
    case OfferKind::kPolygon:
    case OfferKind::kInk:
      break;
  }
  return polygon(random, size, random.between(0.0, 1.0) < 0.5 ? 5 : 6);
}

/// A person with a Phantom Premium on paper, whose pen draws into a session.
class PersonFixture {
 public:
  explicit PersonFixture(const Person& person)
      : device_(*find_stylus_preset("premium")),
        person_(person),
        hand_(std::make_unique<FeedbackHand>(device_, person)) {
    memory_.dt_s = memory_.period_s = kTickS;
    options_ = script_options_for(device_, person.grip());
    options_.device_mass_kg = options_.device_friction_n = options_.friction = 0.0;  // FeedbackHand
    options_.plane_n_per_m = PlaneOptions{}.stiffness_n_per_m;
    for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
      apply(SetOption{id, true});
    }
  }

  /// Draws two lines in the middle that a gesture can delete or select.
  void add_lines(double size) {
    for (const double y : {-2.0, 2.0}) {
      now_ns_ += 20'000'000;
      apply(PenEvent{{kMiddle.x, kMiddle.y, 6.0}, {}, 0});
      for (int i = 0; i <= 40; ++i) {
        now_ns_ += 4'000'000;
        const double x = size * (0.45 * i - 9.0);
        apply(PenEvent{{kMiddle.x + x, kMiddle.y + size * y + std::sin(0.4 * i), -0.1}, 0.4, 0});
      }
      lift(kMiddle);
    }
  }
  void draw(const Path& via, double pace, std::uint64_t trial, double rest_s) {
    Person drawer = person_;
    drawer.pace *= pace;
    drawer.seed += 7919 * (trial + 1);
    RecordedPath plan = plan_movement(drawer, via, trial);
    if (plan.empty()) return;
    RecordedPoint last = plan.back();
    for (int i = 0; i < static_cast<int>(rest_s / kTickS); ++i) {
      last.time_ns = last.time_ns.value_or(0) + 1'000'000;
      plan.push_back(last);
    }
    hand_ = std::make_unique<FeedbackHand>(device_, drawer);
    memory_ = {};
    memory_.dt_s = memory_.period_s = kTickS;
    const std::vector<TimedAim> aims = script_hand(std::span(&plan, 1), options_);
    const auto extra = static_cast<std::size_t>((drawer.preview_s + 0.1) / kTickS);
    const std::int64_t start_ns = now_ns_;
    Point at;
    for (std::size_t i = 0; i < aims.size() + extra; ++i) {
      const TimedAim& aim = aims[std::min(i, aims.size() - 1)];
      hand_->aim(aim.target_mm, aim.pressure, 0);
      const std::int64_t tick_ns = static_cast<std::int64_t>(i) * 1'000'000;
      const PenSample sample = hand_->read(tick_ns).value();
      memory_.begin_tick(kTickS);
      static_cast<void>(hand_->write(Plane()(sample, memory_) + friction_(sample, memory_)));
      // A tablet reports every 8 ms. The pressure of the plan varies a little, as that of people.
      if (i % 8 != 0) continue;
      now_ns_ = start_ns + tick_ns + 1'000'000;
      at = on_page(sample.position);
      const bool is_down = in_contact(sample);
      if (is_down) drawn_.push_back(at);
      const double pressure = 0.45 + 0.05 * std::sin(0.07 * static_cast<double>(i));
      apply(PenEvent{
          {at.x, at.y, is_down ? -0.1 : 6.0}, is_down ? std::optional(pressure) : std::nullopt, 0});
    }
    lift(at);
  }
  [[nodiscard]] std::optional<OfferView> offered() const { return session_.offered(); }
  [[nodiscard]] bool is_offered(OfferKind kind) const {
    const std::optional<OfferView> offer = offered();
    return offer && std::any_of(offer->rows.begin(), offer->rows.end(),
                                [kind](const OfferRow& r) { return r.kind == kind; });
  }
  /// Returns the samples in contact of draw().
  [[nodiscard]] const Path& drawn() const noexcept { return drawn_; }

 private:
  void lift(Point at) {
    for (int i = 0; i < 8; ++i) {
      now_ns_ += 8'000'000;
      apply(PenEvent{{at.x, at.y, 6.0}, {}, 0});
    }
  }
  void apply(decltype(Event::what) what) {
    if (!session_.apply({now_ns_, std::move(what)})) std::abort();
  }

  const StylusPreset& device_;
  Person person_;
  std::unique_ptr<FeedbackHand> hand_;
  HandScriptOptions options_;
  Friction friction_{{.coefficient = 0.2}};
  ForceMemory memory_;
  Session session_{make_tools(), {}};
  std::int64_t now_ns_ = 0;
  Path drawn_;
};

void print_missed(OfferKind kind, std::size_t person, double size, const Path& path,
                  const std::optional<OfferView>& offer) {
  fmt::print("missed: {} of person {}, size {}", kOfferKinds[static_cast<std::size_t>(kind)],
             person, size);
  if (kind < OfferKind::kLine) {
    const ScratchFeatures f = ScratchOut::features(path);
    const bool has_shape = ScratchOut::find(path).has_value();
    fmt::print(
        ": {} passes, along {:.2f}, evenness {:.2f}, straightness {:.2f}, overlap {:.2f}, path "
        "{:.1f} diagonals{}\n",
        f.passes, f.along, f.evenness, f.straightness, f.overlap, f.path_per_diagonal,
        has_shape ? "; it crosses out" : "");
    return;
  }
  fmt::print(": offered");
  if (!offer) fmt::print(" nothing");
  for (std::size_t i = 0; offer && i < offer->rows.size(); ++i) {
    fmt::print(" {}", kOfferKinds[static_cast<std::size_t>(offer->rows[i].kind)]);
  }
  fmt::print("; near to");
  for (const ShapeGuess& guess : guess_shapes(path)) {
    fmt::print(" {} {:.2f}", kOfferKinds[static_cast<std::size_t>(offer_of(guess.form))],
               guess.misfit);
  }
  if (!path.empty()) {
    const LineFit line = fit_line(path);
    fmt::print("; from a line {:.3f} of its length, {:.1f} mm\n",
               line.rms_mm / distance(line.from, line.to), distance(line.from, line.to));
  }
}

}  // namespace

std::vector<MeantStrokes> draw_meant(std::size_t people, std::uint64_t seed, bool each) {
  std::vector<MeantStrokes> all;
  const std::vector<Person> persons = population(people, seed);
  for (std::size_t k = 1; k < kOfferKinds.size(); ++k) {
    MeantStrokes meant{static_cast<OfferKind>(k), 0, 0, 0};
    const bool is_shape = meant.kind >= OfferKind::kLine;
    for (std::size_t p = 0; p < persons.size(); ++p) {
      for (const double size : kSizes) {
        Random random(seed + 1000 * p + 10 * k + static_cast<std::uint64_t>(4.0 * size));
        PersonFixture fixture(persons[p]);
        if (!is_shape) fixture.add_lines(size);
        fixture.draw(meant_path(random, meant.kind, size), is_shape ? kCareful : kQuick, k,
                     is_shape ? kRestS : 0.0);
        ++meant.drawn;
        const bool is_found = fixture.is_offered(meant.kind);
        meant.offered += is_found;
        meant.first += is_found && fixture.offered()->rows.front().kind == meant.kind;
        if (each && !is_found) {
          print_missed(meant.kind, p, size, fixture.drawn(), fixture.offered());
        }
      }
    }
    all.push_back(meant);
  }
  return all;
}

}  // namespace felt::bench
