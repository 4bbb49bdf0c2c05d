#include "desktop/panels/edit_actions.h"

#include <QCoreApplication>

#include "desktop/engine/tool_texts.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr double kWidthStep = 1.25;  // factor on the widths of the selected lines

QString menu_text(const char* english) {
  return QCoreApplication::translate("EditActions", english);
}

/// Updates the texts of undo and redo from the history. The update is called after every process(),
/// so it must return quickly if nothing has changed.
class UndoTexts : public QObject {
 public:
  UndoTexts(QAction* undo, QAction* redo, Studio& studio, QObject* parent)
      : QObject(parent), undo_(undo), redo_(redo), studio_(studio) {
    connect(&studio, &Studio::shown, this, [this] { follow(); });
    connect(&studio, &Studio::edited, this, [this] { follow(); });
    connect(&studio, &Studio::opened, this, [this] {
      reported_ = {};
      follow();
    });
    follow();
  }

 private:
  struct Reported {
    std::uint64_t edits = ~std::uint64_t{0};
    bool gesture = false;
    friend bool operator==(const Reported&, const Reported&) = default;
  };

  void follow() {
    const Session& session = studio_.session();
    const Reported now{session.edit_count(), session.gesture_in_progress()};
    if (now == reported_) return;
    reported_ = now;
    const History& history = session.history();
    // During a gesture, undo cancels the gesture and nothing else.
    undo_->setEnabled(history.can_undo() || now.gesture);
    redo_->setEnabled(history.can_redo() && !now.gesture);
    undo_->setText(history.can_undo() && !now.gesture
                       ? menu_text(QT_TRANSLATE_NOOP("EditActions", "&Undo %1"))
                             .arg(edit_text(history.undo_label()))
                       : menu_text(QT_TRANSLATE_NOOP("EditActions", "&Undo")));
    redo_->setText(history.can_redo() ? menu_text(QT_TRANSLATE_NOOP("EditActions", "&Redo %1"))
                                            .arg(edit_text(history.redo_label()))
                                      : menu_text(QT_TRANSLATE_NOOP("EditActions", "&Redo")));
  }

  QAction* undo_;
  QAction* redo_;
  Studio& studio_;
  Reported reported_;
};

void add_history(Actions& actions, Studio& studio) {
  QAction* undo =
      actions.add(QStringLiteral("edit.undo"), menu_text(QT_TRANSLATE_NOOP("EditActions", "&Undo")),
                  {QKeySequence(Qt::CTRL | Qt::Key_Z)},
                  menu_text(QT_TRANSLATE_NOOP("EditActions", "Undoes the last step.")),
                  [&studio] { studio.apply(UndoEvent{}); });
  undo->setIcon(icon_of("undo"));
  QAction* redo = actions.add(
      QStringLiteral("edit.redo"), menu_text(QT_TRANSLATE_NOOP("EditActions", "&Redo")),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Redoes the step that was undone.")),
      [&studio] { studio.apply(RedoEvent{}); });
  redo->setIcon(icon_of("redo"));
  new UndoTexts(undo, redo, studio, &actions);
  QAction* drawn = actions.add(
      QStringLiteral("edit.as_drawn"),
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Line as dra&wn")),
      {QKeySequence(Qt::CTRL | Qt::Key_R)},
      menu_text(QT_TRANSLATE_NOOP(
          "EditActions", "Replaces the line of the steady hand by the line as it was drawn.")),
      [&studio] { studio.apply(AsDrawnEvent{}); });
  drawn->setAutoRepeat(false);
  const auto follow_drawn = [drawn, &studio] {
    drawn->setEnabled(studio.session().can_show_as_drawn());
  };
  QObject::connect(&studio, &Studio::shown, drawn, follow_drawn);
  QObject::connect(&studio, &Studio::opened, drawn, follow_drawn);
  follow_drawn();
  QAction* cancel =
      actions.add(QStringLiteral("edit.cancel"),
                  menu_text(QT_TRANSLATE_NOOP("EditActions", "&Cancel or clear selection")),
                  {QKeySequence(Qt::Key_Escape)},
                  menu_text(QT_TRANSLATE_NOOP(
                      "EditActions", "Cancels the current gesture, or clears the selection.")),
                  [&studio] {
                    const Session& session = studio.session();
                    if (!session.gesture_in_progress() && session.offered()) {
                      studio.apply(ChooseOffer{OfferKind::kInk});
                    } else if (session.gesture_in_progress() || session.selection().empty()) {
                      studio.apply(CancelEvent{});
                    } else {
                      studio.apply(SelectStrokes{SelectStrokes::What::kNone});
                    }
                  });
  cancel->setIcon(icon_of("close"));
  cancel->setAutoRepeat(false);
}

