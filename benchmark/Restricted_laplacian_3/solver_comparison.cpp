// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast do solvers reach a given residual on the systems of this package? The stiffness matrix
// of a mesh at some depths, and for each solver and tolerance: seconds of setup and solution,
// iterations, the residual that was reached, and memory. After the paper's section 5.4 and table 2
// (tolerance 5e-3). With --screening A the matrix is S + A M / h^2, h the width of the cells, and
// with --matrix mass it is M / h^2, that of a fit. (In each of them with the stabilization.)
//
// The right-hand side (--rhs) is
// - x: the load of the x coordinate, without screening minus its mean;
// - random: the same of random values at the vertices;
// - normals: that of figure 7, the load of the gradient of the x component of the vertex normals,
//   and with screening A / h^2 times the load of the component itself. For the mass matrix the
//   latter only.
//
// All solvers get the same consistent system: kernel and near-kernel are left in it.
// - ours, ours_point: the Poisson_solver of this package with the patch smoother, its default, and
//   with point Gauss-Seidel. It takes the matrices of coarser levels from the assembly; what they
//   add to the time of the assembly counts as setup.
// - ours_paper: the algorithm of the paper, W-cycles with point Gauss-Seidel, not accelerated by
//   conjugate gradients. With --paper also its space, and with --stabilization 0 its matrix.
// - amg1, amg2, hmis, cgc, alone and as preconditioners of conjugate gradients (_pcg): hypre, see
//   support/boomer_amg.h. Two threads are two processes: Debian's hypre is built without OpenMP.
// - cholmod: supernodal factorization of A + 1e-10 diag(A), which preconditions conjugate
//   gradients; iterations counts the solutions with the factor, 1 where the factor suffices
// - ic_cg: Eigen's conjugate gradients with its incomplete factorization; one thread only
//
// Each figure is the median of the repetitions (--repetitions), with the residual
// |b - A x| / |b| computed here, in double precision, from the returned solution. A solver that
// does not reach the tolerance within ten times what ours needs (at least --limit seconds) or
// --iterations counts as `no`; its figures are those when it was stopped, of one repetition. The
// column `at_ours` is the residual of a slower solver after the time that ours took in total, by
// the iterations that fit into this time (1: its setup alone takes longer). The column `/ours` is
// the total relative to that of ours with as many threads, where ours reaches the tolerance.
//
// Each solver has a process of its own. Memory is the peak beyond what this process has in use at
// its start (the caller's matrix among it), summed over processes.
//
// usage: solver_comparison [OPTION]... [MESH]...

#include "support/boomer_amg.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/package.h"
#include "support/vertex_normals.h"

#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <HYPRE.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;
using Matrix = RL::Sparse_matrix;
using Vector = Eigen::VectorXd;

