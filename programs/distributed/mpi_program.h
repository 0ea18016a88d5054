// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_MPI_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_MPI_PROGRAM_H

// What programs have in common that run under mpiexec.

#include "../support/color_map.h"
#include "../support/command_line.h"
#include "../support/mesh_input.h"
#include "../support/mesh_output.h"
#include "../support/point_input.h"
#include "../support/program.h"
#include "../support/table.h"

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/distributed/surface_slices.h>
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order.h>

#include <slepcsys.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace programs {

// MPI, PETSc and SLEPc as long as it exists. Their options are the arguments from the first one on
// that begins with one hyphen and has more than one letter, like -ksp_monitor.
class Petsc_session {
public:
  Petsc_session(int argc, char* argv[]) {
    int own = 1;
    const auto is_of_petsc = [](const std::string& argument) {
      return argument.size() > 2 && argument[0] == '-' && argument[1] != '-' &&
             !std::isdigit(static_cast<unsigned char>(argument[1]));
    };
    while(own < argc && !is_of_petsc(argv[own]))
      ++own;
    m_own.assign(argv, argv + own);
    m_of_petsc.assign(1, argv[0]);
    m_of_petsc.insert(m_of_petsc.end(), argv + own, argv + argc);
    int number = static_cast<int>(m_of_petsc.size());
    m_of_petsc.push_back(nullptr);
    char** arguments = m_of_petsc.data();
    MPI_Init(&number, &arguments);
    SlepcInitialize(&number, &arguments, nullptr, nullptr);
    // errors come as exceptions, and the system knows what to do with signals
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    PetscPopSignalHandler();
  }
  ~Petsc_session() {
    SlepcFinalize();
    MPI_Finalize();
  }
  Petsc_session(const Petsc_session&) = delete;
  Petsc_session& operator=(const Petsc_session&) = delete;

  // the other arguments
  int argc() const { return static_cast<int>(m_own.size()); }
  char** argv() { return m_own.data(); }

private:
  std::vector<char*> m_own, m_of_petsc;
};

// Runs the body of a program, a functor that gets a communicator and returns the exit status.
// Errors that all ranks know of become one line on the error stream of the first one. One that they
// do not know of ends all of them.
template <typename Body>
int run_mpi_program(const std::string& program, int argc, char* argv[], Body body) {
  keep_memory();
  const auto silent = [](const char*, const char*, const char*, int, const char*) {};
  CGAL::set_error_handler(silent);
  CGAL::set_warning_handler(silent);
  Petsc_session session(argc, argv);
  const RL::Communicator communicator;
  const bool is_first = communicator.rank() == 0;
  if(!is_first)
    std::cout.rdbuf(nullptr);
  try {
    int status = body(communicator, session.argc(), session.argv());
    communicator.agree([&] {
      require(!is_first || std::cout.flush(), "cannot write to the standard output stream");
    });
    return status;
  } catch(const RL::Distributed_error& e) {
    if(is_first)
      print_error(program, e.parameter().empty()
                               ? std::string(e.what())
                               : message_of(RL::Parameter_error(
                                     e.parameter(),
                                     std::string(e.what()).substr(e.parameter().size() + 1))));
    return failure;
  } catch(const std::exception& e) {
    print_error(program, dynamic_cast<const std::bad_alloc*>(&e) ? "not enough memory" : e.what());
    MPI_Abort(communicator.get(), failure);
  }
  return failure;
}

inline po::options_description mpi_output_options(Common_options& o, const std::string& table,
                                                  const std::string& properties) {
  po::options_description options("Output", help_width);
  auto add = options.add_options();
  add("csv", po::value(&o.csv)->value_name("FILE"), ("write a table: " + table).c_str());
  add("output", po::value(&o.output)->value_name("FILE"),
      ("write the mesh, a PLY file, with colors and " + properties).c_str());
  add("overwrite", po::bool_switch(&o.overwrite), "outputs may replace a file that is read");
  return options;
}

// A file in which a run leaves what it has found, and one with which it begins.
struct Continuation_options {
  std::string save, begin;
};

inline po::options_description
continuation_options(Continuation_options& o, const std::string& saved, const std::string& begin) {
  po::options_description options("Runs that go on", help_width);
  auto add = options.add_options();
  add("save", po::value(&o.save)->value_name("FILE"), saved.c_str());
  add("continue", po::value(&o.begin)->value_name("FILE"),
      (begin + "; it may be missing if it is that of --save").c_str());
  return options;
}

// What an earlier run has left, or nothing.
inline RL::Distributed_functions load_begin(const RL::Distributed_space& space,
                                            const Continuation_options& o) {
  const RL::Communicator& communicator = space.communicator();
  int is_there = o.begin.empty() ? 0 : 1;
  if(o.begin == o.save && communicator.rank() == 0)
    is_there = std::filesystem::exists(o.begin) ? 1 : 0;
  return communicator.minimum(is_there) == 1 ? RL::load_functions(space, o.begin)
                                             : RL::Distributed_functions();
}

inline po::options_description mpi_general_options(Common_options& o) {
  po::options_description options("General", help_width);
  auto add = options.add_options();
  add("quiet", po::bool_switch(&o.quiet), "print errors only");
  add("verbose", po::bool_switch(&o.verbose), "print all that --csv writes above the table");
  add_help_options(options);
  return options;
}

// What is not possible on several processes is refused.
inline void check_mpi_options(const Common_options& o, const po::variables_map& given) {
  require(o.output.empty() || extension(o.output) == ".ply",
          "the file of --output must be a PLY file");
  for(const auto& [argument, file] : this_run().outputs)
    require(!is_standard_output(file), argument + " needs a file, into which all processes write");
  require(o.space.geometry == "flat", "--geometry smooth is not possible on several processes");
  require(!o.space.paper, "--paper is not possible on several processes");
  require(given.count("maximum-memory") == 0,
          "--maximum-memory is not possible on several processes");
}

