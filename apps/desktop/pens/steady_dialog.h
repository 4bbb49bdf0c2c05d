#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <optional>

#include "desktop/engine/studio.h"
#include "desktop/pens/spiral_area.h"
#include "felt/stroke/steady/shake.h"

namespace felt::desktop {

/// Returns "5.2 times a second, by 1.0 mm to each side", for display.
QString shake_words(const Shake& shake);
/// Returns the shaking in the options of the tool that draws.
Shake shake_of(const Session& session);
/// Sets these options, and switches the steady hand on.
void use_shake(Studio& studio, const Shake& shake);

/// Measures how the user's hand shakes by a spiral of about 10 s, and sets the options of the
/// steady hand. The values stay in the settings of this computer (KeptOptions); the spiral is not
/// kept.
class SteadyDialog : public QDialog {
  Q_OBJECT

 public:
  /// Seconds after which the spiral is enough.
  static constexpr double kEnoughS = 10.0;

  /// Borrows the pen from the drawing until the dialog is destroyed.
  explicit SteadyDialog(Studio& studio, QWidget* parent = nullptr);
  ~SteadyDialog() override;

  [[nodiscard]] SpiralArea& area() noexcept { return *area_; }
  /// Returns the result of the spiral so far, if it shows a shaking.
  [[nodiscard]] const std::optional<Shake>& found() const noexcept { return found_; }
  /// Returns the sentence below the spiral.
  [[nodiscard]] QString sentence() const { return result_->text(); }

 private:
  void show_progress();
  void measure();
  void start_again();

  Studio& studio_;
  SpiralArea* area_;
  QProgressBar* bar_;
  QLabel* result_;
  QPushButton* use_;
  QPushButton* again_;
  std::optional<Shake> found_;
};

}  // namespace felt::desktop