namespace {

// What is asked of a solver.
struct Protocol {
  struct Target {
    double tolerance;
    double our_seconds; // setup and solution by this package; 0 when it is itself measured
  };
  std::vector<Target> targets;
  int repetitions = 3;
  int maximum_iterations = 1000;
  double limit_seconds = 20;
};

// The answer, one for each target.
struct Record {
  double setup_seconds, solve_seconds, residual, residual_at_ours;
  int iterations;
  bool is_reached;
};

// One solution: the number of iterations and the time they took.
struct Solution {
  int iterations;
  double seconds;
};

// Runs a solver. It has
// - setup(), returns seconds
// - solve(tolerance, maximum_iterations), from the guess 0, returns a Solution
// - residual() of the last solution
// - agree(i), which returns the i of the first process to all.
template <class Solver> std::vector<Record> measure(Solver& solver, const Protocol& protocol) {
  constexpr int probe_iterations = 5;
  constexpr double rounding = 1.01; // recursive residuals differ that much from true ones
  const std::size_t n = protocol.targets.size();
  std::vector<double> setups;
  std::vector<std::vector<double>> solves(n);
  std::vector<Record> records(n);
  double seconds_per_iteration = 0;
  const auto iterations_in = [&](double seconds) {
    const double number = std::clamp(seconds / seconds_per_iteration, 0., 1e6);
    return solver.agree(std::min(protocol.maximum_iterations, static_cast<int>(number)));
  };
  for(int repetition = 0; repetition < protocol.repetitions; ++repetition) {
    setups.push_back(solver.setup());
    if(repetition == 0) {
      const Solution probe = solver.solve(1e-12, probe_iterations);
      seconds_per_iteration = probe.seconds / std::max(1, probe.iterations);
    }
    for(std::size_t k = 0; k < n; ++k) {
      const auto [tolerance, our_seconds] = protocol.targets[k];
      Record& record = records[k];
      if(repetition > 0 && !record.is_reached)
        continue;
      const double limit = std::max(protocol.limit_seconds, 10 * our_seconds);
      const Solution solution = solver.solve(tolerance, std::max(1, iterations_in(limit)));
      solves[k].push_back(solution.seconds);
      if(solution.iterations > 0)
        seconds_per_iteration =
            std::min(seconds_per_iteration, solution.seconds / solution.iterations);
      record.iterations = solution.iterations;
      record.residual = solver.residual();
      record.is_reached = record.residual <= rounding * tolerance;
      if(repetition > 0)
        continue;
      record.residual_at_ours = record.residual;
      const bool is_slower = setups[0] + solution.seconds > our_seconds;
      if(our_seconds > 0 && solver.agree(is_slower)) {
        const int fitting = iterations_in(our_seconds - setups[0]);
        record.residual_at_ours = 1;
        if(fitting > 0) {
          solver.solve(tolerance, fitting);
          record.residual_at_ours = solver.residual();
        }
      }
    }
  }
  for(std::size_t k = 0; k < n; ++k) {
    records[k].setup_seconds = median(setups);
    records[k].solve_seconds = median(solves[k]);
  }
  return records;
}

template <class Work> double seconds_of(Work&& work) {
  const double begin = seconds_now();
  work();
  return seconds_now() - begin;
}

// what solvers in one process share
class Local_solver {
public:
  Local_solver(const Matrix& a, const Vector& b) : m_a(&a), m_b(&b) {}
  int agree(int i) const { return i; }
  double residual() const { return true_residual(*m_a, *m_b, m_x); }

protected:
  const Matrix* m_a;
  const Vector* m_b;
  Vector m_x;
};

class Package_solver : public Local_solver {
public:
  Package_solver(const RL::Spline_space_3& space, const Matrix& a, const Vector& b,
                 const Vector& integrals, double screening, std::string name, int threads,
                 Coarse_levels coarse)
    : Local_solver(a, b), m_space(space), m_integrals(integrals), m_screening(screening),
      m_name(std::move(name)), m_threads(threads), m_coarse(std::move(coarse)) {}

  // The solver takes the matrices over; the time of copying them is not its own.
  double setup() {
    m_solver.reset();
    Matrix a = *m_a;
    std::vector<Matrix> coarse = m_coarse.matrices;
    RL::Poisson_solver_options options =
        solver_options(m_name == "ours" ? "patch" : "point", m_threads, 1e-3, m_maximum_iterations);
    if(m_name == "ours_paper") {
      options.stand_alone_multigrid = true;
      options.cycle = RL::Cycle::W;
    }
    return m_coarse.seconds + seconds_of([&] {
             coarse.emplace_back().swap(a);
             m_solver.emplace(RL::internal::multigrid_solver(
                 m_space, {std::move(coarse), m_integrals, m_screening * m_integrals}, options));
           });
  }
  // The limit is fixed when a solver is made: the time of making another one does not count.
  Solution solve(double tolerance, int maximum_iterations) {
    if(maximum_iterations != m_maximum_iterations) {
      m_maximum_iterations = maximum_iterations;
      setup();
    }
    RL::Solve_report report;
    const double seconds = seconds_of([&] { report = m_solver->solve(*m_b, m_x, tolerance); });
    return {report.iterations, seconds};
  }

private:
  const RL::Spline_space_3& m_space;
  const Vector& m_integrals;
  double m_screening;
  std::string m_name;
  int m_threads;
  Coarse_levels m_coarse;
  int m_maximum_iterations = 1000;
  std::optional<RL::Multigrid_solver> m_solver;
};

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
class Cholmod_solver : public Local_solver {
public:
  static constexpr double relative_shift = 1e-10;

