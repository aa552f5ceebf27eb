#include "runtime/training/run/tape.h"

#include <bit>
#include <cstring>

#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/sqlite.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

static_assert(std::endian::native == std::endian::little, "tapes are little-endian");

constexpr uint64_t kFormat = 1;
constexpr size_t kWord = sizeof(double);
constexpr size_t kMostJoints = 10'000;
constexpr size_t kMostSteps = 1 << 24;

struct Header {
  uint64_t format = kFormat;
  uint64_t joints = 0;
  uint64_t steps = 0;
  uint64_t ends_at_once = 0;
  double discount = 1;
  uint64_t has_start = 0;
  uint64_t start_pose_size = 0;
};

void Append(std::string& bytes, const void* data, size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}
template <class Numbers>
void AppendNumbers(std::string& bytes, const Numbers& numbers) {
  Append(bytes, std::data(numbers), std::size(numbers) * sizeof(numbers[0]));
}

void AppendPose(std::string& bytes, const robot::Pose& pose) {
  AppendNumbers(bytes, pose.position);
  AppendNumbers(bytes, pose.orientation);
  AppendNumbers(bytes, pose.joint_angles);
}

void AppendStart(std::string& bytes, const robot::StartState& start) {
  AppendPose(bytes, start.pose);
  AppendPose(bytes, start.from);
  AppendNumbers(bytes, start.joint_velocities);
  AppendNumbers(bytes, start.velocity);
  AppendNumbers(bytes, start.angular_velocity);
}

void AppendTargets(std::string& bytes, const Tape& tape) {
  std::string column(tape.steps() * kWord, '\0');
  for (size_t joint = 0; joint < tape.joints; ++joint) {
    uint64_t last = 0;
    for (size_t step = 0; step < tape.steps(); ++step) {
      const auto bits = std::bit_cast<uint64_t>(tape.targets[step * tape.joints + joint]);
      const uint64_t change = bits ^ last;
      for (size_t i = 0; i < kWord; ++i)
        column[i * tape.steps() + step] = static_cast<char>(change >> (8 * i) & 0xff);
      last = bits;
    }
    bytes += column;
  }
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  void Read(void* to, size_t size) {
    if (size > bytes_.size()) throw UserError("its tape is cut off");
    std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  template <class Numbers>
  void ReadNumbers(Numbers& numbers) {
    Read(std::data(numbers), std::size(numbers) * sizeof(numbers[0]));
  }
  robot::StartState ReadStart(size_t joints) {
    robot::StartState start;
    ReadPose(start.pose, joints);
    ReadPose(start.from, joints);
    start.joint_velocities.resize(joints);
    ReadNumbers(start.joint_velocities);
    ReadNumbers(start.velocity);
    ReadNumbers(start.angular_velocity);
    return start;
  }
  void ReadPose(robot::Pose& pose, size_t joints) {
    pose.joint_angles.resize(joints);
    ReadNumbers(pose.position);
    ReadNumbers(pose.orientation);
    ReadNumbers(pose.joint_angles);
  }
  size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

void ReadTargets(Reader& reader, size_t steps, Tape& tape) {
  tape.targets.resize(steps * tape.joints);
  std::string column(steps * kWord, '\0');
  for (size_t joint = 0; joint < tape.joints; ++joint) {
    reader.Read(column.data(), column.size());
    uint64_t last = 0;
    for (size_t step = 0; step < steps; ++step) {
      for (size_t i = 0; i < kWord; ++i)
        last ^= uint64_t{static_cast<unsigned char>(column[i * steps + step])} << (8 * i);
      tape.targets[step * tape.joints + joint] = std::bit_cast<double>(last);
    }
  }
}

}  // namespace

std::string Pack(const Tape& tape) {
  const Header header{.joints = tape.joints,
                      .steps = tape.steps(),
                      .ends_at_once = tape.ends_at_once ? 1u : 0u,
                      .discount = tape.discount,
                      .has_start = tape.start ? 1u : 0u,
                      .start_pose_size = tape.start_pose.size()};
  std::string bytes;
  Append(bytes, &header, sizeof(header));
  bytes += tape.start_pose;
  if (tape.start) AppendStart(bytes, *tape.start);
  AppendNumbers(bytes, tape.actions);
  AppendTargets(bytes, tape);
  return Compress(std::as_bytes(std::span(bytes)));
}

Tape Unpack(std::string_view packed) {
  const std::string bytes = Decompress(packed, "its tape");
  Reader reader(bytes);
  Header header;
  reader.Read(&header, sizeof(header));
  if (header.format != kFormat) throw UserError("its tape is of another version of the trainer");
  if (header.joints > kMostJoints || header.steps > kMostSteps ||
      header.start_pose_size > reader.left())
    throw UserError("its tape is damaged");
  Tape tape{.start_pose = std::string(header.start_pose_size, ' '),
            .start = {},
            .discount = header.discount,
            .ends_at_once = header.ends_at_once != 0,
            .joints = header.joints,
            .targets = {},
            .actions = {}};
  reader.ReadNumbers(tape.start_pose);
  if (header.has_start != 0) tape.start = reader.ReadStart(tape.joints);
  tape.actions.resize(header.steps + 1);
  reader.ReadNumbers(tape.actions);
  if (reader.left() != header.steps * header.joints * kWord) throw UserError("its tape is damaged");
  ReadTargets(reader, header.steps, tape);
  return tape;
}

std::string ReadTape(const std::filesystem::path& folder, int64_t episode) {
  const SqliteDatabase database(RunDatabaseFile(folder), SqliteAccess::kRead);
  if (!HasTable(database, "tape")) return "";
  TableReader row(database, "tape", "data", "WHERE episode = ?");
  row.Bind(episode);
  return row.Next() ? row.Blob(0) : "";
}

}  // namespace runtime
