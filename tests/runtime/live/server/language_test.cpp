// The language server of a client.
#include <signal.h>
#include <unistd.h>

#include <fstream>

#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;

class LanguageTest : public ServerTest {
 protected:
  void StartWith(std::vector<std::string> program) {
    Start(ServerOptions{.folder = folder(), .language_server = std::move(program)});
  }
};

// `cat` answers each message with itself.
TEST_F(LanguageTest, MessagesGoBothWaysWithoutTheirHeaders) {
  StartWith({"/bin/cat"});
  RawClient client = OnWebSocket("/api/language");
  client.SendText("one");
  client.SendText("another, and longer");
  EXPECT_EQ(client.ReceiveMessage(), "one");
  EXPECT_EQ(client.ReceiveMessage(), "another, and longer");
}

TEST_F(LanguageTest, EndsWithItsConnection) {
  const std::filesystem::path script = folder() / "program";
  std::ofstream(script) << "#!/bin/sh\necho $$ > " << (folder() / "pid").string() << "\nexec cat\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  StartWith({script.string()});
  {
    RawClient client = OnWebSocket("/api/language");
    client.SendText("there");
    EXPECT_EQ(client.ReceiveMessage(), "there");
  }
  int process = 0;
  std::ifstream(folder() / "pid") >> process;
  ASSERT_GT(process, 0);
  for (int tries = 0; tries < 5000 && kill(process, 0) == 0; ++tries) usleep(1000);
  EXPECT_NE(kill(process, 0), 0);
}

TEST_F(LanguageTest, AProgramThatEndsEndsTheConnection) {
  StartWith({"/bin/true"});
  RawClient client = OnWebSocket("/api/language");
  EXPECT_TRUE(client.IsClosed());
}

TEST_F(LanguageTest, AtMostEightRun) {
  StartWith({"/bin/cat"});
  std::vector<RawClient> clients;
  for (int i = 0; i < 8; ++i) clients.push_back(OnWebSocket("/api/language"));
  const RawResponse refused = ResponseTo("GET", "/api/language?token=" + token_, Host() + kUpgrade);
  EXPECT_EQ(refused.status, 503);
  EXPECT_THAT(ErrorIn(refused), HasSubstr("8 language servers are running"));
}

TEST_F(LanguageTest, SaysWhatIsMissing) {
  StartWith({"/nowhere/taskc"});
  const RawResponse refused = ResponseTo("GET", "/api/language?token=" + token_, Host() + kUpgrade);
  EXPECT_EQ(refused.status, 500);
  EXPECT_THAT(ErrorIn(refused), HasSubstr("/nowhere/taskc: cannot be started"));
}

}  // namespace
}  // namespace runtime
