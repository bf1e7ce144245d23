# What is needed of ITK to build its distance transform, a template, as Debian has it: gives ITKCommon_FOUND, ITKCommon_VERSION and
# ITKCommon::ITKCommon. ITK's own package looks for all that any of its modules might need.
find_path(ITKCommon_INCLUDE_DIR itkSignedMaurerDistanceMapImageFilter.h PATH_SUFFIXES ITK-5.4 ITK-5.3 ITK-5.2)
if (ITKCommon_INCLUDE_DIR MATCHES "ITK-([0-9.]+)$")
  set(ITKCommon_VERSION "${CMAKE_MATCH_1}")
endif ()
set(libraries)
foreach (library ITKCommon itksys itkvnl_algo itkvnl)
  find_library(ITKCommon_${library}_LIBRARY NAMES ${library}-${ITKCommon_VERSION})
  list(APPEND libraries ITKCommon_${library}_LIBRARY)
endforeach ()
mark_as_advanced(ITKCommon_INCLUDE_DIR ${libraries})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ITKCommon REQUIRED_VARS ITKCommon_INCLUDE_DIR ${libraries}
  VERSION_VAR ITKCommon_VERSION)
if (ITKCommon_FOUND AND NOT TARGET ITKCommon::ITKCommon)
  add_library(ITKCommon::ITKCommon INTERFACE IMPORTED)
  target_include_directories(ITKCommon::ITKCommon SYSTEM INTERFACE "${ITKCommon_INCLUDE_DIR}")
  foreach (library IN LISTS libraries)
    target_link_libraries(ITKCommon::ITKCommon INTERFACE "${${library}}")
  endforeach ()
endif ()
