#include "desktop/canvas/view_actions.h"

#include <QCoreApplication>
#include <utility>

#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/engine/settings.h"

namespace felt::desktop {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kTurnStepDeg = 15.0;
constexpr double kScrollShare = 0.15;  // relative to the shorter side of the canvas

QString view_text(const char* text) {
  return QCoreApplication::translate("ViewActions", text);
}

using Change = void (*)(CanvasView&, QPointF anchor);

/// Adds an action that changes the view.
void add_look(Actions& actions, Canvas& canvas, const char* name, const char* text,
              const QList<QKeySequence>& keys, const char* tip, Change change) {
  actions.add(QString::fromLatin1(name), view_text(text), keys, view_text(tip), [&canvas, change] {
    CanvasView view = canvas.view();
    change(view, canvas.anchor());
    canvas.set_view(view);
  });
}

double scroll_px(const CanvasView& view) {
  return kScrollShare * std::min(view.size().width(), view.size().height());
}

void add_zooming(Actions& actions, Canvas& canvas) {
  add_look(actions, canvas, "view.zoom_in", QT_TRANSLATE_NOOP("ViewActions", "Zoom &in"),
           {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal), QKeySequence::ZoomIn},
           QT_TRANSLATE_NOOP("ViewActions", "Shows the drawing larger, around the pointer"),
           [](CanvasView& view, QPointF at) { view.zoom(kZoomStep, at); });
  add_look(actions, canvas, "view.zoom_out", QT_TRANSLATE_NOOP("ViewActions", "Zoom &out"),
           {QKeySequence(Qt::Key_Minus), QKeySequence::ZoomOut},
           QT_TRANSLATE_NOOP("ViewActions", "Shows the drawing smaller, around the pointer"),
           [](CanvasView& view, QPointF at) { view.zoom(1.0 / kZoomStep, at); });
  actions.add(QStringLiteral("view.zoom_100"),
              view_text(QT_TRANSLATE_NOOP("ViewActions", "&Life size")), {QKeySequence(Qt::Key_1)},
              view_text(QT_TRANSLATE_NOOP(
                  "ViewActions", "One millimetre of the drawing is one millimetre on the screen")),
              [&canvas] { canvas.set_zoom(1.0); });
  actions.add(
      QStringLiteral("view.fit_selection"),
      view_text(QT_TRANSLATE_NOOP("ViewActions", "Fit &selection")), {QKeySequence(Qt::Key_2)},
      view_text(QT_TRANSLATE_NOOP("ViewActions", "Shows the selection as large as possible")),
      [&canvas] { canvas.fit_selection(); });
  actions.add(QStringLiteral("view.fit_page"),
              view_text(QT_TRANSLATE_NOOP("ViewActions", "Fit &page")),
              {QKeySequence(Qt::Key_3), QKeySequence(Qt::Key_0)},
              view_text(QT_TRANSLATE_NOOP("ViewActions", "Shows the whole page")),
              [&canvas] { canvas.fit_page(); });
  actions.add(
      QStringLiteral("view.fit_ink"), view_text(QT_TRANSLATE_NOOP("ViewActions", "Fit &drawing")),
      {QKeySequence(Qt::Key_7)},
      view_text(QT_TRANSLATE_NOOP("ViewActions", "Shows all ink, including any outside the page")),
      [&canvas] { canvas.fit_ink(); });
}

void add_turning(Actions& actions, Canvas& canvas) {
  add_look(
      actions, canvas, "view.rotate_left", QT_TRANSLATE_NOOP("ViewActions", "Turn l&eft"),
      {QKeySequence(Qt::Key_4), QKeySequence(Qt::CTRL | Qt::Key_BracketLeft)},
      QT_TRANSLATE_NOOP("ViewActions", "Turns the view anticlockwise; the drawing does not change"),
      [](CanvasView& view, QPointF at) { view.turn(-kTurnStepDeg, at); });
  add_look(
      actions, canvas, "view.rotate_right", QT_TRANSLATE_NOOP("ViewActions", "Turn ri&ght"),
      {QKeySequence(Qt::Key_6), QKeySequence(Qt::CTRL | Qt::Key_BracketRight)},
      QT_TRANSLATE_NOOP("ViewActions", "Turns the view clockwise; the drawing does not change"),
      [](CanvasView& view, QPointF at) { view.turn(kTurnStepDeg, at); });
  add_look(actions, canvas, "view.rotate_reset", QT_TRANSLATE_NOOP("ViewActions", "&Upright"),
           {QKeySequence(Qt::Key_5)},
           QT_TRANSLATE_NOOP("ViewActions", "Turns the view back upright"),
           [](CanvasView& view, QPointF at) { view.turn(-view.angle_deg(), at); });
  add_look(
      actions, canvas, "view.mirror", QT_TRANSLATE_NOOP("ViewActions", "&Mirror view"),
      {QKeySequence(Qt::Key_M)},
      QT_TRANSLATE_NOOP(
          "ViewActions",
          "Swaps left and right in the view, to check proportions; the drawing does not change"),
      [](CanvasView& view, QPointF) { view.mirror(); });
}

