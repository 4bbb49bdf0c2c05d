#include "felt/devices/cue/hid_descriptor.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace felt::hid_descriptor_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Descriptor of a mouse that uses many features: two reports, push and pop, usages of four bytes.
const Bytes kTwoReports{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01,              // mouse
                        0x85, 0x07, 0x05, 0x0E, 0x09, 0x21,              // report 7: trigger
                        0x15, 0x00, 0x25, 0x10, 0x75, 0x08, 0x95, 0x01,  //
                        0x91, 0x02,                                      // output
                        0xA4, 0x85, 0x09, 0x75, 0x04,                    // push; report 9
                        0x0B, 0x23, 0x00, 0x0E, 0x00, 0xB1, 0x02,        // feature, whole usage
                        0xB4,                                            // pop: report 7 again
                        0x09, 0x23, 0x26, 0xFF, 0x00, 0x91, 0x02,        // 0..255
                        0x15, 0x81, 0x25, 0x7F, 0x09, 0x25, 0x91, 0x02,  // -127..127
                        0xC0};

TEST(HidDescriptor, FieldsAreWhereTheyAre) {
  const Result<HidDescriptor> read = read_hid_descriptor(kTwoReports);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->fields.size(), 4u);
  EXPECT_TRUE(read->numbers_reports());
  const auto& f = read->fields;
  EXPECT_EQ(f[0].usage, 0x000E0021u);
  EXPECT_EQ(f[0].report, 7);
  EXPECT_EQ(f[0].application, 0x00010002u);
  EXPECT_EQ(f[0].kind, HidReportKind::kOutput);
  EXPECT_EQ(f[1].usage, 0x000E0023u);
  EXPECT_EQ(f[1].report, 9);
  EXPECT_EQ(f[1].bits, 4u);
  EXPECT_EQ(f[2].bit, 8u);
  EXPECT_EQ(f[2].maximum, 255);
  EXPECT_EQ(f[3].bit, 16u);
  EXPECT_EQ(f[3].minimum, -127);
  EXPECT_EQ(read->report_bytes(HidReportKind::kOutput, 7), 4u);
  EXPECT_EQ(read->report_bytes(HidReportKind::kFeature, 9), 2u);
  EXPECT_EQ(read->report_bytes(HidReportKind::kInput, 7), 0u);
}

TEST(HidDescriptor, ValuesGoInAndComeOut) {
  HidField field;
  field.bit = 5;
  field.bits = 11;
  field.minimum = -1000;
  field.maximum = 1000;
  Bytes report(3, 0xFF);
  for (const int value : {-1000, -1, 0, 1, 999, 1000}) {
    set_hid_value(report, field, value);
    EXPECT_EQ(hid_value(report, field), value);
  }
  EXPECT_EQ(report[0], 0xFF);
  EXPECT_EQ(report[1] & 0x1F, 0x1F) << "the neighbours stay";
  set_hid_value(report, field, 5000);
  EXPECT_EQ(hid_value(report, field), 1000);
  Bytes too_short(2, 0);
  EXPECT_EQ(hid_value(too_short, field), 0);
  set_hid_value(too_short, field, 7);  // must not write past the end
}

/// A report must have the length that the device expects, because otherwise the kernel or the
/// device refuses it.
TEST(HidDescriptor, WhatFillsAReportUpIsOfItsLength) {
  const Bytes padded{0x05, 0x0E, 0x09, 0x21, 0x15, 0x00, 0x25, 0x10, 0x75, 0x08,
                     0x95, 0x01, 0x91, 0x02, 0x75, 0x04, 0x95, 0x05, 0x91, 0x03};
  const auto read = read_hid_descriptor(padded);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->fields.size(), 1u);
  EXPECT_EQ(read->report_bytes(HidReportKind::kOutput, 0), 1u + 1u + 3u);
}

TEST(HidDescriptor, ARangeOfUsagesEndsAtTheLastNumberThereIs) {
  Bytes bytes{0x1B, 0xF0, 0xFF, 0xFF, 0xFF, 0x2B, 0xFF, 0xFF, 0xFF, 0xFF};
  bytes.insert(bytes.end(), {0x75, 0x01, 0x95, 0x10, 0x25, 0x01, 0x81, 0x02});
  const auto read = read_hid_descriptor(bytes);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->fields.size(), 16u);
  EXPECT_EQ(read->fields.front().usage, 0xFFFFFFF0u);
  EXPECT_EQ(read->fields.back().usage, 0xFFFFFFFFu);
}

