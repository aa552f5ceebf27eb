#include "runtime/trainer/setup/study_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>
#include <limits>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/setup/agent_presets.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

constexpr uint64_t kMostSeeds = 10'000;

class StudyReader {
 public:
  explicit StudyReader(const std::filesystem::path& file) : file_(file) {}

  StudyPlan Read(const toml::table& root) const {
    Experiment common;
    StudyPlan study;
    for (const auto& [key, node] : root) {
      if (key == "slurm") {
        study.slurm = ReadSlurm(node);
      } else if (key != "experiments") {
        ReadKey(key, node, common);
      }
    }
    const toml::node* list = root.get("experiments");
    if (list == nullptr || !list->is_array_of_tables()) {
      throw UserError(fmt::format("{}: a study needs [[experiments]]", file_.string()));
    }
    for (const toml::node& node : *list->as_array()) {
      study.experiments.push_back(ReadExperiment(*node.as_table(), common));
    }
    return study;
  }

  [[noreturn]] void Fail(const toml::source_region& source, const std::string& message) const {
    throw UserError(fmt::format("{}: {}", PlaceOf(source), message));
  }

 private:
  Experiment ReadExperiment(const toml::table& table, const Experiment& common) const {
    Experiment experiment = common;
    experiment.place = PlaceOf(table.source());
    for (const auto& [key, node] : table) ReadKey(key, node, experiment);
    if (experiment.task.task.empty()) Fail(table.source(), "an experiment needs a `task`");
    if (experiment.seeds.empty()) Fail(table.source(), "an experiment needs `seeds`");
    return experiment;
  }

  SlurmSettings ReadSlurm(const toml::node& node) const {
    if (!node.is_table()) Fail(node.source(), "`slurm` is a table: [slurm]");
    SlurmSettings slurm;
    for (const auto& [key, value] : *node.as_table()) {
      if (key == "partition") {
        slurm.partition = Text(value);
      } else if (key == "account") {
        slurm.account = Text(value);
      } else if (key == "time") {
        slurm.time = Text(value);
      } else if (key == "memory") {
        slurm.memory = Text(value);
      } else if (key == "cpus") {
        slurm.cpus = Whole(value, 1);
      } else if (key == "at_once") {
        slurm.at_once = Whole(value, 0);
      } else if (key == "modules") {
        slurm.modules = Texts(value);
      } else if (key == "options") {
        slurm.options = Texts(value);
      } else {
        const std::vector<std::string> keys = {"partition", "account", "time",    "memory",
                                               "cpus",      "at_once", "modules", "options"};
        Fail(key.source(),
             fmt::format("[slurm] has no `{}`{}", key.str(), Suggestion(key.str(), keys)));
      }
    }
    return slurm;
  }

  void ReadKey(const toml::key& key, const toml::node& node, Experiment& experiment) const {
    if (key == "task") {
      experiment.task.task = file_.parent_path() / Text(node);
    } else if (key == "agent") {
      const std::string agent = Text(node);
      experiment.task.agent = IsAgentFile(agent) ? (file_.parent_path() / agent).string() : agent;
    } else if (key == "profile") {
      experiment.task.profile = Text(node);
    } else if (key == "robot") {
      experiment.task.robot = Text(node);
    } else if (key == "robots") {
      experiment.task.robots = file_.parent_path() / Text(node);
    } else if (key == "name") {
      experiment.name = Name(node);
    } else if (key == "settings") {
      experiment.task.settings = Texts(node);
    } else if (key == "seeds") {
      experiment.seeds = Seeds(node);
    } else if (key == "episodes") {
      experiment.plan.episodes = Whole(node, 1);
    } else if (key == "record_every") {
      experiment.plan.record_every = Whole(node, 0);
    } else {
      const std::vector<std::string> keys = {"task",     "agent",       "profile", "robot",
                                             "robots",   "name",        "seeds",   "settings",
                                             "episodes", "record_every"};
      Fail(key.source(),
           fmt::format("an experiment has no `{}`{}", key.str(), Suggestion(key.str(), keys)));
    }
  }

  std::string Text(const toml::node& node) const {
    if (const auto* text = node.as_string()) return text->get();
    Fail(node.source(), "expected a string in quotes");
  }

  std::string Name(const toml::node& node) const {
    std::string name = Text(node);
    const bool is_plain = !name.empty() && name.find('/') == std::string::npos && name[0] != '.';
    return is_plain ? name : (Fail(node.source(), "this cannot name a folder"), "");
  }

  std::vector<std::string> Texts(const toml::node& node) const {
    const toml::array* list = node.as_array();
    if (list == nullptr) Fail(node.source(), "expected a list of strings");
    std::vector<std::string> texts;
    for (const toml::node& item : *list) texts.push_back(Text(item));
    return texts;
  }

  int64_t Whole(const toml::node& node, int64_t minimum) const {
    const auto* number = node.as_integer();
    if (number != nullptr && number->get() >= minimum) return number->get();
    Fail(node.source(), fmt::format("expected an integer, at least {}", minimum));
  }

  std::vector<uint64_t> Seeds(const toml::node& node) const {
    if (node.is_string()) return SeedRange(node);
    const toml::array* list = node.as_array();
    if (list == nullptr) Fail(node.source(), "`seeds` are a list or a range: [1, 2] or \"1..10\"");
    std::vector<uint64_t> seeds;
    for (const toml::node& item : *list) seeds.push_back(static_cast<uint64_t>(Whole(item, 0)));
    return seeds;
  }

  // "1..10", both ends included.
  std::vector<uint64_t> SeedRange(const toml::node& node) const {
    const std::string text = Text(node);
    const size_t dots = text.find("..");
    uint64_t first = 0;
    uint64_t last = 0;
    const bool is_range = dots != std::string::npos && Parse(text.substr(0, dots), first) &&
                          Parse(text.substr(dots + 2), last);
    if (!is_range || last < first || last - first >= kMostSeeds) {
      Fail(node.source(), "this is not a range of seeds: write \"1..10\"");
    }
    std::vector<uint64_t> seeds;
    for (uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
    return seeds;
  }

  static bool Parse(const std::string& text, uint64_t& number) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    return !text.empty() && result.ec == std::errc() && result.ptr == text.data() + text.size();
  }

  std::string PlaceOf(const toml::source_region& source) const {
    return fmt::format("{}:{}:{}", file_.string(), source.begin.line, source.begin.column);
  }

  std::filesystem::path file_;
};

}  // namespace

StudyPlan ReadStudy(const std::filesystem::path& file) {
  const StudyReader reader(file);
  try {
    return reader.Read(toml::parse(ReadText(file)));
  } catch (const toml::parse_error& error) {
    reader.Fail(error.source(), std::string(error.description()));
  }
}

}  // namespace runtime
