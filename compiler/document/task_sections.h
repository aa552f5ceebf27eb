// The sections of a task's page. One of which the task has nothing adds nothing.
#pragma once

#include "compiler/document/page_builder.h"
#include "compiler/document/task_parts.h"

namespace compiler {

// What happens in an episode, and what it pays.
void AddStart(const TaskParts& parts, PageBuilder& page);
void AddPhases(const TaskParts& parts, PageBuilder& page);
void AddRewards(const Statements& statements, PageBuilder& page);
void AddPotentials(const TaskParts& parts, PageBuilder& page);
void AddBounds(const TaskParts& parts, PageBuilder& page);
void AddEnds(const TaskParts& parts, PageBuilder& page);
void AddRequirements(const TaskParts& parts, PageBuilder& page);
void AddMetrics(const TaskParts& parts, PageBuilder& page);
void AddLogs(const TaskParts& parts, PageBuilder& page);

// What the task declares, and what it reads.
void AddParams(const TaskParts& parts, PageBuilder& page);
void AddConsts(const TaskParts& parts, PageBuilder& page);
void AddSets(const TaskParts& parts, PageBuilder& page);
void AddTables(const TaskParts& parts, PageBuilder& page);
void AddGoals(const TaskParts& parts, PageBuilder& page);
void AddObservations(const TaskParts& parts, PageBuilder& page);
void AddMemory(const TaskParts& parts, PageBuilder& page);
void AddFunctions(const TaskParts& parts, PageBuilder& page);
void AddSensors(const TaskParts& parts, PageBuilder& page);
void AddTests(const TaskParts& parts, PageBuilder& page);

}  // namespace compiler
