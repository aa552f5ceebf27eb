// What the page shows of a run, as JSON (read by web/src/data/report_data.ts).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace runtime {

// Keys: run (texts by key), sources, agentText, modules, body, madeAt, episode, returns, endOf,
// ends, simulatedSeconds, wallSeconds, faults, violations, terms, metrics, logs, goals, recordings,
// notes.
// Series and poses are base64 (base64.h); a value that is not a number is NaN there. Throws
// UserError where there is no run, no episode yet, or the database cannot be read.
nlohmann::json CollectReportData(const std::filesystem::path& run_dir);

// The same without recordings and evaluations, for who follows the run from now on: also where
// there is no episode yet.
nlohmann::json CollectRecord(const std::filesystem::path& run_dir);

}  // namespace runtime