void add_scrolling(Actions& actions, Canvas& canvas) {
  add_look(actions, canvas, "view.scroll_left", QT_TRANSLATE_NOOP("ViewActions", "Scroll left"),
           {QKeySequence(Qt::ALT | Qt::Key_Left)},
           QT_TRANSLATE_NOOP("ViewActions", "Moves the view to the left"),
           [](CanvasView& view, QPointF) {
             view.pan({scroll_px(view), 0});
           });
  add_look(actions, canvas, "view.scroll_right", QT_TRANSLATE_NOOP("ViewActions", "Scroll right"),
           {QKeySequence(Qt::ALT | Qt::Key_Right)},
           QT_TRANSLATE_NOOP("ViewActions", "Moves the view to the right"),
           [](CanvasView& view, QPointF) {
             view.pan({-scroll_px(view), 0});
           });
  add_look(actions, canvas, "view.scroll_up", QT_TRANSLATE_NOOP("ViewActions", "Scroll up"),
           {QKeySequence(Qt::ALT | Qt::Key_Up), QKeySequence(Qt::Key_PageUp)},
           QT_TRANSLATE_NOOP("ViewActions", "Moves the view up"), [](CanvasView& view, QPointF) {
             view.pan({0, scroll_px(view)});
           });
  add_look(actions, canvas, "view.scroll_down", QT_TRANSLATE_NOOP("ViewActions", "Scroll down"),
           {QKeySequence(Qt::ALT | Qt::Key_Down), QKeySequence(Qt::Key_PageDown)},
           QT_TRANSLATE_NOOP("ViewActions", "Moves the view down"), [](CanvasView& view, QPointF) {
             view.pan({0, -scroll_px(view)});
           });
}

/// Adds a switch for a setting. The canvas follows the setting.
void add_setting(Actions& actions, const char* name, const char* text, const char* tip,
                 const char* key, bool fallback) {
  const QString setting = QString::fromLatin1(key);
  QAction* action = actions.add_switch(QString::fromLatin1(name), view_text(text), {},
                                       view_text(tip), Settings::the().flag(setting, fallback),
                                       [setting](bool on) { Settings::the().set(setting, on); });
  QObject::connect(&Settings::the(), &Settings::changed, action, [=](const QString& changed) {
    if (changed == setting) action->setChecked(Settings::the().flag(setting, fallback));
  });
}

void add_switches(Actions& actions, Canvas& canvas) {
  actions.add_switch(
      QStringLiteral("view.outline"), view_text(QT_TRANSLATE_NOOP("ViewActions", "Ou&tlines")),
      {QKeySequence(Qt::Key_O)},
      view_text(QT_TRANSLATE_NOOP("ViewActions", "Shows only the centre line of each stroke")),
      false, [&canvas](bool on) { canvas.set_outline_mode(on); });
  add_setting(
      actions, "view.force_arrow", QT_TRANSLATE_NOOP("ViewActions", "&Force arrow"),
      QT_TRANSLATE_NOOP("ViewActions", "Shows the direction and size of the force at the nib"),
      canvas_keys::kForceArrow, canvas_keys::kForceArrowDefault);
  add_setting(actions, "view.pseudo_haptics",
              QT_TRANSLATE_NOOP("ViewActions", "&Nib moves with forces"),
              QT_TRANSLATE_NOOP("ViewActions",
                                "With a simulated stylus, shows the nib where forces move it"),
              canvas_keys::kPseudoHaptics, canvas_keys::kPseudoHapticsDefault);
  add_setting(actions, "view.grain", QT_TRANSLATE_NOOP("ViewActions", "G&rain of the surface"),
              QT_TRANSLATE_NOOP("ViewActions", "Dry media show the relief of the surface"),
              canvas_keys::kGrain, canvas_keys::kGrainDefault);
}

}  // namespace

void add_view_actions(Actions& actions, Canvas& canvas) {
  add_zooming(actions, canvas);
  add_turning(actions, canvas);
  add_scrolling(actions, canvas);
  add_switches(actions, canvas);
}

}  // namespace felt::desktop
