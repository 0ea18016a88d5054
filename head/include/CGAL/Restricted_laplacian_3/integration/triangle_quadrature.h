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

/// 24 nodes, degree 10, all weights positive, all nodes inside, from Taylor's rule by elimination
/// of nodes (H. Xiao, Z. Gimbutas, A numerical algorithm for the construction of efficient
/// quadrature rules in two and higher dimensions, Comput. Math. Appl. 59 (2010)). They fill six
/// vectors of four.
inline const std::vector<Triangle_quadrature_node>& rule_of_degree_10() {
  // clang-format off
  static const std::vector<Triangle_quadrature_node> rule = {
      {0.423980874746696322, 0.409401718630203877, 0.166617406623099801, 0.0848835838807637533},
      {0.308901236653822873, 0.318225563851979913, 0.372873199494197213, 0.0803498164388750649},
      {0.189749941012442049, 0.630571123627442606, 0.179678935360115346, 0.0777692288908517285},
      {0.518714805891843815, 0.151529301268827504, 0.329755892839328681, 0.0755620356832836163},
      {0.272901759417847658, 0.144823562839024235, 0.582274677743128106, 0.0695489303253650689},
      {0.140235372004349794, 0.451540572809342997, 0.408224055186307209, 0.0685566952710972988},
      {0.666958659816253662, 0.196523007940706806, 0.136518332243039531, 0.0606869811288014232},
      {0.102403135548282693, 0.250153456080693459, 0.647443408371023848, 0.0559799058665935696},
      {0.374182657767192294, 0.590392412606017229, 0.0354249296267904771, 0.043866639403974802},
      {0.430180387722473316, 0.0328774946349145741, 0.53694211764261211, 0.0388174565319319486},
      {0.032934881329299345, 0.614683314889311829, 0.352381803781388826, 0.0376757895693132334},
      {0.630191102600197998, 0.340484350882324316, 0.029324546517477686, 0.0374975978085812076},
      {0.0379851525808730511, 0.810873411844462098, 0.151141435574664851, 0.0323360325395543173},
      {0.157731290717836198, 0.807465295138009005, 0.0348034141441547966, 0.0318008272065056966},
      {0.820196309996289897, 0.0436150319105661305, 0.136188658093143973, 0.0308620664921319138},
      {0.661581160705129936, 0.0275975487204664751, 0.310821290574403589, 0.0299334958281225152},
      {0.100524626817109929, 0.082974991532418758, 0.816500381650471313, 0.0298862110398435924},
      {0.0188550150709230063, 0.381112430054870085, 0.600032554874206908, 0.0258461425930929582},
      {0.21006059789244589, 0.0218040911636651566, 0.768135310943888953, 0.0234300659982981343},
      {0.856518094723557164, 0.118904624836832907, 0.0245772804396099295, 0.0226963619344197406},
      {0.0129841443087149382, 0.146315611626615816, 0.840700244064669245, 0.0157923149199996114},
      {0.0284907974837382136, 0.943290204484440117, 0.0282189980318216698, 0.0109420910189448745},
      {0.0334492292785107016, 0.018305461583589695, 0.948245309137899603, 0.00930581843351779864},
      {0.96149631829659489, 0.00862519830113068511, 0.029878483402274425, 0.00597391119613613178}};
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

/// K. Gatermann, The construction of symmetric cubature formulas for the square and the triangle,
/// Computing 40 (1988): 12 nodes, degree 7, all weights positive, all nodes inside.
inline const std::vector<Triangle_quadrature_node>& gatermann_rule_of_degree_7() {
  static const std::vector<Triangle_quadrature_node> rule = [] {
    // one of three nodes that follow from each other by rotation
    // clang-format off
    const std::vector<Triangle_quadrature_node> generators = {
      {0.515842334353591779, 0.206441498670016438, 0.277716166976391783, 0.134986374019605549},
      {0.623272049491091566, 0.321502493851981823, 0.0552254566569266117, 0.0877628174288921101},
      {0.304726500868167196, 0.660949196186735658, 0.0343243029450971465, 0.0575500855699631715},
      {0.0675178670739160854, 0.0623822650944021182, 0.870099867831681796, 0.0530340563148725029}};
    // clang-format on
    std::vector<Triangle_quadrature_node> nodes;
    for(const auto& [a, b, c, weight] : generators)
      nodes.insert(nodes.end(), {{a, b, c, weight}, {b, c, a, weight}, {c, a, b, weight}});
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
/// `degree` exactly: 3 nodes up to degree 2, 7 up to 5, 12 up to 7, 16 up to 8, 24 up to 10, and
/// Taylor's 32 up to 12. A product of two triquadratic functions on a plane has degree 12, one of
/// their gradients 10, one of a triquadratic with a linear function 7.
/// \throws Parameter_error if `degree` is negative or above 12
inline const std::vector<Triangle_quadrature_node>& triangle_quadrature(int degree) {
  if(degree < 0 || degree > 12)
    throw Parameter_error("degree", "of exactness is " + std::to_string(degree) +
                                        ", but the cubature rules reach from 0 to 12");
  if(degree <= 2)
    return internal::three_point_rule_of_degree_2();
  if(degree <= 5)
    return internal::radon_rule_of_degree_5();
  if(degree <= 7)
    return internal::gatermann_rule_of_degree_7();
  if(degree <= 8)
    return internal::lyness_jespersen_rule_of_degree_8();
  if(degree <= 10)
    return internal::rule_of_degree_10();
  return internal::taylor_rule_of_degree_12();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_TRIANGLE_QUADRATURE_H
