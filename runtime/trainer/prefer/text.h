#pragma once

#include <string>

#include "runtime/analysis/study/preference_fit.h"

namespace runtime {

// The outcome of a user's preferences in words and tables, for a terminal or a pipe.
std::string PreferenceText(const PreferenceFit& fit);

// The name of a run, or of one of its episodes, without that of its experiment.
std::string ShortName(const BehaviorName& behavior, const ExperimentResult& result);

// A number as a person reads it: four digits; "-" for none.
std::string NumberText(double value);

}  // namespace runtime
