# hasp_add_kernel(Grid SOURCES a.cxx … HEADERS a.h … [PUBLIC targets…] [PRIVATE targets…]
#                 [FOLDER Evaluation])
#
# A kernel is a library free of VTK, OpenGL and Qt: target KernelGrid, linked as Hasp::KernelGrid, its
# headers included as "Grid/GridView.h". It is exported with the VTK modules in one package. Without
# SOURCES it is its headers alone.
# FOLDER: where the headers live if not in a folder of the library's name (a second library of one kernel).
function (hasp_add_kernel noun)
  cmake_parse_arguments(arg "" "FOLDER" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  if (NOT arg_FOLDER)
    set(arg_FOLDER ${noun})
  endif ()
  hasp_add_library_without_vtk(Kernel${noun} Kernels ${arg_FOLDER} SOURCES ${arg_SOURCES} HEADERS ${arg_HEADERS}
    PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction ()

# hasp_add_devices(SOURCES a.cxx … HEADERS a.h … [PUBLIC targets…] [PRIVATE targets…])
#
# Storey 1: target Devices, linked as Hasp::Devices, its headers included as "Devices/HeadPose.h".
function (hasp_add_devices)
  hasp_add_library_without_vtk(Devices . Devices ${ARGN})
endfunction ()

# hasp_add_drivers(SOURCES a.cxx … HEADERS a.h … [PUBLIC targets…] [PRIVATE targets…])
#
# The second library of that folder: target DeviceDrivers, linked as Hasp::DeviceDrivers, its headers included as
# "Devices/Drivers/HapticDriver.h".
function (hasp_add_drivers)
  hasp_add_library_without_vtk(DeviceDrivers . Devices/Drivers ${ARGN})
endfunction ()

# hasp_add_studies(SOURCES a.cxx … HEADERS a.h … [PUBLIC targets…] [PRIVATE targets…])
#
# Storey 1 too, above Devices: target Studies, linked as Hasp::Studies.
function (hasp_add_studies)
  hasp_add_library_without_vtk(Studies . Studies ${ARGN})
endfunction ()

# What all do. <storey>: the folder of Modules that headers are included from.
function (hasp_add_library_without_vtk target storey folder)
  cmake_parse_arguments(arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  if (arg_SOURCES)
    add_library(${target} ${arg_SOURCES} ${arg_HEADERS})
    set(public PUBLIC)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME hasp${target}
      VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE})
  else ()
    add_library(${target} INTERFACE ${arg_HEADERS})
    set(public INTERFACE)
  endif ()
  add_library(Hasp::${target} ALIAS ${target})
  target_compile_features(${target} ${public} cxx_std_20)
  cmake_path(SET includes NORMALIZE "Modules/${storey}")
  cmake_path(SET installed NORMALIZE "${HASP_HEADER_DIR}/${storey}")
  target_include_directories(${target} ${public}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/${includes}>"
    "$<INSTALL_INTERFACE:${installed}>")
  target_link_libraries(${target} ${public} ${arg_PUBLIC})
  set_property(GLOBAL APPEND PROPERTY HASP_KERNELS ${target}) # for the messages of find_package(Hasp)
  install(TARGETS ${target} EXPORT Hasp
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  foreach (header IN LISTS arg_HEADERS)
    cmake_path(GET header PARENT_PATH below)
    install(FILES "${header}" DESTINATION "${installed}/${folder}/${below}")
  endforeach ()
endfunction ()

# hasp_add_needed_kernels()
#
# Adds each kernel, Devices and Studies, that some target links and that is not there yet. So a build of single modules
# (HASP_BUILD_ALL_MODULES OFF) has their kernels and no others. Call it when all targets are there.
function (hasp_add_needed_kernels)
  set(folder_of_CellTracer Isosurface) # second libraries of a folder
  set(folder_of_LevelSet Distance)
  set(folder_of_SelfIntersections Evaluation)
  set(folders "${PROJECT_SOURCE_DIR}")
  while (folders)
    list(POP_FRONT folders folder)
    get_property(below DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
    list(APPEND folders ${below})
    get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
    foreach (target IN LISTS targets)
      get_target_property(links ${target} LINK_LIBRARIES)
      foreach (kernel IN LISTS links)
        if (kernel MATCHES "^Hasp::(Devices|DeviceDrivers|Studies|Kernel(.+))$" AND NOT TARGET ${kernel})
          set(home "Kernels/${CMAKE_MATCH_2}")
          if (kernel MATCHES "^Hasp::(Devices|Studies)$")
            set(home ${CMAKE_MATCH_1})
          elseif (kernel STREQUAL "Hasp::DeviceDrivers")
            set(home Devices/Drivers)
          elseif (DEFINED folder_of_${CMAKE_MATCH_2})
            set(home "Kernels/${folder_of_${CMAKE_MATCH_2}}")
          endif ()
          add_subdirectory("${PROJECT_SOURCE_DIR}/Modules/${home}" "${PROJECT_BINARY_DIR}/Modules/${home}")
          list(APPEND folders "${PROJECT_SOURCE_DIR}/Modules/${home}")
        endif ()
      endforeach ()
    endforeach ()
  endwhile ()
endfunction ()
