// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SCREENING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SCREENING_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Mass_weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/vector_fields.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A weight as the assembly takes it: a number, or a function with its degree on the triangles. The
/// function is of one type for all weights, so that the assembly is compiled once.
struct Screening_weight {
  double constant = 0;
  std::function<double(const Surface_point&)> function;
  int degree = 0;
};

/// What pulls the solution to given values: `K` targets \f$g\f$, a weight, and the mean where there
/// are none. A function object on `Surface_point`, or `Param_not_found` in its place.
template <int K, class Target, class Weight> class Screening {
public:
  using Values = Eigen::Matrix<double, K, 1>;
  static constexpr bool has_target = !std::is_same_v<Target, internal_np::Param_not_found>;
  static constexpr bool has_weight = !std::is_same_v<Weight, internal_np::Param_not_found>;
  static constexpr bool has_constant_weight = std::is_arithmetic_v<Weight>;

  template <class NamedParameters>
  Screening(const Target& target, const Weight& weight, const NamedParameters& np)
    : m_target(target), m_weight(weight) {
    m_mean.setZero();
    if constexpr(has_target)
      static_assert(Components_of<Target>::number == K,
                    "target_values need as many components as the vector field has channels");
    if constexpr(has_constant_weight)
      if(!(weight > 0 && std::isfinite(static_cast<double>(weight))))
        throw Parameter_error("screening_weight", "is " + std::to_string(weight) +
                                                      ", but must be a positive, finite number");
    if constexpr(is_given_v<NamedParameters, internal_np::mean_value_t>) {
      const auto mean = parameters::get_parameter(np, internal_np::mean_value);
      using Components = Function_components<std::decay_t<decltype(mean)>>;
      static_assert(Components::number == K,
                    "mean_value needs as many components as the vector field has channels");
      m_mean = Components::read(mean);
      m_has_mean = true;
      if(!m_mean.allFinite())
        throw Parameter_error("mean_value", "is not finite");
    }
  }

  bool has_mean() const { return m_has_mean; }
  /// 0 if none is given
  const Values& mean() const { return m_mean; }

  /// 0 if none is given
  double weight(const Surface_point& p) const {
    if constexpr(has_constant_weight)
      return static_cast<double>(m_weight);
    else if constexpr(has_weight)
      return checked_screening_weight(static_cast<double>(m_weight(p)), p.face);
    else
      return 0;
  }
  /// refers to this object
  Screening_weight assembled_weight() const {
    if constexpr(has_constant_weight)
      return {static_cast<double>(m_weight), nullptr, 0};
    else if constexpr(has_weight)
      return {0, [this](const Surface_point& p) { return weight(p); }, weight_degree()};
    else
      return {};
  }
  int weight_degree() const {
    if constexpr(has_weight && !has_constant_weight)
      return degree_on_triangles(m_weight);
    else
      return 0;
  }

  /// the mean if there is no target
  Values target(const Surface_point& p) const {
    if constexpr(has_target) {
      const Values value = components_at(m_target, p);
      if(!value.allFinite())
        throw Parameter_error("target_values",
                              "has a value that is not finite in face " + std::to_string(p.face));
      return value;
    } else
      return m_mean;
  }
  int target_degree() const {
    if constexpr(has_target)
      return degree_on_triangles(m_target);
    else
      return 0;
  }

  /// `weight(p) * target(p)`; the target is not read where the weight is 0. Without a weight, the
  /// target.
  auto weighted_target() const {
    return function_of_degree(
        [this](const Surface_point& p) -> Values {
          if constexpr(!has_weight)
            return target(p);
          const double w = weight(p);
          return w > 0 ? Values(w * target(p)) : Values(Values::Zero());
        },
        (std::min)(weight_degree() + target_degree(), 6));
  }

private:
  Target m_target;
  Weight m_weight;
  Values m_mean;
  bool m_has_mean = false;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SCREENING_H
