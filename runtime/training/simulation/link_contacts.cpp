#include "runtime/training/simulation/link_contacts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "runtime/training/simulation/friction.h"

namespace runtime {
namespace {

constexpr size_t kUsualLinkContacts = 30;

Vector6 RowAt(const Vector3& arm, const Vector3& direction) {
  Vector6 row;
  row << direction, arm.cross(direction);
  return row;
}

}  // namespace

LinkContacts::LinkContacts(int links) : links_(links), impulses_(links) {
  contacts_.reserve(kUsualLinkContacts);
  const size_t rows = 3 * kUsualLinkContacts;
  active_.reserve(rows);
  parts_.reserve(rows * links_);
  matrix_.reserve(rows * rows);
  right_.reserve(rows);
}

LimitedPull& LinkContacts::Add(const Contact& contact, const Vector3& first_center,
                               const Vector3& second_center, double hold) {
  const Vector3 point(contact.geometry.pos[0], contact.geometry.pos[1], contact.geometry.pos[2]);
  const Vector3 normal(contact.geometry.normal[0], contact.geometry.normal[1],
                       contact.geometry.normal[2]);
  const bool is_limited = contact.friction < robot::kUnlimited;
  const Vector3 tangent = normal.unitOrthogonal();
  const std::array<Vector3, 2> sliding =
      is_limited ? SlidingDirections(normal) : std::array{tangent, Vector3(normal.cross(tangent))};
  const Vector3 directions[] = {normal, sliding[0], sliding[1]};
  LinkContact& added = contacts_.emplace_back();
  added.friction = contact.friction;
  added.hold = hold;
  has_frictions_ = has_frictions_ || is_limited;
  for (int i = 0; i < 3; ++i) {
    added.rows[i] = {contact.first, contact.second, RowAt(point - first_center, directions[i]),
                     RowAt(point - second_center, -directions[i])};
    if (i > 0 && !is_limited)
      added.pulls[i] = {.stiffness = hold, .low = -robot::kUnlimited, .high = robot::kUnlimited};
  }
  return added.pulls[0];
}

double LinkContacts::Speed(int contact, size_t row, std::span<const Vector6> velocities) const {
  return contacts_[contact].rows[row].Speed(velocities);
}

void LinkContacts::LimitFrictions(std::span<const Vector6> velocities) {
  for (LinkContact& contact : contacts_) {
    if (contact.friction == robot::kUnlimited) continue;
    const double impulse = contact.pulls[0].ImpulseAt(contact.rows[0].Speed(velocities));
    for (int i : {1, 2}) contact.pulls[i] = FrictionPull(contact.friction, impulse, contact.hold);
  }
}

void LinkContacts::AddLimitedImpulses(std::span<Vector6> momenta) const {
  if (!has_frictions_) return;
  for (const LinkContact& contact : contacts_) {
    for (int i : {1, 2}) {
      const Row& row = contact.rows[i];
      if (contact.pulls[i].hold() > 0) continue;
      momenta[row.first] += contact.pulls[i].load() * row.first_row;
      momenta[row.second] += contact.pulls[i].load() * row.second_row;
    }
  }
}

Vector3 LinkContacts::Impulse(int contact, std::span<const Vector6> velocities) const {
  const LinkContact& touch = contacts_[contact];
  Vector3 impulse = Vector3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Row& row = touch.rows[i];
    impulse += touch.pulls[i].ImpulseAt(row.Speed(velocities)) * row.first_row.head<3>();
  }
  return impulse;
}

void LinkContacts::AddImpulses(TreeFactor& tree, std::span<const Vector6> velocities,
                               std::span<Vector6> momenta) {
  CollectRows();
  Assemble(tree, velocities);
  const auto count = static_cast<Eigen::Index>(active_.size());
  Eigen::Map<Eigen::MatrixXd> matrix(matrix_.data(), count, count);
  Eigen::Map<Eigen::VectorXd> right(right_.data(), count);
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(matrix).solveInPlace(right);
  for (size_t a = 0; a < active_.size(); ++a) {
    const Row& row = *active_[a].row;
    momenta[row.first] += right_[a] * row.first_row;
    momenta[row.second] += right_[a] * row.second_row;
  }
}

void LinkContacts::CollectRows() {
  active_.clear();
  for (const LinkContact& contact : contacts_) {
    for (int i = 0; i < 3; ++i) {
      const double hold = contact.pulls[i].hold();
      if (hold > 0) active_.push_back({&contact.rows[i], hold, contact.pulls[i].load()});
    }
  }
}

// impulse_a / hold_a + sum_b (row_a . row_b) impulse_b = target_a - speed_a
void LinkContacts::Assemble(TreeFactor& tree, std::span<const Vector6> velocities) {
  const size_t count = active_.size();
  parts_.resize(count * links_);
  matrix_.resize(count * count);
  right_.resize(count);
  for (size_t a = 0; a < count; ++a) {
    const ActiveRow& active = active_[a];
    std::fill(impulses_.begin(), impulses_.end(), Vector6::Zero());
    impulses_[active.row->first] += active.row->first_row;
    impulses_[active.row->second] += active.row->second_row;
    tree.Decompose(impulses_, PartsOf(a));
    for (size_t b = 0; b <= a; ++b) {
      double sum = 0;
      for (size_t i = 0; i < links_; ++i) sum += PartsOf(a)[i].dot(PartsOf(b)[i]);
      matrix_[b * count + a] = sum;  // the lower triangle, by columns
    }
    matrix_[a * count + a] += 1 / active.hold;
    right_[a] = active.load / active.hold - active.row->Speed(velocities);
  }
}

}  // namespace runtime
