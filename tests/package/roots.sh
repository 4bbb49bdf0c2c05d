# Root file systems of other Debians and of Ubuntu, for the tests beside this file. Sourced by them.
# shellcheck shell=bash

# Prints the root of a system, PACKAGES/roots/NAME; makes it with debootstrap if it is missing. Exits with 77 (skipped) without
# root. The keys of Ubuntu come from Debian 13, because Debian 12 has no package with them.
root_of() {
  local roots=$1/roots name=$2
  [ "$(id -u)" = 0 ] || { echo "needs root" >&2; exit 77; }
  mkdir -p "$roots"
  if [ ! -e "$roots/$name/etc/debian_version" ]; then
    rm -rf "${roots:?}/$name"
    case $name in
      noble)
        in_root "$(root_of "$1" trixie)" sh -c 'apt-get -q update && apt-get -qy install --no-install-recommends ubuntu-keyring'
        debootstrap --variant=minbase --keyring="$roots/trixie/usr/share/keyrings/ubuntu-archive-keyring.gpg" \
          noble "$roots/noble" "${FELT_UBUNTU_MIRROR:-}" /usr/share/debootstrap/scripts/gutsy ;;
      *) debootstrap --variant=minbase "$name" "$roots/$name" ${FELT_DEBIAN_MIRROR:+"$FELT_DEBIAN_MIRROR"} ;;
    esac >"$roots/$name.log" 2>&1 || { tail -n 5 "$roots/$name.log" >&2; exit 1; }
  fi
  printf '%s\n' "$roots/$name"
}

# in_root ROOT COMMAND...: runs the command in the root. It sees /proc, the X displays of this system, and
# the folder $shared as /mnt.
in_root() {
  # shellcheck disable=SC2016  # the inner shell expands them
  shared=${shared:-} unshare --mount sh -c '
    root=$1; shift
    mount -t proc proc "$root/proc"
    [ -z "$shared" ] || mount --bind "$shared" "$root/mnt"
    if [ -d /tmp/.X11-unix ]; then
      mkdir -p "$root/tmp/.X11-unix"
      mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
    fi
    cd /
    exec chroot "$root" "$@"' sh "$@"
}
