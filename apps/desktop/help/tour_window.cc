#include "desktop/help/tour_window.h"

#include <QBoxLayout>
#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <algorithm>
#include <memory>
#include <vector>

#include "desktop/engine/tool_texts.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

constexpr int kFrameMs = 16;
constexpr std::int64_t kMaxNs = 50'000'000;  // limit of the time that a frame plays, even if it is
                                             // late
constexpr qint64 kHurryMs = 10;              // computing time of a frame while acts are skipped
constexpr std::int64_t kHurryStepNs = 4'000'000;
constexpr double kPageWidthMm = 124.0, kPageHeightMm = 140.0;

/// An act consists of the script in a tool's folder and the texts of the tool.
struct Act {
  QString script;  // path of a resource
  ToolAct words;
};

/// Returns the texts of the act whose script is N-ID.ndjson or N-ID-NAME.ndjson; null if the tool
/// has no such act.
const ToolAct* find_act(const std::vector<std::unique_ptr<Tool>>& tools, const QString& script) {
  const QString base = script.section(QLatin1Char('.'), 0, 0);
  const std::string id = base.section(QLatin1Char('-'), 1, 1).toStdString(),
                    name = base.section(QLatin1Char('-'), 2).toStdString();
  const auto tool =
      std::find_if(tools.begin(), tools.end(), [&](const auto& t) { return t->info().id == id; });
  if (tool == tools.end()) return nullptr;
  const ToolInfo& info = (*tool)->info();
  if (name.empty()) return &info.act;
  const auto act = std::find_if(info.more_acts.begin(), info.more_acts.end(),
                                [&](const ToolAct& a) { return a.name == name; });
  return act == info.more_acts.end() ? nullptr : &*act;
}

std::vector<Act> find_acts() {
  const std::vector<std::unique_ptr<Tool>> tools = make_tools();
  std::vector<Act> all;
  QStringList names = QDir(QStringLiteral(":/tour")).entryList(QDir::Files);
  const auto number = [](const QString& name) {
    return name.section(QLatin1Char('-'), 0, 0).toInt();
  };
  std::sort(names.begin(), names.end(),
            [&](const QString& a, const QString& b) { return number(a) < number(b); });
  for (const QString& name : names) {
    const ToolAct* act = find_act(tools, name);
    if (act) all.push_back({QStringLiteral(":/tour/") + name, *act});
  }
  return all;
}

/// Returns the acts in the sequence of their scripts: 1-pencil, 2-pull, ...
const std::vector<Act>& acts() {
  static const std::vector<Act> kActs = find_acts();
  return kActs;
}

}  // namespace

TourWindow::TourWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      studio_(new Studio(
          {.device = QStringLiteral("simulated:touch"), .live = false, .first_options = false},
          this)),
      canvas_(new Canvas(*studio_, this)),
      player_(*studio_) {
  setWindowTitle(tr("Guided tour"));
  setAttribute(Qt::WA_DeleteOnClose);
  studio_->set_page({.width_mm = kPageWidthMm, .height_mm = kPageHeightMm});
  canvas_->setFocusPolicy(Qt::NoFocus);
  canvas_->setAccessibleName(tr("Drawing area of the tour"));
  make_controls();
  resize(760, 820);
  before_.push_back(studio_->session().document());
  start_act();
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(kFrameMs);
  connect(&timer_, &QTimer::timeout, this, &TourWindow::tick);
}

int TourWindow::act_count() const noexcept {
  return int(acts().size());
}

