#include "compiler/language_server/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/starts.h"
#include "compiler/check/tables.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/compose/library.h"
#include "compiler/language_server/cursor_place.h"
#include "compiler/language_server/known_values.h"
#include "compiler/language_server/library_text.h"
#include "compiler/language_server/vocabulary.h"
#include "compiler/source/diagnostic_table.h"

namespace compiler {
namespace {

using protocol::Json;

// "vec3" of "vec3 [m/s]".
// "vec3" of "vec3 [m]", and of "vec3[link] [m]": members are taken of each vector.
std::string_view NameOfType(std::string_view type) {
  return type.substr(0, type.find_first_of(" ["));
}

class Completer {
 public:
  Completer(const Document& document, uint32_t offset, Workspace& workspace)
      : document_(document),
        offset_(offset),
        workspace_(workspace),
        place_(FindCursorPlace(document.tokens(), offset)) {}

  Json Run() {
    if (place_.expected != Expected::kAnyText) Offer();
    return std::move(items_);
  }

 private:
  void Offer() {
    switch (place_.expected) {
      case Expected::kAnyText:
        return;
      case Expected::kDeclaration:
        return OfferWords(DeclarationWords());
      case Expected::kStatement:
        OfferWords(StatementWords());
        return OfferNames({NameKind::kMemory}, protocol::kCompleteVariable);
      case Expected::kStartStatement:
        for (const StartValueDescription& value : kStartValues)
          Add(std::string(value.name), protocol::kCompleteVariable, "", std::string(value.doc));
        for (const char* word : {"let", "if", "for"})
          Add(word, protocol::kCompleteKeyword, "", std::string(ExplanationOf(word)));
        return;
      case Expected::kTestStatement:
        return OfferWords(TestWords());
      case Expected::kBodyStatement:
        return OfferWords(BodyWords());
      case Expected::kOverridden:
        for (const char* word : {"param", "const", "set", "table", "reward", "metric", "goal",
                                 "observe", "on", "phase", "start", "after_end", "fn"}) {
          Add(word, protocol::kCompleteKeyword, "", std::string(ExplanationOf(word)));
        }
        return;
      case Expected::kParamName:
        return OfferInherited(NameKind::kParam);
      case Expected::kConstName:
        return OfferInherited(NameKind::kConst);
      case Expected::kSetName:
        return OfferInherited(NameKind::kSet);
      case Expected::kTableName:
        return OfferInherited(NameKind::kTable);
      case Expected::kGoalName:
        return OfferInherited(NameKind::kGoal);
      case Expected::kObservationName:
        return OfferInherited(NameKind::kObservation);
      case Expected::kPhaseName:
        return OfferInherited(NameKind::kPhase);
      case Expected::kMetricName:
        return OfferInherited(NameKind::kMetric);
      case Expected::kFunctionName:
        return OfferInherited(NameKind::kFunction);
      case Expected::kValue:
        return OfferValues();
      case Expected::kGoalValue:
        for (const DrawDescription& draw : kDraws)
          Add(std::string(draw.name), protocol::kCompleteFunction, fmt::format("`{}`", draw.usage),
              std::string(draw.doc));
        return OfferValues();
      case Expected::kObserved:
        Add("onboard", protocol::kCompleteKeyword, "", std::string(ExplanationOf("onboard")));
        return OfferValues();
      case Expected::kGoal:
        return OfferNames({NameKind::kGoal}, protocol::kCompleteVariable);
      case Expected::kPhase:
        return OfferNames({NameKind::kPhase}, protocol::kCompleteEnumMember);
      case Expected::kOperator:
        return OfferWords(OperatorWords());
      case Expected::kMember:
        return OfferMembers();
      case Expected::kIndex:
        return OfferIndices();
      case Expected::kUnit:
        OfferUnits();
        return OfferWords(OperatorWords());
      case Expected::kType:
        for (const std::string& type : TypeNames()) {
          Add(type, protocol::kCompleteType, "", std::string(ExplanationOf(type)));
        }
        return;
      case Expected::kTypeIndex:
        for (const Enumeration& each : Values().enumerations()) {
          Add(each.name, protocol::kCompleteType, fmt::format("one for each of the {}", each.all));
        }
        return OfferUnits();
      case Expected::kEvent:
        return OfferWords(EventWords(), protocol::kCompleteEvent);
      case Expected::kPose:
        return OfferPoses();
      case Expected::kRobot:
        return OfferRobots();
      case Expected::kScope:
        return OfferWords(ScopeWords(), protocol::kCompleteEnumMember);
      case Expected::kReduction:
        return OfferWords(ReductionWords(), protocol::kCompleteEnumMember);
      case Expected::kOutcome:
        return OfferWords(OutcomeWords(), protocol::kCompleteEnumMember);
      case Expected::kAfterEnd:
        return OfferWords(AfterEndWords(), protocol::kCompleteEnumMember);
      case Expected::kPotential:
        return Add("potential", protocol::kCompleteKeyword, "",
                   std::string(ExplanationOf("potential")));
      case Expected::kTerm:
        Add("rate", protocol::kCompleteKeyword, "", std::string(ExplanationOf("rate")));
        return OfferNames({NameKind::kTerm}, protocol::kCompleteProperty);
      case Expected::kTarget:
        OfferNames({NameKind::kSensor, NameKind::kParam, NameKind::kMemory, NameKind::kGoal},
                   protocol::kCompleteVariable);
        OfferReadsOfPhases();
        return Add("time_step", protocol::kCompleteConstant);
      case Expected::kExpectation:
        Add("end_episode", protocol::kCompleteKeyword);
        Add("truncate_episode", protocol::kCompleteKeyword);
        return OfferValues();
      case Expected::kWarningCode:
        for (const DiagnosticKind& kind : kDiagnosticTable) {
          if (kind.code.starts_with('W')) {
            Add(std::string(kind.code), protocol::kCompleteConstant, std::string(kind.title));
          }
        }
        return;
      case Expected::kFile:
        return OfferFiles(".task");
      case Expected::kTableFile:
        return OfferFiles(".csv");
      case Expected::kWorldFile:
        return OfferFiles(".toml");
    }
  }

