#pragma once

#include <QButtonGroup>
#include <QWidget>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/materials/media_pictures.h"

namespace felt::desktop {

/// Sets the medium of new lines, and the line widths and the pressure curve of this medium. Each
/// value is set by an event, so that a replay of a recording gives the same lines. The colour of
/// new ink stays. Returns false if no medium for drawing has that id, or if an event was refused;
/// in the second case `refused` says why.
bool take_medium(Studio& studio, const std::string& id);
/// Handles a click on a medium: calls take_medium(), and also applies the medium to the selected
/// lines.
bool choose_medium(Studio& studio, const std::string& id);

/// Shows the media for drawing as pictures: for each medium a stroke from light to strong pressure
/// on the current surface, rendered with its grain. A click or the arrow keys choose a medium. The
/// number of columns depends on the width and is at least two. The eraser is not shown.
class MediaPicker : public QWidget {
  Q_OBJECT

 public:
  /// `pictures` must outlive this object.
  MediaPicker(Studio& studio, const MediaPictures& pictures, QWidget* parent = nullptr);

  /// Returns the ids of the buttons, in their order.
  [[nodiscard]] const std::vector<std::string>& ids() const noexcept { return ids_; }
  [[nodiscard]] QAbstractButton* button(const std::string& id) const;
  /// Returns the height that the widget needs if it has this width.
  [[nodiscard]] int height_for(int width) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_buttons();
  void follow_choice();
  void show_pictures();
  [[nodiscard]] QSize cell() const;
  [[nodiscard]] int columns(int width) const;
  void place_buttons();

  Studio& studio_;
  const MediaPictures& pictures_;
  QButtonGroup* group_;
  std::vector<std::string> ids_;
  std::vector<QString> labels_;
  std::vector<QAbstractButton*> buttons_;
};

}  // namespace felt::desktop
