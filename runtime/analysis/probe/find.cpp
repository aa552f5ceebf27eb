#include "runtime/analysis/probe/find.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "plugins/robot/sensors.h"
#include "runtime/analysis/behavior/behavior.h"
#include "runtime/analysis/behavior/clustering.h"
#include "runtime/analysis/behavior/robot_scale.h"
#include "runtime/analysis/study/behavior_groups.h"
#include "runtime/base/user_error.h"
#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

// How many of the best finds of each search are looked at.
constexpr size_t kOfEachSearch = 6;

struct Candidate {
  Find find;
  Behavior behavior;
};

// What a robot's base can do, unless its simulation has gone astray.
struct BaseLimits {
  double speed = 0;   // along any axis of the world [m/s]
  double height = 0;  // [m]

  explicit BaseLimits(const robot::RobotDescription& robot) {
    for (const robot::Range& range : RangesOf(Sensor(robot::SensorId::kBaseVelocity), robot)) {
      speed = std::max({speed, range.high, -range.low});
    }
    height = RangesOf(Sensor(robot::SensorId::kBasePosition), robot).back().high;
  }

 private:
  static const robot::SensorDescription& Sensor(robot::SensorId id) {
    return robot::Sensors()[static_cast<size_t>(id)];
  }
};

std::vector<std::string> Beyond(const BaseLimits& limits, const MotionExtremes& extremes) {
  std::vector<std::string> beyond;
  if (extremes.speed > limits.speed) {
    beyond.push_back(fmt::format("a speed of {:.1f} m/s", extremes.speed));
  }
  if (extremes.height > limits.height) {
    beyond.push_back(fmt::format("a height of {:.1f} m", extremes.height));
  }
  return beyond;
}

// Reads the searches of a probe, one after the other.
class ProbeReader {
 public:
  explicit ProbeReader(const std::filesystem::path& folder) { results_.folder = folder.string(); }

  void Read(const std::filesystem::path& run) {
    const RunDatabase database = RunDatabase::OpenToRead(run);
    const auto [record, episodes] = database.ReadRunAndEpisodes();
    if (results_.searches++ == 0) ReadRobot(run, record);
    for (const EpisodeRecord& episode : episodes) {
      ++results_.episodes;
      results_.cpu_seconds += episode.cpu_seconds;
      if (episode.active.end_kind == EndKindName(EndKind::kDiverged)) ++results_.diverged;
    }
    size_t taken = 0;
    std::vector<RecordedEpisode> recorded = database.ReadRecordedEpisodes();
    std::ranges::reverse(recorded);
    for (const RecordedEpisode& each : recorded) {
      if (taken == kOfEachSearch) break;
      const auto recording = database.ReadRecording(each.number);
      if (!recording || !recording->is_best) continue;
      Find find;
      find.run = run.lexically_relative(results_.folder).string();
      find.seed = record.seed;
      find.agent = record.agent;
      find.episode = episodes[static_cast<size_t>(each.number - 1)];
      find.recording = *recording;
      AddCandidate(std::move(find));
      ++taken;
    }
  }

  ProbeResults Finish() {
    for (const AlikeGroup& group : Groups()) results_.finds.push_back(BestOf(group.members));
    std::ranges::stable_sort(results_.finds, [](const Find& a, const Find& b) {
      if (a.is_sound() != b.is_sound()) return a.is_sound();
      return a.episode.active.episode_return > b.episode.active.episode_return;
    });
    if (results_.finds.size() > ProbeResults::kMostFinds) {
      results_.left_out = results_.finds.size() - ProbeResults::kMostFinds;
      results_.finds.resize(ProbeResults::kMostFinds);
    }
    return std::move(results_);
  }

 private:
  void ReadRobot(const std::filesystem::path& run, const RunRecord& record) {
    results_.record = record;
    const RecordedBody body = ParseBody(record.body).value();
    part_count_ = static_cast<int>(body.parts.size());
    links_ = body.links();
    const robot::RobotDescription robot = ReadKeptRobot(run, record.robot_description);
    limits_.emplace(robot);
    if (!links_.empty()) scale_ = ScaleOf(robot);
  }

  void AddCandidate(Find find) {
    try {
      const Motion motion = OfLinks(ReadMotion(find.recording, part_count_), links_.size());
      find.extremes = ExtremesOf(motion);
      find.beyond = Beyond(*limits_, find.extremes);
      candidates_.push_back({std::move(find), DescribeBehavior(motion, links_, scale_)});
    } catch (const UserError& error) {
      results_.notes.push_back(fmt::format("The recording of episode {} of {} is left out: {}.",
                                           find.episode.number, find.run, error.what()));
    }
  }

  std::vector<AlikeGroup> Groups() const {
    const auto behavior = [this](int number) -> const Behavior& {
      return candidates_[static_cast<size_t>(number)].behavior;
    };
    const auto distance = [&](int a, int b) {
      return DistanceBetween(behavior(a), behavior(b)).total();
    };
    return GroupAlike(static_cast<int>(candidates_.size()), distance, kSameBehavior);
  }

  Find BestOf(const std::vector<int>& group) {
    std::set<std::string> searches;
    const Find* best = nullptr;
    for (const int member : group) {
      const Find& find = candidates_[static_cast<size_t>(member)].find;
      searches.insert(find.run);
      const bool is_better =
          best == nullptr || (find.is_sound() && !best->is_sound()) ||
          (find.is_sound() == best->is_sound() &&
           find.episode.active.episode_return > best->episode.active.episode_return);
      if (is_better) best = &find;
    }
    Find found = *best;
    found.searches = static_cast<int>(searches.size());
    return found;
  }

  ProbeResults results_;
  int part_count_ = 0;  // of the recordings
  std::vector<robot::Link> links_;
  std::optional<BaseLimits> limits_;
  double scale_ = 1;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::optional<double> Find::frequency() const {
  const auto found = std::ranges::find(episode.learner, "frequency", &NamedValue::name);
  if (found == episode.learner.end()) return std::nullopt;
  return found->value;
}

MotionExtremes ExtremesOf(const Motion& motion) {
  constexpr int kBase = 0;
  MotionExtremes extremes{0, motion.position(0, kBase).z()};
  for (int frame = 1; frame < motion.frame_count(); ++frame) {
    const Eigen::Vector3d& position = motion.position(frame, kBase);
    const double way = (position - motion.position(frame - 1, kBase)).norm();
    extremes.speed = std::max(extremes.speed, way / motion.frame_interval);
    extremes.height = std::max(extremes.height, position.z());
  }
  return extremes;
}

ProbeResults ReadProbe(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& runs) {
  ProbeReader reader(folder);
  for (const std::filesystem::path& run : runs) reader.Read(run);
  ProbeResults results = reader.Finish();
  if (results.episodes > 0) return results;
  throw UserError(fmt::format("{}: no search has finished an episode yet", folder.string()));
}

}  // namespace runtime
