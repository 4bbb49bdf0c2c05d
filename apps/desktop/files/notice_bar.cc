#include "desktop/files/notice_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QStyle>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace felt::desktop {
namespace {

constexpr int kMargin = 6;
constexpr int kRowsShown = 6;
constexpr int kIconPx = 16;

QString text_of(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      details_(new QToolButton(this)),
      list_(new QTreeWidget(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  auto* icon = new QLabel(this);
  icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxInformation).pixmap(kIconPx));
  details_->setText(tr("&Details"));
  details_->setCheckable(true);
  details_->setToolTip(tr("What was left out or changed, and where"));
  connect(details_, &QToolButton::toggled, this, &NoticeBar::show_details);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));  // in the colour of the theme, which the style's icon is not
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  list_->setRootIsDecorated(false);
  list_->setHeaderLabels({tr("Line"), tr("Element"), tr("What became of it"), tr("How often")});
  list_->setAccessibleName(tr("What was left out or changed, and where"));
  list_->setWordWrap(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(2, QHeaderView::Stretch);
  list_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(icon);
  row->addWidget(text_, 1);
  row->addWidget(details_);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  all->addLayout(row);
  all->addWidget(list_);
  hide();
}

void NoticeBar::show_report(const QString& name, const ImportReport& report) {
  list_->clear();
  details_->setChecked(false);
  details_->show();
  if (report.empty()) return hide();
  const QLocale locale;
  int count = 0;
  for (const ImportNotice& notice : report.notices()) {
    count += int(std::min<std::int64_t>(notice.count, 1'000'000));
    auto* item = new QTreeWidgetItem(list_);
    if (notice.line > 0) item->setText(0, locale.toString(qlonglong(notice.line)));
    item->setText(1, text_of(notice.element));
    item->setText(2, text_of(notice.what));
    item->setToolTip(2, text_of(notice_text(notice)));
    item->setText(3, locale.toString(qlonglong(notice.count)));
  }
  text_->setText(tr("Not everything in “%1” could be taken as it is. Left out or changed: %2. "
                    "The file itself is as it was.")
                     .arg(name, locale.toString(count)));
  announce();
}

void NoticeBar::show_words(const QString& words) {
  list_->clear();
  details_->setChecked(false);
  details_->hide();
  text_->setText(words);
  announce();
}

void NoticeBar::announce() {
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  setAccessibleName(text_->text());
  QAccessible::updateAccessibility(&alert);
}

void NoticeBar::show_details(bool on) {
  const int rows = std::min(list_->topLevelItemCount(), kRowsShown);
  const int row_height = std::max(list_->sizeHintForRow(0), fontMetrics().height());
  list_->setFixedHeight(list_->header()->sizeHint().height() + (rows + 1) * row_height);
  list_->setVisible(on);
}

void NoticeBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  hide();
}

}  // namespace felt::desktop
