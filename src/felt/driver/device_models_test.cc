#include "felt/driver/device_models.h"

#include <gtest/gtest.h>

#include <set>

#include "felt/haptics/safety/safety_limits.h"

namespace felt::device_models_test {
namespace {

TEST(DeviceModels, AreFoundByTheirIds) {
  std::set<std::string_view> ids;
  for (const DeviceModel& model : device_models()) {
    EXPECT_TRUE(ids.insert(model.id).second) << model.id << " stands twice";
    EXPECT_EQ(find_device_model(model.id), &model);
    EXPECT_FALSE(model.label.empty()) << model.id;
    EXPECT_FALSE(model.source.empty()) << model.id;
  }
  EXPECT_EQ(find_device_model("no such"), nullptr);
  EXPECT_EQ(find_device_model(""), nullptr);
}

TEST(DeviceModels, FiguresMakeSense) {
  for (const DeviceModel& model : device_models()) {
    SCOPED_TRACE(model.id);
    const Capabilities& device = model.capabilities;
    EXPECT_TRUE(device.has_force());
    EXPECT_GT(device.continuous_force_n, 0.0);
    EXPECT_LE(device.continuous_force_n, device.max_force_n);
    EXPECT_GT(device.advised_force_n, 0.0);
    EXPECT_LE(device.advised_force_n, 0.9 * device.max_force_n);
    EXPECT_LT(device.workspace_min.x, device.workspace_max.x);
    EXPECT_LT(device.workspace_min.y, device.workspace_max.y);
    EXPECT_LE(device.workspace_min.z, device.workspace_max.z);
    EXPECT_GE(device.period_ns, kShortestPeriodNs);
    EXPECT_LE(device.period_ns, kLongestPeriodNs);
    EXPECT_TRUE(is_sound(limits_for(device)));
  }
}

TEST(DeviceModels, TheUnknownOneIsTheLeastOfAll) {
  const Capabilities& unknown = generic_device_model().capabilities;
  for (const DeviceModel& model : device_models()) {
    if (model.capabilities.actuated_axes < 3) continue;
    SCOPED_TRACE(model.id);
    EXPECT_LE(unknown.max_force_n, model.capabilities.max_force_n);
    EXPECT_LE(unknown.continuous_force_n, model.capabilities.continuous_force_n);
    EXPECT_LE(unknown.advised_force_n, model.capabilities.advised_force_n);
    EXPECT_LE(unknown.max_stiffness_n_per_m, model.capabilities.max_stiffness_n_per_m);
  }
}

}  // namespace
}  // namespace felt::device_models_test
