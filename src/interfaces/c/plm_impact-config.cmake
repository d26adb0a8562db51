# The C library for CMake: find_package(plm_impact CONFIG REQUIRED PATHS <this folder>), then
# target_link_libraries(... plm_impact::plm_impact). It finds the library where cargo builds it, beside these files, or in
# the folder lib of the prefix that holds include/plm_impact.h. Set PLM_IMPACT_LIBRARY for another place.

set(_plm_folder "${CMAKE_CURRENT_LIST_DIR}")
find_path(PLM_IMPACT_INCLUDE_DIR plm_impact.h HINTS "${_plm_folder}" "${_plm_folder}/../../../include")
find_library(
  PLM_IMPACT_LIBRARY
  NAMES libplm_impact.a plm_impact
  HINTS "${_plm_folder}" "${_plm_folder}/../../../target/release" "${_plm_folder}/../../../lib"
)
if(NOT PLM_IMPACT_LIBRARY OR NOT PLM_IMPACT_INCLUDE_DIR)
  set(plm_impact_FOUND FALSE)
  set(plm_impact_NOT_FOUND_MESSAGE
      "the library is not built: cargo rustc --release --lib --features capi --crate-type staticlib, or set PLM_IMPACT_LIBRARY"
  )
  return()
endif()

if(NOT TARGET plm_impact::plm_impact)
  find_package(Threads REQUIRED)
  add_library(plm_impact::plm_impact UNKNOWN IMPORTED)
  set_target_properties(
    plm_impact::plm_impact
    PROPERTIES IMPORTED_LOCATION "${PLM_IMPACT_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${PLM_IMPACT_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "Threads::Threads;${CMAKE_DL_LIBS};m"
  )
endif()
