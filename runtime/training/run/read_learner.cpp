#include "runtime/training/run/read_learner.h"

#include <map>
#include <string>
#include <string_view>

#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

constexpr std::string_view kCurveTable = "learner_curve";

// By their ids.
std::map<int64_t, CurveRecord> ReadCurves(const SqliteDatabase& database) {
  std::map<int64_t, CurveRecord> curves;
  if (!HasTable(database, kCurveTable)) return curves;
  TableReader row(database, kCurveTable, "id, name, unit, doc", "ORDER BY id");
  while (row.Next()) {
    curves[row.Whole(0, 1)] = CurveRecord{row.Name(1), row.Text(2), "", row.Text(3)};
  }
  return curves;
}

}  // namespace

std::vector<CurveRecord> ReadLearnerCurves(const SqliteDatabase& database) {
  std::vector<CurveRecord> curves;
  for (const auto& [id, curve] : ReadCurves(database)) curves.push_back(curve);
  return curves;
}

void ReadLearnerValues(const SqliteDatabase& database, std::vector<EpisodeRecord>& episodes) {
  const std::map<int64_t, CurveRecord> curves = ReadCurves(database);
  if (!HasTable(database, kCurveTable)) return;
  TableReader row(database, "learner_value", "episode, curve, value", "ORDER BY episode, curve");
  while (row.Next()) {
    const int64_t number = row.Whole(0, 1, static_cast<int64_t>(episodes.size()));
    const auto curve = curves.find(row.Whole(1, 1));
    if (curve == curves.end()) row.FailAt(1, "is of a curve that does not exist");
    episodes[static_cast<size_t>(number - 1)].learner.push_back({curve->second.name, row.Real(2)});
  }
}

}  // namespace runtime
