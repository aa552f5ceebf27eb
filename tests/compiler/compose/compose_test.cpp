#include "compiler/compose/compose.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/check/check.h"
#include "tests/compiler/compose/file_set.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A tree that must come without errors.
SyntaxTree Merged(FileSet files) {
  Composed composed(std::move(files));
  EXPECT_TRUE(composed.tree) << composed.Messages();
  return composed.tree ? std::move(*composed.tree) : SyntaxTree{};
}

// The same, checked. The tasks of these tests have no robot.
CheckedTask Checked(FileSet files) {
  Composed composed(std::move(files));
  std::optional<CheckedTask> task;
  if (composed.tree) task = Check(*composed.tree, nullptr, composed.diagnostics);
  EXPECT_TRUE(task) << composed.Messages();
  return task ? std::move(*task) : CheckedTask{};
}

template <typename Node>
std::vector<const Node*> All(const SyntaxTree& tree) {
  std::vector<const Node*> nodes;
  for (const Declaration& declaration : tree.declarations)
    if (const auto* node = std::get_if<Node>(&declaration.node)) nodes.push_back(node);
  return nodes;
}

TEST(Override, OfAnObservationShowsSomethingElseInItsPlace) {
  const CheckedTask task =
      Checked({{"base.task",
                "task base\nsensor x: real\n/// Where it is.\nobserve x\nobserve half = 0.5 * x\n"
                "on end_of_time_step { reward a = x }\n"},
               {"main.task",
                "task own extends \"base.task\"\noverride observe x = 2 * x\nobserve 3 * x\n"}});
  ASSERT_EQ(task.observations.size(), 3u);
  EXPECT_EQ(task.observations[0].name, "x");
  EXPECT_EQ(task.observations[0].doc, "Where it is.");
  EXPECT_TRUE(std::holds_alternative<CheckedBinary>(task.observations[0].value.node));
  EXPECT_EQ(task.observations[1].name, "half");
  EXPECT_EQ(task.observations[2].name, "3 * x");
  EXPECT_EQ(task.observations[2].offset, 2u);
}

TEST(Override, OfAGoalChangesHowItIsDrawn) {
  const CheckedTask task = Checked(
      {{"base.task",
        "task base\nsensor x: real\ngoal aim: real [m] = uniform(0 m, 1 m) per 2 s\n"
        "on end_of_time_step { reward a = x * aim / 1 m }\n"},
       {"main.task", "task own extends \"base.task\"\noverride goal aim = uniform(0 m, 5 m)\n"}});
  ASSERT_EQ(task.goals.size(), 1u);
  EXPECT_FALSE(task.goals[0].interval);
  const auto& draw = std::get<Draw>(task.goals[0].value.node);
  EXPECT_EQ(std::get<Constant>(draw.arguments[1]->node).value, 5);
}

TEST(Library, IsImportedByNameWhereverTheTaskLies) {
  FileSet files{{"main.task",
                 "task t\nimport \"std/kernels\"\nsensor x: real [m]\n"
                 "metric near = squared_kernel(x, 2 m)\n"},
                // Of that name, but beside the task.
                {"std/kernels.task", "fn squared_kernel(x: real) -> real = x\n"}};
  const FileReader beside = ReaderOf(std::move(files));
  const FileReader read = [&](const std::filesystem::path& file) {
    return file.is_absolute() ? ReadFromDisk(file) : beside(file);
  };
  Sources sources;
  Diagnostics diagnostics;
  const auto tree = Compose("main.task", read, sources, diagnostics);
  ASSERT_TRUE(tree);
  const auto task = Check(*tree, nullptr, diagnostics);
  ASSERT_TRUE(task) << Render(sources, diagnostics, false);
  EXPECT_EQ(task->functions.at(0).arguments.size(), 2u);
  EXPECT_EQ(sources.files().size(), 2u);
  EXPECT_TRUE(sources.files()[1].path().ends_with("share/taskc/library/std/kernels.task"));
  // What a task does not use of a library is no mistake.
  for (const Diagnostic& diagnostic : diagnostics.list()) EXPECT_EQ(diagnostic.code, "W0707");
}

