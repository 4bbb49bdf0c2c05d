#include "desktop/files/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "desktop/files/page_picture.h"
#include "felt/formats/drawing_materials.h"

namespace felt::desktop {
namespace {

constexpr QSize kThumbnailSize(190, 134);
constexpr int kDrawingsShown = 2;

QString name_of(const Recovered& recovered) {
  return recovered.name.empty() ? RecoveryDialog::tr("Untitled")
                                : QString::fromStdString(recovered.name);
}

/// Returns a time of today as "14:32", and any other time with its date.
QString time_of(const QDateTime& when) {
  const QLocale locale;
  const QString time = locale.toString(when.time(), QLocale::ShortFormat);
  if (when.date() == QDate::currentDate()) return time;
  return locale.toString(when.date(), QLocale::ShortFormat) + QLatin1Char(' ') + time;
}

QString facts_of(const Drawing& drawing, const QDateTime& when) {
  const int count = int(drawing.document.stroke_count());
  return count == 1 ? RecoveryDialog::tr("%1, one line").arg(time_of(when))
                    : RecoveryDialog::tr("%1, %2 lines").arg(time_of(when)).arg(count);
}

QLabel* frame_of(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setFrameShape(QFrame::StyledPanel);
  label->setAlignment(Qt::AlignCenter);
  label->setFixedSize(kThumbnailSize + QSize(6, 6));
  label->setAccessibleName(name);
  return label;
}

QLabel* picture_of(const Drawing& drawing, const QString& name, double ratio, QWidget* parent) {
  QLabel* label = frame_of(name, parent);
  const Page& page = drawing.page;
  const Rgba paper = page.paper.a > 0 ? page.paper : Rgba{255, 255, 255, 255};
  QImage picture = page_thumbnail(drawing.document, page.area(), kThumbnailSize * ratio, paper,
                                  Grain::solid(with_texts(drawing.materials)), PictureChoice::kAll);
  picture.setDevicePixelRatio(ratio);
  label->setPixmap(QPixmap::fromImage(picture));
  return label;
}

QLabel* plain_label(const QString& text, QWidget* parent, bool is_bold = false) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  if (is_bold) {
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
  }
  return label;
}

/// Returns a text that explains why no picture of the file is shown.
QString absence_of(const Recovered& recovered) {
  if (recovered.path.empty()) return RecoveryDialog::tr("It was never saved");
  return QFileInfo::exists(QString::fromStdString(recovered.path))
             ? RecoveryDialog::tr("The file cannot be read")
             : RecoveryDialog::tr("The file is no longer there");
}

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<RecoveryOffer> offers, QWidget* parent)
    : QDialog(parent), offers_(std::move(offers)), left_(offers_.size()) {
  setWindowTitle(tr("Recover drawings"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(
      plain_label(tr("Feltline closed unexpectedly. These drawings have unsaved changes:"), this));
  auto* list = new QWidget(this);
  auto* rows = new QVBoxLayout(list);
  rows->setContentsMargins(0, 0, 0, 0);
  int shown_height = 0;
  for (std::size_t i = 0; i < offers_.size(); ++i) {
    QWidget* row = make_row(i);
    rows->addWidget(row);
    if (i < kDrawingsShown) shown_height += row->sizeHint().height() + rows->spacing();
  }
  rows->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(list);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumSize(list->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width(),
                         shown_height);
  all->addWidget(scroll);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
  later->setToolTip(tr("Keep them, and ask again at the next start"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  all->addWidget(buttons);
}

QWidget* RecoveryDialog::make_row(std::size_t i) {
  const RecoveryOffer& offer = offers_[i];
  const Recovered& recovered = offer.recovered;
  const QString name = name_of(recovered);
  auto* row = new QWidget(this);
  auto* grid = new QGridLayout(row);
  grid->setContentsMargins(0, 4, 0, 14);
  grid->setHorizontalSpacing(18);
  QLabel* title = plain_label(name, row, true);
  title->setToolTip(QString::fromStdString(recovered.path));
  grid->addWidget(title, 0, 0, 1, 2);
  grid->addWidget(picture_of(recovered.drawing, tr("Picture of the recovered drawing"),
                             devicePixelRatioF(), row),
                  1, 0);
  const QDateTime when = QDateTime::fromSecsSinceEpoch(recovered.changed_at_s);
  const auto add_facts = [&](const QString& what, const QString& facts, int column) {
    grid->addWidget(plain_label(what + QLatin1Char('\n') + facts, row), 2, column, Qt::AlignTop);
  };
  add_facts(tr("Recovered"), facts_of(recovered.drawing, when), 0);
  if (offer.saved) {
    grid->addWidget(
        picture_of(offer.saved->drawing, tr("Picture of the saved file"), devicePixelRatioF(), row),
        1, 1);
    add_facts(tr("Saved"), facts_of(offer.saved->drawing, offer.saved->when), 1);
  } else {
    QLabel* frame = frame_of(absence_of(recovered), row);
    frame->setText(absence_of(recovered));
    frame->setWordWrap(true);
    grid->addWidget(frame, 1, 1);
  }
  if (!recovered.problems.empty()) {
    QLabel* warning = plain_label(tr("⚠ Some of it could not be read."), row);
    QStringList problems;
    for (const std::string& problem : recovered.problems) {
      problems.push_back(QString::fromStdString(problem));
    }
    warning->setToolTip(problems.join(QLatin1Char('\n')));
    grid->addWidget(warning, 3, 0, 1, 2);
  }
  grid->addWidget(make_keys(i, row), 4, 0, 1, 2);
  return row;
}

QWidget* RecoveryDialog::make_keys(std::size_t i, QWidget* row) {
  const RecoveryOffer& offer = offers_[i];
  const QString name = name_of(offer.recovered);
  auto* keys = new QWidget(row);
  auto* line = new QHBoxLayout(keys);
  line->setContentsMargins(0, 0, 0, 0);
  auto* recover = new QPushButton(tr("Recover as a new drawing"), keys);
  recover->setAccessibleDescription(tr("Recover “%1”").arg(name));
  recover->setDefault(i == 0);
  line->addWidget(recover);
  if (offer.saved) {
    auto* open = new QPushButton(tr("Open the saved version"), keys);
    open->setAccessibleDescription(tr("Open the saved version of “%1”").arg(name));
    open->setToolTip(tr("The unsaved changes are kept and offered again at the next start"));
    open->setAutoDefault(false);
    line->addWidget(open);
    const QString path = QString::fromStdString(offer.recovered.path);
    connect(open, &QPushButton::clicked, this, [this, path] {
      Q_EMIT open_wanted(path);
      accept();
    });
  }
  auto* discard_key = new QPushButton(tr("Discard…"), keys);
  discard_key->setAccessibleDescription(tr("Discard “%1”").arg(name));
  discard_key->setAutoDefault(false);
  line->addWidget(discard_key);
  line->addStretch();
  connect(recover, &QPushButton::clicked, this, [this, i] {
    chosen_ = i;
    Q_EMIT recover_wanted();
    accept();
  });
  connect(discard_key, &QPushButton::clicked, this, [this, i, row] { discard(i, row); });
  return keys;
}

void RecoveryDialog::discard(std::size_t i, QWidget* row) {
  const QString name = name_of(offers_[i].recovered);
  QMessageBox box(QMessageBox::Question, tr("Discard"),
                  tr("Discard the unsaved changes of “%1”?").arg(name),
                  QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setInformativeText(offers_[i].saved
                             ? tr("This cannot be undone. The saved file does not change.")
                             : tr("This cannot be undone."));
  box.setDefaultButton(QMessageBox::Cancel);
  if (box.exec() != QMessageBox::Discard) return;
  static_cast<void>(std::move(offers_[i].store).remove());
  row->hide();
  if (--left_ == 0) reject();
}

}  // namespace felt::desktop
