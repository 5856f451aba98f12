# What `cmake --install` puts where. Component `program`: the program with its parts, studies, documents, man page and
# completions. Component `development`: the libraries of hullgen and of the solver with their headers, as a CMake package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(icebow_parts icebow_sampling)
if(ICEBOW_HAS_CAD)
  list(APPEND icebow_parts icebow_cad)
endif()
if(ICEBOW_HAS_PDF)
  list(APPEND icebow_parts icebow_pdf)
endif()
install(TARGETS icebow RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Where base/plugin.cpp looks for them: icebow_plugin_folder in cmake/flags.cmake.
install(TARGETS ${icebow_parts} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/icebow COMPONENT program)

# Man page and completions, by the program's own table of commands.
set(pages ${CMAKE_BINARY_DIR}/pages)
set(page_files ${pages}/icebow.1 ${pages}/icebow.bash ${pages}/_icebow ${pages}/icebow.fish)
add_custom_command(
  OUTPUT ${page_files}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}
  COMMAND icebow help --man > ${pages}/icebow.1
  COMMAND icebow help --completion=bash > ${pages}/icebow.bash
  COMMAND icebow help --completion=zsh > ${pages}/_icebow
  COMMAND icebow help --completion=fish > ${pages}/icebow.fish
  DEPENDS icebow
  COMMENT "Writing the man page and the completions"
  VERBATIM)
add_custom_target(icebow_pages ALL DEPENDS ${page_files})
set(share ${CMAKE_INSTALL_DATADIR})
install(FILES ${pages}/icebow.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${pages}/icebow.bash DESTINATION ${share}/bash-completion/completions RENAME icebow COMPONENT program)
install(FILES ${pages}/_icebow DESTINATION ${share}/zsh/site-functions COMPONENT program)
install(FILES ${pages}/_icebow DESTINATION ${share}/zsh/vendor-completions COMPONENT program)  # Debian's, of packages
install(FILES ${pages}/icebow.fish DESTINATION ${share}/fish/vendor_completions.d COMPONENT program)
install(DIRECTORY studies/ DESTINATION ${share}/icebow/studies COMPONENT program)
install(DIRECTORY reports/paraview/ DESTINATION ${share}/icebow/paraview COMPONENT program)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)

# The libraries under the program that others may link: no study, no report.
set(icebow_libraries icebow_flags icebow_base icebow_geometry fftw3
  icebow_hullgen icebow_hullgen_mesh icebow_hullgen_bow icebow_hullgen_import icebow_hullgen_hydro icebow_hullgen_cad
  icebow_hullgen_drawing
  icebow_solver icebow_solver_model icebow_solver_lattice icebow_solver_kernel icebow_solver_ice icebow_solver_contact
  icebow_solver_water icebow_solver_step icebow_solver_watch icebow_solver_output icebow_solver_run icebow_solver_tank)
foreach(library IN LISTS icebow_libraries)
  string(REGEX REPLACE "^icebow_" "" exported ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${exported})
endforeach()
install(TARGETS ${icebow_libraries} EXPORT icebow
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/icebow COMPONENT development)
foreach(folder base geometry solver)
  install(DIRECTORY src/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/icebow COMPONENT development
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY hullgen DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/icebow COMPONENT development
  FILES_MATCHING PATTERN "*.h")
install(DIRECTORY examples/ DESTINATION ${share}/icebow/examples COMPONENT development)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/icebow)
install(EXPORT icebow NAMESPACE icebow:: FILE icebowTargets.cmake DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/icebowConfig.cmake.in ${CMAKE_BINARY_DIR}/icebowConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/icebowConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/icebowConfig.cmake ${CMAKE_BINARY_DIR}/icebowConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)

# `cpack` in the build directory writes icebow_*.deb and icebow-dev_*.deb.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Icebow maintainers <maintainers@users.noreply.h-seed-81ee9ff3.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME icebow)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS openmpi-bin)  # mpirun, for runs on several cores
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, python3-pandas")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "parametric studies of icebreaker bows
 Generates icebreaker bows from their angles, breaks level ice with them by the
 breaking cycle and by peridynamics, and ranks them in one offline report.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME icebow-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "icebow (= ${PROJECT_VERSION}), libeigen3-dev, nlohmann-json3-dev, libcgal-dev, libopenmpi-dev, libhdf5-openmpi-dev, libpng-dev, libfftw3-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "libraries of Icebow: hull generator and ice solver
 Headers, static libraries and a CMake package: find_package(icebow).")
include(CPack)