std::vector<std::string> FunctionNames(const SyntaxTree& tree) {
  std::vector<std::string> names;
  for (const auto* function : All<FunctionDeclaration>(tree)) names.push_back(function->name.text);
  return names;
}

double ValueOf(const Expression& expression) {
  return std::get<NumberLiteral>(expression.node).value;
}

std::string Code(FileSet files) {
  const Composed composed(std::move(files));
  EXPECT_TRUE(composed.diagnostics.has_errors());
  return composed.diagnostics.list().empty() ? "" : composed.diagnostics.list()[0].code;
}

const std::string kBase =
    "/// The base.\ntask base\nsensor speed: real [m/s]\n"
    "/// How much.\nparam gain: real = 4 in 0 .. 20\n"
    "memory far: bool = false\n"
    "/// How fast.\nmetric max top = speed\n"
    "fn half(x: real) -> real = x / 2\n"
    "on end_of_time_step {\n  let v = speed\n  /// For speed.\n  reward rate run = v * gain\n"
    "  if v > 2 m/s { reward rate run = half(3) far = true }\n"
    "}\n"
    "on end_of_action {\n  if far { end_episode success \"far\" }\n}\n"
    "test \"nothing\" { fire end_of_action }\n";

SyntaxTree Extended(const std::string& own) {
  return Merged(
      {{"main.task", "task derived extends \"base.task\"\n" + own}, {"base.task", kBase}});
}

// ---- Imports -----------------------------------------------------------------------------------

TEST(Import, BringsTheFunctionsOfALibrary) {
  const SyntaxTree tree =
      Merged({{"main.task", "task t\nimport \"lib/a.task\"\nfn own(x: real) -> real = x\n"},
              {"lib/a.task", "import \"b.task\"\nfn a(x: real) -> real = b(x)\n"},
              {"lib/b.task", "/// Half.\nfn b(x: real) -> real = x / 2\n"}});
  EXPECT_THAT(FunctionNames(tree), ElementsAre("b", "a", "own"));
  EXPECT_EQ(All<FunctionDeclaration>(tree)[0]->doc, "Half.");
  EXPECT_THAT(All<ImportDeclaration>(tree), IsEmpty());
}

TEST(Import, BringsSetsAndConsts) {
  const CheckedTask task = Checked(
      {{"main.task",
        "task a\nimport \"shared.task\"\nsensor x: real[4]\nmetric b = half(sum(x[ends]))\n"},
       {"shared.task",
        "const two: real = 2\nset ends = {0, 3}\nfn half(x: real) -> real = x / two\n"}});
  EXPECT_EQ(task.consts.at(0).name, "two");
  EXPECT_EQ(task.sets.at(0).names, (std::vector<std::string>{"0", "3"}));
}

TEST(Import, TwiceIsOnce) {
  const SyntaxTree tree =
      Merged({{"main.task", "task t\nimport \"a.task\"\nimport \"b.task\"\nimport \"./b.task\"\n"},
              {"a.task", "import \"b.task\"\nfn a(x: real) -> real = b(x)\n"},
              {"b.task", "fn b(x: real) -> real = x\n"}});
  EXPECT_THAT(FunctionNames(tree), ElementsAre("b", "a"));
}

TEST(Import, KeepsThePlacesOfTheLibrary) {
  Composed composed(
      {{"main.task", "task t\nimport \"a.task\"\n"}, {"a.task", "fn a(x: real) -> real = x\n"}});
  ASSERT_TRUE(composed.tree);
  const Span span = All<FunctionDeclaration>(*composed.tree)[0]->name.span;
  EXPECT_EQ(composed.sources.FileOf(span).path(), "a.task");
  EXPECT_EQ(composed.sources.FileOf(span).TextOf(span), "a");
}

// ---- Extension ---------------------------------------------------------------------------------

