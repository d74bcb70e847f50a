# SPDX-License-Identifier: MIT
# The files installed by `cmake --install`, and the package that find_package(shigusa) finds.
include(CMakePackageConfigHelpers)

set(shigusa_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/shigusa)

install(TARGETS shigusa EXPORT shigusaTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/shigusa DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# the studio's page, if scripts/build_studio has built it
install(DIRECTORY studio/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/shigusa/studio OPTIONAL)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(GLOB schemas docs/*.schema.json)
install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/shigusa/schemas)
install(DIRECTORY examples/tasks examples/plans examples/robots DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(EXPORT shigusaTargets NAMESPACE shigusa:: DESTINATION ${shigusa_package_dir})
if(TARGET shigusa_dataset)
  install(TARGETS shigusa_dataset EXPORT shigusaDatasetTargets)
  install(DIRECTORY dataset/include/shigusa DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT shigusaDatasetTargets NAMESPACE shigusa:: DESTINATION ${shigusa_package_dir})
endif()
if(TARGET shigusa_c)
  install(EXPORT shigusaCTargets NAMESPACE shigusa:: DESTINATION ${shigusa_package_dir})
endif()

# The module of pkg-config. Users of a static library also link its dependencies.
set(needed_modules fmt)
if(TBB_FOUND)
  list(APPEND needed_modules tbb)
endif()
if(SHIGUSA_FOLDERS)
  list(APPEND needed_modules libmd)
endif()
if(SHIGUSA_PACKED_MESHES)
  list(APPEND needed_modules draco)
  set(needed_libraries -lmeshoptimizer)
elseif(SHIGUSA_DRACO_INSIDE)
  list(APPEND needed_modules draco)
endif()
if(SHIGUSA_MANNEQUIN)
  list(APPEND needed_modules zlib)
endif()
list(JOIN needed_modules " " needed_modules)
if(BUILD_SHARED_LIBS)
  set(private .private)
  set(then "\nLibs.private:")
endif()
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE prefix_from_here)
configure_file(cmake/shigusa.pc.in ${PROJECT_BINARY_DIR}/shigusa.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/shigusa.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# In a folder of their own: next to bin, find_package would find the uninstalled package if the program is on PATH.
set(shigusa_package ${PROJECT_BINARY_DIR}/package)
file(REMOVE ${PROJECT_BINARY_DIR}/shigusaConfig.cmake ${PROJECT_BINARY_DIR}/shigusaConfigVersion.cmake) # of old builds
configure_package_config_file(cmake/shigusaConfig.cmake.in ${shigusa_package}/shigusaConfig.cmake
                              INSTALL_DESTINATION ${shigusa_package_dir})
# below 1.0 a minor version may change the interface
write_basic_package_version_file(${shigusa_package}/shigusaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${shigusa_package}/shigusaConfig.cmake
              ${shigusa_package}/shigusaConfigVersion.cmake DESTINATION ${shigusa_package_dir})

# The C interface for pkg-config, which needs nothing else.
if(TARGET shigusa_c)
  configure_file(cmake/shigusa_c.pc.in ${PROJECT_BINARY_DIR}/shigusa_c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/shigusa_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# Removes what the last `cmake --install` of this build has installed.
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D MANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
                                      -P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake VERBATIM)
endif()
