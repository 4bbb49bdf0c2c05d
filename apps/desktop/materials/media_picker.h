#pragma once

#include <QButtonGroup>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"
#include "desktop/materials/media_pictures.h"

namespace felt::desktop {

/// Sets the medium that new lines are drawn in and, as events of their own, so that a recording
/// replays alike, the widths and the pressure curve that it comes with, and take_usual_color()
/// where it is another one. False: `refused` said why.
bool take_medium(Studio& studio, const std::string& id);
/// The same for a click: the lines that are selected become of it, too, and a sentence says if the
/// colour of new ink is another one now.
bool choose_medium(Studio& studio, const std::string& id);

/// The colour of new ink becomes the usual one of the medium in hand, 0xRRGGBB, where it still is
/// that of the medium `before`, or black as in a new drawing; another one is a person's own, and
/// stays. False: `refused` said why.
bool take_usual_color(Studio& studio, std::optional<std::uint32_t> before, std::uint32_t now);

/// What can be drawn with, as pictures: a stroke of each from light to hard on the sheet that is
/// chosen, rendered with its grain; a click, or the arrow keys, take one. As many side by side as
/// there is room for, two at least. The eraser is none of them.
class MediaPicker : public QWidget {
  Q_OBJECT

 public:
  /// `pictures` must outlive it.
  MediaPicker(Studio& studio, const MediaPictures& pictures, QWidget* parent = nullptr);

  /// Of the buttons, in their order.
  [[nodiscard]] const std::vector<std::string>& ids() const noexcept { return ids_; }
  [[nodiscard]] QAbstractButton* button(const std::string& id) const;
  /// What it is high when it is so wide.
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
