#include "felt/tools/retrace.h"

#include <algorithm>
#include <cmath>
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

void Retrace::add(Places& places, Point place) noexcept {
  std::copy_backward(places.begin(), places.end() - 1, places.end());
  places[0] = place;
}

void Retrace::begin(const PenSample& sample) noexcept {
  pen_.fill(on_page(sample.position));
  times_.fill(sample.time_ns);
  free_steps_ = kAgainSteps;
}

void Retrace::stop() noexcept {
  let_go();
  lines_.clear();
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
  const Point pen = on_page(sample.position);
  if (!in_contact(sample)) return;
  if (distance(pen, pen_[0]) >= kStepMm) step(pen, sample.time_ns, scene, force_n);
  if (track_) track_->update(sample);
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

/// Returns the nearest point of each line near the pen.
std::vector<Retrace::Near> Retrace::lines_near(Point pen, const Scene& scene) const {
  const double reach_mm = track_ ? kLeftMm : kNearMm;
  std::vector<Near> near;
  scene.index.for_each_segment_in(
      around(pen, reach_mm),
      [&](StrokeId id, int segment) {
        const StrokePtr stroke = scene.document.find(id);
        if (!stroke) return;
        const auto place = nearest_within(stroke->segment(segment), pen, reach_mm * reach_mm);
        if (!place) return;
        const Near found{id, stroke, segment + place->t, place->point,
                         std::sqrt(place->distance_squared)};
        const auto same = std::find_if(near.begin(), near.end(),
                                       [&](const Near& other) { return other.id == id; });
        if (same == near.end()) {
          near.push_back(found);
        } else if (found.distance_mm < same->distance_mm) {
          *same = found;
        }
      },
      StrokeReach::kVisible);
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.id < b.id; });
  return near;
}

/// Returns true if the pen and its nearest place on the line moved in about the same direction over
/// the last steps. The line itself may run the other way.
bool Retrace::goes_along(const Line& line, double most_deg) const noexcept {
  if (line.steps < static_cast<int>(kChordSteps)) return true;  // too early to say
  const Vec pen = pen_[0] - pen_[kChordSteps];
  const Vec along = line.places[0] - line.places[kChordSteps];
  const double pen_mm = norm(pen), along_mm = norm(along);
  return along_mm >= kMinShare * pen_mm && dot(pen, along) >= cos_deg(most_deg) * pen_mm * along_mm;
}

/// Returns true if a place is a step further on the stroke, and not on another part of the stroke
/// that passes near, as in a zigzag.
bool Retrace::is_onward(double from_u, const Near& to) noexcept {
  const double whole = to.stroke->segment_count();
  double middle = 0.5 * (from_u + to.u);
  if (to.stroke->closed() && std::fabs(to.u - from_u) > 0.5 * whole) middle += 0.5 * whole;
  if (middle > whole) middle -= whole;
  return distance(to.stroke->position(middle), to.point) <= 2.0 * kStepMm;
}

/// Updates the lines that the pen follows.
void Retrace::follow(const std::vector<Near>& near) {
  std::vector<Line> lines;
  for (const Near& at : near) {
    const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) {
      return line.id == at.id && is_onward(line.u, at);
    });
    Line line = known == lines_.end() ? Line{.id = at.id} : *known;
    const bool is_held = track_ && line.id == held_;
    if (!is_held && at.distance_mm > kNearMm) continue;
    add(line.places, at.point);
    line.u = at.u;
    line.away_mm += at.distance_mm;
    if (known != lines_.end()) ++line.steps;
    if (goes_along(line, is_held ? kLeftDeg : kAlongDeg)) lines.push_back(line);
  }
  lines_ = std::move(lines);
}

double Retrace::chord_mm_per_s() const noexcept {
  const double s =
      1e-9 * (static_cast<double>(times_[0]) - static_cast<double>(times_[kChordSteps]));
  return s > 0.0 ? distance(pen_[0], pen_[kChordSteps]) / s : 0.0;
}

/// Returns true if ink runs beside the pen in its direction, as in a hatching, or if a stroke comes
/// back beside itself, as in a zigzag.
bool Retrace::is_beside_ink(const Scene& scene) const {
  const Vec along = normalized(pen_[0] - pen_[kChordSteps]);
  bool is_beside = false;
  std::vector<std::pair<StrokeId, double>> near;  // how far to the side, mm
  scene.index.for_each_segment_in(
      around(pen_[0], kBesideMm),
      [&](StrokeId id, int segment) {
        const StrokePtr stroke = scene.document.find(id);
        if (!stroke) return;
        const auto place = nearest_within(stroke->segment(segment), pen_[0], kBesideMm * kBesideMm);
        if (!place) return;
        const Vec away = place->point - pen_[0];
        if (place->distance_squared < kNearMm * kNearMm) {
          near.emplace_back(id, cross(along, away));
        } else if (std::fabs(dot(away, along)) <= kBesideCosine * norm(away)) {
          is_beside = true;
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
  GuideLine line{.kind = GuideKind::kGroove, .points = stroke_path(*stroke)};
  // The path of a very long stroke does not come back to its start.
  line.is_closed = stroke->closed() && distance(line.points.front(), line.points.back()) < kStepMm;
  if (!check_guide(line)) return;
  held_ = best->id;
  track_.emplace(std::move(line), ++hold_, law(force_n, scene.device));
}

}  // namespace felt
