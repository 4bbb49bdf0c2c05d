#include "desktop/help/about_dialog.h"

#include <QApplication>
#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QIcon>
#include <QLabel>

namespace felt::desktop {
namespace {

constexpr int kIconPx = 96;
constexpr auto kPaper =
    "C. Raymaekers, G. Vansichem, F. Van Reeth: <i>Improving Sketching by Utilizing Haptic "
    "Feedback</i>, AAAI 2002";
constexpr auto kLibraries =
    "Anti-Grain Geometry, expected, fmt, nlohmann/json, libpng, pugixml, simdjson, SQLite";

}  // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About Feltline"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* icon = new QLabel(this);
  icon->setPixmap(QApplication::windowIcon().pixmap(QSize(kIconPx, kIconPx), devicePixelRatioF()));
  icon->setAccessibleName(tr("Icon of Feltline"));
  auto* text = new QLabel(this);
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text->setMinimumWidth(26 * text->fontMetrics().averageCharWidth() * 2);
  text->setText(
      QStringLiteral("<h2>Feltline %1</h2><p>%2</p><p>%3<br>%4</p><p>%5<br>%6</p><p>%7</p>")
          .arg(QStringLiteral(FELT_VERSION),
               tr("Sketching that you can feel: ink that resists, lines that you correct by "
                  "pulling and pushing."),
               tr("Based on an idea in this paper:"), QString::fromLatin1(kPaper),
               tr("Built with Qt %1 and these libraries:").arg(QString::fromLatin1(qVersion())),
               QString::fromLatin1(kLibraries),
               tr("Free software under the Apache License 2.0. It comes without any warranty.")));
  auto* top = new QHBoxLayout;
  top->setSpacing(20);
  top->addWidget(icon, 0, Qt::AlignTop);
  top->addWidget(text, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(20, 20, 20, 14);
  all->addLayout(top);
  all->addWidget(buttons);
  all->setSizeConstraint(QLayout::SetFixedSize);
}

}  // namespace felt::desktop
