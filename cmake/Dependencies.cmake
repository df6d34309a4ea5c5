# All dependencies, by names that both Debian 12 and upstream provide; the least versions are those of Debian 12.
find_package(Threads REQUIRED)
find_package(GSL 2.7 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)  # 3.4 or 5: its own file of versions takes no range over both
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} in ${Eigen3_DIR} is too old: install 3.4 or newer, or name its folder by Eigen3_DIR")
endif()
find_package(SUNDIALS 6.4 REQUIRED CONFIG COMPONENTS kinsol sunlinsolspgmr)
find_package(fmt 9 REQUIRED)
if(ASPERITY_TOOLS)
  find_package(CLI11 REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(tomlplusplus REQUIRED)
endif()
find_package(pugixml REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW3 REQUIRED IMPORTED_TARGET fftw3>=3.3.10)  # its Debian package has no CMake config
pkg_check_modules(FFTW3F REQUIRED IMPORTED_TARGET fftw3f>=3.3.10)  # the same in single precision
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf>=4.9)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip>=1.7)  # its CMake config needs tools that the package does not install
if(ASPERITY_MPI)
  find_package(MPI REQUIRED COMPONENTS C)
endif()
find_package(UDUNITS2 REQUIRED)
