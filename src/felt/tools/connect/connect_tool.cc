#include "felt/tools/connect/connect_tool.h"

#include <algorithm>
#include <array>
#include <utility>

#include "felt/base/check.h"
#include "felt/tools/connect/connect_ends.h"
#include "felt/tools/connect/connect_force.h"
#include "felt/tools/connect/near_tips.h"

namespace felt {
namespace {

constexpr std::array<ToolUse, 1> kConnectUses = {
    {{.hint = "Drag the end of a line to another end.",
      .first_modifier = "the end stays where you release it",
      .size = "grab_radius_mm",
      .path = ToolPath::kFromEnd}}};
constexpr std::array<std::string_view, 3> kConnectEdits = {"Connect", "Close", "Move end"};
constexpr ToolInfo kConnectInfo{
    .id = "connect",
    .label = "Connect",
    .help =
        "Joins ends of lines, or closes a line: drag an end onto another, "
        "or tap where two ends are near.",
    .shortcut = 'c',
    .options = kConnectOptions,
    .kind = ToolKind::kEdits,
    .uses = kConnectUses,
    .edits = kConnectEdits,
    .act = {.title = "Connect",
            .caption = "Drag one end onto another: they snap together and become one line.",
            .seconds = 16.0}};

/// Radius of the ring around the end that would be grabbed.
constexpr double kTipRingMm = 1.5;

}  // namespace

std::unique_ptr<Tool> make_connect() {
  return std::make_unique<ConnectTool>();
}

ConnectTool::Drag::Drag(const Scene& scene, const TipHit& hit, const PenSample& pen)
    : tip(hit.id),
      from(hit.point),
      pen_from(on_page(pen.position)),
      since_ns(pen.time_ns),
      place(scene.document, hit.id.stroke),
      lead(*place.before(), hit.id.tip),
      lines(BrushOptions{}),
      at(hit.point) {
  lines.keep_shape(tip.stroke);
  lines.release(tip);
}

ConnectTool::ConnectTool() : GestureTool(kConnectInfo) {
  take_options(options());
}

void ConnectTool::take_options(const OptionValues& options) {
  settings_ = connect_settings(options);
}

ToolResult ConnectTool::hover(const PenSample& sample, const Scene& scene) {
  const Point pen = on_page(sample.position);
  near_ = sample.position.z < (near_ ? kFarMm : kNearMm);
  if (released_at_ && distance(*released_at_, pen) > settings_.snap.reach_mm) released_at_.reset();
  find(pen, scene);
  return {};
}

void ConnectTool::find(Point pen, const Scene& scene) {
  const std::vector<TipHit> last = std::exchange(shown_, {});
  shown_ = editable_tips_near(scene, pen, settings_.grab_radius_mm, kMaxShown);
  partner_.reset();
  if (shown_.empty()) return;
  // As for targets, the end that is shown stays until another is nearer by kHysteresisMm.
  const double limit = shown_.front().distance_mm + SnapFinder::kHysteresisMm;
  const auto kept = std::find_if(shown_.begin(), shown_.end(), [&](const TipHit& hit) {
    return !last.empty() && hit.id == last.front().id && hit.point == last.front().point &&
           hit.distance_mm <= limit;
  });
  if (kept != shown_.end()) std::rotate(shown_.begin(), kept, kept + 1);
  if (snaps(settings_.snap.mode)) partner_ = partner(shown_.front(), scene);
}

std::optional<TipHit> ConnectTool::partner(const TipHit& tip, const Scene& scene) const {
  return scene.index.nearest_tip(scene.document, tip.point, settings_.snap.reach_mm,
                                 std::span(&tip.id, 1));
}

ToolResult ConnectTool::begin(const PenSample& sample, const Scene& scene) {
  released_at_.reset();
  find(on_page(sample.position), scene);
  if (shown_.empty()) return {};
  drag_.emplace(scene, shown_.front(), sample);
  finder_.drag(drag_->tip);
  finder_.update(drag_->at, settings_.snap, scene.document, scene.index);
  return {};
}

ToolResult ConnectTool::move(const PenSample& sample, const Scene& scene) {
  if (!drag_) return {.same_preview = true};
  Drag& d = *drag_;
  d.extend = settings_.extend != ((sample.buttons & kFirstModifier) != 0);
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  d.is_long = static_cast<double>(sample.time_ns) - static_cast<double>(d.since_ns) >
              static_cast<double>(kTapNs);
  const Point at = d.from + (on_page(sample.position) - d.pen_from);
  d.is_pulled = d.is_pulled || distance(at, d.from) > kTapMm;
  finder_.update(at, settings_.snap, scene.document, scene.index);
  if (!d.is_pulled || at == d.at) return {.same_preview = true};
  return lead_to(at, scene);
}

ToolResult ConnectTool::lead_to(Point at, const Scene& scene) {
  Drag& d = *drag_;
  d.at = at;
  if (is_in_snap_radius()) {
    const TipId on = finder_.target()->tip;
    if (d.on == on) return {.same_preview = true};
    Edit edit = connect(on, MeetingPlace::kAtTarget, scene);
    if (!edit.empty()) {
      d.on = on;
      d.edit = std::move(edit);
      return {.preview = d.edit};
    }
  }
  d.on.reset();
  auto led = d.lead.at(at);
  if (!led) return {.same_preview = true};  // keep the last valid shape
  d.edit = d.place.with(std::make_shared<const Stroke>(*std::move(led)), "Move end");
  d.lines.complete(*d.edit, scene);
  return {.preview = d.edit};
}

bool ConnectTool::is_in_snap_radius() const {
  const auto& target = finder_.target();
  return target && snaps(settings_.snap.mode) &&
         distance(drag_->at, target->point) <= settings_.snap.radius_mm;
}

Edit ConnectTool::connect(TipId to, MeetingPlace place, const Scene& scene) const {
  const TipId moved = drag_->tip;
  ConnectedPull lines{BrushOptions{}};
  lines.keep_shape(moved.stroke);
  lines.keep_shape(to.stroke);
  if (place == MeetingPlace::kAtTarget) lines.release(moved);
  lines.release(moved, to.stroke);  // the end leaves its place on the line whose end it goes to
  const auto complete = [&](Edit& edit) {
    const bool both_move = place == MeetingPlace::kHalfWay &&
                           std::any_of(edit.changes.begin(), edit.changes.end(),
                                       [&](const StrokeChange& c) { return c.id == to.stroke; });
    if (!both_move) lines.release(to);  // the target stays
    lines.complete(edit, scene);
  };
  return connect_ends(
      scene.document, moved, to,
      {.place = place, .keep_separate = settings_.keep_separate, .complete = complete});
}

Edit ConnectTool::tap(const Scene& scene) const {
  const Drag& d = *drag_;
  if (d.is_long || !snaps(settings_.snap.mode)) return {};
  const auto other = partner({d.tip, d.from}, scene);
  if (!other) return {};
  return connect(other->id, MeetingPlace::kHalfWay, scene);
}

ToolResult ConnectTool::end(const Scene& scene) {
  if (!drag_) return {};
  const Drag& d = *drag_;
  Edit edit;
  if (!d.is_pulled) {
    edit = tap(scene);
  } else if (d.edit && (d.on || (d.extend && d.at != d.from))) {
    edit = *d.edit;
  }
  released_at_ = d.pen_from + (d.at - d.from);
  drop();
  ToolResult result;
  if (!edit.empty()) result.commit = std::move(edit);
  return result;
}

void ConnectTool::drop() {
  drag_.reset();
  finder_.reset();
  shown_.clear();
  partner_.reset();
}

ForceModel ConnectTool::force(const Scene& scene) const {
  ConnectFeel feel;
  if (drag_) {
    feel.dragged_from = drag_->pen_from;
    if (finder_.target() && attracts(settings_.snap.mode)) {
      // Attracts the pen to the point at which the end lies on the target.
      feel.well = finder_.target()->point + (drag_->pen_from - drag_->from);
    }
  } else if (!in_gesture() && near_ && !is_waiting() && !released_at_ && !shown_.empty() &&
             attracts(settings_.snap.mode)) {
    feel.well = shown_.front().point;
  }
  return make_connect_force(settings_, scene, feel);
}

void ConnectTool::draw(Overlay& overlay) const {
  if (drag_) return draw_drag(overlay);
  if (!in_gesture() && !is_waiting() && near_) draw_hover(overlay);
}

void ConnectTool::draw_hover(Overlay& overlay) const {
  for (const TipHit& hit : shown_) overlay.dots.push_back({hit.point, Overlay::Role::kHandle});
  if (shown_.empty()) return;
  const Point tip = shown_.front().point;
  overlay.rings.push_back({tip, kTipRingMm, Overlay::Role::kSelected});
  if (partner_) {
    overlay.dots.push_back({partner_->point, Overlay::Role::kSnap});
    overlay.lines.push_back({tip, partner_->point, Overlay::Role::kGuide});
  }
}

void ConnectTool::draw_drag(Overlay& overlay) const {
  const Drag& d = *drag_;
  overlay.dots.push_back({d.at, Overlay::Role::kHandle});
  if (d.is_pulled) overlay.lines.push_back({d.from, d.at, Overlay::Role::kVector});
  const auto& target = finder_.target();
  if (!target) return;
  const SnapOptions& snap = settings_.snap;
  overlay.dots.push_back({target->point, Overlay::Role::kSnap});
  if (attracts(snap.mode)) {
    overlay.rings.push_back({target->point, snap.reach_mm, Overlay::Role::kReach});
  }
  if (!snaps(snap.mode)) return;
  overlay.rings.push_back({target->point, snap.radius_mm, Overlay::Role::kSnap});
  if (d.on && d.edit) overlay.labels.push_back({target->point, d.edit->label});
}

}  // namespace felt
