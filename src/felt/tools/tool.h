#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "felt/document/edit.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/overlay.h"
#include "felt/tools/scene.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Buttons of the pen that change what a gesture does, each room says how; a desktop sets them for
/// keys too (Shift, Ctrl).
inline constexpr std::uint32_t kFirstModifier = 1U << 0;
inline constexpr std::uint32_t kSecondModifier = 1U << 1;

/// What a tool is, for menus, the command line and the documents.
struct ToolInfo {
  std::string_view id;     ///< "pencil"
  std::string_view label;  ///< "Pencil"
  std::string_view help;   ///< one sentence
  char shortcut = 0;       ///< key of the desktop, 0 for none
  std::span<const OptionSpec> options;
  /// draw() marks the selection; with other tools the session does.
  bool shows_selection = false;
};

/// What came of one sample.
struct ToolResult {
  /// The document with this edit is what the user should see now; replaces the previous preview.
  std::optional<Edit> preview = {};
  /// The gesture is over and this is what it did: one undo step.
  std::optional<Edit> commit = {};
  /// What is selected from now on, after `commit`.
  std::optional<Selection> selection = {};
  /// No preview here means that the last one stays, instead of none: an answer to a sample that
  /// changes nothing.
  bool same_preview = false;
};

/// A tool: a state machine over pen samples, without threads, clock, files or widgets. What it does
/// to a document it says as an edit; what the hand feels, as a force model; what the eye sees
/// besides the document, as an overlay. One room per tool; adding one is a folder and a line in
/// rooms.cc. Edit thread only.
class Tool {
 public:
  virtual ~Tool() = default;

  [[nodiscard]] virtual const ToolInfo& info() const noexcept = 0;
  /// Takes every sample of the device, in the air too.
  virtual ToolResult sample(const PenSample& sample, const Scene& scene) = 0;
  /// No sample follows for now: another tool was chosen, the device is gone, the script or the
  /// program ends. Ends the gesture as if the pen were lifted here, so that no ink is lost.
  virtual ToolResult finish(const Scene& scene) = 0;
  /// The gesture never was. The pen must be lifted before another begins.
  virtual void cancel() = 0;
  /// What the hand should feel from now on, until asked again.
  [[nodiscard]] virtual ForceModel force(const Scene& scene) const = 0;
  /// Adds what is to be seen besides the document: wet ink, rings, tethers.
  virtual void draw(Overlay& overlay) const = 0;

  /// Options; the default is that they take effect with the next gesture.
  virtual Result<void> set_option(std::string_view id, const OptionValue& value) = 0;
  [[nodiscard]] virtual Result<OptionValue> option(std::string_view id) const = 0;
};

/// One of each tool, in the order of the tool bar.
std::vector<std::unique_ptr<Tool>> make_tools();

}  // namespace felt
