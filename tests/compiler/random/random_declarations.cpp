#include "tests/compiler/random/random_task_writer.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {

void TaskWriter::DeclareSensors() {
  for (const char* type : kTypes) DeclareSensor(type, {});
  for (int i = 0; i < 6; ++i) {
    DeclareSensor(
        random_.OneOf({"real", "real", "vec2", "vec3", "vec4", "mat3", "real[5]", "vec3[18]"}),
        expressions_.RandomUnit());
  }
}

void TaskWriter::DeclareSensor(const std::string& type_name, const Unit& unit) {
  const std::string name = NewName("s");
  const Type type = TypeOf(type_name);
  Line(fmt::format("sensor {}: {}", name, DeclaredType(type, unit)));
  readable_.push_back({name, type, unit});
}

void TaskWriter::ReadRobot() {
  constexpr Unit kMeter{.meter = 1};
  constexpr Unit kSpeed{.meter = 1, .second = -1};
  constexpr Unit kAcceleration{.meter = 1, .second = -2};
  constexpr Unit kRate{.second = -1, .radian = 1};
  Line("set ends = {left_toe, right_heel} + hand_tips");
  Line("memory places: vec3[site] [m] = 0");
  const std::vector<Readable> values = {
      {"contact[feet]", TypeOf("bool[2]"), {}},
      {"joint.angle[0..4]", TypeOf("real[5]"), kRadianUnit},
      {"link.position[head]", TypeOf("vec3"), kMeter},
      {"places[toes]", TypeOf("vec3[2]"), kMeter},
      {"site.position[head_top]", TypeOf("vec3"), kMeter},
      {"site.position[hand_tips].xy", TypeOf("vec2[2]"), kMeter},
      {"site.velocity[heels]", TypeOf("vec3[2]"), kSpeed},
      {"norm(site.velocity[ends - left_toe])", TypeOf("real[3]"), kSpeed},
      {"site.angular_velocity[ends].z[0..2]", TypeOf("real[3]"), kRate},
      {"site.orientation[toes, head_top]", TypeOf("quat[3]"), {}},
      {"site.acceleration[left_toe]", TypeOf("vec3"), kAcceleration}};
  readable_.insert(readable_.end(), values.begin(), values.end());
}

void TaskWriter::DeclareConsts() {
  Line("const most: int = 2");
  Line("set few = {0, most} + 1");
  Line("set fewer = few - 0");
  for (const char* name : {"vec3", "vec4", "mat3", "real[5]", "real[40]", "int[3]", "bool[5]"}) {
    DeclareConst(TypeOf(name), {});
    DeclareConst(TypeOf(name), UnitFor(TypeOf(name)));
  }
  readable_.insert(readable_.end(), consts_.begin(), consts_.end());
}

void TaskWriter::DeclareConst(const Type& type, const Unit& unit) {
  consts_.push_back({NewName("c"), type, unit, true});
  const std::string one = ConstantOf(ScalarType(type.scalar), unit);
  const bool is_vec3 = type.shape == Shape::kVector && type.rows == 3;
  Line(fmt::format("const {}: {} = {}", consts_.back().name, DeclaredType(type, unit),
                   is_vec3 ? fmt::format("vec3({0}, 2 * {0}, -({0}))", one) : one));
}

Type TaskWriter::TypeOf(const std::string& name) {
  const std::string element = name.substr(0, name.find('['));
  const Type type = *FindType(element);
  if (element == name) return type;
  return ArrayOf(type, static_cast<uint32_t>(std::stoi(name.substr(element.size() + 1))));
}

void TaskWriter::DeclareParams() {
  for (int i = 0; i < 3; ++i) {
    const Type type =
        ScalarType(random_.OneOf({Scalar::kBool, Scalar::kInt, Scalar::kReal, Scalar::kReal}));
    const Unit unit = type.scalar == Scalar::kReal ? expressions_.RandomUnit() : Unit{};
    params_.push_back({NewName("p"), type, unit});
    Line(fmt::format("param {}: {} = {}", params_.back().name, DeclaredType(type, unit),
                     ConstantOf(type, unit)));
  }
  readable_.insert(readable_.end(), params_.begin(), params_.end());
}

std::string TaskWriter::ConstantOf(const Type& type, const Unit& unit) {
  if (IsBool(type)) return random_.OneOf({"true", "false"});
  if (type.scalar == Scalar::kInt) return std::to_string(int(random_.Below(20)) - 10);
  return random_.OneOf({"0.5", "-2.0", "1e3"}) + UnitOfLiteral(unit);
}

void TaskWriter::DeclareMemory() {
  for (int i = 0; i < 8; ++i) {
    const Type type = expressions_.RandomType();
    const Unit unit = UnitFor(type);
    memory_.push_back({NewName("v"), type, unit});
    Line(fmt::format("memory {}: {} = {}{}", memory_.back().name, DeclaredType(type, unit),
                     InitialValue(type, unit),
                     random_.OneOf({"", " per action", " per run", " per episode"})));
  }
  readable_.insert(readable_.end(), memory_.begin(), memory_.end());
}

