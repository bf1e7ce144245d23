# hasp_add_kernel(Grid SOURCES a.cxx … HEADERS a.h … [PUBLIC targets…] [PRIVATE targets…]
#                 [FOLDER Evaluation])
#
# A kernel is a library free of VTK, OpenGL and Qt: target KernelGrid, linked as Hasp::KernelGrid, its
# headers included as "Grid/GridView.h". It is exported with the VTK modules in one package.
# FOLDER: where the headers live if not in a folder of the library's name (a second library of one kernel).
function (hasp_add_kernel noun)
  cmake_parse_arguments(arg "" "FOLDER" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target Kernel${noun})
  if (NOT arg_FOLDER)
    set(arg_FOLDER ${noun})
  endif ()
  add_library(${target} ${arg_SOURCES} ${arg_HEADERS})
  add_library(Hasp::${target} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/Modules/Kernels>"
    "$<INSTALL_INTERFACE:${HASP_HEADER_DIR}/Kernels>")
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME haspKernel${noun}
    VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  set_property(GLOBAL APPEND PROPERTY HASP_KERNELS ${target}) # for the messages of find_package(Hasp)
  install(TARGETS ${target} EXPORT Hasp
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  foreach (header IN LISTS arg_HEADERS)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES "${header}" DESTINATION "${HASP_HEADER_DIR}/Kernels/${arg_FOLDER}/${folder}")
  endforeach ()
endfunction ()

# hasp_add_needed_kernels()
#
# Adds each kernel that some target links and that is not there yet. So a build of single modules
# (HASP_BUILD_ALL_MODULES OFF) has their kernels and no others. Call it when all targets are there.
function (hasp_add_needed_kernels)
  set(folder_of_CellTracer Isosurface) # second libraries of a folder
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
        if (kernel MATCHES "^Hasp::Kernel(.+)$" AND NOT TARGET ${kernel})
          set(home "${CMAKE_MATCH_1}")
          if (DEFINED folder_of_${home})
            set(home "${folder_of_${home}}")
          endif ()
          add_subdirectory("${PROJECT_SOURCE_DIR}/Modules/Kernels/${home}"
            "${PROJECT_BINARY_DIR}/Modules/Kernels/${home}")
          list(APPEND folders "${PROJECT_SOURCE_DIR}/Modules/Kernels/${home}")
        endif ()
      endforeach ()
    endforeach ()
  endwhile ()
endfunction ()
