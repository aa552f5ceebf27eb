// What the trainer itself has written, and somebody has damaged.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>

#include "base/seal/seal.h"
#include "fuzz/edits.h"
#include "fuzz/read_or_refuse.h"
#include "fuzz/runtime_targets.h"
#include "fuzz/targets.h"
#include "plugins/host/elf_file.h"
#include "runtime/analysis/report/report.h"
#include "runtime/training/learning/peng_q_lambda.h"
#include "runtime/training/run/change_json.h"
#include "runtime/training/run/checkpoint.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/sealed_state.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace fuzz {
namespace {

std::string Content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// A run with some episodes, in a folder of its own.
struct SampleFolder {
  runtime::TemporaryFolder folder;
  std::filesystem::path file = runtime::RunDatabaseFile(folder.path() / "run");
  std::string intact;

  SampleFolder() {
    {
      runtime::RunDatabase database =
          runtime::RunDatabase::Create(file.parent_path(), runtime::SampleRun());
      for (int64_t number = 1; number <= 3; ++number) {
        database.AddEpisode(runtime::SampleEpisode(number), std::nullopt,
                            runtime::Checkpoint{number, std::string(100, 'x')});
      }
      database.SetState(runtime::RunState::kFinished);
    }
    intact = Content(file);
  }
};

class Learner {
 public:
  Learner() : learner_(static_cast<runtime::PengQLambda&>(Add())) {}
  runtime::ModuleGraph& graph() { return graph_; }

 private:
  runtime::Module& Add() {
    return graph_.Add(std::make_unique<runtime::PengQLambda>("learner", runtime::Context{}));
  }
  runtime::ModuleGraph graph_;
  runtime::PengQLambda& learner_;
};

}  // namespace

bool Plugin(const std::string& edits) {
  static const std::string intact = Content("/proc/self/exe").substr(0, 1 << 17);
  const std::string bytes = Damaged(intact, edits);
  const auto content = std::as_bytes(std::span(bytes));
  host::ElfDefect(content);
  host::ElfCompiler(content);
  Require(seal::StateOf(bytes) != seal::State::kIntact, "a seal where there is none");
  const std::string sealed = Damaged(seal::Seal(intact.substr(0, 1000)), edits);
  static const std::string whole = seal::Seal(intact.substr(0, 1000));
  Require((seal::StateOf(sealed) == seal::State::kIntact) == (sealed == whole),
          "a damaged file has its seal");
  return true;
}

bool Run(const std::string& edits) {
  static const SampleFolder sample;
  const std::filesystem::path folder = sample.file.parent_path();
  for (const char* suffix : {"-wal", "-shm", "-journal"}) {
    std::filesystem::remove(sample.file.string() + suffix);
  }
  std::ofstream(sample.file, std::ios::binary | std::ios::trunc) << Damaged(sample.intact, edits);
  ReadOrRefuse([&] {
    const runtime::RunDatabase database = runtime::RunDatabase::OpenToRead(folder);
    ReadOrRefuse([&] { database.ReadRun(); });
    ReadOrRefuse([&] { database.ReadState(); });
    ReadOrRefuse([&] { database.ReadEpisodes(); });
    ReadOrRefuse([&] { database.ReadLearnerCurves(); });
    ReadOrRefuse([&] { database.ReadChanges(); });
    ReadOrRefuse([&] { database.ReadCheckpoint(); });
    ReadOrRefuse([&] { database.ReadRecordedEpisodes(); });
  });
  return ReadOrRefuse([&] { runtime::RecordText(folder); });
}

bool Checkpoint(const std::string& edits) {
  static Learner learner;
  static const std::string state = runtime::SaveModules(learner.graph());
  const std::string damaged = Damaged(state, edits);
  const bool is_read = ReadOrRefuse([&] { runtime::LoadModules(learner.graph(), damaged); });
  const std::string sealed = runtime::SealState(7, state);
  const std::string broken = Damaged(sealed, edits);
  const std::optional<std::string> unsealed = runtime::UnsealState(7, broken);
  // One without a hash is of an old version; it is taken.
  Require(!unsealed || *unsealed == state || *unsealed == broken, "a damaged state has its hash");
  return is_read;
}

bool Change(const std::string& text) {
  const size_t line_end = std::min(text.find('\n'), text.size());
  const std::string kind = text.substr(0, line_end);
  const std::string data = text.substr(std::min(text.size(), line_end + 1));
  return ReadOrRefuse([&] {
    const runtime::Change change = runtime::ReadChange(kind, data, 2);
    const std::string written = runtime::ChangeData(change);
    const runtime::Change again =
        runtime::ReadChange(std::string(runtime::KindOf(change)), written, 2);
    Require(runtime::ChangeData(again) == written, "a change that was written is read otherwise");
  });
}

}  // namespace fuzz
