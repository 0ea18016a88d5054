vcpkg_from_github(
    OUT_SOURCE_PATH SOURCE_PATH
    REPO OWNER/restricted_laplacian_3
    REF "v${VERSION}"
    SHA512 0
    HEAD_REF main
)

vcpkg_check_features(OUT_FEATURE_OPTIONS options
    FEATURES
        programs RESTRICTED_LAPLACIAN_3_BUILD_PROGRAMS
)
if(NOT "cholmod" IN_LIST FEATURES)
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_CHOLMOD=ON)
endif()

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${options}
        -DCGAL_DISABLE_GMP=ON
        -DRESTRICTED_LAPLACIAN_3_BUILD_TESTS=OFF
        -DRESTRICTED_LAPLACIAN_3_BUILD_EXAMPLES=OFF
        -DRESTRICTED_LAPLACIAN_3_BUILD_DOC=OFF
        -DRESTRICTED_LAPLACIAN_3_BUILD_VIEWER=OFF
        -DRESTRICTED_LAPLACIAN_3_DISTRIBUTED=OFF
        -DRESTRICTED_LAPLACIAN_3_INSTALL=ON
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Restricted_laplacian_3
    CONFIG_PATH share/cmake/Restricted_laplacian_3 DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME Restricted_laplacian_3_compiled
    CONFIG_PATH lib/cmake/Restricted_laplacian_3_compiled)
vcpkg_fixup_pkgconfig()
if("programs" IN_LIST FEATURES)
    vcpkg_copy_tools(TOOL_NAMES solve_poisson laplace_spectrum spectral_descriptors fit_function estimate_curvature
        geodesic_distance diffuse edit_surface flow_surface stitch_colors bake_scans draw_mesh AUTO_CLEAN)
endif()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
