#include "compiler/language_server/hover.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/language_server/bounds_text.h"
#include "compiler/language_server/cursor_place.h"
#include "compiler/language_server/known_values.h"
#include "compiler/language_server/library_text.h"
#include "compiler/language_server/vocabulary.h"

namespace compiler {
namespace {

using protocol::Json;

std::string Code(std::string_view text) { return fmt::format("```task\n{}\n```", text); }

std::string WithDoc(std::string text, std::string_view doc) {
  if (!doc.empty()) text.append("\n\n").append(doc);
  return text;
}

class HoverFinder {
 public:
  HoverFinder(const Document& document, uint32_t offset, Workspace& workspace)
      : document_(document),
        workspace_(workspace),
        values_(document, workspace),
        path_(FindPath(document.tokens(), offset)),
        offset_(offset) {}

  Json Find() {
    if (const auto import = ImportAt(document_, offset_)) {
      shown_ = *import;
      const std::string doc =
          LibraryDoc(std::string_view(document_.text())
                         .substr(import->begin + 1, import->end - import->begin - 2));
      return doc.empty() ? Json(nullptr) : Shown(doc);
    }
    if (path_.path.empty()) return nullptr;
    word_ = document_.text().substr(path_.last.begin, path_.last.end - path_.last.begin);
    shown_ = path_.last;
    for (const auto& explain :
         {&HoverFinder::Referenced, &HoverFinder::Declared, &HoverFinder::Sensor,
          &HoverFinder::Function, &HoverFinder::Part, &HoverFinder::OfRobot, &HoverFinder::UnitName,
          &HoverFinder::Word}) {
      const std::string text = (this->*explain)();
      if (!text.empty()) return Shown(text);
    }
    return nullptr;
  }

 private:
  Json Shown(const std::string& text) const {
    return {{"contents", protocol::Markdown(text)},
            {"range", protocol::ToJson(document_.positions(), shown_)}};
  }

  // What the compiler found here.
  std::string Referenced() {
    const Findings& findings = workspace_.FindingsOf(document_);
    const Reference* reference = findings.FindReference(offset_);
    if (reference == nullptr || !reference->has_definition()) return "";
    const SourceFile& file = findings.analysis.sources.FileOf(reference->definition);
    const uint32_t place = LocalSpan(file, reference->definition).begin;
    shown_ = {reference->use.begin - findings.first_offset,
              reference->use.end - findings.first_offset};
    return WithDoc(WithDoc(Code(Describe(*reference, CodeOfLine(file.text(), place))),
                           BoundsOf(*reference, findings)),
                   DocAbove(file.text(), place));
  }

  static std::string Describe(const Reference& reference, const std::string& line) {
    switch (reference.kind) {
      case ReferenceKind::kLocal:
        return fmt::format("let {}: {}", reference.name, TypeText(reference.type, reference.unit));
      case ReferenceKind::kLoop:
        if (!reference.type.index.empty()) {
          return fmt::format("{}: {}", reference.name, reference.type.index);
        }
        [[fallthrough]];
      case ReferenceKind::kArgument:
        return fmt::format("{}: {}", reference.name, TypeText(reference.type, reference.unit));
      default:
        return line;
    }
  }

  static std::string BoundsOf(const Reference& reference, const Findings& findings) {
    if (!findings.analysis.task) return "";
    const std::string constant = ConstantText(reference, *findings.analysis.task);
    return constant.empty() ? BoundsText(reference, *findings.analysis.task) : constant;
  }

  // What a const is, and what is in a set.
  static std::string ConstantText(const Reference& reference, const CheckedTask& task) {
    if (reference.kind == ReferenceKind::kConst) {
      const auto found = std::ranges::find(task.consts, reference.name, &CheckedConst::name);
      if (found == task.consts.end() || IsBool(found->type)) return "";
      const std::string unit = ToString(found->unit);
      return fmt::format("{:.6g}{}{}", fmt::join(found->elements, ", "), unit.empty() ? "" : " ",
                         unit);
    }
    if (reference.kind == ReferenceKind::kTable) return TableText(reference, task);
    if (reference.kind != ReferenceKind::kSet) return "";
    const auto found = std::ranges::find(task.sets, reference.name, &CheckedSet::name);
    return found == task.sets.end() ? "" : fmt::format("{}", fmt::join(found->names, ", "));
  }

  // "51 rows, time from 0 to 1 s"
  static std::string TableText(const Reference& reference, const CheckedTask& task) {
    const auto found = std::ranges::find(task.tables, reference.name, &CheckedTable::name);
    if (found == task.tables.end()) return "";
    const std::string unit = ToString(found->argument_unit);
    return fmt::format("{} rows, {} from {:.6g} to {:.6g}{}{}", found->arguments.size(),
                       found->argument, found->arguments.front(), found->arguments.back(),
                       unit.empty() ? "" : " ", unit);
  }

