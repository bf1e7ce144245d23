# ITK's distance maps: headers, and the libraries that they need. Gives ITKDistanceMap_FOUND and ITKDistanceMap::ITKDistanceMap.
# find_package(ITK) would search for all that ITK was built with: GDCM, HDF5, VTK.
find_path(ITKDistanceMap_INCLUDE_DIR itkSignedMaurerDistanceMapImageFilter.h PATH_SUFFIXES ITK-5.2 ITK-5.3 ITK-5.4)
set(ITKDistanceMap_LIBRARIES)
foreach (library ITKCommon itkvnl itkvnl_algo itksys)
  find_library(ITKDistanceMap_${library} NAMES ${library}-5.2 ${library}-5.3 ${library}-5.4)
  mark_as_advanced(ITKDistanceMap_${library})
  list(APPEND ITKDistanceMap_LIBRARIES "${ITKDistanceMap_${library}}")
endforeach ()
mark_as_advanced(ITKDistanceMap_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ITKDistanceMap REQUIRED_VARS ITKDistanceMap_INCLUDE_DIR ITKDistanceMap_ITKCommon
  ITKDistanceMap_itkvnl ITKDistanceMap_itkvnl_algo ITKDistanceMap_itksys)
if (ITKDistanceMap_FOUND AND NOT TARGET ITKDistanceMap::ITKDistanceMap)
  add_library(ITKDistanceMap::ITKDistanceMap INTERFACE IMPORTED)
  set_target_properties(ITKDistanceMap::ITKDistanceMap PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${ITKDistanceMap_INCLUDE_DIR}" INTERFACE_LINK_LIBRARIES "${ITKDistanceMap_LIBRARIES}")
endif ()
