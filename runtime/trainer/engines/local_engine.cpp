#include "runtime/trainer/engines/engine.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

class LocalEngine : public Engine {
 public:
  explicit LocalEngine(int jobs) : jobs_(jobs) {}
  int Train(const StudyRuns& study, const OutputOptions& output) override {
    return TrainRuns(study.folder, study.runs, jobs_, output);
  }

 private:
  const int jobs_;
};

}  // namespace

std::unique_ptr<Engine> MakeLocalEngine(int jobs) { return std::make_unique<LocalEngine>(jobs); }

}  // namespace runtime
