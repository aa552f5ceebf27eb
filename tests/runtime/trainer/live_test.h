// A trainer at work, and a client that changes what it does.
#pragma once

#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/training/run/sqlite.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {

using nlohmann::json;

class LiveTest : public TrainerTest {
 protected:
  // A run in the folder `run` that stands still before the first step of an episode.
  void Serve(int episodes, std::vector<std::string> more = {},
             const std::string& task = TaskFile("leaning")) {
    std::vector<std::string> words = {TRAINER,
                                      "serve",
                                      task,
                                      "--profile",
                                      "fast",
                                      "--episodes",
                                      std::to_string(episodes),
                                      "--out",
                                      RunFolder("run"),
                                      "--json"};
    words.insert(words.end(), more.begin(), more.end());
    trainer_.emplace(words);
    ASSERT_TRUE(trainer_->WaitForLines(1));
    Ask({"pause"});
    Ask({"step", "1", "--episodes"});
    WaitForState("paused");
  }

  ProgramResult Ctl(std::vector<std::string> words) const {
    words.insert(words.begin(), {"ctl", "--run", RunFolder("run"), "--json"});
    return Trainer(std::move(words));
  }
  json Ask(std::vector<std::string> words) const {
    const ProgramResult result = Ctl(std::move(words));
    EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
    const json reply = json::parse(result.output, nullptr, false);
    return reply.is_object() ? reply.value("value", json::object()) : json::object();
  }
  std::string Refusal(std::vector<std::string> words) const {
    const ProgramResult result = Ctl(std::move(words));
    EXPECT_EQ(result.exit_status, 1);
    return json::parse(result.output).value("error", "") + result.errors;
  }

  void WaitForState(const std::string& state) const {
    for (int tries = 0; tries < 3000; ++tries) {
      // It may not answer while it is started again.
      const json reply = json::parse(Ctl({"status"}).output, nullptr, false);
      if (reply.is_object() && reply["value"]["state"] == state) return;
      usleep(10'000);
    }
    FAIL() << "the trainer never was " << state;
  }
  // Goes on, and stands still before the first step of the `count`-th episode from here.
  void RunEpisodes(int count) const {
    Ask({"step", std::to_string(count), "--episodes"});
    WaitForState("paused");
  }
  void RunSteps(int count) const {
    Ask({"step", std::to_string(count)});
    WaitForState("paused");
  }
  ProgramResult Stop() {
    Ask({"stop"});
    return trainer_->Wait();
  }

  // A trainer that was killed is gone when its guard, and so the program, has ended.
  void Kill() {
    trainer_->Send(SIGKILL);
    trainer_->Wait();
  }
  // Goes on with the run from its checkpoint, and waits for what comes before the next episode.
  void ServeAgain() {
    {
      RunDatabase database = RunDatabase::Open(RunFolder("run"));
      database.SetEpisodesPlanned(database.ReadCheckpoint()->episode);
    }
    trainer_.emplace(std::vector<std::string>{TRAINER, "serve", RunFolder("run"), "--json"});
    WaitForState("finished");
  }
  // From what the trainer waits for in such a case.
  void RunOneMoreEpisode() const {
    const int64_t done = Ask({"status"})["episodes_done"];
    Ask({"resume", "--episodes", std::to_string(done + 1)});
    WaitForState("finished");
  }
  // Trains the run, which nobody works on, until it has so many episodes, and once more from
  // nothing but its record.
  void ExpectTheSameFromTheRecord(int episodes) const {
    std::filesystem::create_directory(RunFolder("again"));
    for (const auto& entry : std::filesystem::directory_iterator(RunFolder("run"))) {
      if (entry.is_regular_file()) std::filesystem::copy(entry.path(), RunFolder("again"));
    }
    {  // as if it had been killed before its first checkpoint
      SqliteDatabase database(folder() / "again" / "run.db", SqliteAccess::kWrite);
      database.Execute("DELETE FROM checkpoint", "forget the checkpoint");
    }
    std::vector<std::string> states;
    for (const char* name : {"run", "again"}) {
      const ProgramResult result =
          Trainer({"resume", RunFolder(name), "--episodes", std::to_string(episodes), "--quiet"});
      EXPECT_EQ(result.exit_status, 0) << result.errors;
      EXPECT_EQ(result.errors, "");
      states.push_back(RunDatabase::OpenToRead(RunFolder(name)).ReadCheckpoint()->state);
    }
    ExpectEqual(TraceOf("run"), TraceOf("again"));
    EXPECT_TRUE(states[0] == states[1]) << "checkpoints differ";
  }

  std::vector<EpisodeRecord> Episodes() const {
    return RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes();
  }
  std::vector<std::string> Changes() const {
    std::vector<std::string> texts;
    for (const ChangeRecord& change : RunDatabase::OpenToRead(RunFolder("run")).ReadChanges()) {
      texts.push_back(std::to_string(change.episode) + ":" + std::to_string(change.step) + " " +
                      std::string(KindOf(change.change)));
    }
    return texts;
  }
  json TaskNamed(const std::string& module) const {
    const json list = Ask({"list"});
    for (const json& task : list.at("tasks")) {
      if (task["module"] == module) return task;
    }
    return {};
  }
  static std::string Plugin(const std::string& name) {
    return std::string(PLUGIN_FOLDER) + "/" + name + ".so";
  }

  std::optional<ChildProcess> trainer_;
};

}  // namespace runtime
