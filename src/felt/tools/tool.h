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
#include "felt/tools/offer.h"
#include "felt/tools/overlay.h"
#include "felt/tools/reading.h"
#include "felt/tools/scene.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Pen buttons that modify a gesture; ToolUse says how. A desktop program also maps keys (Shift,
/// Ctrl, Alt) to them.
inline constexpr std::uint32_t kFirstModifier = 1U << 0;
inline constexpr std::uint32_t kSecondModifier = 1U << 1;
inline constexpr std::uint32_t kThirdModifier = 1U << 2;

/// What a tool does to a drawing. Other modules and the programs branch on ToolKind, never on a
/// tool's id.
enum class ToolKind : std::uint8_t {
  kDraws,    ///< adds strokes in the medium of its option "medium"; a session starts with this tool
  kShapes,   ///< adds strokes in the medium, colour and width of new ink (Scene)
  kEdits,    ///< changes strokes under the pen
  kErases,   ///< removes ink; its medium is "eraser"
  kSelects,  ///< changes the selection and shows it
  kFills,    ///< adds, changes and removes fills; its option "opened" says what becomes of a fill
             ///< whose boundary is opened: "close" or "remove"
  kTransforms,  ///< changes the strokes that are selected when the gesture begins; shows the
                ///< selection
  kReads,       ///< changes nothing; reports what is under the pen (Tool::reading)
  kGuides,      ///< adds, changes and removes guides of the drawing
};

/// The path of a typical gesture. Tests of devices and of the haptic loop perform it.
enum class ToolPath : std::uint8_t {
  kFree,    ///< across free space, as a new line
  kAway,    ///< starts on a line and moves off sideways
  kAlong,   ///< along a line
  kAcross,  ///< across lines
  kAround,  ///< around lines
  kFromEnd  ///< starts at the end of a line and moves away
};

/// How a tool is used in one of its modes.
struct ToolUse {
  std::string_view mode = {};             ///< value of the option "mode"; "" matches any mode
  std::string_view hint = {};             ///< one line of text, shown while the pen hovers
  std::string_view first_modifier = {};   ///< effect of kFirstModifier, such as "thinner"; or ""
  std::string_view second_modifier = {};  ///< effect of kSecondModifier, or "" if it has none
  std::string_view third_modifier = {};   ///< effect of kThirdModifier, or "" if it has none
  std::string_view size = {};  ///< id of the number option that sets the tool's size; "" for none
  ToolPath path = ToolPath::kAway;
};

/// The part of the demonstration that shows a tool. Its script is the file N-ID.ndjson in the
/// tool's folder; N is the position of the act in the demonstration, ID the id of the tool. The
/// script of a further act of the same tool is N-ID-NAME.ndjson.
struct ToolAct {
  std::string_view name = {};     ///< NAME of a further act; "" for the first one
  std::string_view title = {};    ///< "Pull and push"; "" if the tool has no act
  std::string_view caption = {};  ///< one or two sentences
  double seconds = 0.0;           ///< longest duration on screen
};

/// Describes a tool for menus, panels, the command line, the documentation and the tests.
struct ToolInfo {
  std::string_view id;     ///< "pencil"; also the name of its folder, icon and help page
  std::string_view label;  ///< "Pencil"
  std::string_view help;   ///< one sentence
  char shortcut = 0;       ///< keyboard shortcut in the desktop program, 0 for none
  std::span<const OptionSpec> options;
  ToolKind kind = ToolKind::kEdits;
  std::span<const ToolUse> uses = {};            ///< the first one that matches the mode applies
  std::span<const std::string_view> edits = {};  ///< labels of the edits that the tool makes
  ToolAct act = {};
  std::span<const ToolAct> more_acts = {};
};

/// The current size of a tool and its range.
struct ToolSize {
  double mm = 0.0;
  double min_mm = 0.0;
  double max_mm = 0.0;
};

