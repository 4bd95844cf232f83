#!/usr/bin/env bash
# Installs the build folder $1 to a temporary prefix, then builds and runs a small program against the
# installed files.
set -euo pipefail
build=${1:?usage: consumer_test.sh BUILD_FOLDER}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cmake --install "$build" --prefix "$dir/prefix" >/dev/null
"$dir/prefix/bin/thaw" --help >/dev/null

mkdir "$dir/consumer"
cat >"$dir/consumer/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(consumer LANGUAGES CXX)
find_package(thaw REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE thaw::io)
END
cat >"$dir/consumer/consumer.cpp" <<'END'
#include <cstdio>
#include "core/math/exact_sum.hpp"
#include "io/version.hpp"
int main() {
  thaw::ExactSum sum;
  for (double x : {1e100, 1.0, -1e100}) sum.add(x);
  std::printf("thaw %s: 1e100 + 1 - 1e100 = %g\n", thaw::versionNumber(), sum.value());
  return sum.value() == 1.0 ? 0 : 1;
}
END
# The consumer sees only the installed files, not the source tree or the build folder.
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt")
flags=$(sed -n 's/^THAW_SANITIZE:STRING=\(.\+\)/-fsanitize=\1/p' "$build/CMakeCache.txt")
(cd "$dir/consumer" && cmake -G "$generator" -B build -DCMAKE_PREFIX_PATH="$dir/prefix" -DCMAKE_CXX_FLAGS="$flags" >log 2>&1 &&
  cmake --build build >>log 2>&1) || { cat "$dir/consumer/log"; exit 1; }
"$dir/consumer/build/consumer"
source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
if grep -rlF -e "$source/" "$dir/prefix/lib"*/cmake; then
  echo "the installed package names the source tree"
  exit 1
fi
