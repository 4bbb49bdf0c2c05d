#include "desktop/files/clipboard_actions.h"

#include <QAction>
#include <QClipboard>
#include <QCryptographicHash>
#include <QGuiApplication>
#include <set>
#include <utility>

#include "desktop/files/added_strokes.h"
#include "desktop/files/clipboard.h"
#include "desktop/files/error_words.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_materials.h"

namespace felt::desktop {
namespace {

constexpr double kBesideMm = 5.0;  // each paste of the same strokes

void put(std::unique_ptr<QMimeData> data) {
  QGuiApplication::clipboard()->setMimeData(data.release());
}

/// Of our strokes on a clipboard, to know them again.
QByteArray fingerprint(const QMimeData& data) {
  return QCryptographicHash::hash(data.data(QString::fromLatin1(kStrokesMime)),
                                  QCryptographicHash::Sha1);
}

Sketch moved(Sketch sketch, double by_mm) {
  for (SketchStroke& s : sketch) {
    StrokeData data = s.stroke.data();
    for (Point& p : data.points) p = {p.x + by_mm, p.y + by_mm};
    if (Result<Stroke> stroke = Stroke::create(std::move(data))) s.stroke = *std::move(stroke);
  }
  return sketch;
}

}  // namespace

ClipboardActions::ClipboardActions(Studio& studio, Actions& actions, FileDialogs& dialogs,
                                   QWidget* window)
    : QObject(window), studio_(studio), dialogs_(dialogs), window_(window) {
  cut_ = actions.add(QStringLiteral("edit.cut"), tr("Cu&t"), {QKeySequence::Cut},
                     tr("Move the selected strokes to the clipboard"), [this] { cut(); });
  actions.add(QStringLiteral("edit.copy"), tr("&Copy"), {QKeySequence::Copy},
              tr("Copy the selected strokes, or all"), [this] { copy(); });
  actions.add(QStringLiteral("edit.paste"), tr("&Paste"), {QKeySequence::Paste},
              tr("Add the strokes of the clipboard"), [this] { paste(); });
  actions.add(QStringLiteral("edit.copy_as_svg"), tr("Copy as &SVG"), {},
              tr("Copy the selected strokes, or all, as an SVG drawing"), [this] {
                const Sketch sketch = chosen();
                put(svg_mime(sketch, materials_of(sketch)));
              });
  actions.add(QStringLiteral("edit.copy_as_png"), tr("Copy as &picture"), {},
              tr("Copy the selected strokes, or all, as a picture"),
              [this] { put(png_mime(chosen())); });
  connect(&studio, &Studio::selection_changed, this, &ClipboardActions::keep_up);
  keep_up();
}

void ClipboardActions::keep_up() {
  cut_->setEnabled(!studio_.session().selection().empty());
}

Sketch ClipboardActions::chosen() const {
  const Session& session = studio_.session();
  if (session.selection().empty()) return visible_strokes(session.document());
  Sketch sketch;
  for (const Layer& layer : session.document().layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      if (!session.selection().find(id)) continue;
      sketch.push_back({"s" + std::to_string(id.value), *session.document().find(id)});
    }
  }
  return sketch;
}

/// As they are now: who pastes may do so when they have changed here, or in another program.
std::vector<std::string> ClipboardActions::materials_of(const Sketch& sketch) const {
  std::set<std::string> media;
  for (const SketchStroke& s : sketch) media.insert(s.stroke.material());
  const std::vector<std::string> ids(media.begin(), media.end());
  return texts_of_used(Document(), {}, studio_.session().materials(), ids);
}

void ClipboardActions::remember_and_put(const Sketch& sketch) {
  std::unique_ptr<QMimeData> data = strokes_mime(sketch, materials_of(sketch));
  copied_ = fingerprint(*data);
  put(std::move(data));
}

void ClipboardActions::copy() {
  remember_and_put(chosen());
  pastes_ = 0;
}

void ClipboardActions::cut() {
  // Delete takes strokes that are wholly selected; no more than that is cut.
  Sketch whole;
  const Session& session = studio_.session();
  for (SketchStroke& s : chosen()) {
    const StrokeId id{std::stoull(s.id.substr(1))};
    if (session.selection().is_whole(id)) whole.push_back(std::move(s));
  }
  if (whole.empty()) {
    Q_EMIT studio_.refused(tr("Only whole strokes can be cut: select all of a stroke."));
    return;
  }
  remember_and_put(whole);
  pastes_ = -1;  // their place is free
  studio_.apply(DeleteEvent{});
}

void ClipboardActions::paste() {
  const QMimeData* data = QGuiApplication::clipboard()->mimeData();
  Result<PastedStrokes> pasted = data ? strokes_of(*data) : PastedStrokes();
  if (!pasted) {
    dialogs_.show_error(window_, tr("The clipboard cannot be pasted"), error_words(pasted.error()),
                        QString::fromStdString(pasted.error().message));
    return;
  }
  if (pasted->sketch.empty()) {
    Q_EMIT studio_.refused(tr("The clipboard holds no strokes."));
    return;
  }
  const bool is_ours = fingerprint(*data) == copied_;
  const int beside = is_ours ? ++pastes_ : 0;
  add_strokes(studio_, QStringLiteral("clipboard"),
              {moved(pasted->sketch, kBesideMm * beside), pasted->materials}, pasted->report);
  Q_EMIT taken(tr("the clipboard"), pasted->report);
}

}  // namespace felt::desktop
