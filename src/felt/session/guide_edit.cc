#include "felt/session/guide_edit.h"

#include <memory>
#include <string>

namespace felt {
namespace {

using GuideDo = GuidesEvent::Do;

Result<void> check_new_guide(const Document& document, const DrawingGuide& guide) {
  if (Result<void> fine = check_drawing_guide(guide); !fine) return fine;
  if (!guide.stroke || document.find(guide.stroke)) return {};
  return fail(ErrorCode::kNotFound, "stroke: no stroke " + std::to_string(guide.stroke.value));
}

Result<Edit> added_guide(const Document& document, const DrawingGuide& guide) {
  if (document.guides().size() >= kMaxDrawingGuides) {
    return fail(ErrorCode::kLimitExceeded, "guides: a drawing has at most 256 guides");
  }
  Edit edit{"Add guide", {}};
  edit.guides.push_back(
      {document.new_guide_id(), nullptr, std::make_shared<const DrawingGuide>(guide)});
  edit.toggles_guides = !document.shows_guides();
  return edit;
}

Edit changed_guide(const DrawingGuidePtr& present, const GuidesEvent& event) {
  Edit edit{"Change guide", {}};
  if (*present == event.guide) return edit;
  edit.guides.push_back({event.id, present, std::make_shared<const DrawingGuide>(event.guide)});
  return edit;
}

Edit without_guides(const Document& document) {
  Edit edit{"Remove guides", {}};
  for (const auto& [id, guide] : document.guides()) edit.guides.push_back({id, guide, nullptr});
  return edit;
}

Edit shown_guides(const Document& document, bool shown) {
  Edit edit{shown ? "Show guides" : "Hide guides", {}};
  edit.toggles_guides = document.shows_guides() != shown;
  return edit;
}

}  // namespace

Result<Edit> guide_edit(const Document& document, const GuidesEvent& event) {
  const DrawingGuidePtr present = document.find_guide(event.id);
  if ((event.what == GuideDo::kChange || event.what == GuideDo::kRemove) && !present) {
    return fail(ErrorCode::kNotFound, "id: no guide " + std::to_string(event.id.value));
  }
  if (event.what == GuideDo::kAdd || event.what == GuideDo::kChange) {
    if (Result<void> fine = check_new_guide(document, event.guide); !fine) {
      return tl::unexpected(fine.error());
    }
  }
  switch (event.what) {
    case GuideDo::kAdd:
      return added_guide(document, event.guide);
    case GuideDo::kChange:
      return changed_guide(present, event);
    case GuideDo::kRemove:
      return Edit{"Remove guide", {}, {}, {}, {{event.id, present, nullptr}}};
    case GuideDo::kClear:
      return without_guides(document);
    case GuideDo::kShow:
    case GuideDo::kHide:
      return shown_guides(document, event.what == GuideDo::kShow);
    case GuideDo::kUnlink:
      break;
  }
  return Edit{};
}

}  // namespace felt
