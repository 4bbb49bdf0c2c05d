#include "desktop/help/key_table.h"

#include <QCoreApplication>
#include <array>
#include <utility>

namespace felt::desktop {
namespace {

struct Group {
  const char* prefix;
  const char* title;
};
constexpr std::array kGroups{
    Group{"tool", QT_TRANSLATE_NOOP("KeyTable", "Tools")},
    Group{"edit", QT_TRANSLATE_NOOP("KeyTable", "Edit")},
    Group{"view", QT_TRANSLATE_NOOP("KeyTable", "View")},
    Group{"file", QT_TRANSLATE_NOOP("KeyTable", "File")},
    Group{"layer", QT_TRANSLATE_NOOP("KeyTable", "Layer")},
    Group{"feel", QT_TRANSLATE_NOOP("KeyTable", "Feel")},
    Group{"help", QT_TRANSLATE_NOOP("KeyTable", "Help")},
};

/// The inputs that are not actions: pen, mouse and held keys.
constexpr std::array kHandRows{
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Move the view"),
              QT_TRANSLATE_NOOP("KeyTable", "Space + drag")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Zoom"), QT_TRANSLATE_NOOP("KeyTable", "Wheel")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Zoom smoothly"),
              QT_TRANSLATE_NOOP("KeyTable", "Ctrl + Space + drag")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Turn the view"),
              QT_TRANSLATE_NOOP("KeyTable", "Shift + Space + drag")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Change the size"),
              QT_TRANSLATE_NOOP("KeyTable", "Ctrl + Alt + drag")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Palette at the pointer"),
              QT_TRANSLATE_NOOP("KeyTable", "Click with the right button")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Move the selected lines by 1, 10 or 0.1 mm"),
              QT_TRANSLATE_NOOP("KeyTable", "Arrow, Shift + arrow, Ctrl + arrow")},
    std::pair{QT_TRANSLATE_NOOP("KeyTable", "Use a tool temporarily"),
              QT_TRANSLATE_NOOP("KeyTable", "Hold its key while you use it")},
};

QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QChar(0x2026));
}

QString keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) {
    const QString text = key.toString(QKeySequence::NativeText);
    if (!text.isEmpty()) keys.push_back(text);
  }
  return keys.join(QStringLiteral("  "));
}

QString cell_of(const KeyRow& row, const QPalette& palette) {
  QString keys;
  for (const QString& key : row.keys.split(QStringLiteral("  "), Qt::SkipEmptyParts)) {
    keys += QStringLiteral("<span style='background-color:%1;'>&nbsp;%2&nbsp;</span> ")
                .arg(palette.color(QPalette::AlternateBase).name(), key.toHtmlEscaped());
  }
  return QStringLiteral("<tr><td>%1</td><td align='right' style='padding-left:14px;'>%2</td></tr>")
      .arg(row.text.toHtmlEscaped(), keys);
}

}  // namespace

QVector<KeyGroup> key_groups(const Actions& actions, const QString& filter) {
  QVector<KeyGroup> groups;
  const auto fits = [&filter](const KeyRow& row) {
    return filter.isEmpty() || row.text.contains(filter, Qt::CaseInsensitive) ||
           row.keys.contains(filter, Qt::CaseInsensitive);
  };
  for (const Group& group : kGroups) {
    KeyGroup made{QCoreApplication::translate("KeyTable", group.title), {}};
    for (const QAction* action : actions.all()) {
      if (action->objectName().section(QLatin1Char('.'), 0, 0) != QLatin1String(group.prefix)) {
        continue;
      }
      const KeyRow row{plain(action->text()), keys_of(*action)};
      if (!row.keys.isEmpty() && fits(row)) made.rows.push_back(row);
    }
    if (!made.rows.isEmpty()) groups.push_back(made);
  }
  KeyGroup hand{QCoreApplication::translate("KeyTable", "Pen, mouse and held keys"), {}};
  for (const auto& [text, keys] : kHandRows) {
    const KeyRow row{QCoreApplication::translate("KeyTable", text),
                     QCoreApplication::translate("KeyTable", keys)};
    if (fits(row)) hand.rows.push_back(row);
  }
  if (!hand.rows.isEmpty()) groups.insert(std::min(qsizetype(1), groups.size()), hand);
  return groups;
}

QString key_page(const QVector<KeyGroup>& groups, int columns, const QPalette& palette) {
  qsizetype total = 0;
  for (const KeyGroup& group : groups) total += group.rows.size() + 2;
  QString page = QStringLiteral("<table width='100%' cellspacing='0' cellpadding='0'><tr>");
  qsizetype at = 0;
  for (int column = 0; column < columns; ++column) {
    page += QStringLiteral("<td width='%1%' valign='top' style='padding-right:24px;'>")
                .arg(100 / columns);
    qsizetype height = 0;
    while (at < groups.size() && (column == columns - 1 || height * columns < total)) {
      const KeyGroup& group = groups[at++];
      page += QStringLiteral("<h4>%1</h4><table width='100%' cellpadding='2'>")
                  .arg(group.title.toHtmlEscaped());
      for (const KeyRow& row : group.rows) page += cell_of(row, palette);
      page += QStringLiteral("</table>");
      height += group.rows.size() + 2;
    }
    page += QStringLiteral("</td>");
  }
  return page + QStringLiteral("</tr></table>");
}

}  // namespace felt::desktop
