#include "felt/driver/device_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "felt/haptics/safety/safety_limits.h"

namespace felt::device_profile_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Folder {
  Folder() {
    std::string made = std::filesystem::temp_directory_path() / "felt-profile-XXXXXX";
    path = mkdtemp(made.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  [[nodiscard]] std::string below() const { return path + "/feltline/devices"; }

  std::string path;
};

DeviceProfile full() {
  const double c = std::cos(0.698), s = std::sin(0.698);
  DeviceProfile profile;
  profile.device_id = "haply:049D";
  profile.serial = "049D";
  profile.name = "Der linke, für Ölkreide";
  profile.left_handed = true;
  profile.plane = PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -c, s}, Vec3{0, s, c}},
                                         {148.5, 1.0 / 3.0, -12}, 1.25);
  profile.area = DrawingArea{{0.1, 20, -15}, 160.5, 120};
  profile.other_plane =
      PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {-20, 7, 1.0 / 7.0});
  profile.other_area = DrawingArea{{-60, 20, -15}, 120, 90.25};
  profile.force_limit_n = 2.1;
  profile.stiffness_cap_n_per_m = 300;
  profile.friction_n = 0.125;
  profile.mass_kg = 0.05;
  profile.unknown = {"grip = soft", "tilt = 3 # of a newer program"};
  return profile;
}

TEST(DeviceProfile, ComesBackToTheLastBit) {
  const Folder folder;
  const DeviceProfile profile = full();
  ASSERT_TRUE(profile.plane.has_value());
  const Result<void> saved = save_device_profile(folder.below(), profile);
  ASSERT_TRUE(saved.has_value()) << saved.error().message;
  const Result<DeviceProfile> loaded = load_device_profile(folder.below(), "haply:049D");
  ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
  EXPECT_EQ(*loaded, profile);
  DeviceProfile bare;
  bare.device_id = "haply:049D";
  ASSERT_TRUE(save_device_profile(folder.below(), bare).has_value());
  EXPECT_EQ(load_device_profile(folder.below(), "haply:049D").value(), bare);
}

TEST(DeviceProfile, AnyPlaneComesBack) {
  std::mt19937 random(7);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
  };
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const double a = between(-3, 3), b = between(-3, 3);
    const Vec3 x{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    const Vec3 y{-std::sin(a), std::cos(a), 0};
    const Vec3 z{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
    DeviceProfile profile;
    profile.device_id = "any:1";
    profile.plane = PlaneCalibration::from(
        {x, y, z}, {between(-900, 900), between(-1e-7, 1e-7), between(-9, 9)}, between(0.5, 2));
    ASSERT_TRUE(profile.plane.has_value());
    const auto read = parse_device_profile(device_profile_text(profile), "x");
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_EQ(*read, profile);
  }
}

TEST(DeviceProfile, WithoutAFileNothingIsSet) {
  const Folder folder;
  const auto loaded = load_device_profile(folder.below(), "openhaptics:default");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->device_id, "openhaptics:default");
  EXPECT_FALSE(loaded->plane || loaded->force_limit_n || loaded->left_handed);
  EXPECT_FALSE(std::filesystem::exists(folder.below())) << "reading makes nothing";
}

TEST(DeviceProfile, WhatMakesNoSenseIsToldWithItsPlace) {
  const auto error_of = [](const std::string& text) {
    const auto read = parse_device_profile(text, "f.conf");
    return read ? std::string("none") : read.error().message;
  };
  const std::string head = "device = a:1\n";
  EXPECT_EQ(error_of(head + "# note\n\nhand = both\n"),
            "f.conf:4: hand: must be \"left\" or \"right\"");
  EXPECT_THAT(error_of(head + "hand\n"), StartsWith("f.conf:2: has no \"=\""));
  EXPECT_THAT(error_of(head + "= 3\n"), HasSubstr("f.conf:2: has no name"));
  EXPECT_THAT(error_of(head + "device = b\n"), EndsWith("f.conf:2: device occurs twice"));
  EXPECT_THAT(error_of("name = x\n"), HasSubstr("does not name its device"));
  for (const char* bad : {"", "two", "1,5", "1 2", "nan", "inf", "-1", "0", "1e9", "1x"}) {
    EXPECT_THAT(error_of(head + "force_limit_n = " + bad + "\n"),
                StartsWith("f.conf:2: force_limit_n: "))
        << bad;
  }
  for (const char* bad : {"0.4", "2.1", "nan", ""}) {
    EXPECT_THAT(error_of(head + "plane_scale = " + bad + "\n"), StartsWith("f.conf:2: plane_scale"))
        << bad;
  }
  EXPECT_THAT(error_of(head + "plane_x = 1 0 0\n"), HasSubstr("it needs plane_x"));
  EXPECT_THAT(error_of(head + "plane_x = 1 0\n"), HasSubstr("is not 3 numbers"));
  EXPECT_THAT(error_of(head + "plane_x = 2 0 0\nplane_y = 0 1 0\nplane_z = 0 0 1\n"
                              "plane_origin_mm = 0 0 0\n"),
              HasSubstr("must have length 1"));
  EXPECT_THAT(error_of(head + "area_mm = 100 50\n"), HasSubstr("there is only one"));
  EXPECT_THAT(error_of(head + "area_mm = 100 -50\n"), HasSubstr("must be a width and a height"));
  EXPECT_THAT(error_of(head + "name = \xff\xfe\n"), HasSubstr("f.conf:2: name: is not UTF-8"));
  EXPECT_EQ(error_of(head + "something = else\r\n"), "none");
}