// Runs a program that reads its options, and then does what they say:
// `read_options(argc, argv, options, given)` returns false if there is nothing more to do, and
// `work(communicator, options, given)` the exit status.
template <typename Options>
int run_mpi_program(const std::string& program, int argc, char* argv[],
                    bool (*read_options)(int, char*[], Options&, po::variables_map&),
                    int (*work)(const RL::Communicator&, const Options&,
                                const po::variables_map&)) {
  return run_mpi_program(
      program, argc, argv,
      [&](const RL::Communicator& communicator, int number, char* arguments[]) -> int {
        Options o;
        po::variables_map given;
        bool is_to_do = false;
        communicator.agree([&] { is_to_do = read_options(number, arguments, o, given); });
        return is_to_do ? work(communicator, o, given) : static_cast<int>(success);
      });
}

// Reads the surface: a slice on each rank if the file permits, or all of it on the first one.
inline RL::Distributed_surface read_distributed(const RL::Communicator& communicator,
                                                const Common_options& o,
                                                const Point_options& points,
                                                const po::variables_map& given,
                                                bool& is_triangulated) {
  is_triangulated = false;
  std::optional<RL::Surface_slice> slice;
  if(extension(o.mesh) == ".ply")
    slice = RL::read_binary_ply_slice(communicator, o.mesh);
  if(slice && communicator.sum(static_cast<std::uint64_t>(slice->triangles.size())) > 0)
    return RL::Distributed_surface(communicator, std::move(*slice));
  std::optional<Mesh_input> input;
  communicator.agree([&] {
    if(communicator.rank() == 0)
      input.emplace(read_mesh_or_points(o, points, given, {}));
  });
  is_triangulated = communicator.maximum(input && input->is_triangulated ? 1 : 0) == 1;
  return RL::Distributed_surface(
      communicator, RL::slice_of_first_rank(communicator, input ? &input->surface : nullptr));
}

inline RL::Spline_space_options distributed_options(const RL::Distributed_surface& surface,
                                                    const Common_options& o) {
  RL::Spline_space_options result;
  result.depth = o.space.depth;
  if(o.space.cube_scale > 0)
    result.cube_scale = o.space.cube_scale;
  if(o.space.joining_tolerance >= 0)
    result.joining_tolerance = o.space.joining_tolerance;
  result.paper = o.space.paper;
  result.split = o.space.split;
  result.split_point_set = surface.is_point_set() && o.space.split_point_set;
  return result;
}

inline void add_space(Summary& summary, const RL::Distributed_space& space,
                      const std::string& meaning) {
  const int depth = space.depth();
  summary.add("depth", depth);
  summary.add("dimension", space.dimension(depth));
  summary.add_detail("sheets", space.number_of_sheets(depth));
  summary.add_detail("split_elements", space.level(depth).number_of_split_elements);
  if(!space.part().is_split())
    return;
  const std::uint64_t components = space.number_of_sheets(0);
  summary.add_explained("components", components,
                        components == 1 ? "" : ", the surface is disconnected: " + meaning);
}

// Values at the vertices of the slices, as a table.
inline void write_csv(const RL::Distributed_surface& surface, const std::string& file,
                      const Summary& summary, const std::vector<double>& values) {
  const RL::Communicator& communicator = surface.communicator();
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  if(communicator.rank() == 0) {
    summary.print_comments(out);
    out << "vertex,value\n";
  }
  std::uint64_t vertex = surface.first_vertices()[static_cast<std::size_t>(communicator.rank())];
  for(double value : values)
    out << vertex++ << ',' << value << '\n';
  RL::write_in_order(communicator, file, {out.str()});
}

// the smallest and the largest of the values of all ranks that are numbers
struct Range {
  Range(const RL::Communicator& communicator, const std::vector<double>& values) {
    double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
    for(double x : values)
      if(std::isfinite(x)) {
        smallest = (std::min)(smallest, x);
        largest = (std::max)(largest, x);
      }
    smallest = communicator.minimum(smallest);
    largest = communicator.maximum(largest);
    if(smallest <= largest) {
      low = smallest;
      high = largest;
    }
  }
  double low = 0, high = 0;
};

// The surface with the values and their colors, as a binary PLY file.
inline void write_ply(const RL::Distributed_surface& surface, const std::string& file,
                      const std::vector<double>& values, const Range& range) {
  const RL::Communicator& communicator = surface.communicator();
  const Color_scale scale(range.low, range.high);
  const bool has_faces = !surface.is_point_set();
  std::string header, vertices, faces;
  if(communicator.rank() == 0)
    header = internal::ply_header(surface.number_of_vertices(),
                                  has_faces ? surface.number_of_faces() : 0, {"value"});
  const auto write = [](std::string& out, auto number) {
    out.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  const std::vector<RL::Point_3>& points = surface.points();
  for(std::size_t v = 0; v < points.size(); ++v) {
    for(int axis = 0; axis < 3; ++axis)
      write(vertices, points[v][axis]);
    for(double component : scale(values[v]))
      write(vertices, static_cast<std::uint8_t>(internal::color_byte(component)));
    write(vertices, values[v]);
    for(int axis = 0; axis < 3 && !has_faces; ++axis)
      write(vertices, surface.slice().surface.normal(v)[axis]);
  }
  for(std::size_t f = 0; f < surface.slice().faces.size() && has_faces; ++f) {
    write(faces, std::uint8_t(3));
    for(std::uint32_t v : surface.slice().surface.triangle(f))
      write(faces, surface.slice().vertices[v]);
  }
  RL::write_in_order(communicator, file, {header, vertices, faces});
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_MPI_PROGRAM_H
