#include "felt/tools/transform/transform_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "felt/tools/transform/transform_force.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kTransformUses = {
    {{.hint = "Drag inside to move, a corner to scale, outside it to turn.",
      .first_modifier = "along one axis, in steps of 15°",
      .second_modifier = "a copy",
      .third_modifier = "about the centre",
      .size = "grab_radius_mm",
      .path = ToolPath::kAway}}};
constexpr std::array<std::string_view, 5> kTransformEdits = {"Move", "Rotate", "Scale", "Stretch",
                                                             "Duplicate"};
constexpr ToolInfo kTransformInfo{.id = "transform",
                                  .label = "Transform",
                                  .help =
                                      "Moves, turns, scales and stretches the selection. Lines "
                                      "that cross it stay attached and resist.",
                                  .shortcut = 't',
                                  .options = kTransformOptions,
                                  .kind = ToolKind::kTransforms,
                                  .uses = kTransformUses,
                                  .edits = kTransformEdits,
                                  .act = {.title = "Move and turn",
                                          .caption = "Drag the selection. Lines that cross it stay "
                                                     "attached and resist, and you feel how much.",
                                          .seconds = 18.0}};

TransformKind kind_of(TransformMode mode) {
  switch (mode) {
    case TransformMode::kRotate:
      return TransformKind::kRotate;
    case TransformMode::kScale:
      return TransformKind::kScale;
    case TransformMode::kStretch:
      return TransformKind::kStretch;
    case TransformMode::kAuto:
    case TransformMode::kMove:
      break;
  }
  return TransformKind::kMove;
}

/// Gaps of larger previews are closed only when the pen is lifted, so that a sample takes no
/// longer.
constexpr std::size_t kMaxCompleted = 100, kMaxCompletedPoints = 5'000;
/// Minimum time between two previews whose gaps are closed, per stroke and per control point:
/// closing them takes about half of this.
constexpr double kCompletionNsPerStroke = 50'000.0, kCompletionNsPerPoint = 2'000.0;

/// Returns the number of control points of the strokes after an edit.
std::size_t point_count(const Edit& edit) {
  std::size_t count = 0;
  for (const StrokeChange& c : edit.changes) {
    if (c.after) count += c.after->data().points.size();
  }
  return count;
}

std::string hold_text(std::size_t anchors) {
  return std::to_string(anchors) + (anchors == 1 ? " line holds it" : " lines hold it");
}

}  // namespace

std::unique_ptr<Tool> make_transform() {
  return std::make_unique<TransformTool>();
}

TransformTool::TransformTool() : GestureTool(kTransformInfo) {}

TransformFrame::Grip TransformTool::grip_at(Point p) const {
  using Part = TransformFrame::Part;
  if (frame_.empty() || settings_.mode == TransformMode::kAuto) return frame_.grip_at(p);
  const bool has_centre = settings_.mode != TransformMode::kMove;
  if (has_centre && frame_.is_centre(p)) return {Part::kCentre, TransformKind::kMove, p};
  return {Part::kInside, kind_of(settings_.mode), p};
}

void TransformTool::look_at_stroke(Point p, const Scene& scene) {
  const auto hit = scene.index.nearest(p, settings_.grab_radius_mm);
  under_pen_id_ = hit ? hit->stroke : StrokeId{};
  under_pen_ = hit ? scene.document.find(hit->stroke) : nullptr;
}

/// Updates the frame. Resets the centre if other points are selected or if something other than
/// this tool has moved them.
void TransformTool::follow_selection(const Scene& scene) {
  if (selected_.fingerprint() != centre_is_for_) {
    if (selected_.marks_fingerprint() != moved_marks_) centre_.reset();
    moved_marks_.reset();
    centre_is_for_ = selected_.fingerprint();
  }
  frame_ = TransformFrame(selected_.ink_box(), selected_.box(), centre_);
  const Layer* layer = scene.document.layer(scene.layer);
  const bool is_open = layer && layer->visible && !layer->locked;
  picture_ = scene.selection.empty() && is_open ? layer->picture : nullptr;
  if (picture_) frame_ = TransformFrame(bounds_of(*picture_));
}

ToolResult TransformTool::hover(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  selected_.look(scene.document, scene.selection);
  follow_selection(scene);
  under_pen_ = nullptr;
  const TransformFrame::Part part = grip_at(pen_).part;
  if (part == TransformFrame::Part::kNone || (picture_ && part != TransformFrame::Part::kHandle)) {
    look_at_stroke(pen_, scene);
  }
  return {};
}