TEST(Extension, TakesOverEverythingButTheTestsAndTheHeader) {
  const SyntaxTree tree = Extended("");
  EXPECT_EQ(tree.task->text, "derived");
  EXPECT_EQ(tree.doc, "");
  EXPECT_FALSE(tree.base);
  EXPECT_EQ(tree.declarations.size(), 7u);
  EXPECT_THAT(All<TestDeclaration>(tree), IsEmpty());
  EXPECT_EQ(All<ParamDeclaration>(tree)[0]->doc, "How much.");
}

TEST(Extension, HasTheRobotOfTheBaseUnlessItNamesAnother) {
  const FileSet base = {{"base.task", "task base for humanoid\nstart standing\n"}};
  FileSet files = base;
  files["main.task"] = "task t extends \"base.task\"\n";
  EXPECT_EQ(Merged(files).robot->text, "humanoid");
  files["main.task"] = "task t extends \"base.task\" for hopper\noverride start lying\n";
  const SyntaxTree tree = Merged(files);
  EXPECT_EQ(tree.robot->text, "hopper");
  ASSERT_EQ(tree.declarations.size(), 1u);
  EXPECT_EQ(std::get<StartDeclaration>(tree.declarations[0].node).poses[0].text, "lying");
}

TEST(Extension, AppendsToTheBlocksOfTheBaseInScopesOfTheirOwn) {
  const CheckedTask task =
      Checked({{"main.task",
                "task t extends \"base.task\"\non end_of_time_step {\n  let v = 2 * speed\n"
                "  reward rate more = v\n}\non start_of_action { far = false }\n"},
               {"base.task", kBase}});
  const CheckedEvent& event = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)];
  ASSERT_EQ(event.locals.size(), 2u);
  EXPECT_EQ(event.body.size(), 5u);
  EXPECT_TRUE(task.events[static_cast<size_t>(EventKind::kStartOfAction)].is_declared);
  ASSERT_EQ(task.terms.size(), 2u);
  EXPECT_EQ(task.terms[0].name, "run");
  EXPECT_EQ(task.terms[1].name, "more");
}

TEST(Extension, OverridesConstsAndSets) {
  const FileSet files = {
      {"main.task",
       "task a extends \"base.task\"\nconst most: int = 2\noverride const reach = 7 cm\n"
       "/// Others.\noverride set few = {most, 4}\n"},
      {"base.task",
       "/// The base.\ntask base\nsensor x: real[5] [m]\nset few = 0..1\n/// How far.\n"
       "const reach: real [m] = 5 cm\n"
       "on end_of_time_step {\n  reward rate a = sum(x[few]) / reach\n}\n"}};
  const CheckedTask task = Checked(files);
  ASSERT_EQ(task.consts.size(), 2u);
  EXPECT_EQ(task.consts[1].name, "reach");
  EXPECT_EQ(task.consts[1].elements, std::vector<double>{0.07});
  EXPECT_EQ(task.sets.at(0).indices, (std::vector<uint32_t>{2, 4}));
  const SyntaxTree tree = Merged(files);
  EXPECT_EQ(All<ConstDeclaration>(tree)[0]->doc, "How far.");
  EXPECT_EQ(All<SetDeclaration>(tree)[0]->doc, "Others.");
}

TEST(Extension, OverridesTheDefaultOfAParam) {
  const SyntaxTree tree = Extended("override param gain = 5\n");
  const ParamDeclaration& param = *All<ParamDeclaration>(tree)[0];
  EXPECT_EQ(ValueOf(param.initial), 5);
  EXPECT_EQ(ValueOf(*param.maximum), 20);
  EXPECT_EQ(param.doc, "How much.");
  const SyntaxTree wider = Extended("override param gain = 50 in 10 .. 100\n");
  EXPECT_EQ(ValueOf(*All<ParamDeclaration>(wider)[0]->minimum), 10);
  EXPECT_EQ(ValueOf(*All<ParamDeclaration>(wider)[0]->maximum), 100);
}

