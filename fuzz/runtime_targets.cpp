#include "fuzz/runtime_targets.h"

#include <unistd.h>

#include <fstream>
#include <optional>

#include "fuzz/corpus.h"
#include "fuzz/read_or_refuse.h"
#include "fuzz/targets.h"
#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"
#include "runtime/core/agent/agent.h"
#include "runtime/trainer/setup/study_file.h"
#include "runtime/training/environment/environment_link.h"
#include "runtime/training/signal/signal_file.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace fuzz {
namespace {

using Texts = std::vector<std::string>;

// `text` as a file of this name.
std::filesystem::path FileOf(const std::string& text, const char* name) {
  static const runtime::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
  return file;
}

Texts RobotTexts() { return TextsIn({"/plugins", "/tests/plugins/robots"}, "robot.toml"); }
Texts AgentTexts() { return TextsIn({"/plugins", "/tests/runtime"}, "agent.toml"); }
Texts StudyTexts() { return TextsIn({"/examples"}, ".toml"); }
Texts WorldTexts() { return TextsIn({"/examples/tasks", "/tests/plugins/world"}, ".toml"); }
Texts GreetingTexts() {
  return {R"({"taskc_environment":1,"time_step":0.01,"action":{"low":[-1],"high":[1]},)"
          R"("sensors":[{"name":"x","type":"real","unit":"m"}]})",
          R"({"taskc_environment":1,"time_step":0.5,"action":{"low":[],"high":[]},)"
          R"("sensors":[],"formats":["binary"]})"};
}

// All words of some texts, and what TOML, JSON and CSV are made of.
Texts WordsOf(const Texts& texts) {
  Texts words = {"[",
                 "]",
                 "[[",
                 "]]",
                 "{",
                 "}",
                 "=",
                 ",",
                 "\"",
                 "'",
                 "\"\"\"",
                 "#",
                 "\n",
                 "\r\n",
                 ".",
                 "-",
                 "true",
                 "inf",
                 "nan",
                 "1e308",
                 "1e-400",
                 "0",
                 "-1",
                 "1979-05-27",
                 "\\u",
                 "\\uD800",
                 "\xff",
                 ":",
                 "null",
                 "[]",
                 "18446744073709551616",
                 std::string(1, '\0')};
  for (const std::string& text : texts) {
    std::string word;
    for (const char character : text) {
      if (std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_') {
        word += character;
      } else if (!word.empty()) {
        words.push_back(std::exchange(word, {}));
      }
    }
  }
  return words;
}

template <Texts (*texts)()>
Texts WordsIn() {
  return WordsOf(texts());
}

Texts SignalTexts() { return {"time [s], wish [m/s]\n0, 0.2\n2.5, 0.5\n", "0 1 2\n1 2 3\n"}; }
Texts EditTexts() { return {std::string(4, '\0'), "abcd", "abcdefghijklmnop"}; }
Texts EditWords() {
  return {std::string(4, '\0'), "\xff\xff\xff\xff", std::string("\0\0\0\x7f", 4), "abcd"};
}
Texts ChangeTexts() {
  return {R"(swap
{"command":"swap","forget":true,"name":"task","task":2})",
          R"(set
{"command":"set","name":"a.b","value":[1.0,-0.5]})",
          R"(schedule
{"command":"set","episodes":10,"from":2,"name":"a.b","to":0.5})",
          R"(module_add
{"command":"module_add","name":"net","parameters":{"file":"x","width":3},"type":"NgNet"})",
          R"(quarantine
{"change":7,"command":"quarantine","why":"loop"})"};
}
Texts RequestTexts() {
  return {"GET\n/api/get?name=task.weight\n",
          "GET\n/api/status\n",
          "GET\n/report\n",
          "POST\n/api/set\n{\"name\":\"task.limit\",\"value\":\"0.5 s\"}",
          "POST\n/api/swap\n{\"name\":\"task\",\"file\":\"a.task\",\"now\":true}",
          "GET\n/api/language?token=0123\n"};
}
Texts RequestWords() {
  Texts words = WordsOf(RequestTexts());
  for (const char* word :
       {"%00", "%", "%zz", "+", "&", "?", "/", "//", "/..", "[[[[[[[[[[[[[[[[[["}) {
    words.emplace_back(word);
  }
  return words;
}
// A text, a ping, a close and the half of a message, masked with zeros.
Texts FrameTexts() {
  return {std::string("\x81\x82\0\0\0\0{}", 8), std::string("\x89\x80\0\0\0\0", 6),
          std::string("\x88\x82\0\0\0\0\x03\xe8", 8), std::string("\x01\x81\0\0\0\0a", 7)};
}
Texts FrameWords() {
  return {std::string("\x81\xfe\xff\xff", 4),
          std::string("\x81\xff\0\0\0\0\xff\xff\xff\xff", 10),
          std::string("\0\x80\0\0\0\0", 6),
          std::string("\x80\x80\0\0\0\0", 6),
          std::string(126, 'a'),
          "\xff"};
}

}  // namespace

bool Robot(const std::string& text) {
  return ReadOrRefuse([&] { robot::ReadRobot(FileOf(text, "robot.toml")); });
}

bool Agent(const std::string& text) {
  return ReadOrRefuse([&] {
    const runtime::Agent agent = runtime::ParseAgent(text, "agent.toml");
    const std::string written = runtime::ToToml(agent);
    Require(runtime::ToToml(runtime::ParseAgent(written, "again")) == written,
            "an agent that was written is read otherwise");
  });
}

bool Study(const std::string& text) {
  return ReadOrRefuse([&] { runtime::ReadStudy(FileOf(text, "study.toml")); });
}

bool World(const std::string& text) {
  const auto read = [&](const std::filesystem::path&) { return std::optional(text); };
  return ReadOrRefuse([&] { world::ReadWorld(text, "world.toml", read); });
}

bool Signal(const std::string& text) {
  return ReadOrRefuse([&] {
    const runtime::SignalFile signal = runtime::ReadSignalFile(FileOf(text, "signal.csv"));
    Require(signal.samples.size() % (signal.elements + 1) == 0, "half a row");
    runtime::CheckSamples(signal.samples, signal.elements, "what was read");
  });
}

// Whether time passes and actions have limits is up to the environment (SetSteps).
bool Greeting(const std::string& text) {
  return ReadOrRefuse([&] { runtime::ParseGreeting(text); });
}

const std::vector<Target>& Targets() {
  static const std::vector<Target> targets = {
      {"robot", Robot, RobotTexts, WordsIn<RobotTexts>},
      {"agent", Agent, AgentTexts, WordsIn<AgentTexts>},
      {"study", Study, StudyTexts, WordsIn<StudyTexts>},
      {"world", World, WorldTexts, WordsIn<WorldTexts>},
      {"signal", Signal, SignalTexts, TableWords},
      {"greeting", Greeting, GreetingTexts, WordsIn<GreetingTexts>},
      {"plugin", Plugin, EditTexts, EditWords},
      {"run", Run, EditTexts, EditWords},
      {"checkpoint", Checkpoint, EditTexts, EditWords},
      {"change", Change, ChangeTexts, WordsIn<ChangeTexts>},
      {"request", Request, RequestTexts, RequestWords},
      {"frames", Frames, FrameTexts, FrameWords},
  };
  return targets;
}

}  // namespace fuzz
