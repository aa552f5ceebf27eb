#include "compiler/document/task_page.h"

#include <sstream>

#include "compiler/document/page_builder.h"
#include "compiler/document/task_parts.h"
#include "compiler/document/task_sections.h"

namespace compiler {
namespace {

void AddIntroduction(const TaskParts& parts, PageBuilder& page) {
  std::istringstream lines(parts.task.doc);
  std::string paragraph;
  const auto flush = [&] {
    if (!paragraph.empty()) page.AddParagraph(FromDoc(paragraph));
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      flush();
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  flush();
  Text facts;
  if (parts.task.robot.empty()) {
    facts = Plain("For any host that supplies the sensors below.");
  } else {
    facts = {{Piece::kPlain, "Robot: "}, {Piece::kCode, parts.task.robot}};
    const std::vector<std::string>& poses = parts.task.start.poses;
    for (size_t i = 0; i < poses.size(); ++i) {
      facts.push_back({Piece::kPlain, i == 0 ? ", which starts in the pose " : " or "});
      facts.push_back({Piece::kCode, poses[i]});
    }
    if (parts.tree.world) {
      facts.push_back({Piece::kPlain, ", in the world "});
      facts.push_back({Piece::kCode, parts.tree.world->path});
    }
    facts.push_back({Piece::kPlain, "."});
  }
  page.AddParagraph(facts);
}

}  // namespace

Page PageOf(const Analysis& analysis) {
  const TaskParts parts(analysis);
  PageBuilder page(parts.task.name);
  AddIntroduction(parts, page);
  AddStart(parts, page);
  AddPhases(parts, page);
  for (const Statements& each : parts.statements) AddRewards(each, page);
  AddPotentials(parts, page);
  AddBounds(parts, page);
  AddEnds(parts, page);
  AddRequirements(parts, page);
  AddMetrics(parts, page);
  AddParams(parts, page);
  AddConsts(parts, page);
  AddSets(parts, page);
  AddTables(parts, page);
  AddGoals(parts, page);
  AddObservations(parts, page);
  AddMemory(parts, page);
  AddLogs(parts, page);
  AddFunctions(parts, page);
  AddSensors(parts, page);
  AddTests(parts, page);
  return page.Finish();
}

}  // namespace compiler
