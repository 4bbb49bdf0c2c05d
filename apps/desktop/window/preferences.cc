#include "desktop/window/preferences.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>

#include "desktop/devices/device_page.h"
#include "desktop/panels/tool_icons.h"
#include "desktop/pens/pens_page.h"
#include "desktop/pens/steady_group.h"
#include "desktop/window/canvas_page.h"
#include "desktop/window/general_page.h"
#include "desktop/window/shortcuts_page.h"

namespace felt::desktop {
namespace {

constexpr QSize kFirstDialogSize{800, 580};
constexpr int kIconPx = 22, kMinListPx = 150, kListMarginPx = 36, kRowMarginPx = 16;
constexpr double kTitleSize = 1.35;

}  // namespace

Preferences::Preferences(MainWindow& window)
    : QDialog(&window), list_(new QListWidget(this)), stack_(new QStackedWidget(this)) {
  setWindowTitle(tr("Preferences"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(kFirstDialogSize);
  list_->setAccessibleName(tr("Pages of the preferences"));
  list_->setIconSize({kIconPx, kIconPx});
  list_->setSpacing(1);
  Actions& actions = window.actions();
  add(QStringLiteral("general"), "preferences", tr("General"), [] { return new GeneralPage; });
  add(QStringLiteral("pen"), "pen-pressure", tr("Pen"), [&window] {
    auto* page = new PensPage;
    page->add_group(new SteadyGroup(window.studio()));
    return page;
  });
  add(QStringLiteral("device"), "device", tr("Device"),
      [&window] { return new DevicePage(window.studio(), &window.care()); });
  add(QStringLiteral("canvas"), "page", tr("Canvas"), [] { return new CanvasPage; });
  add(QStringLiteral("shortcuts"), "keyboard", tr("Shortcuts"),
      [&actions] { return new ShortcutsPage(actions); });
  list_->setFixedWidth(std::max(kMinListPx, list_->sizeHintForColumn(0) + kListMarginPx));
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

void Preferences::add(const QString& name, const char* icon, const QString& title,
                      std::function<QWidget*()> make) {
  pages_.push_back({name, std::move(make)});
  auto* item = new QListWidgetItem(icon_of(icon), title, list_);
  item->setSizeHint(QSize(0, fontMetrics().height() + kRowMarginPx));
  // A page that is too large scrolls, so that the dialog keeps its size.
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
    auto* content = new QWidget;
    auto* lines = new QVBoxLayout(content);
    lines->setContentsMargins(0, 0, kRowMarginPx / 2, 0);
    lines->setSpacing(kRowMarginPx);
    auto* title = new QLabel(list_->item(row)->text(), content);
    QFont font = title->font();
    font.setPointSizeF(kTitleSize * font.pointSizeF());
    font.setBold(true);
    title->setFont(font);
    lines->addWidget(title);
    lines->addWidget(page.made, 1);
    if (page.made->layout()) page.made->layout()->setContentsMargins(0, 0, 0, 0);
    static_cast<QScrollArea*>(stack_->widget(row))->setWidget(content);
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
