#include "desktop/files/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <utility>

#include "desktop/files/sheet_picture.h"
#include "felt/document/visible_strokes.h"

namespace felt::desktop {
namespace {

constexpr QSize kPicture(150, 106);

QString name_of(const Recovered& recovered) {
  return recovered.name.isEmpty() ? RecoveryDialog::tr("Untitled") : recovered.name;
}

/// "14:32" today, with the day before.
QString time_of(const QDateTime& when) {
  const QLocale locale;
  const QString time = locale.toString(when.time(), QLocale::ShortFormat);
  if (when.date() == QDate::currentDate()) return time;
  return locale.toString(when.date(), QLocale::ShortFormat) + QLatin1Char(' ') + time;
}

QLabel* picture_of(const Recovered& recovered, double ratio, QWidget* parent) {
  auto* label = new QLabel(parent);
  const SheetPage& page = recovered.drawing.page;
  const Rgba paper = page.paper.a > 0 ? page.paper : Rgba{255, 255, 255, 255};
  QImage picture = sheet_thumbnail(visible_strokes(recovered.drawing.document), page.area(),
                                   kPicture * ratio, paper);
  picture.setDevicePixelRatio(ratio);
  label->setPixmap(QPixmap::fromImage(picture));
  label->setFrameShape(QFrame::StyledPanel);
  label->setAlignment(Qt::AlignCenter);
  label->setFixedSize(kPicture + QSize(6, 6));
  label->setAccessibleName(RecoveryDialog::tr("Picture of the drawing"));
  return label;
}

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<Offer> offers, QWidget* parent)
    : QDialog(parent), offers_(std::move(offers)), left_(offers_.size()) {
  setWindowTitle(tr("Recover drawings"));
  auto* all = new QVBoxLayout(this);
  auto* text = new QLabel(tr("Feltline did not close in order. This was not saved:"), this);
  text->setWordWrap(true);
  all->addWidget(text);
  auto* list = new QWidget(this);
  auto* rows = new QVBoxLayout(list);
  rows->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < offers_.size(); ++i) add_row(i, *rows);
  rows->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(list);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  const int shown = std::min<int>(int(offers_.size()), 4);
  scroll->setMinimumSize(list->sizeHint().width() + 24, shown * (kPicture.height() + 24));
  all->addWidget(scroll);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
  later->setToolTip(tr("Keep them, and ask again at the next start"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  all->addWidget(buttons);
}

void RecoveryDialog::add_row(std::size_t i, QVBoxLayout& rows) {
  const Recovered& recovered = offers_[i].recovered;
  auto* row = new QWidget(this);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 4, 0, 4);
  line->setSpacing(14);
  line->addWidget(picture_of(recovered, devicePixelRatioF(), row));
  const int count = int(recovered.drawing.document.stroke_count());
  const QString name = name_of(recovered);
  auto* words = new QVBoxLayout;
  auto* title = new QLabel(name, row);
  title->setTextFormat(Qt::PlainText);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  const QString when = time_of(recovered.when);
  auto* note = new QLabel(count == 1 ? tr("Last changed %1, one line").arg(when)
                                     : tr("Last changed %1, %2 lines").arg(when).arg(count),
                          row);
  auto* keys = new QHBoxLayout;
  auto* recover = new QPushButton(tr("Recover"), row);
  recover->setAccessibleDescription(tr("Recover “%1”").arg(name));
  recover->setDefault(i == 0);
  auto* discard_key = new QPushButton(tr("Discard…"), row);
  discard_key->setAccessibleDescription(tr("Throw “%1” away").arg(name));
  discard_key->setAutoDefault(false);
  keys->addWidget(recover);
  keys->addWidget(discard_key);
  keys->addStretch();
  words->addStretch();
  words->addWidget(title);
  words->addWidget(note);
  words->addLayout(keys);
  words->addStretch();
  line->addLayout(words, 1);
  rows.addWidget(row);
  connect(recover, &QPushButton::clicked, this, [this, i] {
    chosen_ = i;
    Q_EMIT recover_wanted();
    accept();
  });
  connect(discard_key, &QPushButton::clicked, this, [this, i, row] { discard(i, row); });
}

void RecoveryDialog::discard(std::size_t i, QWidget* row) {
  const QString name = name_of(offers_[i].recovered);
  QMessageBox box(QMessageBox::Question, tr("Throw away"), tr("Throw “%1” away?").arg(name),
                  QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setInformativeText(tr("It cannot be brought back."));
  box.setDefaultButton(QMessageBox::Cancel);
  if (box.exec() != QMessageBox::Discard) return;
  offers_[i].folder.remove();
  row->hide();
  if (--left_ == 0) reject();
}

}  // namespace felt::desktop
