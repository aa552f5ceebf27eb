#include "tests/compiler/random/random_task_writer.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {

void TaskWriter::WritePhase(const std::string& name) {
  const std::string limit =
      random_.OneIn(2) ? fmt::format(" within {} else {}", random_.OneOf({"7 ms", "20 ms"}),
                                     random_.OneOf(phases_))
                       : "";
  is_in_phase_ = true;
  WriteTopBlock(fmt::format("phase {}{}", name, limit), EventKind::kEndOfTimeStep);
  is_in_phase_ = false;
}

void TaskWriter::WriteEvent(std::string_view name, EventKind event) {
  WriteTopBlock(fmt::format("on {}", name), event);
}

void TaskWriter::WriteTopBlock(const std::string& head, EventKind event) {
  event_ = event;
  const size_t outside = readable_.size();
  readable_.push_back({"reward", ScalarType(Scalar::kReal), {}});
  if (IsStep()) readable_.push_back({"time_step", ScalarType(Scalar::kReal), {.second = 1}});
  Line(head + " {");
  WriteBlock(4 + random_.Below(8), 2);
  Line("}");
  readable_.resize(outside);
}

void TaskWriter::WriteBlock(uint32_t statements, int depth) {
  ++indent_;
  const size_t outside = readable_.size();
  for (uint32_t i = 0; i < statements; ++i) WriteStatement(depth);
  readable_.resize(outside);
  --indent_;
}

void TaskWriter::WriteStatement(int depth) {
  if (is_in_phase_ && random_.OneIn(6)) return Line(fmt::format("next {}", random_.OneOf(phases_)));
  switch (random_.Below(depth > 0 ? 18 : 14)) {
    case 0:
    case 1:
      return WriteLet();
    case 2:
    case 3:
      return WriteAssignment();
    case 4:
    case 5:
      return WriteElementAssignment();
    case 6:
    case 7:
      return WriteReward();
    case 8:
      return WriteEnd();
    case 9:
      return WriteLog();
    case 10:
      return Line(fmt::format("require {}{}", Condition(),
                              random_.OneIn(2) ? fmt::format(" \"{}\"", NewName("reason")) : ""));
    case 11:
      return Line(fmt::format("redraw {}", random_.OneOf(goals_).name));
    case 12:
      return WritePast();
    case 13:
      return WriteTable();
    case 14:
      return WriteFor(depth);
    case 15:
      Line(fmt::format("once per {} if {} {{", random_.OneOf({"action", "episode", "run"}),
                       Condition()));
      WriteBlock(1 + random_.Below(3), depth - 1);
      if (random_.OneIn(2)) {
        Line(fmt::format("}} else if {} {{", Condition()));
        WriteBlock(1 + random_.Below(3), depth - 1);
      }
      return Line("}");
    default:
      return WriteIf(depth);
  }
}

void TaskWriter::WriteLet() {
  const Type type = expressions_.RandomType();
  const Unit unit = UnitFor(type);
  const Readable let{NewName("l"), type, unit};
  Line(fmt::format("let {} = {}", let.name, expressions_.OfType(type, unit)));
  readable_.push_back(let);
}

void TaskWriter::WritePast() {
  const Readable& of = readable_[random_.Below(past_)];
  if ((!IsScalar(of.type) && !IsRow(of.type)) || HasVectors(of.type)) return WriteLet();
  struct Form {
    std::string_view text;
    bool is_condition = false;
  };
  const bool is_condition = IsBool(of.type);
  std::vector<Form> forms = {{"previous({})", is_condition}, {"delay({}, 2)", is_condition}};
  if (is_condition) {
    forms.insert(
        forms.end(),
        {Form{"held({}, 8 ms)", true}, {"since({})"}, {"rising({})", true}, {"falling({})", true}});
  } else {
    forms.insert(forms.end(), {Form{"change({})"}, {"rate({})"}, {"smooth({}, 6 ms)"}});
  }
  const Form form = forms[random_.Below(forms.size())];
  std::string number = fmt::format(fmt::runtime(form.text), of.name);
  if (!IsScalar(of.type))
    number = fmt::format("{}({})", form.is_condition ? "count" : "sum", number);
  else if (form.is_condition)
    number = fmt::format("select({}, 1, 0)", number);
  Line(fmt::format("log {} = {}", NewName("past"), number));
}

void TaskWriter::WriteTable() {
  const Readable& table = random_.OneOf(tables_);
  const std::string argument = random_.OneOf(
      {readable_[2].name, std::string("0.7"), fmt::format("3 * {}", readable_[2].name)});
  const std::string unit = IsPlain(table.unit) ? "" : " * 1" + UnitOfLiteral(table.unit);
  std::string value =
      fmt::format("{}({}{}{})", table.name, argument, unit, random_.OneOf({"", ", loop"}));
  if (IsOfQuaternions(table.type)) {
    value = IsScalar(table.type) || table.type.shape == Shape::kQuaternion
                ? value + ".z"
                : fmt::format("sum({}[1, 2].x)", value);
  } else if (!IsScalar(table.type)) {
    value = fmt::format("norm({})", value);
  }
  Line(fmt::format("log {} = {}", NewName("looked"),
                   random_.OneIn(3) ? fmt::format("previous({})", value) : value));
}

