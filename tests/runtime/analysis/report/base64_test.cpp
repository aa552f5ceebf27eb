#include "runtime/analysis/report/base64.h"

#include <gmock/gmock.h>

#include <string_view>

namespace runtime {
namespace {

std::string Encode(std::string_view text) { return EncodeBase64(std::as_bytes(std::span(text))); }

TEST(Base64, AgreesWithRfc4648) {
  EXPECT_EQ(Encode(""), "");
  EXPECT_EQ(Encode("f"), "Zg==");
  EXPECT_EQ(Encode("fo"), "Zm8=");
  EXPECT_EQ(Encode("foo"), "Zm9v");
  EXPECT_EQ(Encode("foobar"), "Zm9vYmFy");
}

TEST(Base64, KeepsEveryByte) {
  EXPECT_EQ(Encode(std::string_view("\xff\xfe\x00\x7f", 4)), "//4Afw==");
}

TEST(Base64, FloatsAreLittleEndian) {
  const float values[] = {1.f, -2.5f};  // 3f800000, c0200000
  EXPECT_EQ(EncodeFloats(values), "AACAPwAAIMA=");
}

}  // namespace
}  // namespace runtime
