#include "desktop/panels/tactile_panel.h"

#include <QCoreApplication>
#include <QFormLayout>
#include <QLocale>
#include <QPointer>
#include <QThreadPool>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <variant>

#include "desktop/engine/settings.h"
#include "desktop/panels/panel_setting_keys.h"

namespace felt::desktop {
namespace {

constexpr double kRingMm = 4.0;

QString mm(double value, int digits = 1) {
  return QLocale().toString(value, 'f', digits);
}

}  // namespace

QString tactile_rule_name(TactileRule rule) {
  switch (rule) {
    case TactileRule::kGap:
      return TactilePanel::tr("Gap");
    case TactileRule::kSmallShape:
      return TactilePanel::tr("Small shape");
    case TactileRule::kShortSide:
      return TactilePanel::tr("Short side");
    case TactileRule::kNarrowArea:
      return TactilePanel::tr("Narrow area");
    case TactileRule::kLineStyles:
      return TactilePanel::tr("Line widths");
    case TactileRule::kAreaStyles:
      return TactilePanel::tr("Area colours");
    case TactileRule::kSize:
      return TactilePanel::tr("Size");
    case TactileRule::kThinLine:
      return TactilePanel::tr("Thin line");
  }
  return {};
}

QString tactile_fault_text(const TactileFault& f) {
  switch (f.rule) {
    case TactileRule::kGap:
      return TactilePanel::tr("%1 mm between lines, for %2 mm; at least %3 mm")
          .arg(mm(f.measured), mm(f.length_mm, 0), mm(f.limit));
    case TactileRule::kSmallShape:
    case TactileRule::kShortSide:
      return TactilePanel::tr("%1 mm long; at least %2 mm").arg(mm(f.measured), mm(f.limit));
    case TactileRule::kNarrowArea:
    case TactileRule::kThinLine:
      return TactilePanel::tr("%1 mm wide; at least %2 mm").arg(mm(f.measured), mm(f.limit));
    case TactileRule::kLineStyles:
      return TactilePanel::tr("%1 different widths; at most %2")
          .arg(mm(f.measured, 0), mm(f.limit, 0));
    case TactileRule::kAreaStyles:
      return TactilePanel::tr("%1 colours, which feel the same").arg(mm(f.measured, 0));
    case TactileRule::kSize:
      return TactilePanel::tr("%1 mm; at most %2 mm (A4)").arg(mm(f.measured, 0), mm(f.limit, 0));
  }
  return {};
}

TactilePanel::TactilePanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      print_(new QComboBox(this)),
      summary_(new QLabel(this)),
      list_(new QListWidget(this)) {
  print_->addItem(tr("Swell paper"), TactileLimits().gap_mm);
  print_->addItem(tr("An embosser"), TactileLimits::kEmbossedGapMm);
  print_->setToolTip(tr("Lines on swell paper must be 6.4 mm apart, embossed lines 3.2 mm"));
  const QString key = QString::fromLatin1(panel_keys::kTactileEmbossed);
  print_->setCurrentIndex(Settings::the().flag(key, false) ? 1 : 0);
  summary_->setWordWrap(true);
  list_->setAccessibleName(tr("Faults"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->setContentsMargins(8, 6, 8, 2);
  form->addRow(tr("Made &for:"), print_);
  form->addRow(summary_);
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addLayout(form);
  lines->addWidget(list_, 1);
  delay_.setSingleShot(true);
  delay_.setInterval(kWaitMs);
  connect(&delay_, &QTimer::timeout, this, &TactilePanel::start);
  connect(print_, &QComboBox::currentIndexChanged, this, [this, key](int row) {
    Settings::the().set(key, row == 1);
    wait();
  });
  const auto go = [this](const QListWidgetItem* item) {
    const auto row = static_cast<std::size_t>(list_->row(item));
    if (row < faults_.size()) Q_EMIT wants_position(faults_[row].at);
  };
  connect(list_, &QListWidget::itemClicked, this, go);
  connect(list_, &QListWidget::itemActivated, this, go);
  connect(&studio_, &Studio::edited, this, &TactilePanel::wait);
  connect(&studio_, &Studio::opened, this, &TactilePanel::wait);
  connect(&studio_, &Studio::layer_changed, this, &TactilePanel::wait);
  connect(&studio_, &Studio::page_changed, this, &TactilePanel::wait);
  connect(&studio_, &Studio::event_applied, this, [this](const Event& event) {
    if (std::holds_alternative<UseView>(event.what)) wait();
  });
}

void TactilePanel::set_on(bool on) {
  if (std::exchange(is_on_, on) == on) return;
  if (on) return start();
  delay_.stop();
  waits_ = false;
  Q_EMIT marks_changed({});
}

/// Starts the check when the drawing has come to rest.
void TactilePanel::wait() {
  if (!is_on_) return;
  waits_ = true;
  delay_.start();
}

void TactilePanel::start() {
  if (!is_on_) return;
  if (runs_) {
    waits_ = true;  // take() starts again
    return;
  }
  waits_ = false;
  runs_ = true;
  summary_->setText(tr("Checking…"));
  const TactileLimits limits{.gap_mm = print_->currentData().toDouble(),
                             .paper = studio_.page().paper};
  QThreadPool::globalInstance()->start(
      [asked = QPointer(this), limits, document = studio_.session().seen()] {
        auto faults = check_tactile(document, limits);
        // The pointer is used in the main thread only.
        QMetaObject::invokeMethod(
            qApp,
            [asked, faults = std::move(faults)] {
              if (asked) asked->take(faults);
            },
            Qt::QueuedConnection);
      });
}

void TactilePanel::take(Result<std::vector<TactileFault>> faults) {
  runs_ = false;
  if (!is_on_) return;
  if (waits_ && !delay_.isActive()) delay_.start();
  faults_ = faults ? *std::move(faults) : std::vector<TactileFault>();
  show_faults();
  if (!faults)
    summary_->setText(
        tr("The lines are longer than 100 m: too much for a raised "
           "drawing."));
}

void TactilePanel::show_faults() {
  const std::size_t shown = std::min(faults_.size(), kMaxRows);
  const int row = list_->currentRow();
  list_->clear();
  Overlay marks;
  for (std::size_t i = 0; i < shown; ++i) {
    const TactileFault& fault = faults_[i];
    const QString name = tr("%1 %2").arg(i + 1).arg(tactile_rule_name(fault.rule));
    list_->addItem(tr("%1: %2").arg(name, tactile_fault_text(fault)));
    marks.rings.push_back({fault.at, kRingMm, Overlay::Role::kCut});
    // One label for each rule: hundreds of them would hide the drawing. The faults come rule by
    // rule.
    const bool is_first = i == 0 || faults_[i - 1].rule != fault.rule;
    if (is_first) marks.labels.push_back({fault.at, name.toStdString()});
  }
  // Someone who corrects one fault after another stays at the same place of the list.
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  if (faults_.empty()) {
    summary_->setText(tr("No faults."));
  } else if (shown < faults_.size()) {
    summary_->setText(tr("%1 faults; the first %2 are shown.").arg(faults_.size()).arg(shown));
  } else {
    summary_->setText(tr("Faults: %1. Click one to go to it.").arg(faults_.size()));
  }
  Q_EMIT marks_changed(marks);
}

}  // namespace felt::desktop
