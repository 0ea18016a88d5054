// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_TRIANGLE_QUADRATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_TRIANGLE_QUADRATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// A node of a cubature rule on a triangle: barycentric coordinates and a weight. The weights of a
/// rule sum to 1: multiply by the area of the triangle.
struct Triangle_quadrature_node {
  /// barycentric coordinate of corner 0
  double b0;
  /// barycentric coordinate of corner 1
  double b1;
  /// barycentric coordinate of corner 2
  double b2;
  /// fraction of the area of the triangle that the node stands for
  double weight;
};

namespace internal {

/// M. A. Taylor, Asymmetric cubature formulas for polynomial integration in the triangle and
/// square, J. Comput. Appl. Math. 218 (2008): 32 nodes, degree 12, all weights positive. Four of
/// the nodes lie on an edge of the triangle, so a fragment has to evaluate the polynomial pieces of
/// the cell that owns it, never those of the cell that contains the node.
inline const std::vector<Triangle_quadrature_node>& taylor_rule_of_degree_12() {
  // clang-format off
  static const std::vector<Triangle_quadrature_node> rule = {
      {0.409354529674576756, 0.379860210934018857, 0.210785259391404386, 0.059437833951135512},
      {0.288796329020881330, 0.301417093209093079, 0.409786577770025590, 0.075222062603324290},
      {0.228197277938737869, 0.558025289531202367, 0.213777432530059762, 0.063164546422656709},
      {0.255495747579340019, 0.125122995058103883, 0.619381257362556096, 0.050964924876787498},
      {0.543837635808460059, 0.211179399098048424, 0.244982965093491516, 0.047499575325307049},
      {0.073813754422606659, 0.854314749475804340, 0.071871496101588999, 0.022490746199158185},
      {0.078349659941746980, 0.717881858980523263, 0.203768481077729756, 0.039573605792972001},
      {0.124718320885524395, 0.466317874623230742, 0.408963804491244861, 0.059989707327106135},
      {0.122162380966293739, 0.250155003353392070, 0.627682615680314189, 0.053352083048821038},
      {0.094041301141058654, 0.079955384841381180, 0.826003314017560164, 0.030529172412072411},
      {0.225505520049374285, 0.710081259568365111, 0.064413220382260602, 0.041281887395462672},
      {0.432112641877997103, 0.497320633777965648, 0.070566724344037247, 0.048148805036907408},
      {0.643800731623786280, 0.260770682565628259, 0.095428585810585459, 0.045937842165791862},
      {0.794010795132135128, 0.089602705800586795, 0.116386499067278076, 0.030575277604039186},
      {0.227722111443204904, 0.023088148766115803, 0.749189739790679291, 0.021685085417011567},
      {0.447861373562202774, 0.129532969004336115, 0.422605657433461109, 0.054146872613167303},
      {0.663093778446758118, 0.093448087604440942, 0.243458133948800938, 0.027943734319879610},
      {0.021179073180361003, 0.955269193570060316, 0.023551733249578679, 0.006675900027367369},
      {0, 0.845935398373144049, 0.154064601626855950, 0.007714492373624853},
      {0.022809112637652904, 0.616009296172675007, 0.361181591189672088, 0.025099173427685055},
      {0.025145682063804436, 0.393165103196048017, 0.581689214740147546, 0.028145558605213286},
      {0.022191950159709017, 0.189206330617159210, 0.788601719223131772, 0.020620004119682121},
      {0.011514366672623634, 0.043010560106405332, 0.945475073220971033, 0.007119751436080709},
      {0.141841115784669493, 0.858158884215330506, 0, 0.006845534654343693},
      {0.372684680767588945, 0.627315319232411054, 0, 0.009654708742436398},
      {0.621586880750877927, 0.363846604460774759, 0.014566514788347313, 0.018545480421606808},
      {0.823277107647898370, 0.155570668968979541, 0.021152223383122087, 0.018483685811230865},
      {0.943134911146902480, 0.029754117496841756, 0.027110971356255762, 0.010509326735602506},
      {0.072651025516050314, 0, 0.927348974483949685, 0.004888049814660044},
      {0.429837040104381147, 0.025716283623693869, 0.544446676271924983, 0.028169654459729984},
      {0.643364629415365139, 0.024506286636990074, 0.332129083947644786, 0.024904073201507736},
      {0.844725347421859668, 0.009229690905964613, 0.146044961672175717, 0.010680843657628118}};
  // clang-format on
  return rule;
}

/// J. N. Lyness, D. Jespersen, Moderate degree symmetric quadrature rules for the triangle,
/// J. Inst. Math. Appl. 15 (1975): 16 nodes, degree 8, all weights positive, all nodes inside.
inline const std::vector<Triangle_quadrature_node>& lyness_jespersen_rule_of_degree_8() {
  static const std::vector<Triangle_quadrature_node> rule = [] {
    const double third = 1. / 3;
    std::vector<Triangle_quadrature_node> nodes = {{third, third, third, 0.144315607677787168251}};
    // on the medians: two coordinates are equal
    constexpr double on_medians[3][2] = {{0.459292588292723156029, 0.0950916342672846247939},
                                         {0.170569307751760206622, 0.103217370534718250282},
                                         {0.0505472283170309754584, 0.0324584976231980803109}};
    for(const auto& [a, weight] : on_medians) {
      const double b = 1 - 2 * a;
      nodes.insert(nodes.end(), {{b, a, a, weight}, {a, b, a, weight}, {a, a, b, weight}});
    }
    const double a = 0.00839477740995760533721, b = 0.263112829634638113422, c = 1 - a - b,
                 weight = 0.0272303141744349942648;
    nodes.insert(nodes.end(), {{a, b, c, weight},
                               {b, c, a, weight},
                               {c, a, b, weight},
                               {a, c, b, weight},
                               {c, b, a, weight},
                               {b, a, c, weight}});
    return nodes;
  }();
  return rule;
}

/// J. Radon (1948): 7 nodes, degree 5
inline const std::vector<Triangle_quadrature_node>& radon_rule_of_degree_5() {
  static const std::vector<Triangle_quadrature_node> rule = [] {
    const double root = 3.872983346207416885179265399782; // sqrt(15)
    const double a = (6 - root) / 21, b = (6 + root) / 21;
    const double u = (155 - root) / 1200, v = (155 + root) / 1200;
    const double third = 1. / 3;
    return std::vector<Triangle_quadrature_node>{{third, third, third, 9. / 40},
                                                 {1 - 2 * a, a, a, u},
                                                 {a, 1 - 2 * a, a, u},
                                                 {a, a, 1 - 2 * a, u},
                                                 {1 - 2 * b, b, b, v},
                                                 {b, 1 - 2 * b, b, v},
                                                 {b, b, 1 - 2 * b, v}};
  }();
  return rule;
}

/// 3 nodes, degree 2
inline const std::vector<Triangle_quadrature_node>& three_point_rule_of_degree_2() {
  static const std::vector<Triangle_quadrature_node> rule = {{2. / 3, 1. / 6, 1. / 6, 1. / 3},
                                                             {1. / 6, 2. / 3, 1. / 6, 1. / 3},
                                                             {1. / 6, 1. / 6, 2. / 3, 1. / 3}};
  return rule;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// The smallest rule of this package that integrates all polynomials of total degree at most
/// `degree` exactly: 3 nodes up to degree 2, 7 up to 5, 16 up to 8, and Taylor's 32 up to 12. A
/// product of two triquadratic functions on a plane has degree 12, one of a triquadratic with a
/// linear function 7.
/// \throws Parameter_error if `degree` is negative or above 12
inline const std::vector<Triangle_quadrature_node>& triangle_quadrature(int degree) {
  if(degree < 0 || degree > 12)
    throw Parameter_error("degree", "of exactness is " + std::to_string(degree) +
                                        ", but the cubature rules reach from 0 to 12");
  if(degree <= 2)
    return internal::three_point_rule_of_degree_2();
  if(degree <= 5)
    return internal::radon_rule_of_degree_5();
  if(degree <= 8)
    return internal::lyness_jespersen_rule_of_degree_8();
  return internal::taylor_rule_of_degree_12();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_TRIANGLE_QUADRATURE_H
