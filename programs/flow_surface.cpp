// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves a surface by mean-curvature flow, and writes where its vertices are then.

#include "support/command_line.h"
#include "support/moved_surface.h"
#include "support/picture.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/surface_program.h"

#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;
namespace params = RL::parameters;

const Help help = {
    "flow_surface MESH --steps N --time-step T [OPTION]...", std::string(R"(
Moves a surface by mean-curvature flow: dx/dt = Laplacian x, in implicit steps.

A sphere of the radius r shrinks as (r^2 - 4 t)^(1/2), and thin parts sooner than thick
ones. Where a part collapses the program stops, says so, and writes the surface before the
step. With --conformal the energy remains that of the first surface: then a surface without
holes and handles becomes a sphere, and the map to it is conformal in the end; it is scaled
to its first area after each step.
)") + about_meshes,
    R"(  flow_surface elephant.off --steps 30 --time-step 0.01 --conformal --output sphere.ply
      a conformal map to a sphere, colored by how far vertices moved
  flow_surface mannequin-devil.off --steps 5 --time-step 1e-5 --csv positions.csv
      where the vertices are after a short time
  flow_surface elephant.off --steps 9 --time-step 1e-3 --conformal --pictures flow
      pictures flow0.png to flow9.png; --html has a slider over the steps instead
)"};

struct Options : Common_options {
  int steps = 1;
  double time_step = 0, tolerance = RL::Mean_curvature_flow_options().tolerance, stabilization = -1;
  bool conformal = false, free_boundary = false;
  std::string rescaling, pictures;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Flow", help_width);
  auto add = problem.add_options();
  add("steps", po::value(&o.steps)->value_name("N")->default_value(o.steps), "how many");
  add("time-step", po::value(&o.time_step)->value_name("T"), "in units of squared length");
  add("conformal", po::bool_switch(&o.conformal), "with the energy of the first surface");
  add("rescaling", po::value(&o.rescaling)->value_name("none|area|volume"),
      "what is kept by scaling after each step; default: area with --conformal, or none");
  add("no-fixed-boundary", po::bool_switch(&o.free_boundary),
      "the boundary of an open surface moves, too; by default it stays where it is");
  add("pictures", po::value(&o.pictures)->value_name("PREFIX"),
      "draws the surface before the first step and after at most 20 others; PREFIX and the "
      "number of the step are the name of a PNG file");
  po::options_description solver("Solver", help_width);
  auto add_to_solver = solver.add_options();
  add_to_solver("tolerance",
                po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance, "1e-06"),
                "norm of the residual, relative to that of the right-hand side");
  add_to_solver("stabilization", po::value(&o.stabilization)->value_name("C"),
                "factor of the stabilization by normal derivatives; default 0.001");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(solver)
      .add(output_options(o, "vertex, x, y, z",
                          "the property displacement, how far they moved, of the moved mesh; "
                          "pages show up to 20 of the steps, too"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require(o.steps > 0, "the argument of --steps must be positive");
  require(is_given(given, "time-step"), "give --time-step");
  require_positive(given, "time-step", o.time_step);
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require_not_negative(given, "stabilization");
  if(is_given(given, "rescaling"))
    require_choice("rescaling", o.rescaling, {"none", "area", "volume"});
  return true;
}

RL::Mean_curvature_flow_options flow_options(const Options& o) {
  RL::Mean_curvature_flow_options result;
  result.conformal = o.conformal;
  if(!o.rescaling.empty())
    result.rescaling = o.rescaling == "area"     ? RL::Rescaling::area
                       : o.rescaling == "volume" ? RL::Rescaling::volume
                                                 : RL::Rescaling::none;
  result.fixed_boundary = !o.free_boundary;
  result.tolerance = o.tolerance;
  result.stabilization = given_number(o.stabilization);
  return result;
}

// What pages and pictures show of the flow: the first surface, up to 20 of the steps, and the last.
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

Outcome flow_surface(Job& job, const Options& o) {
  const RL::Spline_space_3 space = job.make_space("each component moves on its own");
  RL::Mean_curvature_flow flow(space, flow_options(o));
  const auto progress = job.step("moving", space);
  RL::Flow_report report;
  const bool is_shown = !o.html.empty() || !o.pictures.empty();
  Step_series series(job.surface, o.steps);
  double solve_seconds = 0;
  int steps = 0;
  while(steps < o.steps && report.collapse.empty()) {
    report = flow.step(o.time_step);
    solve_seconds += report.solve_seconds;
    steps += report.collapse.empty();
    if(is_shown && series.wants(steps) && steps > series.last_step())
      series.add(steps, report.time, flow.vertex_positions());
    progress(static_cast<double>(steps) / o.steps);
    if(!report.converged)
      break;
  }
  report.solve_seconds = solve_seconds;
  job.add_solve(report);
  job.summary.add("steps", steps);
  job.summary.add("time", report.time);
  job.summary.add("moved_area", report.area);
  job.summary.add("moved_volume", report.volume);
  job.summary.add("smallest_angle", report.smallest_angle);
  job.summary.add("mean_distortion", report.mean_distortion);
  job.summary.add("largest_distortion", report.largest_distortion);
  job.summary.add("sphere_deviation", report.sphere_deviation);
  if(!report.collapse.empty())
    job.fail("after " + std::to_string(steps) + " steps " + report.collapse);

  if(is_shown && steps > series.last_step())
    series.add(steps, report.time, flow.vertex_positions());

  Outcome result = moved_outcome(job.surface, flow.vertex_positions());
  series.show_on_page(result.page);
  if(!o.pictures.empty())
    result.write_more = [series, prefix = o.pictures] { series.draw(prefix); };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("flow_surface", argc, argv, read_options, flow_surface);
}
