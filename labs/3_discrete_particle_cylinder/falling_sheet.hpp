#pragma once

#include <functional>

#include "discrete_particle_cylinder.hpp"

/// The cloth of the scene: a mass-spring sheet, stepped by positions (Müller et al. 2007).
namespace lab::discrete_particle_cylinder {

inline constexpr double skin = 0.001;  ///< contacts are held this far apart [m]

/// A function that moves a sheet out of the cylinder. It is called within every step.
using PushOut = std::function<void(Sheet& sheet, const Cylinder& cylinder)>;

/// Moves each particle that is inside back along the gradient.
inline void push_particles_out(Sheet& sheet, const Cylinder& cylinder) {
  for (Vec3& position : sheet.positions) {
    const double depth = skin - gap(position, sheet.particle_radius, cylinder);
    if (depth > 0.0) position += depth * gap_gradient(position);
  }
}

/// Moves each triangle's deepest place back along the gradient, its corners by their weights there.
inline void push_triangles_out(Sheet& sheet, const Cylinder& cylinder) {
  constexpr int passes = 20;  // a push may move a neighbour inside
  bool is_inside = true;
  for (int pass = 0; pass < passes && is_inside; ++pass) {
    is_inside = false;
    for (const auto& [i, j, k] : sheet.triangles) {
      Vec3& a = sheet.positions[i];
      Vec3& b = sheet.positions[j];
      Vec3& c = sheet.positions[k];
      const TriangleGap deepest = triangle_gap(a, b, c, sheet.particle_radius, cylinder);
      const double depth = skin - deepest.gap;
      if (depth <= 1e-9) continue;
      is_inside = is_inside || deepest.gap <= 0.5 * skin;
      const Vec3& w = deepest.weights;
      const Vec3 push = depth / w.squaredNorm() * gap_gradient(w.x() * a + w.y() * b + w.z() * c);
      a += w.x() * push;
      b += w.y() * push;
      c += w.z() * push;
    }
  }
}

/// A rectangle of cells, each divided into two triangles.
struct FallingSheet {
  int rows;
  int columns;
  Sheet sheet;
  std::vector<Vec3> velocities;

  /// Makes a level sheet about `center`, turned about the vertical by `angle` [rad].
  FallingSheet(int row_count, int column_count, double spacing, const Vec3& center, double angle)
      : rows(row_count), columns(column_count) {
    const common::Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Vec3 place(column - 0.5 * (columns - 1), row - 0.5 * (rows - 1), 0.0);
        sheet.positions.emplace_back(center + spacing * (turn * place));
        if (column + 1 < columns) join(row, column, row, column + 1);
        if (row + 1 < rows) join(row, column, row + 1, column);
        if (column + 1 < columns && row + 1 < rows) cut(row, column);
      }
    }
    velocities.assign(sheet.positions.size(), Vec3::Zero());
    for (const auto& [a, b] : sheet.edges) rest_lengths_.push_back(length(a, b));
  }

  /// Applies weight and air, then edge lengths and contacts in turn, until both about hold.
  void step(double dt, const Cylinder& cylinder, const PushOut& push_out) {
    constexpr double drag = 3.0;  // [1/s]
    constexpr int turns = 8;
    const std::vector<Vec3> before = sheet.positions;
    for (std::size_t i = 0; i < before.size(); ++i) {
      velocities[i] += dt * (Vec3(0.0, 0.0, -9.81) - drag * velocities[i]);
      sheet.positions[i] += dt * velocities[i];
    }
    std::vector<bool> is_touched(before.size(), false);
    for (int turn = 0; turn < turns; ++turn) {
      restore_lengths();
      const std::vector<Vec3> unpushed = sheet.positions;
      push_out(sheet, cylinder);
      for (std::size_t i = 0; i < before.size(); ++i) {
        is_touched[i] = is_touched[i] || sheet.positions[i] != unpushed[i];
      }
    }
    constexpr double slip =
        0.3;  // what friction leaves of a velocity, as far as a picture needs it
    for (std::size_t i = 0; i < before.size(); ++i) {
      velocities[i] = (is_touched[i] ? slip : 1.0) / dt * (sheet.positions[i] - before[i]);
    }
  }

 private:
  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] double length(std::size_t a, std::size_t b) const {
    return (sheet.positions[b] - sheet.positions[a]).norm();
  }
  void join(int row_a, int column_a, int row_b, int column_b) {
    sheet.edges.push_back({index(row_a, column_a), index(row_b, column_b)});
  }
  void cut(int row, int column) {
    const std::size_t a = index(row, column);
    const std::size_t b = index(row + 1, column);
    sheet.triangles.push_back({a, a + 1, b + 1});
    sheet.triangles.push_back({a, b + 1, b});
    sheet.edges.push_back({a, b + 1});
  }
  void restore_lengths() {
    for (std::size_t i = 0; i < sheet.edges.size(); ++i) {
      const auto [a, b] = sheet.edges[i];
      const Vec3 span = sheet.positions[b] - sheet.positions[a];
      const Vec3 half = 0.5 * (1.0 - rest_lengths_[i] / span.norm()) * span;
      sheet.positions[a] += half;
      sheet.positions[b] -= half;
    }
  }

  std::vector<double> rest_lengths_;
};

}  // namespace lab::discrete_particle_cylinder
