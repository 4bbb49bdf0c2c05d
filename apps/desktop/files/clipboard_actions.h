#pragma once

#include <QByteArray>
#include <QObject>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_dialogs.h"
#include "desktop/files/picture_actions.h"
#include "felt/document/drawing.h"
#include "felt/io/import.h"
#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// Copy, cut and paste of strokes: "edit.copy", "edit.cut", "edit.paste", "edit.copy_as_svg",
/// "edit.copy_as_png", "edit.paste_in_place". Copy copies every visible stroke that is at least
/// partly selected, or all visible strokes if nothing is selected. Cut copies and deletes only
/// strokes that are selected as a whole. The clipboard also gets those media of the strokes that
/// Feltline does not ship. A paste is one step of undo. A clipboard with a picture instead of
/// strokes gives a layer to draw over (PictureActions). Strokes that were copied in this window are
/// pasted with a small offset from the originals, or with their middle at the pointer if it is over
/// the page; "edit.paste_in_place" pastes at the original position.
class ClipboardActions : public QObject {
  Q_OBJECT

 public:
  /// `names` are those of the strokes of the studio's drawing; a paste adds to them.
  ClipboardActions(Studio& studio, Actions& actions, FileDialogs& dialogs, PictureActions& pictures,
                   std::shared_ptr<const StrokeNames>& names, QWidget* window);

  /// Sets a function that returns the position of the pointer on the page, or nullopt if it is
  /// elsewhere. Without a function, pastes are not moved to the pointer.
  void set_pointer(std::function<std::optional<Point>()> pointer) { pointer_ = std::move(pointer); }
  /// Pastes the clipboard with the middle of its ink at a point of the page.
  void paste_at(Point middle);

 Q_SIGNALS:
  /// Emitted when strokes were pasted; `report` lists the unsupported content of the clipboard.
  void taken(const QString& name, const felt::ImportReport& report);

 private:
  [[nodiscard]] Drawing chosen() const;
  [[nodiscard]] bool is_ours() const;
  void copy();
  void cut();
  void paste();
  void paste_in_place();
  [[nodiscard]] std::optional<Imported> pasted();
  void add(Imported pasted, Vec by_mm);
  void keep_up();
  void remember_and_put(Drawing drawing);

  Studio& studio_;
  FileDialogs& dialogs_;
  PictureActions& pictures_;
  std::shared_ptr<const StrokeNames>& names_;
  QWidget* window_;
  QAction* cut_;
  std::function<std::optional<Point>()> pointer_;
  QByteArray copied_;  // fingerprint of the strokes that this window copied
  int pastes_ = 0;     // number of pastes since the last copy or cut here
};

}  // namespace felt::desktop
