#include "desktop/window/preferences.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QScrollArea>

#include "desktop/feel/device_page.h"
#include "desktop/pens/pens_page.h"
#include "desktop/window/canvas_page.h"
#include "desktop/window/general_page.h"
#include "desktop/window/shortcuts_page.h"

namespace felt::desktop {

Preferences::Preferences(MainWindow& window)
    : QDialog(&window), list_(new QListWidget(this)), stack_(new QStackedWidget(this)) {
  setWindowTitle(tr("Preferences"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(760, 540);
  list_->setAccessibleName(tr("Pages of the preferences"));
  list_->setFixedWidth(150);
  Actions& actions = window.actions();
  add(QStringLiteral("general"), tr("General"), [] { return new GeneralPage; });
  add(QStringLiteral("pen"), tr("Pen"), [] { return new PensPage; });
  add(QStringLiteral("device"), tr("Device"),
      [&window] { return new DevicePage(window.studio()); });
  add(QStringLiteral("canvas"), tr("Sheet"), [] { return new CanvasPage; });
  add(QStringLiteral("shortcuts"), tr("Shortcuts"),
      [&actions] { return new ShortcutsPage(actions); });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  row->addWidget(list_);
  row->addWidget(stack_, 1);
  auto* all = new QVBoxLayout(this);
  all->addLayout(row, 1);
  all->addWidget(buttons);
  connect(list_, &QListWidget::currentRowChanged, this, &Preferences::show_row);
  list_->setCurrentRow(0);
}

void Preferences::add(const QString& name, const QString& title, std::function<QWidget*()> make) {
  pages_.push_back({name, std::move(make)});
  list_->addItem(title);
  // A large page scrolls; the dialog keeps its size.
  auto* frame = new QScrollArea(this);
  frame->setFrameShape(QFrame::NoFrame);
  frame->setWidgetResizable(true);
  frame->setFocusPolicy(Qt::NoFocus);
  stack_->addWidget(frame);
}

void Preferences::show_row(int row) {
  if (row < 0) return;
  Page& page = pages_[std::size_t(row)];
  if (!page.made) {
    page.made = page.make();
    static_cast<QScrollArea*>(stack_->widget(row))->setWidget(page.made);
  }
  stack_->setCurrentIndex(row);
}

bool Preferences::show_page(const QString& name) {
  const qsizetype row = page_names().indexOf(name);
  if (row >= 0) list_->setCurrentRow(int(row));
  return row >= 0;
}

QStringList Preferences::page_names() const {
  QStringList names;
  for (const Page& page : pages_) names.push_back(page.name);
  return names;
}

QWidget* Preferences::page(const QString& name) {
  const qsizetype row = page_names().indexOf(name);
  if (row < 0) return nullptr;
  show_row(int(row));
  return pages_[std::size_t(row)].made;
}

}  // namespace felt::desktop
