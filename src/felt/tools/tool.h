#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/document/edit.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/contact.h"
#include "felt/tools/overlay.h"
#include "felt/tools/scene.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Buttons of the pen that change what a gesture does; ToolUse says how. A desktop sets them for
/// keys too (Shift, Ctrl).
inline constexpr std::uint32_t kFirstModifier = 1U << 0;
inline constexpr std::uint32_t kSecondModifier = 1U << 1;

/// What a tool does to a drawing. The other layers and the programs decide by this, never by the
/// name of a tool.
enum class ToolKind : std::uint8_t {
  kDraws,       ///< adds lines in the medium of its option "material"; a session starts with it
  kEdits,       ///< changes lines under the pen; a gesture that meets none missed its target
  kErases,      ///< removes ink, rubbing with the medium "eraser"
  kSelects,     ///< changes what is selected; draws the selection itself
  kTransforms,  ///< changes what is selected when the gesture begins; draws the selection itself
};

/// Where a typical gesture of a tool goes. Tests of devices and of the haptic loop perform it.
enum class ToolPath : std::uint8_t {
  kFree,    ///< across free space, as a new line
  kAway,    ///< from a line away to one side
  kAlong,   ///< along a line
  kAcross,  ///< across lines
  kAround,  ///< around lines
  kFromEnd  ///< from the end of a line away
};

/// How a tool is used while its option "mode" has one value.
struct ToolUse {
  std::string_view mode = {};            ///< value of the option "mode"; "" for all others
  std::string_view hint = {};            ///< one line, shown while the pen hovers
  std::string_view first_modifier = {};  ///< what kFirstModifier changes: "thinner"; "" for nothing
  std::string_view second_modifier = {};  ///< same for kSecondModifier
  std::string_view size = {};             ///< number option that is its size; "" for none
  ToolPath path = ToolPath::kAway;
};

/// The act of the demonstration that shows a tool: its script is the file N-ID.ndjson in the tool's
/// folder, where N is its place in the demonstration.
struct ToolAct {
  std::string_view title = {};    ///< "Pull and push"; "" if there is no act
  std::string_view caption = {};  ///< one or two sentences
  double seconds = 0.0;           ///< longest duration on screen
};

/// What others need to know of a tool: menus, panels, the command line, the documents, the tests.
struct ToolInfo {
  std::string_view id;     ///< "pencil"; the name of its folder, of its icon and of its page
  std::string_view label;  ///< "Pencil"
  std::string_view help;   ///< one sentence
  char shortcut = 0;       ///< key of the desktop, 0 for none
  std::span<const OptionSpec> options;
  ToolKind kind = ToolKind::kEdits;
  std::span<const ToolUse> uses = {};            ///< the first that fits the mode counts
  std::span<const std::string_view> edits = {};  ///< labels of the edits that it makes
  ToolAct act = {};
};

/// The size of a tool as it is set now, and its range.
struct ToolSize {
  double mm = 0.0;
  double min_mm = 0.0;
  double max_mm = 0.0;
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

/// A tool: a state machine over pen samples, without threads, clock, files or widgets. It changes a
/// document by edits, returns what the hand feels as a force model, and draws what is visible
/// besides the document into an overlay. One folder per tool; ARCHITECTURE.md and `./dev new tool`
/// say what is in it. Edit thread only.
class Tool {
 public:
  virtual ~Tool() = default;

  [[nodiscard]] virtual const ToolInfo& info() const noexcept = 0;
  /// Handles one sample of the device, in the air too. `contact` is what the session's Contact made
  /// of it. Requires is_pen_position().
  virtual ToolResult sample(const PenSample& sample, Contact::Change contact,
                            const Scene& scene) = 0;
  /// Called when the sample stream stops: another tool was chosen, the device is gone, the script
  /// or the program ends. Commits the gesture as if the pen had been lifted, so that no ink is
  /// lost.
  virtual ToolResult finish(const Scene& scene) = 0;
  /// Discards the gesture. The pen must be lifted before another begins.
  virtual void cancel() = 0;
  /// Returns what the hand should feel from now on, until asked again.
  [[nodiscard]] virtual ForceModel force(const Scene& scene) const = 0;
  /// Adds what is visible besides the document: wet ink, rings, tethers.
  virtual void draw(Overlay& overlay) const = 0;

  /// Options; the default is that they take effect with the next gesture.
  virtual Result<void> set_option(std::string_view id, const OptionValue& value) = 0;
  [[nodiscard]] virtual Result<OptionValue> option(std::string_view id) const = 0;

  /// Returns its size, or nullopt if it has none: the option that its ToolUse names.
  [[nodiscard]] virtual std::optional<ToolSize> size() const;
  /// Returns the options to set, by id, so that its size becomes `mm`, clamped to its range.
  [[nodiscard]] virtual std::vector<std::pair<std::string_view, double>> options_for_size(
      double mm) const;

  /// Returns how it is used as it is set now; its help is the hint if the tool names none.
  [[nodiscard]] ToolUse use() const;
};

/// One of each tool, in the order of the tool bar.
std::vector<std::unique_ptr<Tool>> make_tools();

}  // namespace felt