std::string TaskWriter::InitialValue(const Type& type, const Unit& unit) {
  for (const Readable& param : params_) {
    const bool fits = param.type.scalar == type.scalar && param.unit == unit;
    if (fits && random_.OneIn(2)) return param.name;
  }
  return ConstantOf(type, unit);
}

void TaskWriter::DeclareTables() {
  AddTable("real", "curve.csv", {}, {});
  AddTable("real[5]", "five.csv", {}, {});
  AddTable("vec3", "place.csv", {.second = 1}, {.meter = 1});
  AddTable("quat", "turn.csv", {.second = 1}, {});
  AddTable("quat[3]", "turns.csv", {}, {});
}

void TaskWriter::AddTable(const std::string& type_name, const std::string& file,
                          const Unit& argument, const Unit& unit) {
  const Type type = TypeOf(type_name);
  const std::string table = NewName("table");
  Line(fmt::format("table {}: {} = \"{}\"", table, DeclaredType(type, unit), file));
  Callable function{
      NewName("f"), type, unit, {{NewName("a"), ScalarType(Scalar::kReal), argument}}};
  const std::string& name = function.arguments.front().name;
  Line(fmt::format("fn {}({}: {}) -> {} = {}({}{})", function.name, name,
                   DeclaredType(ScalarType(Scalar::kReal), argument), DeclaredType(type, unit),
                   table, name, random_.OneOf({"", ", loop"})));
  callable_.push_back(function);
  tables_.push_back({table, type, argument});
}

void TaskWriter::DeclareGoal() {
  const Readable& model = memory_[random_.Below(memory_.size())];
  const bool is_row = IsScalar(model.type) || IsRow(model.type);
  const bool is_real = model.type.scalar == Scalar::kReal && is_row && !IsOfQuaternions(model.type);
  const std::string constant = ConstantOf(model.type, model.unit);
  const std::string number = IsScalar(model.type) ? model.name : constant;
  std::string value = fmt::format("choose({}, {})", model.name, model.name);
  if (IsScalar(model.type))
    value = fmt::format("choose({}, {}, {})", model.name, constant, model.name);
  if (is_real && random_.OneIn(2)) value = fmt::format("uniform({}, {})", constant, number);
  if (is_real && random_.OneIn(2))
    value += fmt::format(" + normal({}, 0.5{})", number, UnitOfLiteral(model.unit));
  goals_.push_back({NewName("g"), model.type, model.unit});
  Line(fmt::format("goal {}: {} = {}{}", goals_.back().name, DeclaredType(model.type, model.unit),
                   value, random_.OneOf({"", " per episode", " per 7 ms", " per 3 ms .. 12 ms"})));
  readable_.push_back(goals_.back());
}

void TaskWriter::NamePhases() {
  const uint32_t count = 1 + random_.Below(4);
  for (uint32_t i = 0; i < count; ++i) {
    phases_.push_back(NewName("phase"));
    readable_.push_back(
        {fmt::format("(phase == {})", phases_.back()), ScalarType(Scalar::kBool), {}});
  }
  readable_.push_back({"phase_time", ScalarType(Scalar::kReal), {.second = 1}});
}

void TaskWriter::DeclarePotentials() {
  for (const char* name : {"t4", "t5"}) {
    if (random_.OneIn(3)) continue;
    Line(fmt::format("reward potential {} = {}", name,
                     expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit())));
  }
}

void TaskWriter::DeclareFunction() {
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
                              DeclaredType(argument.type, argument.unit));
  }
  const std::string header = fmt::format("fn {}({}) -> {}", function.name, parameters,
                                         DeclaredType(function.type, function.unit));
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

void TaskWriter::DeclareOpenFunction() {
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
  Line(fmt::format("fn {}({}: real [unit], {}: real [unit], {}: real, {}: bool) -> real [unit] {{",
                   function.name, a, b, plain.name, condition.name));
  Line(fmt::format("  let {} = count({})", whole.name, condition.name));
  Line(fmt::format("  let turn = {}", expressions.OfType(real, {})));
  Line(fmt::format("  return {} * turn + select({}, {}, max({}, -{}))", a,
                   expressions.OfType(ScalarType(Scalar::kBool), {}), b, a, b));
  Line("}");
  callable_.push_back(function);
}

Unit TaskWriter::UnitFor(const Type& type) {
  const bool has_unit = type.scalar == Scalar::kReal && !IsOfQuaternions(type);
  return has_unit ? expressions_.RandomUnit() : Unit{};
}

void TaskWriter::DeclareMetrics() {
  for (int i = 0; i < 2; ++i) {
    Line(fmt::format("metric {} = {}", NewName("metric"),
                     expressions_.OfType(ScalarType(Scalar::kReal), expressions_.RandomUnit())));
  }
}

void TaskWriter::DeclareObservations() {
  for (int i = 0; i < 3; ++i) {
    const Type type = expressions_.RandomType();
    Line(fmt::format("observe {} = {}", NewName("o"), expressions_.OfType(type, UnitFor(type))));
  }
  Line(fmt::format("observe {}", random_.OneOf(goals_).name));
  Line(fmt::format("observe previous({})", random_.OneOf(memory_).name));
  if (!phases_.empty()) Line("observe phase");
}

}  // namespace compiler
