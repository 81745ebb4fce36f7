# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Bare Debian systems to try things on, for scripts to source. Needs root and debootstrap.
# THICKEN_MACHINES is the folder that they lie in, each some hundred MB; this machine's mirror serves them.
machines=${THICKEN_MACHINES:-/var/tmp/thicken-machines}

# machine_base SUITE: makes machines/base-SUITE, a system without anything that Debian does not insist on.
machine_base() {
  local suite=$1 base=$machines/base-$1 mirror
  [ ! -d "$base" ] || return 0
  command -v debootstrap >/dev/null || { echo "debootstrap is missing (apt-get install debootstrap)" >&2; return 1; }
  mirror=$(awk '/^URIs:/{print $2; exit}' /etc/apt/sources.list.d/*.sources 2>/dev/null || true)
  mkdir -p "$machines"
  rm -rf "$base.part"
  debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$base.part" "${mirror:-http://deb.debian.org/debian}" >"$machines/$suite.log" ||
    { tail "$machines/$suite.log" >&2; return 1; }
  echo force-unsafe-io >"$base.part/etc/dpkg/dpkg.cfg.d/unsafe-io"  # nobody minds if such a system is lost
  cp /etc/apt/apt.conf.d/99* "$base.part/etc/apt/apt.conf.d/" 2>/dev/null || true
  mv "$base.part" "$base"
}

# machine SUITE NAME: makes machines/NAME-SUITE of the bare system where it is not there yet, and prints where it is.
machine() {
  local root=$machines/$2-$1
  machine_base "$1" || return 1
  if [ ! -d "$root" ]; then
    cp -a "$machines/base-$1" "$root.part"
    mv "$root.part" "$root"
  fi
  echo "$root"
}

# inside ROOT COMMAND: runs a command of the shell in /root/project of such a system.
inside() {
  local root=$1
  cp /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
  mkdir -p "$root/root/project"
  # In a mount namespace of its own: nothing stays mounted, however this ends.
  unshare --mount --fork bash -c '
    mount --bind /proc "$1/proc" && mount --bind /dev "$1/dev" || exit 1
    exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "cd /root/project; $2"
  ' inside "$root" "$2" </dev/null
}
