#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "base/text/print.h"
#include "runtime/analysis/film/film.h"
#include "runtime/analysis/film/film_writer.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/results/recorded_episode.h"
#include "runtime/training/run/live_text.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/recorded_ground.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

struct VideoOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  int64_t episode = 0;  // 0: the last that was recorded
  FilmOptions film;
};

// How far it is and how long it will take, on a terminal.
class FilmProgress {
 public:
  explicit FilmProgress(int pictures) : pictures_(pictures), shown_(stderr) {}
  ~FilmProgress() { shown_.Erase(); }

  void Next() {
    ++done_;
    if (!shown_.is_on_terminal()) return;
    const std::chrono::duration<double> passed = Clock::now() - start_;
    const double left = passed.count() / done_ * (pictures_ - done_);
    shown_.Show(FittingLine({{fmt::format("picture {} of {}", done_, pictures_), 0},
                             {fmt::format("{} left", DurationText(left)), 1}},
                            shown_.columns()) +
                "\n");
  }

 private:
  using Clock = std::chrono::steady_clock;

  int pictures_;
  int done_ = 0;
  Clock::time_point start_ = Clock::now();
  LiveText shown_;
};

void Video(const VideoOptions& options) {
  const std::unique_ptr<FilmWriter> writer =
      MakeFilmWriter(options.output, options.film.size, Film::kPicturesPerSecond);
  const RunDatabase database = RunDatabase::OpenToRead(options.folder);
  const RunRecord run = database.ReadRun();
  const RecordedBody body = ReadBody(options.folder, run);
  const int64_t episode = ChooseRecordedEpisode(options.folder, database, options.episode);
  const Motion motion = ReadRecordedMotion(options.folder, database, episode, body.parts.size());
  CheckSpan(options.film.from, options.film.to, motion);
  FilmOptions settings = options.film;
  settings.things = body.things;
  settings.ground = GroundOf(run);
  const Film film(motion, body.parts, settings);
  {
    FilmProgress progress(film.picture_count());
    film.Draw([&](const Image& picture) {
      writer->Add(picture);
      progress.Next();
    });
  }
  WriteOutput(options.output, "the film", writer->Finish());
  text::Print("{}: episode {}, {} pictures, {:.2f} s\n", options.output.string(), episode,
              film.picture_count(),
              static_cast<double>(film.picture_count()) / Film::kPicturesPerSecond);
}

}  // namespace

void AddVideoCommand(command_line::Command& program) {
  const auto options = std::make_shared<VideoOptions>();
  command_line::Command& command = program.AddCommand(
      "video", "Draws a recorded episode as a film: MP4, WebM or an animated GIF.");
  command.AddOption("RUN", options->folder, "folder of the run").Required();
  command.AddOption("-o,--output", options->output, "file to write, *.mp4, *.webm or *.gif")
      .Required()
      .ValueName("FILE");
  command
      .AddOption("--episode", options->episode,
                 "number of a recorded episode; by default the last one")
      .Positive();
  command
      .AddOption("--speed", options->film.speed,
                 "of the motion: 0.5 shows it half as fast as it was")
      .ShowDefault()
      .Range(0.05, 20.0);
  command.AddOption("--size", options->film.size, "width and height, in pixels; made even")
      .ShowDefault()
      .Range(16, 2160);
  command.AddOption("--from", options->film.from, "time at which it begins, in seconds")
      .NonNegative();
  command.AddOption("--to", options->film.to, "time at which it ends, in seconds").NonNegative();
  command.OnRun([options] {
    options->film.size += options->film.size % 2;
    Video(*options);
    return kSuccess;
  });
}

}  // namespace runtime
