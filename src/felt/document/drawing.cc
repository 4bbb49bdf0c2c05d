#include "felt/document/drawing.h"

#include <tuple>

namespace felt {

bool operator==(const Drawing& a, const Drawing& b) {
  const auto rest = [](const Drawing& d) {
    return std::tie(d.document, d.page, d.has_page, d.color, d.layer, d.palette, d.view,
                    d.materials);
  };
  const bool same_extras =
      a.extras == b.extras || (a.extras && b.extras && a.extras->equals(*b.extras));
  return same_extras && rest(a) == rest(b);
}

}  // namespace felt
