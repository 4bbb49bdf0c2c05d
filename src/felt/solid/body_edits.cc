#include "felt/solid/body_edits.h"

#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "felt/solid/cut_body.h"
#include "felt/solid/extrude_body.h"
#include "felt/solid/paint_body.h"
#include "felt/solid/smooth_body.h"
#include "felt/solid/surface_hit.h"

namespace felt {
namespace body_editing {

constexpr const char* kMissesBodies = "the stroke does not touch a body";
/// Distance of the points of painted lines, as a share of their width.
constexpr double kPaintStepShare = 0.25;

/// The verb of a kind, for sentences.
const char* name_of(BodyEditKind kind) {
  switch (kind) {
    case BodyEditKind::kCut:
      return "cut";
    case BodyEditKind::kExtrude:
      return "extrusion";
    case BodyEditKind::kPaint:
      return "painted line";
    case BodyEditKind::kSmooth:
      return "smoothing";
  }
  return "edit";
}

/// Returns points that are relative to the origin of the page in the frame of a solid.
std::vector<Vec3> in_frame(std::span<const Vec3> path, Point origin) {
  std::vector<Vec3> points;
  points.reserve(path.size());
  for (const Vec3& p : path) points.push_back({p.x - origin.x, p.y + origin.y, p.z});
  return points;
}

/// Returns the body that the eye sees first at the first point of the path where it sees one, or
/// nullopt.
std::optional<std::size_t> body_below(const Solid& solid, const std::vector<Vec3>& path,
                                      const Vec3& view) {
  // Each point is compared with every triangle, so a long path is not searched at each point.
  constexpr std::size_t kMaxSearched = 500;
  const std::size_t stride = path.size() / kMaxSearched + 1;
  for (std::size_t at = 0; at < path.size(); at += stride) {
    const Vec3& p = path[at];
    std::optional<std::size_t> seen;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < solid.bodies.size(); ++i) {
      const auto hit = hit_from_eye(solid.bodies[i], p, view);
      if (!hit || dot(view, hit->point) >= nearest) continue;
      nearest = dot(view, hit->point);
      seen = i;
    }
    if (seen) return seen;
  }
  return std::nullopt;
}

/// Applies edits to a solid.
class Editor {
 public:
  explicit Editor(Solid solid) : solid_(std::move(solid)) {}

  Result<void> apply(const BodyEdit& edit);
  /// Paints the bodies. Calls `leave_out` with the number of each painted line, counted from 0,
  /// that would break a body, and the reason.
  Solid finish(const std::function<void(std::size_t, const std::string&)>& leave_out,
               const std::atomic<bool>* is_cancelled);

 private:
  Result<void> cut(const BodyEdit& edit, const std::vector<Vec3>& path);
  Result<void> extrude(const BodyEdit& edit, const std::vector<Vec3>& path);
  Result<void> smooth(const BodyEdit& edit, const std::vector<Vec3>& path);
  Result<void> paint(const BodyEdit& edit, const std::vector<Vec3>& path);

