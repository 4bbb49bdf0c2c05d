#include "desktop/feel/force_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>

#include "desktop/feel/feel_icons.h"
#include "desktop/feel/safety_words.h"

namespace felt::desktop {
namespace {

constexpr int kFrameMs = 33;         // time between two repaints of the plot
constexpr int kWordsMs = 250;        // time between two updates of the numbers
constexpr int kReportedTables = 12;  // number of table updates between two announcements (3 s)
constexpr int kStopIconPx = 22;
constexpr int kNameColumn = 0, kNowColumn = 1, kMaxColumn = 2;

QIcon track_icon(std::size_t track, const QPalette& palette, qreal dpr) {
  const TrackStyle style = track_style(track, palette);
  QPixmap pixmap(QSizeF(24 * dpr, 14 * dpr).toSize());
  pixmap.setDevicePixelRatio(dpr);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(style.color, style.width));
  painter.drawLine(QPointF(1, 7), QPointF(23, 7));
  painter.setBrush(style.color);
  draw_mark(painter, style.mark, {12, 7}, 3.0);
  return pixmap;
}

QLabel* wrapped(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  return label;
}

QString microseconds(std::int64_t ns) {
  return ForcePanel::tr("%L1 µs").arg(static_cast<double>(ns) / 1000.0, 0, 'f', 0);
}

QString scheduling_in_words(const RealtimeStatus& status) {
  if (status.is_silent) return ForcePanel::tr("The loop has stopped: the device does not answer.");
  switch (status.scheduling) {
    case LoopScheduling::kNotRunning:
      return ForcePanel::tr("The loop is not running.");
    case LoopScheduling::kFifo:
      return ForcePanel::tr("Real-time scheduling.");
    case LoopScheduling::kNice:
      return ForcePanel::tr("Raised priority, no real-time scheduling.");
    case LoopScheduling::kOrdinary:
      return ForcePanel::tr("Ordinary scheduling: late if the computer is busy.");
    case LoopScheduling::kHost:
      return ForcePanel::tr("The device's own software runs the loop.");
  }
  return {};
}

}  // namespace

ForcePanel::ForcePanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      layout_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      graph_(new ForceGraph(history_, this)),
      table_(new QTableWidget(0, 3, this)),
      icon_(new QLabel(this)),
      state_(wrapped(this)),
      detail_(wrapped(this)),
      loop_(wrapped(this)),
      pause_(new QToolButton(this)) {
  setAccessibleName(tr("Forces"));
  table_->setHorizontalHeaderLabels({tr("Force"), tr("Now"), tr("Maximum")});
  table_->setAccessibleName(tr("Forces by name"));
  table_->setAccessibleDescription(tr("Each force now and its maximum in the last seconds"));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  table_->horizontalHeader()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(kNowColumn, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kMaxColumn, QHeaderView::ResizeToContents);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setShowGrid(false);
  table_->setIconSize({24, 14});
  table_->setMinimumWidth(26 * fontMetrics().averageCharWidth());
  table_->setTabKeyNavigation(false);

  auto* side = new QVBoxLayout;
  auto* head = new QHBoxLayout;
  head->addWidget(icon_, 0, Qt::AlignTop);
  head->addWidget(state_, 1);
  QFont strong = font();
  strong.setBold(true);
  state_->setFont(strong);
  pause_->setText(tr("Pause"));
  pause_->setCheckable(true);
  pause_->setToolTip(tr("Pause the plot"));
  connect(pause_, &QToolButton::toggled, this, &ForcePanel::set_paused);
  side->addLayout(head);
  side->addWidget(detail_);
  side->addWidget(loop_);
  side->addStretch(1);
  side->addWidget(pause_, 0, Qt::AlignLeft);
  layout_->addWidget(graph_, 5);
  layout_->addWidget(table_, 2);
  layout_->addLayout(side, 2);

  frame_.setSingleShot(true);
  frame_.setInterval(kFrameMs);
  connect(&frame_, &QTimer::timeout, graph_, qOverload<>(&QWidget::update));
  words_.setInterval(kWordsMs);
  connect(&words_, &QTimer::timeout, this, &ForcePanel::report);
  connect(&studio_.loop(), &HapticLoop::ticked, this, &ForcePanel::take);
  connect(&studio_.loop(), &HapticLoop::device_changed, this, &ForcePanel::use_device);
  connect(&studio_.loop(), &HapticLoop::started, this, &ForcePanel::show_bounds);
  connect(&studio_.loop(), &HapticLoop::forces_changed, this, &ForcePanel::report);
  use_device();
}

void ForcePanel::set_paused(bool paused) {
  pause_->setChecked(paused);
  if (paused) held_ = history_;
  graph_->show_history(paused ? held_ : history_);
}

void ForcePanel::take(const TickReport& tick) {
  history_.add(tick);
  if (isVisible() && !pause_->isChecked() && !frame_.isActive()) frame_.start();
}

void ForcePanel::use_device() {
  has_motors_ = studio_.loop().device().device().capabilities().has_force();
  history_.clear();
  held_.clear();
  table_->setRowCount(0);
  show_bounds();
  graph_->set_shows_sent(has_motors_);
  report();
}

