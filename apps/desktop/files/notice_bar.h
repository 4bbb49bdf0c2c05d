#pragma once

#include "desktop/engine/message_bar.h"
#include "felt/io/import.h"

class QTreeWidget;

namespace felt::desktop {

/// Says that a file held things that could not be taken: one line above the sheet, and on demand a
/// list of what and where. Another file's report takes the place of the last.
class NoticeBar : public MessageBar {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  /// `name` is the file's, for people. A report without notices hides the bar.
  void show_report(const QString& name, const ImportReport& report);
  /// Another drawing is here: the last file's report goes.
  void forget_report();
  /// Something else that a person should know, in plain words; it stays until it is closed.
  void show_words(const QString& words);

 private:
  NoticeBar(QTreeWidget* list, QWidget* parent);
  void fit_list();

  QTreeWidget* list_;
};

}  // namespace felt::desktop
