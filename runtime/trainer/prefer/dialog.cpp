#include "runtime/trainer/prefer/dialog.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <set>
#include <string>

#include "base/text/print.h"
#include "runtime/analysis/study/compared_behavior.h"
#include "runtime/analysis/study/informative_pair.h"
#include "runtime/trainer/prefer/text.h"

namespace runtime {
namespace {

enum class Answer { kFirst, kSecond, kEqual, kSkip, kQuit };

class Dialog {
 public:
  Dialog(const StudyResults& study, const ExperimentResult& experiment, const TaskParams& params,
         const std::filesystem::path& folder)
      : study_(study), experiment_(experiment), params_(params), folder_(folder) {}

  bool Run() {
    std::set<GroupPair> skipped;
    while (const std::optional<GroupPair> pair = MostInformativePair(Fit(), skipped)) {
      Show(*pair);
      const Answer answer = Ask();
      if (answer == Answer::kQuit) return false;
      if (answer == Answer::kSkip) {
        skipped.insert(*pair);
      } else {
        AddPreferences(folder_, {PreferenceOf(*pair, answer)});
      }
    }
    return true;
  }

 private:
  PreferenceFit Fit() const {
    const std::vector<std::vector<Preference>> preferences =
        PreferencesByExperiment(study_.experiments, ReadPreferences(folder_), folder_);
    const auto index = static_cast<size_t>(&experiment_ - study_.experiments.data());
    return FitPreferences(experiment_, params_, preferences[index]);
  }

  BehaviorName NameOf(size_t group) const {
    return {experiment_.runs[experiment_.groups[group].typical].run->name, std::nullopt};
  }

  void Show(const GroupPair& pair) const {
    const std::filesystem::path page = folder_ / "report.html";
    text::Print("\n{}: which is better? {}\n", experiment_.experiment->name,
                std::filesystem::exists(page)
                    ? fmt::format("Watch both in {}.", page.string())
                    : fmt::format("`trainer report {}` makes a page on which both can be watched.",
                                  folder_.string()));
    ShowGroup('a', pair.first);
    ShowGroup('b', pair.second);
  }

  // Without its return: the user is to judge what the robot does.
  void ShowGroup(char letter, size_t index) const {
    const BehaviorGroup& group = experiment_.groups[index];
    const size_t count = group.runs.size();
    text::Print("  {}  group {}, as {}; {} run{}\n", letter, GroupName(index),
                ShortName(NameOf(index), experiment_), count, count == 1 ? "" : "s");
    for (const size_t run : group.runs) {
      const auto sentence = study_.sentences.find(experiment_.runs[run].run->name);
      if (sentence != study_.sentences.end()) text::Print("       {}\n", sentence->second);
    }
    for (const CurveRecord& metric : experiment_.experiment->task().metrics) {
      const auto value = experiment_.runs[group.typical].final.metrics.find(metric.name);
      if (value == experiment_.runs[group.typical].final.metrics.end()) continue;
      text::Print("       {} {} {}\n", metric.name, NumberText(value->second), metric.unit);
    }
  }

  // The end of the input is the end of the questions.
  static Answer Ask() {
    while (true) {
      text::Print("a, b, = (equally good), s (skip) or q (quit)? ");
      std::fflush(stdout);
      std::string word;
      if (!std::getline(std::cin, word) || word == "q") return Answer::kQuit;
      if (word == "a") return Answer::kFirst;
      if (word == "b") return Answer::kSecond;
      if (word == "=") return Answer::kEqual;
      if (word == "s") return Answer::kSkip;
    }
  }

  Preference PreferenceOf(const GroupPair& pair, Answer answer) const {
    const BehaviorName first = NameOf(pair.first);
    const BehaviorName second = NameOf(pair.second);
    if (answer == Answer::kSecond) return {second, first};
    return {first, second, answer == Answer::kEqual};
  }

  const StudyResults& study_;
  const ExperimentResult& experiment_;
  const TaskParams& params_;
  const std::filesystem::path& folder_;
};

}  // namespace

bool AskPreferences(const StudyResults& study, const ExperimentResult& experiment,
                    const TaskParams& params, const std::filesystem::path& folder) {
  return Dialog(study, experiment, params, folder).Run();
}

}  // namespace runtime
