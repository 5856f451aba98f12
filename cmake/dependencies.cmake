# Every third-party library, once. CGAL puts its own FindEigen3 on the module path and sets BUILD_TESTING,
# hence Eigen's NO_MODULE and our own ICEBOW_TESTS.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(CGAL 5.5 REQUIRED)
find_package(OpenTURNS REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(PNG REQUIRED)
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "HDF5 was found without MPI: install the parallel one (Debian: libhdf5-openmpi-dev)")
endif()
find_package(Threads REQUIRED)

# Debian splits NLopt in a C and a C++ library whose CMake packages share one name: ask for the files.
find_path(NLOPT_INCLUDE_DIR nlopt.hpp REQUIRED)
find_library(NLOPT_CXX_LIBRARY nlopt_cxx REQUIRED)
add_library(nlopt_cxx INTERFACE)
target_include_directories(nlopt_cxx SYSTEM INTERFACE ${NLOPT_INCLUDE_DIR})
target_link_libraries(nlopt_cxx INTERFACE ${NLOPT_CXX_LIBRARY})
