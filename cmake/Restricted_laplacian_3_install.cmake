# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# What `cmake --install` installs: the component `headers`, in which nothing depends on the processor,
# so all that is not a header goes below share/; the component `compiled`, the library, if it is built;
# `programs`, with the viewer; and `distributed`, programs for several machines. Nothing names a path of this
# machine, so the installation can be moved.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME headers)
install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")

# find_package()
set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/Restricted_laplacian_3")
configure_package_config_file(cmake/Restricted_laplacian_3Config.cmake.in
  "${PROJECT_BINARY_DIR}/Restricted_laplacian_3Config.cmake" INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/Restricted_laplacian_3ConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(TARGETS Restricted_laplacian_3 EXPORT Restricted_laplacian_3Targets
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT Restricted_laplacian_3Targets NAMESPACE Restricted_laplacian_3::
  DESTINATION "${package_dir}")
install(FILES
  "${PROJECT_BINARY_DIR}/Restricted_laplacian_3Config.cmake"
  "${PROJECT_BINARY_DIR}/Restricted_laplacian_3ConfigVersion.cmake"
  cmake/Restricted_laplacian_3_optional_dependencies.cmake
  cmake/FindCHOLMOD.cmake
  DESTINATION "${package_dir}")

# pkg-config
file(RELATIVE_PATH pc_to_include "${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig"
  "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
configure_file(cmake/restricted_laplacian_3.pc.in "${PROJECT_BINARY_DIR}/restricted_laplacian_3.pc"
  @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/restricted_laplacian_3.pc"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/pkgconfig")

# the library, a CMake package that the one above looks for
if(TARGET Restricted_laplacian_3_compiled)
  set(compiled_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Restricted_laplacian_3_compiled")
  set(compiled_with_tbb OFF)
  set(pc_requires "restricted_laplacian_3 = ${PROJECT_VERSION}")
  set(pc_definitions "-DCGAL_RESTRICTED_LAPLACIAN_3_COMPILED")
  set(pc_libraries "-lCGAL_Restricted_laplacian_3")
  if(TARGET CGAL::TBB_support)
    set(compiled_with_tbb ON)
    string(APPEND pc_requires ", tbb")
    string(APPEND pc_definitions " -DCGAL_LINKED_WITH_TBB")
  endif()
  if(CHOLMOD_FOUND)
    string(APPEND pc_libraries " -lcholmod")
  endif()
  configure_file(cmake/Restricted_laplacian_3_compiledConfig.cmake.in
    "${PROJECT_BINARY_DIR}/Restricted_laplacian_3_compiledConfig.cmake" @ONLY)
  write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/Restricted_laplacian_3_compiledConfigVersion.cmake"
    COMPATIBILITY ExactVersion)
  install(TARGETS Restricted_laplacian_3_compiled EXPORT Restricted_laplacian_3_compiledTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT compiled
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT compiled NAMELINK_COMPONENT compiled
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT compiled)
  install(EXPORT Restricted_laplacian_3_compiledTargets NAMESPACE Restricted_laplacian_3::
    DESTINATION "${compiled_dir}" COMPONENT compiled)
  install(FILES
    "${PROJECT_BINARY_DIR}/Restricted_laplacian_3_compiledConfig.cmake"
    "${PROJECT_BINARY_DIR}/Restricted_laplacian_3_compiledConfigVersion.cmake"
    DESTINATION "${compiled_dir}" COMPONENT compiled)
  configure_file(cmake/restricted_laplacian_3_compiled.pc.in
    "${PROJECT_BINARY_DIR}/restricted_laplacian_3_compiled.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/restricted_laplacian_3_compiled.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT compiled)
endif()

# the viewer for HTML pages, which programs put their surfaces into
if(TARGET viewer)
  get_property(viewer GLOBAL PROPERTY RESTRICTED_LAPLACIAN_3_VIEWER)
  install(FILES "${viewer}" DESTINATION "${CMAKE_INSTALL_DATADIR}/Restricted_laplacian_3"
    COMPONENT programs OPTIONAL)
endif()

# documentation
install(FILES README.md CHANGELOG.md LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY examples/Restricted_laplacian_3/ DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples"
  FILES_MATCHING PATTERN "*.cpp" PATTERN "*.h" PATTERN "*.in" PATTERN "*.cmake"
  PATTERN CMakeLists.txt)
if(RESTRICTED_LAPLACIAN_3_BUILD_DOC)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/doc/Restricted_laplacian_3/html"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}" OPTIONAL)
endif()
