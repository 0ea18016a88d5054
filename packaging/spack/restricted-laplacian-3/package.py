# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

from spack.package import CMakePackage, depends_on, license, variant, version


class RestrictedLaplacian3(CMakePackage):
    """Laplace-Beltrami operators of surfaces by restriction of 3D B-splines, in the style of CGAL."""

    homepage = "https://github.com/OWNER/restricted_laplacian_3"
    url = "https://github.com/OWNER/restricted_laplacian_3/archive/refs/tags/v0.2.0.tar.gz"

    license("GPL-3.0-or-later")

    version("0.2.0", sha256="0000000000000000000000000000000000000000000000000000000000000000")

    variant("cholmod", default=True, description="Factorizations by CHOLMOD")
    variant("programs", default=True, description="Programs for the command line")
    variant("mpi", default=False, description="The part for several machines")

    depends_on("cxx", type="build")
    depends_on("cmake@3.19:", type="build")
    depends_on("cgal@5.5:")
    depends_on("eigen@3.4:")
    depends_on("tbb")
    depends_on("suite-sparse", when="+cholmod")
    depends_on("boost+program_options", when="+programs")
    depends_on("libpng", when="+programs")
    depends_on("zlib-api", when="+programs")
    depends_on("mpi", when="+mpi")
    depends_on("petsc+mpi", when="+mpi")
    depends_on("slepc", when="+mpi")

    def cmake_args(self):
        off = ("TESTS", "EXAMPLES", "DOC", "VIEWER")
        args = [self.define(f"RESTRICTED_LAPLACIAN_3_BUILD_{name}", False) for name in off]
        args.append(self.define_from_variant("RESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS", "programs"))
        args.append(self.define_from_variant("RESTRICTED_LAPLACIAN_3_DISTRIBUTED", "mpi"))
        args.append(self.define("CMAKE_DISABLE_FIND_PACKAGE_CHOLMOD", "~cholmod" in self.spec))
        return args
