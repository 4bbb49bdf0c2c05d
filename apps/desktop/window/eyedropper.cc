#include "desktop/window/eyedropper.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <algorithm>
#include <cmath>

#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr double kReachPx = 4.0;

}  // namespace

std::optional<PickedInk> ink_at(const Document& document, Point at, double reach_mm) {
  const std::vector<StrokePtr> strokes = visible_strokes(document);
  std::optional<PickedInk> found;
  double least_mm = reach_mm;  // distance of the point from the ink that was found
  for (auto stroke = strokes.rbegin(); stroke != strokes.rend(); ++stroke) {
    const Stroke& line = **stroke;
    if (!line.bounds().inflated(reach_mm).contains(at)) continue;
    for (int i = 0; i < line.segment_count(); ++i) {
      const Nearest near = nearest(line.segment(i), at);
      const double width_mm = line.width_mm(i + near.t);
      const double gap_mm = std::max(0.0, std::sqrt(near.distance_squared) - 0.5 * width_mm);
      if (found ? gap_mm >= least_mm : gap_mm > least_mm) continue;
      least_mm = gap_mm;
      found = PickedInk{line.color(), line.medium(), width_mm};
    }
    if (found && least_mm == 0.0) return found;
  }
  return found;
}

Eyedropper::Eyedropper(Actions& actions, Canvas& canvas)
    : QObject(&canvas), canvas_(canvas), studio_(canvas.studio()) {
  actions.add(QStringLiteral("edit.pick_color"), tr("&Pick a colour"), {QKeySequence(Qt::Key_I)},
              tr("Uses the colour of the line under the pen, or of the line that you click"),
              [this] { start(What::kColor); });
  actions.add(QStringLiteral("edit.pick_all"), tr("Pick colour, &medium and width"),
              {QKeySequence(Qt::SHIFT | Qt::Key_I)},
              tr("Draws on as the line under the pen, or as the line that you click"),
              [this] { start(What::kAll); });
}

/// Picks at the nib if it is on the page. If the user has clicked a button or a menu, the nib is
/// not shown, and the next click on the page picks.
void Eyedropper::start(What what) {
  if (armed_) return disarm();
  if (canvas_.place_text().isEmpty()) return arm(what);
  pick(studio_.pen().hand, what);
}

bool Eyedropper::pick(Point at, What what) {
  const double reach_mm = kReachPx / canvas_.view().px_per_mm();
  const std::optional<PickedInk> ink = ink_at(studio_.session().document(), at, reach_mm);
  if (!ink) {
    Q_EMIT studio_.refused(tr("There is no line under the pen."));
    return false;
  }
  if (what == What::kAll) take_medium_and_width(*ink);
  const std::string color = color_to_text(ink->color);
  studio_.apply(SetOption{kInkColorId, color});
  if (!studio_.session().selection().empty()) {
    studio_.apply(
        RestyleEvent{.color = color, .medium = what == What::kAll ? ink->medium : std::string()});
  }
  return true;
}

void Eyedropper::take_medium_and_width(const PickedInk& ink) {
  if (!take_medium(studio_, ink.medium)) return;
  const Tool* tool = studio_.session().first_tool(ToolKind::kDraws);
  if (!tool) return;
  for (const auto& [option, value] : tool->options_for_size(ink.width_mm)) {
    studio_.apply(SetOption{std::string(tool->info().id) + "." + std::string(option), value});
  }
}

void Eyedropper::arm(What what) {
  if (!armed_) canvas_.installEventFilter(this);  // before the filter of the pen
  armed_ = what;
  canvas_.setCursor(QCursor(icon_of("pick-color").pixmap(24, 24), 3, 21));
  canvas_.setFocus();
  Q_EMIT studio_.refused(tr("Click a line to use its colour. Escape ends this."));
}

void Eyedropper::disarm() {
  armed_.reset();
  canvas_.removeEventFilter(this);
  canvas_.setCursor(canvas_.pen_cursor());
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_ || !armed_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
      [[fallthrough]];
    case QEvent::TabletPress:
      return true;
    case QEvent::MouseButtonRelease:
    case QEvent::TabletRelease: {
      const auto* pointer = static_cast<QSinglePointEvent*>(event);
      const bool is_all = pointer->modifiers().testFlag(Qt::ShiftModifier);
      const What what = is_all ? What::kAll : *armed_;
      disarm();
      pick(canvas_.view().to_mm(pointer->position()), what);
      return true;
    }
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
      event->accept();
      if (event->type() == QEvent::KeyPress) disarm();
      return true;
    default:
      return false;
  }
}

}  // namespace felt::desktop