void add_exact(Actions& actions, Studio& studio) {
  QAction* exact = actions.add(
      QStringLiteral("edit.exact"), menu_text(QT_TRANSLATE_NOOP("EditActions", "Make e&xact")),
      {QKeySequence(Qt::CTRL | Qt::Key_E)},
      menu_text(QT_TRANSLATE_NOOP(
          "EditActions", "Replaces the line that was drawn along a guide by the exact curve.")),
      [&studio] { studio.apply(ExactEvent{}); });
  const auto follow = [exact, &studio] {
    exact->setEnabled(studio.session().exact_offer() != nullptr);
  };
  QObject::connect(&studio, &Studio::shown, exact, follow);
  follow();
}

void add_selected(Actions& actions, Studio& studio) {
  QAction* remove = actions.add(
      QStringLiteral("edit.delete"), menu_text(QT_TRANSLATE_NOOP("EditActions", "De&lete")),
      {QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_Backspace)},
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Removes the selected lines.")),
      [&studio] { studio.apply(DeleteEvent{}); });
  remove->setIcon(icon_of("delete"));
  QAction* copy = actions.add(
      QStringLiteral("edit.duplicate"), menu_text(QT_TRANSLATE_NOOP("EditActions", "&Duplicate")),
      {QKeySequence(Qt::CTRL | Qt::Key_D)},
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Copies the selected lines, slightly offset.")),
      [&studio] { studio.apply(DuplicateEvent{}); });
  copy->setIcon(icon_of("duplicate"));
  QAction* broader = actions.add(
      QStringLiteral("edit.broader"), menu_text(QT_TRANSLATE_NOOP("EditActions", "&Broader lines")),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B)},
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Makes the selected lines broader by a quarter.")),
      [&studio] { studio.apply(RestyleEvent{.width_factor = kWidthStep}); });
  QAction* thinner = actions.add(
      QStringLiteral("edit.thinner"), menu_text(QT_TRANSLATE_NOOP("EditActions", "T&hinner lines")),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T)},
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Makes the selected lines thinner by a fifth.")),
      [&studio] { studio.apply(RestyleEvent{.width_factor = 1.0 / kWidthStep}); });
  QAction* front = actions.add(
      QStringLiteral("edit.to_front"),
      menu_text(QT_TRANSLATE_NOOP("EditActions", "Bring to &front")), {QKeySequence(Qt::Key_Home)},
      menu_text(QT_TRANSLATE_NOOP("EditActions",
                                  "Puts the selected lines above all others of their layer.")),
      [&studio] { studio.apply(OrderEvent{OrderEvent::To::kFront}); });
  QAction* back = actions.add(
      QStringLiteral("edit.to_back"), menu_text(QT_TRANSLATE_NOOP("EditActions", "Send to bac&k")),
      {QKeySequence(Qt::Key_End)},
      menu_text(QT_TRANSLATE_NOOP("EditActions",
                                  "Puts the selected lines below all others of their layer.")),
      [&studio] { studio.apply(OrderEvent{OrderEvent::To::kBack}); });
  const auto follow = [all = QList{remove, copy, broader, thinner, front, back}, &studio] {
    const bool any = !studio.session().selection().empty();
    for (QAction* action : all) action->setEnabled(any);
  };
  QObject::connect(&studio, &Studio::selection_changed, remove, follow);
  follow();
}

void add_selecting(Actions& actions, Studio& studio) {
  using What = SelectStrokes::What;
  actions
      .add(QStringLiteral("edit.select_all"),
           menu_text(QT_TRANSLATE_NOOP("EditActions", "Select &all")),
           {QKeySequence(Qt::CTRL | Qt::Key_A)},
           menu_text(
               QT_TRANSLATE_NOOP("EditActions", "Selects all lines of visible, unlocked layers.")),
           [&studio] { studio.apply(SelectStrokes{What::kAll}); })
      ->setIcon(icon_of("select-all"));
  QAction* none = actions.add(QStringLiteral("edit.select_none"),
                              menu_text(QT_TRANSLATE_NOOP("EditActions", "Select &none")),
                              {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)},
                              menu_text(QT_TRANSLATE_NOOP("EditActions", "Clears the selection.")),
                              [&studio] { studio.apply(SelectStrokes{What::kNone}); });
  none->setIcon(icon_of("select-none"));
  actions
      .add(QStringLiteral("edit.invert_selection"),
           menu_text(QT_TRANSLATE_NOOP("EditActions", "&Invert selection")),
           {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)},
           menu_text(
               QT_TRANSLATE_NOOP("EditActions", "Selects all lines that are not selected now.")),
           [&studio] { studio.apply(SelectStrokes{What::kInvert}); })
      ->setIcon(icon_of("select-invert"));
  const auto follow = [none, &studio] { none->setEnabled(!studio.session().selection().empty()); };
  QObject::connect(&studio, &Studio::selection_changed, none, follow);
  follow();
}

}  // namespace

void add_edit_actions(Actions& actions, Studio& studio) {
  add_history(actions, studio);
  add_exact(actions, studio);
  add_selected(actions, studio);
  add_selecting(actions, studio);
}

}  // namespace felt::desktop
