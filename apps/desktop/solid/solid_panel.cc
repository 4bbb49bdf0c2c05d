#include "desktop/solid/solid_panel.h"

#include <QGridLayout>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "desktop/engine/grain_setting.h"
#include "desktop/engine/settings.h"
#include "desktop/solid/solid_setting_keys.h"
#include "desktop/solid/solid_words.h"
#include "felt/fill/fill_map.h"
#include "felt/material/relief.h"
#include "felt/solid/gap_search.h"

namespace felt::desktop {
namespace {

constexpr double kGapStepMm = 0.5;
constexpr int kSectionSteps = 200;
constexpr qsizetype kMaxNotes = 3;  // more would leave no room for the bodies
constexpr int kMaxGapStep = static_cast<int>(FillMap::kMaxNamedGapMm / kGapStepMm);

QString gap_name(double gap_mm) {
  return SolidPanel::tr("%1 mm").arg(QLocale().toString(gap_mm, 'g', 3));
}

}  // namespace

SolidPanel::SolidPanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      scene_(new SolidScene(this)),
      tools_(new BodyTools(
          *scene_, [&studio] { return studio.session().ink_color(); }, this)),
      summary_(new QLabel(this)),
      offer_(new QPushButton(this)),
      gap_(new QSlider(Qt::Horizontal, this)),
      gap_text_(new QLabel(this)),
      automatic_(new QCheckBox(tr("Automatic"), this)),
      fill_holes_(new QCheckBox(tr("Fill holes"), this)),
      wireframe_(new QCheckBox(tr("Wireframe"), this)),
      section_(new QCheckBox(tr("Section"), this)),
      section_at_(new QSlider(Qt::Horizontal, this)),
      buttons_(new QHBoxLayout),
      export_(new QToolButton(this)) {
  make_controls();
  delay_.setSingleShot(true);
  delay_.setInterval(kWaitMs);
  announce_.setSingleShot(true);
  announce_.setInterval(kAnnounceMs);
  connect(&delay_, &QTimer::timeout, this, &SolidPanel::start);
  connect(tools_, &BodyTools::edit_wanted, this, &SolidPanel::try_edit);
  connect(&announce_, &QTimer::timeout, this, [this] { summary_->setText(tr("Inflating…")); });
  connect(&studio_, &Studio::edited, this, &SolidPanel::follow);
  connect(&studio_, &Studio::opened, this, [this] {
    ++session_;
    forget();
    wait();
  });
  show_gap(kAutomaticGapsMm.front());
  scene_->set_placeholder(tr("Draw a closed line: it becomes a body here."));
}

SolidPanel::~SolidPanel() {
  is_cancelled_ = true;
}

void SolidPanel::make_controls() {
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  summary_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  offer_->setAccessibleName(tr("Close wider gaps"));
  offer_->hide();
  connect(offer_, &QPushButton::clicked, this, [this] { set_gap(offered_mm_); });
  auto* below = new QVBoxLayout;
  below->setContentsMargins(8, 2, 8, 6);
  below->addWidget(summary_);
  below->addWidget(offer_);
  below->addWidget(gap_row());
  below->addWidget(look_rows());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tools_);
  column->addWidget(scene_, 1);
  column->addLayout(below);
}

QWidget* SolidPanel::gap_row() {
  auto* row = new QWidget(this);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  auto* title = new QLabel(tr("Gap:"), row);
  title->setBuddy(gap_);
  gap_->setRange(0, kMaxGapStep);
  gap_->setAccessibleName(tr("Gap"));
  gap_->setToolTip(tr("Gaps of the outline up to this size count as closed"));
  gap_text_->setMinimumWidth(fontMetrics().horizontalAdvance(gap_name(31.5)));
  automatic_->setChecked(true);
  automatic_->setToolTip(tr("Uses the smallest of 2, 4 and 8 mm that closes most of the drawing"));
  for (QWidget* part : std::initializer_list<QWidget*>{title, gap_, gap_text_, automatic_}) {
    line->addWidget(part, part == gap_ ? 1 : 0);
  }
  connect(gap_, &QSlider::valueChanged, this, [this](int step) { set_gap(kGapStepMm * step); });
  connect(automatic_, &QCheckBox::toggled, this, &SolidPanel::wait);
  return row;
}