void ForcePanel::show_bounds() {
  const SafetyLimits& limits = studio_.loop().servo().options().limits;
  std::vector<ForceBound> bounds;
  if (has_motors_) {
    bounds.push_back(
        {tr("maximum, %L1 N").arg(limits.peak_force_n, 0, 'g', 3), limits.peak_force_n});
    if (limits.continuous_force_n > 0.0 && limits.continuous_force_n < limits.peak_force_n) {
      bounds.push_back({tr("continuous, %L1 N").arg(limits.continuous_force_n, 0, 'g', 2),
                        limits.continuous_force_n});
    }
  }
  graph_->set_bounds(std::move(bounds));
}

void ForcePanel::report() {
  report_state();
  if (!isVisible()) return;
  if (!pause_->isChecked()) report_table();
  report_loop();
}

void ForcePanel::report_table() {
  int row = 0;
  for (std::size_t track = 0; track < history_.tracks(); ++track) {
    if (track == ForceHistory::kSent && !has_motors_) continue;
    if (row == table_->rowCount()) {
      table_->insertRow(row);
      for (const int column : {kNameColumn, kNowColumn, kMaxColumn}) {
        auto* item = new QTableWidgetItem;
        if (column != kNameColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(row, column, item);
      }
    }
    QTableWidgetItem* name = table_->item(row, kNameColumn);
    if (const QString label = term_label(history_.name(track)); name->text() != label) {
      name->setText(label);
      name->setIcon(track_icon(track, palette(), devicePixelRatioF()));
    }
    const auto newton = [](float value) {
      return tr("%L1 N").arg(static_cast<double>(value), 0, 'f', 2);
    };
    table_->item(row, kNowColumn)->setText(newton(history_.now(track)));
    table_->item(row, kMaxColumn)->setText(newton(history_.largest(track)));
    ++row;
  }
  // The state is announced to screen readers only rarely, because they would otherwise read
  // nothing else.
  if (++reported_tables_ % kReportedTables != 1) return;
  graph_->setAccessibleDescription(
      tr("Requested: %L1 N, recently at most %L2 N. The table lists each force.")
          .arg(static_cast<double>(history_.now(ForceHistory::kAsked)), 0, 'f', 1)
          .arg(static_cast<double>(history_.largest(ForceHistory::kAsked)), 0, 'f', 1));
}

void ForcePanel::report_state() {
  const SafetyReport& safety = studio_.loop().tick().safety;
  const SafetyWords words = words_for(safety, has_motors_, studio_.loop().forces_are_on(),
                                      studio_.loop().device_status().last_fault);
  if (state_->text() != words.state || icon_->pixmap(Qt::ReturnByValue).isNull()) {
    state_->setText(words.state);
    icon_->setPixmap(level_icon(words.level, palette(), kStopIconPx, devicePixelRatioF()));
    icon_->setAccessibleName(words.state);
  }
  QString detail = words.detail;
  if (safety.motors_are_warm) {
    detail += (detail.isEmpty() ? QString() : QStringLiteral(" ")) +
              tr("The motors are warm, so forces are reduced for a while.");
  }
  if (detail_->text() != detail) detail_->setText(detail);
  detail_->setVisible(!detail.isEmpty());
}

void ForcePanel::report_loop() {
  QStringList lines;
  RealtimeThread* loop = studio_.loop().thread();
  const LoopStats& stats = loop ? loop->stats() : studio_.loop().servo().stats();
  lines
      << tr("Loop: %L1 Hz, missed ticks: %L2").arg(stats.rate_hz(), 0, 'f', 0).arg(stats.missed());
  lines << tr("Delay: usually %1, 1 in 100 %2")
               .arg(microseconds(stats.lateness().percentile_ns(0.5)),
                    microseconds(stats.lateness().percentile_ns(0.99)));
  if (loop) lines << scheduling_in_words(loop->status());
  if (has_motors_) {
    const SafetyReport& safety = studio_.loop().tick().safety;
    lines << tr("Motors: %L1 N on average").arg(safety.rms_force_n, 0, 'f', 2);
    lines << tr("Work on the hand: %L1 mJ").arg(safety.energy_mj, 0, 'f', 1);
  }
  if (const QString text = lines.join(QLatin1Char('\n')); loop_->text() != text)
    loop_->setText(text);
}

void ForcePanel::resizeEvent(QResizeEvent* event) {
  // Shows plot and table side by side if the panel is wide enough, otherwise one below the other.
  const bool wide = width() > 2 * height() && width() > 90 * fontMetrics().averageCharWidth();
  layout_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

void ForcePanel::showEvent(QShowEvent* event) {
  words_.start();
  report();
  QWidget::showEvent(event);
}

void ForcePanel::hideEvent(QHideEvent* event) {
  words_.stop();
  frame_.stop();
  QWidget::hideEvent(event);
}

void ForcePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
    state_->clear();  // its icons have the colours of the old palette
    table_->setRowCount(0);
    report();
  }
  QWidget::changeEvent(event);
}

}  // namespace felt::desktop
