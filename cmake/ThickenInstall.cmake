# SPDX-License-Identifier: LGPL-2.1-or-later
#
# After `cmake --install`, find_package(thicken) gives thicken::thicken. tests/consume proves it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(thicken_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/thicken")

install(TARGETS thicken EXPORT thickenTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        COMPONENT library)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/libthicken/include/thicken"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT library FILES_MATCHING PATTERN "*.h")
install(FILES "${thicken_generated_include}/thicken/version.h"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/thicken" COMPONENT library)
install(EXPORT thickenTargets NAMESPACE thicken:: DESTINATION "${thicken_package_dir}"
        COMPONENT library)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/thickenConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/thickenConfig.cmake"
                              INSTALL_DESTINATION "${thicken_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/thickenConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/thickenConfig.cmake" "${PROJECT_BINARY_DIR}/thickenConfigVersion.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindLibZip.cmake"
        DESTINATION "${thicken_package_dir}" COMPONENT library)

if(TARGET thicken_program)
  install(TARGETS thicken_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
endif()
