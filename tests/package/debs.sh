#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# debs.sh BUILD_DIR: makes the Debian packages of a build tree with cpack, and checks their files and dependencies. cpack reads all
# files of a package to find its shared libraries, so this is done only for jounce-mpi, which has few files.
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "debs: $1" >&2; exit 1; }
cpack --config "$1/CPackConfig.cmake" -B "$scratch" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -D CPACK_STRIP_FILES=OFF \
  -D CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS=OFF > "$scratch/log" 2>&1 ||
  { cat "$scratch/log"; exit 1; }

# contains PACKAGE FILE...; the files are patterns of grep.
contains() {
  package=$1
  shift
  dpkg-deb -c "$scratch/${package}"_*.deb | awk '{print $6}' > "$scratch/files"
  for file in "$@"; do grep -qxE "\./usr/$file" "$scratch/files" || fail "$package does not contain $file"; done
  for file in copyright changelog.gz; do
    grep -qx "./usr/share/doc/$package/$file" "$scratch/files" || fail "$package does not contain its $file"
  done
}
lacks() { ! grep -E "$1" "$scratch/files" || fail "$package contains $1"; }
field() { dpkg-deb -f "$scratch/$1"_*.deb "$2"; }

contains jounce bin/jounce 'share/man/man1/jounce(-check|-stream)?\.1\.gz' share/bash-completion/completions/jounce \
  'share/zsh/.*/_jounce' share/fish/vendor_completions.d/jounce.fish 'share/doc/jounce/examples/pmc600-cam/cam\.toml' \
  'share/doc/jounce/docs/how-to/ci\.md'
lacks '\.(a|hpp|cmake|pc)$'
contains libjounce-dev 'include/jounce/profiles/moves/move\.hpp' 'lib/.*libjounce_profiles\.a' 'lib/.*/jounceConfig\.cmake' \
  'lib/.*/jounce-profiles\.pc'
lacks '/usr/bin|/detail/|/man/|/include/jounce/web/'
if [ -d "$1/python/jounce" ]; then
  contains python3-jounce 'lib/python3[.0-9]*/dist-packages/jounce/(__init__\.py|_jounce\.pyi|py\.typed)' \
    'lib/python3[.0-9]*/dist-packages/jounce/_jounce\..*\.so'
  field python3-jounce Depends | grep -q 'python3-numpy' || fail "dependencies of python3-jounce: $(field python3-jounce Depends)"
  dpkg-deb -e "$scratch"/python3-jounce_*.deb "$scratch/control"
  [ -x "$scratch/control/postinst" ] && [ -x "$scratch/control/prerm" ] || fail "python3-jounce does not compile its Python files"
fi
field jounce-mpi Depends | grep -q 'jounce (= .*libopenmpi' || fail "dependencies of jounce-mpi: $(field jounce-mpi Depends)"
field libjounce-dev Depends | grep -q 'libnlopt-cxx-dev' || fail "dependencies of libjounce-dev: $(field libjounce-dev Depends)"
for package in "$scratch"/*.deb; do
  [ "$(dpkg-deb -f "$package" Description | wc -l)" -ge 3 ] || fail "$package has no description"
done
