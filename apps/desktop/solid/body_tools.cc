#include "desktop/solid/body_tools.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <utility>

#include "desktop/solid/body_strokes.h"
#include "desktop/solid/solid_words.h"

namespace felt::desktop {
namespace {

constexpr double kMinWidthMm = 0.2, kMaxWidthMm = 100.0;
/// The ends of a closed line may be this far apart, as a share of its length.
constexpr double kMaxGapShare = 0.25;
/// How much one stroke of the tool smooths.
constexpr double kSmoothAmount = 0.5;

struct ToolRow {
  BodyTool tool;
  const char* text;
  const char* tip;
  const char* hint;
};
constexpr std::array kTools{
    ToolRow{BodyTool::kTurn, QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Turn"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Drag to turn the body"), ""},
    ToolRow{BodyTool::kCut, QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Cut"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools",
                              "Cuts the body along a stroke, and removes the part at its left"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools",
                              "Draw a line across the body, from beside it to beside it. What is "
                              "at the left of the line goes away.")},
    ToolRow{BodyTool::kExtrude, QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Extrude"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools",
                              "Pulls a part out of the body: a closed line, then its profile"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Draw a closed line on the body.")},
    ToolRow{BodyTool::kPaint, QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Paint"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools",
                              "Paints on the body, in the colour of the pen"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Draw on the body.")},
    ToolRow{BodyTool::kSmooth, QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Smooth"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools",
                              "Smooths the body below a stroke, for example where it was cut"),
            QT_TRANSLATE_NOOP("felt::desktop::BodyTools", "Draw over what should become smooth.")},
};

bool is_closed(const std::vector<QPointF>& px) {
  double length = 0.0;
  for (std::size_t i = 1; i < px.size(); ++i) {
    length += std::hypot(px[i].x() - px[i - 1].x(), px[i].y() - px[i - 1].y());
  }
  const QPointF gap = px.back() - px.front();
  return std::hypot(gap.x(), gap.y()) <= kMaxGapShare * length;
}

}  // namespace

BodyTools::BodyTools(SolidScene& scene, std::function<Rgba()> color, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      color_(std::move(color)),
      group_(new QButtonGroup(this)),
      width_(new QDoubleSpinBox(this)),
      hint_(new QLabel(this)) {
  width_->setRange(kMinWidthMm, kMaxWidthMm);
  width_->setDecimals(1);
  width_->setSuffix(tr(" mm"));
  width_->setAccessibleName(tr("Width of the brush"));
  width_->setToolTip(tr("Width of the brush"));
  hint_->setWordWrap(true);
  make_buttons();
  connect(width_, &QDoubleSpinBox::valueChanged, this, [this](double width_mm) {
    (tool_ == BodyTool::kSmooth ? smooth_mm_ : paint_mm_) = width_mm;
  });
  connect(&scene_, &SolidScene::stroke_drawn, this, &BodyTools::stroke_drawn);
  connect(&scene_, &SolidScene::escaped, this, [this] { set_tool(BodyTool::kTurn); });
  set_tool(BodyTool::kTurn);
}

void BodyTools::make_buttons() {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  for (const ToolRow& line : kTools) {
    auto* button = new QToolButton(this);
    button->setText(tr(line.text));
    button->setToolTip(tr(line.tip));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    group_->addButton(button, static_cast<int>(line.tool));
    row->addWidget(button);
  }
  row->addStretch(1);
  auto* below = new QHBoxLayout;
  below->addWidget(hint_, 1);
  below->addWidget(width_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 0);
  column->addLayout(row);
  column->addLayout(below);
  connect(group_, &QButtonGroup::idClicked, this,
          [this](int id) { set_tool(static_cast<BodyTool>(id)); });
}

void BodyTools::set_tool(BodyTool tool) {
  forget_strokes();
  tool_ = tool;
  group_->button(static_cast<int>(tool))->setChecked(true);
  scene_.set_tool(tool);
  width_->setVisible(tool == BodyTool::kPaint || tool == BodyTool::kSmooth);
  const QSignalBlocker block(width_);
  width_->setValue(tool == BodyTool::kSmooth ? smooth_mm_ : paint_mm_);
}

void BodyTools::show_hint() {
  const char* const hint = kTools[static_cast<std::size_t>(tool_)].hint;
  hint_->setVisible(*hint != '\0');
  hint_->setText(extrusion_
                     ? tr("Turn the body with the other mouse button or the arrow keys until "
                          "you see the line from the side. Then draw the profile: from one "
                          "side of the line over the tip to the other side.")
                     : tr(hint));
}

void BodyTools::forget_strokes() {
  extrusion_.reset();
  scene_.set_lines({});
  show_hint();
}

void BodyTools::show_refusal(const QString& why) {
  hint_->setText(why);
  hint_->show();
}

void BodyTools::stroke_drawn(const std::vector<QPointF>& px) {
  if (!scene_.solid() || px.empty()) return;
  if (!refusal_.isEmpty()) return show_refusal(refusal_);
  if (extrusion_) return end_extrusion(px);
  show_hint();
  BodyEdit edit;
  edit.path_mm = stroke_over_solid(scene_.camera(), px, scene_.solid()->origin);
  edit.view = -1.0 * scene_.camera().towards;
  edit.color = color_();
  edit.width_mm = width_->value();
  edit.amount = kSmoothAmount;
  const bool is_dot = edit.path_mm.size() < 2;
  switch (tool_) {
    case BodyTool::kTurn:
      return;
    case BodyTool::kCut:
      edit.kind = BodyEditKind::kCut;
      break;
    case BodyTool::kExtrude:
      return begin_extrusion(std::move(edit), px);
    case BodyTool::kPaint:
      edit.kind = BodyEditKind::kPaint;
      break;
    case BodyTool::kSmooth:
      edit.kind = BodyEditKind::kSmooth;
      break;
  }
  if (is_dot && tool_ == BodyTool::kCut) return;
  scene_.set_lines({scene_.on_plane(px)});
  Q_EMIT edit_wanted(edit);
}

void BodyTools::begin_extrusion(BodyEdit edit, const std::vector<QPointF>& px) {
  if (px.size() < 3 || !is_closed(px)) return show_refusal(tr("The line is not closed."));
  edit.kind = BodyEditKind::kExtrude;
  Result<ExtrusionRing> ring = extrusion_ring(*scene_.solid(), edit);
  if (!ring) return show_refusal(solid_words(ring.error().message));
  std::vector<Vec3> shown = ring->points;
  shown.push_back(shown.front());
  extrusion_ = Extrusion{std::move(edit), *std::move(ring)};
  scene_.set_lines({std::move(shown)});
  show_hint();
}

void BodyTools::end_extrusion(const std::vector<QPointF>& px) {
  const SolidCamera camera = scene_.camera();
  auto profile = profile_over_solid(camera, px, extrusion_->ring, scene_.solid()->origin);
  if (!profile || profile->size() < 3) return show_hint();
  BodyEdit edit = std::move(extrusion_->edit);
  edit.profile_mm = *std::move(profile);
  std::vector<Vec3> ring = extrusion_->ring.points;
  ring.push_back(ring.front());
  extrusion_.reset();
  scene_.set_lines({std::move(ring), scene_.on_plane(px)});
  show_hint();
  Q_EMIT edit_wanted(edit);
}

}  // namespace felt::desktop
