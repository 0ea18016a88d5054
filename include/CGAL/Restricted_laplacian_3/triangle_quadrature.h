// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TRIANGLE_QUADRATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TRIANGLE_QUADRATURE_H

#include <CGAL/Restricted_laplacian_3/exceptions.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// A node of a cubature rule on a triangle: barycentric coordinates and a weight. The weights of a
/// rule sum to 1: multiply by the area of the triangle.
struct Triangle_quadrature_node {
  double b0, b1, b2;
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
      {0.409354529674576756005, 0.379860210934018857838, 0.210785259391404386157, 0.059437833951135512201},
      {0.288796329020881330058, 0.301417093209093079338, 0.409786577770025590604, 0.075222062603324290742},
      {0.228197277938737869877, 0.558025289531202367918, 0.213777432530059762205, 0.063164546422656709986},
      {0.255495747579340019803, 0.125122995058103883701, 0.619381257362556096496, 0.050964924876787498325},
      {0.543837635808460059286, 0.211179399098048424442, 0.244982965093491516273, 0.047499575325307049783},
      {0.073813754422606659942, 0.854314749475804340241, 0.071871496101588999817, 0.022490746199158185206},
      {0.078349659941746980485, 0.717881858980523263183, 0.203768481077729756332, 0.039573605792972001664},
      {0.124718320885524395517, 0.466317874623230742642, 0.408963804491244861840, 0.059989707327106135804},
      {0.122162380966293739617, 0.250155003353392070701, 0.627682615680314189681, 0.053352083048821038365},
      {0.094041301141058654509, 0.079955384841381180585, 0.826003314017560164906, 0.030529172412072411833},
      {0.225505520049374285900, 0.710081259568365111564, 0.064413220382260602536, 0.041281887395462672648},
      {0.432112641877997103700, 0.497320633777965648971, 0.070566724344037247329, 0.048148805036907408622},
      {0.643800731623786280987, 0.260770682565628259608, 0.095428585810585459405, 0.045937842165791862400},
      {0.794010795132135128733, 0.089602705800586795125, 0.116386499067278076142, 0.030575277604039186724},
      {0.227722111443204904859, 0.023088148766115803189, 0.749189739790679291952, 0.021685085417011567981},
      {0.447861373562202774772, 0.129532969004336115561, 0.422605657433461109667, 0.054146872613167303660},
      {0.663093778446758118762, 0.093448087604440942382, 0.243458133948800938856, 0.027943734319879610534},
      {0.021179073180361003562, 0.955269193570060316501, 0.023551733249578679937, 0.006675900027367369348},
      {0, 0.845935398373144049798, 0.154064601626855950202, 0.007714492373624853873},
      {0.022809112637652904400, 0.616009296172675007017, 0.361181591189672088583, 0.025099173427685055945},
      {0.025145682063804436069, 0.393165103196048017173, 0.581689214740147546758, 0.028145558605213286058},
      {0.022191950159709017171, 0.189206330617159210137, 0.788601719223131772692, 0.020620004119682121102},
      {0.011514366672623634517, 0.043010560106405332253, 0.945475073220971033231, 0.007119751436080709944},
      {0.141841115784669493407, 0.858158884215330506593, 0, 0.006845534654343693775},
      {0.372684680767588945951, 0.627315319232411054049, 0, 0.009654708742436398306},
      {0.621586880750877927143, 0.363846604460774759580, 0.014566514788347313277, 0.018545480421606808183},
      {0.823277107647898370840, 0.155570668968979541934, 0.021152223383122087226, 0.018483685811230865640},
      {0.943134911146902480326, 0.029754117496841756887, 0.027110971356255762787, 0.010509326735602506149},
      {0.072651025516050314746, 0, 0.927348974483949685254, 0.004888049814660044775},
      {0.429837040104381147092, 0.025716283623693869720, 0.544446676271924983188, 0.028169654459729984998},
      {0.643364629415365139063, 0.024506286636990074560, 0.332129083947644786377, 0.024904073201507736815},
      {0.844725347421859668940, 0.009229690905964613689, 0.146044961672175717371, 0.010680843657628118611}};
  // clang-format on
  return rule;
}

/// J. Radon (1948): 7 nodes, degree 5
inline const std::vector<Triangle_quadrature_node>& radon_rule_of_degree_5() {
  static const std::vector<Triangle_quadrature_node> rule = [] {
    const double root = 3.872983346207416885179265399782; // sqrt(15)
    const double a = (6 - root) / 21, b = (6 + root) / 21;
    const double u = (155 - root) / 1200, v = (155 + root) / 1200;
    const double third = 1. / 3;
    return std::vector<Triangle_quadrature_node>{
        {third, third, third, 9. / 40}, {1 - 2 * a, a, a, u}, {a, 1 - 2 * a, a, u},
        {a, a, 1 - 2 * a, u},           {1 - 2 * b, b, b, v}, {b, 1 - 2 * b, b, v},
        {b, b, 1 - 2 * b, v}};
  }();
  return rule;
}

/// 3 nodes, degree 2
inline const std::vector<Triangle_quadrature_node>& three_point_rule_of_degree_2() {
  static const std::vector<Triangle_quadrature_node> rule = {
      {2. / 3, 1. / 6, 1. / 6, 1. / 3},
      {1. / 6, 2. / 3, 1. / 6, 1. / 3},
      {1. / 6, 1. / 6, 2. / 3, 1. / 3}};
  return rule;
}

} // namespace internal

/// The smallest rule of this package that integrates all polynomials of total degree at most
/// `degree` exactly: 3 nodes up to degree 2, 7 up to 5, and Taylor's 32 up to 12, which is what a
/// product of two triquadratic functions on a plane needs.
/// \throws Parameter_error if `degree` is negative or above 12
inline const std::vector<Triangle_quadrature_node>& triangle_quadrature(int degree) {
  if(degree < 0 || degree > 12)
    throw Parameter_error("degree", "of exactness is " + std::to_string(degree) +
                                        ", but the cubature rules reach from 0 to 12");
  if(degree <= 2)
    return internal::three_point_rule_of_degree_2();
  if(degree <= 5)
    return internal::radon_rule_of_degree_5();
  return internal::taylor_rule_of_degree_12();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TRIANGLE_QUADRATURE_H
