#include "base/text/utf8.h"

#include <gtest/gtest.h>

#include <string_view>

namespace text {
namespace {

void ExpectValid(std::string_view bytes, char32_t value) {
  const CodePoint point = DecodeUtf8(bytes, 0);
  EXPECT_TRUE(point.is_valid) << bytes;
  EXPECT_EQ(point.value, value);
  EXPECT_EQ(point.length, bytes.size());
}

void ExpectInvalid(std::string_view bytes) {
  const CodePoint point = DecodeUtf8(bytes, 0);
  EXPECT_FALSE(point.is_valid);
  EXPECT_EQ(point.value, char32_t{0xFFFD});
  EXPECT_EQ(point.length, 1u);
}

TEST(Utf8, DecodesTheFirstAndLastOfEachLength) {
  ExpectValid("\x7F", 0x7F);
  ExpectValid("\xC2\x80", 0x80);
  ExpectValid("\xDF\xBF", 0x7FF);
  ExpectValid("\xE0\xA0\x80", 0x800);
  ExpectValid("\xEF\xBF\xBF", 0xFFFF);
  ExpectValid("\xF0\x90\x80\x80", 0x10000);
  ExpectValid("\xF4\x8F\xBF\xBF", 0x10FFFF);
}

TEST(Utf8, KnowsWholeTexts) {
  EXPECT_TRUE(IsUtf8(""));
  EXPECT_TRUE(IsUtf8("fast \xC3\xBC"));
  EXPECT_FALSE(IsUtf8("fast\x80"));
  EXPECT_FALSE(IsUtf8("fast\xC3"));
}

TEST(Utf8, RefusesWhatIsNoUtf8) {
  ExpectInvalid("\x80");              // a continuation without a begin
  ExpectInvalid("\xC1\xBF");          // overlong
  ExpectInvalid("\xE0\x9F\xBF");      // overlong
  ExpectInvalid("\xF0\x8F\xBF\xBF");  // overlong
  ExpectInvalid("\xED\xA0\x80");      // a surrogate
  ExpectInvalid("\xF4\x90\x80\x80");  // beyond U+10FFFF
  ExpectInvalid("\xE2\x82");          // cut off
  ExpectInvalid("\xE2\x28\xA1");      // interrupted
}

TEST(Utf8, WideAndCombiningCharactersHaveTheirWidth) {
  EXPECT_EQ(DisplayWidth(U'a'), 1u);
  EXPECT_EQ(DisplayWidth(U'\u00f6'), 1u);
  EXPECT_EQ(DisplayWidth(U'\u0301'), 0u);
  EXPECT_EQ(DisplayWidth(U'\u6f22'), 2u);
  EXPECT_EQ(DisplayWidth(U'\U0001F600'), 2u);
  EXPECT_EQ(DisplayWidth("a\u00f6\u0301\u6f22"), 4u);
}

TEST(Utf8, ControlAndDirectionCharactersAreUnprintable) {
  EXPECT_TRUE(IsUnprintable(U'\x1b'));
  EXPECT_TRUE(IsUnprintable(U'\u202e'));
  EXPECT_TRUE(IsUnprintable(U'\u061c'));
  EXPECT_TRUE(IsUnprintable(U'\u2028'));
  EXPECT_FALSE(IsUnprintable(U'\u0641'));
  EXPECT_FALSE(IsUnprintable(U' '));
  EXPECT_FALSE(IsUnprintable(U'\u00f6'));
}

}  // namespace
}  // namespace text