  Solid solid_;
  std::vector<PaintedLine> lines_;
};

Result<void> Editor::apply(const BodyEdit& edit) {
  const std::vector<Vec3> path = in_frame(edit.path_mm, solid_.origin);
  switch (edit.kind) {
    case BodyEditKind::kCut:
      return cut(edit, path);
    case BodyEditKind::kExtrude:
      return extrude(edit, path);
    case BodyEditKind::kPaint:
      return paint(edit, path);
    case BodyEditKind::kSmooth:
      return smooth(edit, path);
  }
  return {};
}

Result<void> Editor::cut(const BodyEdit& edit, const std::vector<Vec3>& path) {
  std::vector<SolidBody> bodies;
  bool touches = false;
  for (const SolidBody& body : solid_.bodies) {
    Result<std::optional<std::vector<SolidBody>>> parts = cut_body(body, path, edit.view);
    if (!parts) return tl::unexpected(parts.error());
    touches = touches || *parts;
    if (!*parts) {
      bodies.push_back(body);
    } else {
      for (SolidBody& part : **parts) bodies.push_back(std::move(part));
    }
  }
  if (!touches) return invalid_data(kMissesBodies);
  solid_.bodies = std::move(bodies);
  return {};
}

Result<void> Editor::extrude(const BodyEdit& edit, const std::vector<Vec3>& path) {
  const std::optional<std::size_t> at = body_below(solid_, path, edit.view);
  if (!at) return invalid_data(kMissesBodies);
  SolidBody& body = solid_.bodies[*at];
  const std::vector<Vec3> profile = in_frame(edit.profile_mm, solid_.origin);
  Result<SolidBody> extruded = extrude_body(body, path, profile, edit.view);
  if (!extruded) return tl::unexpected(extruded.error());
  body = *std::move(extruded);
  return {};
}

Result<void> Editor::smooth(const BodyEdit& edit, const std::vector<Vec3>& path) {
  const std::optional<std::size_t> at = body_below(solid_, path, edit.view);
  if (!at) return invalid_data(kMissesBodies);
  SolidBody& body = solid_.bodies[*at];
  Result<SolidBody> smoothed = smooth_body(body, path, edit.view, edit.width_mm, edit.amount);
  if (!smoothed) return tl::unexpected(smoothed.error());
  body = *std::move(smoothed);
  body.border_count = 0;
  return {};
}

Result<void> Editor::paint(const BodyEdit& edit, const std::vector<Vec3>& path) {
  PaintedLine line{{}, edit.width_mm, edit.color};
  if (!(line.width_mm > 0.0)) return invalid_data("the painted line has no width");
  for (const SolidBody& body : solid_.bodies) {
    const double step = kPaintStepShare * edit.width_mm;
    for (LineOnBody& part : projected_line(body, path, edit.view, step)) {
      line.parts.push_back(std::move(part));
    }
  }
  if (line.parts.empty()) return invalid_data(kMissesBodies);
  lines_.push_back(std::move(line));
  return {};
}

Solid Editor::finish(const std::function<void(std::size_t, const std::string&)>& leave_out,
                     const std::atomic<bool>* is_cancelled) {
  for (SolidBody& body : solid_.bodies) {
    for (std::size_t count = lines_.size(); count > 0; --count) {
      if (is_cancelled && *is_cancelled) return std::move(solid_);
      SolidBody painted = body;
      paint_body(painted, std::span(lines_).first(count));
      const Result<void> checked = check_body(painted, solid_.origin);
      if (checked) {
        body = std::move(painted);
        break;
      }
      leave_out(count - 1, checked.error().message);
    }
  }
  return std::move(solid_);
}

std::string refusal(std::size_t number, const BodyEdit& edit, const std::string& why) {
  char text[160];
  const Vec3 at = edit.path_mm.empty() ? Vec3{} : edit.path_mm.front();
  std::snprintf(text, sizeof text,
                "left out: edit %zu of the body, the %s that begins at (%.2f, %.2f) mm: ", number,
                name_of(edit.kind), at.x, 0.0 - at.y);
  return text + why;
}

}  // namespace body_editing

std::vector<BodyEdit> body_edits_of(const Document& document) {
  std::vector<BodyEdit> edits;
  for (const auto& [id, edit] : document.body_edits()) edits.push_back(*edit);
  return edits;
}

Result<ExtrusionRing> extrusion_ring(const Solid& solid, const BodyEdit& edit) {
  const std::vector<Vec3> path = body_editing::in_frame(edit.path_mm, solid.origin);
  const std::optional<std::size_t> at = body_editing::body_below(solid, path, edit.view);
  if (!at) return invalid_data(body_editing::kMissesBodies);
  return ring_on_body(solid.bodies[*at], path, edit.view);
}

EditedSolid apply_body_edits(Solid solid, std::span<const BodyEdit> edits,
                             const std::atomic<bool>* is_cancelled) {
  using namespace body_editing;
  EditedSolid result;
  result.refusals.resize(edits.size());
  result.reasons.resize(edits.size());
  Editor editor(std::move(solid));
  std::vector<std::size_t> painted;  // the index of the edit of each painted line
  const auto leave_out = [&](std::size_t i, const std::string& why) {
    result.refusals[i] = refusal(i + 1, edits[i], why);
    result.reasons[i] = why;
  };
  for (std::size_t i = 0; i < edits.size() && !(is_cancelled && *is_cancelled); ++i) {
    const Result<void> done = editor.apply(edits[i]);
    if (!done) leave_out(i, done.error().message);
    if (done && edits[i].kind == BodyEditKind::kPaint) painted.push_back(i);
  }
  result.solid = editor.finish(
      [&](std::size_t line, const std::string& why) { leave_out(painted[line], why); },
      is_cancelled);
  return result;
}

}  // namespace felt
