// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_EXPOSURE_GAINS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_EXPOSURE_GAINS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Logarithms of ratios of the colors of pairs of scans where both cover the surface, by channel.
class Exposure_ratios {
public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  using Ratios = std::array<std::vector<double>, 3>;

  explicit Exposure_ratios(const std::vector<Back_projection>& scans) {
    std::vector<std::size_t> next(scans.size(), 0);
    std::vector<std::uint32_t> here;
    std::uint32_t vertex = 0;
    for(;; ++vertex) {
      if(!find_next_vertex(scans, next, vertex))
        return;
      here.clear();
      for(std::uint32_t s = 0; s < scans.size(); ++s)
        if(next[s] < scans[s].vertices.size() && scans[s].vertices[next[s]] == vertex)
          here.push_back(s);
      for(std::size_t i = 0; i < here.size(); ++i)
        for(std::size_t j = i + 1; j < here.size(); ++j)
          add(scans, next, {here[i], here[j]});
      for(std::uint32_t s : here)
        ++next[s];
    }
  }

  const std::map<Pair, Ratios>& of_pairs() const { return m_ratios; }

private:
  static bool find_next_vertex(const std::vector<Back_projection>& scans,
                               const std::vector<std::size_t>& next, std::uint32_t& vertex) {
    bool is_found = false;
    for(std::size_t s = 0; s < scans.size(); ++s)
      if(next[s] < scans[s].vertices.size()) {
        const std::uint32_t v = scans[s].vertices[next[s]];
        vertex = is_found ? (std::min)(vertex, v) : v;
        is_found = true;
      }
    return is_found;
  }

  void add(const std::vector<Back_projection>& scans, const std::vector<std::size_t>& at,
           const Pair& pair) {
    // Where one scan sees the surface badly, and in colors that are cut off or nearly black, the
    // ratio says little of the exposures.
    constexpr double smallest_quality = 0.1, darkest = 0.02, brightest = 0.98;
    const Back_projection &a = scans[pair.first], &b = scans[pair.second];
    const std::size_t i = at[pair.first], j = at[pair.second];
    if(!((std::min)(a.qualities[i], b.qualities[j]) >= smallest_quality))
      return;
    for(int k = 0; k < 3; ++k) {
      const double x = a.colors[i][k], y = b.colors[j][k];
      if((std::min)(x, y) > darkest && (std::max)(x, y) < brightest)
        m_ratios[pair][k].push_back(std::log(x / y));
    }
  }

  std::map<Pair, Ratios> m_ratios;
};

/// Factors that make the colors of scans agree where they overlap, for each scan and channel.
/// Their logarithms \f$g_s\f$ minimize \f$\sum n_{st} (g_s + m_{st} - g_t)^2\f$ over pairs,
/// where \f$m_{st}\f$ is the median of the logarithms of the ratios of their \f$n_{st}\f$ common
/// colors; they sum to 0 among scans that are connected by overlaps.
/// \throws Numerical_error the factorization fails
inline std::vector<Rgb_color> exposure_gains(const std::vector<Back_projection>& scans) {
  // A weak weight of g^2 fixes what pairs leave undetermined.
  constexpr double relative_regularization = 1e-9;
  const Exposure_ratios ratios(scans);
  const auto n = static_cast<Eigen::Index>(scans.size());
  std::vector<Rgb_color> gains(scans.size(), Rgb_color{1, 1, 1});
  for(int k = 0; k < 3; ++k) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for(const auto& [pair, of_pair] : ratios.of_pairs()) {
      const auto weight = static_cast<double>(of_pair[k].size());
      const double difference = median(of_pair[k]);
      const Eigen::Index s = pair.first, t = pair.second;
      a(s, s) += weight;
      a(t, t) += weight;
      a(s, t) -= weight;
      a(t, s) -= weight;
      b[s] -= weight * difference;
      b[t] += weight * difference;
    }
    const double largest = a.diagonal().maxCoeff();
    if(!(largest > 0))
      continue; // no overlaps
    a.diagonal().array() += relative_regularization * largest;
    const Eigen::LDLT<Eigen::MatrixXd> factor(a);
    if(factor.info() != Eigen::Success)
      throw Numerical_error("the factorization for the exposures of the scans failed");
    const Eigen::VectorXd logarithms = factor.solve(b);
    for(std::size_t s = 0; s < scans.size(); ++s)
      gains[s][k] = std::exp(logarithms[static_cast<Eigen::Index>(s)]);
  }
  return gains;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_EXPOSURE_GAINS_H