  void OfferWords(std::span<const ExplainedWord> words,
                  protocol::CompletionKind kind = protocol::kCompleteKeyword) {
    for (const ExplainedWord& word : words) {
      Add(std::string(word.word), kind, "", std::string(word.explanation));
    }
  }

  void OfferNames(const std::set<NameKind>& kinds, protocol::CompletionKind kind) {
    for (const KnownValue& value : Values().VisibleAt(offset_)) {
      if (kinds.contains(value.kind)) Add(value.name, kind, value.type, value.doc);
    }
  }

  void OfferInherited(NameKind kind) {
    for (const KnownValue& value : Values().inherited()) {
      if (value.kind == kind) Add(value.name, protocol::kCompleteVariable, value.type, value.doc);
    }
  }

  void OfferValues() {
    OfferNames({NameKind::kLet, NameKind::kLoop, NameKind::kArgument, NameKind::kMemory,
                NameKind::kGoal, NameKind::kSensor},
               protocol::kCompleteVariable);
    OfferNames({NameKind::kParam, NameKind::kConst}, protocol::kCompleteConstant);
    OfferNames({NameKind::kFunction}, protocol::kCompleteFunction);
    OfferTables();
    for (const std::string& name : BuiltinNames()) {
      Add(name, protocol::kCompleteFunction, fmt::format("`{}`", FindBuiltin(name)->usage));
    }
    OfferWords(ValueWords());
    OfferReadsOfPhases();
    if (!IsIn(NameKind::kTest)) return OfferTimeFunctions();
    for (const char* word : {"total", "value", "observed", "ended"}) {
      Add(word, protocol::kCompleteFunction, "", std::string(ExplanationOf(word)));
    }
    OfferNames({NameKind::kTerm, NameKind::kMetric, NameKind::kLog, NameKind::kObservation},
               protocol::kCompleteProperty);
  }

  void OfferTables() {
    OfferNames({NameKind::kTable}, protocol::kCompleteFunction);
    const OpenCall call = FindOpenCall(document_.tokens(), place_.word.begin);
    const auto table = Values().Find(call.function, offset_);
    if (call.argument == 1 && table && table->kind == NameKind::kTable)
      Add(std::string(kLoopWord), protocol::kCompleteKeyword, "",
          std::string(ExplanationOf(kLoopWord)));
    Add(std::string(kDuration), protocol::kCompleteFunction, fmt::format("`{}(table)`", kDuration),
        std::string(ExplanationOf(kDuration)));
  }

  // Where there are phases.
  void OfferReadsOfPhases() {
    const auto visible = Values().VisibleAt(offset_);
    if (std::ranges::find(visible, NameKind::kPhase, &KnownValue::kind) == visible.end()) return;
    for (const char* word : {"phase", "phase_time"})
      Add(word, protocol::kCompleteVariable, "", std::string(ExplanationOf(word)));
  }

  void OfferTimeFunctions() {
    for (const TimeFunctionDescription& each : kTimeFunctions)
      Add(std::string(each.name), protocol::kCompleteFunction, fmt::format("`{}`", each.usage),
          std::string(each.doc));
  }

  bool IsIn(NameKind kind) const {
    return std::ranges::any_of(document_.names(), [&](const DeclaredName& name) {
      return name.kind == kind && name.whole.begin < offset_ && offset_ <= name.whole.end;
    });
  }

