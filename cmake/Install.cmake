# Rules for `cmake --install`, in five components: the tools, the shared libraries, the development files (headers under
# include/asperity, CMake package, asperity.pc), the module of Python, and that of MPI.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(tools GLOBAL PROPERTY ASPERITY_TOOLS)
get_property(parts GLOBAL PROPERTY ASPERITY_PARTS)
get_property(modules GLOBAL PROPERTY ASPERITY_MODULES)
if(ASPERITY_MPI)  # in a package of its own
  list(REMOVE_ITEM modules asperity_mpi)
  install(TARGETS asperity_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT mpi)
  set_target_properties(asperity_mpi PROPERTIES INSTALL_RPATH $ORIGIN)
endif()
foreach(target ${tools} ${parts} ${modules})
  install(TARGETS ${target} RUNTIME COMPONENT tools LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime)
endforeach()
install(TARGETS asperity asperity_io asperity_stats EXPORT Asperity
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asperity COMPONENT development)

# Tools find the libraries after the tree is moved.
file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
if(tools)
  set_target_properties(${tools} PROPERTIES INSTALL_RPATH $ORIGIN/${to_libraries})
endif()
set_target_properties(asperity asperity_io asperity_stats ${parts} ${modules} PROPERTIES INSTALL_RPATH $ORIGIN)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Asperity)
install(EXPORT Asperity NAMESPACE Asperity:: FILE AsperityTargets.cmake DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/AsperityConfig.cmake.in ${PROJECT_BINARY_DIR}/AsperityConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/AsperityConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/AsperityConfig.cmake ${PROJECT_BINARY_DIR}/AsperityConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)

# Users of a static library must link its dependencies; a shared library is linked with them.
set(pc_requires "eigen3 >= ${Eigen3_VERSION_MAJOR}.${Eigen3_VERSION_MINOR}")
set(pc_libraries "-lasperity_stats -lasperity_io -lasperity -pthread")
if(NOT BUILD_SHARED_LIBS)
  string(APPEND pc_requires ", gsl, fftw3, fftw3f, netcdf, libzip, pugixml, zlib, fmt")
  string(APPEND pc_libraries " -ludunits2 -lsundials_kinsol -lsundials_sunlinsolspgmr")
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindUDUNITS2.cmake DESTINATION ${package_folder} COMPONENT development)
endif()
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${pc_folder} OUTPUT_VARIABLE to_prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/asperity.pc.in ${PROJECT_BINARY_DIR}/asperity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/asperity.pc DESTINATION ${pc_folder} COMPONENT development)

if(NOT tools)
  return()
endif()
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
list(FILTER pages EXCLUDE REGEX README)
install(FILES ${pages} ${PROJECT_SOURCE_DIR}/docs/pipeline.svg ${PROJECT_SOURCE_DIR}/docs/schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/asperity COMPONENT tools)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/gallery ${PROJECT_SOURCE_DIR}/docs/accuracy DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/asperity COMPONENT tools)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/asperity COMPONENT tools)

set(ASPERITY_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where the module of Python is installed")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/python/asperity DESTINATION ${ASPERITY_PYTHON_DIR} COMPONENT python
  FILES_MATCHING PATTERN *.py PATTERN py.typed)
set(types ${PROJECT_BINARY_DIR}/python/asperity)  # made from the tools by tools/CMakeLists.txt
install(FILES ${types}/__init__.pyi ${types}/stage.pyi DESTINATION ${ASPERITY_PYTHON_DIR}/asperity COMPONENT python)