ToolResult TransformTool::begin(const PenSample& sample, const Scene& scene) {
  pen_ = grab_ = on_page(sample.position);
  farthest_mm_ = 0.0;
  ++gesture_;
  doing_ = Doing::kNothing;
  selected_.look_at_all(scene.document, scene.selection);
  follow_selection(scene);
  old_centre_ = centre_;
  under_pen_ = nullptr;
  const TransformFrame::Grip grip = grip_at(pen_);
  if (picture_) {
    begin_with_picture(grip, scene, sample.buttons);
    return {};
  }
  switch (grip.part) {
    case TransformFrame::Part::kInside:
    case TransformFrame::Part::kHandle:
      take_hold(grip.kind, scene, scene.selection, sample.buttons);
      if (grip.opposite) drag_.set_opposite(*grip.opposite);
      break;
    case TransformFrame::Part::kCentre:
      doing_ = Doing::kCentre;
      break;
    case TransformFrame::Part::kNone:
      look_at_stroke(pen_, scene);
      if (frame_.empty() && under_pen_) {
        hold_stroke(scene, sample.buttons);
      } else if (!frame_.empty()) {
        doing_ = Doing::kElsewhere;
      }
      break;
  }
  return {};
}

/// A stroke at the touch has priority over the inside of the picture, but not over its handles.
void TransformTool::begin_with_picture(const TransformFrame::Grip& grip, const Scene& scene,
                                       std::uint32_t buttons) {
  using Part = TransformFrame::Part;
  if (grip.part != Part::kHandle) look_at_stroke(pen_, scene);
  if (under_pen_) return hold_stroke(scene, buttons);
  if (grip.part == Part::kNone) return;
  const TransformKind kind = grip.part == Part::kCentre ? TransformKind::kMove : grip.kind;
  drag_ = TransformDrag(kind, frame_.centre(), grab_);
  if (grip.opposite) drag_.set_opposite(*grip.opposite);
  doing_ = Doing::kPicture;
}

/// Returns the edit that moves the picture, or nullopt if the picture cannot be there.
std::optional<Edit> TransformTool::picture_edit(const Scene& scene) const {
  const std::span<const Layer> layers = scene.document.layers();
  const auto layer = std::find_if(layers.begin(), layers.end(),
                                  [&scene](const Layer& l) { return l.id == scene.layer; });
  const Affine place = picture_ ? then(picture_->place, drag_.map()) : Affine{};
  if (layer == layers.end() || layer->picture != picture_ || !is_picture_place(place)) return {};
  const auto index = static_cast<std::size_t>(layer - layers.begin());
  LayerChange change{layer->id, layer->state(), layer->state(), index, index};
  change.after->picture = placed(*picture_, place);
  return Edit{drag_.label(), {}, {std::move(change)}};
}

void TransformTool::hold_stroke(const Scene& scene, std::uint32_t buttons) {
  Selection selection;
  selection.set_whole(under_pen_id_, under_pen_->data().points.size());
  selected_.look_at_all(scene.document, selection);
  frame_ = TransformFrame(selected_.ink_box(), selected_.box(), std::nullopt);
  take_hold(kind_of(settings_.mode), scene, selection, buttons);
  taken_ = std::move(selection);
}

void TransformTool::take_hold(TransformKind kind, const Scene& scene, const Selection& selection,
                              std::uint32_t buttons) {
  duplicates_ = settings_.duplicate || (buttons & kSecondModifier) != 0;
  strokes_ = MovedStrokes(scene.document, scene.index, selection, duplicates_,
                          scene.copies_leave_originals);
  connected_ = strokes_.connected_pull();
  completion_ns_ = 0.0;
  drag_ = TransformDrag(kind, frame_.centre(), grab_, strokes_.min_scale());
  doing_ = strokes_.empty() ? Doing::kNothing : Doing::kTransform;
}

double TransformTool::width_factor() const {
  return settings_.scale_widths ? drag_.width_factor() : 1.0;
}

ToolResult TransformTool::move(const PenSample& sample, const Scene& scene) {
  pen_ = on_page(sample.position);
  farthest_mm_ = std::max(farthest_mm_, distance(grab_, pen_));
  if (farthest_mm_ < kClickMm) return {.same_preview = true};
  if (doing_ == Doing::kCentre) {
    centre_ = pen_;
    frame_ = TransformFrame(selected_.ink_box(), selected_.box(), centre_);
  }
  if (doing_ == Doing::kNothing && duplicates_) {
    return {.refusal = strokes_.take_refusal(), .same_preview = true};
  }
  if (doing_ != Doing::kTransform && doing_ != Doing::kPicture) return {.same_preview = true};
  drag_.update(pen_, settings_.constrain || (sample.buttons & kFirstModifier) != 0,
               settings_.about_centre || (sample.buttons & kThirdModifier) != 0);
  if (doing_ == Doing::kPicture) return {.preview = picture_edit(scene), .same_preview = true};
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  const double waited =
      std::fabs(static_cast<double>(sample.time_ns) - static_cast<double>(completed_ns_));
  if (connected_ && waited < completion_ns_) return {.same_preview = true};
  ToolResult result{.preview = strokes_.step(drag_.map(), width_factor()), .same_preview = true};
  if (!connected_ || !result.preview) return result;
  const std::size_t strokes = result.preview->changes.size();
  const std::size_t points = point_count(*result.preview);
  if (strokes <= kMaxCompleted && points <= kMaxCompletedPoints) {
    connected_->complete(*result.preview, scene);
    completed_ns_ = sample.time_ns;
    completion_ns_ = kCompletionNsPerStroke * static_cast<double>(strokes) +
                     kCompletionNsPerPoint * static_cast<double>(points);
  }
  return result;
}