TEST(Extension, OverridesMetricsAndFunctions) {
  const SyntaxTree tree =
      Extended("override metric top = 3\n/// A quarter.\noverride fn half(x: real) -> real = 1\n");
  ASSERT_EQ(All<MetricDeclaration>(tree).size(), 1u);
  const MetricDeclaration& metric = *All<MetricDeclaration>(tree)[0];
  EXPECT_EQ(metric.doc, "How fast.");
  EXPECT_EQ(metric.reduction, Reduction::kLast);
  EXPECT_EQ(ValueOf(metric.value), 3);
  ASSERT_EQ(All<FunctionDeclaration>(tree).size(), 1u);
  EXPECT_EQ(All<FunctionDeclaration>(tree)[0]->doc, "A quarter.");
  EXPECT_EQ(ValueOf(All<FunctionDeclaration>(tree)[0]->value), 1);
}

TEST(Extension, OverridesEveryStatementOfATermInItsScope) {
  const CheckedTask task =
      Checked({{"main.task", "task t extends \"base.task\"\noverride reward rate run = 2 * v\n"},
               {"base.task", kBase}});
  const CheckedEvent& event = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)];
  const auto& first = std::get<CheckedReward>(event.body[1].node);
  const auto& nested =
      std::get<CheckedReward>(std::get<CheckedIf>(event.body[2].node).branches[0].body[0].node);
  EXPECT_TRUE(nested.is_rate);
  EXPECT_EQ(first.term, nested.term);
  EXPECT_EQ(task.terms.size(), 1u);
  EXPECT_EQ(task.terms[0].doc, "For speed.");
}

TEST(Extension, OverridesAPotential) {
  const CheckedTask task = Checked(
      {{"main.task", "task t extends \"base.task\"\noverride reward potential near = -2 * x\n"},
       {"base.task", "task base\nsensor x: real\n/// Nearer.\nreward potential near = -x\n"}});
  ASSERT_EQ(task.potentials.size(), 1u);
  EXPECT_EQ(task.terms[0].doc, "Nearer.");
  const CheckedEvent& event = task.events[static_cast<size_t>(EventKind::kEndOfAction)];
  const auto& step = std::get<CheckedPotentialStep>(event.body[0].node);
  EXPECT_TRUE(std::holds_alternative<CheckedBinary>(step.value.node));
}

TEST(Extension, OverridesTheBlockOfAnEvent) {
  const SyntaxTree tree = Extended("override on end_of_action { reward end = 1 }\n");
  const auto events = All<EventDeclaration>(tree);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1]->event, EventKind::kEndOfAction);
  EXPECT_TRUE(std::holds_alternative<RewardStatement>(events[1]->body[0].node));
  EXPECT_THAT(events[1]->appended, IsEmpty());
}

TEST(Extension, ReplacesPhasesAndAddsThem) {
  const FileSet files = {{"main.task",
                          "task b extends \"base.task\"\n"
                          "override phase lift { reward up = 2 next rest }\n"
                          "override reward near = 3\n"
                          "phase rest { reward still = 1 next reach }\n"},
                         {"base.task",
                          "task base\nsensor x: real\n"
                          "phase reach { if x > 0 { reward near = 1 next lift } }\n"
                          "/// Up.\nphase lift within 3 s else reach { reward up = x }\n"}};
  const SyntaxTree tree = Merged(files);
  const auto phases = All<PhaseDeclaration>(tree);
  ASSERT_EQ(phases.size(), 3u);
  EXPECT_EQ(phases[1]->name.text, "lift");
  EXPECT_EQ(phases[1]->doc, "Up.");
  EXPECT_FALSE(phases[1]->limit);
  EXPECT_EQ(phases[2]->name.text, "rest");
  const Block& block = std::get<IfStatement>(phases[0]->body[0].node).branches[0].body;
  EXPECT_EQ(ValueOf(std::get<RewardStatement>(block[0].node).value), 3);
  EXPECT_EQ(Checked(files).phases.size(), 3u);
}

TEST(Extension, ChainsFromBaseToBase) {
  const SyntaxTree tree = Merged({{"main.task",
                                   "task c extends \"b.task\"\noverride param gain = 3\n"
                                   "on end_of_action { reward c = 1 }\n"},
                                  {"b.task",
                                   "task b extends \"base.task\"\noverride param gain = 2\n"
                                   "on end_of_action { reward b = 1 }\n"},
                                  {"base.task", kBase}});
  EXPECT_EQ(ValueOf(All<ParamDeclaration>(tree)[0]->initial), 3);
  EXPECT_EQ(All<EventDeclaration>(tree)[1]->appended.size(), 2u);
}

