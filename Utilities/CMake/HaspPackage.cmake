# The installed package: find_package(Hasp COMPONENTS RenderingIsosurfaceOpenGL2 KernelGrid …).
include(CMakePackageConfigHelpers)
get_property(kernels GLOBAL PROPERTY HASP_KERNELS)
list(TRANSFORM HASP_MODULES REPLACE "^Hasp::" "" OUTPUT_VARIABLE modules)
list(TRANSFORM HASP_REQUIRED_MODULES REPLACE "^VTK::" "" OUTPUT_VARIABLE HASP_VTK_COMPONENTS)
list(JOIN HASP_VTK_COMPONENTS " " HASP_VTK_COMPONENTS)
list(JOIN kernels " " HASP_COMPONENTS)
list(JOIN modules " " modules)
string(APPEND HASP_COMPONENTS " ${modules}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/HaspConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${HASP_PACKAGE_DIR}/HaspConfig.cmake"
  INSTALL_DESTINATION "${HASP_PACKAGE_DIR}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/${HASP_PACKAGE_DIR}/HaspConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${HASP_PACKAGE_DIR}/HaspConfig.cmake"
  "${CMAKE_BINARY_DIR}/${HASP_PACKAGE_DIR}/HaspConfigVersion.cmake"
  DESTINATION "${HASP_PACKAGE_DIR}")
