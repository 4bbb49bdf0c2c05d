#include "desktop/devices/homing_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "desktop/feel/feel_icons.h"

namespace felt::desktop {
namespace {

constexpr int kSignPx = 40;
constexpr double kTitleSize = 1.2;

}  // namespace

HomingDialog::HomingDialog(PenDevice& device, QWidget* parent)
    : QDialog(parent),
      device_(device),
      homing_(device.device().homing()),
      sign_(new QLabel(this)),
      title_(new QLabel(this)),
      words_(new QLabel(this)),
      error_(new QLabel(this)),
      bar_(new QProgressBar(this)) {
  setWindowTitle(tr("Home position of %1").arg(device_.info().label));
  mover_.setMaxThreadCount(1);
  const bool by_itself = homing_ == Homing::kByItself;
  sign_->setPixmap(level_icon(by_itself ? FeelLevel::kLimited : FeelLevel::kWaiting, palette(),
                              kSignPx, devicePixelRatioF()));
  QFont large = title_->font();
  large.setPointSizeF(kTitleSize * large.pointSizeF());
  large.setBold(true);
  title_->setFont(large);
  for (QLabel* label : {title_, words_, error_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setMinimumWidth(52 * fontMetrics().averageCharWidth());
  }
  bar_->setRange(0, 0);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Finding the home position"));
  auto* buttons = new QDialogButtonBox(this);
  go_ = buttons->addButton(by_itself ? tr("Let it &move") : tr("It is &in place"),
                           QDialogButtonBox::ActionRole);
  not_now_ = buttons->addButton(tr("&Not now"), QDialogButtonBox::RejectRole);
  connect(go_, &QPushButton::clicked, this, &HomingDialog::begin);
  connect(not_now_, &QPushButton::clicked, this, &HomingDialog::reject);
  auto* text = new QVBoxLayout;
  for (QLabel* label : {title_, words_, error_}) text->addWidget(label);
  text->addWidget(bar_);
  text->addStretch(1);
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  row->addWidget(sign_, 0, Qt::AlignTop);
  row->addLayout(text, 1);
  auto* rows = new QVBoxLayout(this);
  rows->addLayout(row, 1);
  rows->addWidget(buttons);
  error_->hide();
  ask();
}

HomingDialog::~HomingDialog() {
  mover_.waitForDone();
}

bool HomingDialog::bring_home(PenDevice& device, QWidget* parent) {
  if (device.device().homing() == Homing::kNone) return true;
  HomingDialog dialog(device, parent);
  return dialog.exec() == QDialog::Accepted;
}

void HomingDialog::ask() {
  is_under_way_ = false;
  bar_->hide();
  go_->setEnabled(true);
  not_now_->setEnabled(true);
  QString words;
  switch (homing_) {
    case Homing::kNone:
      break;
    case Homing::kByItself:
      title_->setText(tr("Allow its arm to move by itself?"));
      words =
          tr("%1 moves its arm to find its home position: for a few seconds, over its whole reach, "
             "with the force that it needs. Let go of the arm, clear the space around it, and keep "
             "hair, sleeves and cups away. You can stop it at any time with its power switch.");
      break;
    case Homing::kRestPose:
      title_->setText(tr("Bring the arm to its rest pose"));
      words = tr("%1 uses its rest pose as its home position. Nothing moves by itself.");
      break;
    case Homing::kInkwell:
      title_->setText(tr("Put the stylus into the inkwell"));
      words =
          tr("%1 finds its position while its stylus is in the inkwell, the hole in its base. "
             "Nothing moves by itself.");
      break;
  }
  words = words.arg(device_.info().label);
  if (const std::string more = device_.device().homing_words(); !more.empty()) {
    words += QStringLiteral("\n\n") + QString::fromStdString(more);
  }
  words_->setText(words);
  // The default button never starts the movement of an arm, so that Enter does not start it.
  QPushButton* usual = homing_ == Homing::kByItself ? not_now_ : go_;
  for (QPushButton* button : {go_, not_now_}) {
    button->setAutoDefault(button == usual);
    button->setDefault(button == usual);
  }
  usual->setFocus();
}

void HomingDialog::begin() {
  if (is_under_way_) return;
  is_under_way_ = true;
  error_->hide();
  bar_->show();
  go_->setEnabled(false);
  not_now_->setEnabled(false);
  if (homing_ == Homing::kByItself) {
    title_->setText(tr("It is moving: keep your hands away"));
  } else {
    title_->setText(tr("Hold it still for a moment"));
  }
  mover_.start([this] {
    Result<void> home = device_.device().find_home();
    QMetaObject::invokeMethod(
        this, [this, home = std::move(home)] { take(home); }, Qt::QueuedConnection);
  });
}

void HomingDialog::take(const Result<void>& home) {
  if (home && device_.device().homing() == Homing::kNone) {
    is_under_way_ = false;
    return accept();
  }
  ask();
  error_->setText(home ? tr("It did not find its home position. Try again.")
                       : tr("This failed: %1").arg(QString::fromStdString(home.error().message)));
  error_->show();
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

void HomingDialog::reject() {
  if (!is_under_way_) QDialog::reject();
}

}  // namespace felt::desktop
