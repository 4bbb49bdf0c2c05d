#pragma once

#include <vector>

#include "felt/tools/tool.h"

namespace felt {

/// The states that all tools share: from touch to lift is one gesture.
///
///   air --touch--> gesture --lift, finish--> air     begin(), move() for each sample, end()
///                     |
///                     +--cancel--> waiting for the lift --> air     drop()
///
/// Samples out of contact that may be a bounce (Contact) are buffered: they are replayed if contact
/// resumes, and discarded if it was the lift. A button that changes within a gesture changes its
/// samples only. Options that are set during a gesture take effect after it.
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
  /// A sample in the air, while no gesture is in work. A preview is allowed.
  virtual ToolResult hover(const PenSample& sample, const Scene& scene) = 0;
  /// The first sample of a gesture.
  virtual ToolResult begin(const PenSample& sample, const Scene& scene) = 0;
  /// Each further one. Without a preview the last one stays.
  virtual ToolResult move(const PenSample& sample, const Scene& scene) = 0;
  /// The pen was lifted: commit, or nothing. Strokes that the commit leaves as they were are left
  /// out of it.
  virtual ToolResult end(const Scene& scene) = 0;
  /// Discards the gesture.
  virtual void drop() = 0;
  /// Forgets what the pen hovers over: no gesture is in progress, and the sample stream stops or
  /// the user cancels.
  virtual void stop_hovering() {}
  /// Options are as options() says from now on; never during a gesture.
  virtual void take_options(const OptionValues& options) = 0;

  /// True from begin() to the return of end() or drop().
  [[nodiscard]] bool in_gesture() const noexcept { return in_gesture_; }
  /// True while the pen must be lifted before it begins anything: nothing is to be felt but the
  /// sheet.
  [[nodiscard]] bool is_waiting() const noexcept { return waiting_; }
  [[nodiscard]] const OptionValues& options() const noexcept { return options_; }

 private:
  ToolResult add(const PenSample& sample, const Scene& scene);
  ToolResult close(const Scene& scene);
  void stop();

  const ToolInfo& info_;
  OptionValues options_;
  bool has_new_options_ = true;  // the constructor of a base cannot tell its derived class
  bool is_down_ = false;         // at the last sample, or in a gap since
  bool in_gesture_ = false;
  bool waiting_ = false;
  std::vector<PenSample> gap_;  // out of contact, perhaps only for a moment
};

/// Returns the seconds from one sample to another, within 0 and `max_s`.
double seconds_between(std::int64_t from_ns, std::int64_t to_ns, double max_s) noexcept;

}  // namespace felt
