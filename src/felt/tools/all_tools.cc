// The only file that includes every tool. To add a tool, add a folder and a line here.

#include "felt/tools/connect/connect_tool.h"
#include "felt/tools/eraser/eraser_tool.h"
#include "felt/tools/fill/fill_tool.h"
#include "felt/tools/gather/gather_tool.h"
#include "felt/tools/guide/guide_tool.h"
#include "felt/tools/lasso/lasso_tool.h"
#include "felt/tools/pencil/pencil_tool.h"
#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/read/read_tool.h"
#include "felt/tools/recolor/recolor_tool.h"
#include "felt/tools/shape/shape_tool.h"
#include "felt/tools/smooth/smooth_tool.h"
#include "felt/tools/tool.h"
#include "felt/tools/transform/transform_tool.h"
#include "felt/tools/width/width_tool.h"

namespace felt {

std::vector<std::unique_ptr<Tool>> make_tools() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(make_pencil());
  tools.push_back(make_pull());
  tools.push_back(make_smooth());
  tools.push_back(make_width());
  tools.push_back(make_eraser());
  tools.push_back(make_lasso());
  tools.push_back(make_transform());
  tools.push_back(make_connect());
  tools.push_back(make_recolor());
  tools.push_back(make_shape());
  tools.push_back(make_gather());
  tools.push_back(make_fill());
  tools.push_back(make_read());
  tools.push_back(make_guide());
  return tools;
}

}  // namespace felt