  // `base.` goes on with sensors, `base.velocity.` with elements.
  void OfferMembers() {
    const std::string prefix = place_.path + ".";
    for (const KnownValue& sensor : Values().Sensors()) {
      if (sensor.name.starts_with(prefix)) {
        Add(sensor.name.substr(prefix.size()), protocol::kCompleteProperty, sensor.type,
            sensor.doc);
      }
    }
    const auto value = Values().Find(place_.path, offset_);
    if (!value) return;
    const std::string_view type = NameOfType(value->type);
    const std::string_view letters = type == "quat"   ? "wxyz"
                                     : type == "vec4" ? "xyzw"
                                     : type == "vec3" ? "xyz"
                                     : type == "vec2" ? "xy"
                                                      : "";
    for (const char letter : letters) {
      Add(std::string(1, letter), protocol::kCompleteProperty, "an element");
    }
    if (letters.size() > 2 && type != "quat") {
      Add("xy", protocol::kCompleteProperty, "two elements");
    }
  }

  void OfferIndices() {
    const Enumeration* index =
        place_.path.empty() ? nullptr : Values().IndexOf(place_.path, offset_);
    const bool is_known = place_.path.empty() || Values().Find(place_.path, offset_);
    for (const Enumeration& each : Values().enumerations()) {
      const bool fits = index == &each || (index == nullptr && (place_.path.empty() || !is_known));
      if (fits) OfferParts(each);
    }
    OfferNames({NameKind::kLoop}, protocol::kCompleteVariable);
    OfferNames({NameKind::kSet}, protocol::kCompleteConstant);
  }

  void OfferParts(const Enumeration& parts) {
    Add(parts.all, protocol::kCompleteEnumMember, fmt::format("all {}", parts.all));
    for (const robot::Group& group : parts.groups) {
      Add(group.name, protocol::kCompleteEnumMember,
          fmt::format("group of {} {}", group.members.size(), parts.all));
    }
    for (const std::string& member : parts.members) {
      Add(member, protocol::kCompleteEnumMember, parts.name);
    }
  }

  void OfferUnits() {
    for (const std::string& unit : KnownUnits()) {
      Add(unit, protocol::kCompleteUnit, ToString(FindUnit(unit)->unit));
    }
    const size_t last = document_.tokens().CountBefore(place_.word.begin);
    const bool is_behind_number =
        last > 0 && document_.tokens().KindOf(last - 1) == LexedKind::kNumber;
    if (!is_behind_number && IsIn(NameKind::kFunction))
      Add(std::string(kAnyUnit), protocol::kCompleteUnit, "", std::string(ExplanationOf(kAnyUnit)));
  }

  void OfferPoses() {
    const robot::RobotDescription* robot = workspace_.RobotOf(document_);
    if (robot == nullptr) return;
    for (const robot::Pose& pose : robot->poses) Add(pose.name, protocol::kCompleteEnumMember);
  }

  void OfferRobots() {
    for (const std::filesystem::path& folder : workspace_.RobotFoldersOf(document_)) {
      std::error_code error;
      for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (std::filesystem::exists(entry.path() / "robot.toml", error)) {
          Add(entry.path().filename().string(), protocol::kCompleteEnumMember, "a robot");
        }
      }
    }
  }

  // Files beside this one, within the quotes; behind `import` also libraries.
  void OfferFiles(std::string_view ending) {
    const size_t text = document_.tokens().CountBefore(place_.word.begin - 1);
    if (text > 0 && document_.tokens().Is(text - 1, "import")) {
      for (const std::string& library : LibraryNames())
        Add(library, protocol::kCompleteFile, "library", LibraryDoc(library));
    }
    std::error_code error;
    const std::filesystem::path folder = document_.path().parent_path();
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      const bool is_other = entry.path() != document_.path();
      if (entry.path().extension() == ending && is_other) {
        Add(entry.path().filename().string(), protocol::kCompleteFile);
      }
    }
  }

  // Each label once: the nearest declaration comes first.
  void Add(std::string label, protocol::CompletionKind kind, const std::string& detail = "",
           const std::string& doc = "") {
    if (!seen_.insert(label).second) return;
    Json item{{"label", label}, {"kind", kind}};
    item["sortText"] = fmt::format("{:04}", items_.size());
    item["textEdit"] = {{"range", protocol::ToJson(document_.positions(), place_.word)},
                        {"newText", std::move(label)}};
    if (!detail.empty()) item["detail"] = detail;
    if (!doc.empty()) item["documentation"] = protocol::Markdown(doc);
    items_.push_back(std::move(item));
  }

  const KnownValues& Values() {
    if (!values_) values_.emplace(document_, workspace_);
    return *values_;
  }

  const Document& document_;
  uint32_t offset_;
  Workspace& workspace_;
  CursorPlace place_;
  std::optional<KnownValues> values_;
  std::set<std::string> seen_;
  Json items_ = Json::array();
};

}  // namespace

Json Complete(const Document& document, uint32_t offset, Workspace& workspace) {
  return {{"isIncomplete", false}, {"items", Completer(document, offset, workspace).Run()}};
}

}  // namespace compiler
