#include "desktop/window/eyedropper.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <algorithm>
#include <cmath>

#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "felt/fill/curve_area.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr double kReachPx = 4.0;

/// The nearest ink of the lines that were searched, and its distance from the point.
struct NearestInk {
  std::optional<PickedInk> ink;
  double distance_mm;
};

/// Replaces `best` if a line is nearer to the point.
void search(const Stroke& line, Point at, NearestInk& best) {
  if (!line.bounds().inflated(best.distance_mm).contains(at)) return;
  for (int i = 0; i < line.segment_count(); ++i) {
    const Nearest near = nearest(line.segment(i), at);
    const double width_mm = line.width_mm(i + near.t);
    const double gap_mm = std::max(0.0, std::sqrt(near.distance_squared) - 0.5 * width_mm);
    if (best.ink ? gap_mm >= best.distance_mm : gap_mm > best.distance_mm) continue;
    best = {PickedInk{line.color(), line.medium(), width_mm}, gap_mm};
  }
}

bool covers(const Fill& fill, Point at) {
  bool is_inside_all = false;  // by the even-odd rule
  for (const FillLoop& loop : fill.loops) is_inside_all ^= is_inside(loop.points, at);
  return is_inside_all;
}

}  // namespace

std::optional<PickedInk> ink_at(const Document& document, Point at, double reach_mm) {
  NearestInk best{std::nullopt, reach_mm};
  const std::span<const Layer> layers = document.layers();
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    if (!layer->visible) continue;
    for (auto id = layer->strokes.rbegin(); id != layer->strokes.rend(); ++id) {
      search(*document.find(*id), at, best);
      if (best.ink && best.distance_mm == 0.0) return best.ink;
    }
    for (auto id = layer->fills.rbegin(); id != layer->fills.rend(); ++id) {
      const FillPtr fill = document.find_fill(*id);
      if (covers(*fill, at)) return PickedInk{fill->color, {}, 0.0};
    }
  }
  return best.ink;
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
  const std::optional<PickedInk> ink = ink_at(studio_.session().seen(), at, reach_mm);
  if (!ink) {
    Q_EMIT studio_.refused(tr("There is no line or filled area under the pen."));
    return false;
  }
  if (what == What::kAll && !ink->medium.empty()) take_medium_and_width(*ink);
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
