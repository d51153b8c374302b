#!/usr/bin/env bash
# A C and a C++ project that use the CMake targets, each way: find_package after an install, FetchContent, subdirectory.
source "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
version=$(sed -n 's/^#define PRT_VERSION "\(.*\)"/\1/p' "$root/prt.h")

consume() {   # USE, further arguments of cmake
    local use=$1; shift
    cmake -S "$tests/compile/consumer" -B "$use" -DUSE="$use" "$@" && cmake --build "$use" -j "$jobs" &&
        [ "$("$use/consumer_c")" = "1.000 1.000 1.000" ] && [ "$("$use/consumer_cpp")" = "1.000 1.000 1.000" ]
}
install_package() {
    cmake -S "$root" -B staging -DPRT_BUILD_TESTS=OFF -DPRT_BUILD_EXAMPLES=OFF -DPRT_BUILD_BENCH=OFF -DPRT_BUILD_CODEGEN=OFF \
          -DCMAKE_INSTALL_PREFIX="$work/prefix" && cmake --install staging &&
        mv prefix moved   # a package must not remember where it was made
}
check "install" install_package
for file in include/prt.h include/prt_bake.h share/doc/prt/LICENSE share/cmake/prt/prt-config.cmake; do
    check "installs $file" test -f "moved/$file"
done
check_empty "the installed package names no path of this machine" "$(grep -rlF -e "$root" -e "$work" moved)"
check "find_package(prt): C and C++" consume package -DCMAKE_PREFIX_PATH="$work/moved" -DEXPECTED_VERSION="$version"
check "find_package(prt): another minor version is refused" bash -c \
    "sed 's/prt 0.1/prt 0.0/' '$tests/compile/consumer/CMakeLists.txt' >CMakeLists.txt && cp '$tests/compile/consumer/consumer.c.in' . &&
     ! cmake -S . -B refused -DUSE=package -DCMAKE_PREFIX_PATH='$work/moved' -DEXPECTED_VERSION='$version'"
check "FetchContent: C and C++" consume fetch -DPRT_SOURCE="$root"
check "add_subdirectory: C and C++" consume subdirectory -DPRT_SOURCE="$root"
check "the version of CMake is the version of the headers" grep -q "PACKAGE_VERSION \"$version\"" \
    moved/share/cmake/prt/prt-config-version.cmake
finish