TEST(DeviceProfile, FilesOfOthersAndBrokenOnesAreNamed) {
  const Folder folder;
  std::filesystem::create_directories(folder.below());
  const std::string path = device_profile_path(folder.below(), "a:1");
  const auto write = [&path](const std::string& text) { std::ofstream(path) << text; };
  write("device = b:2\n");
  EXPECT_THAT(load_device_profile(folder.below(), "a:1").error().message,
              HasSubstr("belongs to the device \"b:2\""));
  write(std::string(100'000, 'x'));
  EXPECT_THAT(load_device_profile(folder.below(), "a:1").error().message, HasSubstr(path));
  std::filesystem::remove(path);
  std::filesystem::create_directory(path);
  EXPECT_THAT(load_device_profile(folder.below(), "a:1").error().message, HasSubstr(path));
  DeviceProfile profile;
  profile.device_id = "a:1";
  EXPECT_FALSE(save_device_profile(folder.below(), profile).has_value());
  profile.device_id = "a:2";
  profile.name = "two\nlines = 1";
  EXPECT_FALSE(save_device_profile(folder.below(), profile).has_value());
  EXPECT_FALSE(std::filesystem::exists(device_profile_path(folder.below(), "a:2")));
}

TEST(DeviceProfile, NoIdLeadsOutOfTheFolderAndNoTwoShareAFile) {
  std::set<std::string> paths;
  const std::vector<std::string> ids{"",
                                     ".",
                                     "..",
                                     "../../etc/passwd",
                                     "a:b",
                                     "a+b",
                                     "a%3Ab",
                                     "a/b",
                                     "A:b",
                                     "a b",
                                     "a\nb",
                                     "\xc3\xa4",
                                     "a\\b",
                                     std::string(500, 'x'),
                                     std::string(500, 'x') + "y",
                                     std::string("a\0b", 3)};
  for (const std::string& id : ids) {
    const std::string path = device_profile_path("/f", id);
    EXPECT_EQ(path.find_last_of('/'), 2u) << path;
    EXPECT_LT(path.size(), 200u);
    EXPECT_NE(path[3], '.');
    EXPECT_TRUE(paths.insert(path).second) << path;
  }
  EXPECT_EQ(device_profile_path("/f", "haply:049D"), "/f/haply+049D.conf");
}

TEST(DeviceProfile, NoBytesAreTooOddToRead) {
  std::mt19937 random(11);
  const std::string whole = device_profile_text(full());
  for (int seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    std::string text = whole;
    for (std::uint32_t i = 0; i < 1 + random() % 6; ++i) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, 1 + random() % 20);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 30));
      }
      if (text.empty()) text = "=";
    }
    const auto read = parse_device_profile(text, "f");
    if (!read) {
      EXPECT_THAT(read.error().message, StartsWith("f:"));
    } else if (read->plane) {
      EXPECT_TRUE(std::isfinite(norm(read->plane->to_page(Vec3{1, 2, 3}))));
    }
  }
}

TEST(DeviceProfile, APersonsLimitsOnlyLower) {
  Capabilities touch;
  touch.max_force_n = 3.3;
  touch.advised_force_n = 2.5;
  touch.max_stiffness_n_per_m = 400;
  DeviceProfile profile;
  EXPECT_EQ(limited_by(profile, touch), touch);
  profile.force_limit_n = 9.0;
  profile.stiffness_cap_n_per_m = 1e5;
  EXPECT_EQ(limits_for(limited_by(profile, touch)).peak_force_n, limits_for(touch).peak_force_n);
  EXPECT_EQ(limited_by(profile, touch).max_stiffness_n_per_m, 400);
  profile.force_limit_n = 0.4;
  profile.stiffness_cap_n_per_m = 250;
  EXPECT_EQ(limits_for(limited_by(profile, touch)).peak_force_n, 0.4);
  EXPECT_EQ(limited_by(profile, touch).max_stiffness_n_per_m, 250);
  // A device without an advised force is still limited by its nominal force.
  touch.advised_force_n = 0.0;
  profile.force_limit_n = 9.0;
  EXPECT_EQ(limits_for(limited_by(profile, touch)).peak_force_n, limits_for(touch).peak_force_n);
}

