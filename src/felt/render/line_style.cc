#include "felt/render/line_style.h"

#include <algorithm>

namespace felt {
namespace {

using NamedStyles = std::vector<std::pair<std::string, StrokeStyle>>;

bool has_style(const MediumStyle& style) noexcept {
  return style.kind != StyleKind::kPlain || style.arrows != StyleArrows::kNone;
}

std::shared_ptr<const NamedStyles> styles_of(const Materials& materials) {
  auto all = std::make_shared<NamedStyles>();
  for (const Medium& medium : materials.media()) {
    if (!has_style(medium.style)) continue;
    StrokeStyle style{medium.style, {}};
    if (style.how.kind == StyleKind::kRepeat || style.how.kind == StyleKind::kStretch) {
      Result<StyleShape> shape = read_style_shape(style.how.shape);
      if (!shape) continue;
      style.shape = *std::move(shape);
    }
    all->emplace_back(medium.id, std::move(style));
  }
  return all;
}

}  // namespace

StrokeStyles::StrokeStyles() noexcept {
  static const std::shared_ptr<const NamedStyles> kBuiltIn = styles_of(Materials::built_in());
  all_ = kBuiltIn;
}

StrokeStyles::StrokeStyles(const Materials& materials) : all_(styles_of(materials)) {}

const StrokeStyle* StrokeStyles::find(std::string_view medium) const noexcept {
  const auto found = std::find_if(all_->begin(), all_->end(),
                                  [medium](const auto& known) { return known.first == medium; });
  return found == all_->end() ? nullptr : &found->second;
}

}  // namespace felt
