#include "desktop/window/menus.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <array>
#include <string_view>

#include "desktop/engine/text_of.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

/// A menu: the first part of its actions' names, and the sequence of its entries. "-" is a
/// separator. "name.*" means all actions with that prefix; they are in a submenu if a SubmenuRow
/// has this prefix.
struct MenuRow {
  std::string_view prefix;
  const char* title;
  std::string_view order;  // separated by blanks
};

/// In the sequence of a menu, the position of the submenu of recent files. It is not the name of an
/// action.
constexpr auto kRecent = "file.recent_menu";

constexpr std::array kMenus{
    MenuRow{
        "file", QT_TRANSLATE_NOOP("Menus", "&File"),
        "file.new file.new_window file.open file.recent_menu - file.save file.save_as "
        "file.revert - file.import file.import_picture file.export* file.timelapse file.animation "
        "file.page* file.print* - "
        "file.* - file.close "
        "file.quit"},
    MenuRow{
        "edit", QT_TRANSLATE_NOOP("Menus", "&Edit"),
        "edit.undo edit.redo edit.as_drawn edit.exact - edit.cut edit.copy edit.copy* edit.paste "
        "edit.paste_in_place edit.duplicate "
        "edit.delete - edit.select_all edit.select_none edit.invert_selection - edit.pick_color "
        "edit.pick_all edit.broader edit.thinner edit.to_front edit.to_back - edit.palette_* - "
        "edit.* - edit.cancel - edit.preferences"},
    MenuRow{
        "view", QT_TRANSLATE_NOOP("Menus", "&View"),
        "view.zoom_in view.zoom_out view.zoom* view.life_size - view.fit_page view.fit* - "
        "view.rotate* view.mirror view.scroll_* - view.outline view.grain view.force_arrow "
        "view.onion_skin view.correct_matches view.play - view.* - view.panel_solid view.materials "
        "view.compare_materials - view.panel_* view.next_part "
        "view.hide_panels view.full_screen"},
    MenuRow{"tool", QT_TRANSLATE_NOOP("Menus", "&Tools"), "tool.*"},
    MenuRow{"layer", QT_TRANSLATE_NOOP("Menus", "&Layer"),
            "layer.add layer.add_key layer.same_timing layer.duplicate layer.merge layer.rename "
            "layer.remove - "
            "layer.show "
            "layer.lock layer.export_picture - layer.raise layer.lower - layer.group "
            "layer.ungroup layer.leave_group - layer.*"},
    MenuRow{"guide", QT_TRANSLATE_NOOP("Menus", "&Guides"),
            "guide.show - guide.add_* - guide.unlink guide.clear - guide.*"},
    MenuRow{
        "feel", QT_TRANSLATE_NOOP("Menus", "F&eel"),
        "feel.forces feel.forces_off feel.stronger feel.weaker - feel.surface_* - feel.pressure "
        "feel.sound - feel.page_edge feel.selection_edge feel.contours - feel.*"},
    MenuRow{"help", QT_TRANSLATE_NOOP("Menus", "&Help"),
            "help.guide help.tour help.shortcuts - help.example* - help.* - help.about"},
};

/// A submenu of the actions with that prefix.
struct SubmenuRow {
  std::string_view prefix;
  const char* title;
};
constexpr std::array kSubmenus{
    SubmenuRow{"file.export_solid_", QT_TRANSLATE_NOOP("Menus", "Export the so&lid")},
    SubmenuRow{"edit.copy_as_", QT_TRANSLATE_NOOP("Menus", "Copy &as")},
    SubmenuRow{"edit.palette_", QT_TRANSLATE_NOOP("Menus", "Pal&ette")},
    SubmenuRow{"view.scroll_", QT_TRANSLATE_NOOP("Menus", "&Scroll")},
    SubmenuRow{"view.panel_", QT_TRANSLATE_NOOP("Menus", "&Panels")},
    SubmenuRow{"feel.surface_", QT_TRANSLATE_NOOP("Menus", "S&urface")},
    SubmenuRow{"help.example_", QT_TRANSLATE_NOOP("Menus", "&Example drawings")},
};

