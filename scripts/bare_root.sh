#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Functions for scripts that work in a bare Debian 12 (fresh, package-test), which read this file:
#
#   if [ -z "${BARE_WORK:-}" ]; then   # the outer process
#     ...                         # reads the options, and exports them
#     in_namespaces "$@"          # runs the same script again, with BARE_WORK, and ends
#   fi
#   make_root "$BARE_WORK/root"
#   furnish "$BARE_WORK/root"
#   in_root "$BARE_WORK/root" COMMAND...
#
# BARE_WORK is a temporary folder in TMPDIR (/var/tmp). Debian comes from the mirror of this machine's apt, or from MIRROR. Needs
# root and debootstrap.
release=bookworm
script=$(basename "$0")

# refuse MESSAGE [STATUS]
refuse() { echo "$script: $1" >&2; exit "${2:-3}"; }

# in_namespaces ARGUMENT...: all mounts and processes are in namespaces that end with the child. Only a plain folder is left to
# remove.
in_namespaces() {
  [ "$(id -u)" = 0 ] || refuse "run it as root"
  for tool in debootstrap git unshare setpriv; do
    command -v $tool > /dev/null || refuse "$tool is missing: apt-get install debootstrap git util-linux"
  done
  unshare -m true 2> /dev/null ||
    refuse "no mount namespace can be made here: CAP_SYS_ADMIN is missing, as in a container"
  BARE_WORK=$(mktemp -d "${TMPDIR:-/var/tmp}/jounce-$script.XXXXXX")
  export BARE_WORK
  unshare --mount --pid --fork --kill-child --propagation private "$0" "$@" &
  inner=$!
  clean_up() {
    kill -KILL $inner 2> /dev/null || true
    wait $inner 2> /dev/null || true
    rm -rf --one-file-system "$BARE_WORK" 2> /dev/null || { sleep 2; rm -rf --one-file-system "$BARE_WORK"; }  # still written to
  }
  trap clean_up EXIT
  trap 'echo "$script: interrupted" >&2; exit 130' INT
  trap 'echo "$script: interrupted" >&2; exit 143' TERM HUP
  status=0
  wait $inner || status=$?
  exit $status
}

# sources: a line "SITE RELEASE COMPONENT" for each of Debian's that apt uses here.
sources() {
  if [ -n "${MIRROR:-}" ]; then
    echo "$MIRROR $release main"
  else
    apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Origin: Debian' 'Created-By: Packages' |
      grep -E " $release(-updates|-security)? main$" | sort -u
  fi
}

# make_root DIRECTORY [LOG]: a bare Debian.
make_root() {
  site=$(sources | sed -n "s/ $release main$//p" | head -1)
  [ -n "$site" ] || refuse "apt has no source of Debian $release here: name one in MIRROR"
  bootstrap_log=${2:-$BARE_WORK/debootstrap.log}
  debootstrap --variant=minbase "$release" "$1" "$site" > "$bootstrap_log" 2>&1 || {
    tail -20 "$bootstrap_log"
    refuse "debootstrap failed" 1
  }
  sources | sed 's/^/deb /' > "$1/etc/apt/sources.list"
  apt-config dump Acquire | grep -E '::(Check-Valid-Until|Check-Date|Proxy) ' > "$1/etc/apt/apt.conf.d/99bare" || true
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
}

# furnish DIRECTORY: mounts the file systems of an ordinary container.
furnish() {
  mount -t proc proc "$1/proc"
  mount -t tmpfs -o mode=755 tmpfs "$1/dev"
  for device in null zero full random urandom tty; do
    touch "$1/dev/$device"
    mount --bind "/dev/$device" "$1/dev/$device"
  done
  ln -s /proc/self/fd "$1/dev/fd"
  mkdir "$1/dev/shm"
  mount -t tmpfs tmpfs "$1/dev/shm"
}

# in_root DIRECTORY COMMAND...: runs it there, in an empty environment. In a chroot no user namespace can be made.
in_root() {
  root_folder=$1
  shift
  chroot "$root_folder" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
}
