#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# release.sh SCRIPT: runs scripts/release in a small repository: its conditions, a dry run, and a release whose tests and packages
# are replaced by short scripts.
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b.example GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b.example GIT_CONFIG_GLOBAL=/dev/null
git init -q
mkdir scripts
cp "$1" scripts/release
printf '#!/bin/sh\necho ran test\n' > scripts/test
printf '#!/bin/sh\nmkdir -p build/package/debs && echo deb > build/package/debs/jounce_1.2.3_amd64.deb\n' > scripts/package
printf '#!/bin/sh\ntest -f "$1/jounce_1.2.3_amd64.deb"\n' > scripts/package-test
chmod +x scripts/*
echo 'project(jounce VERSION 1.2.3 LANGUAGES CXX)' > CMakeLists.txt
printf '# Changelog\n\n## Unreleased\n\n### Added\n\n- new\n\n## 1.2.2 (2026-01-01)\n\n- old\n' > CHANGELOG.md
echo /build/ > .gitignore
git add -A
git commit -qm first

# rejects STATUS TEXT ARGUMENT...
rejects() {
  status=$1 text=$2 got=0
  shift 2
  scripts/release "$@" > .git/out 2>&1 || got=$?
  [ $got = "$status" ] || { cat .git/out; echo "release $*: exit status $got instead of $status"; exit 1; }
  grep -qF -- "$text" .git/out || { cat .git/out; echo "release $*: no '$text'"; exit 1; }
  [ -z "$(git tag)" ] || { echo "release $*: a tag exists"; exit 1; }
}
rejects 2 "is not of the form" --dry-run
rejects 2 "is not of the form" 1.2
rejects 2 "--dry is not an option" 1.2.3 --dry
rejects 1 "CHANGELOG.md begins with the section 'Unreleased'" 1.2.3
rejects 1 "another version than 1.2.4" 1.2.4
sed -i 's/^## Unreleased/## 1.2.3 (2026-11-26)/' CHANGELOG.md
rejects 1 "the tree has changes" 1.2.3
git commit -qam changelog

scripts/release 1.2.3 --dry-run > .git/out
grep -q "release: git tag -a v1.2.3" .git/out
! grep "the files are in" .git/out || { echo "the dry run reports files"; exit 1; }
[ ! -e build ] && [ -z "$(git tag)" ] || { echo "the dry run does something"; exit 1; }

printf '#!/bin/sh\nexit 1\n' > scripts/test && git commit -qam 'a test fails'
rejects 1 "release: scripts/test" 1.2.3
printf '#!/bin/sh\n' > scripts/test && git commit -qam 'it succeeds'
scripts/release 1.2.3 > /dev/null
(cd build/release-1.2.3 && sha256sum -c SHA256SUMS > /dev/null && [ "$(wc -l < SHA256SUMS)" = 2 ])
[ "$(git tag -l --format='%(contents)' | tr -d '\n')" = "Jounce 1.2.3### Added- new" ] || { git tag -l --format='%(contents)'; exit 1; }
git tag -d v1.2.3 > /dev/null
git tag -a v1.2.3 -m x
scripts/release 1.2.3 2>&1 | grep -q "the tag v1.2.3 exists already"
