#include "desktop/help/shortcut_sheet.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTextDocument>

#include "desktop/help/key_table.h"

namespace felt::desktop {

ShortcutSheet::ShortcutSheet(const Actions& actions, QWidget* parent)
    : QDialog(parent),
      actions_(actions),
      search_(new QLineEdit(this)),
      page_(new QTextBrowser(this)) {
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(900, 640);
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search the shortcuts"));
  search_->setClearButtonEnabled(true);
  page_->setAccessibleName(tr("Keys"));
  page_->setFrameShape(QFrame::NoFrame);
  page_->document()->setDocumentMargin(12);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* print = buttons->addButton(tr("&Print\u2026"), QDialogButtonBox::ActionRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(print, &QPushButton::clicked, this, &ShortcutSheet::print);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutSheet::refresh);
  connect(&actions, &Actions::keys_changed, this, &ShortcutSheet::refresh);
  auto* all = new QVBoxLayout(this);
  all->addWidget(search_);
  all->addWidget(page_, 1);
  all->addWidget(buttons);
  refresh();
  search_->setFocus();
}

void ShortcutSheet::refresh() {
  const QVector<KeyGroup> groups = key_groups(actions_, search_->text().trimmed());
  page_->setHtml(groups.isEmpty()
                     ? QStringLiteral("<p>%1</p>").arg(tr("No shortcut found.").toHtmlEscaped())
                     : key_page(groups, 2, palette()));
}

void ShortcutSheet::print() {
  QPrinter printer(QPrinter::HighResolution);
  QPrintDialog dialog(&printer, this);
  if (dialog.exec() != QDialog::Accepted) return;
  QPalette paper;
  paper.setColor(QPalette::AlternateBase, QColor(0xee, 0xee, 0xee));
  QTextDocument page;
  page.setHtml(QStringLiteral("<h2>%1</h2>").arg(windowTitle().toHtmlEscaped()) +
               key_page(key_groups(actions_), 2, paper));
  page.print(&printer);
}

void ShortcutSheet::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

void ShortcutSheet::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  refresh();
}

}  // namespace felt::desktop
