#include "runtime/analysis/report/encoded_curves.h"

#include "runtime/analysis/report/base64.h"

namespace runtime {

nlohmann::json EncodeCurves(const std::vector<Curve>& curves) {
  nlohmann::json encoded = nlohmann::json::array();
  for (const auto& [record, tasks, values] : curves) {
    nlohmann::json indices = nlohmann::json::array();
    for (const int64_t task : tasks) indices.push_back(task - 1);
    encoded.push_back({{"name", record.name},
                       {"unit", record.unit},
                       {"reduction", record.reduction},
                       {"doc", record.doc},
                       {"tasks", indices},
                       {"values", EncodeFloats(std::vector<float>(values.begin(), values.end()))}});
  }
  return encoded;
}

}  // namespace runtime
