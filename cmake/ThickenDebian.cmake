# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Debian packages by CPack, one for each component: thicken, libthicken-dev, freecad-thicken. scripts/package makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME thicken)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The Thicken authors <thicken@users.noreply.github.com>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(about "The surface, such as a scan, a mould or a skin of CAD, is kept triangle by
triangle, and the solid is proved to be closed, manifold, oriented and free of
self-intersection.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME thicken)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "program that makes printable solids of open mesh surfaces
${about}

This package has the program for the command line.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libthicken-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev, libzip-dev, zlib1g-dev, libexpat1-dev, g++")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "library that makes printable solids of open mesh surfaces
${about}

This package has the headers and the static library for C++.")

if(TARGET _thicken)
  list(APPEND CPACK_COMPONENTS_ALL workbench)
  find_package(Python REQUIRED COMPONENTS Interpreter)  # the folder of the extension found it for itself
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_WORKBENCH_PACKAGE_NAME freecad-thicken)
  set(CPACK_DEBIAN_WORKBENCH_PACKAGE_DEPENDS "freecad, python3-numpy, python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
  set(CPACK_COMPONENT_WORKBENCH_DESCRIPTION "FreeCAD workbench that makes printable solids of open mesh surfaces
${about}

This package has the workbench, and the module thicken for Python.")
endif()

# What Debian wants to be in every package.
include(GNUInstallDirs)
find_program(THICKEN_GZIP gzip)
if(THICKEN_GZIP)
  configure_file("${PROJECT_SOURCE_DIR}/packaging/changelog.in" "${PROJECT_BINARY_DIR}/debian/changelog.Debian" @ONLY)
  configure_file("${PROJECT_SOURCE_DIR}/packaging/thicken.1" "${PROJECT_BINARY_DIR}/debian/thicken.1" COPYONLY)
  execute_process(COMMAND "${THICKEN_GZIP}" -9nf "${PROJECT_BINARY_DIR}/debian/changelog.Debian"
                          "${PROJECT_BINARY_DIR}/debian/thicken.1" COMMAND_ERROR_IS_FATAL ANY)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER "${component}" upper)
    set(doc "share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
    install(FILES "${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz" "${PROJECT_SOURCE_DIR}/packaging/copyright"
            DESTINATION "${doc}" COMPONENT ${component})
  endforeach()
  install(FILES "${PROJECT_BINARY_DIR}/debian/thicken.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
endif()

include(CPack)
