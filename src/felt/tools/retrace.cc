#include "felt/tools/retrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "felt/base/constants.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/nearest.h"
#include "felt/tools/guide_choice.h"
#include "felt/tools/guided_feel.h"

namespace felt {
namespace {

constexpr double kRimMm = Retrace::kLeftMm - Retrace::kNearMm;
// A line along which the pen moves slower than this share of its own speed is not followed.
constexpr double kMinShare = 0.7;

// The nearest point of ink beside the pen is within this cosine of the direction across it.
constexpr double kBesideCosine = 0.3;

Rect around(Point pen, double mm) noexcept {
  return Rect{pen.x, pen.y, pen.x, pen.y}.inflated(mm);
}

double cos_deg(double degrees) noexcept {
  return std::cos(degrees * kTau / 360.0);
}

}  // namespace

GuideLaw Retrace::law(double force_n, const Capabilities& device) noexcept {
  const GuideSpring spring = guide_spring_for(device);
  return {.well = {.radius_mm = kLeftMm,
                   .core_mm = 1e3 * force_n / spring.n_per_m,
                   .rim_mm = kRimMm,
                   .force_n = force_n,
                   .damping_n_s_per_m = spring.damping_n_s_per_m}};
}

void Retrace::add(Positions& positions, Point position) noexcept {
  std::copy_backward(positions.begin(), positions.end() - 1, positions.end());
  positions[0] = position;
}

void Retrace::begin(const PenSample& sample) noexcept {
  pen_.fill(on_page(sample.position));
  times_.fill(sample.time_ns);
  free_steps_ = kAgainSteps;
  is_stopped_ = false;
}

void Retrace::stop() noexcept {
  let_go();
  lines_.clear();
  is_stopped_ = true;
}

/// Ends the hold. Its numbers are not used again: the haptic loop would take the next hold for the
/// same one, and its force would begin at its full value.
void Retrace::let_go() noexcept {
  if (!track_) return;
  hold_ = std::max(hold_, track_->hold());
  track_.reset();
  free_steps_ = 0;
}

void Retrace::update(const PenSample& sample, bool is_down, const Scene& scene, double force_n) {
  const bool begins = is_down && !is_down_;
  is_down_ = is_down;
  if (!is_down || !(force_n > 0.0)) return stop();
  if (begins) begin(sample);
  if (is_stopped_ || !in_contact(sample)) return;
  const Point pen = on_page(sample.position);
  if (distance(pen, pen_[0]) >= kStepMm) step(pen, sample.time_ns, scene, force_n);
  if (!track_) return;
  track_->update(sample);
  // The path of a very long stroke does not reach its end.
  if (track_->guide().distance_mm(pen) > kLeftMm) let_go();
}

void Retrace::step(Point pen, std::int64_t time_ns, const Scene& scene, double force_n) {
  add(pen_, pen);
  std::copy_backward(times_.begin(), times_.end() - 1, times_.end());
  times_[0] = time_ns;
  ++free_steps_;
  follow(lines_near(pen, scene));
  if (!track_ && !lines_.empty() && is_beside_ink(scene)) lines_.clear();
  if (track_) {
    const auto line = std::find_if(lines_.begin(), lines_.end(),
                                   [this](const Line& near) { return near.id == held_; });
    if (line == lines_.end() || chord_mm_per_s() > kFastMmPerS) let_go();
  } else if (free_steps_ > kAgainSteps) {
    hold(scene, force_n);
  }
}

/// Returns the nearest point of each line near the pen, by ascending id.
std::vector<Retrace::Near> Retrace::lines_near(Point pen, const Scene& scene) const {
  const double reach_mm = track_ ? kLeftMm : kNearMm;
  std::vector<Near> near;
  scene.index.for_each_segment_in(
      around(pen, reach_mm),
      [&](StrokeId id, int segment) {
        const StrokePtr stroke = scene.document.find(id);
        if (!stroke) return;
        const auto at = nearest_within(stroke->segment(segment), pen, reach_mm * reach_mm);
        if (!at) return;
        near.push_back({id, stroke, segment + at->t, at->point, std::sqrt(at->distance_squared)});
      },
      StrokeReach::kVisible);
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return std::tuple(a.id, a.distance_mm, a.u) < std::tuple(b.id, b.distance_mm, b.u);
  });
  const auto is_same = [](const Near& a, const Near& b) { return a.id == b.id; };
  near.erase(std::unique(near.begin(), near.end(), is_same), near.end());
  return near;
}

