#pragma once

#include <vector>

#include "felt/tools/tool.h"

namespace felt {

/// The state machine that all tools share: a gesture lasts from touch to lift.
///
///   air --touch--> gesture --lift, finish--> air     begin(), move() for each sample, end()
///                     |
///                     +--cancel--> waiting for the lift --> air     drop()
///
/// Samples out of contact that may be a bounce (Contact) are buffered: they are replayed if contact
/// resumes, and discarded if the pen was lifted. A button that is pressed or released during a
/// gesture does not end the gesture; move() sees the change in the samples. Options set during a
/// gesture take effect after it.
class GestureTool : public Tool {
 public:
  /// `info` must outlive the tool.
  explicit GestureTool(const ToolInfo& info);

  [[nodiscard]] const ToolInfo& info() const noexcept final { return info_; }
  ToolResult sample(const PenSample& sample, Contact::Change contact, const Scene& scene) final;
  ToolResult finish(const Scene& scene) final;
  void cancel() final;
  Result<void> set_option(std::string_view id, const OptionValue& value) final;
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const final;

 protected:
  /// Handles a hover sample while no gesture is in progress. May return a preview.
  virtual ToolResult hover(const PenSample& sample, const Scene& scene) = 0;
  /// Handles the first sample of a gesture.
  virtual ToolResult begin(const PenSample& sample, const Scene& scene) = 0;
  /// Handles each further sample. If it returns no preview, the previous one stays.
  virtual ToolResult move(const PenSample& sample, const Scene& scene) = 0;
  /// Called when the pen is lifted. Returns the edit to commit, if any; the caller removes
  /// unchanged strokes from the edit.
  virtual ToolResult end(const Scene& scene) = 0;
  /// Discards the gesture.
  virtual void drop() = 0;
  /// Forgets the ink that the pen hovers over. Called if the sample stream stops or the user
  /// cancels while no gesture is in progress.
  virtual void stop_hovering() {}
  /// Applies options(). Never called during a gesture.
  virtual void take_options(const OptionValues& options) = 0;

  /// Returns true from begin() until end() or drop() returns.
  [[nodiscard]] bool in_gesture() const noexcept { return in_gesture_; }
  /// Returns true while the pen must be lifted before the next gesture. During this time, only the
  /// surface exerts a force.
  [[nodiscard]] bool is_waiting() const noexcept { return waiting_; }
  [[nodiscard]] const OptionValues& options() const noexcept { return options_; }

 private:
  ToolResult add(const PenSample& sample, const Scene& scene);
  ToolResult close(const Scene& scene);
  void stop();

  const ToolInfo& info_;
  OptionValues options_;
  bool has_new_options_ = true;  // options not yet passed to take_options()
  bool is_down_ = false;         // in contact at the last sample, or in a gap after it
  bool in_gesture_ = false;
  bool waiting_ = false;
  std::vector<PenSample> gap_;  // samples of a possible bounce
};

/// Returns the time in s from one sample to another, clamped to [0, `max_s`].
double seconds_between(std::int64_t from_ns, std::int64_t to_ns, double max_s) noexcept;

}  // namespace felt
