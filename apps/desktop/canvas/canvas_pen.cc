#include <QCoreApplication>
#include <QKeySequence>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "desktop/canvas/canvas.h"
#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/canvas/canvas_shown.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/tool_size.h"
#include "desktop/engine/tool_texts.h"

namespace felt::desktop {
namespace {

constexpr double kFeltN = 0.02;   // smallest force that the user should feel
constexpr double kShrink = 0.35;  // share by which an attraction of 1 N shrinks the nib

/// Returns the width of the line that a mouse would draw, or 0 if the current tool draws no line.
double drawn_width_mm(const Session& session) {
  const ToolKind kind = session.tool().info().kind;
  if (kind != ToolKind::kDraws && kind != ToolKind::kShapes) return 0.0;
  const std::optional<ToolSize> size = tool_size(session);
  return size ? size->mm : 0.0;
}

/// Returns the system's name of a modifier key, such as "Shift".
QString key_name(Qt::KeyboardModifier modifier) {
  QString name = QKeySequence(static_cast<int>(modifier)).toString(QKeySequence::NativeText);
  while (name.endsWith(QLatin1Char('+'))) name.chop(1);
  return name;
}

}  // namespace

void Canvas::set_pen_visible(bool visible) {
  if (pen_visible_ == visible) return;
  pen_visible_ = visible;
  refresh_soon();
}

void Canvas::set_tablet_in_hand(bool tablet) {
  tablet_in_hand_ = tablet;
}

void Canvas::set_pen_status(const QString& status) {
  pen_status_ = status;
  take_status();
}

PenMark Canvas::pen_mark(const PenState& pen) {
  Shown& s = *shown_;
  const bool has_force = studio_.loop().device().device().capabilities().has_force();
  const Force force = !studio_.loop().forces_are_on() ? Force{} : has_force ? pen.sent : pen.asked;
  const Point stylus{pen.sample.position.x, pen.sample.position.y};
  Point nib = stylus;
  const double pull_n = std::hypot(force.x, force.y);
  if (has_force && studio_.loop().device().hand()) {
    using Use = PseudoCursor::Use;
    const Use use = tablet_in_hand_ && !s.wet.is_empty()        ? Use::kTabletInk
                    : in_contact(pen.sample) || pull_n > kFeltN ? Use::kFeeling
                                                                : Use::kInAir;
    PseudoCursorOptions options;
    options.on =
        Settings::the().flag(canvas_keys::kPseudoHaptics, canvas_keys::kPseudoHapticsDefault);
    s.cursor.set_options(options);
    const std::int64_t now_ns = studio_.now_ns();
    nib = s.cursor.update(pen.hand, stylus, use, 1e-9 * static_cast<double>(now_ns - s.cursor_ns));
    s.cursor_ns = now_ns;
  }
  PenMark mark{view_.to_px(pen.hand), view_.to_px(nib)};
  if (!has_force) mark.hand = mark.nib;
  mark.radius = nib_radius_px(pull_n);
  if (Settings::the().flag(canvas_keys::kForceArrow, canvas_keys::kForceArrowDefault)) {
    const QPointF to = view_.to_px(nib + Vec{force.x, force.y});
    mark.force_n = (to - mark.nib) / view_.px_per_mm();
    mark.out_n = force.z;
  }
  return mark;
}

/// Returns the radius of the dot that the tool would draw; smaller if something attracts the pen.
/// Returns 0 while ink flows. Also returns 0 for tools that do not draw, because these show their
/// reach themselves.
double Canvas::nib_radius_px(double pull_n) const {
  const Session& session = studio_.session();
  const Shown& s = *shown_;
  const double width = drawn_width_mm(session);
  if (width <= 0.0 || !s.wet.is_empty()) return 0.0;
  const bool attracts = std::any_of(s.overlay.rings.begin(), s.overlay.rings.end(),
                                    [](const auto& r) { return r.role == Overlay::Role::kSnap; });
  const double shrunk = attracts ? 1.0 - kShrink * std::min(1.0, pull_n) : 1.0;
  return std::max(2.5, 0.5 * width * view_.px_per_mm() * shrunk);
}

/// Shows the size of the current tool for kSizeMs after it changed.
void Canvas::show_size(const QString& option_id) {
  const bool is_size = option_id.endsWith(QLatin1String("_width_mm")) ||
                       option_id.endsWith(QLatin1String("radius_mm"));
  if (!is_size || !isVisible() || drawn_width_mm(studio_.session()) <= 0.0) return;
  shown_->size_ring.start();
  refresh_soon();
}

/// Adds the ring around the pointer, or in the middle if the pointer is not over the canvas.
void Canvas::add_size_ring() {
  const PenState& pen = studio_.pen();
  const Point at =
      pen_visible_ && pen.is_known ? pen.hand : view_.to_mm({0.5 * width(), 0.5 * height()});
  const double width_mm = drawn_width_mm(studio_.session());
  shown_->overlay.rings.push_back({at, 0.5 * width_mm, Overlay::Role::kHandle});
  shown_->overlay.labels.push_back(
      {at, tr("%1 mm").arg(QLocale().toString(width_mm, 'g', 2)).toStdString()});
}

// --- Texts

QString Canvas::hint() const {
  if (studio_.is_touching()) {
    return tr("Hold the pen against the body, and move along it. The pen draws nothing.");
  }
  const ToolUse use = studio_.session().tool().use();
  QString hint = translated(use.hint);
  const auto add = [&hint](Qt::KeyboardModifier modifier, std::string_view what) {
    if (what.empty()) return;
    //: a key that is held, and what it does: "Shift: thinner"
    const QString words = QCoreApplication::translate("ToolHint", "%1: %2");
    hint += QStringLiteral("   ") + words.arg(key_name(modifier), translated(what));
  };
  add(Qt::ShiftModifier, use.first_modifier);
  add(Qt::ControlModifier, use.second_modifier);
  add(Qt::AltModifier, use.third_modifier);
  if (right_button_.isEmpty()) return hint;
  return hint + QStringLiteral("   ") + tr("Right button: %1").arg(right_button_);
}

void Canvas::set_right_button(const QString& what) {
  if (std::exchange(right_button_, what) != what) Q_EMIT hint_changed();
}

QString Canvas::place_text() const {
  const PenState& pen = studio_.pen();
  if (!pen_visible_ || !pen.is_known) return {};
  const QLocale locale;
  return tr("%1, %2 mm")
      .arg(locale.toString(pen.hand.x, 'f', 1), locale.toString(pen.hand.y, 'f', 1));
}

QString Canvas::view_text() const {
  QStringList parts{tr("%1 %").arg(qRound(100.0 * zoom()))};
  const int angle = qRound(view_.angle_deg());
  if (angle != 0) parts << tr("%1°").arg(angle);
  if (view_.is_mirrored()) parts << tr("mirrored");
  return parts.join(QStringLiteral(", "));
}

bool Canvas::shows_first_minute() const {
  const Session& session = studio_.session();
  const Document& document = session.document();
  const auto layers = document.layers();
  const bool is_empty =
      document.stroke_count() == 0 && document.fill_count() == 0 &&
      std::none_of(layers.begin(), layers.end(), [](const Layer& l) { return l.picture; });
  return has_first_hints_ && is_empty && !session.gesture_in_progress() &&
         shown_->overlay.ink.empty() && !shown_->wet.is_drying();
}

bool Canvas::shows_first_hints() const {
  return shown_->shows_first_minute;
}

QRect Canvas::first_hints_area() const {
  return shown_->first_minute.area(size(), font());
}

void Canvas::hide_first_hints() {
  has_first_hints_ = false;
  refresh_soon();
}

void Canvas::take_status() {
  Shown& s = *shown_;
  QString status = pen_status_;
  if (status.isEmpty()) {
    status = pressure_seen_ ? tr("Pressure is recognised.")
                            : tr("No pressure recognised yet. A mouse draws lines of even width.");
  }
  const Tool* edits = studio_.session().first_tool(ToolKind::kEdits);
  s.first_minute.set_text(edits ? edits->info().shortcut : 'a', status);
  setAccessibleDescription(s.shows_first_minute ? s.first_minute.spoken()
                                                : tr("The area to draw on"));
  update(s.first_minute.area(size(), font()));
}

}  // namespace felt::desktop