/// Returns true if the pen and the nearest position on the line moved in about the same direction
/// over the last steps. The line itself may run the other way.
bool Retrace::goes_along(const Line& line, double max_deg) const noexcept {
  if (line.steps < static_cast<int>(kChordSteps)) return true;  // too early to say
  const Vec pen = pen_[0] - pen_[kChordSteps];
  const Vec along = line.positions[0] - line.positions[kChordSteps];
  const double pen_mm = norm(pen), along_mm = norm(along);
  return along_mm >= kMinShare * pen_mm && dot(pen, along) >= cos_deg(max_deg) * pen_mm * along_mm;
}

/// Returns true if a position is a step further on the stroke, and not on another part of the
/// stroke that passes near, as in a zigzag.
bool Retrace::is_onward(double from_u, const Near& to) noexcept {
  const double whole = to.stroke->segment_count();
  double middle = 0.5 * (from_u + to.u);
  if (to.stroke->closed() && std::fabs(to.u - from_u) > 0.5 * whole) middle += 0.5 * whole;
  if (middle > whole) middle -= whole;
  return distance(to.stroke->position(middle), to.point) <= 2.0 * kStepMm;
}

/// Updates the lines that the pen follows, which are sorted by id. A held pen that leaps to another
/// part of its line has left it.
void Retrace::follow(const std::vector<Near>& near) {
  std::vector<Line> lines;
  for (const Near& at : near) {
    const auto known = std::lower_bound(lines_.begin(), lines_.end(), at.id,
                                        [](const Line& line, StrokeId id) { return line.id < id; });
    const bool goes_on = known != lines_.end() && known->id == at.id && is_onward(known->u, at);
    const bool is_held = track_ && at.id == held_;
    if (is_held ? !goes_on : at.distance_mm > kNearMm) continue;
    Line line = goes_on ? *known : Line{.id = at.id};
    add(line.positions, at.point);
    line.u = at.u;
    line.away_mm += at.distance_mm;
    line.steps += goes_on ? 1 : 0;
    if (goes_along(line, is_held ? kLeftDeg : kAlongDeg)) lines.push_back(line);
  }
  lines_ = std::move(lines);
}

/// Returns the speed over the last steps; infinity if the time does not increase.
double Retrace::chord_mm_per_s() const noexcept {
  const double s =
      1e-9 * (static_cast<double>(times_[0]) - static_cast<double>(times_[kChordSteps]));
  return s > 0.0 ? distance(pen_[0], pen_[kChordSteps]) / s
                 : std::numeric_limits<double>::infinity();
}

/// Returns true if a line runs beside the pen in its direction, as in a hatching, or if a stroke
/// comes back beside itself, as in a zigzag.
bool Retrace::is_beside_ink(const Scene& scene) const {
  const Vec along = normalized(pen_[0] - pen_[kChordSteps]);
  bool is_beside = false;
  std::vector<std::pair<StrokeId, double>> near;  // how far to the side, mm
  scene.index.for_each_segment_in(
      around(pen_[0], kBesideMm),
      [&](StrokeId id, int segment) {
        const StrokePtr stroke = is_beside ? nullptr : scene.document.find(id);
        if (!stroke) return;
        const Cubic curve = stroke->segment(segment);
        const auto at = nearest_within(curve, pen_[0], kBesideMm * kBesideMm);
        if (!at) return;
        const Vec away = at->point - pen_[0];
        if (at->distance_squared < kNearMm * kNearMm) {
          near.emplace_back(id, cross(along, away));
        } else {
          is_beside = std::fabs(dot(away, along)) <= kBesideCosine * norm(away) &&
                      std::fabs(dot(tangent(curve, at->t), along)) >= cos_deg(kLeftDeg);
        }
      },
      StrokeReach::kVisible);
  std::sort(near.begin(), near.end());
  for (std::size_t i = 1; i < near.size(); ++i) {
    const bool is_same = near[i].first == near[i - 1].first;
    is_beside = is_beside || (is_same && near[i].second - near[i - 1].second > kApartMm);
  }
  return is_beside;
}

/// Begins to hold the pen to the nearest of the lines that it has followed for long enough.
void Retrace::hold(const Scene& scene, double force_n) {
  if (chord_mm_per_s() > kSlowMmPerS) return;
  const Line* best = nullptr;
  for (const Line& line : lines_) {
    if (line.steps < kFollowedSteps || line.away_mm > kMeanMm * line.steps) continue;
    if (!best || line.away_mm / line.steps < best->away_mm / best->steps) best = &line;
  }
  const StrokePtr stroke = best ? scene.document.find(best->id) : nullptr;
  if (!stroke) return;
  free_steps_ = 0;
  GuideLine line{.kind = GuideKind::kGroove, .points = stroke_path(*stroke)};
  line.is_closed = is_closed_path(*stroke, line.points);
  if (!check_guide(line)) return;
  held_ = best->id;
  track_.emplace(std::move(line), ++hold_, law(force_n, scene.device));
}

}  // namespace felt
