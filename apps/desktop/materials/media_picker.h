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

/// Sets the medium of new lines. Also sets its widths and pressure curve, as separate events, so
/// that a recording replays in the same way. Calls take_usual_color() if the medium differs from
/// the previous one. Returns false if an event was refused; then `refused` says why.
bool take_medium(Studio& studio, const std::string& id);
/// Does the same for a click. It also applies the medium to the selected lines. If the colour of
/// new ink changed, it reports this to the user.
bool choose_medium(Studio& studio, const std::string& id);

/// Sets the colour of new ink to `now`, the usual colour of the current medium, 0xRRGGBB. Does so
/// only if the colour is still the usual one of the previous medium, `before`, or black as in a
/// new drawing. Any other colour was chosen by the user and stays. Returns false if that was
/// refused; then `refused` says why.
bool take_usual_color(Studio& studio, std::optional<std::uint32_t> before, std::uint32_t now);

/// Shows the media for drawing as pictures: a stroke of each, from light to hard, on the current
/// surface, rendered with its grain. A click or the arrow keys choose a medium. The number of
/// columns depends on the width and is at least two. The eraser is not shown.
class MediaPicker : public QWidget {
  Q_OBJECT

 public:
  /// `pictures` must outlive it.
  MediaPicker(Studio& studio, const MediaPictures& pictures, QWidget* parent = nullptr);

  /// Returns the ids of the buttons, in their order.
  [[nodiscard]] const std::vector<std::string>& ids() const noexcept { return ids_; }
  [[nodiscard]] QAbstractButton* button(const std::string& id) const;
  /// Returns the height that it needs at this width.
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
