#include "tests/drawing/gestures/checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "felt/haptics/bricks/drawing_feel.h"

namespace felt::gestures {
namespace {

constexpr double kMaxNormalN = 3.0;

std::string name_of(StrokeId id) {
  return "stroke " + std::to_string(id.value);
}

bool may_be_edited(const Document& document, StrokeId id) {
  const Layer* layer = document.layer(document.layer_of(id));
  return layer->visible && !layer->locked;
}

Broken check_change(const Document& before, const StrokeChange& change) {
  if (change.after) {
    const Result<void> kept = check_invariants(change.after->data());
    if (!kept) return name_of(change.id) + ": " + kept.error().message;
  }
  if (!change.before) return std::nullopt;
  if (before.find(change.id) != change.before) return name_of(change.id) + " is not what it was";
  if (!may_be_edited(before, change.id)) return name_of(change.id) + " is hidden or locked";
  return std::nullopt;
}

bool is_of_the_surface(std::string_view term) {
  return term == "plane" || term == "friction" || term == "viscosity" || term == "texture";
}

bool is_fine(Point p) {
  return is_finite(p);
}

std::size_t control_points(const Document& document) {
  std::size_t count = 0;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) count += document.find(id)->data().points.size();
  }
  return count;
}

}  // namespace

Broken check_edit(const Document& before, const Edit& edit) {
  for (const FillChange& change : edit.fills) {
    const std::string name = "fill " + std::to_string(change.id.value);
    if (change.after) {
      if (const Result<void> kept = check_fill(*change.after); !kept) {
        return name + ": " + kept.error().message;
      }
    }
    if (!change.before) continue;
    if (before.find_fill(change.id) != change.before) return name + " is not what it was";
    const Layer* layer = before.layer(before.layer_of_fill(change.id));
    if (layer->locked) return name + " is locked";
  }
  for (const GuideChange& change : edit.guides) {
    const std::string name = "guide " + std::to_string(change.id.value);
    if (before.find_guide(change.id) != change.before) return name + " is not what it was";
    if (!change.after) continue;
    if (const Result<void> kept = check_drawing_guide(*change.after); !kept) {
      return name + ": " + kept.error().message;
    }
  }
  for (const SymmetryChange& change : edit.symmetries) {
    if (!change.after) continue;
    if (const Result<void> kept = check_symmetry_group(*change.after); !kept) {
      return kept.error().message;
    }
  }
  for (const StrokeChange& change : edit.changes) {
    if (Broken broken = check_change(before, change)) return broken;
  }
  Document copy = before;
  const Result<void> applied = copy.apply(edit);
  if (!applied) return "the edit does not fit: " + applied.error().message;
  return std::nullopt;
}

Broken check_locality(const Document& before, const Document& after, const Edit& edit) {
  std::set<StrokeId> named;
  for (const StrokeChange& change : edit.changes) named.insert(change.id);
  for (const Layer& layer : before.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (!named.contains(id) && after.find(id) != before.find(id)) {
        return name_of(id) + " changed, which the edit does not name";
      }
    }
  }
  return std::nullopt;
}

Broken check_selection(const Document& document, const Selection& selection) {
  for (const auto& [id, marks] : selection.strokes()) {
    const StrokePtr stroke = document.find(id);
    if (!stroke) return name_of(id) + " is selected and not there";
    if (marks.size() != stroke->data().points.size()) return name_of(id) + " has too few marks";
    if (std::count(marks.begin(), marks.end(), 0) == std::ssize(marks)) {
      return name_of(id) + " is selected without a point";
    }
    if (stroke->closed() && marks.front() != marks.back()) {
      return name_of(id) + " is closed and its first point selected once only";
    }
  }
  return std::nullopt;
}