void TourWindow::make_controls() {
  title_ = new QLabel(this);
  QFont font = title_->font();
  font.setPointSizeF(1.5 * font.pointSizeF());
  font.setBold(true);
  title_->setFont(font);
  caption_ = new QLabel(this);
  caption_->setWordWrap(true);
  caption_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  // Reserves space for the longest caption, so that the picture does not jump between acts.
  caption_->setMinimumHeight(3 * caption_->fontMetrics().lineSpacing());
  step_ = new QLabel(this);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  progress_->setAccessibleName(tr("Progress of the tour"));
  back_ = new QPushButton(tr("&Back"), this);
  pause_ = new QPushButton(tr("&Pause"), this);
  next_ = new QPushButton(tr("&Next"), this);
  auto* close = new QPushButton(tr("&Close"), this);
  connect(back_, &QPushButton::clicked, this, [this] { go_to(act_ - 1); });
  connect(pause_, &QPushButton::clicked, this, [this] { set_paused(!is_paused_); });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (act_ < act_count()) return go_to(act_ + 1);
    Q_EMIT drawing_requested(studio_->session().document());
    this->close();
  });
  connect(close, &QPushButton::clicked, this, &QWidget::close);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(step_, 1);
  for (QPushButton* button : {back_, pause_, next_, close}) buttons->addWidget(button);
  auto* words = new QVBoxLayout;
  words->setContentsMargins(16, 10, 16, 12);
  words->addWidget(title_);
  words->addWidget(caption_);
  words->addLayout(buttons);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addWidget(canvas_, 1);
  all->addWidget(progress_);
  all->addLayout(words);
  // The button gets the focus, so that Space pauses from the start.
  pause_->setFocus();
}

void TourWindow::start_act() {
  if (act_ < act_count()) {
    const Act& act = acts()[std::size_t(act_)];
    QFile file(act.script);
    const QByteArray text = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    const Result<void> loaded =
        player_.load(file.fileName(), {text.data(), std::size_t(text.size())});
    if (!loaded) caption_->setText(QString::fromStdString(loaded.error().message));
    speed_ = std::max(1.0, 1e-9 * double(player_.length_ns()) / act.words.seconds);
  }
  show_state();
}

void TourWindow::go_to(int act) {
  act = std::clamp(act, 0, act_count());
  if (act > act_) {
    wanted_ = act;  // the previous acts are drawn fast
    set_paused(false);
    return;
  }
  studio_->apply(CancelEvent{});
  act_ = wanted_ = act;
  before_.resize(std::size_t(act) + 1);
  studio_->open(before_[std::size_t(act)], studio_->page());
  set_paused(false);
  start_act();
}

void TourWindow::set_paused(bool paused) {
  is_paused_ = paused;
  if (isVisible() && !paused) clock_.start();
  show_state();
}

void TourWindow::tick() {
  const std::int64_t ns = clock_.nsecsElapsed();
  clock_.start();
  if (!is_paused_) play(std::min(ns, kMaxNs));
}

void TourWindow::play(std::int64_t ns) {
  if (act_ >= act_count()) return;
  if (wanted_ > act_) {
    QElapsedTimer spent;
    for (spent.start(); !player_.is_over() && spent.elapsed() < kHurryMs;) {
      player_.advance(kHurryStepNs);
    }
  } else {
    player_.advance(std::int64_t(speed_ * double(ns)));
  }
  if (player_.is_over()) {
    before_.push_back(studio_->session().document());
    wanted_ = std::max(wanted_, ++act_);
    start_act();
  }
  show_state();
}

void TourWindow::show_state() {
  const bool is_end = act_ >= act_count();
  const double here = is_end || player_.length_ns() == 0
                          ? 0.0
                          : double(player_.played_ns()) / double(player_.length_ns());
  progress_->setValue(int(1000.0 * (act_ + here) / act_count()));
  const Act* act = is_end ? nullptr : &acts()[std::size_t(act_)];
  title_->setText(act ? translated(act->words.title) : tr("Try it yourself"));
  caption_->setText(act ? translated(act->words.caption)
                        : tr("Draw with a pen or with the mouse. Press ? for the keys. You can "
                             "undo everything with Ctrl+Z."));
  step_->setText(act ? tr("%1 of %2").arg(act_ + 1).arg(act_count()) : QString());
  back_->setEnabled(act_ > 0);
  pause_->setEnabled(!is_end);
  pause_->setText(is_paused_ ? tr("C&ontinue") : tr("&Pause"));
  next_->setText(is_end ? tr("&Try it yourself") : tr("&Next"));
}

void TourWindow::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      close();
      break;
    case Qt::Key_Right:
    case Qt::Key_PageDown:
      go_to(act_ + 1);
      break;
    case Qt::Key_Left:
    case Qt::Key_PageUp:
      go_to(act_ - 1);
      break;
    case Qt::Key_Space:
      set_paused(!is_paused_);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void TourWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  clock_.start();
  timer_.start();
}

void TourWindow::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  timer_.stop();
}

}  // namespace felt::desktop
