#include "desktop/files/clipboard_actions.h"

#include <QAction>
#include <QClipboard>
#include <QCryptographicHash>
#include <QGuiApplication>
#include <functional>
#include <utility>

#include "desktop/files/added_strokes.h"
#include "desktop/files/clipboard.h"
#include "desktop/files/error_words.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/copied_ink.h"

namespace felt::desktop {
namespace {

constexpr double kBesideMm = 5.0;  // offset by which each paste of the same strokes differs from
                                   // the previous one

void put(std::unique_ptr<QMimeData> data) {
  QGuiApplication::clipboard()->setMimeData(data.release());
}

/// Returns a hash that identifies Feltline's strokes on a clipboard.
QByteArray fingerprint(const QMimeData& data) {
  return QCryptographicHash::hash(data.data(QString::fromLatin1(kStrokesMime)),
                                  QCryptographicHash::Sha1);
}

}  // namespace

ClipboardActions::ClipboardActions(Studio& studio, Actions& actions, FileDialogs& dialogs,
                                   PictureActions& pictures,
                                   std::shared_ptr<const StrokeNames>& names, QWidget* window)
    : QObject(window),
      studio_(studio),
      dialogs_(dialogs),
      pictures_(pictures),
      names_(names),
      window_(window) {
  cut_ = actions.add(QStringLiteral("edit.cut"), tr("Cu&t"), {QKeySequence::Cut},
                     tr("Move the selected strokes to the clipboard"), [this] { cut(); });
  actions.add(QStringLiteral("edit.copy"), tr("&Copy"), {QKeySequence::Copy},
              tr("Copy the selected strokes, or all if none is selected"), [this] { copy(); });
  actions.add(QStringLiteral("edit.paste"), tr("&Paste"), {QKeySequence::Paste},
              tr("Add the strokes from the clipboard"), [this] { paste(); });
  actions.add(QStringLiteral("edit.paste_in_place"), tr("Paste &in place"),
              {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V)},
              tr("Add the strokes from the clipboard at their original position"),
              [this] { paste_in_place(); });
  actions.add(QStringLiteral("edit.copy_as_svg"), tr("Copy as &SVG"), {},
              tr("Copy the selected strokes, or all, as an SVG drawing"),
              [this] { put(svg_mime(chosen())); });
  actions.add(QStringLiteral("edit.copy_as_png"), tr("Copy as &picture"), {},
              tr("Copy the selected strokes, or all, as a picture"),
              [this] { put(png_mime(chosen())); });
  connect(&studio, &Studio::selection_changed, this, &ClipboardActions::keep_up);
  keep_up();
}

void ClipboardActions::keep_up() {
  cut_->setEnabled(!studio_.session().selection().empty());
}

Drawing ClipboardActions::chosen() const {
  const Session& session = studio_.session();
  const Selection& selection = session.selection();
  return copied_drawing(
      session, [&](StrokeId id) { return selection.empty() || selection.find(id) != nullptr; });
}

void ClipboardActions::remember_and_put(Drawing drawing) {
  drawing.names = names_;
  std::unique_ptr<QMimeData> data = strokes_mime(std::move(drawing));
  copied_ = fingerprint(*data);
  put(std::move(data));
}

void ClipboardActions::copy() {
  remember_and_put(chosen());
  pastes_ = 0;
}

void ClipboardActions::cut() {
  // Cuts only the strokes that are selected as a whole, because Delete removes only these.
  const Session& session = studio_.session();
  Drawing whole =
      copied_drawing(session, [&](StrokeId id) { return session.selection().is_whole(id); });
  if (whole.document.stroke_count() == 0) {
    Q_EMIT studio_.refused(tr("Only whole strokes can be cut. Select a whole stroke first."));
    return;
  }
  remember_and_put(std::move(whole));
  pastes_ = -1;  // the next paste has no offset
  studio_.apply(DeleteEvent{});
}

/// Returns the drawing on the clipboard, or nullopt, with a message to the user, if it has no
/// strokes or fills.
std::optional<Imported> ClipboardActions::pasted() {
  const QMimeData* data = QGuiApplication::clipboard()->mimeData();
  Result<Imported> pasted = data ? drawing_of(*data) : Imported();
  if (!pasted) {
    dialogs_.show_error(window_, tr("The clipboard cannot be pasted"), error_words(pasted.error()),
                        QString::fromStdString(pasted.error().message));
    return std::nullopt;
  }
  const bool is_empty = ink_bounds(pasted->drawing.document).empty();
  if (is_empty && data && data->hasImage()) {
    pictures_.add_image(tr("Picture"), qvariant_cast<QImage>(data->imageData()));
    return std::nullopt;
  }
  if (is_empty) {
    Q_EMIT studio_.refused(tr("The clipboard holds no strokes."));
    return std::nullopt;
  }
  return *std::move(pasted);
}

void ClipboardActions::paste() {
  const std::optional<Point> pointer = pointer_ ? pointer_() : std::nullopt;
  if (pointer) return paste_at(*pointer);
  std::optional<Imported> pasted = this->pasted();
  if (!pasted) return;
  const double beside_mm = is_ours() ? kBesideMm * ++pastes_ : 0.0;
  add(*std::move(pasted), {beside_mm, beside_mm});
}

void ClipboardActions::paste_in_place() {
  if (std::optional<Imported> pasted = this->pasted()) add(*std::move(pasted), {});
}

void ClipboardActions::paste_at(Point middle) {
  std::optional<Imported> pasted = this->pasted();
  if (!pasted) return;
  const Rect box = ink_bounds(pasted->drawing.document);
  const Point from{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  add(*std::move(pasted), middle - from);
}

void ClipboardActions::add(Imported pasted, Vec by_mm) {
  const UsedNames used = is_ours() ? UsedNames::kExpected : UsedNames::kReported;
  add_drawing(studio_, QStringLiteral("clipboard"), pasted.drawing, by_mm, used, names_,
              pasted.report);
  Q_EMIT taken(tr("the clipboard"), pasted.report);
}

/// Returns true if the clipboard has the strokes that this window copied last.
bool ClipboardActions::is_ours() const {
  return fingerprint(*QGuiApplication::clipboard()->mimeData()) == copied_;
}

}  // namespace felt::desktop
