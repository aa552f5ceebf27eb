#include "runtime/training/run/timeline_recorder.h"

#include <algorithm>
#include <limits>
#include <span>

#include "runtime/training/run/timeline.h"

namespace runtime {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// What was paid from sample to sample, of what was paid from the start on.
class Payments {
 public:
  float Next(double sum) {
    const double paid = sum - last_;
    last_ = sum;
    return static_cast<float>(paid);
  }

 private:
  double last_ = 0;
};

}  // namespace

TimelineRecorder::TimelineRecorder(int pose_count, size_t most_frames)
    : most_frames_(most_frames),
      contact_bytes_(ContactBytes(static_cast<size_t>(pose_count))),
      contacts_((most_frames + 1) * contact_bytes_) {}

bool TimelineRecorder::IsOf(const UniversalTask& task) const {
  return task.instance().id() == task_;
}

void TimelineRecorder::StartEpisode(const UniversalTask& task) {
  const taskc_plugin& table = task.plugin();
  task_ = task.instance().id();
  terms_ = table.term_count;
  metrics_ = table.metric_count;
  phases_ = table.phase_count;
  width_ = 1 + terms_ + metrics_ + (phases_ > 0 ? 1 : 0);
  const size_t size = (most_frames_ + 1) * width_;
  if (values_.size() < size) values_.resize(size);
  is_whole_ = true;
}

void TimelineRecorder::Note(size_t frame, const EpisodeModules& modules) {
  UniversalTask& task = *modules.tasks.active;
  if (!IsOf(task)) is_whole_ = false;
  if (!is_whole_) return;
  double* value = Row(frame);
  *value++ = modules.learner.episode_return();
  value = std::ranges::copy(task.term_sums(), value).out;
  if (modules.environment.time() > 0) {
    const Environment::Peek peek(modules.environment);
    const std::span<const double> measured = task.MeasureNow();
    for (size_t i = 0; i < metrics_; ++i) {
      const bool is_sum = task.plugin().metrics[i].reduction == TASKC_SUM;
      *value++ = is_sum ? task.metrics()[i] : measured[i];
    }
  } else {
    value = std::fill_n(value, metrics_, kNone);
  }
  if (phases_ > 0) *value = static_cast<double>(task.instance().phases().present());
  modules.environment.CaptureContacts({Contacts(frame), contact_bytes_});
}

void TimelineRecorder::NoteEnd(const EpisodeModules& modules) {
  Note(most_frames_, modules);
  end_ = modules.environment.time();
}

void TimelineRecorder::Move(size_t from, size_t to) {
  std::copy_n(Row(from), width_, Row(to));
  std::copy_n(Contacts(from), contact_bytes_, Contacts(to));
}

std::string TimelineRecorder::Finish(size_t frames) const {
  if (!is_whole_) return "";
  Timeline timeline;
  timeline.end = end_;
  timeline.terms.resize(terms_);
  timeline.metrics.resize(metrics_);
  std::vector<Payments> payments(1 + terms_);
  for (size_t i = 0; i <= frames; ++i) {
    const size_t sample = i < frames ? i : most_frames_;
    const double* value = Row(sample);
    timeline.returns.push_back(payments[0].Next(*value++));
    for (size_t term = 0; term < terms_; ++term) {
      timeline.terms[term].push_back(payments[1 + term].Next(*value++));
    }
    for (std::vector<float>& metric : timeline.metrics) {
      metric.push_back(static_cast<float>(*value++));
    }
    if (phases_ > 0) timeline.phases.push_back(static_cast<float>(*value));
    const auto contacts = contacts_.begin() + static_cast<std::ptrdiff_t>(sample * contact_bytes_);
    timeline.contacts.insert(timeline.contacts.end(), contacts,
                             contacts + static_cast<std::ptrdiff_t>(contact_bytes_));
  }
  return PackTimeline(timeline);
}

}  // namespace runtime
