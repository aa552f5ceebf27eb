// A robot as its description file says it: body, joints, controller, poses, names. One TOML file
// describes one robot; plugins/humanoid/robot.toml is the model to copy.
//
// Units: m, kg, s, rad, N m. World frame: x forward, y left, z up; the robot faces +x.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robot {

using Vector3 = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // w, x, y, z

// What robots are in, and what no link of theirs exceeds: a simulation that does is at its end.
inline constexpr double kGravity = 9.8;          // downward [m / s^2]
inline constexpr double kFastest = 1e2;          // [m / s]
inline constexpr double kFastestRotation = 1e4;  // [rad / s]

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

enum class ShapeKind { kBox, kCapsule, kCylinder, kSphere, kConvex };

struct LinkShape {
  ShapeKind kind = ShapeKind::kSphere;
  Vector3 size{};     // box: full extents
  double radius = 0;  // capsule, cylinder, sphere
  double length = 0;  // capsule: total length, both caps included; cylinder
  int axis = 2;       // capsule, cylinder: 0, 1, 2 = along x, y, z of the shape
  // Where the shape is in its link's frame.
  Vector3 position{};
  Quaternion orientation{1, 0, 0, 0};
  std::vector<Vector3> points{};  // convex: the shape is their convex hull; IsSolid()

  bool IsMoved() const { return position != Vector3{} || orientation != Quaternion{1, 0, 0, 0}; }
};

// Whether the convex hull of the points is a body: what is thinner than a thousandth of its length
// is not.
bool IsSolid(const std::vector<Vector3>& points);

// A symmetric matrix, about the center of mass, along the axes of the zero pose [kg m^2].
struct Inertia {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

struct Link {
  std::string name;
  double mass = 0;
  Vector3 position{};  // center of mass relative to the base link's center, zero pose
  LinkShape shape;
  // Without it that of the shape, which is of uniform density. A convex shape never is without.
  std::optional<Inertia> inertia{};
  double friction = kUnlimited;  // coefficient; of two links that touch the smaller one counts
};

enum class JointKind { kHinge, kContinuous, kSlider };

// What a joint has of its own in place of what the controller says for all.
struct OwnGains {
  std::optional<double> stiffness;
  std::optional<double> damping;
  std::optional<double> max_torque;
  std::optional<double> max_speed;
};

// What acts on a joint besides its motor and its stops.
struct PassiveForces {
  double spring = 0;       // N m / rad, toward `spring_rest`
  double spring_rest = 0;  // rad
  double damper = 0;       // N m s / rad
  double friction = 0;     // N m, whatever the speed
  double armature = 0;     // inertia of what turns with the motor, as the joint feels it [kg m^2]
};

// A joint of one coordinate, its angle [rad]. A positive angle turns the child by -angle about
// `axis` (ODE's own measure when the parent is attached first). A slider is moved by a rack and
// pinion, and its angle is that of the pinion: a positive one shifts the child by radius * angle
// along `axis`.
struct Joint {
  std::string name;
  int parent = 0;  // link index
  int child = 0;
  Vector3 axis{};    // unit vector, world frame, zero pose
  Vector3 anchor{};  // relative to the base link's center, zero pose; of a slider nothing
  double low = 0;    // stops; of a joint without any minus infinity and infinity
  double high = 0;
  JointKind kind = JointKind::kHinge;
  double radius = 1;  // of a slider's pinion [m / rad]
  OwnGains gains{};
  PassiveForces passive{};

  bool HasStops() const { return high < kUnlimited; }
};

enum class MountKind { kFixed, kBall };

// What joins two links without a coordinate: it is neither driven nor sensed.
struct Mount {
  std::string name;
  MountKind kind = MountKind::kFixed;
  int parent = 0;  // link index
  int child = 0;
  Vector3 anchor{};   // of a ball: its center, relative to the base link's center, zero pose
  double damper = 0;  // of a ball [N m s / rad]
};

inline constexpr size_t kMostSites = 250;  // of a robot

// A point with a frame of its own, fixed to a link: a fingertip, or where an inertial unit sits.
struct Site {
  std::string name;
  int link = 0;                        // index
  Vector3 position{};                  // relative to the base link's center, zero pose
  Quaternion orientation{1, 0, 0, 0};  // from its frame to the world, zero pose
};

// One edge of the tree of links: a joint, or a mount.
struct Branch {
  int parent = 0;  // link index
  int child = 0;
  int joint = -1;  // index, or -1
  int mount = -1;  // index, or -1
};

// Joint-level PD control: torque = clip(stiffness * (target - angle) - damping * rate, max_torque).
// A motor that turns has less to give, in proportion, and at `max_speed` nothing: the two numbers
// of a servo's data sheet, its stall torque and its no-load speed. One that is turned faster
// brakes.
struct Gains {
  double stiffness = 0;           // N m / rad
  double damping = 0;             // N m s / rad
  double max_torque = 0;          // N m
  double max_speed = kUnlimited;  // rad / s

