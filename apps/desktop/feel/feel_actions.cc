#include "desktop/feel/feel_actions.h"

#include <QActionGroup>
#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QMenu>
#include <QSignalBlocker>
#include <QWidget>

#include "desktop/engine/cue_player.h"
#include "desktop/engine/settings.h"
#include "desktop/feel/contour_finder.h"
#include "desktop/feel/feel_setting_keys.h"
#include "desktop/feel/friction_sound.h"
#include "desktop/feel/material_words.h"
#include "desktop/feel/safety_words.h"

namespace felt::desktop {
namespace {

constexpr double kStrengthStep = 0.1;
/// If another program gets the focus, the release of Escape may never be reported. Therefore the
/// key counts as released after this time.
constexpr int kForgetDownMs = 300;

QString material_of(const Studio& studio) {
  const std::string_view id = studio.session().surface().id;
  return QString::fromUtf8(id.data(), qsizetype(id.size()));
}

void restore(Studio& studio) {
  const Settings& settings = Settings::the();
  studio.loop().set_strength(settings.number(feel_keys::kStrength, feel_keys::kStrengthDefault));
  studio.loop().set_force_limit(
      settings.number(feel_keys::kForceLimit, feel_keys::kForceLimitDefault));
  const QString material = settings.text(feel_keys::kMaterial);
  if (studio.materials().find_surface(material.toStdString()) && material != material_of(studio)) {
    studio.apply(SetOption{"surface.material", OptionValue(material.toStdString())});
  }
}

void add_switch(Actions& actions, Studio& studio) {
  QAction* forces = actions.add(
      QStringLiteral("feel.forces"), QString(), {},
      QCoreApplication::translate("FeelActions", "Stops all forces, or switches them on"),
      [&studio] { studio.loop().set_forces(!studio.loop().forces_are_on()); });
  const auto say = [forces](bool on) {
    forces->setText(on ? QCoreApplication::translate("FeelActions", "Stop &forces")
                       : QCoreApplication::translate("FeelActions", "Switch &forces on"));
  };
  say(studio.loop().forces_are_on());
  QObject::connect(&studio.loop(), &HapticLoop::forces_changed, forces, say);
  actions.add(QStringLiteral("feel.forces_off"),
              QCoreApplication::translate("FeelActions", "Stop forces, &never start (Esc twice)"),
              {}, QCoreApplication::translate("FeelActions", "Stops all forces immediately"),
              [&studio] { studio.loop().set_forces(false); });
}

void add_strength(Actions& actions, Studio& studio) {
  actions.add(QStringLiteral("feel.stronger"),
              QCoreApplication::translate("FeelActions", "&Stronger forces"), {},
              QCoreApplication::translate("FeelActions", "All forces 10 % stronger"),
              [&studio] { choose_strength(studio, studio.loop().strength() + kStrengthStep); });
  actions.add(QStringLiteral("feel.weaker"),
              QCoreApplication::translate("FeelActions", "&Weaker forces"), {},
              QCoreApplication::translate("FeelActions", "All forces 10 % weaker"),
              [&studio] { choose_strength(studio, studio.loop().strength() - kStrengthStep); });
}

void add_materials(Actions& actions, Studio& studio, QWidget* window) {
  auto* group = new QActionGroup(window);
  for (const SurfaceMaterial& material : surface_materials()) {
    const QString id = QString::fromUtf8(material.id.data(), qsizetype(material.id.size()));
    QAction* action = actions.add_switch(QStringLiteral("feel.surface_") + id,
                                         material_label(material), {}, material_words(material),
                                         id == material_of(studio), [&studio, id](bool on) {
                                           if (on) choose_material(studio, id);
                                         });
    group->addAction(action);
    QObject::connect(&studio, &Studio::option_changed, action, [action, id, &studio] {
      if (id != material_of(studio) || action->isChecked()) return;
      action->setChecked(true);  // choosing the present surface again changes nothing
    });
  }
}  // the window owns the group: NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks)

bool is_own(const SurfaceMaterial& material) {
  return find_surface(material.id) == nullptr;
}

void fill_own_surfaces(QMenu& menu, Studio& studio) {
  menu.clear();
  for (const SurfaceMaterial& material : studio.materials().surfaces()) {
    if (!is_own(material)) continue;
    const QString id = QString::fromStdString(material.id);
    QAction* choice = menu.addAction(material_label(material));
    choice->setCheckable(true);
    choice->setChecked(id == material_of(studio));
    QObject::connect(choice, &QAction::triggered, &studio,
                     [&studio, id] { choose_material(studio, id); });
  }
}

/// Adds a submenu of the surfaces that the user made or that came with a drawing. It is visible if
/// such surfaces exist.
void add_own_surfaces(Actions& actions, Studio& studio, QWidget* window) {
  auto* menu = new QMenu(window);
  QAction* action =
      actions.add(QStringLiteral("feel.surface_own"),
                  QCoreApplication::translate("FeelActions", "M&y surfaces"), {},
                  QCoreApplication::translate("FeelActions",
                                              "Surfaces that you made or that came with a drawing"),
                  [menu] {
                    if (!menu->isEmpty())
                      menu->popup(QCursor::pos());  // triggered by a user-defined key
                  });
  action->setMenu(menu);
  const auto fill = [action, menu, &studio] {
    fill_own_surfaces(*menu, studio);
    action->setVisible(!menu->isEmpty());
  };
  fill();
  QObject::connect(menu, &QMenu::aboutToShow, menu, fill);
  QObject::connect(&studio, &Studio::materials_changed, menu, fill);
  QObject::connect(&studio, &Studio::opened, menu, fill);
}

void add_sound(Actions& actions, Studio& studio, QWidget* window) {
  if (!FrictionSound::is_built_in()) return;
  const QString key = QString::fromLatin1(feel_keys::kSound);
  const bool on = Settings::the().flag(key, feel_keys::kSoundDefault);
  new FrictionSound(studio, window);  // owned by the window; follows the setting
  QAction* action = actions.add_switch(
      QStringLiteral("feel.sound"), QCoreApplication::translate("FeelActions", "S&ound of drawing"),
      {}, QCoreApplication::translate("FeelActions", "Hear the pen rub on the surface"), on,
      [key](bool now) { Settings::the().set(key, now); });
  QObject::connect(&Settings::the(), &Settings::changed, action,
                   [action, key](const QString& which) {
                     if (which == key)
                       action->setChecked(Settings::the().flag(key, feel_keys::kSoundDefault));
                   });
}

/// Sets the edges that are felt: that of the page, that of the box around the selection, and the
/// contours of pictures.
void use_edges(Studio& studio, ContourFinder& finder) {
  const Settings& settings = Settings::the();
  finder.set_on(studio.session().device().has_force() &&
                settings.flag(feel_keys::kContours, feel_keys::kContoursDefault));
  UseEdges edges;
  if (settings.flag(feel_keys::kPageEdge, false)) edges.page = studio.page().area();
  edges.selection = settings.flag(feel_keys::kSelectionEdge, false);
  edges.contours = finder.contours();
  if (edges != studio.session().edges()) studio.apply(edges);
}

/// Adds switches for these edges.
void add_edges(Actions& actions, Studio& studio) {
  auto* finder = new ContourFinder(studio, &actions);
  const auto follow = [&studio, finder] { use_edges(studio, *finder); };
  const auto add = [&](const char* name, const char* setting, bool fallback, const QString& text,
                       const QList<QKeySequence>& keys, const QString& tip) {
    const QString key = QString::fromLatin1(setting);
    QAction* action = actions.add_switch(QString::fromLatin1(name), text, keys, tip,
                                         Settings::the().flag(key, fallback),
                                         [key](bool on) { Settings::the().set(key, on); });
    QObject::connect(&Settings::the(), &Settings::changed, action,
                     [action, key, fallback, follow](const QString& which) {
                       if (which != key) return;
                       action->setChecked(Settings::the().flag(key, fallback));
                       follow();
                     });
  };
  add("feel.page_edge", feel_keys::kPageEdge, false,
      QCoreApplication::translate("FeelActions", "&Edge of the page as a ridge"), {},
      QCoreApplication::translate("FeelActions",
                                  "Feel where the page ends, while the pen touches"));
  add("feel.selection_edge", feel_keys::kSelectionEdge, false,
      QCoreApplication::translate("FeelActions", "Box of the se&lection as a ridge"), {},
      QCoreApplication::translate("FeelActions",
                                  "Feel where the box around the selected lines ends"));
  if (ContourFinder::is_built_in()) {
    add("feel.contours", feel_keys::kContours, feel_keys::kContoursDefault,
        QCoreApplication::translate("FeelActions", "Lines of locked &pictures as grooves"),
        {QKeySequence(Qt::Key_J)},
        QCoreApplication::translate("FeelActions",
                                    "Feel the lines and edges of a picture in a locked layer, "
                                    "while you draw slowly along them"));
  }
  QObject::connect(finder, &ContourFinder::changed, finder, follow);
  QObject::connect(&studio, &Studio::opened, finder, follow);
  QObject::connect(&studio, &Studio::page_changed, finder, follow);
  QObject::connect(&studio.loop(), &HapticLoop::device_changed, finder, follow);
  follow();
}

/// Plays cues on a haptic pen, mouse or touchpad, if the user has chosen one.
void add_cues(Studio& studio, QWidget* window) {
  auto* cues = new CuePlayer(studio, window);
  QObject::connect(cues, &CuePlayer::refused, &studio, &Studio::refused);
}

/// Reports a fault that only the user can clear, and switches the forces off.
void watch_faults(Studio& studio, QWidget* window) {
  QObject::connect(&studio.loop(), &HapticLoop::ticked, window, [&studio](const TickReport& tick) {
    if (tick.safety.state != SafetyState::kLatched || !studio.loop().forces_are_on()) return;
    studio.loop().set_forces(false);
    const SafetyWords words =
        words_for(tick.safety, true, true, studio.loop().device_status().last_fault);
    Q_EMIT studio.refused(words.state + QStringLiteral(". ") + words.detail);
  });
}

}  // namespace

void add_feel_actions(Actions& actions, Studio& studio, QWidget* window) {
  restore(studio);
  add_switch(actions, studio);
  add_strength(actions, studio);
  add_materials(actions, studio, window);
  add_own_surfaces(actions, studio, window);
  add_edges(actions, studio);
  add_sound(actions, studio, window);
  add_cues(studio, window);
  watch_faults(studio, window);
  auto* escape = new DoubleEscape(window);
  QObject::connect(escape, &DoubleEscape::pressed_twice, &studio, [&studio] {
    if (!studio.loop().forces_are_on()) return;
    studio.loop().set_forces(false);
    Q_EMIT studio.refused(QCoreApplication::translate(
        "FeelActions", "Forces are off. Switch them on in the Feel panel."));
  });
}

void choose_material(Studio& studio, const QString& id) {
  if (id == material_of(studio)) return;
  if (!studio.apply(SetOption{"surface.material", OptionValue(id.toStdString())})) return;
  Settings::the().set(feel_keys::kMaterial, id);
}

void choose_strength(Studio& studio, double share) {
  studio.loop().set_strength(share);
  Settings::the().set(feel_keys::kStrength, studio.loop().strength());
}

DoubleEscape::DoubleEscape(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool DoubleEscape::eventFilter(QObject* watched, QEvent* event) {
  static_cast<void>(watched);
  const QEvent::Type type = event->type();
  const bool is_key =
      type == QEvent::KeyPress || type == QEvent::ShortcutOverride || type == QEvent::KeyRelease;
  const auto* key = is_key ? static_cast<const QKeyEvent*>(event) : nullptr;
  if (key != nullptr && key->key() == Qt::Key_Escape && !key->isAutoRepeat()) {
    if (type == QEvent::KeyRelease) {
      is_down_ = false;
    } else {
      press();
    }
  }
  return false;  // the key keeps its other effects
}

/// Handles one press of Escape. It is called several times for the same press: for
/// ShortcutOverride, for the key event, for the window and for the widget in it.
void DoubleEscape::press() {
  // Esc closes an open menu. If a user closes several nested menus, forces must not be switched
  // off.
  if (QApplication::activePopupWidget()) return since_.invalidate();
  if (is_down_ && since_.isValid() && since_.elapsed() < kForgetDownMs) return;
  is_down_ = true;
  const bool twice = since_.isValid() && since_.elapsed() <= kWithinMs;
  since_.start();
  if (!twice) return;
  since_.invalidate();
  Q_EMIT pressed_twice();
}

}  // namespace felt::desktop
