#include "tests/compiler/random/random_task.h"

#include <fmt/format.h>

#include <vector>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/syntax/words.h"
#include "tests/compiler/random/random_expression.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {
namespace {

class TaskWriter {
 public:
  explicit TaskWriter(uint32_t seed) : random_(seed), expressions_(random_, readable_, callable_) {}

  std::string Write() {
    text_ = "task random\n";
    // Else an early end would leave little to compare.
    if (!random_.OneIn(3)) Line("after_end continue");
    DeclareSensors();
    DeclareConsts();
    DeclareParams();
    DeclareMemory();
    for (int i = 0; i < 4; ++i) DeclareGoal();
    if (random_.OneIn(2)) NamePhases();
    past_ = readable_.size();
    DeclareTables();
    DeclarePotentials();
    for (int i = 0; i < 4; ++i) DeclareFunction();
    for (int i = 0; i < 2; ++i) DeclareOpenFunction();
    DeclareMetrics();
    DeclareObservations();
    for (const auto& event : kEventNames) {
      if (random_.OneIn(2)) WriteEvent(event.text, event.meaning);
    }
    for (const std::string& phase : phases_) WritePhase(phase);
    return text_;
  }

  std::string WriteStart() {
    text_ = "task random for humanoid\n";
    for (const char* type : kTypes) DeclareInsteadOfSensor(type);
    DeclareConsts();
    DeclareParams();
    DeclareMemory();
    for (int i = 0; i < 2; ++i) DeclareGoal();
    for (int i = 0; i < 2; ++i) DeclareFunction();
    Line(fmt::format("start {} {{", random_.OneOf({"standing", "standing or lying",
                                                   "lying or sitting or standing"})));
    WriteStartBlock(4 + random_.Below(6), 2);
    Line("}");
    return text_;
  }

 private:
  void Line(const std::string& line) { text_ += std::string(indent_ * 2, ' ') + line + "\n"; }
  bool IsStep() const { return event_ >= EventKind::kStartOfTimeStep; }
  std::string NewName(std::string_view kind) { return fmt::format("{}{}", kind, ++names_); }

  static constexpr const char* kTypes[] = {
      "bool",    "int",     "real",    "vec2",     "vec3",    "vec4",    "mat3",     "quat",
      "bool[2]", "bool[3]", "bool[5]", "bool[40]", "int[2]",  "int[3]",  "int[5]",   "int[40]",
      "real[2]", "real[3]", "real[5]", "real[40]", "vec2[3]", "vec3[2]", "vec3[18]", "quat[3]"};

  // A task for a robot has no sensors of its own.
  void DeclareInsteadOfSensor(const std::string& type_name) {
    const std::string name = NewName("s");
    const Type type = TypeOf(type_name);
    Line(fmt::format("memory {}: {} = {} per run", name, type_name, ConstantOf(type, {})));
    readable_.push_back({name, type, {}});
  }

  // One of each type in plain numbers, so that everything can be made; then some with units.
  void DeclareSensors() {
    for (const char* type : kTypes) DeclareSensor(type, {});
    for (int i = 0; i < 6; ++i) {
      DeclareSensor(
          random_.OneOf({"real", "real", "vec2", "vec3", "vec4", "mat3", "real[5]", "vec3[18]"}),
          expressions_.RandomUnit());
    }
  }

  void DeclareSensor(const std::string& type_name, const Unit& unit) {
    const std::string name = NewName("s");
    const Type type = TypeOf(type_name);
    Line(fmt::format("sensor {}: {}", name, TypeText(type, unit)));
    readable_.push_back({name, type, unit});
  }

  // Sets and numbers for loops, and consts with a shape.
  void DeclareConsts() {
    Line("const most: int = 2");
    Line("set few = {0, most} + 1");
    Line("set fewer = few - 0");
    for (const char* name : {"vec3", "vec4", "mat3", "real[5]", "real[40]", "int[3]", "bool[5]"}) {
      DeclareConst(TypeOf(name), {});
      DeclareConst(TypeOf(name), UnitFor(TypeOf(name)));
    }
    readable_.insert(readable_.end(), consts_.begin(), consts_.end());
  }

