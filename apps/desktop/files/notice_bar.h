#pragma once

#include <QFrame>

#include "felt/io/import.h"

class QLabel;
class QToolButton;
class QTreeWidget;

namespace felt::desktop {

/// Says, without being in the way, that a file held things that could not be taken: one line above
/// the sheet, "Details" with a list of what and where, and a cross. It takes no focus; a screen
/// reader is told. Hidden until show_report; another file's report takes the place of the last.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  /// `name` is the file's, for people. A report without notices hides the bar.
  void show_report(const QString& name, const ImportReport& report);
  /// Something else that a person should know, in plain words; it stays until it is closed.
  void show_words(const QString& words);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void announce();
  void show_details(bool on);

  QLabel* text_;
  QToolButton* details_;
  QTreeWidget* list_;
};

}  // namespace felt::desktop