  // What the text says, where the compiler has not come so far.
  std::string Declared() {
    if (IsMember()) return "";
    const DeclaredName* name = document_.FindName(word_, offset_);
    if (name == nullptr || name->kind == NameKind::kEvent) return "";
    const bool is_plain = name->kind == NameKind::kArgument || name->kind == NameKind::kLoop;
    const auto value = values_.Find(name->name, offset_);
    std::string line = CodeOfLine(document_.text(), name->span.begin);
    if (is_plain) line = fmt::format("{}: {}", name->name, name->type);
    if (name->kind == NameKind::kLet && value && !value->type.empty()) {
      line = fmt::format("let {}: {}", name->name, value->type);
    }
    return WithDoc(Code(line), DocAbove(document_.text(), name->span.begin));
  }

  bool IsMember() const { return path_.path.size() > word_.size(); }

  std::string Sensor() {
    for (const KnownValue& sensor : values_.Sensors()) {
      if (sensor.name != path_.path) continue;
      shown_ = path_.span;
      const std::string_view what = sensor.is_constant ? "constant" : "sensor";
      return WithDoc(Code(fmt::format("{} {}: {}", what, sensor.name, sensor.type)), sensor.doc);
    }
    return "";
  }

  std::string Function() {
    if (!IsCall()) return "";
    const std::string signature = SignatureOf(word_, document_, workspace_);
    return signature.empty() ? "" : Code(signature);
  }

  // `min` is a unit, a reduction, or a function: then a bracket follows.
  bool IsCall() const {
    const size_t next = document_.tokens().CountBefore(path_.last.end);
    return document_.tokens().Is(next, "(");
  }

  std::string Part() {
    for (const Enumeration& each : values_.enumerations()) {
      const auto members = each.Find(word_);
      if (!members) continue;
      if (members->size() == 1 && each.members[members->front()] == word_) {
        return fmt::format("{} {} `{}`", each.name, members->front(), word_);
      }
      std::vector<std::string> names;
      for (const uint32_t member : *members) names.push_back(each.members[member]);
      return fmt::format("{} `{}`: {}", each.all, word_, fmt::join(names, ", "));
    }
    return "";
  }

  std::string OfRobot() {
    const robot::RobotDescription* robot = workspace_.RobotOf(document_);
    if (robot == nullptr) return "";
    if (robot->name == word_) {
      return WithDoc(fmt::format("robot `{}`: {} links, {} joints, {} sites", robot->name,
                                 robot->links.size(), robot->joints.size(), robot->sites.size()),
                     robot->doc);
    }
    if (robot->FindPose(word_) != nullptr) return fmt::format("pose `{}`", word_);
    return "";
  }

  std::string UnitName() {
    const size_t index = document_.tokens().CountBefore(path_.last.begin);
    const auto unit = FindUnit(word_);
    const bool is_unit = unit && document_.tokens().KindOf(index) == LexedKind::kUnit;
    if (!is_unit || IsReduction(index)) return "";
    return fmt::format("unit: 1 {} = {} {}", word_, unit->ToSi(1), ToString(unit->unit));
  }

  // `metric min height`
  bool IsReduction(size_t index) const {
    return index > 0 &&
           (document_.tokens().Is(index - 1, "metric") || document_.tokens().Is(index - 1, "log"));
  }

  std::string Word() { return std::string(ExplanationOf(word_)); }

  const Document& document_;
  Workspace& workspace_;
  KnownValues values_;
  PathAtCursor path_;
  uint32_t offset_;
  std::string word_;
  Span shown_{};
};

}  // namespace

Json Hover(const Document& document, uint32_t offset, Workspace& workspace) {
  return HoverFinder(document, offset, workspace).Find();
}

std::string SignatureOf(std::string_view function, const Document& document, Workspace& workspace) {
  const auto written = [](std::string_view name, std::string_view type) {
    return fmt::format("{}{}", name, type);
  };
  const auto of_table = [](std::string_view name, std::string_view type) {
    return fmt::format("{0}(x) -> {1}\n{0}(x, loop) -> {1}", name, type);
  };
  for (const DeclaredName& name : document.names()) {
    if (name.name != function) continue;
    if (name.kind == NameKind::kFunction) return written(name.name, name.type);
    if (name.kind == NameKind::kTable && !name.is_override) return of_table(name.name, name.type);
  }
  if (const BuiltinDescription* builtin = FindBuiltin(function)) {
    // "min(x, y)` or `min(values)" is written for messages.
    std::string usage(builtin->usage);
    if (const size_t other = usage.find("` or `"); other != std::string::npos) {
      usage.replace(other, 6, "\n");
    }
    return usage;
  }
  if (const TimeFunctionDescription* timed = FindTimeFunction(function))
    return fmt::format("{}\n{}", timed->usage, timed->doc);
  const auto* draw = std::ranges::find(kDraws, function, &DrawDescription::name);
  if (draw != std::end(kDraws)) return fmt::format("{}\n{}", draw->usage, draw->doc);
  const KnownValues values(document, workspace);
  for (const KnownValue& value : values.inherited()) {
    if (value.name != function) continue;
    if (value.kind == NameKind::kFunction) return written(value.name, value.type);
    if (value.kind == NameKind::kTable) return of_table(value.name, value.type);
  }
  return "";
}

}  // namespace compiler
