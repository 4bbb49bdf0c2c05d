#include "desktop/files/notice_bar.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "desktop/engine/text_of.h"
#include "desktop/files/import_words.h"
#include "desktop/files/lost_words.h"

namespace felt::desktop {
namespace {

constexpr int kRowsShown = 6;
constexpr int kIconPx = 16;

/// Returns sentences about the objects that are not in a file. Requires that there are any.
QString lost_text(const LostObjects& lost) {
  QStringList texts;
  for (const LostWords& row : kLostWords) {
    const std::size_t count = lost.*row.count;
    if (count > 0) texts += NoticeBar::tr(row.text).arg(QLocale().toString(qulonglong(count)));
  }
  return texts.join(QLatin1Char(' '));
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : NoticeBar(new QTreeWidget, parent) {}

NoticeBar::NoticeBar(QTreeWidget* list, QWidget* parent)
    : MessageBar(list, tr("Unsupported content, and its line"), parent),
      list_(list),
      folder_(new QPushButton(tr("&Open the folder"), this)) {
  extras().addWidget(folder_);
  folder_->hide();
  connect(folder_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path_).absolutePath()));
  });
  until_.setSingleShot(true);
  connect(&until_, &QTimer::timeout, this, &QWidget::hide);
  set_icon(style()->standardIcon(QStyle::SP_MessageBoxInformation).pixmap(kIconPx));
  list_->setRootIsDecorated(false);
  list_->setHeaderLabels({tr("Line"), tr("Element"), tr("Result"), tr("Count")});
  list_->setAccessibleName(tr("Unsupported content, and its line"));
  list_->setWordWrap(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(2, QHeaderView::Stretch);
  connect(this, &MessageBar::details_toggled, this, &NoticeBar::fit_list);
}

void NoticeBar::show_report(const QString& name, const ImportReport& report) {
  clear();
  if (report.empty()) return hide();
  const QLocale locale;
  int count = 0;
  for (const ImportNotice& notice : report.notices()) {
    count += int(std::min<std::int64_t>(notice.count, 1'000'000));
    auto* item = new QTreeWidgetItem(list_);
    if (notice.line > 0) item->setText(0, locale.toString(qlonglong(notice.line)));
    item->setText(1, text_of(notice.element));
    item->setText(2, import_words(notice.what));
    item->setToolTip(2, text_of(notice_text(notice)));
    item->setText(3, locale.toString(qlonglong(notice.count)));
  }
  say(tr("Some content of “%1” is not supported. Skipped or changed: %2. The file itself is "
         "unchanged.")
          .arg(name, locale.toString(count)),
      true);
}

void NoticeBar::forget_report() {
  if (list_->topLevelItemCount() > 0) show_report({}, {});
}

void NoticeBar::show_words(const QString& words) {
  clear();
  say(words, false);
}

void NoticeBar::show_written(const QString& path, const LostObjects& lost, const QString& changed) {
  clear();
  path_ = path;
  folder_->setToolTip(QDir::toNativeSeparators(QFileInfo(path).absolutePath()));
  folder_->show();
  const QFileInfo file(path);
  QString words = tr("“%1” was exported to “%2”.")
                      .arg(file.fileName(), QDir::toNativeSeparators(file.absolutePath()));
  if (lost == LostObjects() && changed.isEmpty()) until_.start(kWrittenMs);
  if (lost != LostObjects()) words += QLatin1Char(' ') + lost_text(lost);
  if (!changed.isEmpty()) words += QLatin1Char(' ') + changed;
  say(words, false);
}

void NoticeBar::clear() {
  list_->clear();
  folder_->hide();
  until_.stop();
}

/// Sets the height so that the rows fit, but at most kRowsShown of them.
void NoticeBar::fit_list() {
  const int rows = std::min(list_->topLevelItemCount(), kRowsShown);
  const int row_height = std::max(list_->sizeHintForRow(0), fontMetrics().height());
  list_->setFixedHeight(list_->header()->sizeHint().height() + (rows + 1) * row_height);
}

}  // namespace felt::desktop
