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

/// The input of probe_figures(): a medium, a surface, and the device that renders their forces.
struct ProbeRequest {
  SurfaceMaterial surface;
  Medium medium;
  Capabilities device;
  /// Factor of all forces, 0..1 (Studio::strength).
  double strength = 1.0;

  friend bool operator==(const ProbeRequest&, const ProbeRequest&) = default;
};

/// The predicted forces. They are computed with the same force models as the tools use, and by
/// simulating a stroke of the hand in virtual time.
struct ProbeFigures {
  static constexpr double kLengthMm = 40.0;
  static constexpr double kSpeedMmPerS = 80.0;
  static constexpr double kPressN = 0.8;

  /// Force against the motion of the pen, in N, at equal distances along kLengthMm. The pen presses
  /// with kPressN.
  std::vector<double> drag_n;
  double stiffness_n_per_m = 0.0;  ///< stiffness of the surface as the device renders it
  double budget_share = 0.0;       ///< largest stiffness of any axis, relative to the device's
                                   ///< limit (R56)
  double grain_share = 1.0;        ///< share of the relief's height that the device can render; 1
                                   ///< without a relief
  double rest_n = 0.0;             ///< tremble of a resting pen: RMS above 30 Hz (R48)
  bool is_sound = true;            ///< true if the safety chain reported no fault

  friend bool operator==(const ProbeFigures&, const ProbeFigures&) = default;
};

/// Computes the figures. The time that this takes is proportional to the rate of the device: about
/// 50 ms at 1 kHz. The result depends only on `request`. Safe to call from any thread except the
/// haptic thread. If the device has no motors, uses the simulated Touch.
ProbeFigures probe_figures(const ProbeRequest& request);
/// Returns the device that probe_figures() uses: `device`, or the simulated Touch if `device` has
/// no motors.
Capabilities probe_device(const Capabilities& device);

/// Computes probe_figures() on another thread. A newer request replaces an older one.
class ForceProbe : public QObject {
  Q_OBJECT

 public:
  explicit ForceProbe(QObject* parent = nullptr);
  ~ForceProbe() override;

  /// Requests the figures. `figured` is emitted when they are ready; before that, it may also be
  /// emitted with the figures of an older request. Does nothing if the request equals the previous
  /// one.
  void ask(const ProbeRequest& request);
  [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }

 Q_SIGNALS:
  void figured(const felt::desktop::ProbeFigures& figures);

 private:
  void start();

  ProbeRequest wanted_, asked_;
  bool has_asked_ = false;
  bool is_busy_ = false;
  bool is_stale_ = false;  // another request waits
  QThreadPool worker_;     // last, so that it ends before the other members are destroyed
};

}  // namespace felt::desktop
