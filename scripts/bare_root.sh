# SPDX-License-Identifier: MIT
# Read after common.sh by the scripts that need a bare Debian in a folder: installs it there and runs commands in it.
# shellcheck shell=bash

# need_bare_root: exits with 77, and says so, where no bare root can be made
need_bare_root() {
  [ "$(id -u)" != 0 ] || ! command -v debootstrap >/dev/null || return 0
  echo "$(basename "$0"): skipped: a bare Debian needs root and debootstrap"
  exit 77
}

# bare_root FOLDER: a bare Debian bookworm in FOLDER (new or empty), with packages from the sources of this machine's
# apt; a copy of the folder SHIGUSA_BARE_ROOT if that is set
bare_root() {
  local root=$1 sources mirror
  if [ -n "${SHIGUSA_BARE_ROOT:-}" ]; then
    mkdir -p "$root" && cp -a "$SHIGUSA_BARE_ROOT/." "$root"
    return
  fi
  # lines of address, release, component
  # shellcheck disable=SC2016  # apt's own variables
  sources=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' | grep -E ' bookworm(-updates|-security)? main$' | sort -u) || true
  mirror=$(awk '$2 == "bookworm" { print $1; exit }' <<<"$sources")
  [ -n "$mirror" ] || {
    echo "$(basename "$0"): this machine's apt has no source of bookworm" >&2
    return 2
  }
  say "bare Debian bookworm into $root"
  quietly debootstrap --variant=minbase bookworm "$root" "$mirror" || return
  awk '{ print "deb", $1, $2, $3 }' <<<"$sources" >"$root/etc/apt/sources.list"
  apt-config dump | grep -iE '^Acquire::[a-z]+::Proxy' >"$root/etc/apt/apt.conf.d/proxy" || true
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  # additional certificates of this machine's npm
  [ -z "${NODE_EXTRA_CA_CERTS:-}" ] || cp "$NODE_EXTRA_CA_CERTS" "$root/etc/host_certificates.crt"
}

# inside ROOT USER FOLDER [NAME=VALUE…] COMMAND…: runs the command there as that user in that folder, with the environment
# of a fresh login and access to the network; /proc is mounted for it alone
inside() {
  local root=$1 user=$2 folder=$3 home
  shift 3
  home=$(awk -F : -v user="$user" '$1 == user { print $6 }' "$root/etc/passwd")
  [ -n "$home" ] || {
    echo "$(basename "$0"): no user $user in $root" >&2
    return 2
  }
  # shellcheck disable=SC2016  # for the inner shell
  unshare --mount sh -euc 'mount -t proc proc "$2/proc"; exec chroot --userspec="$@"' sh "$user" "$root" \
    /usr/bin/env -i -C "$folder" HOME="$home" LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    ${NODE_EXTRA_CA_CERTS:+NODE_EXTRA_CA_CERTS=/etc/host_certificates.crt} "$@"
}
