#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/session/session.h"
#include "felt/session/surface_options.h"
#include "tests/drawing/gestures/checks.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// Counts of the gestures with one tool and of their effects.
struct ToolTotals {
  std::uint64_t gestures = 0, edits = 0, previews = 0, selections = 0;
  std::uint64_t readings = 0;  ///< of different things under the pen (Tool::reading)
  double largest_n = 0.0;      ///< largest force without those of the surface, in N
};

struct Totals {
  std::map<std::string, ToolTotals, std::less<>> tools;
  std::uint64_t samples = 0, undone = 0, chosen = 0, exact = 0;
  std::uint64_t digest = 0xcbf29ce484222325ULL;  ///< FNV-1a hash of the final documents
};

struct EpisodeOptions {
  std::uint64_t seed = 1;
  int gestures = 20;
  std::string tool;  ///< id of the tool that makes most gestures; "" for any tool
  bool trace = false;
};

/// Runs one drawing session that starts with a random drawing: random gestures with all tools and
/// options, interrupted by undo, redo, cancel and changes of tool. After each step it checks the
/// rules of checks.h and those of the history: a gesture makes at most one undo step and that step
/// changes something, and a cancelled gesture changes nothing. At the end, undoing everything must
/// restore the first document byte for byte, and redoing everything the last (R52).
class Episode {
 public:
  Episode(const EpisodeOptions& options, const std::vector<Stroke>& real, Totals& totals);

  /// Returns the rule that was broken, or nullopt if all rules hold.
  Broken run();
  /// Returns the current step, for example "pull, gesture 7 (along), pull.radius_mm = 20".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  [[nodiscard]] std::string_view tool() const noexcept { return session_.tool().info().id; }

 private:
  SessionOptions session_options(const std::vector<Stroke>& real);
  ToolTotals& tool_totals();
  void see_edit(const Edit& edit);
  void break_rule(Broken broken);
  template <class What>
  void apply(const What& what);
  /// Same as apply(), for events whose edits do not come from a tool.
  template <class What>
  void command(const What& what);
  void take(const PenSample& sample);
  void check_state(const PenSample& sample);

  void one_gesture(int number);
  void choose_tool();
  void choose_options();
  void choose_option(std::string_view owner, const OptionSpec& spec);
  void between_gestures();
  void interfere();
  void undo_and_redo();
  void cancel();
  void import();
  void select_or_delete();
  void change_layers();
  void change_edges();
  void use_ring();
  void change_guides();
  void make_exact();
  void mean_something();
  void choose_offer();
  void back_and_forth();

  EpisodeOptions options_;
  Totals& totals_;
  Dice dice_;
  ForceProbe probe_;
  std::uint64_t edits_ = 0;
  bool is_command_ = false;  // the next edits come from undo, redo or layers, not from a tool
  Broken broken_;
  std::string where_;
  std::int64_t now_ns_ = 0;
  // Contacts that the session has reported to the tools, and imports; edits of tools.
  std::uint64_t touches_ = 0, commits_ = 0;
  std::size_t samples_in_gesture_ = 0;
  VelocityFilter velocity_;
  std::int64_t velocity_ns_ = 0;
  Selection last_selection_;
  std::uint32_t last_news_ = 0;
  Overlay overlay_;
  Document last_;  // the document before the next edit
  Document start_;
  Session session_;
};

/// Returns the whole document as bytes: its layers, and its strokes as in a file.
std::string bytes_of(const Document& document);

}  // namespace felt::gestures
