# SPDX-License-Identifier: LGPL-2.1-or-later
#
# After `cmake --install`, find_package(thicken) gives thicken::thicken. tests/consume proves it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What is linked to everything statically is not for others to link.
if(NOT THICKEN_SELF_CONTAINED)
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
endif()

if(TARGET thicken_program)
  install(TARGETS thicken_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
endif()

# The Python module, and the workbench, which takes it from where Python finds it.
if(TARGET _thicken)
  if(NOT SKBUILD)
    set(THICKEN_PYTHON_INSTALL_DIR "lib/python3/dist-packages/thicken" CACHE STRING "Where the Python module is installed")
    set(THICKEN_FREECAD_MOD_DIR "share/freecad/Mod" CACHE STRING "FreeCAD's folder of workbenches")
    set(mod "${THICKEN_FREECAD_MOD_DIR}/Thicken")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/thicken/" DESTINATION "${THICKEN_PYTHON_INSTALL_DIR}" COMPONENT workbench
            FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed"
            PATTERN "__pycache__" EXCLUDE PATTERN "binaries" EXCLUDE)
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/ThickenWorkbench" "${PROJECT_SOURCE_DIR}/icons" DESTINATION "${mod}"
            COMPONENT workbench PATTERN "__pycache__" EXCLUDE PATTERN "_thicken*" EXCLUDE PATTERN "*.ts" EXCLUDE)
    install(FILES "${PROJECT_SOURCE_DIR}/Init.py" "${PROJECT_SOURCE_DIR}/InitGui.py" "${PROJECT_SOURCE_DIR}/package.xml"
            DESTINATION "${mod}" COMPONENT workbench)
    install(TARGETS _thicken LIBRARY DESTINATION "${THICKEN_PYTHON_INSTALL_DIR}" COMPONENT workbench)
  else()
    install(TARGETS _thicken LIBRARY DESTINATION . COMPONENT python)
  endif()
endif()

if(PROJECT_IS_TOP_LEVEL)
  include(ThickenDebian)
endif()