  void DeclareConst(const Type& type, const Unit& unit) {
    consts_.push_back({NewName("c"), type, unit, true});
    const std::string one = ConstantOf(ScalarType(type.scalar), unit);
    const bool is_vec3 = type.shape == Shape::kVector && type.rows == 3;
    Line(fmt::format("const {}: {} = {}", consts_.back().name, TypeText(type, unit),
                     is_vec3 ? fmt::format("vec3({0}, 2 * {0}, -({0}))", one) : one));
  }

  static Type TypeOf(const std::string& name) {
    const std::string element = name.substr(0, name.find('['));
    const Type type = *FindType(element);
    if (element == name) return type;
    return ArrayOf(type, static_cast<uint32_t>(std::stoi(name.substr(element.size() + 1))));
  }

  void DeclareParams() {
    for (int i = 0; i < 3; ++i) {
      const Type type =
          ScalarType(random_.OneOf({Scalar::kBool, Scalar::kInt, Scalar::kReal, Scalar::kReal}));
      const Unit unit = type.scalar == Scalar::kReal ? expressions_.RandomUnit() : Unit{};
      params_.push_back({NewName("p"), type, unit});
      Line(fmt::format("param {}: {} = {}", params_.back().name, TypeText(type, unit),
                       ConstantOf(type, unit)));
    }
    readable_.insert(readable_.end(), params_.begin(), params_.end());
  }

  std::string ConstantOf(const Type& type, const Unit& unit) {
    if (IsBool(type)) return random_.OneOf({"true", "false"});
    if (type.scalar == Scalar::kInt) return std::to_string(int(random_.Below(20)) - 10);
    return random_.OneOf({"0.5", "-2.0", "1e3"}) + UnitOfLiteral(unit);
  }

  void DeclareMemory() {
    for (int i = 0; i < 8; ++i) {
      const Type type = expressions_.RandomType();
      const Unit unit = UnitFor(type);
      memory_.push_back({NewName("v"), type, unit});
      Line(fmt::format("memory {}: {} = {}{}", memory_.back().name, TypeText(type, unit),
                       InitialValue(type, unit),
                       random_.OneOf({"", " per action", " per run", " per episode"})));
    }
    readable_.insert(readable_.end(), memory_.begin(), memory_.end());
  }

  std::string InitialValue(const Type& type, const Unit& unit) {
    for (const Readable& param : params_) {
      const bool fits = param.type.scalar == type.scalar && param.unit == unit;
      if (fits && random_.OneIn(2)) return param.name;
    }
    return ConstantOf(type, unit);
  }

  // Of files in tests/compiler/check/tables. Expressions call them through a function, which with
  // constant arguments is no constant, and so may be divided by.
  void DeclareTables() {
    AddTable("real", "curve.csv", {}, {});
    AddTable("real[5]", "five.csv", {}, {});
    AddTable("vec3", "place.csv", {.second = 1}, {.meter = 1});
    AddTable("quat", "turn.csv", {.second = 1}, {});
    AddTable("quat[3]", "turns.csv", {}, {});
  }

  void AddTable(const std::string& type_name, const std::string& file, const Unit& argument,
                const Unit& unit) {
    const Type type = TypeOf(type_name);
    const std::string table = NewName("table");
    Line(fmt::format("table {}: {} = \"{}\"", table, TypeText(type, unit), file));
    Callable function{
        NewName("f"), type, unit, {{NewName("a"), ScalarType(Scalar::kReal), argument}}};
    const std::string& name = function.arguments.front().name;
    Line(fmt::format("fn {}({}: {}) -> {} = {}({}{})", function.name, name,
                     TypeText(ScalarType(Scalar::kReal), argument), TypeText(type, unit), table,
                     name, random_.OneOf({"", ", loop"})));
    callable_.push_back(function);
    tables_.push_back({table, type, argument});
  }

