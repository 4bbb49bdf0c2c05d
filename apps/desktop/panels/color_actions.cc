// The actions of the colours panel.
#include <QCoreApplication>

#include "desktop/panels/colors_panel.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

QString color_text(const char* english) {
  return QCoreApplication::translate("ColorActions", english);
}

}  // namespace

void add_color_actions(Actions& actions, ColorsPanel& panel) {
  actions
      .add(QStringLiteral("edit.palette_open"),
           color_text(QT_TRANSLATE_NOOP("ColorActions", "&Open a palette…")), {},
           color_text(QT_TRANSLATE_NOOP("ColorActions", "Reads colours from a .gpl file.")),
           [&panel] { panel.ask_open(); })
      ->setIcon(icon_of("palette"));
  actions
      .add(QStringLiteral("edit.palette_export"),
           color_text(QT_TRANSLATE_NOOP("ColorActions", "&Export the palette…")), {},
           color_text(QT_TRANSLATE_NOOP("ColorActions", "Writes the palette that is shown.")),
           [&panel] { panel.ask_export(); })
      ->setIcon(icon_of("export"));
  actions
      .add(QStringLiteral("edit.palette_keep"),
           color_text(QT_TRANSLATE_NOOP("ColorActions", "&Keep the colour")), {},
           color_text(
               QT_TRANSLATE_NOOP("ColorActions", "Adds the current colour to your own palette.")),
           [&panel] { panel.keep_color(); })
      ->setIcon(icon_of("add"));
  actions
      .add(QStringLiteral("edit.palette_drop"),
           color_text(QT_TRANSLATE_NOOP("ColorActions", "&Remove the colour")), {},
           color_text(QT_TRANSLATE_NOOP("ColorActions",
                                        "Removes the current colour from your own palette.")),
           [&panel] { panel.drop_color(); })
      ->setIcon(icon_of("remove"));
}

}  // namespace felt::desktop
