# All dependencies, by names that both Debian 12 and upstream provide.
find_package(Threads REQUIRED)
find_package(GSL 2.7 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(SUNDIALS 6.4 REQUIRED CONFIG COMPONENTS kinsol sunlinsolspgmr)
find_package(fmt REQUIRED)
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
pkg_check_modules(LIBMD REQUIRED IMPORTED_TARGET libmd)
if(ASPERITY_MPI)
  find_package(MPI REQUIRED COMPONENTS C)
endif()
find_package(UDUNITS2 REQUIRED)
