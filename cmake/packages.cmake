# `cpack` makes Debian packages of the installed parts: hsr (the command), libhsr-dev (headers, static libraries, CMake files) and,
# where the Python module is built, python3-hsr. There is no shared library: its interface is C++ templates and structs that grow,
# and no version keeps it as it was. To be called in a build of the preset `packages`, whose files go below /usr.
set(HSR_MAINTAINER "the hsr authors <hsr@example.org>" CACHE STRING "Who makes the packages")
mark_as_advanced(HSR_MAINTAINER)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PACKAGE_CONTACT ${HSR_MAINTAINER})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own, its first line
set(about "Every decision about what hides what is exact, for any input, however
degenerate: no cracks, stray slivers or missing edges.")

set(CPACK_COMPONENTS_ALL command core raster check io)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME hsr)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_DESCRIPTION "vector drawings of polygon models with hidden lines removed
The command hsr draws STL, OBJ, PLY, OFF and glTF models with hidden lines
removed, dashed or under filled faces, as SVG, PDF, EPS, DXF, TikZ, HPGL, PNG
or JSON.
${about}")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libhsr-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libgmp-dev, libtbb-dev, libcairo2-dev, libjpeg-dev, libpng-dev, zlib1g-dev, pkg-config")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "cmake, libeigen3-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "exact visible lines, visible fragments and painter's orders (C++)
Headers, static libraries and CMake files of hsr, a C++20 library of visible
lines, visible fragments and painter's orders of polygon scenes.
${about}")

if(TARGET hsr_eigen)
  list(APPEND CPACK_COMPONENTS_ALL eigen)
endif()
if(TARGET hsr_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next "${HSR_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-hsr)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${HSR_PYTHON_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS hsr)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/cmake/debian/postinst;${PROJECT_SOURCE_DIR}/cmake/debian/prerm")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "exact visible lines, visible fragments and painter's orders (Python)
The module hsr draws polygon models, gives visible lines, visible fragments
and painter's orders as numpy arrays, and puts plots of matplotlib in the
right order.
${about}")
endif()

# What Debian wants beside the installed files is added to the trees that the packages are made of.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_HSR_SOURCE_DIR ${PROJECT_SOURCE_DIR})
include(CPack)
cpack_add_component_group(dev)
foreach(component IN ITEMS core raster check io eigen)
  cpack_add_component(${component} GROUP dev)
endforeach()
