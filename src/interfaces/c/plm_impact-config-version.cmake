# The version is that of the header. A program that asks for another minor version before 1.0 may not compile.

find_file(_plm_header plm_impact.h NO_CACHE HINTS "${CMAKE_CURRENT_LIST_DIR}" "${CMAKE_CURRENT_LIST_DIR}/../../../include")
file(STRINGS "${_plm_header}" _plm_line REGEX "^#define PLM_IMPACT_VERSION \"")
string(REGEX REPLACE "^[^\"]*\"([0-9]+\\.[0-9]+)(.*)\"$" "\\1" _plm_minor "${_plm_line}")
string(REGEX REPLACE "^[^\"]*\"(.*)\"$" "\\1" PACKAGE_VERSION "${_plm_line}")
if(PACKAGE_FIND_VERSION VERSION_LESS_EQUAL PACKAGE_VERSION AND PACKAGE_FIND_VERSION VERSION_GREATER_EQUAL _plm_minor)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
endif()