TEST(HidDescriptor, ARangeOfValuesThatMakesNoSenseIsAnError) {
  for (const Bytes& range :
       {Bytes{0x15, 0x05, 0x25, 0x03}, Bytes{0x15, 0xFF, 0x25, 0xFB}, Bytes{0x15, 0x01, 0x25, 0x00},
        Bytes{0x17, 0xFF, 0xFF, 0xFF, 0x7F, 0x25, 0x10}}) {
    Bytes bytes{0x05, 0x0E, 0x09, 0x21, 0x75, 0x08, 0x95, 0x01};
    bytes.insert(bytes.end(), range.begin(), range.end());
    bytes.insert(bytes.end(), {0x91, 0x02});
    const auto read = read_hid_descriptor(bytes);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("range of values"), std::string::npos);
  }
}

TEST(HidDescriptor, AFieldHoldsNoMoreThanItsBits) {
  HidField field;
  field.bits = 4;
  field.maximum = 1000;
  Bytes report(2, 0);
  set_hid_value(report, field, 300);
  EXPECT_EQ(hid_value(report, field), 15);
  field.minimum = -1000;
  set_hid_value(report, field, -300);
  EXPECT_EQ(hid_value(report, field), -8);
}

TEST(HidDescriptor, WhatMakesNoSenseIsAnError) {
  const auto error_of = [](const Bytes& bytes) {
    const auto read = read_hid_descriptor(bytes);
    return read ? std::string() : read.error().message;
  };
  EXPECT_NE(error_of({0xA1, 0x01}).find("does not end"), std::string::npos);
  EXPECT_NE(error_of({0xC0}).find("has not started"), std::string::npos);
  EXPECT_NE(error_of({0x26, 0x01}).find("within an item"), std::string::npos);
  EXPECT_NE(error_of({0xFE, 0x10, 0x00}).find("within a long item"), std::string::npos);
  EXPECT_NE(error_of({0xB4}).find("a pop without a push"), std::string::npos);
  EXPECT_NE(error_of({0x85, 0x00}).find("number"), std::string::npos);
  EXPECT_NE(error_of({0x76, 0xFF, 0xFF}).find("too wide"), std::string::npos);
  EXPECT_NE(error_of({0x96, 0xFF, 0xFF}).find("too many"), std::string::npos);
  EXPECT_NE(error_of({0x19, 0x05, 0x29, 0x01}).find("range"), std::string::npos);
  EXPECT_NE(error_of({0x1A, 0x00, 0x00, 0x2A, 0xFF, 0xFF}).find("range"), std::string::npos);
  EXPECT_NE(error_of(Bytes(5000, 0x00)).find("exceeds the maximum length"), std::string::npos);
  EXPECT_NE(error_of(Bytes(40, 0xA4)).find("nested pushes"), std::string::npos);
  Bytes deep;
  for (int i = 0; i < 40; ++i) deep.insert(deep.end(), {0xA1, 0x00});
  EXPECT_NE(error_of(deep).find("deep"), std::string::npos);
  Bytes large{0x09, 0x01, 0x76, 0x00, 0x10, 0x96, 0x00, 0x10, 0x91, 0x02};
  EXPECT_NE(error_of(large).find("too long"), std::string::npos);
  EXPECT_EQ(error_of({}), "");
}

/// Memory and time are bounded for any input: the number of fields and the length of a report never
/// exceed their limits.
RC_GTEST_PROP(HidDescriptor, HostileOnesAreBounded, ()) {
  Bytes bytes = *rc::gen::element(kTwoReports, Bytes{});
  const auto noise = *rc::gen::container<Bytes>(rc::gen::arbitrary<std::uint8_t>());
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, bytes.size() + 1);
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), noise.begin(), noise.end());
  const auto read = read_hid_descriptor(bytes);
  if (!read) return;
  RC_ASSERT(read->fields.size() <= kMaxHidFields);
  Bytes report(16, 0xA5);
  for (const HidField& field : read->fields) {
    RC_ASSERT(field.bits >= 1);
    RC_ASSERT(field.bits <= 32);
    RC_ASSERT(field.bit + field.bits <= kMaxReportBits);
    set_hid_value(report, field, hid_value(report, field));
  }
}

}  // namespace
}  // namespace felt::hid_descriptor_test