  // Of the type of a memory, so that it can be chosen from that.
  void DeclareGoal() {
    const Readable& model = memory_[random_.Below(memory_.size())];
    const bool is_row = IsScalar(model.type) || IsRow(model.type);
    const bool is_real =
        model.type.scalar == Scalar::kReal && is_row && !IsOfQuaternions(model.type);
    const std::string constant = ConstantOf(model.type, model.unit);
    const std::string number = IsScalar(model.type) ? model.name : constant;
    std::string value = fmt::format("choose({}, {})", model.name, model.name);
    if (IsScalar(model.type))
      value = fmt::format("choose({}, {}, {})", model.name, constant, model.name);
    if (is_real && random_.OneIn(2)) value = fmt::format("uniform({}, {})", constant, number);
    if (is_real && random_.OneIn(2))
      value += fmt::format(" + normal({}, 0.5{})", number, UnitOfLiteral(model.unit));
    goals_.push_back({NewName("g"), model.type, model.unit});
    Line(fmt::format("goal {}: {} = {}{}", goals_.back().name, TypeText(model.type, model.unit),
                     value,
                     random_.OneOf({"", " per episode", " per 7 ms", " per 3 ms .. 12 ms"})));
    readable_.push_back(goals_.back());
  }

  // Their names, which may be read before the phases are written.
  void NamePhases() {
    const uint32_t count = 1 + random_.Below(4);
    for (uint32_t i = 0; i < count; ++i) {
      phases_.push_back(NewName("phase"));
      readable_.push_back(
          {fmt::format("(phase == {})", phases_.back()), ScalarType(Scalar::kBool), {}});
    }
    readable_.push_back({"phase_time", ScalarType(Scalar::kReal), {.second = 1}});
  }

  void DeclarePotentials() {
    for (const char* name : {"t4", "t5"}) {
      if (random_.OneIn(3)) continue;
      Line(fmt::format("reward potential {} = {}", name,
                       expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit())));
    }
  }

  // A function reads nothing but its arguments and consts; it may call those before it.
  void DeclareFunction() {
    std::vector<Readable> inside;
    for (Scalar scalar : {Scalar::kBool, Scalar::kInt, Scalar::kReal}) {
      inside.push_back({NewName("a"), ScalarType(scalar), {}});
    }
    for (int i = 0; i < 2; ++i) {
      const Type type = expressions_.RandomType();
      inside.push_back({NewName("a"), type, UnitFor(type)});
      // Of each type there must be something plain.
      inside.push_back({NewName("a"), type, {}});
    }
    Callable function{NewName("f"), inside[random_.Below(inside.size())].type, {}, inside};
    function.unit = UnitFor(function.type);
    inside.insert(inside.end(), consts_.begin(), consts_.end());
    RandomExpressions expressions(random_, inside, callable_);
    std::string parameters;
    for (const Readable& argument : function.arguments) {
      parameters += fmt::format("{}{}: {}", parameters.empty() ? "" : ", ", argument.name,
                                TypeText(argument.type, argument.unit));
    }
    const std::string header = fmt::format("fn {}({}) -> {}", function.name, parameters,
                                           TypeText(function.type, function.unit));
    if (random_.OneIn(2)) {
      Line(header + " = " + expressions.OfType(function.type, function.unit));
    } else {
      Line(header + " {");
      for (int i = 0; i < 2; ++i) {
        const Type type = expressions.RandomType();
        const Readable let{NewName("l"), type, UnitFor(type)};
        Line(fmt::format("  let {} = {}", let.name, expressions.OfType(type, let.unit)));
        inside.push_back(let);
      }
      Line("  return " + expressions.OfType(function.type, function.unit));
      Line("}");
    }
    callable_.push_back(function);
  }

  // Of numbers of any unit, to be applied to rows as well.
  void DeclareOpenFunction() {
    const Type real = ScalarType(Scalar::kReal);
    const std::string a = NewName("a");
    const std::string b = NewName("a");
    const Readable plain{NewName("a"), real, {}};
    const Readable condition{NewName("a"), ScalarType(Scalar::kBool), {}};
    const Readable whole{NewName("l"), ScalarType(Scalar::kInt), {}};
    // What divides must not be a constant.
    const std::vector<Readable> inside = {condition, whole, plain};
    RandomExpressions expressions(random_, inside, no_callable_);
    Callable function{NewName("f"), real, {}, {}, true};
    Line(
        fmt::format("fn {}({}: real [unit], {}: real [unit], {}: real, {}: bool) -> real [unit] {{",
                    function.name, a, b, plain.name, condition.name));
    Line(fmt::format("  let {} = count({})", whole.name, condition.name));
    Line(fmt::format("  let turn = {}", expressions.OfType(real, {})));
    Line(fmt::format("  return {} * turn + select({}, {}, max({}, -{}))", a,
                     expressions.OfType(ScalarType(Scalar::kBool), {}), b, a, b));
    Line("}");
    callable_.push_back(function);
  }

