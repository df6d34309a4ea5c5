# Debian packages by `cpack`: asperity (the tools), libasperity0.2 (named after its SOVERSION, as usual in Debian),
# libasperity-dev, python3-asperity and asperity-mpi. dpkg-shlibdeps finds what they depend on.
if(NOT BUILD_SHARED_LIBS OR NOT ASPERITY_TOOLS)
  return()  # the tools and the development package would each contain the library
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own line
set(CPACK_PACKAGE_VENDOR "The Asperity developers")
set(CPACK_PACKAGE_CONTACT "The Asperity developers <maintainers@asperity.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL tools runtime development python)
if(ASPERITY_MPI)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib ${PROJECT_BINARY_DIR}/stats)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY >=)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

get_target_property(soversion asperity SOVERSION)
set(runtime libasperity${soversion})
set(same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME asperity)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${runtime} ${same_version}")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "random rough surfaces: drawn, measured, pressed together, stressed
Small Unix tools over NetCDF pipes that draw random rough surfaces with a
prescribed autocorrelation, measure them by ISO 25178-2, press them together
(elastic-perfectly plastic) and compute the stress below. Estimates have
standard errors, and solvers report their residuals.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${runtime})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/package/triggers)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "random rough surfaces: shared libraries
The C++ libraries that the tools of asperity use.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libasperity-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${runtime} ${same_version}, libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "random rough surfaces: headers of the C++ library
Files to build a C++20 program with Asperity: headers, the CMake package
Asperity, and asperity.pc for pkg-config.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-asperity)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "asperity ${same_version}, python3, python3-numpy, python3-xarray")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/cmake/package/python/postinst ${PROJECT_SOURCE_DIR}/cmake/package/python/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "random rough surfaces: the tools in Python
A module whose functions run the tools of asperity. Datasets of xarray pass
through their pipes in memory.")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME asperity-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "asperity ${same_version}, openmpi-bin")
set(CPACK_DEBIAN_MPI_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/package/triggers)
set(CPACK_DEBIAN_MPI_DESCRIPTION "random rough surfaces: one problem on many machines
With this module asperity-contact solves one problem by several processes
under mpirun or srun, each of which holds a part of the surface.")

set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/documents.cmake)
include(CPack)
