#include "desktop/panels/guide_actions.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "desktop/engine/text_of.h"
#include "desktop/panels/tool_icons.h"
#include "felt/tools/guide/guide_options.h"

namespace felt::desktop {
namespace {

using RowKind = DrawingGuideKind;
using GuideDo = GuidesEvent::Do;

QString guide_text(const char* english) {
  return QCoreApplication::translate("GuideActions", english);
}

/// A command that adds a guide.
struct GuideRow {
  RowKind kind;
  const char* text;
  const char* tip;
};
constexpr std::array kGuideRows{
    GuideRow{RowKind::kRuler, QT_TRANSLATE_NOOP("GuideActions", "&Ruler"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a straight edge with millimetres.")},
    GuideRow{RowKind::kLine, QT_TRANSLATE_NOOP("GuideActions", "&Line"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a straight line across the page.")},
    GuideRow{RowKind::kParallels, QT_TRANSLATE_NOOP("GuideActions", "&Parallels"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds all lines of one direction.")},
    GuideRow{RowKind::kSetSquare, QT_TRANSLATE_NOOP("GuideActions", "&Set square"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a right angle with millimetres.")},
    GuideRow{RowKind::kProtractor, QT_TRANSLATE_NOOP("GuideActions", "Pr&otractor"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds rays in steps of 15 degrees.")},
    GuideRow{RowKind::kCompass, QT_TRANSLATE_NOOP("GuideActions", "&Compass"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds the centre of circles.")},
    GuideRow{RowKind::kEllipse, QT_TRANSLATE_NOOP("GuideActions", "&Ellipse"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds one ellipse.")},
    GuideRow{RowKind::kEllipses, QT_TRANSLATE_NOOP("GuideActions", "Co&ncentric ellipses"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds ellipses around one centre.")},
    GuideRow{RowKind::kPerspective, QT_TRANSLATE_NOOP("GuideActions", "Perspecti&ve"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds two vanishing points.")},
    GuideRow{RowKind::kGrid, QT_TRANSLATE_NOOP("GuideActions", "&Grid"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a grid of squares.")},
    GuideRow{RowKind::kIsometricGrid, QT_TRANSLATE_NOOP("GuideActions", "&Isometric grid"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a grid of triangles.")},
    GuideRow{RowKind::kSymmetry, QT_TRANSLATE_NOOP("GuideActions", "S&ymmetry"),
             QT_TRANSLATE_NOOP("GuideActions", "Adds a mirror axis. New lines get mirror images.")},
    GuideRow{RowKind::kTrace, QT_TRANSLATE_NOOP("GuideActions", "&Trace of selected lines"),
             QT_TRANSLATE_NOOP("GuideActions", "Makes each selected line a guide.")}};

/// Returns a guide of this kind at the middle of the page.
DrawingGuide guide_at_middle(RowKind kind, const Rect& page) {
  DrawingGuide guide{kind, {0.5 * (page.x0 + page.x1), 0.5 * (page.y0 + page.y1)}};
  const double side = std::min(page.width(), page.height());
  const auto sized = [](double mm) {
    return std::clamp(mm, DrawingGuide::kMinSizeMm, DrawingGuide::kMaxSizeMm);
  };
  guide.size_mm = sized(0.35 * side);
  guide.second_mm = sized(0.2 * side);
  switch (kind) {
    case RowKind::kRuler:
      guide.size_mm = sized(0.7 * side);
      guide.origin.x -= 0.5 * guide.size_mm;
      break;
    case RowKind::kGrid:
    case RowKind::kIsometricGrid:
      guide.size_mm = 5.0;
      break;
    case RowKind::kPerspective:
      guide.points = {{page.x0, guide.origin.y}, {page.x1, guide.origin.y}};
      break;
    case RowKind::kSymmetry:
      guide.angle_rad = -0.5 * std::numbers::pi;
      break;
    default:
      break;
  }
  return guide;
}

/// Calls `use` for every stroke that is wholly selected.
template <class Use>
void for_each_selected(const Session& session, Use use) {
  for (const auto& [id, marks] : session.selection().strokes()) {
    if (session.selection().is_whole(id)) use(id);
  }
}

void add_guide(Studio& studio, RowKind kind) {
  if (kind == RowKind::kTrace) {
    std::vector<StrokeId> strokes;
    for_each_selected(studio.session(), [&strokes](StrokeId id) { strokes.push_back(id); });
    for (const StrokeId id : strokes) {
      DrawingGuide trace{RowKind::kTrace};
      trace.stroke = id;
      if (!studio.apply(GuidesEvent{GuideDo::kAdd, {}, trace})) return;
    }
    return;
  }
  if (!studio.apply(GuidesEvent{GuideDo::kAdd, {}, guide_at_middle(kind, studio.page().area())}))
    return;
  // The tool stays, so that the next line is drawn with the new guide. If the user then chooses the
  // tool Guide, it places the same kind.
  if (const Tool* tool = studio.session().first_tool(ToolKind::kGuides)) {
    studio.apply(SetOption{std::string(tool->info().id) + ".kind",
                           std::string(kPlacedGuideKinds[static_cast<std::size_t>(kind)])});
  }
}

/// Enables the commands that have an effect now. Called after every process(), so it must return
/// quickly if nothing has changed.
class GuideStates : public QObject {
 public:
  GuideStates(Actions& actions, Studio& studio) : QObject(&actions), studio_(studio) {
    show_ = actions.find(QStringLiteral("guide.show"));
    clear_ = actions.find(QStringLiteral("guide.clear"));
    unlink_ = actions.find(QStringLiteral("guide.unlink"));
    trace_ = actions.find(QStringLiteral("guide.add_trace"));
    connect(&studio, &Studio::shown, this, [this] { follow(); });
    connect(&studio, &Studio::edited, this, [this] { follow(); });
    connect(&studio, &Studio::opened, this, [this] {
      seen_ = ~std::uint64_t{0};
      follow();
    });
    follow();
  }

 private:
  void follow() {
    const Session& session = studio_.session();
    const std::uint64_t now = session.edit_count() + session.selection_count();
    if (seen_ == now) return;
    seen_ = now;
    const Document& document = session.document();
    bool has_selected = false, has_linked = false;
    for_each_selected(session, [&](StrokeId id) {
      has_selected = true;
      has_linked = has_linked || static_cast<bool>(document.symmetry_of(id));
    });
    show_->setChecked(document.shows_guides());
    clear_->setEnabled(!document.guides().empty());
    unlink_->setEnabled(has_linked);
    trace_->setEnabled(has_selected);
  }

  Studio& studio_;
  QAction *show_, *clear_, *unlink_, *trace_;
  std::uint64_t seen_ = ~std::uint64_t{0};
};

}  // namespace

void add_guide_actions(Actions& actions, Studio& studio) {
  actions
      .add_switch(QStringLiteral("guide.show"),
                  guide_text(QT_TRANSLATE_NOOP("GuideActions", "&Show guides")),
                  {QKeySequence(Qt::Key_F7)},
                  guide_text(QT_TRANSLATE_NOOP(
                      "GuideActions", "Shows or hides the guides. Hidden guides have no effect.")),
                  true,
                  [&actions, &studio](bool on) {
                    const Document& document = studio.session().document();
                    if (document.shows_guides() == on) return;
                    studio.apply(GuidesEvent{on ? GuideDo::kShow : GuideDo::kHide});
                    // During a stroke, nothing changes.
                    actions.find(QStringLiteral("guide.show"))
                        ->setChecked(studio.session().document().shows_guides());
                  })
      ->setIcon(icon_of("eye"));
  for (const GuideRow& row : kGuideRows) {
    QString name = text_of(guide_kind_name(row.kind));
    name.replace(QLatin1Char('-'), QLatin1Char('_'));
    actions.add(QStringLiteral("guide.add_") + name, guide_text(row.text), {}, guide_text(row.tip),
                [&studio, kind = row.kind] { add_guide(studio, kind); });
  }
  actions.add(QStringLiteral("guide.unlink"),
              guide_text(QT_TRANSLATE_NOOP("GuideActions", "&Unlink mirrored lines")), {},
              guide_text(QT_TRANSLATE_NOOP(
                  "GuideActions", "The selected lines no longer follow their mirror images.")),
              [&studio] { studio.apply(GuidesEvent{GuideDo::kUnlink}); });
  actions
      .add(QStringLiteral("guide.clear"),
           guide_text(QT_TRANSLATE_NOOP("GuideActions", "Remove &all guides")), {},
           guide_text(QT_TRANSLATE_NOOP("GuideActions", "Removes the guides. Lines stay.")),
           [&studio] { studio.apply(GuidesEvent{GuideDo::kClear}); })
      ->setIcon(icon_of("remove"));
  new GuideStates(actions, studio);
}

}  // namespace felt::desktop