  Cholmod_solver(const Matrix& a, const Vector& b, bool use_metis)
    : Local_solver(a, b), m_shifted(a) {
    m_shifted.diagonal() *= 1 + relative_shift;
    m_cholesky.cholmod().print = 0;
    m_cholesky.cholmod().nmethods = 1;
    m_cholesky.cholmod().method[0].ordering = use_metis ? CHOLMOD_METIS : CHOLMOD_AMD;
  }

  double setup() {
    return seconds_of([&] {
      m_cholesky.compute(m_shifted);
      if(m_cholesky.info() != Eigen::Success)
        throw std::runtime_error("CHOLMOD: the factorization failed");
    });
  }
  Solution solve(double tolerance, int maximum_iterations) {
    int iterations = 0;
    const double seconds =
        seconds_of([&] { iterations = conjugate_gradient(tolerance, maximum_iterations); });
    return {iterations, seconds};
  }

private:
  int conjugate_gradient(double tolerance, int maximum_iterations) {
    const double target = tolerance * m_b->norm();
    m_x = Vector::Zero(m_b->size());
    Vector r = *m_b, p = Vector::Zero(m_b->size());
    double rho = 1;
    int iteration = 0;
    while(iteration < maximum_iterations && r.norm() > target) {
      const Vector z = m_cholesky.solve(r);
      const double next = r.dot(z);
      p = z + (iteration == 0 ? 0 : next / rho) * p;
      rho = next;
      const Vector q = m_a->selfadjointView<Eigen::Lower>() * p;
      const double step = rho / p.dot(q);
      m_x += step * p;
      r -= step * q;
      ++iteration;
    }
    return iteration;
  }

  Matrix m_shifted;
  Eigen::CholmodSupernodalLLT<Matrix> m_cholesky;
};
#endif

class Ic_cg_solver : public Local_solver {
public:
  Ic_cg_solver(const Matrix& a, const Vector& b) : Local_solver(a, b), m_rows(a) {}

  double setup() {
    return seconds_of([&] { m_cg.compute(m_rows); });
  }
  Solution solve(double tolerance, int maximum_iterations) {
    m_cg.setTolerance(tolerance);
    m_cg.setMaxIterations(maximum_iterations);
    const double seconds = seconds_of([&] { m_x = m_cg.solve(*m_b); });
    return {static_cast<int>(m_cg.iterations()), seconds};
  }

private:
  using Row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>; // faster to multiply
  Row_matrix m_rows;
  Eigen::ConjugateGradient<Row_matrix, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double>>
      m_cg;
};

// The system in a file, for solvers that run in programs of their own.
class System_file {
public:
  System_file(const std::string& path, const Matrix& a, const Vector& b) : m_path(path) {
    std::ofstream out(path, std::ios::binary);
    const auto write = [&](const auto* data, std::size_t count) {
      out.write(reinterpret_cast<const char*>(data),
                static_cast<std::streamsize>(count * sizeof *data));
    };
    const std::array<int, 2> sizes = {static_cast<int>(a.rows()), static_cast<int>(a.nonZeros())};
    write(sizes.data(), 2);
    write(a.outerIndexPtr(), sizes[0] + 1);
    write(a.innerIndexPtr(), sizes[1]);
    write(a.valuePtr(), sizes[1]);
    write(b.data(), sizes[0]);
    if(!out.flush())
      throw std::runtime_error("cannot write " + path);
  }
  System_file(const System_file&) = delete;
  System_file& operator=(const System_file&) = delete;
  ~System_file() { std::remove(m_path.c_str()); }
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

// BoomerAMG on the rows of one process, read from a file.
class Hypre_solver {
public:
  explicit Hypre_solver(const std::string& path) {
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_size);
    std::ifstream in(path, std::ios::binary);
    const auto read = [&](auto& to, std::size_t skipped, std::size_t count, std::size_t left) {
      const auto size = static_cast<std::streamoff>(sizeof to[0]);
      in.seekg(static_cast<std::streamoff>(skipped) * size, std::ios::cur);
      to.resize(count);
      in.read(reinterpret_cast<char*>(to.data()), static_cast<std::streamoff>(count) * size);
      in.seekg(static_cast<std::streamoff>(left) * size, std::ios::cur);
    };
    std::vector<int> sizes;
    read(sizes, 0, 2, 0);
    const int n = sizes[0], entries = sizes[1];
    for(int i = 0; i <= m_size; ++i)
      m_firsts.push_back(static_cast<int>(std::int64_t(n) * i / m_size));
    const int first = m_firsts[m_rank], last = m_firsts[m_rank + 1];
    read(m_begins, first, last - first + 1, n - last);
    const int begin = m_begins.front(), end = m_begins.back();
    for(int& i : m_begins)
      i -= begin;
    read(m_columns, begin, end - begin, entries - end);
    read(m_values, begin, end - begin, entries - end);
    read(m_b, first, last - first, 0);
    if(!in)
      throw std::runtime_error("cannot read " + path);
    m_x.resize(m_b.size());
    m_memory_before = memory_mib("VmRSS");
    m_amg = std::make_unique<Boomer_amg>(MPI_COMM_WORLD, first, last, m_begins.data(),
                                         m_columns.data(), m_values.data());
  }

