#include "desktop/pens/pen_hand.h"

#include <algorithm>
#include <utility>

#include "felt/haptics/pen_sample.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

/// Time after which the session has handled a lift of the pen, if it has handled the touch before:
/// the hand's positions are played with a delay of up to 15 ms (AimTrack).
constexpr std::int64_t kLiftSeenNs = 20'000'000;
/// Time after which a touch that the session has not handled is given up. A simulated body may have
/// a long way to the place of the touch (LandingWait).
constexpr std::int64_t kTouchSeenNs = 800'000'000;

std::uint32_t bit_of(ButtonRole role) {
  return 1U << static_cast<unsigned>(role);
}

/// Returns the tool that a button borrows, or null if it borrows no tool.
const Tool* tool_of(ButtonRole role, const Session& session) {
  switch (role) {
    case ButtonRole::kEraser:
      return session.first_tool(ToolKind::kErases);
    case ButtonRole::kPull:
      return session.first_tool(ToolKind::kEdits);
    case ButtonRole::kLasso:
      return session.first_tool(ToolKind::kSelects);
    default:
      return nullptr;
  }
}

std::uint32_t modifier_of(ButtonRole role) {
  if (role == ButtonRole::kFirstModifier) return kFirstModifier;
  return role == ButtonRole::kSecondModifier ? kSecondModifier : 0;
}

}  // namespace

PenHand::PenHand(Canvas& canvas) : canvas_(canvas), studio_(canvas.studio()) {
  connect(&studio_, &Studio::shown, this, &PenHand::settle);
  connect(&studio_, &Studio::sampled, this, &PenHand::on_sample);
}

/// Notes touches and lifts as the session handles them.
void PenHand::on_sample(const PenSample& sample) {
  const bool touches = in_contact(sample);
  if (std::exchange(session_touches_, touches) == touches) return;
  if (touches) {
    touches_owed_ = std::max(0, touches_owed_ - 1);
  } else {
    seen_lift_ns_ = sample.time_ns;
  }
}

bool PenHand::point(Source source, QPointF px, std::int64_t time_ns, bool touching,
                    std::optional<double> pressure, std::optional<double> tilt_deg) {
  return point_mm(source, canvas_.view().to_mm(px), time_ns, touching, pressure, tilt_deg);
}

bool PenHand::point_mm(Source source, Point mm, std::int64_t time_ns, bool touching,
                       std::optional<double> pressure, std::optional<double> tilt_deg) {
  if (down_ && source != source_) {
    if (source_ == Source::kTablet || (!touching && source != Source::kTablet)) return false;
    lift();
  }
  source_ = source;
  place_ = mm;
  is_known_ = true;
  pressure_ = pressure;
  tilt_deg_ = tilt_deg;
  if (touching && !down_) give_back(true);
  const bool changes = std::exchange(down_, touching) != touching;
  if (changes && touching) ++touches_owed_;
  if (changes && !touching) lifted_ns_ = std::max(time_ns, studio_.now_ns());
  send(time_ns);
  if (changes) Q_EMIT down_changed(touching);
  return true;
}

Point PenHand::place_mm() const {
  if (is_known_) return place_;
  const QSizeF size = canvas_.view().size();
  return canvas_.view().to_mm({size.width() / 2, size.height() / 2});
}

void PenHand::lift() {
  if (down_) point_mm(source_, place_, studio_.now_ns(), false, pressure_, tilt_deg_);
}

void PenHand::cancel() {
  studio_.apply(CancelEvent{});
  lift();
}

void PenHand::send(std::int64_t time_ns) {
  studio_.point({time_ns, place_, down_, down_ ? pressure_ : std::nullopt, buttons(), tilt_deg_});
}

/// Sends a change of the modifiers as an event, because they take effect even while the pen rests.
void PenHand::send_buttons(std::uint32_t before) {
  if (is_known_ && buttons() != before) send(studio_.now_ns());
}

void PenHand::press(ButtonRole role) {
  if (const std::uint32_t modifier = modifier_of(role)) {
    const std::uint32_t before = buttons();
    held_ |= modifier;
    return send_buttons(before);
  }
  if (role == ButtonRole::kUndo) studio_.apply(UndoEvent{});
  if (role == ButtonRole::kPopup) Q_EMIT canvas_.popup_wanted(canvas_.view().to_px(place_mm()));
  if (role == ButtonRole::kRing) Q_EMIT canvas_.ring_wanted(canvas_.view().to_px(place_mm()));
  const Tool* tool = tool_of(role, studio_.session());
  if (!tool || (borrowing_ & bit_of(role))) return;
  give_back(true);
  borrowing_ |= bit_of(role);
  const std::string_view id = tool->info().id;
  studio_.borrow_tool(QString::fromUtf8(id.data(), qsizetype(id.size())));
}

void PenHand::release(ButtonRole role) {
  if (const std::uint32_t modifier = modifier_of(role)) {
    const std::uint32_t before = buttons();
    held_ &= ~modifier;
    return send_buttons(before);
  }
  if (!(borrowing_ & bit_of(role))) return;
  borrowing_ &= ~bit_of(role);
  ++owed_;
  settle();
}

void PenHand::release_all() {
  for (const ButtonRole role : button_roles()) release(role);
}

void PenHand::set_keys(Qt::KeyboardModifiers keys) {
  const std::uint32_t before = buttons();
  keys_ = (keys.testFlag(Qt::ShiftModifier) ? kFirstModifier : 0) |
          (keys.testFlag(Qt::ControlModifier) ? kSecondModifier : 0) |
          (keys.testFlag(Qt::AltModifier) ? kThirdModifier : 0);
  send_buttons(before);
}

void PenHand::set_locked(std::uint32_t bits) {
  const std::uint32_t before = buttons();
  locked_ = bits;
  send_buttons(before);
}

void PenHand::give_back(bool at_once) {
  const PenState& pen = studio_.pen();
  const std::int64_t wait_ns = touches_owed_ > 0 ? kTouchSeenNs : kLiftSeenNs;
  const bool seen =
      !down_ && !in_contact(pen.sample) &&
      (!pen.is_known || pen.sample.time_ns >= std::max(lifted_ns_, seen_lift_ns_) + wait_ns);
  if (!at_once && !seen) return;
  for (int n = std::exchange(owed_, 0); n > 0; --n) studio_.give_back_tool();
}

void PenHand::settle() {
  if (owed_ > 0) give_back(false);
}

}  // namespace felt::desktop
