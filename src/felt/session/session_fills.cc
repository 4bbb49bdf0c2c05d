// How the fills of a session follow its edits.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "felt/fill/follow_edit.h"
#include "felt/session/session.h"

namespace felt {
namespace {

/// Returns what the tool that fills says about fills whose boundary is opened.
WhenOpened when_opened(const Session& session) {
  const Tool* fills = session.first_tool(ToolKind::kFills);
  const Result<OptionValue> value =
      fills ? fills->option("opened") : Result<OptionValue>(std::string("close"));
  return value && *value == OptionValue(std::string("remove")) ? WhenOpened::kRemove
                                                               : WhenOpened::kClose;
}

}  // namespace

void Session::let_fills_follow(Edit& edit) const {
  if (document_.fill_count() == 0) {
    fill_map_.reset();
    return;
  }
  if (edit.changes.empty()) return;
  if (!fill_map_) fill_map_ = std::make_unique<DocumentMap>(DocumentMap::Of::kAllStrokes);
  std::vector<FillChange> fills = following_fills(document_, edit, *fill_map_, when_opened(*this));
  std::move(fills.begin(), fills.end(), std::back_inserter(edit.fills));
}

const std::optional<Edit>& Session::preview_with_fills() const {
  if (!shown_is_current_) {
    shown_preview_ = preview_;
    if (shown_preview_) let_fills_follow(*shown_preview_);
    shown_is_current_ = true;
  }
  return shown_preview_;
}

}  // namespace felt
