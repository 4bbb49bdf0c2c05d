#include "desktop/window/first_steps.h"

#include <QAccessible>
#include <QAction>
#include <QEvent>
#include <algorithm>

#include "desktop/engine/settings.h"
#include "desktop/engine/tool_texts.h"
#include "desktop/window/window_setting_keys.h"
#include "felt/haptics/pen_sample.h"

namespace felt::desktop {
namespace {

constexpr int kBesideLinePx = 14, kHintMarginPx = 4, kBelowHintsPx = 10;

/// Returns the tool that the hint is about, or null.
const Tool* pull_tool(const Session& session) {
  return session.first_tool(ToolKind::kEdits);
}

}  // namespace

PullHint::PullHint(const Actions& actions, Canvas& canvas)
    : QLabel(&canvas), actions_(actions), canvas_(canvas), studio_(canvas.studio()) {
  setObjectName(QStringLiteral("pull_hint"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  setForegroundRole(QPalette::ToolTipText);
  setMargin(kHintMarginPx);
  setTextFormat(Qt::PlainText);
  hide();
  connect(&studio_, &Studio::edited, this, &PullHint::on_edit);
  connect(&studio_, &Studio::shown, this, &PullHint::follow);
  connect(&studio_, &Studio::opened, this, [this] {
    at_.reset();
    follow();
  });
  connect(&canvas, &Canvas::view_changed, this, &PullHint::place);
}

void PullHint::on_edit(const Edit& edit) {
  at_.reset();
  const Tool* pull = pull_tool(studio_.session());
  if (!pull || Settings::the().flag(window_keys::kHasPulled, false)) return;
  const ToolInfo& info = studio_.session().tool().info();
  const bool has_one = edit.changes.size() == 1 && edit.changes.front().after;
  if (info.id == pull->info().id) {
    const bool pulls = !edit.changes.empty() && edit.changes.front().before;
    return pulls ? Settings::the().set(window_keys::kHasPulled, true) : void();
  }
  const bool is_new_line = has_one && !edit.changes.front().before;
  if (info.kind != ToolKind::kDraws || !is_new_line || times_ >= kMaxTimes) return;
  const Stroke& line = *edit.changes.front().after;
  at_ = line.position(line.segment_count());
}

/// Shows or hides the hint. A choice at the pen (OfferPopup) is at the same place and goes first.
void PullHint::follow() {
  const Tool* pull = pull_tool(studio_.session());
  const bool is_down = in_contact(studio_.pen().sample) || studio_.session().gesture_in_progress();
  if (is_down || studio_.session().offered()) at_.reset();
  if (!at_ || !pull) return hide();
  if (isVisible()) return;
  const QString id = QString::fromUtf8(pull->info().id.data(), qsizetype(pull->info().id.size()));
  const QAction* action = actions_.find(QStringLiteral("tool.") + id);
  const QString key = action ? action->shortcut().toString(QKeySequence::NativeText) : QString();
  setText(key.isEmpty()
              ? tr("Choose the tool %1 and pull this line").arg(translated(pull->info().label))
              : tr("Hold %1 and pull this line").arg(key));
  ++times_;
  place();
  show();
  raise();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void PullHint::place() {
  if (!at_) return;
  adjustSize();
  const QPointF end = canvas_.view().to_px(*at_);
  const auto inside = [](double wanted, int length, int room) {
    return std::clamp(int(wanted), 0, std::max(0, room - length));
  };
  const bool fits_right = end.x() + kBesideLinePx + width() <= canvas_.width();
  const double left = fits_right ? end.x() + kBesideLinePx : end.x() - kBesideLinePx - width();
  move(inside(left, width(), canvas_.width()),
       inside(end.y() + kBesideLinePx, height(), canvas_.height()));
}

ExampleButton::ExampleButton(QAction& example, Canvas& canvas)
    : QPushButton(tr("Show the sample cat"), &canvas), canvas_(canvas) {
  setObjectName(QStringLiteral("first_example"));
  setToolTip(tr("Opens a drawing to pull, erase and colour"));
  setCursor(Qt::ArrowCursor);
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QPushButton::clicked, &example, &QAction::trigger);
  connect(&canvas, &Canvas::first_hints_changed, this, &ExampleButton::follow);
  canvas.installEventFilter(this);
  follow();
}

void ExampleButton::follow() {
  const bool had_focus = hasFocus();
  const QRect hints = canvas_.first_hints_area();
  adjustSize();
  move((canvas_.width() - width()) / 2, hints.bottom() + kBelowHintsPx);
  setVisible(canvas_.shows_first_hints());
  if (had_focus && isHidden()) canvas_.setFocus();
}

bool ExampleButton::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &canvas_ && event->type() == QEvent::Resize) follow();
  return QPushButton::eventFilter(watched, event);
}

bool ExampleButton::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::TabletRelease:
      if (isDown()) click();
      [[fallthrough]];
    case QEvent::TabletPress:
      setDown(event->type() == QEvent::TabletPress);
      [[fallthrough]];
    case QEvent::TabletMove:
      event->accept();
      return true;
    default:
      return QPushButton::event(event);
  }
}

}  // namespace felt::desktop