  bool is_first() const { return m_rank == 0; }
  void set_configuration(const std::string& name) {
    m_configuration = boomer_amg_configuration(name);
  }
  double setup() {
    return seconds([&] { m_amg->setup(m_configuration); });
  }
  Solution solve(double tolerance, int maximum_iterations) {
    Solution solution;
    solution.seconds = seconds([&] {
      solution.iterations = m_amg->solve(m_b.data(), m_x.data(), tolerance, maximum_iterations);
    });
    return solution;
  }
  int agree(int i) const {
    MPI_Bcast(&i, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return i;
  }
  double residual() const {
    std::vector<double> x(m_firsts.back());
    std::vector<int> counts;
    for(int i = 0; i < m_size; ++i)
      counts.push_back(m_firsts[i + 1] - m_firsts[i]);
    MPI_Allgatherv(m_x.data(), counts[m_rank], MPI_DOUBLE, x.data(), counts.data(), m_firsts.data(),
                   MPI_DOUBLE, MPI_COMM_WORLD);
    std::array<double, 2> squares = {0, 0};
    for(std::size_t i = 0; i < m_b.size(); ++i) {
      double r = m_b[i];
      for(int k = m_begins[i]; k < m_begins[i + 1]; ++k)
        r -= m_values[k] * x[m_columns[k]];
      squares[0] += r * r;
      squares[1] += m_b[i] * m_b[i];
    }
    MPI_Allreduce(MPI_IN_PLACE, squares.data(), 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return std::sqrt(squares[0] / squares[1]);
  }
  double peak_mib() const {
    double peak = memory_mib("VmHWM") - m_memory_before;
    MPI_Allreduce(MPI_IN_PLACE, &peak, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return peak;
  }

private:
  template <class Work> static double seconds(Work&& work) {
    MPI_Barrier(MPI_COMM_WORLD);
    const double begin = seconds_now();
    work();
    MPI_Barrier(MPI_COMM_WORLD);
    return seconds_now() - begin;
  }

  int m_rank = 0, m_size = 1;
  std::vector<int> m_firsts, m_begins, m_columns;
  std::vector<double> m_values, m_b, m_x;
  double m_memory_before = 0;
  std::unique_ptr<Boomer_amg> m_amg;
  Boomer_amg_configuration m_configuration;
};

const char* const worker_mark = "--hypre-worker";

// The program as one of hypre's processes: the arguments are those that run_hypre() gives.
int hypre_worker(int argc, char* argv[]) {
  const Hypre_session session;
  Protocol protocol;
  const std::string file = argv[2], configuration = argv[3];
  protocol.repetitions = std::stoi(argv[4]);
  protocol.maximum_iterations = std::stoi(argv[5]);
  protocol.limit_seconds = std::stod(argv[6]);
  counts_processor_time() = std::stoi(argv[7]) != 0;
  for(int i = 8; i + 1 < argc; i += 2)
    protocol.targets.push_back({std::stod(argv[i]), std::stod(argv[i + 1])});
  Hypre_solver solver(file);
  solver.set_configuration(configuration);
  const std::vector<Record> records = measure(solver, protocol);
  const double peak = solver.peak_mib();
  if(solver.is_first())
    for(const Record& r : records)
      std::printf("%.17g %.17g %.17g %.17g %d %d %.17g\n", r.setup_seconds, r.solve_seconds,
                  r.residual, r.residual_at_ours, r.iterations, r.is_reached, peak);
  return 0;
}

struct Options {
  std::vector<std::string> meshes = {"bunny_closed_70k", "armadillo", "fandisk_32k", "pulley_28k",
                                     "cow_5k8"};
  std::vector<int> depths = {5, 6, 7, 8}, threads = {1, 2};
  std::vector<double> tolerances = {5e-3, 1e-5, 1e-8};
  std::vector<std::string> solvers = {"ours",     "ours_point", "amg1",    "amg1_pcg", "amg2",
                                      "amg2_pcg", "cgc",        "cgc_pcg", "cholmod",  "ic_cg"};
  double stabilization = default_stabilization();
  bool is_split = true, is_paper = false;
  System_factors factors;
  double memory_gib = 12;
  std::string rhs = "x";
  std::string mpirun = "mpirun --bind-to none --mca mpi_yield_when_idle 1", ordering = "metis";
  std::string scratch = std::filesystem::temp_directory_path();
  Protocol protocol;

  // A process that takes that long is ended, whatever it does.
  unsigned process_seconds() const {
    double seconds = 0;
    for(const Protocol::Target& target : protocol.targets)
      seconds += std::max(protocol.limit_seconds, 10 * target.our_seconds);
    return static_cast<unsigned>(60 + 3 * (1 + protocol.repetitions) * seconds);
  }
};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::vector<Record> run_hypre(const Options& o, const std::string& program, const std::string& file,
                              const std::string& configuration, int processes, double& peak_mib) {
  std::string command =
      "ulimit -d " + std::to_string(static_cast<long>(o.memory_gib * (1 << 20))) +
      "; exec timeout " + std::to_string(o.process_seconds()) + " " + o.mpirun + " -np " +
      std::to_string(processes) + " " + program + " " + worker_mark + " " + file + " " +
      configuration + " " + std::to_string(o.protocol.repetitions) + " " +
      std::to_string(o.protocol.maximum_iterations) + " " +
      std::to_string(o.protocol.limit_seconds) + " " + std::to_string(int(counts_processor_time()));
  for(const auto& [tolerance, our_seconds] : o.protocol.targets)
    command += " " + number(tolerance) + " " + number(our_seconds);
  std::fflush(nullptr);
  FILE* pipe = popen(command.c_str(), "r");
  if(!pipe)
    return {};
  std::vector<Record> records;
  Record r;
  int is_reached = 0;
  while(std::fscanf(pipe, "%lf %lf %lf %lf %d %d %lf", &r.setup_seconds, &r.solve_seconds,
                    &r.residual, &r.residual_at_ours, &r.iterations, &is_reached, &peak_mib) == 7) {
    r.is_reached = is_reached != 0;
    records.push_back(r);
  }
  pclose(pipe);
  return records;
}

// One system, and what the solvers did with it.
class Comparison {
public:
  Comparison(const Options& o, const std::string& program, const std::string& mesh, int depth,
             const RL::Triangulated_surface_3& surface)
    : m_options(o), m_program(program), m_mesh(mesh), m_depth(depth),
      m_space(surface, options_of_space(1)) {
    if(m_space.is_split() && m_space.octree().number_of_sheets(0) != 1)
      throw std::runtime_error("the surface has several components");
    RL::Operators both = operators(m_space, o.stabilization);
    m_a = std::move(both.stiffness);
    m_a.coeffs() *= o.factors.stiffness;
    m_a.coeffs() += screening() * both.mass.coeffs();
    m_integrals = RL::assemble_element_integrals(m_space);
    m_b = right_hand_side(surface);
    for(double tolerance : o.tolerances)
      m_options.protocol.targets.push_back({tolerance, 0});
  }

  void run() {
    const bool needs_file =
        std::any_of(m_options.solvers.begin(), m_options.solvers.end(), is_hypre);
    std::optional<System_file> file;
    if(needs_file)
      file.emplace(m_options.scratch + "/solver_comparison_" + std::to_string(getpid()), m_a, m_b);
    for(int threads : m_options.threads) {
      for(const std::string& solver : m_options.solvers)
        if(solver.rfind("ours", 0) == 0)
          run_ours(solver, threads);
        else
          run_peer(solver, threads, file ? file->path() : "");
      print_summary(threads);
    }
  }

  // the lines of the figure: one for each number of threads and tolerance
  const std::vector<std::string>& summary() const { return m_summary; }

private:
  RL::Spline_space_options options_of_space(int threads) const {
    RL::Spline_space_options options = space_options(m_depth, m_options.is_split, threads);
    options.paper = m_options.is_paper;
    return options;
  }
  // the factor of the mass matrix in units of 1 / length^2
  double screening() const {
    const double h = m_space.octree().cell_width(m_depth);
    return m_options.factors.mass / (h * h);
  }

  Vector right_hand_side(const RL::Triangulated_surface_3& surface) const {
    const Vertex_normals normals(surface);
    std::mt19937 generator(1);
    std::normal_distribution<double> distribution;
    std::vector<double> f;
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      f.push_back(m_options.rhs == "x"         ? surface.point(v).x()
                  : m_options.rhs == "normals" ? normals.at_vertex[v].x()
                                               : distribution(generator));
    Vector b = RL::assemble_load(m_space, RL::Linear_surface_function<double>(std::move(f)));
    if(m_options.rhs == "normals") {
      b *= screening();
      b += m_options.factors.stiffness *
           RL::assemble_gradient_load(m_space, [&](const RL::Surface_point& p) {
             return normals.gradients_of_face[3 * p.face];
           });
    } else if(screening() == 0)
      b -= m_integrals * (b.sum() / m_integrals.sum());
    return b;
  }

  static bool is_hypre(const std::string& solver) {
    return solver.rfind("amg", 0) == 0 || solver.rfind("cgc", 0) == 0 ||
           solver.rfind("hmis", 0) == 0 || solver.find(':') != std::string::npos;
  }

  void run_ours(const std::string& name, int threads) {
    if(name != "ours" && name != "ours_point" && name != "ours_paper")
      throw std::invalid_argument("there is no solver " + name);
    if(threads > 1 && !is_parallel_available()) {
      std::printf("# ours has no threads\n");
      return;
    }
    for(Protocol::Target& target : m_options.protocol.targets)
      target.our_seconds = 0;
    double peak = 0;
    const std::vector<Record> records =
        in_child_process<Record>(m_options.process_seconds(), peak, [&] {
          [[maybe_unused]] const auto limited = limit_threads(threads);
          const RL::Spline_space_3 space(m_space.surface(), options_of_space(threads));
          Package_solver solver(space, m_a, m_b, m_integrals, screening(), name, threads,
                                coarse_levels(space, m_options.factors, m_options.stabilization));
          return measure(solver, m_options.protocol);
        });
    if(name == "ours")
      for(std::size_t k = 0; k < records.size(); ++k) {
        m_our_seconds[k] = records[k].setup_seconds + records[k].solve_seconds;
        m_our_reached[k] = records[k].is_reached;
      }
    print(name, threads, records, peak);
  }

  void run_peer(const std::string& solver, int threads, const std::string& file) {
    for(std::size_t k = 0; k < m_options.protocol.targets.size(); ++k)
      m_options.protocol.targets[k].our_seconds = m_our_seconds[k];
    double peak = 0;
    std::vector<Record> records;
    if(is_hypre(solver)) {
      records = run_hypre(m_options, m_program, file, solver, threads, peak);
    } else if(solver == "ic_cg") {
      if(threads > 1)
        return;
      records = in_child_process<Record>(m_options.process_seconds(), peak, [&] {
        Ic_cg_solver ic_cg(m_a, m_b);
        return measure(ic_cg, m_options.protocol);
      });
    } else if(solver == "cholmod") {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
      records = in_child_process<Record>(m_options.process_seconds(), peak, [&] {
        set_blas_threads(threads);
        Cholmod_solver cholmod(m_a, m_b, m_options.ordering == "metis");
        return measure(cholmod, m_options.protocol);
      });
#else
      std::printf("# built without CHOLMOD\n");
      return;
#endif
    } else {
      throw std::invalid_argument("there is no solver " + solver);
    }
    print(solver, threads, records, peak);
  }

  void print(const std::string& solver, int threads, const std::vector<Record>& records,
             double peak_mib) {
    if(records.empty())
      std::printf("# %s, %s, depth %d, %d threads: failed, or out of memory or time\n",
                  solver.c_str(), m_mesh.c_str(), m_depth, threads);
    for(std::size_t k = 0; k < records.size(); ++k) {
      const Record& r = records[k];
      const double total = r.setup_seconds + r.solve_seconds;
      std::printf("%-18s %5d %8td %9td %-12s %2d %7.0e %8.3f %8.3f %8.3f %5d %9.2e %3s %9.2e %7.0f "
                  "%8.2f\n",
                  m_mesh.c_str(), m_depth, m_a.rows(), m_a.nonZeros(), solver.c_str(), threads,
                  m_options.tolerances[k], r.setup_seconds, r.solve_seconds, total, r.iterations,
                  r.residual, r.is_reached ? "yes" : "no", r.residual_at_ours, peak_mib,
                  m_our_reached[k] ? total / m_our_seconds[k] : std::nan(""));
      if(r.is_reached)
        m_totals[{threads, k, solver}] = total;
    }
    std::fflush(stdout);
  }

  // the best of some solvers that reached the tolerance, NaN if none did
  double best(int threads, std::size_t k, const std::vector<std::string>& solvers) const {
    double seconds = std::nan("");
    for(const std::string& solver : solvers) {
      const auto found = m_totals.find({threads, k, solver});
      if(found != m_totals.end())
        seconds = std::fmin(seconds, found->second);
    }
    return seconds;
  }

  void print_summary(int threads) {
    for(std::size_t k = 0; k < m_options.tolerances.size(); ++k) {
      char line[256];
      std::snprintf(line, sizeof line, "%-18s %5d %8td %2d %7.0e %8.3f %8.3f %8.3f %8.3f %8.3f",
                    m_mesh.c_str(), m_depth, m_a.rows(), threads, m_options.tolerances[k],
                    best(threads, k, {"ours"}), best(threads, k, {"amg1", "amg1_pcg"}),
                    best(threads, k, {"amg2", "amg2_pcg", "hmis", "hmis_pcg", "cgc", "cgc_pcg"}),
                    best(threads, k, {"cholmod"}), best(threads, k, {"ic_cg"}));
      m_summary.emplace_back(line);
    }
  }

  Options m_options;
  std::string m_program, m_mesh;
  int m_depth;
  RL::Spline_space_3 m_space;
  Matrix m_a;
  Vector m_b, m_integrals;
  std::map<std::size_t, double> m_our_seconds; // setup and solution, for each tolerance
  std::map<std::size_t, bool> m_our_reached;
  std::map<std::tuple<int, std::size_t, std::string>, double> m_totals;
  std::vector<std::string> m_summary;
};

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: solver_comparison [OPTION]... [MESH]...");
  bool is_quick = false, is_unsplit = false;
  std::string matrix = "stiffness";
  line.add("mesh", o.meshes, "files, or names in the folder of shared meshes");
  line.add("depth", o.depths, "5 6 7 8");
  line.add("threads", o.threads, "1 2");
  line.add("tolerance", o.tolerances, "5e-3 1e-5 1e-8");
  line.add(
      "solver", o.solvers,
      "ours ours_point ours_paper amg1 amg1_pcg amg2 amg2_pcg hmis hmis_pcg cgc cgc_pcg cholmod "
      "ic_cg, ours the first; or a configuration of support/boomer_amg.h");
  line.add("repetitions", o.protocol.repetitions);
  line.add("iterations", o.protocol.maximum_iterations);
  line.add("limit", o.protocol.limit_seconds,
           "least number of seconds after which a peer is stopped");
  line.add(
      "rhs", o.rhs,
      "x: the coordinate; random: independent normal values at the vertices; normals: the gradient "
      "of the x component of the vertex normals");
  line.add("matrix", matrix, "stiffness or mass");
  line.add("screening", o.factors.mass, "weight of the mass matrix, in units of 1 / h^2");
  line.add("stabilization", o.stabilization,
           "of the normal derivative; 0 is the system of the paper");
  line.add("unsplit", is_unsplit, "elements are not split");
  line.add("paper", o.is_paper, "the space of the paper");
  line.add("processor-time", counts_processor_time(),
           "seconds of the processor, for one thread on a machine that is busy otherwise");
  line.add("ordering", o.ordering, "of cholmod: metis or amd");
  line.add("memory", o.memory_gib, "GiB that a process of hypre may take");
  line.add("mpirun", o.mpirun, "starts hypre's processes");
  line.add("scratch", o.scratch, "folder for the systems");
  line.add("quick", is_quick, "one mesh, depths 5 and 6, one repetition");
  line.add_positional("mesh");
  if(!line.read(argc, argv))
    return false;
  if(is_quick) {
    o.protocol.repetitions = 1;
    o.depths = {5, 6};
    if(!line.has("mesh"))
      o.meshes.resize(1);
  }
  if(counts_processor_time() && !line.has("threads"))
    o.threads = {1};
  if(counts_processor_time() && o.threads != std::vector<int>{1})
    throw std::invalid_argument("--processor-time is for one thread");
  o.is_split = !is_unsplit && !o.is_paper;
  if(o.rhs != "x" && o.rhs != "random" && o.rhs != "normals")
    throw std::invalid_argument("--rhs is x, random or normals");
  if(matrix != "stiffness" && matrix != "mass")
    throw std::invalid_argument("--matrix is stiffness or mass");
  if(matrix == "mass")
    o.factors = {0, 1};
  return true;
}

int compare(int argc, char* argv[]) {
  Options o;
  if(!read_options(argc, argv, o))
    return 0;
  set_blas_threads(1);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe");
  print_header(argc, argv);
  std::printf("# median of %d repetitions, %s; %s elements; stabilization %g; hypre %s, one "
              "process for each thread\n",
              o.protocol.repetitions,
              counts_processor_time() ? "processor time" : "wall-clock time",
              o.is_paper ? "paper's" : (o.is_split ? "split" : "unsplit"), o.stabilization,
              HYPRE_RELEASE_VERSION);
  std::printf("# %-16s %5s %8s %9s %-12s %2s %7s %8s %8s %8s %5s %9s %3s %9s %7s %8s\n", "mesh",
              "depth", "unknowns", "entries", "solver", "th", "tol", "setup_s", "solve_s",
              "total_s", "iter", "residual", "ok", "at_ours", "MiB", "/ours");
  std::vector<std::string> summary;
  for(const std::string& mesh : o.meshes) {
    const auto surface = find_mesh(mesh);
    if(!surface)
      continue;
    const std::string name = std::filesystem::path(mesh).stem();
    for(int depth : o.depths) {
      Comparison comparison(o, program, name, depth, *surface);
      comparison.run();
      const auto& lines = comparison.summary();
      summary.insert(summary.end(), lines.begin(), lines.end());
    }
  }
  for(int threads : o.threads)
    for(double tolerance : o.tolerances) {
      char selected[32];
      std::snprintf(selected, sizeof selected, " %2d %7.0e ", threads, tolerance);
      std::printf("\n\n# %d threads, residual %.0e\n", threads, tolerance);
      std::printf("# %-16s %5s %8s %2s %7s %8s %8s %8s %8s %8s\n", "mesh", "depth", "unknowns",
                  "th", "tol", "ours", "amg1", "amg2", "cholmod", "ic_cg");
      for(const std::string& line : summary)
        if(line.find(selected) != std::string::npos)
          std::printf("%s\n", line.c_str());
    }
  return 0;
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("solver_comparison", [&] {
    if(argc > 8 && std::string(argv[1]) == worker_mark)
      return hypre_worker(argc, argv);
    return compare(argc, argv);
  });
}