/// The result of handling one sample.
struct ToolResult {
  /// The preview: an edit that is shown as if it were applied to the document. It replaces the
  /// previous preview.
  std::optional<Edit> preview = {};
  /// The edit to commit, one undo step. Set if the gesture is over and has changed the document.
  std::optional<Edit> commit = {};
  /// An edit for the document after `commit`: it replaces the committed line by the line of the
  /// unchanged pen samples (AsDrawnEvent).
  std::optional<Edit> as_drawn = {};
  /// The new selection, applied after `commit`.
  std::optional<Selection> selection = {};
  /// What else the finished gesture could mean. `commit` and `selection` are those of the choice
  /// that applies.
  std::optional<Offer> offer = {};
  /// Why the gesture changes nothing, if it would exceed a limit. Set once in a gesture.
  std::optional<Error> refusal = {};
  /// If true, a missing `preview` keeps the previous one instead of removing it, for example
  /// because nothing visible has changed.
  bool same_preview = false;
};

/// A tool: a state machine over pen samples, without threads, clock, files or widgets. It changes
/// the document by edits, returns a force model for the hand, and draws previews and hints into an
/// overlay. Each tool has its own folder; ARCHITECTURE.md and `./dev new tool` describe the
/// contents. Use it on the edit thread only.
class Tool {
 public:
  virtual ~Tool() = default;

  [[nodiscard]] virtual const ToolInfo& info() const noexcept = 0;
  /// Handles one sample, which may be a hover sample. `contact` is the result of the session's
  /// Contact for this sample. Requires is_pen_position().
  virtual ToolResult sample(const PenSample& sample, Contact::Change contact,
                            const Scene& scene) = 0;
  /// Called when the sample stream stops: the user chose another tool, the device was disconnected,
  /// the script ended, or the program ends. Commits the gesture as if the pen had been lifted, so
  /// that no ink is lost.
  virtual ToolResult finish(const Scene& scene) = 0;
  /// Returns what the gesture in progress offers at the moment, for display; nullopt for nothing.
  [[nodiscard]] virtual std::optional<OfferView> offered() const { return std::nullopt; }
  /// Chooses what the gesture in progress becomes. Has no effect if it is not offered.
  virtual void choose(OfferKind /*kind*/) {}
  /// Discards the gesture. The pen must be lifted before another gesture begins.
  virtual void cancel() = 0;
  /// Returns the force model to render until the next call.
  [[nodiscard]] virtual ForceModel force(const Scene& scene) const = 0;
  /// Adds everything that the tool shows on top of the document: wet ink, rings, tethers.
  virtual void draw(Overlay& overlay) const = 0;

  /// Sets or returns an option. A change takes effect with the next gesture unless a tool says
  /// otherwise.
  virtual Result<void> set_option(std::string_view id, const OptionValue& value) = 0;
  [[nodiscard]] virtual Result<OptionValue> option(std::string_view id) const = 0;

  /// Returns what is under the pen, or null if the tool does not read (ToolKind::kReads).
  [[nodiscard]] virtual const Reading* reading() const { return nullptr; }

  /// Returns the value of the option that the current ToolUse names as the tool's size, or nullopt
  /// if it does not name any.
  [[nodiscard]] virtual std::optional<ToolSize> size() const;
  /// Returns the ids and values of the options to set so that the size becomes `mm`, clamped to its
  /// range.
  [[nodiscard]] virtual std::vector<std::pair<std::string_view, double>> options_for_size(
      double mm) const;

  /// Returns the largest force with which a line that is drawn over holds the pen (Retrace), N; 0
  /// for a tool that does not draw.
  [[nodiscard]] virtual double retrace_n() const { return 0.0; }

  /// Returns the ToolUse of the current mode. Its hint is ToolInfo::help if the tool gives none.
  [[nodiscard]] ToolUse use() const;
};

/// Makes one of each tool, in the order of the tool bar.
std::vector<std::unique_ptr<Tool>> make_tools();

}  // namespace felt
