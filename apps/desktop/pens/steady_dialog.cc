#include "desktop/pens/steady_dialog.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "felt/stroke/steady/shake_finder.h"

namespace felt::desktop {
namespace {

constexpr auto kOn = "pencil.steady", kHz = "pencil.steady_hz", kMm = "pencil.steady_mm",
               kAxis = "pencil.steady_axis_deg";

double number_of(const Session& session, const char* id, double fallback) {
  const Result<OptionValue> value = session.option(id);
  const auto* number = value ? std::get_if<double>(&*value) : nullptr;
  return number ? *number : fallback;
}

/// Returns why nothing was found, in the language of the program.
QString why_not(const SpiralArea& area) {
  // The spiral was drawn for long enough, but has gaps, which leave lines that are too short.
  if (area.drawn_s() >= kMinSpiralS && spiral_s(area.samples()) < kMinSpiralS) {
    return SteadyDialog::tr(
        "The computer was too busy and missed parts of the spiral. Close other programs, then "
        "start again.");
  }
  if (spiral_s(area.samples()) < kMinSpiralS) {
    return SteadyDialog::tr(
        "That was too short. Draw slowly, for about ten seconds, without lifting the pen.");
  }
  if (static_cast<double>(area.samples().size()) < kMinSpiralHz * area.drawn_s()) {
    return SteadyDialog::tr("This pen reports its position too rarely to measure a shaking.");
  }
  return SteadyDialog::tr("No shaking was found, so there is nothing to remove.");
}

}  // namespace

QString shake_words(const Shake& shake) {
  return SteadyDialog::tr("%L1 times a second, by %L2 mm to each side")
      .arg(shake.hz, 0, 'f', 1)
      .arg(shake.amplitude_mm, 0, 'f', 1);
}

Shake shake_of(const Session& session) {
  const Shake usual;
  return {number_of(session, kHz, usual.hz), number_of(session, kMm, usual.amplitude_mm),
          number_of(session, kAxis, usual.axis_deg)};
}

void use_shake(Studio& studio, const Shake& shake) {
  studio.apply(SetOption{kHz, shake.hz});
  studio.apply(SetOption{kMm, shake.amplitude_mm});
  studio.apply(SetOption{kAxis, shake.axis_deg});
  studio.apply(SetOption{kOn, true});
}

SteadyDialog::SteadyDialog(Studio& studio, QWidget* parent)
    : QDialog(parent),
      studio_(studio),
      area_(new SpiralArea(this)),
      bar_(new QProgressBar(this)),
      result_(new QLabel(this)) {
  setWindowTitle(tr("Measure the hand"));
  auto* layout = new QVBoxLayout(this);
  QString words =
      tr("Trace the spiral slowly, from the middle outwards, without resting the hand. It takes "
         "about ten seconds. What is measured stays on this computer.");
  const bool is_held = studio.loop().device().hand() == nullptr;
  if (is_held) words += QLatin1Char(' ') + tr("The spiral begins where your device touches first.");
  auto* text = new QLabel(words, this);
  text->setWordWrap(true);
  layout->addWidget(text);
  layout->addWidget(area_, 1);
  bar_->setRange(0, 100);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("How much of the ten seconds is drawn"));
  layout->addWidget(bar_);
  result_->setWordWrap(true);
  result_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  layout->addWidget(result_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  use_ = buttons->addButton(tr("&Use"), QDialogButtonBox::AcceptRole);
  again_ = buttons->addButton(tr("&Start again"), QDialogButtonBox::ResetRole);
  layout->addWidget(buttons);
  connect(area_, &SpiralArea::drawn, this, &SteadyDialog::show_progress);
  connect(area_, &SpiralArea::lifted, this, &SteadyDialog::measure);
  connect(again_, &QPushButton::clicked, this, &SteadyDialog::start_again);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    if (found_) use_shake(studio_, *found_);
    accept();
  });
  studio.lend_pen(true);
  if (is_held) {
    connect(&studio, &Studio::sampled, this, [this] { area_->add(studio_.pen().sample); });
  }
  start_again();
}

SteadyDialog::~SteadyDialog() {
  studio_.lend_pen(false);
}

void SteadyDialog::start_again() {
  area_->clear();
  found_.reset();
  result_->clear();
  show_progress();
}

void SteadyDialog::show_progress() {
  bar_->setValue(static_cast<int>(std::lround(100.0 * std::min(area_->drawn_s() / kEnoughS, 1.0))));
  use_->setEnabled(found_.has_value());
  again_->setEnabled(!area_->samples().empty());
}

void SteadyDialog::measure() {
  found_.reset();
  if (const Result<Shake> shake = find_shake(area_->samples())) {
    found_ = *shake;
    result_->setText(tr("The hand shakes %1.").arg(shake_words(*shake)));
  } else {
    result_->setText(why_not(*area_));
  }
  show_progress();
}

}  // namespace felt::desktop
