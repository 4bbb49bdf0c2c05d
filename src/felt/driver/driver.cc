#include "felt/driver/driver.h"

#include "felt/driver/cue_device.h"

namespace felt {

Result<std::unique_ptr<CueDevice>> Driver::open_cue(const DeviceDescriptor& device) {
  return fail(ErrorCode::kUnsupported, "\"" + device.id + "\" plays no cues");
}

}  // namespace felt
