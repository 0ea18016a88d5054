// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_STEP_SERIES_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_STEP_SERIES_H

#include "color_map.h"
#include "picture.h"
#include "surface_program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace programs {

/// What pages and pictures show of a surface that moves: the first one, up to 20 of the steps, and
/// the last.
class Step_series {
public:
  Step_series(const RL::Triangulated_surface_3& surface, int steps)
    : m_surface(surface), m_every((steps + largest_number - 1) / largest_number),
      m_digits(std::to_string(steps).size()) {
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      m_first.push_back(surface.point(v));
    add(0, 0, m_first);
  }

  bool wants(int step) const { return step % m_every == 0; }
  int last_step() const { return m_steps.back(); }

  void add(int step, double time, const Eigen::MatrixXd& positions) {
    std::vector<RL::Point_3> points;
    for(const auto& p : positions.rowwise())
      points.emplace_back(p[0], p[1], p[2]);
    add(step, time, std::move(points));
  }

  // one range for all steps: colors mean the same
  void show_on_page(Page_contents& page) const {
    page.points = m_points;
    page.values.resize(static_cast<Eigen::Index>(m_first.size()),
                       static_cast<Eigen::Index>(m_steps.size()));
    for(std::size_t i = 0; i < m_steps.size(); ++i) {
      std::ostringstream name;
      name << "displacement, step " << m_steps[i] << ", time " << m_times[i];
      page.names.push_back(name.str());
      page.ranges.emplace_back(std::pair(0., largest_displacement()));
      page.values.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::VectorXd>(
          m_displacements[i].data(), static_cast<Eigen::Index>(m_first.size()));
    }
    page.first = m_steps.size() - 1;
  }

  // all with the same frame, and the same colors
  void draw(const std::string& prefix) const {
    Picture_options options;
    for(const auto& points : m_points)
      options.room_for.insert(options.room_for.end(), points.begin(), points.end());
    const Color_scale scale(0, largest_displacement());
    std::vector<RL::Triangulated_surface_3::Triangle> triangles;
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
      triangles.push_back(m_surface.triangle(f));
    for(std::size_t i = 0; i < m_steps.size(); ++i) {
      std::ostringstream file;
      file << prefix << std::setw(static_cast<int>(m_digits)) << std::setfill('0') << m_steps[i]
           << ".png";
      write_picture(file.str(), RL::Triangulated_surface_3(m_points[i], triangles),
                    scale.colors(m_displacements[i]), m_displacements[i], options);
    }
  }

private:
  static constexpr int largest_number = 20;

  void add(int step, double time, std::vector<RL::Point_3> points) {
    std::vector<double> displacements;
    for(std::size_t v = 0; v < points.size(); ++v)
      displacements.push_back(std::sqrt((points[v] - m_first[v]).squared_length()));
    m_steps.push_back(step);
    m_times.push_back(time);
    m_points.push_back(std::move(points));
    m_displacements.push_back(std::move(displacements));
  }

  double largest_displacement() const {
    double result = 0;
    for(const auto& displacements : m_displacements)
      for(const double d : displacements)
        result = std::max(result, d);
    return result;
  }

  const RL::Triangulated_surface_3& m_surface;
  int m_every;
  std::size_t m_digits;
  std::vector<RL::Point_3> m_first;
  // of each step that is shown
  std::vector<int> m_steps;
  std::vector<double> m_times;
  std::vector<std::vector<RL::Point_3>> m_points;
  std::vector<std::vector<double>> m_displacements;
};

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_STEP_SERIES_H
