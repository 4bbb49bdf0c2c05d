#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <atomic>
#include <cstdint>
#include <vector>

#include "felt/haptics/capabilities.h"
#include "felt/material/materials.h"

namespace felt::desktop {

/// What is to be felt: a medium on a sheet, through a device.
struct FeltWish {
  SurfaceMaterial sheet;
  Medium medium;
  Capabilities device;
  /// Of all forces, 0..1 (Studio::strength).
  double strength = 1.0;

  friend bool operator==(const FeltWish&, const FeltWish&) = default;
};

/// What comes of it, by the rules that the tools' forces are made with and by a stroke of the
/// simulated hand in virtual time.
struct FeltFigures {
  static constexpr double kLengthMm = 40.0;
  static constexpr double kSpeedMmPerS = 80.0;
  static constexpr double kPressN = 0.8;

  /// Force against the pen's way along kLengthMm, N, evenly spaced; a push is kPressN.
  std::vector<double> drag_n;
  double stiffness_n_per_m = 0.0;  ///< of the sheet, as the device makes it
  double budget_share = 0.0;  ///< stiffness along the worst axis, of what the device bears (R56)
  double grain_share = 1.0;   ///< of the relief's height that is felt; 1 where there is none
  double rest_n = 0.0;        ///< trembling of a pen that rests: RMS above 30 Hz (R48)
  bool is_sound = true;       ///< the safety chain found nothing wrong

  friend bool operator==(const FeltFigures&, const FeltFigures&) = default;
};

/// 50 ms at 1 kHz, in proportion to the rate; deterministic; any thread but the haptic one. A
/// device without motors is felt as if it were the Touch of the simulated ones.
FeltFigures felt_figures(const FeltWish& wish);
/// The device that felt_figures() reckons with: the one in use, or the Touch in its place.
Capabilities felt_device(const Capabilities& device);

/// Works felt_figures() out beside Qt's thread. A newer wish goes before an older one.
class FeltProbe : public QObject {
  Q_OBJECT

 public:
  explicit FeltProbe(QObject* parent = nullptr);
  ~FeltProbe() override;

  /// `figured` comes for the last wish, later; not where it is the last one's.
  void ask(const FeltWish& wish);
  [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }

 Q_SIGNALS:
  void figured(const felt::desktop::FeltFigures& figures);

 private:
  void start();

  FeltWish wanted_, asked_;
  bool has_asked_ = false;
  bool is_busy_ = false;
  bool is_stale_ = false;  // another wish waits
  QThreadPool worker_;     // last, so that it has ended before the rest goes
};

}  // namespace felt::desktop
