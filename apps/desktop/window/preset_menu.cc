#include "desktop/window/preset_menu.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QLocale>

#include "desktop/engine/presets.h"
#include "desktop/engine/tool_size.h"
#include "desktop/feel/material_words.h"
#include "desktop/panels/swatch_view.h"
#include "desktop/panels/tool_icons.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

QString preset_text(const char* english) {
  return QCoreApplication::translate("PresetMenu", english);
}

/// Returns a name for the present pen, such as "Chalk, 3 mm".
QString usual_name(const Session& session) {
  const Medium* medium = session.materials().find_medium(drawing_medium(session));
  const Tool* draws = session.first_tool(ToolKind::kDraws);
  const std::optional<ToolSize> size = draws ? draws->size() : std::nullopt;
  const QString label = medium ? medium_label(*medium) : QString();
  if (!size) return label;
  //: a medium and its size
  return preset_text(QT_TRANSLATE_NOOP("PresetMenu", "%1, %2 mm"))
      .arg(label, QLocale().toString(size->mm, 'g', 2));
}

/// Returns a square of the colour of a preset.
QIcon icon_of_preset(const Preset& preset) {
  for (const SetOption& option : preset.options) {
    const auto* text = std::get_if<std::string>(&option.value);
    const auto color = text ? color_from_text(*text) : std::nullopt;
    if (option.id != kInkColorId || !color) continue;
    QPixmap square(16, 16);
    square.fill(qcolor(*color));
    return QIcon(square);
  }
  return {};
}

/// Asks for the name without blocking the event loop.
void ask_name(Studio& studio, QWidget* window) {
  auto* dialog = new QInputDialog(window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(preset_text(QT_TRANSLATE_NOOP("PresetMenu", "Keep as a preset")));
  dialog->setLabelText(preset_text(
      QT_TRANSLATE_NOOP("PresetMenu", "Name for this medium, size, colour and options:")));
  dialog->setTextValue(usual_name(studio.session()));
  QObject::connect(dialog, &QInputDialog::textValueSelected, &studio,
                   [&studio](const QString& name) { keep_preset(studio.session(), name); });
  dialog->open();
}

}  // namespace

PresetMenu::PresetMenu(const Actions& actions, Studio& studio, QWidget* parent)
    : QMenu(tr("P&resets"), parent), actions_(actions), studio_(studio) {
  setIcon(icon_of("preset"));
  connect(this, &QMenu::aboutToShow, this, &PresetMenu::fill);
  fill();
}

void PresetMenu::fill() {
  clear();
  const std::vector<Preset> presets = stored_presets();
  const auto plain = [](QString name) {
    return name.replace(QLatin1Char('&'), QLatin1String("&&"));
  };
  for (const Preset& preset : presets) {
    addAction(icon_of_preset(preset), plain(preset.name), this,
              [this, preset] { use_preset(studio_, preset); });
  }
  addSeparator();
  if (QAction* keep = actions_.find(QStringLiteral("edit.preset_keep"))) addAction(keep);
  if (presets.empty()) return;
  QMenu* remove = addMenu(icon_of("delete"), tr("&Remove"));
  for (const Preset& preset : presets) {
    remove->addAction(plain(preset.name), this, [name = preset.name] { remove_preset(name); });
  }
}

void add_preset_actions(Actions& actions, Studio& studio, QWidget* window) {
  actions
      .add(QStringLiteral("edit.preset_keep"),
           preset_text(QT_TRANSLATE_NOOP("PresetMenu", "&Keep as a preset…")), {},
           preset_text(QT_TRANSLATE_NOOP(
               "PresetMenu",
               "Keeps the medium, the size, the colour and the options of the pencil "
               "under a name.")),
           [&studio, window] { ask_name(studio, window); })
      ->setIcon(icon_of("add"));
}

}  // namespace felt::desktop
