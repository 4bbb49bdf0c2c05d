#include "desktop/window/ring_wells.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <cmath>
#include <string>

#include "desktop/engine/text_of.h"
#include "desktop/engine/tool_size.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kWells = ChoiceRing::kWells;
using Names = std::array<const char*, kWells>;

/// The commands of the tools, and of the rings that a well opens.
constexpr Names kTools{"tool.pencil", "tool.shape",     "tool.pull",  "tool.size_ring",
                       "tool.eraser", "tool.transform", "tool.lasso", "tool.media_ring"};
constexpr Names kMedia{"pencil",   "pencil-soft", "ink-pen",  "brush-pen",
                       "felt-tip", "crayon",      "charcoal", "chalk"};
/// Widths of lines: those of technical pens (ISO 9175-1), and wider ones. Sizes of tools such as
/// the eraser are kToolFactor times as large.
constexpr std::array<double, kWells> kWidthsMm{0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0};
constexpr double kToolFactor = 10.0;

QString ring_text(const char* english) {
  return QCoreApplication::translate("felt::desktop::RingMenu", english);
}

/// Returns a picture of a size: dots that grow from well to well.
QIcon size_icon(std::size_t well, const QPalette& palette) {
  constexpr double kBoxPx = 24.0, kSmallestPx = 2.0, kStepPx = 2.8;
  constexpr double kScale = 2.0;  // enough pixels for screens of scale 2
  QPixmap pixmap(QSize(1, 1) * qRound(kScale * kBoxPx));
  pixmap.setDevicePixelRatio(kScale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(QPalette::WindowText));
  const double radius = 0.5 * (kSmallestPx + kStepPx * double(well));
  painter.drawEllipse(QPointF(0.5 * kBoxPx, 0.5 * kBoxPx), radius, radius);
  painter.end();
  return pixmap;
}

RingWell tool_well(const QString& command, const Actions& actions) {
  RingWell well;
  QAction* action = actions.find(command);
  if (!action) return well;
  well.name = action->iconText();
  well.icon = action->icon();
  well.is_current = action->isCheckable() && action->isChecked();
  for (const RingContent ring : {RingContent::kMedia, RingContent::kSizes}) {
    if (command != ring_command(ring)) continue;
    well.opens = ring;
    return well;
  }
  well.choose = [action] { action->trigger(); };
  return well;
}

RingWell medium_well(const std::string& id, Studio& studio, const MediaPictures& pictures,
                     const QPalette& palette) {
  const Medium* medium = studio.materials().find_medium(id);
  const QImage picture = pictures.of(id);
  return {.name = medium ? medium_label(*medium) : QString(),
          .icon = picture.isNull() ? QIcon() : swatch_icon(QPixmap::fromImage(picture), palette),
          .is_current = id == drawing_medium(studio.session()),
          .choose = [&studio, id] { choose_medium(studio, id); }};
}

RingWell size_well(std::size_t i, Studio& studio, const QPalette& palette) {
  const std::optional<ToolSize> size = tool_size(studio.session());
  double mm = kWidthsMm[i] * (is_line_size(studio.session()) ? 1.0 : kToolFactor);
  if (size) mm = std::clamp(mm, size->min_mm, size->max_mm);
  return {.name = ring_text(QT_TRANSLATE_NOOP("felt::desktop::RingMenu", "%1 mm"))
                      .arg(QLocale().toString(mm)),
          .icon = size_icon(i, palette),
          .is_current = size && std::abs(size->mm - mm) < 1e-6,
          .choose = [&studio, mm] {
            set_tool_size(studio, mm);
            resize_selected(studio);
          }};
}

}  // namespace

QString ring_command(RingContent content) {
  switch (content) {
    case RingContent::kTools:
      return QStringLiteral("tool.ring");
    case RingContent::kMedia:
      return QStringLiteral("tool.media_ring");
    case RingContent::kSizes:
      return QStringLiteral("tool.size_ring");
  }
  return {};
}

QString ring_name(RingContent content) {
  switch (content) {
    case RingContent::kTools:
      return ring_text(QT_TRANSLATE_NOOP("felt::desktop::RingMenu", "Ring of tools"));
    case RingContent::kMedia:
      return ring_text(QT_TRANSLATE_NOOP("felt::desktop::RingMenu", "Ring of media"));
    case RingContent::kSizes:
      return ring_text(QT_TRANSLATE_NOOP("felt::desktop::RingMenu", "Ring of sizes"));
  }
  return {};
}

std::array<RingWell, kWells> ring_wells(RingContent content, const Actions& actions, Studio& studio,
                                        const MediaPictures& pictures, const QPalette& palette) {
  std::array<RingWell, kWells> wells;
  for (std::size_t i = 0; i < kWells; ++i) {
    if (content == RingContent::kTools) {
      wells[i] = tool_well(QString::fromLatin1(kTools[i]), actions);
    } else if (content == RingContent::kMedia) {
      wells[i] = medium_well(kMedia[i], studio, pictures, palette);
    } else {
      wells[i] = size_well(i, studio, palette);
    }
  }
  return wells;
}

}  // namespace felt::desktop
