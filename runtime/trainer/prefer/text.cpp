#include "runtime/trainer/prefer/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "runtime/analysis/preference/weight_value.h"

namespace runtime {
namespace {

using Row = std::vector<std::string>;

// Columns as wide as they must be, the first to the left, the others to the right.
std::string Table(const std::vector<Row>& rows) {
  std::vector<size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("  {:<{}}", row[0], widths[0]);
    for (size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>{}}", row[i], widths[i]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string PercentText(double probability) { return fmt::format("{:.0f} %", 100 * probability); }

std::string RangeText(const TaskParam& param) {
  if (std::isinf(param.least) && std::isinf(param.greatest)) return "any";
  return fmt::format("{} .. {}", param.least, param.greatest);
}

std::string NameWithUnit(const TaskParam& param) {
  return param.unit.empty() ? param.name : fmt::format("{} [{}]", param.name, param.unit);
}

std::string WeightTable(const PreferenceFit& fit) {
  std::vector<Row> rows = {{"weight", "now", "new", "likely", "range"}};
  for (const WeightChange& weight : fit.weights) {
    rows.push_back({NameWithUnit(weight.param), fmt::format("{}", weight.value.before),
                    fmt::format("{}", weight.value.after),
                    fmt::format("{:.2g} .. {:.2g}", weight.low, weight.high),
                    RangeText(weight.param)});
  }
  std::string text = Table(rows);
  for (const KeptParam& param : fit.kept) {
    if (!param.param.scales.empty()) {
      text += fmt::format("  {} stays: {}.\n", param.param.name, param.why);
    }
  }
  return text;
}

std::string PreferenceTable(const PreferenceFit& fit) {
  const auto judgment = [](double probability, bool holds) {
    return fmt::format("{} {}", PercentText(probability), holds ? "yes" : " no");
  };
  std::vector<Row> rows = {{"preference", "now", "new"}};
  for (const PreferenceResult& each : fit.preferences) {
    const Preference& preference = each.preference;
    rows.push_back({fmt::format("{} {} {}", ShortName(preference.better, *fit.result),
                                preference.is_tie ? "as good as" : "over",
                                ShortName(preference.worse, *fit.result)),
                    judgment(each.probability.before, each.holds.before),
                    judgment(each.probability.after, each.holds.after)});
  }
  return Table(rows);
}

std::string TermTable(const PreferenceFit& fit) {
  std::vector<Row> rows = {{"term", "paid now", "paid new"}};
  for (size_t i = 0; i < fit.rescored.terms.size(); ++i) {
    const BeforeAfter<double>& paid = fit.rescored.terms[i];
    rows.push_back({fit.result->experiment->task().terms[i].name, NumberText(paid.before),
                    NumberText(paid.after)});
  }
  return Table(rows);
}

// The groups' places, the best first, by what `value` takes of their returns.
template <class Value>
std::vector<std::string> Places(const std::vector<BeforeAfter<double>>& groups, Value value) {
  std::vector<std::string> places;
  for (const BeforeAfter<double>& group : groups) {
    const auto better = std::ranges::count_if(
        groups, [&](const BeforeAfter<double>& other) { return value(other) > value(group); });
    places.push_back(fmt::format("{}.", better + 1));
  }
  return places;
}

std::string GroupTable(const PreferenceFit& fit) {
  const std::vector<BeforeAfter<double>>& groups = fit.rescored.groups;
  const auto now = Places(groups, [](const auto& each) { return each.before; });
  const auto then = Places(groups, [](const auto& each) { return each.after; });
  std::vector<Row> rows = {{"group", "runs", "return now", "", "return new", ""}};
  for (size_t i = 0; i < groups.size(); ++i) {
    const BehaviorGroup& group = fit.result->groups[i];
    const BehaviorName typical{fit.result->runs[group.typical].run->name, std::nullopt};
    rows.push_back({fmt::format("{}, as {}", GroupName(i), ShortName(typical, *fit.result)),
                    fmt::format("{}", group.runs.size()), NumberText(groups[i].before), now[i],
                    NumberText(groups[i].after), then[i]});
  }
  return Table(rows);
}

std::string RunTable(const PreferenceFit& fit) {
  std::vector<Row> rows = {{"run", "at the end", "new", "all episodes", "new"}};
  for (size_t i = 0; i < fit.rescored.runs.size(); ++i) {
    const RunReturns& run = fit.rescored.runs[i];
    if (std::isnan(run.all.before)) continue;
    rows.push_back({ShortName({fit.result->runs[i].run->name, std::nullopt}, *fit.result),
                    NumberText(run.final.before), NumberText(run.final.after),
                    NumberText(run.all.before), NumberText(run.all.after)});
  }
  return Table(rows);
}

// The preferences of which `condition` is true, for a sentence.
template <class Condition>
std::vector<std::string> Texts(const PreferenceFit& fit, Condition condition) {
  std::vector<std::string> texts;
  for (const PreferenceResult& each : fit.preferences) {
    if (!condition(each)) continue;
    const Preference& preference = each.preference;
    texts.push_back(fmt::format("{}:{}: {}", kPreferencesFile, preference.line, preference.text()));
  }
  return texts;
}

std::string Advice(const PreferenceFit& fit) {
  const auto contradicted = Texts(fit, [](const auto& each) { return each.is_contradicted; });
  if (!contradicted.empty()) {
    return fmt::format(
        "These preferences contradict each other; delete what is no longer true:\n  {}\n",
        fmt::join(contradicted, "\n  "));
  }
  const auto inexplicable = Texts(fit, [](const auto& each) { return !each.can_hold; });
  if (!inexplicable.empty()) {
    return fmt::format(
        "No weights within their ranges explain all preferences: a term is missing, or a "
        "range "
        "is too\nnarrow. At best, these do not hold:\n  {}\n",
        fmt::join(inexplicable, "\n  "));
  }
  if (std::ranges::any_of(fit.preferences, [](const auto& each) { return !each.holds.after; })) {
    return fmt::format(
        "There are weights under which all preferences hold, but farther from the current ones "
        "than so\nfew preferences justify: state more, or let weights change more (--factor "
        "{:.3g}).\n",
        std::round(2 * std::exp(fit.model.prior_sd)));
  }
  return "";
}

}  // namespace

std::string NumberText(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value);
}

std::string ShortName(const BehaviorName& behavior, const ExperimentResult& result) {
  const std::string prefix = result.experiment->name + "/";
  const std::string name = behavior.text();
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

std::string PreferenceText(const PreferenceFit& fit) {
  const auto count = [&](auto holds) { return std::ranges::count_if(fit.preferences, holds); };
  const auto now = count([](const PreferenceResult& each) { return each.holds.before; });
  const auto then = count([](const PreferenceResult& each) { return each.holds.after; });
  std::string text =
      fmt::format("{}: of {} preference{}, {} hold{} now, {} under the new weights\n\n",
                  fit.result->experiment->name, fit.preferences.size(),
                  fit.preferences.size() == 1 ? "" : "s", now, now == 1 ? "s" : "", then);
  std::vector<std::string> parts = {WeightTable(fit), PreferenceTable(fit), TermTable(fit)};
  if (!fit.rescored.groups.empty()) parts.push_back(GroupTable(fit));
  parts.push_back(RunTable(fit));
  const std::string advice = Advice(fit);
  if (!advice.empty()) parts.push_back(advice);
  if (!fit.notes.empty()) parts.push_back(fmt::format("{}\n", fmt::join(fit.notes, "\n")));
  return text + fmt::format("{}", fmt::join(parts, "\n"));
}

}  // namespace runtime
