#include "runtime/analysis/export/tensorboard.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/export/sample_table.h"

namespace runtime {
namespace {

TEST(TensorBoard, TheChecksumIsThatOfTheStandard) {
  EXPECT_EQ(Crc32c("123456789"), 0xE3069283);
  EXPECT_EQ(Crc32c(std::string(32, '\0')), 0x8A9136AA);  // RFC 3720, B.4
}

// web/tests/exports.ts reads a whole file with the decoders of others.
TEST(TensorBoard, AFileBeginsWithItsVersion) {
  const std::string file = TensorBoardEvents(SampleTable());
  // Fields 1 (a double) and 3 (13 bytes of text).
  EXPECT_EQ(file.substr(0, 8), std::string("\x18\0\0\0\0\0\0\0", 8));
  EXPECT_EQ(file.substr(12 + 9, 15),
            "\x1a\x0d"
            "brain.Event:2");
}

TEST(TensorBoard, LeavesOutWhatIsNoNumber) {
  const std::string file = TensorBoardEvents(SampleTable());
  const size_t first = file.find("learner/kl");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(file.find("learner/kl", first + 1), std::string::npos);
}

}  // namespace
}  // namespace runtime
