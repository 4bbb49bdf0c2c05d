#include "felt/io/fill_path.h"

namespace felt {

OutlinePath fill_path(const Fill& fill) {
  OutlinePath path;
  for (const FillLoop& loop : fill.loops) {
    path.verbs.push_back(OutlinePath::Verb::kMove);
    path.verbs.insert(path.verbs.end(), loop.points.size() / 3, OutlinePath::Verb::kCubic);
    path.verbs.push_back(OutlinePath::Verb::kClose);
    path.points.insert(path.points.end(), loop.points.begin(), loop.points.end());
  }
  return path;
}

}  // namespace felt
