# The Debian package, made by `./dev package` with the preset `package`: shared libraries, so that
# programs and the Python module have them once, and users need no -dev packages but Eigen's. What
# it depends on at run time dpkg-shlibdeps finds in the programs themselves.
set(debian ${PROJECT_SOURCE_DIR}/cmake/debian)
install(FILES ${debian}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "tencer maintainers <maintainers@tencer.invalid>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION " \
Finds few cables, where to tie them and how long to cut them, that hold bent rods in the shape of \
given curves, and says how close the rods will come and whether the structure will stand. \
This package holds the program, the C++ library with its headers, and the Python module.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
get_property(modules GLOBAL PROPERTY TENCER_MODULES)
foreach(name IN LISTS modules)
  get_target_property(folder tencer_${name} BINARY_DIR)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
endforeach()
# The extension fits one version of Python. Pictures of studies and of designs in notebooks, and
# programs with the library, need what is recommended.
if(TARGET tencer_python)
  find_package(Python REQUIRED COMPONENTS Interpreter)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}~), python3-numpy")
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${debian}/postinst ${debian}/prerm)
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libeigen3-dev, python3-matplotlib, gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "jupyter-notebook, python3-scipy, parallel")
list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${debian}/triggers)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/compress_pages.cmake)
include(CPack)
