#include "wend/path/smoothing/drive_window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

constexpr std::size_t kEnd = 3;  // numbers of a pose: x, y, heading
constexpr double kLeastScale =
    0.2;  // a stretch in one gear keeps this share of its length in a step
constexpr double kGreatestScale = 5;  // and becomes no longer than this
constexpr double kAtEnd = 1e-10;      // turning radii and radians
constexpr double kDifference = 1e-6;  // for derivatives
constexpr double kDamping = 1e-3;     // of the method of Gauss and Newton
constexpr double kSingular = 1e-12;

/// A square matrix and its right side, by rows.
class Equations {
 public:
  explicit Equations(std::size_t size) : size_(size), rows_(size, std::vector<double>(size + 1)) {}

  double& at(std::size_t row, std::size_t column) { return rows_[row][column]; }
  double& right(std::size_t row) { return rows_[row][size_]; }

  /// By elimination with pivots; zeros if they are singular.
  std::vector<double> solved() {
    std::vector<double> solution(size_, 0);
    for (std::size_t i = 0; i < size_; ++i) {
      const auto below = rows_.begin() + static_cast<std::ptrdiff_t>(i);
      const auto larger = [i](const auto& a, const auto& b) {
        return std::abs(a[i]) < std::abs(b[i]);
      };
      std::iter_swap(below, std::max_element(below, rows_.end(), larger));
      if (std::abs(rows_[i][i]) < kSingular) return solution;
      for (std::size_t k = i + 1; k < size_; ++k) {
        const double share = rows_[k][i] / rows_[i][i];
        if (share == 0) continue;
        for (std::size_t j = i; j <= size_; ++j) rows_[k][j] -= share * rows_[i][j];
      }
    }
    for (std::size_t i = size_; i-- > 0;) {
      double sum = rows_[i][size_];
      for (std::size_t j = i + 1; j < size_; ++j) sum -= rows_[i][j] * solution[j];
      solution[i] = sum / rows_[i][i];
    }
    return solution;
  }

 private:
  std::size_t size_;
  std::vector<std::vector<double>> rows_;
};

/// The derivatives of some numbers by the variables, a row for each variable.
template <class Function>
std::vector<std::vector<double>> derivatives(std::vector<double> variables, Function&& numbers_at) {
  const std::vector<double> here = numbers_at(variables);
  std::vector<std::vector<double>> rows;
  for (double& variable : variables) {
    const double was = std::exchange(variable, variable + kDifference);
    std::vector<double> row = numbers_at(variables);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = (row[i] - here[i]) / kDifference;
    rows.push_back(std::move(row));
    variable = was;
  }
  return rows;
}

}  // namespace

DriveWindow::DriveWindow(const FreeSpace& space, const DriveObjective& objective, const Pose& from,
                         std::vector<DrivePiece> pieces, std::optional<double> before,
                         std::optional<double> after)
    : space_(&space),
      objective_(objective),
      from_(from),
      pieces_(std::move(pieces)),
      before_(before),
      after_(after) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i == 0 || pieces_[i].length * pieces_[i - 1].length < 0) ++runs_;
    run_.push_back(runs_ - 1);
  }
  wanted_end_ = end_of_variables(variables());
}

double DriveWindow::length() const {
  double sum = 0;
  for (const DrivePiece& piece : pieces_) sum += std::abs(piece.length);
  return sum;
}

/// The curvature of each piece times the radius, and the scale of each stretch in one gear.
DriveWindow::Numbers DriveWindow::variables() const {
  Numbers variables;
  for (const DrivePiece& piece : pieces_) variables.push_back(piece.curvature * objective_.radius);
  variables.insert(variables.end(), runs_, 1);
  return variables;
}

std::vector<DrivePiece> DriveWindow::pieces_at(const Numbers& variables) const {
  std::vector<DrivePiece> pieces = pieces_;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].curvature = variables[i] / objective_.radius;
    pieces[i].length *= variables[pieces.size() + run_[i]];
  }
  return pieces;
}

std::vector<Pose> DriveWindow::poses_of(std::span<const DrivePiece> pieces) const {
  std::vector<Pose> poses{from_};
  for (const DrivePiece& piece : pieces) {
    poses.push_back(end_of(Segment(poses.back(), piece.length, piece.length * piece.curvature, 0)));
  }
  return poses;
}

/// In turning radii and radians; headings are not normalised, so that derivatives are.
DriveWindow::Numbers DriveWindow::end_of_variables(const Numbers& variables) const {
  const std::vector<DrivePiece> pieces = pieces_at(variables);
  double heading = from_.heading;
  for (const DrivePiece& piece : pieces) heading += piece.length * piece.curvature;
  const Pose end = poses_of(pieces).back();
  return {end.x / objective_.radius, end.y / objective_.radius, heading};
}

/// Of the base point, between the centres of cells, at most what is enough.
double DriveWindow::clearance_at(Point point) const {
  const double x = point.x - 0.5;
  const double y = point.y - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto of_cell = [this](double i, double j) {
    const Cell cell{static_cast<int>(i), static_cast<int>(j)};
    return space_->contains(cell) ? space_->clearance(cell, objective_.clearance) : 0;
  };
  const double share_x = x - left;
  const double share_y = y - top;
  const double above = std::lerp(of_cell(left, top), of_cell(left + 1, top), share_x);
  const double below = std::lerp(of_cell(left, top + 1), of_cell(left + 1, top + 1), share_x);
  return std::min(std::lerp(above, below, share_y), objective_.clearance);
}