QWidget* SolidPanel::look_rows() {
  auto* rows = new QWidget(this);
  auto* grid = new QGridLayout(rows);
  grid->setContentsMargins(0, 0, 0, 0);
  Settings& settings = Settings::the();
  fill_holes_->setChecked(settings.flag(solid_keys::kFillHoles, true));
  fill_holes_->setToolTip(tr("Closed lines inside an outline, such as eyes, make no holes"));
  wireframe_->setChecked(settings.flag(solid_keys::kWireframe, false));
  wireframe_->setToolTip(tr("Shows the triangles"));
  section_->setToolTip(tr("Cuts away the right part"));
  section_at_->setRange(0, kSectionSteps);
  section_at_->setValue(kSectionSteps / 2);
  section_at_->setAccessibleName(tr("Position of the section"));
  section_at_->setEnabled(false);
  export_->setText(tr("Export"));
  export_->setPopupMode(QToolButton::InstantPopup);
  export_->setToolTip(tr("Writes the bodies as a file for printing or for a 3D program"));
  export_->setEnabled(false);
  grid->addWidget(fill_holes_, 0, 0);
  grid->addWidget(wireframe_, 0, 1);
  buttons_->addStretch();
  buttons_->addWidget(export_);
  grid->addLayout(buttons_, 0, 2);
  grid->addWidget(section_, 1, 0);
  grid->addWidget(section_at_, 1, 1, 1, 2);
  grid->setColumnStretch(2, 1);
  const auto show_wireframe = [this](bool on) {
    scene_->set_wireframe(on ? WireframeChoice::kShow : WireframeChoice::kHide);
  };
  const auto cut = [this] {
    section_at_->setEnabled(section_->isChecked());
    const double share = static_cast<double>(section_at_->value()) / kSectionSteps;
    scene_->set_section(section_->isChecked() ? std::optional(share) : std::nullopt);
  };
  show_wireframe(wireframe_->isChecked());
  connect(fill_holes_, &QCheckBox::toggled, this, [this](bool on) {
    Settings::the().set(solid_keys::kFillHoles, on);
    wait();
  });
  connect(wireframe_, &QCheckBox::toggled, this, [show_wireframe](bool on) {
    Settings::the().set(solid_keys::kWireframe, on);
    show_wireframe(on);
  });
  connect(section_, &QCheckBox::toggled, this, cut);
  connect(section_at_, &QSlider::valueChanged, this, cut);
  return rows;
}

void SolidPanel::set_export_actions(const QList<QAction*>& actions) {
  auto* menu = new QMenu(export_);
  menu->addActions(actions);
  export_->setMenu(menu);
}

void SolidPanel::set_on(bool on) {
  if (std::exchange(is_on_, on) == on) return;
  delay_.stop();
  waits_ = false;
  is_cancelled_ = !on;
  if (on) return start();
  ++session_;
  forget();
}

void SolidPanel::set_touch_action(QAction* action) {
  auto* touch = new QToolButton(this);
  touch->setDefaultAction(action);
  buttons_->insertWidget(1, touch);  // left of "Export"
}

/// The bodies of another time or another drawing must not be exported.
void SolidPanel::forget() {
  forget_edit();
  if (!solid()) return;
  paint_.reset();
  scene_->set_solid(nullptr);
  export_->setEnabled(false);
  Q_EMIT solid_changed();
}

void SolidPanel::show_gap(double gap_mm) {
  const QSignalBlocker block(gap_);
  gap_->setValue(static_cast<int>(std::lround(gap_mm / kGapStepMm)));
  gap_text_->setText(gap_name(gap_mm));
}

/// Sets the gap that the user chose.
void SolidPanel::set_gap(double gap_mm) {
  const QSignalBlocker block(automatic_);
  automatic_->setChecked(false);
  show_gap(gap_mm);
  wait();
}

SolidRequest SolidPanel::request() const {
  SolidRequest request;
  if (!automatic_->isChecked()) request.gap_mm = kGapStepMm * gap_->value();
  request.new_edit = new_edit_;
  request.holes = fill_holes_->isChecked() ? HoleChoice::kFill : HoleChoice::kKeep;
  if (Settings::the().flag(kShowsGrain, kShowsGrainDefault)) {
    const Session& session = studio_.session();
    request.grain = Grain(surface_grain(session.surface()), session.materials());
  }
  return request;
}