  Unit UnitFor(const Type& type) {
    const bool has_unit = type.scalar == Scalar::kReal && !IsOfQuaternions(type);
    return has_unit ? expressions_.RandomUnit() : Unit{};
  }

  void DeclareMetrics() {
    for (int i = 0; i < 2; ++i) {
      Line(fmt::format("metric {} = {}", NewName("metric"),
                       expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit())));
    }
  }

  // Of any type; functions of the past among them.
  void DeclareObservations() {
    for (int i = 0; i < 3; ++i) {
      const Type type = expressions_.RandomType();
      Line(fmt::format("observe {} = {}", NewName("o"), expressions_.OfType(type, UnitFor(type))));
    }
    Line(fmt::format("observe {}", random_.OneOf(goals_).name));
    Line(fmt::format("observe previous({})", random_.OneOf(memory_).name));
    if (!phases_.empty()) Line("observe phase");
  }

  void WritePhase(const std::string& name) {
    const std::string limit =
        random_.OneIn(2) ? fmt::format(" within {} else {}", random_.OneOf({"7 ms", "20 ms"}),
                                       random_.OneOf(phases_))
                         : "";
    is_in_phase_ = true;
    WriteTopBlock(fmt::format("phase {}{}", name, limit), EventKind::kEndOfTimeStep);
    is_in_phase_ = false;
  }

  void WriteStartBlock(uint32_t statements, int depth) {
    ++indent_;
    const size_t outside = readable_.size();
    for (uint32_t i = 0; i < statements; ++i) WriteStartStatement(depth);
    readable_.resize(outside);
    --indent_;
  }

  void WriteStartStatement(int depth) {
    switch (random_.Below(depth > 0 ? 6 : 4)) {
      case 0:
        return WriteLet();
      case 4:
        Line(fmt::format("if {} {{", Condition()));
        WriteStartBlock(1 + random_.Below(2), depth - 1);
        return Line("}");
      case 5:
        Line(fmt::format("for {} in 0..1 {{", NewName("i")));
        WriteStartBlock(1 + random_.Below(2), depth - 1);
        return Line("}");
      default:
        return WriteStartAssignment();
    }
  }

  void WriteStartAssignment() {
    struct Target {
      const char* name;
      Unit unit;
    };
    const Unit speed{.meter = 1, .second = -1};
    const Unit turn{.second = -1, .radian = 1};
    const Target target = random_.OneOf(
        {Target{"joint.angle", {.radian = 1}}, Target{"joint.angle[3..7]", {.radian = 1}},
         Target{"joint.velocity[legs]", turn}, Target{"base.position", {.meter = 1}},
         Target{"base.position.z", {.meter = 1}}, Target{"base.yaw", {.radian = 1}},
         Target{"base.velocity.xy", speed}, Target{"base.angular_velocity", turn}});
    std::string value = expressions_.OfType(ScalarType(Scalar::kReal), target.unit);
    const std::string other = expressions_.OfType(ScalarType(Scalar::kReal), target.unit);
    if (random_.OneIn(2)) value = fmt::format("uniform({0}, {0} + abs({1}))", value, other);
    if (random_.OneIn(4)) value = fmt::format("normal({}, abs({}))", value, other);
    if (random_.OneIn(4)) value = fmt::format("choose({0}, {1}, {0})", value, other);
    Line(fmt::format("{} {} {}", target.name, random_.OneOf({"=", "+=", "-="}), value));
  }

  void WriteEvent(std::string_view name, EventKind event) {
    WriteTopBlock(fmt::format("on {}", name), event);
  }

  void WriteTopBlock(const std::string& head, EventKind event) {
    event_ = event;
    const size_t outside = readable_.size();
    readable_.push_back({"reward", ScalarType(Scalar::kReal), {}});
    if (IsStep()) readable_.push_back({"time_step", ScalarType(Scalar::kReal), {.second = 1}});
    Line(head + " {");
    WriteBlock(4 + random_.Below(8), 2);
    Line("}");
    readable_.resize(outside);
  }

  void WriteBlock(uint32_t statements, int depth) {
    ++indent_;
    const size_t outside = readable_.size();
    for (uint32_t i = 0; i < statements; ++i) WriteStatement(depth);
    readable_.resize(outside);
    --indent_;
  }

  void WriteStatement(int depth) {
    if (is_in_phase_ && random_.OneIn(6))
      return Line(fmt::format("next {}", random_.OneOf(phases_)));
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

  std::string Condition() { return expressions_.OfType(ScalarType(Scalar::kBool), {}); }

  void WriteLet() {
    const Type type = expressions_.RandomType();
    const Unit unit = UnitFor(type);
    const Readable let{NewName("l"), type, unit};
    Line(fmt::format("let {} = {}", let.name, expressions_.OfType(type, unit)));
    readable_.push_back(let);
  }

  // What a declared value was, or how it changes.
  void WritePast() {
    const Readable& of = readable_[random_.Below(past_)];
    if ((!IsScalar(of.type) && !IsRow(of.type)) || HasVectors(of.type)) return WriteLet();
    struct Form {
      std::string_view text;
      bool is_condition = false;
    };
    const bool is_condition = IsBool(of.type);
    std::vector<Form> forms = {{"previous({})", is_condition}, {"delay({}, 2)", is_condition}};
    if (is_condition) {
      forms.insert(forms.end(), {Form{"held({}, 8 ms)", true},
                                 {"since({})"},
                                 {"rising({})", true},
                                 {"falling({})", true}});
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

  // What a table says for a sensor or a constant: directly, and a step ago.
  void WriteTable() {
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

  void WriteAssignment() {
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
    const Type value =
        !IsBool(type) && (is_scaled || random_.OneIn(4)) && op != "=" ? element : type;
    std::string text = expressions_.OfType(value, is_scaled ? Unit{} : target.unit);
    // A divisor must not be a constant: it might be 0.
    if (op == "/=") text = fmt::format("({} + {})", text, readable_[2].name);
    Line(fmt::format("{} {} {}", target.name, op, text));
  }

  // Some neighboring elements: to a scalar, or to as many elements.
  void WriteElementAssignment() {
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

  void WriteLog() {
    // One curve: always the same unit and reduction.
    struct Log {
      const char* head;
      Unit unit;
    };
    const Log log = random_.OneOf({Log{"log curve1", {}}, Log{"log max curve2", {.meter = 1}},
                                   Log{"log mean curve3", {.radian = 1}}});
    Line(
        fmt::format("{} = {}", log.head, expressions_.OfType(ScalarType(Scalar::kReal), log.unit)));
  }

  // The loop's variable is a constant. What is computed with it is not: it has a sensor in it.
  void WriteFor(int depth) {
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

  void WriteReward() {
    const std::string value =
        expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit());
    if (random_.OneIn(5)) {
      return Line(fmt::format("reward {} {}", random_.OneOf({"+=", "-="}),
                              expressions_.OfType(ScalarType(Scalar::kReal), {})));
    }
    Line(fmt::format("reward {}{} = {}", IsStep() && random_.OneIn(2) ? "rate " : "",
                     fmt::format("t{}", random_.Below(4)), value));
  }

  void WriteEnd() {
    if (event_ == EventKind::kEndOfEpisode) return WriteReward();
    Line(fmt::format(
        "{} \"{}\"",
        random_.OneOf({"end_episode success", "end_episode failure", "truncate_episode"}),
        NewName("reason")));
  }

  void WriteIf(int depth) {
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

  RandomNumbers random_;
  std::vector<Readable> readable_;
  std::vector<Callable> callable_;
  const std::vector<Callable> no_callable_{};
  std::vector<Readable> consts_;
  std::vector<Readable> params_;
  std::vector<Readable> memory_;
  std::vector<Readable> goals_;
  std::vector<Readable> tables_;  // with the units of their arguments
  std::vector<std::string> phases_;
  RandomExpressions expressions_;
  std::string text_;
  size_t past_ = 0;  // as many of `readable_` are declared
  size_t indent_ = 0;
  int names_ = 0;
  EventKind event_{};
  bool is_in_phase_ = false;
};

}  // namespace

std::string RandomTask(uint32_t seed) { return TaskWriter(seed).Write(); }
std::string RandomStart(uint32_t seed) { return TaskWriter(seed).WriteStart(); }

}  // namespace compiler
