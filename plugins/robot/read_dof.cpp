#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

constexpr int kMostUnits = 100'000;  // of a net: for each of them an action has a weight

// `units`: of the net that `place` lays out.
void CheckUnits(const TomlValue& place, double units) {
  if (units <= kMostUnits) return;
  place.Fail(fmt::format("{} make {} basis functions", place.what(), units),
             fmt::format("a net has at most {}", kMostUnits));
}

// One coordinate: the joint that stands for it, then those that follow.
void ReadCoordinate(const TomlValue& value, const RobotDescription& robot, DofConfiguration& dof) {
  value.AllowKeys(KeysOf("coordinate"));
  const std::vector<std::string> joints = NamesOf(robot.joints);
  const int coordinate = dof.dof();
  const TomlValue own = value.At("joint");
  const int representative = own.IndexIn(joints, "joint");
  const auto couple = [&](const TomlValue& place, int joint, double factor) {
    for (const Coupling& coupling : dof.couplings) {
      if (coupling.joint != joint) continue;
      place.Fail(fmt::format("joint `{}` is driven twice in DoF configuration `{}`", joints[joint],
                             dof.name),
                 "let each joint follow one coordinate");
    }
    dof.couplings.push_back({joint, coordinate, factor});
  };
  couple(own, representative, 1);
  dof.representatives.push_back(representative);
  const auto also = value.Find("also");
  if (!also) return;
  for (const auto& [name, factor] : also->Entries()) {
    const std::optional<int> joint = robot.FindJoint(name);
    if (!joint) factor.Fail(fmt::format("there is no joint `{}`", name), SuggestName(name, joints));
    couple(factor, *joint, factor.Number());
  }
}

void ReadRange(const TomlValue& value, size_t dof, NetDescription& net) {
  const TomlValue low = value.At("low");
  const TomlValue high = value.At("high");
  net.low = low.Numbers(dof);
  net.high = high.Numbers(dof);
  for (size_t i = 0; i < dof; ++i) {
    if (net.low[i] < net.high[i]) continue;
    high.Items()[i].Fail(fmt::format("`high` of net `{}` is not above its `low`", net.name),
                         "give one `low` and one greater `high` for each coordinate");
  }
}

NetDescription ReadNet(const TomlValue& value, const RobotDescription& robot) {
  NetDescription net;
  net.name = value.At("name").Text();
  const TomlValue named = value.Called(fmt::format("net `{}`", net.name));
  const int dof_index =
      named.At("dof").IndexIn(NamesOf(robot.dof_configurations), "DoF configuration");
  const DofConfiguration& dof = robot.dof_configurations[dof_index];
  net.dof = dof.name;
  if (named.At("kind").IndexIn({"grid", "bubble"}, "kind") == 0) {
    named.AllowKeys(KeysOf("grid"));
    net.kind = NetKind::kGrid;
    const TomlValue counts = named.At("counts");
    counts.Numbers(dof.representatives.size());
    double units = 1;  // a product that an int may not hold
    for (const TomlValue& count : counts.Items()) {
      net.counts.push_back(count.Count());
      units *= net.counts.back();
    }
    CheckUnits(counts, units);
    if (const auto deviations = named.Find("deviations")) {
      deviations->Numbers(dof.representatives.size());
      for (const TomlValue& item : deviations->Items()) {
        net.deviations.push_back(item.PositiveNumber());
      }
    }
  } else {
    named.AllowKeys(KeysOf("bubble"));
    net.kind = NetKind::kBubble;
    const TomlValue units = named.At("units");
    net.units = units.Count();
    CheckUnits(units, net.units);
  }
  ReadRange(named, dof.representatives.size(), net);
  return net;
}

}  // namespace

std::vector<DofConfiguration> ReadDofConfigurations(const TomlValue& root,
                                                    const RobotDescription& robot) {
  std::vector<DofConfiguration> configurations;
  const auto list = root.Find("dof_configurations");
  if (!list) return configurations;
  for (const TomlValue& value : list->Items()) {
    value.AllowKeys(KeysOf("DoF configuration"));
    DofConfiguration dof;
    const TomlValue name = value.At("name");
    dof.name = name.Text();
    CheckIsNew(name, dof.name, "DoF configuration", configurations);
    const TomlValue coordinates =
        value.Called(fmt::format("DoF configuration `{}`", dof.name)).At("coordinates");
    for (const TomlValue& coordinate : coordinates.Items()) ReadCoordinate(coordinate, robot, dof);
    if (dof.dof() == 0) coordinates.Fail(coordinates.what() + " are missing", "add at least one");
    configurations.push_back(std::move(dof));
  }
  return configurations;
}

std::vector<NetDescription> ReadNets(const TomlValue& root, const RobotDescription& robot) {
  std::vector<NetDescription> nets;
  const auto list = root.Find("nets");
  if (!list) return nets;
  for (const TomlValue& value : list->Items()) {
    NetDescription net = ReadNet(value, robot);
    CheckIsNew(value.At("name"), net.name, "net", nets);
    nets.push_back(std::move(net));
  }
  return nets;
}

}  // namespace robot