struct IconRow {
  std::string_view action;
  std::string_view icon;
};
/// The commands whose icons have other names.
constexpr std::array kIcons{
    IconRow{"view.fit_page", "fit"},          IconRow{"view.hide_panels", "panels"},
    IconRow{"file.save_as", "save"},          IconRow{"edit.broader", "size-up"},
    IconRow{"edit.thinner", "size-down"},     IconRow{"edit.to_front", "raise"},
    IconRow{"edit.to_back", "lower"},         IconRow{"edit.paste_in_place", "paste"},
    IconRow{"file.import_picture", "import"},
};

class MenuFiller {
 public:
  MenuFiller(QMenu& menu, const Actions& actions, QMenu* recent)
      : menu_(menu), actions_(actions), recent_(recent) {}

  void fill(const MenuRow& row) {
    const QStringList order = text_of(row.order).split(QLatin1Char(' '));
    for (const QString& name : order) {
      if (name.size() > 1 && !name.endsWith(QLatin1Char('*'))) named_.insert(name);
    }
    for (const QString& name : order) add(name);
    add(text_of(row.prefix) + QStringLiteral(".*"));
  }

 private:
  void add(const QString& name) {
    if (name == QStringLiteral("-")) {
      wants_line_ = true;
    } else if (name == QLatin1String(kRecent)) {
      if (recent_) menu_.addMenu(recent_);
    } else if (!name.endsWith(QLatin1Char('*'))) {
      put(actions_.find(name));
    } else {
      for (QAction* action : actions_.all()) {
        if (named_.contains(action->objectName())) continue;
        if (action->objectName().startsWith(name.chopped(1))) put(action);
      }
    }
  }

  void put(QAction* action) {
    if (!action || done_.contains(action)) return;
    done_.insert(action);
    for (const SubmenuRow& row : kSubmenus) {
      if (named_.contains(action->objectName())) break;
      if (!action->objectName().startsWith(text_of(row.prefix))) continue;
      submenu(row).addAction(action);
      return;
    }
    line();
    menu_.addAction(action);
  }

  void line() {
    if (wants_line_ && !menu_.isEmpty()) menu_.addSeparator();
    wants_line_ = false;
  }

  QMenu& submenu(const SubmenuRow& row) {
    const QString name = text_of(row.prefix);
    if (auto* present = menu_.findChild<QMenu*>(name, Qt::FindDirectChildrenOnly)) return *present;
    line();
    QMenu* made = menu_.addMenu(QCoreApplication::translate("Menus", row.title));
    made->setObjectName(name);
    return *made;
  }

  QMenu& menu_;
  const Actions& actions_;
  QMenu* recent_;
  QSet<QString> named_;  // actions that have their own position in the table
  QSet<QAction*> done_;
  bool wants_line_ = false;
};

}  // namespace

void make_menus(QMainWindow& window, const Actions& actions, QMenu* recent) {
  for (const MenuRow& row : kMenus) {
    QMenu* menu = window.menuBar()->addMenu(QCoreApplication::translate("Menus", row.title));
    menu->setObjectName(text_of(row.prefix));
    MenuFiller(*menu, actions, recent).fill(row);
    menu->menuAction()->setVisible(!menu->isEmpty());
  }
}

void set_action_icons(const Actions& actions) {
  for (QAction* action : actions.all()) {
    const QString name = action->objectName();
    const QString command = name.section(QLatin1Char('.'), 1);
    std::string wanted = command.toStdString();
    for (char& c : wanted) c = c == '_' ? '-' : c;
    for (const IconRow& row : kIcons) {
      if (name == text_of(row.action)) wanted = row.icon;
    }
    QIcon icon = icon_of(wanted);
    if (icon.isNull() && !name.startsWith(QStringLiteral("tool."))) {
      icon = icon_of(name.section(QLatin1Char('.'), 0, 0).toStdString() + "-" + wanted);
    }
    if (!icon.isNull()) action->setIcon(icon);
  }
}

QString menu_title_of(const QString& action_name) {
  for (const MenuRow& row : kMenus) {
    if (!action_name.startsWith(text_of(row.prefix) + QLatin1Char('.'))) continue;
    return QCoreApplication::translate("Menus", row.title).remove(QLatin1Char('&'));
  }
  return {};
}

}  // namespace felt::desktop
