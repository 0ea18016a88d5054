// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Smooths, sharpens and edits a surface, and writes where its vertices are then.

#include "support/command_line.h"
#include "support/moved_surface.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/space.h"
#include "support/surface_program.h"

#include <CGAL/Restricted_laplacian_3/problems/Surface_editor.h>
#include <CGAL/Restricted_laplacian_3/problems/scale_details.h>

#include <cmath>
#include <string>

using namespace programs;
namespace params = RL::parameters;

const Help help = {"edit_surface MESH --gradient-scale B --alpha A [OPTION]...\n"
                   "       edit_surface MESH --length L [--factor F] [OPTION]...",
                   std::string(R"(
Edits a surface by the gradient of its positions x: the new ones u minimize the integral
of |grad u - B grad x|^2 + A |u - x|^2. What is much larger than 2 pi / A^(1/2) remains,
what is much smaller is multiplied by B: 0 smooths, 1 changes nothing, 2 doubles details.

With --length in place of that, what is smaller than L is multiplied by F, and what is
larger remains. With --crease-angle creases are kept: normals are smoothed, and the surface
is fitted to them.
)") + about_meshes,
                   R"(  edit_surface elephant.off --gradient-scale 3 --alpha 100 --output sharp.ply
      details are exaggerated
  edit_surface elephant.off --length 0.1 --csv positions.csv
      what is smaller than 0.1 goes
  edit_surface fandisk.off --length 0.2 --crease-angle 30 --output smooth.ply
      noise goes, and creases stay
)"};

struct Options : Common_options {
  double gradient_scale = 1, alpha = 0, anisotropic = 0, length = 0, factor = 0;
  Solver_options solver{RL::Editing_options().tolerance, false};
  std::string gradient_scale_property;
  bool has_length = false, has_crease_angle = false;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Editing", help_width);
  auto add = problem.add_options();
  add("gradient-scale", po::value(&o.gradient_scale)->value_name("B"), "factor of the gradient");
  add("gradient-scale-property", po::value(&o.gradient_scale_property)->value_name("NAME"),
      "this factor as a vertex property of MESH, a PLY file, such as strokes painted on it");
  add("alpha", po::value(&o.alpha)->value_name("A"),
      "weight of the old positions, in units of 1 / area");
  add("anisotropic", po::value(&o.anisotropic)->value_name("F")->default_value(o.anisotropic),
      "lengths grow by curvature k to (1 + F^2 k^2 / A)^(1/2), so creases survive");
  add("length", po::value(&o.length)->value_name("L"), "size of the details that are changed");
  add("factor", po::value(&o.factor)->value_name("F")->default_value(o.factor), "of these details");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(solver_options(o.solver, "default 0.001"))
      .add(output_options(o, "vertex, x, y, z",
                          "the property displacement, how far they moved, of the moved mesh"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  o.has_length = is_given(given, "length");
  o.has_crease_angle = o.has_length && is_given(given, "crease-angle");
  const bool has_property = !o.gradient_scale_property.empty();
  require(!has_property || !is_given(given, "gradient-scale"),
          "give --gradient-scale or --gradient-scale-property, not both");
  require(o.has_length != (has_property || is_given(given, "gradient-scale")),
          "give either --gradient-scale and --alpha, or --length");
  require(o.has_length != is_given(given, "alpha"), "--alpha is for --gradient-scale");
  require(o.has_length || std::isfinite(o.gradient_scale),
          "the argument of --gradient-scale must be finite");
  require_positive(given, "alpha", o.alpha);
  require_positive(given, "length", o.length);
  require_not_negative(given, "anisotropic");
  require(std::isfinite(o.factor), "the argument of --factor must be finite");
  require(!o.has_crease_angle || o.factor == 0, "--factor and --crease-angle exclude each other");
  check_solver_options(o.solver, given);
  return true;
}

Outcome edit_surface(Job& job, const Options& o) {
  RL::Editing_options options;
  options.tolerance = o.solver.tolerance;
  options.stabilization = given_number(o.solver.stabilization);
  options.anisotropic = o.anisotropic;
  if(o.has_crease_angle)
    options.crease_angle = o.space.crease_angle;
  RL::Spline_space_3 space = job.make_space("each component is edited on its own");
  RL::Edited_signal result;
  if(o.has_length) {
    space = RL::internal::space_for_details(space, o.space.depth.has_value(), options);
    if(o.has_crease_angle)
      job.summary.add("depth_of_creases", space.depth());
    options.progress = job.step("smoothing", space);
    result = o.has_crease_angle ? RL::smooth_between_creases(space, o.length, options)
                                : RL::scale_details(space, o.length, o.factor, options);
  } else {
    space = RL::internal::space_to_edit(space, o.alpha, options);
    const auto progress = job.step("editing", space);
    const RL::Surface_editor editor(space, o.alpha, options);
    if(const std::string& name = o.gradient_scale_property; !name.empty())
      result = editor.edit(vertex_function(job.surface, surface_property(job.surface, o, name), o));
    else
      result = editor.edit(o.gradient_scale);
    progress(1);
  }
  job.add_solve(result);
  return moved_outcome(job.surface, result.values);
}

int main(int argc, char* argv[]) {
  return run_surface_program("edit_surface", argc, argv, read_options, edit_surface);
}
