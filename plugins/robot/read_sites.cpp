#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

Site ReadSite(const TomlValue& value, const std::vector<std::string>& links,
              const std::vector<Site>& sites) {
  value.AllowKeys(KeysOf("site"));
  Site site;
  const TomlValue name = value.At("name");
  site.name = name.Name();
  CheckIsNew(name, site.name, "site", sites);
  const TomlValue named = value.Called(fmt::format("site `{}`", site.name));
  site.link = named.At("link").IndexIn(links, "link");
  site.position = named.At("position").ToVector3();
  if (const auto orientation = named.Find("orientation"))
    site.orientation = ReadOrientation(*orientation);
  return site;
}

}  // namespace

std::vector<Site> ReadSites(const TomlValue& root, const RobotDescription& robot) {
  std::vector<Site> sites;
  const auto list = root.Find("sites");
  if (!list) return sites;
  const std::vector<TomlValue> items = list->Items();
  if (items.size() > kMostSites) {
    list->Fail(fmt::format("the robot has {} sites, and {} is the most", items.size(), kMostSites),
               "leave out those that no task reads");
  }
  const std::vector<std::string> links = NamesOf(robot.links);
  for (const TomlValue& value : items) sites.push_back(ReadSite(value, links, sites));
  return sites;
}

}  // namespace robot
