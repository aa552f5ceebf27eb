// Answers what clients ask of a folder of runs: which there are, and to start, pause, continue and
// stop them. Each run that is started here is trained by a worker of its own.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/live/control/request.h"
#include "runtime/live/server/descriptor.h"
#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/serve/courier.h"
#include "runtime/trainer/serve/run_list.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

// The commands that it takes, as docs/api.md lists them.
std::span<const CommandSpec> RunsCommands();

class RunsService : public RequestHandler, private SupervisorListener {
 public:
  // `jobs`: how many runs are trained at a time. `robots`: where tasks look for robots first; may
  // be empty. Throws UserError.
  RunsService(const std::filesystem::path& folder, int jobs, std::filesystem::path robots);
  ~RunsService() override;  // refuses what still waits

  std::span<const CommandSpec> commands() const override { return RunsCommands(); }
  void Handle(Request request, ReplyHandler reply) override;

  // Until a stop is requested and the workers have ended, after their current episodes. On the
  // thread that made this object: workers end with it.
  void Run(const StopRequest& stop);

 private:
  using Json = nlohmann::json;
  using Asked = std::pair<Request, ReplyHandler>;

  void Serve();
  Json Answer(const Request& request);
  Json List();
  Json Start(const Json& arguments);
  Json Continue(const Json& arguments);
  Json Stop(const Json& arguments);
  void CheckIsNotStarted(const std::string& name) const;
  std::vector<std::string> WordsFor(const RunProgress& run) const;

  void OnStart() override {}
  void OnLine(const RunProgress&, std::string_view) override {}
  void OnMessage(const RunProgress& run, std::string_view text) override;
  void OnStopping(bool at_once) override;

  const std::filesystem::path robots_;
  Courier courier_;
  RunList list_;
  std::map<std::string, std::vector<std::string>> first_words_;  // of runs that are to be made
  std::map<std::string, std::string> messages_;  // of those, what was said until they were runs
  Supervisor supervisor_;
  Descriptor wake_;  // can be read while somebody waits

  std::mutex mutex_;
  std::vector<Asked> asked_;  // guarded by mutex_
  bool has_ended_ = false;    // guarded by mutex_
};

}  // namespace runtime