/// The objective is the sum of their squares.
DriveWindow::Numbers DriveWindow::residuals_of(std::span<const DrivePiece> pieces) const {
  const double radius = objective_.radius;
  Numbers residuals;
  std::optional<double> last = before_;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [length, curvature] = pieces[i];
    if (i > 0 && length * pieces[i - 1].length < 0) last = {};
    const double change = last ? (curvature - *last) * radius : 0;
    const double way = std::abs(length) / radius;
    residuals.push_back(std::sqrt(objective_.change_weight) * change);
    residuals.push_back(std::sqrt(objective_.bend_weight * way) * curvature * radius);
    residuals.push_back(std::sqrt(objective_.length_weight * way));
    last = curvature;
  }
  const double change = after_ && last ? (*after_ - *last) * radius : 0;
  residuals.push_back(std::sqrt(objective_.change_weight) * change);
  if (objective_.clearance <= 0) return residuals;
  const std::vector<Pose> poses = poses_of(pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double way = std::abs(pieces[i].length) / radius;
    const double missing = 1 - clearance_at(poses[i + 1].point()) / objective_.clearance;
    residuals.push_back(std::sqrt(objective_.clearance_weight * way) * missing);
  }
  return residuals;
}

double DriveWindow::objective_of(std::span<const DrivePiece> pieces) const {
  double sum = 0;
  for (const double residual : residuals_of(pieces)) sum += residual * residual;
  return sum;
}

bool DriveWindow::allowed(const Numbers& variables) const {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const bool curvature = i < pieces_.size();
    if (curvature && !(std::abs(variables[i]) <= 1)) return false;
    if (!curvature && !(variables[i] >= kLeastScale && variables[i] <= kGreatestScale))
      return false;
  }
  return true;
}

/// Least squares with damping, the end of the pieces fixed. Curvatures that would leave their bounds stay at these.
DriveWindow::Numbers DriveWindow::full_step() const {
  const Numbers here = variables();
  const std::size_t count = here.size();
  const auto ends = derivatives(here, [this](const Numbers& at) { return end_of_variables(at); });
  const auto slopes =
      derivatives(here, [this](const Numbers& at) { return residuals_of(pieces_at(at)); });
  const Numbers residuals = residuals_of(pieces_);
  std::vector<std::optional<double>> fixed(count);
  Numbers step;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    Equations equations(count + kEnd);
    for (std::size_t i = 0; i < count; ++i) {
      if (const std::optional<double>& value = fixed[i]) {
        equations.at(i, i) = 1;
        equations.right(i) = *value;
        continue;
      }
      for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t k = 0; k < residuals.size(); ++k) {
          equations.at(i, j) += slopes[i][k] * slopes[j][k];
        }
      }
      equations.at(i, i) += kDamping;
      for (std::size_t k = 0; k < residuals.size(); ++k) {
        equations.right(i) -= slopes[i][k] * residuals[k];
      }
      for (std::size_t k = 0; k < kEnd; ++k) equations.at(i, count + k) = ends[i][k];
    }
    for (std::size_t k = 0; k < kEnd; ++k) {
      for (std::size_t i = 0; i < count; ++i) equations.at(count + k, i) = ends[i][k];
    }
    step = equations.solved();
    step.resize(count);
    bool leaves = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (fixed[i] || std::abs(here[i] + step[i]) <= 1) continue;
      fixed[i] = std::copysign(1.0, here[i] + step[i]) - here[i];
      leaves = true;
    }
    if (!leaves) break;
  }
  return step;
}

/// By the method of Newton, with the least changes of variables that are not at a bound.
bool DriveWindow::restore_end(Numbers& variables) const {
  const std::size_t count = variables.size();
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    const Numbers end = end_of_variables(variables);
    Numbers gap;
    for (std::size_t k = 0; k < kEnd; ++k) gap.push_back(wanted_end_[k] - end[k]);
    const auto small = [](double number) { return std::abs(number) <= kAtEnd; };
    if (std::ranges::all_of(gap, small)) return allowed(variables);
    const auto ends =
        derivatives(variables, [this](const Numbers& at) { return end_of_variables(at); });
    Equations equations(kEnd);
    const auto free = [&](std::size_t i) {
      return i >= pieces_.size() || std::abs(variables[i]) < 1 - kDifference;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (!free(i)) continue;
      for (std::size_t k = 0; k < kEnd; ++k) {
        for (std::size_t j = 0; j < kEnd; ++j) equations.at(k, j) += ends[i][k] * ends[i][j];
      }
    }
    for (std::size_t k = 0; k < kEnd; ++k) equations.right(k) = gap[k];
    const Numbers weights = equations.solved();
    for (std::size_t i = 0; i < count; ++i) {
      if (!free(i)) continue;
      for (std::size_t k = 0; k < kEnd; ++k) variables[i] += ends[i][k] * weights[k];
    }
  }
  return false;
}

std::optional<std::vector<DrivePiece>> DriveWindow::step(double factor) {
  if (step_.empty()) step_ = full_step();
  Numbers changed = variables();
  for (std::size_t i = 0; i < changed.size(); ++i) changed[i] += factor * step_[i];
  if (!restore_end(changed)) return std::nullopt;
  return pieces_at(changed);
}

}  // namespace wend
