#include "runtime/analysis/preference/contradictions.h"

#include <map>
#include <set>

namespace runtime {
namespace {

// To each behavior, those that it is said to be at least as good as.
using Graph = std::map<BehaviorName, std::set<BehaviorName>>;

// Whether a way leads from one behavior to the other.
bool Leads(const Graph& graph, const BehaviorName& from, const BehaviorName& to) {
  std::set<BehaviorName> seen = {from};
  std::vector<BehaviorName> open = {from};
  while (!open.empty()) {
    const BehaviorName here = open.back();
    open.pop_back();
    if (here == to) return true;
    const auto found = graph.find(here);
    if (found == graph.end()) continue;
    for (const BehaviorName& next : found->second) {
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return false;
}

}  // namespace

std::vector<size_t> FindContradictions(const std::vector<Preference>& preferences) {
  Graph graph;
  for (const Preference& preference : preferences) {
    graph[preference.better].insert(preference.worse);
    if (preference.is_tie) graph[preference.worse].insert(preference.better);
  }
  std::vector<size_t> contradictory;
  for (size_t i = 0; i < preferences.size(); ++i) {
    const Preference& each = preferences[i];
    if (!each.is_tie && Leads(graph, each.worse, each.better)) contradictory.push_back(i);
  }
  return contradictory;
}

}  // namespace runtime