Broken check_overlay(const Overlay& overlay, const Document& document, std::size_t samples) {
  bool fine = true;
  std::size_t count = overlay.labels.size() + overlay.dots.size() + overlay.lines.size() +
                      overlay.rings.size() + overlay.spans.size() + overlay.ink.size();
  const auto see = [&fine](Point p) { fine = fine && is_fine(p); };
  const auto see_curve = [&see](const Cubic& c) { std::for_each(c.p.begin(), c.p.end(), see); };
  for (const auto& ring : overlay.rings) {
    see(ring.center);
    fine = fine && std::isfinite(ring.radius_mm) && ring.radius_mm >= 0.0;
  }
  for (const auto& line : overlay.lines) see(line.from), see(line.to);
  for (const auto& ink : overlay.ink) {
    see_curve(ink.curve);
    fine = fine && ink.start_width_mm >= 0.0 && ink.end_width_mm >= 0.0;
  }
  for (const auto& span : overlay.spans) {
    see_curve(span.curve);
    fine = fine && std::isfinite(span.width_mm) && span.width_mm >= 0.0;
  }
  for (const auto& outline : overlay.outlines) {
    std::for_each(outline.points.begin(), outline.points.end(), see);
    count += outline.points.size();
  }
  for (const auto& dot : overlay.dots) see(dot.at);
  for (const auto& label : overlay.labels) see(label.at);
  if (!fine) return "something that is drawn is not finite, or negative";
  if (count > 20000 + 10 * samples + 10 * control_points(document)) {
    return "too much is drawn: " + std::to_string(count) + " after " + std::to_string(samples) +
           " samples";
  }
  return std::nullopt;
}

Broken check_reading(const Reading& reading, const Document& document) {
  using Kind = Reading::Kind;
  const bool on_line =
      reading.kind == Kind::kLine || reading.kind == Kind::kEnd || reading.kind == Kind::kCrossing;
  if (on_line != static_cast<bool>(reading.stroke)) return "a reading without its line";
  if (on_line && !document.find(reading.stroke)) return "a reading of a line that is not there";
  const bool on_fill = reading.kind == Kind::kFill;
  if (on_fill && !document.find_fill(reading.fill)) return "a reading of a fill that is not there";
  if (reading.kind == Kind::kCrossing && reading.lines < 2) return "a crossing of one line";
  const bool fine =
      reading.distance_mm >= 0.0 && reading.length_mm >= 0.0 && std::isfinite(reading.length_mm);
  if (!fine) return "a reading with a number that is no length";
  return std::nullopt;
}

ForceProbe::ForceProbe(const Capabilities& device) : device_(device) {
  memory_.period_s = 1e-9 * static_cast<double>(device.period_ns);
  memory_.material_cap_n_per_m = device.max_stiffness_n_per_m;
}

Force ForceProbe::beside_the_surface(const ForceModel& model, const PenSample& sample,
                                     ForceMemory memory) {
  // The tick is so short that a groove which captures the pen here (Guide) has no force yet,
  // because its force grows from zero with time. This check is about jumps in space only.
  memory.begin_tick(1e-6);
  (void)model(sample, memory);
  Force sum;
  for (const ForceTerms::Term& term : memory.terms) {
    if (!is_of_the_surface(term.name)) sum += term.force;
  }
  return sum;
}

Broken ForceProbe::check(const ForceModel& model, const PenSample& sample, double limit_n,
                         bool may_exceed_budget) {
  if (Broken broken = check_claims(model.slopes(), may_exceed_budget)) return broken;
  PenSample still = sample;
  still.velocity = {};
  const Force beside = beside_the_surface(model, still, memory_);
  const double lateral_n = std::hypot(beside.x, beside.y);
  largest_n_ = std::max(largest_n_, lateral_n);
  if (!(lateral_n <= limit_n + 1e-9)) {
    return "a tool's force along the surface of " + std::to_string(lateral_n) + " N";
  }
  // A tool may make the surface stiffer along z; the user's force limit bounds that.
  if (!(std::fabs(beside.z) <= kMaxNormalN)) return "a push of " + std::to_string(beside.z) + " N";
  if (Broken broken = check_slope(model, still)) return broken;
  const double dt_s = 1e-9 * static_cast<double>(sample.time_ns - last_ns_);
  last_ns_ = sample.time_ns;
  memory_.begin_tick(std::clamp(dt_s, 0.0002, 0.005));
  const Force force = model(sample, memory_);
  if (!is_finite(force)) return "a force that is not finite";
  Force sum;
  for (const ForceTerms::Term& term : memory_.terms) sum += term.force;
  if (!(norm(sum - force) <= 1e-9 * (1.0 + norm(force)))) return "the terms are not the force";
  return std::nullopt;
}