TEST(Extension, AnOverrideReachesWhatATaskInBetweenAppended) {
  const SyntaxTree tree =
      Merged({{"main.task", "task c extends \"b.task\"\noverride reward b = 7\n"},
              {"b.task", "task b extends \"base.task\"\non end_of_action { reward b = 1 }\n"},
              {"base.task", kBase}});
  const Block& appended = All<EventDeclaration>(tree)[1]->appended[0];
  EXPECT_EQ(ValueOf(std::get<RewardStatement>(appended[0].node).value), 7);
}

TEST(Extension, KeepsAllowancesButThoseOfWhatItReplaces) {
  const FileSet files = {{"main.task",
                          "task t extends \"base.task\"\noverride reward run = 2\nallow W0701\n"
                          "memory far: bool = false\n"},
                         {"base.task",
                          "allow W0707\ntask base\non end_of_time_step {\n  allow W0706\n"
                          "  reward run = 1\n}\n"}};
  const SyntaxTree tree = Merged(files);
  ASSERT_EQ(tree.allowances.size(), 2u);
  EXPECT_EQ(tree.allowances[0].codes[0].text, "W0707");
  EXPECT_EQ(tree.allowances[1].codes[0].text, "W0701");
}

// ---- What is wrong ----------------------------------------------------------------------------

TEST(Compose, NamesTheCodeOfEachMistake) {
  const std::string header = "task t extends \"base.task\"\n";
  const auto of = [&](const std::string& own) {
    return Code({{"main.task", header + own}, {"base.task", kBase}});
  };
  EXPECT_EQ(of("override param gian = 1\n"), "E0634");
  EXPECT_EQ(of("override start lying\n"), "E0634");
  EXPECT_EQ(of("param gain: real = 1\n"), "E0635");
  EXPECT_EQ(of("override metric top = 1\noverride metric top = 2\n"), "E0638");
  EXPECT_EQ(of("override on end_of_action { }\non end_of_action { }\n"), "E0602");
  EXPECT_EQ(Code({{"main.task", "task t\noverride start lying\n"}}), "E0637");
  EXPECT_EQ(Code({{"main.task", "fn a(x: real) -> real = x\n"}}), "E0633");
}

TEST(Compose, LimitsTheNumberOfFiles) {
  FileSet files;
  std::string& main = files["main.task"] = "task t\n";
  for (size_t i = 0; i < kMaxFiles; ++i) {
    main += fmt::format("import \"f{}.task\"\n", i);
    files[fmt::format("f{}.task", i)] = fmt::format("fn f{}(x: real) -> real = x\n", i);
  }
  EXPECT_EQ(Code(files), "E0636");
}

TEST(Compose, LimitsTheLengthOfAChain) {
  FileSet files{{"main.task", "task t extends \"b1.task\"\n"}};
  for (size_t i = 1; i <= kMaxChain; ++i)
    files[fmt::format("b{}.task", i)] = fmt::format("task t extends \"b{}.task\"\n", i + 1);
  EXPECT_EQ(Code(files), "E0636");
}

TEST(Compose, LimitsTheTotalSize) {
  FileSet files{{"main.task", "task t\n"}};
  for (int i = 0; i < 11; ++i) {
    files["main.task"] += fmt::format("import \"f{}.task\"\n", i);
    files[fmt::format("f{}.task", i)] = fmt::format("fn f{}(x: real) -> real = x\n//", i) +
                                        std::string(kMaxTotalSize / 10 - 100, '.');
  }
  EXPECT_EQ(Code(files), "E0636");
}

TEST(Compose, SaysWhyTheFileItselfCannotBeRead) {
  Sources sources;
  Diagnostics diagnostics;
  EXPECT_THROW(Compose("/nowhere/t.task", ReadFromDisk, sources, diagnostics), CallError);
}

}  // namespace
}  // namespace compiler