TEST(DeviceProfile, WhatWasMeasuredReplacesTheModelsEstimates) {
  Capabilities touch;
  touch.friction_n = 0.26;
  touch.mass_kg = 0.045;
  EXPECT_EQ(limited_by({}, touch), touch);
  DeviceProfile profile;
  profile.friction_n = 0.1;
  EXPECT_EQ(limited_by(profile, touch).friction_n, 0.1);
  EXPECT_EQ(limited_by(profile, touch).mass_kg, 0.045);
  profile.mass_kg = 0.08;
  EXPECT_EQ(limited_by(profile, touch).mass_kg, 0.08);
  profile.serial = "one";
  forget_planes_of_another(profile, "two");
  EXPECT_EQ(limited_by(profile, touch), touch);
  EXPECT_FALSE(parse_device_profile("device = a\nmass_kg = 45\n", "p"));  // grams
  EXPECT_FALSE(parse_device_profile("device = a\nfriction_n = -1\n", "p"));
}

TEST(DeviceProfile, AnotherOfItsKindIsNotIt) {
  DeviceProfile profile;
  EXPECT_TRUE(is_of(profile, "123"));
  profile.serial = "123";
  EXPECT_TRUE(is_of(profile, "123"));
  EXPECT_TRUE(is_of(profile, ""));
  EXPECT_FALSE(is_of(profile, "124"));
}

TEST(DeviceProfile, EachHandHasItsPlaneAndArea) {
  const DeviceProfile left = full();
  ASSERT_TRUE(left.left_handed && left.other_plane);
  DeviceProfile right = left;
  switch_hand(right);
  EXPECT_FALSE(right.left_handed);
  EXPECT_EQ(right.plane, left.other_plane);
  EXPECT_EQ(right.area, left.other_area);
  EXPECT_EQ(right.other_plane, left.plane);
  EXPECT_EQ(parse_device_profile(device_profile_text(right), "f").value(), right);
  // The planes keep their names in the file, whichever hand is active.
  const auto lines = [](std::string text) {
    const std::string hand = "hand = left\n";
    if (const std::size_t at = text.find(hand); at != std::string::npos)
      text.erase(at, hand.size());
    std::multiset<std::string> all;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos;
         text.erase(0, end + 1)) {
      all.insert(text.substr(0, end));
    }
    return all;
  };
  EXPECT_EQ(lines(device_profile_text(left)), lines(device_profile_text(right)));
  EXPECT_THAT(device_profile_text(right), HasSubstr("\nplane_origin_mm = -20 7 "));
  EXPECT_THAT(device_profile_text(left), HasSubstr("\nleft_plane_scale = 1.25\n"));
  switch_hand(right);
  EXPECT_EQ(right, left);
  const auto half = parse_device_profile("device = a:1\nleft_plane_x = 1 0 0\n", "f");
  ASSERT_FALSE(half.has_value());
  EXPECT_THAT(half.error().message, HasSubstr("it needs left_plane_x, left_plane_y"));
}

TEST(DeviceProfile, PlanesOfAnotherOfItsKindAreForgottenForBothHands) {
  DeviceProfile profile = full();
  forget_planes_of_another(profile, "");
  forget_planes_of_another(profile, "049D");
  EXPECT_EQ(profile, full());
  forget_planes_of_another(profile, "0500");
  EXPECT_FALSE(profile.plane || profile.area || profile.other_plane || profile.other_area);
  EXPECT_EQ(profile.serial, "0500");
  EXPECT_EQ(profile.force_limit_n, full().force_limit_n);
}

TEST(DeviceProfile, TheFolderIsBelowTheConfigurationsFolder) {
  const auto kept = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
  };
  const auto config = kept("XDG_CONFIG_HOME"), home = kept("HOME");
  setenv("XDG_CONFIG_HOME", "/c", 1);
  EXPECT_EQ(device_profiles_folder().value(), "/c/feltline/devices");
  setenv("XDG_CONFIG_HOME", "not/absolute", 1);
  setenv("HOME", "/h", 1);
  EXPECT_EQ(device_profiles_folder().value(), "/h/.config/feltline/devices");
  unsetenv("HOME");
  EXPECT_THAT(device_profiles_folder().error().message, HasSubstr("XDG_CONFIG_HOME"));
  config ? setenv("XDG_CONFIG_HOME", config->c_str(), 1) : unsetenv("XDG_CONFIG_HOME");
  if (home) setenv("HOME", home->c_str(), 1);
}

}  // namespace
}  // namespace felt::device_profile_test