ToolResult TransformTool::end(const Scene& scene) {
  ToolResult result;
  switch (doing_) {
    case Doing::kNothing:
      break;
    case Doing::kTransform:
      result = end_transform(scene);
      break;
    case Doing::kPicture:
      if (!drag_.is_identity()) result.commit = picture_edit(scene);
      break;
    case Doing::kCentre:
      if (farthest_mm_ < kClickMm) centre_.reset();
      break;
    case Doing::kElsewhere:
      result = end_elsewhere(scene);
      break;
  }
  old_centre_ = centre_;
  drop();
  return result;
}

ToolResult TransformTool::end_transform(const Scene& scene) {
  ToolResult result;
  result.selection = taken_;
  if (drag_.is_identity()) return result;
  Edit edit = strokes_.finished(drag_.map(), width_factor(),
                                duplicates_ ? std::string("Duplicate") : drag_.label());
  if (edit.empty()) return result;
  if (connected_) connected_->complete(edit, scene);
  if (duplicates_) {
    result.selection = strokes_.copies();
  } else if (!taken_) {
    result.selection = strokes_.selection_after(edit, scene.selection);
  }
  result.commit = std::move(edit);
  if (centre_) centre_ = apply(drag_.map(), *centre_);
  moved_marks_ = selected_.marks_fingerprint();
  selected_.start_over();
  return result;
}

ToolResult TransformTool::end_elsewhere(const Scene& scene) const {
  ToolResult result;
  if (farthest_mm_ >= kClickMm) return result;
  result.selection.emplace();
  if (under_pen_ && scene.document.find(under_pen_id_)) {
    result.selection->set_whole(under_pen_id_, under_pen_->data().points.size());
  }
  return result;
}

void TransformTool::drop() {
  centre_ = old_centre_;
  doing_ = Doing::kNothing;
  taken_.reset();
  under_pen_ = nullptr;
  strokes_ = {};
  connected_.reset();
  drag_ = {};
}

void TransformTool::take_options(const OptionValues& options) {
  settings_ = transform_settings(options);
}

ForceModel TransformTool::force(const Scene& scene) const {
  const TransformHold hold{drag_.kind(),       drag_.centre(), drag_.grab(),
                           strokes_.anchors(), gesture_,       drag_.is_constrained(),
                           drag_.min_scale()};
  const bool holds = in_gesture() && doing_ == Doing::kTransform;
  return make_transform_force(scene, settings_.strength, holds ? &hold : nullptr);
}

void TransformTool::draw(Overlay& overlay) const {
  const bool drags = doing_ == Doing::kTransform || doing_ == Doing::kPicture;
  if (in_gesture() && drags) return draw_gesture(overlay);
  if (!frame_.empty()) {
    selected_.draw(overlay);
    frame_.draw(overlay);
    const TransformFrame::Grip grip = grip_at(pen_);
    if (grip.part == TransformFrame::Part::kHandle || grip.part == TransformFrame::Part::kCentre) {
      overlay.rings.push_back({grip.at, TransformFrame::kGripMm, Overlay::Role::kReach});
    }
  }
  if (under_pen_) {
    add_span(overlay, *under_pen_, 0.0, under_pen_->segment_count(), Overlay::Role::kSpan);
  }
}

void TransformTool::draw_gesture(Overlay& overlay) const {
  const Affine& map = drag_.map();
  Overlay marked;
  selected_.draw(marked);
  for (Overlay::Span span : marked.spans) {
    if (span.role != Overlay::Role::kSelected) continue;  // it bends, so only the preview shows it
    span.curve = apply(map, span.curve);
    overlay.spans.push_back(span);
  }
  std::vector<Point> corners;
  for (const Point p : frame_.corners()) corners.push_back(apply(map, p));
  const Point beside = corners[1];
  overlay.outlines.push_back({std::move(corners), true, Overlay::Role::kSelected});
  draw_tethers(overlay);
  if (drag_.kind() == TransformKind::kMove) {
    overlay.lines.push_back({grab_, pen_, Overlay::Role::kVector});
  } else {
    overlay.dots.push_back({drag_.centre(), Overlay::Role::kGuide});
    overlay.lines.push_back({drag_.centre(), grab_, Overlay::Role::kGuide});
    overlay.lines.push_back({drag_.centre(), pen_, Overlay::Role::kVector});
  }
  overlay.labels.push_back({pen_, drag_.text()});
  if (!strokes_.anchors().empty()) {
    overlay.labels.push_back({beside, hold_text(strokes_.anchors().size())});
  }
}

void TransformTool::draw_tethers(Overlay& overlay) const {
  const std::vector<Point>& anchors = strokes_.anchors();
  for (std::size_t i = 0; i < std::min(anchors.size(), kMaxTethers); ++i) {
    overlay.dots.push_back({anchors[i], Overlay::Role::kTether});
    overlay.lines.push_back({anchors[i], apply(drag_.map(), anchors[i]), Overlay::Role::kTether});
  }
}

}  // namespace felt
