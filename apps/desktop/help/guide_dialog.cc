#include "desktop/help/guide_dialog.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QTextDocument>

#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

QString paragraph(const QString& title, const QString& text) {
  return QStringLiteral("<p><b>%1</b><br>%2</p>").arg(title.toHtmlEscaped(), text.toHtmlEscaped());
}

QString tools_part(const Actions& actions) {
  QString part;
  for (const auto& tool : make_tools()) {
    const ToolInfo& info = tool->info();
    QString title = QCoreApplication::translate("tools", info.label.data());
    const QAction* action = actions.find(
        QStringLiteral("tool.") + QString::fromUtf8(info.id.data(), qsizetype(info.id.size())));
    const QString key = action ? action->shortcut().toString(QKeySequence::NativeText) : QString();
    if (!key.isEmpty()) title += QStringLiteral(" (%1)").arg(key);
    part += paragraph(title, QCoreApplication::translate("tools", info.help.data()));
  }
  return part;
}

}  // namespace

GuideDialog::GuideDialog(const Actions& actions, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Guide"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(620, 680);
  const auto heading = [](const QString& text) {
    return QStringLiteral("<h3>%1</h3>").arg(text.toHtmlEscaped());
  };
  const auto say = [](const QString& text) {
    return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
  };
  QString page = heading(tr("Draw, then correct"));
  page +=
      say(tr("Draw with a pen or with the mouse. You do not need to redraw a line that is not "
             "right: pull it, push it, smooth it, make it broader. You can undo every step."));
  page +=
      say(tr("Press a tool's key briefly to choose the tool. Hold the key to use the tool only "
             "until you release it."));
  page += heading(tr("Tools")) + tools_part(actions);
  page += heading(tr("The view"));
  page +=
      say(tr("The wheel zooms at the pointer. Hold Space and drag to move the view, with Shift to "
             "turn it. None of this changes the drawing."));
  page += heading(tr("The feel"));
  page +=
      say(tr("Every tool resists. With a force-feedback pen you feel this in your hand. With a "
             "tablet or a mouse you see it: as an arrow at the nib and in the panel Forces. Press "
             "Esc twice to switch off all forces immediately."));
  page += heading(tr("Files"));
  page +=
      say(tr("Drawings are saved as .felt files, with their layers and pen pressure. You can "
             "export SVG, PDF and PNG for other programs."));
  auto* text = new QTextBrowser(this);
  text->setAccessibleName(tr("Guide"));
  text->setFrameShape(QFrame::NoFrame);
  text->document()->setDocumentMargin(16);
  text->setHtml(page);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->addWidget(text, 1);
  all->addWidget(buttons);
}

}  // namespace felt::desktop