  // A joint without one is passive.
  bool HasMotor() const { return max_torque > 0; }
};

// The gains of joints that have none of their own.
struct Controller {
  double stiffness = 0;           // N m / rad
  double damping = 0;             // N m s / rad
  double max_torque = 0;          // N m
  double max_speed = kUnlimited;  // rad / s
  double time_step = 0;           // of the tasks and the learner [s]
};

struct Pose {
  std::string name;
  Vector3 position{};
  Quaternion orientation{1, 0, 0, 0};
  std::vector<double> joint_angles;  // one for each joint

  bool operator==(const Pose&) const = default;
};

// A named set of links, joints or sites, as indices in ascending order.
struct Group {
  std::string name;
  std::vector<int> members;
};

// joint_j = factor * coordinate: one summand of a coupling.
struct Coupling {
  int joint = 0;
  int coordinate = 0;
  double factor = 1;
};

// A way to drive the joints by fewer coordinates. Joints without a coupling are held at 0.
struct DofConfiguration {
  std::string name;
  // For each coordinate the joint whose angle and rate stand for it.
  std::vector<int> representatives;
  std::vector<Coupling> couplings;

  int dof() const { return static_cast<int>(representatives.size()); }
};

enum class NetKind { kGrid, kBubble };

// How the basis functions of a normalized Gaussian network are laid out in the space of a DoF
// configuration's coordinates.
struct NetDescription {
  std::string name;
  NetKind kind = NetKind::kGrid;
  std::string dof;                 // name of the DoF configuration; others with the same
                                   // representatives fit as well
  std::vector<double> low, high;   // one for each coordinate
  std::vector<int> counts;         // grid: centers along each coordinate
  std::vector<double> deviations;  // grid: one for each coordinate; empty: from the spacing
  int units = 0;                   // bubble: number of centers
};

// The values that a number can have: from `low` to `high`, where these are known.
struct Range {
  double low = -kUnlimited;
  double high = kUnlimited;
};

// What the author of a description says of a sensor whose values nothing limits by itself: where
// they lie unless something has gone wrong.
struct NominalRange {
  std::string sensor;           // "base.velocity"
  std::vector<Range> elements;  // one for each, or a single one for all
};

struct RobotDescription {
  std::string name;
  std::string doc;
  std::filesystem::path file;   // where it was read from
  std::vector<Link> links;      // links[0] is the base
  bool has_fixed_base = false;  // what carries the robot holds the base link where it starts
  std::vector<Joint> joints;
  std::vector<Mount> mounts;
  std::vector<Site> sites;
  std::vector<std::array<int, 2>> contact_exclusions;  // links that do not collide
  Controller controller;
  std::vector<Pose> poses;  // the first is the default
  std::vector<Group> link_groups;
  std::vector<Group> joint_groups;
  std::vector<Group> site_groups;
  std::vector<DofConfiguration> dof_configurations;
  std::vector<NetDescription> nets;
  std::vector<NominalRange> nominal_ranges;

  std::optional<int> FindLink(std::string_view link) const;
  std::optional<int> FindJoint(std::string_view joint) const;
  const Pose* FindPose(std::string_view pose) const;
  const DofConfiguration* FindDof(std::string_view dof) const;
  const NetDescription* FindNet(std::string_view net) const;

  Gains GainsOf(const Joint& joint) const;
  // From the center of its link, in the link's frame.
  Vector3 ArmOf(const Site& site) const;
  // All joints and mounts, each after the one that attaches its parent; joints as far as possible
  // in their own order.
  std::vector<Branch> Branches() const;
};

// A mistake in a description file: the message names file, line and remedy.
class DescriptionError : public std::exception {
 public:
  explicit DescriptionError(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

// Reads and checks a description. Throws DescriptionError.
RobotDescription ReadRobot(const std::filesystem::path& file);

// The same for a robot that was looked for by this name, as its folder is called. Throws
// DescriptionError where the description says that it is another.
RobotDescription ReadRobotCalled(std::string_view name, const std::filesystem::path& file);

// The file that describes the robot called `name`: `name`/robot.toml in the first of the folders
// that has it. Throws DescriptionError with the robots that there are, nearest name first.
std::filesystem::path FindRobotFile(std::string_view name,
                                    const std::vector<std::filesystem::path>& folders);

// Where robots are searched for: the folders of the environment variable TASKC_ROBOT_PATH
// (separated by ':'), then share/taskc/robots beside the running program's bin folder.
std::vector<std::filesystem::path> DefaultRobotFolders();

// Where the robot of a task is searched for: the folder `first` (where it is not empty), those of
// the task's files, then DefaultRobotFolders().
std::vector<std::filesystem::path> RobotFolders(const std::vector<std::filesystem::path>& files,
                                                const std::filesystem::path& first);

}  // namespace robot
