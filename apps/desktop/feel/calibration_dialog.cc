#include "desktop/feel/calibration_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <array>
#include <utility>

namespace felt::desktop {
namespace {

constexpr int kLookMs = 20;
constexpr double kGoodMm = 2.0;  // off at a corner: nobody feels it
constexpr QSize kPicturePx{180, 130};

}  // namespace

CalibrationDialog::CalibrationDialog(std::unique_ptr<PenDevice> device, Point middle,
                                     QWidget* parent)
    : QDialog(parent),
      device_(std::move(device)),
      old_(device_->calibration()),
      middle_(middle),
      picture_(new QLabel(this)),
      words_(new QLabel(this)),
      where_(new QLabel(this)) {
  setWindowTitle(tr("Drawing plane of %1").arg(device_->info().label));
  picture_->setAccessibleName(tr("The corner to touch"));
  for (QLabel* label : {words_, where_}) label->setWordWrap(true);
  words_->setMinimumWidth(40 * fontMetrics().averageCharWidth());
  auto* buttons = new QDialogButtonBox(this);
  take_ = buttons->addButton(tr("&Take this place"), QDialogButtonBox::ActionRole);
  again_ = buttons->addButton(tr("&Start again"), QDialogButtonBox::ActionRole);
  keep_ = buttons->addButton(tr("&Keep"), QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  connect(take_, &QPushButton::clicked, this, &CalibrationDialog::take);
  connect(again_, &QPushButton::clicked, this, &CalibrationDialog::start_again);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* text = new QVBoxLayout;
  text->addWidget(words_);
  text->addWidget(where_);
  text->addStretch(1);
  auto* row = new QHBoxLayout;
  row->addWidget(picture_, 0, Qt::AlignTop);
  row->addLayout(text, 1);
  auto* rows = new QVBoxLayout(this);
  rows->addLayout(row);
  rows->addWidget(buttons);
  take_->setEnabled(false);
  for (auto* button : {take_, again_, keep_}) button->setAutoDefault(true);
  clock_.start();
  connect(&timer_, &QTimer::timeout, this, &CalibrationDialog::look);
  timer_.start(kLookMs);
  start_again();
}

CalibrationDialog::~CalibrationDialog() {
  device_->device().stop();
}

void CalibrationDialog::run(Studio& studio, QWidget* parent) {
  const QString id = studio.device().info().id;
  const Rect page = studio.page().area();
  // One program at a time: the loop lets go of it first.
  if (!studio.use_device(QString::fromLatin1(kPenDeviceDefault))) return;
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(id);
  if (!device) {
    Q_EMIT studio.refused(QString::fromStdString(device.error().message));
    return;
  }
  {
    CalibrationDialog dialog(*std::move(device),
                             {0.5 * (page.x0 + page.x1), 0.5 * (page.y0 + page.y1)}, parent);
    if (dialog.exec() == QDialog::Accepted && dialog.found()) {
      keep_plane_of(id, dialog.found()->calibration);
    }
  }
  studio.use_device(id);
}

std::uint32_t CalibrationDialog::read() {
  const auto sample = device_->device().read(clock_.nsecsElapsed());
  place_.reset();
  if (sample && is_finite(sample->position)) place_ = old_.to_device(sample->position);
  const std::uint32_t before = std::exchange(buttons_, sample ? sample->buttons : 0);
  return buttons_ & ~before;
}

void CalibrationDialog::look() {
  if ((read() & 1u) != 0) take();
  tell();
}

void CalibrationDialog::take() {
  read();  // where it is now, not where it was when it was looked at last
  if (!place_ || corners_.size() == kCorners) return;
  corners_.push_back(*place_);
  if (corners_.size() == kCorners) {
    const double width = norm(corners_[1] - corners_[0]), height = norm(corners_[2] - corners_[0]);
    const auto touches = corner_touches(corners_[0], corners_[1], corners_[2],
                                        middle_ - Vec{0.5 * width, 0.5 * height});
    if (Result<PlaneFit> fit = fit_plane(touches)) {
      found_ = *fit;
    } else {
      corners_.clear();
      words_->setText(tr("That is no drawing area: %1. Begin with the upper left corner again.")
                          .arg(QString::fromStdString(fit.error().message)));
      draw_corners();
      return;
    }
  }
  draw_corners();
  static const std::array<const char*, kCorners + 1> kWords{
      QT_TR_NOOP("Hold the pen's tip on the upper left corner of where you want to draw."),
      QT_TR_NOOP("Now on the upper right corner."), QT_TR_NOOP("Now on the lower left corner."),
      ""};
  if (!found_) {
    words_->setText(tr(kWords[corners_.size()]));
    return;
  }
  const QString size = tr("The drawing area is %L1 mm wide and %L2 mm high.")
                           .arg(norm(corners_[1] - corners_[0]), 0, 'f', 0)
                           .arg(norm(corners_[2] - corners_[0]), 0, 'f', 0);
  const QString fit =
      found_->worst_mm <= kGoodMm
          ? tr("Its corners fit within %L1 mm.").arg(found_->worst_mm, 0, 'f', 1)
          : tr("Its corner is not square: %L1 mm off. Starting again may be better.")
                .arg(found_->worst_mm, 0, 'f', 1);
  words_->setText(size + QLatin1Char(' ') + fit);
}

void CalibrationDialog::start_again() {
  corners_.clear();
  found_.reset();
  words_->setText(tr("Hold the pen's tip on the upper left corner of where you want to draw."));
  draw_corners();
  tell();
}

void CalibrationDialog::tell() {
  const bool could_take = take_->isEnabled();
  take_->setEnabled(place_.has_value() && corners_.size() < kCorners);
  again_->setEnabled(!corners_.empty());
  keep_->setEnabled(found_.has_value());
  // Space and Enter always do what comes next: one hand holds the pen.
  if (take_->isEnabled() && !could_take) take_->setFocus();
  if (keep_->isEnabled() && could_take && !take_->isEnabled()) keep_->setFocus();
  if (!place_) {
    where_->setText(tr("The device does not answer. Check its cable and power."));
    return;
  }
  const Vec3& p = *place_;
  const QString place = tr("The pen is at %L1, %L2, %L3 mm.")
                            .arg(p.x, 0, 'f', 1)
                            .arg(p.y, 0, 'f', 1)
                            .arg(p.z, 0, 'f', 1);
  if (!found_) {
    where_->setText(place);
    return;
  }
  where_->setText(tr("The pen is %L1 mm above the drawing plane.")
                      .arg(found_->calibration.to_sheet(p).z, 0, 'f', 1));
}

void CalibrationDialog::draw_corners() {
  const qreal dpr = devicePixelRatioF();
  QPixmap pixmap(kPicturePx * dpr);
  pixmap.setDevicePixelRatio(dpr);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF sheet = QRectF(QPointF(0, 0), kPicturePx).adjusted(16, 16, -16, -16);
  const QColor line = palette().color(QPalette::WindowText);
  painter.setPen(QPen(line, 1.2));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRect(sheet);
  const std::array<QPointF, kCorners> corners{sheet.topLeft(), sheet.topRight(),
                                              sheet.bottomLeft()};
  for (std::size_t i = 0; i < kCorners; ++i) {
    const bool is_known = i < corners_.size(), is_next = i == corners_.size();
    painter.setBrush(is_known ? line : palette().color(QPalette::Base));
    painter.setPen(QPen(is_next ? palette().color(QPalette::Highlight) : line, is_next ? 3 : 1.2));
    painter.drawEllipse(corners[i], is_next ? 10.0 : 6.0, is_next ? 10.0 : 6.0);
    if (is_known) continue;
    painter.setPen(line);
    painter.drawText(QRectF(corners[i] - QPointF(10, 10), QSizeF(20, 20)), Qt::AlignCenter,
                     QString::number(i + 1));
  }
  picture_->setPixmap(pixmap);
}

}  // namespace felt::desktop
