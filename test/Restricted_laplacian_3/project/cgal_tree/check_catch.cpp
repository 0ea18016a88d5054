// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What takes the place of Catch2 in CGAL's tree: each test whose name begins with `fails` has to
// fail, and all others have to pass.

#include "catch.h"

#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace {

int raise() { throw std::runtime_error("first second"); }

const double infinite = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("true_checks", "[checks]") {
  INFO("number " << 1);
  CHECK(1 == 1);
  CHECK_FALSE(1 == 2);
  REQUIRE(1 == 1);
  REQUIRE_FALSE(1 == 2);
  CHECK_THROWS_AS(raise(), std::runtime_error);
  CHECK_THROWS_WITH(raise(), "first second");
  CHECK_THROWS_WITH(raise(), Catch::Contains("first") && Catch::Contains("second"));
  CHECK_THAT("text", Catch::Contains("ex"));
  CHECK_NOTHROW(std::string("text"));
}

TEST_CASE("approximate_numbers", "[checks]") {
  CHECK(0.1 + 0.2 == Approx(0.3));
  CHECK(1.001 == Approx(1).epsilon(2e-3));
  CHECK_FALSE(1.003 == Approx(1).epsilon(2e-3));
  CHECK(1e-13 == Approx(0).margin(1e-12));
  CHECK_FALSE(1e-11 == Approx(0).margin(1e-12));
  CHECK(0.9 <= Approx(1));
  CHECK(1.0000001 <= Approx(1));
  CHECK_FALSE(1.1 <= Approx(1));
  CHECK(infinite == Approx(infinite));
  CHECK_FALSE(infinite == Approx(1));
  CHECK_FALSE(not_a_number == Approx(1).margin(1));
  CHECK(1 != Approx(not_a_number));
}

TEMPLATE_TEST_CASE("types", "[checks]", int, (std::map<int, int>)) { CHECK(sizeof(TestType) >= 4); }

TEST_CASE("skipped", "[checks]") { SKIP_TEST("number " << 2); }

TEST_CASE("slow", "[checks][slow]") { CHECK(false); }

TEST_CASE("fails_check", "[checks]") {
  CHECK(1 == 2);
  CHECK(1 == 1);
}
TEST_CASE("fails_require", "[checks]") {
  REQUIRE(1 == 2);
  std::exit(0);
}
TEST_CASE("fails_by_approximate_number", "[checks]") { CHECK(1.1 == Approx(1)); }
TEST_CASE("fails_by_exception", "[checks]") {
  CHECK(1 == 1);
  raise();
}
TEST_CASE("fails_without_check", "[checks]") {}
TEST_CASE("fails_without_exception", "[checks]") { CHECK_THROWS_AS(1 + 1, std::runtime_error); }
TEST_CASE("fails_by_other_exception", "[checks]") { CHECK_THROWS_AS(raise(), std::logic_error); }
TEST_CASE("fails_by_other_message", "[checks]") { CHECK_THROWS_WITH(raise(), "first"); }
TEST_CASE("fails_by_text", "[checks]") {
  CHECK_THAT("text", Catch::Contains("te") && Catch::Contains("st"));
}
TEST_CASE("fails_at_once", "[checks]") { FAIL("number " << 3); }
