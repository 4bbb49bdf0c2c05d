#include "desktop/help/help_actions.h"

#include <QApplication>
#include <QThreadPool>
#include <utility>

#include "desktop/help/about_dialog.h"
#include "desktop/help/examples.h"
#include "desktop/help/guide_dialog.h"
#include "desktop/help/shortcut_sheet.h"
#include "desktop/help/tour_window.h"

namespace felt::desktop {

HelpActions::HelpActions(Actions& actions, QWidget* window)
    : QObject(window), actions_(actions), window_(window) {
  actions.add(QStringLiteral("help.guide"), tr("&Guide"), {QKeySequence(Qt::Key_F1)},
              tr("What the tools do, on one page"), [this] {
                show_dialog(guide_, [](const Actions& all, QWidget* parent) -> QWidget* {
                  return new GuideDialog(all, parent);
                });
              });
  actions.add(QStringLiteral("help.shortcuts"), tr("&Keyboard shortcuts"),
              {QKeySequence(Qt::Key_Question)},
              tr("All shortcuts on one page, to search and to print"), [this] {
                show_dialog(shortcuts_, [](const Actions& all, QWidget* parent) -> QWidget* {
                  return new ShortcutSheet(all, parent);
                });
              });
  actions.add(QStringLiteral("help.tour"), tr("Guided &tour"), {},
              tr("A two-minute demonstration of the tools"), [this] { show_tour(); });
  for (const Example& example : examples()) {
    actions.add(QStringLiteral("help.example_") + example.id, example.title, {},
                tr("Opens this drawing, made by the project's simulated hand"),
                [this, example] { make_example(example); });
  }
  actions.add(QStringLiteral("help.about"), tr("&About Feltline"), {},
              tr("Version, licence and libraries"), [this] {
                show_dialog(about_, [](const Actions&, QWidget* parent) -> QWidget* {
                  return new AboutDialog(parent);
                });
              });
}

/// Draws the example on another thread, because that may take long.
void HelpActions::make_example(const Example& example) {
  const QPointer<HelpActions> asked(this);
  QThreadPool::globalInstance()->start([asked, example] {
    Document drawing = example_document(example.id);
    QMetaObject::invokeMethod(
        qApp,
        [asked, title = example.title, drawing = std::move(drawing)] {
          if (asked) Q_EMIT asked->wants_drawing(drawing, title);
        },
        Qt::QueuedConnection);
  });
}

void HelpActions::show_dialog(QPointer<QWidget>& dialog,
                              QWidget* (*make)(const Actions&, QWidget*)) {
  if (!dialog) dialog = make(actions_, window_);
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void HelpActions::show_tour() {
  if (!tour_) {
    auto* tour = new TourWindow(window_);
    connect(tour, &TourWindow::drawing_requested, this, [this](const Document& drawing) {
      Q_EMIT wants_drawing(drawing, tr("From the tour"));
    });
    tour_ = tour;
  }
  tour_->show();
  tour_->raise();
  tour_->activateWindow();
}

}  // namespace felt::desktop
