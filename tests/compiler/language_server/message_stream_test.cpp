#include "compiler/language_server/message_stream.h"

#include <gtest/gtest.h>

#include <sstream>

namespace compiler {
namespace {

TEST(MessageStream, ReadsMessageAfterMessage) {
  std::istringstream in(
      "Content-Length: 2\r\n\r\n{}Content-Type: x\r\ncontent-length:3\r\n\r\n[1]");
  EXPECT_EQ(ReadMessage(in), "{}");
  EXPECT_EQ(ReadMessage(in), "[1]");
  EXPECT_EQ(ReadMessage(in), std::nullopt);
}

TEST(MessageStream, ReadsOnBehindAHeaderWithoutLength) {
  std::istringstream in("Nonsense\r\n\r\nContent-Length: 1\r\n\r\n1");
  EXPECT_EQ(ReadMessage(in), "");
  EXPECT_EQ(ReadMessage(in), "1");
}

TEST(MessageStream, EndsInTheMiddleOfAMessage) {
  std::istringstream in("Content-Length: 20\r\n\r\n{}");
  EXPECT_EQ(ReadMessage(in), std::nullopt);
  std::istringstream header("Content-Length: 20");
  EXPECT_EQ(ReadMessage(header), std::nullopt);
}

TEST(MessageStream, DoesNotBelieveEveryLength) {
  std::istringstream in("Content-Length: 99999999999999999999\r\n\r\nContent-Length: -1\r\n\r\n");
  EXPECT_EQ(ReadMessage(in), "");
  EXPECT_EQ(ReadMessage(in), "");
}

TEST(MessageStream, WritesWhatItReads) {
  std::stringstream stream;
  WriteMessage(stream, "{\"ä\":1}");
  EXPECT_EQ(stream.str(), "Content-Length: 8\r\n\r\n{\"ä\":1}");
  EXPECT_EQ(ReadMessage(stream), "{\"ä\":1}");
}

}  // namespace
}  // namespace compiler
