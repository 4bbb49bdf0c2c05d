#include "desktop/window/edit_actions.h"

#include <QCoreApplication>

namespace felt::desktop {
namespace {

using What = SelectStrokes::What;

struct EditRow {
  const char* name;
  const char* text;
  const char* tip;
  QList<QKeySequence> keys;
  decltype(Event::what) event;
};

/// Not constexpr: keys and events own memory.
const std::vector<EditRow>& rows() {
  static const std::vector<EditRow> kRows{
      {"edit.undo",
       QT_TRANSLATE_NOOP("EditActions", "&Undo"),
       QT_TRANSLATE_NOOP("EditActions", "Takes the last step back"),
       {QKeySequence(Qt::CTRL | Qt::Key_Z)},
       UndoEvent{}},
      {"edit.redo",
       QT_TRANSLATE_NOOP("EditActions", "&Redo"),
       QT_TRANSLATE_NOOP("EditActions", "Does what was undone again"),
       {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
       RedoEvent{}},
      {"edit.delete",
       QT_TRANSLATE_NOOP("EditActions", "&Delete"),
       QT_TRANSLATE_NOOP("EditActions", "Deletes the selected lines"),
       {QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_Backspace)},
       DeleteEvent{}},
      {"edit.duplicate",
       QT_TRANSLATE_NOOP("EditActions", "D&uplicate"),
       QT_TRANSLATE_NOOP("EditActions", "Copies the selected lines, a little beside them"),
       {QKeySequence(Qt::CTRL | Qt::Key_D)},
       DuplicateEvent{}},
      {"edit.select_all",
       QT_TRANSLATE_NOOP("EditActions", "Select &all"),
       QT_TRANSLATE_NOOP("EditActions", "Selects all lines of visible, unlocked layers"),
       {QKeySequence(Qt::CTRL | Qt::Key_A)},
       SelectStrokes{What::kAll}},
      {"edit.select_none",
       QT_TRANSLATE_NOOP("EditActions", "Select &nothing"),
       QT_TRANSLATE_NOOP("EditActions", "Nothing is selected then"),
       {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)},
       SelectStrokes{What::kNone}},
      {"edit.select_invert",
       QT_TRANSLATE_NOOP("EditActions", "&Invert selection"),
       QT_TRANSLATE_NOOP("EditActions", "Selects what is not selected, and nothing else"),
       {QKeySequence(Qt::CTRL | Qt::Key_I)},
       SelectStrokes{What::kInvert}},
      {"edit.cancel",
       QT_TRANSLATE_NOOP("EditActions", "&Cancel the gesture"),
       QT_TRANSLATE_NOOP("EditActions", "What the pen is doing never was"),
       {QKeySequence(Qt::Key_Escape)},
       CancelEvent{}},
  };
  return kRows;
}

void enable(const Actions& actions, const char* name, bool on) {
  if (QAction* action = actions.find(QString::fromLatin1(name))) action->setEnabled(on);
}

void refresh(const Actions& actions, const Studio& studio) {
  const Session& session = studio.session();
  // While the pen is down, undo takes the gesture back.
  enable(actions, "edit.undo", session.history().can_undo() || session.gesture_in_work());
  enable(actions, "edit.redo", session.history().can_redo());
  const bool any = !session.selection().empty();
  for (const char* name : {"edit.delete", "edit.duplicate", "edit.select_none"}) {
    enable(actions, name, any);
  }
}

}  // namespace

void add_edit_actions(Actions& actions, Studio& studio) {
  for (const EditRow& row : rows()) {
    const QString name = QString::fromLatin1(row.name);
    if (actions.find(name)) continue;
    actions.add(name, QCoreApplication::translate("EditActions", row.text), row.keys,
                QCoreApplication::translate("EditActions", row.tip),
                [&studio, event = row.event] { studio.apply(event); });
  }
  if (QAction* cancel = actions.find(QStringLiteral("edit.cancel"))) cancel->setAutoRepeat(false);
  const auto renew = [&actions, &studio] { refresh(actions, studio); };
  QObject::connect(&studio, &Studio::edited, &actions, renew);
  QObject::connect(&studio, &Studio::opened, &actions, renew);
  QObject::connect(&studio, &Studio::selection_changed, &actions, renew);
  // A gesture begins and ends without an edit.
  QObject::connect(&studio, &Studio::shown, &actions, [&actions, &studio] {
    QAction* undo = actions.find(QStringLiteral("edit.undo"));
    const bool can = studio.session().history().can_undo() || studio.session().gesture_in_work();
    if (undo && undo->isEnabled() != can) undo->setEnabled(can);
  });
  renew();
}

}  // namespace felt::desktop
