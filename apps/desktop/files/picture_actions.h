#pragma once

#include <QImage>
#include <QObject>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_dialogs.h"
#include "desktop/files/picture_file.h"

namespace felt::desktop {

/// Adds pictures to draw over: "file.import_picture", and pictures that are dropped or pasted. A
/// picture becomes a faded layer below the current one, which is then the current layer, and the
/// transform tool is chosen, so that the user can move the picture to its place. With the next
/// tool, the former layer becomes current again, so that new ink does not go to the picture.
class PictureActions : public QObject {
  Q_OBJECT

 public:
  PictureActions(Studio& studio, Actions& actions, FileDialogs& dialogs, QWidget* window);

  /// Asks for a file and adds it.
  void ask(const QString& folder);
  /// Adds a file, of a PDF file with several pages the one that the user chooses. Returns false if
  /// it was not added; an error has been shown to the user.
  bool add_file(const QString& path);
  /// Adds a picture from another program. `name` is shown to the user.
  bool add_image(const QString& name, const QImage& image);

 private:
  bool add(const QString& name, const Result<ReadPicture>& picture);
  /// Makes the layer current that was so before the picture, when the picture is placed.
  void return_to_layer();
  void show_error(const QString& name, const Error& error);

  Studio& studio_;
  FileDialogs& dialogs_;
  QWidget* window_;
  LayerId placed_, drawn_on_;  // the layer of the last picture, and the current one before it
};

}  // namespace felt::desktop