/// The strokes of an edit that is tried are no longer shown, and the next ones are accepted.
void SolidPanel::forget_edit() {
  new_edit_.reset();
  tools_->refuse_strokes({});
  tools_->forget_strokes();
}

/// Follows an edit of the drawing. The bodies that are shown have the edit that was just tried. An
/// undo is meant for the edit that is tried, too: it must not be added after it.
void SolidPanel::follow() {
  if (adds_edit_) return;
  if (new_edit_ && studio_.session().history().can_redo()) forget_edit();
  wait();
}

/// Begins when the drawing has come to rest.
void SolidPanel::wait() {
  if (!is_on_) return;
  waits_ = true;
  delay_.start();
}

void SolidPanel::start() {
  if (!is_on_) return;
  if (runs_) {
    waits_ = true;  // take() starts again
    return;
  }
  const bool draws = studio_.pen().is_known && in_contact(studio_.pen().sample);
  if (draws && !studio_.is_touching()) return wait();
  waits_ = false;
  runs_ = true;
  announce_.start();
  if (!worker_) worker_ = std::make_unique<FileWorker>();
  worker_->start([this, request = request(), document = studio_.session().document(),
                  asked = session_]() -> FileWorker::Answer {
    const bool tries = request.new_edit.has_value();
    return [this, answer = make_solid(document, request, is_cancelled_), asked, tries] {
      take(answer, asked);
      if (tries && new_edit_) end_edit(answer, asked == session_);
    };
  });
}

/// Finds out whether an edit that the user has drawn fits the bodies.
void SolidPanel::try_edit(const BodyEdit& edit) {
  new_edit_ = edit;
  tools_->refuse_strokes(tr("Wait until the last stroke has been applied."));
  start();
}

/// Makes the edit that was tried a part of the drawing, or says why it does not fit.
void SolidPanel::end_edit(const SolidAnswer& answer, bool is_current) {
  // The session adds no edit while a line is drawn; then the edit is tried again.
  if (is_current && studio_.session().gesture_in_progress()) return wait();
  const std::optional<BodyEdit> edit = new_edit_;
  forget_edit();
  if (!is_current) return;
  if (answer.new_edit_refusal) return tools_->show_refusal(solid_words(*answer.new_edit_refusal));
  if (!answer.solid) return tools_->show_refusal(tr("The drawing has no body."));
  adds_edit_ = true;
  studio_.apply(BodyEvent{BodyEvent::Do::kAdd, {}, *edit});
  adds_edit_ = false;
}

void SolidPanel::take(const SolidAnswer& answer, int asked) {
  runs_ = false;
  announce_.stop();
  if (!is_on_) return;
  if (waits_ && !delay_.isActive()) delay_.start();
  if (asked == session_) show_answer(answer);
}

void SolidPanel::show_answer(const SolidAnswer& answer) {
  if (automatic_->isChecked()) show_gap(answer.gap_mm);
  const bool is_empty = studio_.session().document().stroke_count() == 0;
  QStringList lines;
  if (answer.solid) {
    lines.push_back(tr("Bodies: %1. Triangles: %2.")
                        .arg(answer.solid->bodies.size())
                        .arg(QLocale().toString(qulonglong(triangle_count(*answer.solid)))));
  } else if (!is_empty) {
    lines.push_back(answer.is_open ? tr("The drawing has no body, because no line is closed.")
                                   : tr("The drawing has no body."));
  }
  QStringList notes;
  for (const std::string& note : answer.notes) notes.push_back(solid_words(note));
  if (is_empty) notes.clear();
  lines += notes.mid(0, kMaxNotes);
  if (notes.size() > kMaxNotes) lines.push_back(tr("and %1 more").arg(notes.size() - kMaxNotes));
  summary_->setText(lines.join(QLatin1Char('\n')));
  summary_->setToolTip(notes.size() > kMaxNotes ? notes.join(QLatin1Char('\n')) : QString());
  offered_mm_ = answer.wider_gap_mm.value_or(0.0);
  offer_->setVisible(answer.wider_gap_mm.has_value());
  offer_->setText(tr("Close gaps up to %1").arg(gap_name(offered_mm_)));
  export_->setEnabled(answer.solid != nullptr);
  paint_ = answer.paint;
  scene_->set_solid(answer.solid, paint_);
  Q_EMIT solid_changed();
}

}  // namespace felt::desktop