/// Returns the size of a force jump between `a` and `b`, in N. Halves the interval repeatedly and
/// keeps the half in which the force changes more. If the force is continuous, the result
/// approaches 0.
double ForceProbe::jump_between(const ForceModel& model, PenSample a, PenSample b,
                                const ForceMemory& seen) {
  Force at_a = beside_the_surface(model, a, seen), at_b = beside_the_surface(model, b, seen);
  for (int k = 0; k < 10 && norm(at_b - at_a) > 0.002; ++k) {
    PenSample middle = a;
    middle.position = 0.5 * (a.position + b.position);
    const Force at_middle = beside_the_surface(model, middle, seen);
    const bool first_half = norm(at_middle - at_a) > norm(at_b - at_middle);
    (first_half ? b : a) = middle;
    (first_half ? at_b : at_a) = at_middle;
  }
  return norm(at_b - at_a);
}

Broken ForceProbe::check_slope(const ForceModel& model, const PenSample& sample) const {
  constexpr double kStepMm = 0.01;
  // So far from the origin a double is too coarse to measure a slope over kStepMm.
  if (std::max(std::fabs(sample.position.x), std::fabs(sample.position.y)) > 1e5) return {};
  const double claimed_n_per_mm = 1e-3 * model.slopes().lateral_n_per_m;
  // The pen is here before it moves on, so that a turn is counted from here.
  ForceMemory seen = memory_;
  seen.begin_tick(1e-6);
  (void)model(sample, seen);
  const Force here = beside_the_surface(model, sample, seen);
  for (const Vec d : {Vec{kStepMm, 0.0}, Vec{0.0, kStepMm}}) {
    PenSample moved = sample;
    moved.position = moved.position + Vec3{d.x, d.y, 0.0};
    const Force change = beside_the_surface(model, moved, seen) - here;
    const double back_n_per_mm = -(change.x * d.x + change.y * d.y) / (kStepMm * kStepMm);
    if (back_n_per_mm > 1.02 * claimed_n_per_mm + 0.002) {
      return "pulls back by " + std::to_string(1e3 * back_n_per_mm) + " N/m and claims " +
             std::to_string(1e3 * claimed_n_per_mm);
    }
    if (const double jump_n = jump_between(model, sample, moved, seen); jump_n > 0.002) {
      return "a force that jumps by " + std::to_string(jump_n) + " N";
    }
  }
  return std::nullopt;
}

Broken ForceProbe::check_claims(const Slopes& slopes, bool may_exceed_budget) const {
  const double sum = slopes.friction_n_per_m + slopes.lateral_n_per_m;
  if (!(slopes.normal_n_per_m >= 0.0 && slopes.friction_n_per_m >= 0.0 &&
        slopes.lateral_n_per_m >= 0.0 && std::isfinite(sum + slopes.normal_n_per_m))) {
    return "a slope that is claimed is negative or not finite";
  }
  if (may_exceed_budget) return std::nullopt;
  const double budget = stiffness_budget_n_per_m(device_) * (1.0 + 1e-9);
  if (slopes.normal_n_per_m <= budget && sum <= budget) return std::nullopt;
  return "claims " + std::to_string(slopes.normal_n_per_m) + " and " + std::to_string(sum) +
         " N/m of " + std::to_string(budget);
}

}  // namespace felt::gestures
