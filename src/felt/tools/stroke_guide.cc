#include "felt/tools/stroke_guide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/constants.h"

namespace felt {
namespace {

using Kind = DrawingGuideKind;

constexpr double kRaySpanMm = 9.5;  // half of the piece of a ray
constexpr double kRimFadeMm = 5.0;  // beyond the ends of the rays, as for a path
constexpr double kGateRiseS = 0.1, kGateFallS = 0.03;
constexpr double kMaxGateStepS = 0.02;
constexpr double kMaxBackMm = 1.0;   // a stroke that goes back further is not exact
constexpr double kMinExactMm = 2.0;  // shortest stroke that is offered as exact
constexpr double kClickN = 0.2;
constexpr double kChoiceMm = 30.0;      // how far the lines of a perspective are shown
constexpr double kShownSpringMm = 0.3;  // shortest spring that is drawn

GuidePiece node_piece(Point at, std::uint32_t hold, double gain) {
  GuidePiece piece;
  piece.points[0] = at;
  piece.count = 1;
  piece.gain = gain;
  piece.hold = hold;
  return piece;
}

GuidePiece ray_piece(const GuideRay& ray, double along_mm, std::uint32_t hold) {
  GuidePiece piece;
  piece.count = GuidePiece::kPoints;
  piece.hold = hold;
  piece.at_mm = 0.5 * piece.spacing_mm * static_cast<double>(piece.count - 1);
  for (std::size_t i = 0; i < piece.count; ++i) {
    const double mm = along_mm + piece.spacing_mm * static_cast<double>(i) - piece.at_mm;
    piece.points[i] = point_at(ray.line, mm);
  }
  const double x = std::clamp((along_mm - ray.line.to_mm) / kRimFadeMm, 0.0, 1.0);
  piece.gain = 1.0 - x * x * (3.0 - 2.0 * x);
  return piece;
}

/// Returns how far apart two positions of a shape are, about, mm.
double between_mm(const GuideShape& shape, double from, double to) noexcept {
  const auto* ellipse = std::get_if<GuideEllipse>(&shape);
  return ellipse ? (to - from) * std::max(ellipse->a_mm, ellipse->b_mm) : to - from;
}

}  // namespace

void StrokeGuide::update(const PenSample& sample, bool is_down,
                         std::span<const DrawingGuidePtr> guides, const Document& document,
                         const GuideSpring& spring) {
  pen_ = on_page(sample.position);
  spring_ = spring;
  const bool begins = is_down && !is_down_;
  is_down_ = is_down;
  if (!is_down) {
    let_go();
    return;
  }
  if (begins) begin(guides, document);
  if (phase_ == Phase::kNone || !in_contact(sample)) return;
  if (phase_ == Phase::kChooses) choose_line();
  if (phase_ == Phase::kPath) track_->update(sample);
  if (phase_ == Phase::kRays) follow_rays();
  if (phase_ == Phase::kNodes) follow_nodes(sample);
  if (shape_) follow_shape();
  follow_distance();
  last_ns_ = sample.time_ns;
}

void StrokeGuide::stop() noexcept {
  let_go();
  shape_.reset();
  keeps_ = false;
}

void StrokeGuide::let_go() noexcept {
  end_track();
  guide_.reset();
}

/// Ends the track. Its holds are not used again: the haptic loop would take the next guide for the
/// same one, and its force would begin at its full value.
void StrokeGuide::end_track() noexcept {
  phase_ = Phase::kNone;
  if (track_) hold_ = std::max(hold_, track_->hold());
  track_.reset();
}

void StrokeGuide::begin(std::span<const DrawingGuidePtr> guides, const Document& document) {
  touch_ = pen_;
  shape_.reset();
  keeps_ = false;
  ray_.reset();
  node_.reset();
  is_slow_ = true;
  gate_ = 1.0;
  piece_ = {};
  is_near_ = false;
  const std::optional<std::size_t> chosen = choose_guide(guides, document, touch_, bounds_);
  if (!chosen) return;
  guide_ = guides[*chosen];
  number_ = ++hold_;
  switch (guide_->kind) {
    case Kind::kTrace:
    case Kind::kTeacher:
      hold_to_path(document);
      break;
    case Kind::kPerspective:
      choices_ = perspective_lines(*guide_, touch_);
      phase_ = Phase::kChooses;
      break;
    case Kind::kProtractor:
      phase_ = Phase::kRays;
      break;
    case Kind::kGrid:
    case Kind::kIsometricGrid:
      phase_ = Phase::kNodes;
      break;
    default:
      if (const std::optional<GuideShape> shape = guide_shape(*guide_, touch_)) hold_to(*shape);
  }
}

void StrokeGuide::hold_to(const GuideShape& shape) {
  shape_ = shape;
  keeps_ = true;
  first_at_ = last_at_ = furthest_ = nearest_on(shape, pen_).at;
  GuideLaw law = GuideLaw::line(guide_->strength, spring_);
  law.is_edge = guide_->kind == Kind::kRuler;
  if (guide_->kind == Kind::kPerspective) law.click_n = kClickN * guide_->strength;
  start_track({.kind = GuideKind::kGroove,
               .points = guide_points(shape, pen_),
               .is_closed = std::holds_alternative<GuideEllipse>(shape),
               .strength = guide_->strength},
              law);
  if (track_) track_->set_free_side(nearest_on(shape, touch_).distance_mm >= 0.0 ? 1.0 : -1.0);
}

void StrokeGuide::hold_to_path(const Document& document) {
  const bool leads = guide_->kind == Kind::kTeacher;
  GuideLaw law = GuideLaw::line(guide_->strength, spring_);
  if (leads) {
    const GuideLaw teacher = GuideLaw::teacher(guide_->strength);
    law.lead_n = teacher.lead_n;
    law.lead_n_s_per_m = teacher.lead_n_s_per_m;
  }
  std::vector<Point> path = guide_path(*guide_, document);
  const StrokePtr traced = leads ? nullptr : document.find(guide_->stroke);
  const bool is_closed = traced && is_closed_path(*traced, path);
  start_track({.kind = leads ? GuideKind::kTeacher : GuideKind::kGroove,
               .points = std::move(path),
               .is_closed = is_closed,
               .strength = guide_->strength,
               .times_ms = leads ? guide_->times_ms : std::vector<double>()},
              law);
}

void StrokeGuide::start_track(GuideLine line, const GuideLaw& law) {
  end_track();
  if (!check_guide(line)) return;
  track_.emplace(std::move(line), ++hold_, law);
  phase_ = Phase::kPath;
}

/// Chooses the line of a perspective when the pen has moved far enough from the touch.
void StrokeGuide::choose_line() {
  if (distance(pen_, touch_) < kChooseMm) return;
  phase_ = Phase::kNone;
  const std::optional<GuideStraight> line = line_along(choices_, pen_ - touch_);
  if (!line) return;
  ++ticks_;
  hold_to(*line);
  first_at_ = furthest_ = 0.0;  // the stroke began at the touch
}

void StrokeGuide::follow_rays() {
  const GuideRay ray = nearest_ray(*guide_, pen_);
  const double along_mm = dot(pen_ - ray.line.at, ray.line.along);
  if (ray_ && *ray_ != ray.number) {
    ++ticks_;
    keeps_ = false;
  } else if (!ray_) {
    shape_ = GuideStraight{ray.line.at, ray.line.along};
    keeps_ = true;
    first_at_ = last_at_ = furthest_ = along_mm;
  }
  ray_ = ray.number;
  GuideLaw law = GuideLaw::tick(guide_->strength, ray.radius_mm);
  law.window_mm = kRaySpanMm;
  piece_ = Guide(law, ray_piece(ray, along_mm, hold_));
}

void StrokeGuide::follow_nodes(const PenSample& sample) {
  const GuideNode node = nearest_node(*guide_, pen_);
  const double speed = norm(in_plane(sample.velocity));
  is_slow_ = speed < (is_slow_ ? kGateMmPerS : kOpenMmPerS);
  const double dt_s =
      std::clamp(1e-9 * static_cast<double>(sample.time_ns - last_ns_), 0.0, kMaxGateStepS);
  gate_ = std::clamp(gate_ + (is_slow_ ? dt_s / kGateRiseS : -dt_s / kGateFallS), 0.0, 1.0);
  const bool is_inside = distance(node.at, pen_) < node.radius_mm;
  if (is_inside && is_slow_ && node_ != node.at) {
    if (node_) ++ticks_;
    node_ = node.at;
  }
  piece_ =
      Guide(GuideLaw::tick(guide_->strength, node.radius_mm), node_piece(node.at, hold_, gate_));
}

/// Follows the position on the shape, and whether the stroke keeps to it.
void StrokeGuide::follow_shape() {
  const ShapeNearest near = nearest_on(*shape_, pen_);
  double at = near.at;
  if (std::holds_alternative<GuideEllipse>(*shape_)) {
    at = last_at_ + std::remainder(at - last_at_, kTau);
  } else {
    // Beyond its ends, a ruler is not a ruler.
    const auto& line = std::get<GuideStraight>(*shape_);
    if (at < line.from_mm - kExactMm || at > line.to_mm + kExactMm) keeps_ = false;
  }
  last_at_ = at;
  if (std::fabs(near.distance_mm) > kExactMm) keeps_ = false;
  const double sign = furthest_ >= first_at_ ? 1.0 : -1.0;
  const double onward_mm = sign * between_mm(*shape_, furthest_, at);
  const bool has_direction = std::fabs(between_mm(*shape_, first_at_, furthest_)) > kMaxBackMm;
  if (onward_mm > 0.0 || (!has_direction && -onward_mm > kMaxBackMm)) {
    furthest_ = at;
  } else if (has_direction && -onward_mm > kMaxBackMm) {
    keeps_ = false;
  }
}

/// Follows whether the pen is near the guide, with the same hysteresis as the force.
void StrokeGuide::follow_distance() {
  if (phase_ != Phase::kPath) {
    is_near_ = true;
    return;
  }
  const WellShape& well = track_->guide().law().well;
  const double limit_mm = is_near_ ? well.radius_mm : well.radius_mm - well.rim_mm;
  is_near_ = track_->guide().distance_mm(pen_) < limit_mm;
}

std::optional<ExactPath> StrokeGuide::exact_path() const {
  if (!shape_ || !keeps_) return {};
  if (std::fabs(between_mm(*shape_, first_at_, last_at_)) < kMinExactMm) return {};
  return ExactPath{*shape_, first_at_, last_at_};
}

const Guide* StrokeGuide::force() const noexcept {
  if (phase_ == Phase::kPath) return &track_->guide();
  return phase_ == Phase::kRays || phase_ == Phase::kNodes ? &piece_ : nullptr;
}

/// Returns the point to which the force pulls the pen, if there is a force.
std::optional<Point> StrokeGuide::felt_point() const {
  const Guide* guide = force();
  if (!guide || !(guide->pull_n(pen_) > 0.0)) return {};
  if (phase_ == Phase::kNodes) return guide->piece().points[0];
  return guide->nearest(pen_);
}

void StrokeGuide::draw(Overlay& overlay) const {
  if (phase_ == Phase::kChooses) {
    for (const GuideStraight& line : choices_) {
      overlay.lines.push_back(
          {point_at(line, -kChoiceMm), point_at(line, kChoiceMm), Overlay::Role::kReach});
    }
  }
  if (phase_ == Phase::kPath && shape_) {
    const bool is_closed = std::holds_alternative<GuideEllipse>(*shape_);
    overlay.outlines.push_back({guide_points(*shape_, touch_), is_closed, Overlay::Role::kGuide});
  }
}

void StrokeGuide::draw_spring(Overlay& overlay) const {
  const std::optional<Point> to = felt_point();
  if (!to || distance(pen_, *to) < kShownSpringMm) return;
  constexpr int kTurns = 6;
  const Vec whole = *to - pen_;
  const Vec side = 0.5 * perp(normalized(whole));
  Overlay::Outline spring{.points = {pen_}, .role = Overlay::Role::kTether};
  for (int i = 0; i < kTurns; ++i) {
    spring.points.push_back(pen_ + (i + 0.5) / kTurns * whole + (i % 2 == 0 ? 1.0 : -1.0) * side);
  }
  spring.points.push_back(*to);
  overlay.outlines.push_back(std::move(spring));
}

}  // namespace felt