void TaskWriter::WriteAssignment() {
  const Readable& target = random_.OneOf(memory_);
  const Type& type = target.type;
  const bool is_of_numbers = !IsBool(type) && !IsOfQuaternions(type);
  const bool is_scaled = is_of_numbers && random_.OneIn(4);
  std::string op = "=";
  if (is_scaled) {
    op = type.scalar == Scalar::kReal ? random_.OneOf({"*=", "/="}) : "*=";
  } else if (is_of_numbers) {
    op = random_.OneOf({"=", "+=", "-="});
  }
  const Type element = ScalarType(type.scalar);
  const Type value = !IsBool(type) && (is_scaled || random_.OneIn(4)) && op != "=" ? element : type;
  std::string text = expressions_.OfType(value, is_scaled ? Unit{} : target.unit);
  // A divisor must not be a constant: it might be 0.
  if (op == "/=") text = fmt::format("({} + {})", text, readable_[2].name);
  Line(fmt::format("{} {} {}", target.name, op, text));
}

void TaskWriter::WriteElementAssignment() {
  const Readable& target = random_.OneOf(memory_);
  const Type& type = target.type;
  if (IsScalar(type) || IsOfQuaternions(type)) return WriteAssignment();
  const bool is_matrix = type.shape == Shape::kMatrix;
  const uint32_t length = is_matrix ? type.columns : type.rows;
  const uint32_t count = 1 + random_.Below(length);
  const uint32_t first = random_.Below(length - count + 1);
  std::string place = fmt::format("{}..{}", first, first + count - 1);
  if (is_matrix) place = fmt::format("{}, {}", random_.Below(type.rows), place);
  const Type element = ScalarType(type.scalar);
  const Type value = random_.OneIn(2) ? element : ElementsType(type, count);
  const bool is_readable = IsScalar(value) || value.shape != Shape::kArray;
  const std::string op = IsBool(type) ? "=" : random_.OneOf({"=", "+=", "-="});
  if (HasVectors(type) && random_.OneIn(2)) {
    return Line(fmt::format("{}[{}].{} {} {}", target.name, place, random_.OneOf({"x", "yx"}), op,
                            expressions_.OfType(element, target.unit)));
  }
  Line(fmt::format("{}[{}] {} {}", target.name, place, op,
                   expressions_.OfType(is_readable ? value : element, target.unit)));
}

void TaskWriter::WriteLog() {
  // One curve: always the same unit and reduction.
  struct Log {
    const char* head;
    Unit unit;
  };
  const Log log = random_.OneOf({Log{"log curve1", {}}, Log{"log max curve2", {.meter = 1}},
                                 Log{"log mean curve3", {.radian = 1}}});
  Line(fmt::format("{} = {}", log.head, expressions_.OfType(ScalarType(Scalar::kReal), log.unit)));
}

void TaskWriter::WriteFor(int depth) {
  const std::string variable = NewName("i");
  Line(fmt::format("for {} in {} {{", variable,
                   random_.OneOf({"0..2", "1", "{0, 2} + 1", "few", "most - 1", "fewer, 0"})));
  const size_t outside = readable_.size();
  for (size_t i = 0; i < outside; ++i) {
    const Readable whole = readable_[i];
    const bool has_element =
        whole.type.shape == Shape::kArray && whole.type.rows > 2 && !whole.is_constant;
    if (!has_element || random_.OneIn(2)) continue;
    readable_.push_back(
        {fmt::format("{}[{}]", whole.name, variable), EntryOf(whole.type), whole.unit});
  }
  readable_.push_back(
      {fmt::format("({} + {})", variable, readable_[1].name), ScalarType(Scalar::kInt), {}});
  WriteBlock(1 + random_.Below(3), depth - 1);
  readable_.resize(outside);
  Line("}");
}

void TaskWriter::WriteReward() {
  const std::string value =
      expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit());
  if (random_.OneIn(5)) {
    return Line(fmt::format("reward {} {}", random_.OneOf({"+=", "-="}),
                            expressions_.OfType(ScalarType(Scalar::kReal), {})));
  }
  Line(fmt::format("reward {}{} = {}", IsStep() && random_.OneIn(2) ? "rate " : "",
                   fmt::format("t{}", random_.Below(4)), value));
}

void TaskWriter::WriteEnd() {
  if (event_ == EventKind::kEndOfEpisode) return WriteReward();
  Line(
      fmt::format("{} \"{}\"",
                  random_.OneOf({"end_episode success", "end_episode failure", "truncate_episode"}),
                  NewName("reason")));
}

void TaskWriter::WriteIf(int depth) {
  Line(fmt::format("if {} {{", Condition()));
  WriteBlock(1 + random_.Below(3), depth - 1);
  if (random_.OneIn(3)) {
    Line(fmt::format("}} else if {} {{", Condition()));
    WriteBlock(1 + random_.Below(3), depth - 1);
  }
  if (random_.OneIn(2)) {
    Line("} else {");
    WriteBlock(1 + random_.Below(3), depth - 1);
  }
  Line("}");
}

}  // namespace compiler
